// Builtin types whose layout only the engine knows: storage with the size in the API JSON, and the engine's
// constructors and destructor. Constructors have the order of the JSON: default, copy, conversions.
#pragma once

#include <godot_cpp/core/gdextension_interface_loader.hpp>

#include <cstddef>
#include <utility>

namespace godot::internal {

template <GDExtensionVariantType TYPE, size_t SIZE> class Opaque {
	alignas(8) std::byte storage_[SIZE];

protected:
	struct Uninitialized {};
	explicit Opaque(Uninitialized) {}

	template <int INDEX> void construct(const GDExtensionConstTypePtr *p_arguments = nullptr) {
		static const GDExtensionPtrConstructor constructor =
				gdextension_interface::variant_get_ptr_constructor(TYPE, INDEX);
		constructor(storage_, p_arguments);
	}

	void destroy() {
		static const GDExtensionPtrDestructor destructor =
				gdextension_interface::variant_get_ptr_destructor(TYPE);
		destructor(storage_);
	}

	void copy_from(const Opaque &p_other) {
		const GDExtensionConstTypePtr arguments[] = { p_other.storage_ };
		construct<1>(arguments);
	}

public:
	Opaque() { construct<0>(); }
	Opaque(const Opaque &p_other) { copy_from(p_other); }
	Opaque(Opaque &&p_other) noexcept {
		construct<0>();
		std::swap(storage_, p_other.storage_);
	}
	~Opaque() { destroy(); }

	Opaque &operator=(const Opaque &p_other) {
		if (this != &p_other) {
			destroy();
			copy_from(p_other);
		}
		return *this;
	}
	Opaque &operator=(Opaque &&p_other) noexcept {
		std::swap(storage_, p_other.storage_);
		return *this;
	}

	GDExtensionTypePtr _native_ptr() const { return const_cast<std::byte *>(storage_); }
};

} // namespace godot::internal
