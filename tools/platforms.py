"""Compilers, flags and library names for `scons platform=PLATFORM arch=ARCH`.

Linux and Windows use Debian's cross-compilers. Android needs an NDK in $ANDROID_NDK_ROOT. macOS needs a Mac, or
osxcross in $OSXCROSS_ROOT. There are no tests for Android and macOS.
"""

import os
import platform as host
import sys
from pathlib import Path

PLATFORMS = ["linux", "windows", "macos", "android"]
ARCHITECTURES = ["x86_64", "arm64"]
SUFFIXES = {"linux": "so", "windows": "dll", "macos": "dylib", "android": "so"}
ANDROID_API_LEVEL = 24  # the oldest level for Godot 4.4
MACOS_VERSION = "13.3"  # the first version with std::to_chars for floating point
INCLUDES = ["/usr/include", "/opt/homebrew/include", "/usr/local/include"]  # the second and third are Homebrew's
HEADERS = {  # name of the link: path below one of INCLUDES
    "Eigen": "eigen3/Eigen",
    "nlohmann": "nlohmann",
    "doctest": "doctest",
    "libusb.h": "libusb-1.0/libusb.h",
}


def of_this_machine() -> tuple[str, str]:
    """Platform and architecture of this machine."""
    systems = {"Linux": "linux", "Windows": "windows", "Darwin": "macos"}
    machines = {"aarch64": "arm64", "arm64": "arm64"}
    return systems.get(host.system(), "linux"), machines.get(host.machine(), "x86_64")


def library(platform: str, target: str, arch: str) -> str:
    """File name of the extension in the add-on's folder bin."""
    return f"libsteadyhand.{platform}.{target}.{arch}.{SUFFIXES[platform]}"


def set_up(env, root: Path) -> None:
    """Sets up `env` for env["platform"] and env["arch"], if they are not this machine's Linux."""
    platform, arch = env["platform"], env["arch"]
    compiler = {"linux": linux, "windows": windows, "macos": macos, "android": android}[platform]
    compiler(env, arch)
    env.Replace(LINK="$CXX", SHLINK="$CXX", SHLIBPREFIX="lib", SHLIBSUFFIX=f".{SUFFIXES[platform]}")
    env.Replace(PROGSUFFIX=".exe" if platform == "windows" else "")
    env.Append(CCFLAGS=["-isystem", str(own_headers(root / "build/headers"))])


def own_headers(folder: Path) -> Path:
    """A folder of links to the header-only libraries. /usr/include itself also has this machine's C library."""
    folder.mkdir(parents=True, exist_ok=True)
    for name, place in HEADERS.items():
        link = folder / name
        found = next((Path(base, place) for base in INCLUDES if Path(base, place).exists()), None)
        if found is not None and not link.exists():
            link.unlink(missing_ok=True)
            link.symlink_to(found)
    return folder


def linux(env, arch: str) -> None:
    prefix = {"x86_64": "x86_64", "arm64": "aarch64"}[arch] + "-linux-gnu-"
    env.Replace(CC=f"{prefix}gcc", CXX=f"{prefix}g++", AR=f"{prefix}ar")


def windows(env, arch: str) -> None:
    if arch != "x86_64":
        sys.exit("Windows is built for x86_64 only: Debian has no MinGW compiler for arm64")
    prefix = "x86_64-w64-mingw32-"
    env.Replace(CC=f"{prefix}gcc-posix", CXX=f"{prefix}g++-posix", AR=f"{prefix}ar")
    # The add-on needs no DLL of the compiler, and its file contains no build time.
    env.Append(LINKFLAGS=["-static", "-Wl,--no-insert-timestamp"])


def android(env, arch: str) -> None:
    ndk = os.environ.get("ANDROID_NDK_ROOT")
    if not ndk:
        sys.exit("platform=android: set ANDROID_NDK_ROOT to the folder of an Android NDK, r29 or later")
    tools = next(iter(Path(ndk, "toolchains/llvm/prebuilt").glob("*/bin")), None)
    if tools is None:
        sys.exit(
            f"platform=android: ANDROID_NDK_ROOT, {ndk}, has no toolchains/llvm/prebuilt/*/bin: name an NDK's folder"
        )
    triple = {"x86_64": "x86_64", "arm64": "aarch64"}[arch] + f"-linux-android{ANDROID_API_LEVEL}"
    env.Replace(CC=f"{tools}/{triple}-clang", CXX=f"{tools}/{triple}-clang++", AR=f"{tools}/llvm-ar")
    env.Append(LINKFLAGS=["-static-libstdc++", "-Wl,-z,max-page-size=16384"], CCFLAGS=["-Wno-error"])


def macos(env, arch: str) -> None:
    osxcross = os.environ.get("OSXCROSS_ROOT")
    if osxcross:
        found = sorted(Path(osxcross, "target/bin").glob(f"{arch}-apple-darwin*-clang++"))
        if not found:
            sys.exit(f"platform=macos: no {arch}-apple-darwin*-clang++ in {osxcross}/target/bin")
        prefix = str(found[-1]).removesuffix("clang++")
        env.Replace(CC=f"{prefix}clang", CXX=f"{prefix}clang++", AR=f"{prefix}ar")
    elif host.system() == "Darwin":
        env.Replace(CC="clang", CXX="clang++", AR="ar")
    else:
        sys.exit("platform=macos: build on a Mac, or set OSXCROSS_ROOT to the folder of osxcross")
    flags = ["-arch", arch, f"-mmacosx-version-min={MACOS_VERSION}"]
    env.Append(LINKFLAGS=flags, CCFLAGS=[*flags, "-Wno-error"])
