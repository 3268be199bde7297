#!/usr/bin/env bash
# setup_godot.sh: prints the path of a Godot of at least MINIMUM: $GODOT, `godot` or `godot4` on PATH, or else
# one out of a private root in the cache that holds Debian testing's package with all that it depends on.
# Nothing is installed into the system, whose C library may be older: the root's own loader starts it.
set -euo pipefail
tools=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
# shellcheck source=tools/shell.sh
source "$tools/shell.sh"

MINIMUM=4.4
SUITE=forky
ROOT=$CACHE/godot
WRAPPER=$CACHE/bin/godot

# new_enough PROGRAM: true if it runs and its version is at least MINIMUM.
new_enough() {
	local version
	version=$("$1" --headless --version 2>/dev/null | tail -n 1) || return 1
	[[ $version =~ ^[0-9]+\.[0-9]+ ]] || return 1
	printf '%s\n%s\n' "$MINIMUM" "$version" | sort --version-sort --check=quiet
}

find_own() {
	local candidate path
	for candidate in "${GODOT:-}" godot godot4; do
		if ! path=$(command -v "$candidate"); then
			[[ -n ${GODOT:-} && $candidate == "$GODOT" ]] && say "\$GODOT, $GODOT, is no program: left alone"
			continue
		fi
		[[ $path -ef $WRAPPER ]] && continue
		if new_enough "$path"; then
			printf '%s\n' "$path"
			return 0
		fi
		say "$path is not Godot $MINIMUM or later: left alone"
	done
	return 1
}

# The mirror this machine already uses for its own release.
find_mirror() {
	# shellcheck disable=SC2016 # apt-get fills in the fields
	apt-get indextargets --format '$(REPO_URI) $(RELEASE)' 'Created-By: Packages' |
		awk '$1 !~ /security/ { print $1; exit }'
}

write_apt_configuration() {
	local mirror keyring=/usr/share/keyrings/debian-archive-keyring.gpg
	mirror=$(find_mirror)
	[[ -n $mirror ]] || fail "apt has no package source; $advice"
	mkdir -p "$work"/{lists,archives}/partial "$work/none"
	: >"$work/status"
	echo "deb [signed-by=$keyring] $mirror $SUITE main" >"$work/sources.list"
	cat >"$work/apt.conf" <<-CONF
		#clear APT::Update::Post-Invoke;
		#clear APT::Update::Post-Invoke-Success;
		#clear DPkg::Post-Invoke;
		#clear Acquire::IndexTargets::deb::DEP-11;
		Dir::Etc::sourcelist "$work/sources.list";
		Dir::Etc::sourceparts "$work/none";
		Dir::Etc::preferencesparts "$work/none";
		Dir::State::lists "$work/lists";
		Dir::State::status "$work/status";
		Dir::Cache "$work";
		Dir::Cache::archives "$work/archives";
		Acquire::Languages "none";
		APT::Install-Recommends "false";
		APT::Sandbox::User "";
		Debug::NoLocking "true";
	CONF
}

# What Godot never opens is left out: it is half of the root.
unpack() {
	dpkg-deb --fsys-tarfile "$1" | tar -x -C "$2" --no-same-owner \
		--exclude=./usr/share/{doc,man,locale,info,icons,bash-completion,lintian} --exclude=./usr/{sbin,games,include}
}
export -f unpack

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

fetch() {
	local packages=("$@")
	work=$CACHE/godot.apt
	rm -rf "$work" "$ROOT.new"
	mkdir -p "$work" "$ROOT.new"
	write_apt_configuration
	say "fetching Godot from Debian $SUITE into $ROOT (about 160 MB)"
	run_apt index -c "$work/apt.conf" update || fail "no package index of Debian $SUITE (is there a network?); $advice"
	run_apt download -c "$work/apt.conf" install --yes --download-only "${packages[@]}" ||
		fail "could not download ${packages[*]} (is there a network?); $advice"
	say "unpacking Godot"
	# shellcheck disable=SC2016 # for the inner shell
	find "$work/archives" -name '*.deb' -print0 |
		xargs -0 -P "$(nproc)" -I{} bash -c 'set -euo pipefail; unpack "$1" "$2"' _ {} "$ROOT.new"
	rm -rf "$ROOT" "$work"
	mv "$ROOT.new" "$ROOT"
	write_wrapper
	new_enough "$WRAPPER" || fail "the Godot of Debian $SUITE does not start: $WRAPPER --headless --version; $advice"
}

advice="put a Godot $MINIMUM or later on PATH or in \$GODOT"
if find_own; then exit 0; fi
mapfile -t packages <"$tools/requirements/godot-root.txt"
key="$SUITE ${packages[*]} $(declare -f unpack write_wrapper | sha256sum | cut -c 1-16)"
lock_cache
if ! [[ -x $WRAPPER && -x $ROOT/usr/bin/godot ]] || ! once godot "$key"; then
	[[ "$(uname -m) $(sed -n 's/^ID=//p' /etc/os-release)" == 'x86_64 debian' ]] ||
		fail "a Godot can be fetched on Debian on x86-64 only; $advice"
	fetch "${packages[@]}"
	done_with godot "$key"
fi
printf '%s\n' "$WRAPPER"
