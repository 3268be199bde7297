#!/usr/bin/env bash
# setup_debian.sh LIST...: installs the missing packages of tools/requirements/debian-LIST.txt.
set -euo pipefail
tools=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
# shellcheck source=tools/shell.sh
source "$tools/shell.sh"

missing=()
for list in "$@"; do
	while read -r package; do
		status=$(dpkg-query -W -f='${Status}' "$package" 2>/dev/null || true)
		[[ $status == 'install ok installed' ]] || missing+=("$package")
	done <"$tools/requirements/debian-$list.txt"
done
((${#missing[@]})) || exit 0

command -v apt-get >/dev/null || fail "these Debian packages are needed: ${missing[*]} (and there is no apt-get here)"
if ((EUID != 0)); then
	command -v sudo >/dev/null || fail "not root and no sudo: ask for apt-get install ${missing[*]}"
	as_root=(sudo)
fi

lock_cache
say "installing Debian packages: ${missing[*]}"
run_apt index update || fail "no package index for ${missing[*]} (is there a network?)"
run_apt install install --yes --no-install-recommends "${missing[@]}" ||
	fail "apt-get could not install ${missing[*]}: see above (is there a network?)"
