#!/usr/bin/env bash
# setup_python.sh LIST...: a virtual environment in the cache with the packages of tools/requirements/python-LIST.txt.
# `plots` also installs fonts.
set -euo pipefail
tools=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
# shellcheck source=tools/shell.sh
source "$tools/shell.sh"

[[ " $* " != *' plots '* ]] || "$tools/setup_debian.sh" fonts

# A stamp is not valid if its folder is empty.
[[ -x $CACHE/venv/bin/python && -x $CACHE/venv/bin/pip ]] || rm -f "$CACHE/stamps"/python-*

lists=() requirements=()
for list in "$@"; do
	once "python-$list" "$(<"$tools/requirements/python-$list.txt")" && continue
	lists+=("$list")
	requirements+=("$tools/requirements/python-$list.txt")
done
((${#lists[@]})) || exit 0

"$tools/setup_debian.sh" python
lock_cache
mapfile -t packages < <(cat "${requirements[@]}")
say "installing Python packages into $CACHE/venv: ${packages[*]}"
[[ -x $CACHE/venv/bin/pip ]] || python3 -m venv --clear "$CACHE/venv" || fail "python3 -m venv failed"
log=$CACHE/log/pip.log
if ! "$CACHE/venv/bin/pip" install "${packages[@]}" 2>&1 | tee "$log" |
	sed --unbuffered --quiet 's/^Collecting \([^ ]*\).*/   \1/p' >&2; then
	tail -n 5 "$log" >&2
	fail "pip could not install ${packages[*]} (is there a network?)"
fi
for list in "${lists[@]}"; do done_with "python-$list" "$(<"$tools/requirements/python-$list.txt")"; done
