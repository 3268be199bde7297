#!/usr/bin/env bash
# import_project.sh GODOT PROJECT: has the editor import PROJECT and find its extension, if a file of it has changed.
set -euo pipefail
godot=$1 project=$2
stamp=$project/.godot/steadyhand_imported # `imported` is the engine's own folder
if [[ -f $stamp ]] && [[ -z $(find "$project" -path "$project/.godot" -prune -o -newer "$stamp" -type f -print -quit) ]]; then
	exit 0
fi

printf '== importing %s\n' "$project" >&2
complaints='SCRIPT ERROR|Parse Error|^ERROR: '
import() {
	output=$(timeout 300 "$godot" --headless --path "$project" --import 2>&1) && ! grep -Eq "$complaints" <<<"$output"
}
# The first import may crash while it writes documentation (godotengine/godot#111048), and reads scripts before the
# extension's classes are known: only the second import counts.
if ! import && ! import; then
	tail -n 30 <<<"$output" >&2
	printf 'steadyhand: Godot could not import %s\n' "$project" >&2
	exit 1
fi
touch "$stamp"
