#pragma once

#include <godot_cpp/core/object.hpp>

#include <utility>

namespace godot {

// Keeps a RefCounted object alive. T may be incomplete until a member is used.
template <typename T> class Ref {
	T *reference_ = nullptr;

	// Takes a further reference; false if the object is already being freed.
	static bool acquire(T *p_object, bool p_fresh) {
		return p_object != nullptr && (p_fresh ? p_object->init_ref() : p_object->reference());
	}
	void assign(T *p_object, bool p_fresh) {
		if (p_object != reference_) {
			T *const acquired = acquire(p_object, p_fresh) ? p_object : nullptr;
			unref();
			reference_ = acquired;
		}
	}

public:
	Ref() = default;
	Ref(std::nullptr_t) {}
	Ref(const Ref &p_other) { assign(p_other.reference_, false); }
	Ref(Ref &&p_other) noexcept : reference_(std::exchange(p_other.reference_, nullptr)) {}
	// Adopts the first reference of a new object.
	Ref(T *p_object) { assign(p_object, true); }
	template <typename Other> Ref(const Ref<Other> &p_other) {
		assign(Object::cast_to<T>(p_other.ptr()), false);
	}
	Ref(const Variant &p_value) { assign(Object::cast_to<T>(p_value.get_validated_object()), false); }
	~Ref() { unref(); }

	Ref &operator=(const Ref &p_other) {
		assign(p_other.reference_, false);
		return *this;
	}
	Ref &operator=(Ref &&p_other) noexcept {
		std::swap(reference_, p_other.reference_);
		return *this;
	}

	T *ptr() const { return reference_; }
	T *operator*() const { return reference_; }
	T *operator->() const { return reference_; }
	bool is_valid() const { return reference_ != nullptr; }
	bool is_null() const { return reference_ == nullptr; }
	bool operator==(const Ref &p_other) const { return reference_ == p_other.reference_; }
	bool operator!=(const Ref &p_other) const { return reference_ != p_other.reference_; }
	bool operator==(const T *p_other) const { return reference_ == p_other; }
	bool operator!=(const T *p_other) const { return reference_ != p_other; }
	operator Variant() const { return Variant(static_cast<const Object *>(reference_)); }

	void unref() {
		if (T *const released = std::exchange(reference_, nullptr); released && released->unreference()) {
			memdelete(released);
		}
	}
	void instantiate() { *this = Ref(memnew(T)); }

	// Adopts a reference that the engine has already counted.
	static Ref _adopt(T *p_object) {
		Ref adopted;
		adopted.reference_ = p_object;
		return adopted;
	}
};

} // namespace godot
