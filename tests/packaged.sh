#!/usr/bin/env bash
# Checks a package made by ./oddity package: its contents, and that it installs and answers on a bare Debian.
#   tests/packaged.sh oddity_0.1.0_amd64.deb
# Without root, or a mirror to make such a Debian from, the last part is skipped with a message.
set -euo pipefail
package=$(realpath "${1:?the package}")
place=$(mktemp -d)
trap 'rm -rf "$place"' EXIT

# check NAME COMMAND...
check() {
  "${@:2}" || { echo "packaged: $1: wrong" >&2; exit 1; }
  echo "packaged: $1"
}
has() { grep -qF -- "$2" <<<"$1"; }

files=$(dpkg-deb --contents "$package")
for file in bin/oddity share/man/man1/oddity.1 share/bash-completion/completions/oddity share/oddity/models.js \
            share/oddity/own.js share/oddity/reference/tables/03_05_swing.csv share/oddity/reference/approved/proofs.csv \
            share/oddity/reference/trust/fuzz.csv liboddity_lanes.so share/cmake/oddity/oddityConfig.cmake; do
  check "it has $file" has "$files" "$file"
done
check "nothing outside of /usr" test -z "$(awk '{print $6}' <<<"$files" | grep -vE '^\./(usr/.*)?$')"
check "its libraries are Debian's packages" has "$(dpkg-deb --field "$package" Depends)" libgsl

# ---- on a bare Debian -------------------------------------------------------------------------------------

bare=$place/bare
suite=$(. /etc/os-release && echo "$VERSION_CODENAME")
mirror=$(apt-get indextargets --format '$(REPO_URI)' 'Origin: Debian' | grep '/debian/*$' | sort -u | tail -n 1)
if [ "$(id -u)" -ne 0 ] || ! command -v debootstrap >/dev/null ||
   ! debootstrap --variant=minbase "$suite" "$bare" "$mirror" >"$place/log" 2>&1; then
  echo "packaged: no bare Debian can be made here ($(tail -n 1 "$place/log" 2>/dev/null || echo "it takes root and debootstrap")): not installed"
  exit
fi
# on_bare COMMAND...: runs it as its root, with a /proc that disappears with the command. In a chroot / is not
# a mount that could be made private, and need not be.
on_bare() {
  env -i PATH=/usr/bin:/bin:/usr/sbin:/sbin HOME=/home/reader \
    unshare --mount --propagation unchanged --pid --fork sh -c '
      mount --make-rprivate / 2>/dev/null
      mount -t proc proc "$0/proc" && exec chroot "$0" "$@"' "$bare" "$@"
}
cp /etc/resolv.conf "$bare/etc/"
cp "$package" "$bare/oddity.deb"
mkdir -p "$bare/home/reader"
chown 1000 "$bare/home/reader"
on_bare apt-get install -q -y --no-install-recommends /oddity.deb >"$place/log" 2>&1 || { tail "$place/log"; exit 1; }
reader() { on_bare setpriv --reuid 1000 --regid 1000 --clear-groups "$@"; }
check "installed, it has its tables" has "$(reader oddity solve 3.5)" "(table 03_05_quarter_period.csv)"
check "it chooses" has "$(reader oddity choose 3.5 --error 1deg --json)" '"lanes": null'
check "in lanes" has "$(reader oddity choose 3.5 --error 1deg --bodies 1000)" "side by side in lanes"
check "it verifies" has "$(reader oddity verify '[3.5]')" "All tests passed"
check "it writes a report" has "$(reader oddity chart 3.5 --out /tmp/charts)" /tmp/charts/3.5.md
check "its completion is found" has "$(on_bare bash -c '. /usr/share/bash-completion/completions/oddity; COMP_WORDS=(oddity so) COMP_CWORD=1; _oddity; echo ${COMPREPLY[@]}')" solve
on_bare apt-get remove -q -y oddity >/dev/null 2>&1
check "removed, nothing of it is left" test -z "$(find "$bare/usr" -name '*oddity*')"
