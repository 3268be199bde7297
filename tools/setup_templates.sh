#!/usr/bin/env bash
# setup_templates.sh: prints the path of a root in the cache (debian_root.sh) with Godot's release template for exports
# and all libraries that it needs.
set -euo pipefail
tools=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
# shellcheck source=tools/shell.sh
source "$tools/shell.sh"
# shellcheck source=tools/debian_root.sh
source "$tools/debian_root.sh"

ROOT=$CACHE/templates

mapfile -t packages <"$tools/requirements/godot-root-export.txt"
key="$SUITE ${packages[*]} $(declare -f unpack | sha256sum | cut -c 1-16)"
lock_cache
if ! [[ -x $ROOT/usr/bin/godot-template-release ]] || ! once templates "$key"; then
	fetch_root "$ROOT" "Godot's export template (about 110 MB)" 'the test of an export cannot run' "${packages[@]}"
	done_with templates "$key"
fi
printf '%s\n' "$ROOT"
