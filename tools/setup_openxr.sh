#!/usr/bin/env bash
# setup_openxr.sh: prints the path of a program that starts another one, as `godot` or `monado-service`, out of a root
# in the cache (debian_root.sh): Monado, an OpenXR runtime with simulated devices, a Godot that loads it, and lavapipe,
# a Vulkan driver that needs no graphics card. They share one root, because the runtime is loaded into Godot's process.
set -euo pipefail
tools=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
# shellcheck source=tools/shell.sh
source "$tools/shell.sh"
# shellcheck source=tools/debian_root.sh
source "$tools/debian_root.sh"

ROOT=$CACHE/openxr
WRAPPER=$CACHE/bin/in_openxr_root

write_wrapper() {
	mkdir -p "$CACHE/bin"
	cat >"$WRAPPER" <<-WRAPPER
		#!/bin/sh
		root='$ROOT'
		lib=\$root/usr/lib/x86_64-linux-gnu
		program=\$1
		shift
		export VK_DRIVER_FILES=\$root/usr/share/vulkan/icd.d/lvp_icd.json
		export XR_RUNTIME_JSON=\$root/usr/share/openxr/1/openxr_monado.json
		export FONTCONFIG_PATH=\$root/etc/fonts
		exec "\$lib/ld-linux-x86-64.so.2" \\
			--library-path "\$lib:\$lib/pulseaudio:\$lib/blas:\$lib/lapack:\$root/usr/lib" "\$root/usr/bin/\$program" "\$@"
	WRAPPER
	chmod +x "$WRAPPER"
}

advice="the tests with OpenXR cannot run"
mapfile -t packages <"$tools/requirements/godot-root-openxr.txt"
key="$SUITE ${packages[*]} $(declare -f unpack write_wrapper | sha256sum | cut -c 1-16)"
lock_cache
if ! [[ -x $WRAPPER && -x $ROOT/usr/bin/monado-service ]] || ! once openxr "$key"; then
	fetch_root "$ROOT" "Godot and Monado (about 260 MB)" "$advice" "${packages[@]}"
	write_wrapper
	done_with openxr "$key"
fi
printf '%s\n' "$WRAPPER"
