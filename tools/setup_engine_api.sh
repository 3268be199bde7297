#!/usr/bin/env bash
# setup_engine_api.sh: prints the path of a folder with VERSION/extension_api.json of each Godot and
# gdextension_interface.json: the source of the crate gdextension-api, which cargo fetches.
set -euo pipefail
tools=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
# shellcheck source=tools/shell.sh
source "$tools/shell.sh"

wanted=$tools/requirements/engine_api
folder=$CACHE/engine_api
lock_cache
if ! [[ -d $folder/gdextension-api/src ]] || ! once engine_api "$(<"$wanted/Cargo.toml")"; then
	command -v cargo >/dev/null || fail "no cargo: the API of other Godot versions cannot be fetched. Install Rust's cargo"
	say "fetching the API of each Godot version"
	rm -rf "$folder" "$folder.new"
	cp -r "$wanted" "$folder.package"
	log=$CACHE/log/cargo.log
	if ! (cd "$folder.package" && cargo vendor "$folder.new") >"$log" 2>&1; then
		tail -n 5 "$log" >&2
		rm -rf "$folder.package" "$folder.new"
		fail "cargo could not fetch the crate gdextension-api (is there a network?)"
	fi
	rm -rf "$folder.package"
	mv "$folder.new" "$folder"
	done_with engine_api "$(<"$wanted/Cargo.toml")"
fi
printf '%s\n' "$folder/gdextension-api/src"
