// Base of the packed arrays. The generator makes one class for each element type from it.
#pragma once

#include <godot_cpp/variant/opaque.hpp>

#include <cstdint>
#include <initializer_list>

namespace godot::internal {

// Self: the class made from this one, which adds size(), resize(), ... from the API JSON. WRITE, READ: the
// engine's access to an element; WRITE first makes an own copy of shared memory (copy on write). Both return
// null for an empty array.
template <typename Self, typename T, GDExtensionVariantType TYPE, size_t SIZE, auto &WRITE, auto &READ>
class PackedArray : public Opaque<TYPE, SIZE> {
	const Self &self() const { return static_cast<const Self &>(*this); }

public:
	PackedArray() = default;
	PackedArray(std::initializer_list<T> p_values) {
		static_cast<Self &>(*this).resize(int64_t(p_values.size()));
		T *target = ptrw();
		for (const T &value : p_values) {
			*target++ = value;
		}
	}

	const T *ptr() const { return static_cast<const T *>(READ(this->_native_ptr(), 0)); }
	T *ptrw() { return static_cast<T *>(WRITE(this->_native_ptr(), 0)); }

	const T &operator[](int64_t p_index) const {
		return *static_cast<const T *>(READ(this->_native_ptr(), p_index));
	}
	T &operator[](int64_t p_index) { return *static_cast<T *>(WRITE(this->_native_ptr(), p_index)); }

	const T *begin() const { return ptr(); }
	const T *end() const { return ptr() + self().size(); }
	T *begin() { return ptrw(); }
	T *end() { return ptrw() + self().size(); }

	bool operator==(const PackedArray &p_other) const {
		const int64_t size = self().size();
		if (size != p_other.self().size()) {
			return false;
		}
		for (int64_t i = 0; i < size; i++) {
			if (!((*this)[i] == p_other[i])) {
				return false;
			}
		}
		return true;
	}
	bool operator!=(const PackedArray &p_other) const { return !(*this == p_other); }
};

} // namespace godot::internal
