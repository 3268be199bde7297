#!/usr/bin/env bash
# setup_godot.sh: prints the path of a Godot of at least MINIMUM: $GODOT, `godot` or `godot4` on PATH, or else
# one out of a root in the cache (debian_root.sh).
set -euo pipefail
tools=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
# shellcheck source=tools/shell.sh
source "$tools/shell.sh"
# shellcheck source=tools/debian_root.sh
source "$tools/debian_root.sh"

MINIMUM=4.4
ROOT=$CACHE/godot
WRAPPER=$CACHE/bin/godot

# new_enough PROGRAM: true if it runs and its version is at least MINIMUM.
new_enough() {
	local version
	version=$("$1" --headless --version 2>/dev/null | tail -n 1) || return 1
	[[ $version =~ ^[0-9]+\.[0-9]+ ]] || return 1
	printf '%s\n%s\n' "$MINIMUM" "$version" | sort --version-sort --check=quiet
}

# find_own: the user's Godot. A $GODOT that is no Godot is an error.
find_own() {
	local candidate path
	if [[ -n ${GODOT:-} ]]; then
		path=$(command -v "$GODOT") || fail "\$GODOT is no program: $GODOT"
		new_enough "$path" || fail "\$GODOT is no Godot $MINIMUM or later: $GODOT"
		printf '%s\n' "$path"
		return 0
	fi
	for candidate in godot godot4; do
		path=$(command -v "$candidate") || continue
		[[ $path -ef $WRAPPER ]] && continue
		if new_enough "$path"; then
			printf '%s\n' "$path"
			return 0
		fi
		say "$path is not Godot $MINIMUM or later: left alone"
	done
	return 1
}

write_wrapper() {
	mkdir -p "$CACHE/bin"
	cat >"$WRAPPER" <<-WRAPPER
		#!/bin/sh
		root='$ROOT'
		lib=\$root/usr/lib/x86_64-linux-gnu
		export LIBGL_DRIVERS_PATH=\$lib/dri GBM_BACKENDS_PATH=\$lib/gbm
		export __EGL_VENDOR_LIBRARY_DIRS=\$root/usr/share/glvnd/egl_vendor.d
		export FONTCONFIG_PATH=\$root/etc/fonts
		exec "\$lib/ld-linux-x86-64.so.2" --library-path "\$lib:\$lib/pulseaudio" "\$root/usr/bin/godot" "\$@"
	WRAPPER
	chmod +x "$WRAPPER"
}

advice="put a Godot $MINIMUM or later on PATH or in \$GODOT"
if find_own; then exit 0; fi
mapfile -t packages <"$tools/requirements/godot-root.txt"
key="$SUITE ${packages[*]} $(declare -f unpack write_wrapper | sha256sum | cut -c 1-16)"
lock_cache
if ! [[ -x $WRAPPER && -x $ROOT/usr/bin/godot ]] || ! once godot "$key"; then
	fetch_root "$ROOT" 'a Godot (about 160 MB)' "$advice" "${packages[@]}"
	write_wrapper
	new_enough "$WRAPPER" || fail "the Godot of Debian $SUITE does not start: $WRAPPER --headless --version; $advice"
	done_with godot "$key"
fi
printf '%s\n' "$WRAPPER"
