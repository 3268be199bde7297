# shellcheck shell=bash
# Sourced by ./steadyhand and the set-up scripts: the cache folder, messages, apt-get.

CACHE=$(realpath -m -- "${STEADYHAND_CACHE:-${XDG_CACHE_HOME:-${HOME:-}/.cache}/steadyhand}")

say() { printf '== %s\n' "$*" >&2; }

fail() {
	printf 'steadyhand: %s\n' "$*" >&2
	exit 1
}

# once NAME KEY: true if set-up step NAME has already been done for this KEY.
once() { [[ -f $CACHE/stamps/$1 && $(<"$CACHE/stamps/$1") == "$2" ]]; }

# done_with NAME KEY: marks the step as done for once().
done_with() {
	mkdir -p "$CACHE/stamps"
	printf '%s\n' "$2" >"$CACHE/stamps/$1"
}

# Two set-ups at once (of a demo and a test) wait for each other, because they write the same files.
lock_cache() {
	if ! mkdir -p "$CACHE/log" 2>/dev/null || [[ ! -w $CACHE ]]; then
		fail "cannot write to the cache $CACHE: set \$STEADYHAND_CACHE to a folder that you can write to"
	fi
	exec 9>"$CACHE/lock"
	flock -n 9 || { say "waiting for another set-up that uses $CACHE" && flock 9; }
}

# Reads apt-get's status lines: one line redrawn on a terminal, a line per quarter elsewhere.
show_apt_progress() {
	local kind percent drawn=-1 step
	while IFS=: read -r kind _ percent _; do
		[[ $kind == dlstatus || $kind == pmstatus ]] || continue
		percent=${percent%%.*}
		step=$percent
		[[ -t 2 ]] || step=$((percent / 25 * 25))
		((step == drawn)) && continue
		drawn=$step
		if [[ -t 2 ]]; then printf '\r   %-8s %3d %%' "$1" "$step" >&2; else printf '   %s %d %%\n' "$1" "$step" >&2; fi
	done
	[[ ! -t 2 || $drawn == -1 ]] || printf '\n' >&2
}

# run_apt LABEL ARGUMENT...: apt-get by as_root. Its output goes to a log, whose end is shown on failure.
# Its status lines come on descriptor 3, made within sudo, which closes every one above 2. They cannot share
# descriptor 1: apt-get keeps the status one from the packages' scripts, and those write to their standard output.
as_root=()
run_apt() {
	local label=$1 log=$CACHE/log/apt-$1.log
	shift
	# shellcheck disable=SC2016 # for the inner shell
	if ! "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive sh -c 'exec apt-get "$@" 3>&1 1>&2' apt-get -q "$@" \
		-o APT::Status-Fd=3 -o Dpkg::Use-Pty=0 -o Acquire::Retries=2 -o APT::Update::Error-Mode=any \
		</dev/null 2>"$log" | show_apt_progress "$label"; then
		tail -n 5 "$log" | cut -c 1-300 >&2
		return 1
	fi
}
