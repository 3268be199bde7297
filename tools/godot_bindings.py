"""Adds godot_cpp headers and code to the build: an installed godot-cpp, or the repo's own bindings."""

import hashlib
import os
import subprocess
import sys
from pathlib import Path

# Inlined code of another godot-cpp version may raise warnings.
OF_OTHERS = ["-Wno-error"]


def add_installed(env, prefix: Path) -> None:
    """Adds an installed godot-cpp, or a built checkout of it."""
    library = f"libgodot-cpp.{env['platform']}.{env['target']}.{env['arch']}.a"
    found = [folder / library for folder in (prefix / "lib", prefix / "bin") if (folder / library).exists()]
    if not found:
        sys.exit(f"no {library} in {prefix}/lib or {prefix}/bin")
    for include in ("include", "gen/include", "gdextension"):
        if (prefix / include).is_dir():
            env.Append(CCFLAGS=["-isystem", str(prefix / include)])
    env.Append(LIBS=[env.File(str(found[0]))], CCFLAGS=OF_OTHERS)


def add_from_pkg_config(env) -> bool:
    """Adds the godot-cpp that pkg-config finds. Returns False if there is none."""
    query = ["pkg-config", "--silence-errors", "--cflags", "--libs", "godot-cpp"]
    try:
        answer = subprocess.run(query, capture_output=True, text=True)
    except FileNotFoundError:
        return False
    if answer.returncode != 0:
        return False
    env.MergeFlags(answer.stdout)
    env.Append(CCFLAGS=OF_OTHERS)
    return True


def add_own(env, root: Path) -> list[str]:
    """Generates the repo's own bindings for the Godot of this machine, and returns their sources."""
    godot = find_godot(root)
    version = subprocess.run([godot, "--headless", "--version"], capture_output=True, text=True).stdout
    generator = root / "extension/bindings/generate.py"
    parts = [*sorted(generator.parent.glob("*.py")), generator.with_name("manifest.txt")]
    key = hashlib.sha256(version.encode() + b"".join(part.read_bytes() for part in parts)).hexdigest()

    api = root / "build/godot_api"
    generated = root / "build/bindings"
    stamp = root / "build/bindings.stamp"
    if not stamp.exists() or stamp.read_text() != key:
        print(f"generating the bindings for Godot {version.strip()}", flush=True)
        dump_api(godot, api)
        arguments = ["--api", str(api / "extension_api.json"), "--out", str(generated)]
        subprocess.run([sys.executable, str(generator), *arguments], check=True)
        stamp.write_text(key)

    env.Append(CPPPATH=["#build/bindings/include", "#extension/bindings/include", "#build/godot_api"])
    written = [str(source) for source in sorted((generated / "src").rglob("*.cpp"))]
    return written + [str(source) for source in sorted(generator.parent.rglob("*.cpp"))]


def find_godot(root: Path) -> str:
    """The Godot executable to build for. It is downloaded into the cache if the machine has none."""
    finder = [str(root / "tools/setup_godot.sh")]
    answer = subprocess.run(finder, stdout=subprocess.PIPE, text=True)
    if answer.returncode != 0:
        sys.exit(answer.returncode)
    return answer.stdout.strip()


def dump_api(godot: str, folder: Path) -> None:
    """Lets the engine write gdextension_interface.h and extension_api.json. It writes into its working folder."""
    os.makedirs(folder, exist_ok=True)
    query = [godot, "--headless", "--dump-gdextension-interface", "--dump-extension-api"]
    answer = subprocess.run(query, cwd=folder, capture_output=True, text=True)
    if answer.returncode != 0 or not (folder / "extension_api.json").exists():
        sys.exit(f"{godot} did not write its extension API:\n{answer.stdout}{answer.stderr}")
