#pragma once

// Loads a library at run time, by LoadLibrary or dlopen.

#ifdef _WIN32
#ifndef NOMINMAX
#define NOMINMAX // windows.h's macros would replace std::min and std::max
#endif
#include <windows.h>
#else
#include <dlfcn.h>
#endif

#include <cstdlib>
#include <span>
#include <string>

namespace steadyhand {

#ifdef _WIN32
using LibraryHandle = HMODULE;

/// Null if it fails; `r_why_not` then says why.
inline LibraryHandle open_library(const char *name, std::string &r_why_not) {
	const LibraryHandle handle = LoadLibraryA(name);
	if (handle == nullptr) {
		r_why_not = "error " + std::to_string(GetLastError());
	}
	return handle;
}

inline void *find_symbol(LibraryHandle handle, const char *symbol) {
	return reinterpret_cast<void *>(GetProcAddress(handle, symbol));
}

inline void close_library(LibraryHandle handle) {
	FreeLibrary(handle);
}
#else
using LibraryHandle = void *;

/// Null if it fails; `r_why_not` then says why.
inline LibraryHandle open_library(const char *name, std::string &r_why_not) {
	void *const handle = dlopen(name, RTLD_NOW | RTLD_LOCAL);
	if (handle == nullptr) {
		const char *const why = dlerror();
		r_why_not = why != nullptr ? why : name;
	}
	return handle;
}

inline void *find_symbol(LibraryHandle handle, const char *symbol) {
	return dlsym(handle, symbol);
}

inline void close_library(LibraryHandle handle) {
	dlclose(handle);
}
#endif

/// Loads the file in the environment variable, otherwise the first of `names` that can be loaded.
inline LibraryHandle open_library(
		const char *variable, std::span<const char *const> names, std::string &r_why_not) {
	if (const char *const given = std::getenv(variable); given != nullptr && *given != '\0') {
		return open_library(given, r_why_not);
	}
	for (const char *const name : names) {
		if (const LibraryHandle handle = open_library(name, r_why_not)) {
			return handle;
		}
	}
	return nullptr;
}

template <class Function>
bool bind_symbol(LibraryHandle handle, const char *symbol, Function &r_function, std::string &r_why_not) {
	void *const found = find_symbol(handle, symbol);
	if (found == nullptr) {
		r_why_not = "it has no ";
		r_why_not += symbol;
		return false;
	}
	r_function = reinterpret_cast<Function>(found);
	return true;
}

} // namespace steadyhand
