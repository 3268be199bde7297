# shellcheck shell=bash
# Sourced after shell.sh: a root in the cache that holds packages of Debian testing with all that they depend on.
# Nothing is installed into the system, whose C library may be older: the root's own loader starts the programs.

SUITE=forky

# The mirror this machine already uses for its own release.
find_mirror() {
	# shellcheck disable=SC2016 # apt-get fills in the fields
	apt-get indextargets --format '$(REPO_URI) $(RELEASE)' 'Created-By: Packages' |
		awk '$1 !~ /security/ { print $1; exit }'
}

# write_apt_configuration WORK ADVICE
write_apt_configuration() {
	local work=$1 mirror keyring=/usr/share/keyrings/debian-archive-keyring.gpg
	mirror=$(find_mirror)
	[[ -n $mirror ]] || fail "apt has no package source; $2"
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

# Files that no program of a root opens are left out: they are half of the root.
unpack() {
	dpkg-deb --fsys-tarfile "$1" | tar -x -C "$2" --no-same-owner \
		--exclude=./usr/share/{doc,man,locale,info,icons,bash-completion,lintian} --exclude=./usr/{sbin,games,include}
}
export -f unpack

# fetch_root ROOT WHAT ADVICE PACKAGE...: makes ROOT anew. Texts for the user: WHAT, the content, and ADVICE, the remedy.
fetch_root() {
	local root=$1 what=$2 advice=$3 work=$1.apt
	shift 3
	[[ "$(uname -m) $(sed -n 's/^ID=//p' /etc/os-release)" == 'x86_64 debian' ]] ||
		fail "$what can be fetched on Debian on x86-64 only; $advice"
	rm -rf "$work" "$root.new"
	mkdir -p "$work" "$root.new"
	write_apt_configuration "$work" "$advice"
	say "fetching $what from Debian $SUITE into $root"
	run_apt index -c "$work/apt.conf" update || fail "no package index of Debian $SUITE (is there a network?); $advice"
	run_apt download -c "$work/apt.conf" install --yes --download-only "$@" ||
		fail "could not download $* (is there a network?); $advice"
	say "unpacking $what"
	# shellcheck disable=SC2016 # for the inner shell
	find "$work/archives" -name '*.deb' -print0 |
		xargs -0 -P "$(nproc)" -I{} bash -c 'set -euo pipefail; unpack "$1" "$2"' _ {} "$root.new"
	rm -rf "$root" "$work"
	mv "$root.new" "$root"
}
