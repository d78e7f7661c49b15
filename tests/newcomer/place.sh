#!/usr/bin/env bash
# A place where nothing has run yet: a bare Debian in a chroot, or, if none is available, a fresh clone on
# this machine. It has the tracked files of this tree, in their current state.
#   tests/newcomer/place.sh make SUITE          makes a new one, as build/newcomer/SUITE.
#   tests/newcomer/place.sh in SUITE COMMAND    runs a shell command in its tree.
#   tests/newcomer/place.sh afresh SUITE        restores the tree except its build, empties /tmp and home.
#   tests/newcomer/place.sh tree SUITE          prints the tree's path from outside.
# Mounts are made for one command at a time, in separate namespaces: nothing stays mounted, however it ends.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
program=tests/newcomer/place.sh
suite=${2:?a suite of Debian, such as bookworm}
place=$PWD/build/newcomer/$suite
root=$place/root  # the chroot
home=/srv/oddity  # its tree
own=$place/tree   # where there is no chroot
packages=/var/cache/apt/archives

isolated() { unshare --mount --pid --fork --kill-child "$@"; }

# The mirror configured on this machine.
mirror() {
  local set_to
  set_to=$(apt-get indextargets --format '$(REPO_URI)' 'Origin: Debian' | grep '/debian/*$' | sort -u | tail -n 1) || true
  echo "${set_to:-http://deb.debian.org/debian}"
}

# Uses packages that are here already, and keeps those fetched there.
share() { cp -lu "$1$packages"/*.deb "$2$packages/" 2>/dev/null || cp -u "$1$packages"/*.deb "$2$packages/" 2>/dev/null || true; }

bare_debian() {
  [ "$(id -u)" -eq 0 ] || { echo "only root can make a chroot"; return 1; }
  isolated true || return 1
  command -v debootstrap >/dev/null || { apt-get update -q && apt-get install -q -y --no-install-recommends debootstrap; } || return 1
  isolated debootstrap --variant=minbase --cache-dir=$packages "$suite" "$root" "$(mirror)" || return 1
  [ -z "${NODE_EXTRA_CA_CERTS:-}" ] || install -D -m 644 "$NODE_EXTRA_CA_CERTS" "$root$NODE_EXTRA_CA_CERTS"
  echo force-unsafe-io >"$root/etc/dpkg/dpkg.cfg.d/newcomer"  # nothing here has to outlive a power cut
  in_root 'cd / && useradd --create-home reader' </dev/null
}

# tree FOLDER: makes a clone there, with uncommitted changes.
tree() {
  git clone -q --no-hardlinks . "$1"
  git diff --quiet HEAD && return
  git diff --binary HEAD | git -C "$1" apply
  git -C "$1" -c user.name=newcomer -c user.email=newcomer@localhost commit -q -a -m 'What is not committed yet'
}

make() {
  if [ -e "$root" ]; then share "$root" ''; fi
  rm -rf "$place"
  mkdir -p "$place"
  if bare_debian >"$place/debootstrap.log" 2>&1; then
    share '' "$root"
    tree "$root$home"
    echo "newcomer: a bare Debian $(cat "$root/etc/debian_version"), $suite"
  elif [ "$suite" != bookworm ]; then
    tail -n 2 "$place/debootstrap.log"
    echo "newcomer: not run: a bare Debian $suite cannot be had here"
    return 77
  else
    tail -n 2 "$place/debootstrap.log"
    rm -rf "$root"
    tree "$own"
    echo "newcomer: a bare Debian cannot be had here: the same commands run in a fresh clone on this machine itself"
  fi
}

# Environment of a login, and of CI if this is CI.
clean() {
  env -i HOME="$1" PATH="$1/.local/bin:/usr/local/sbin:/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin" TERM=dumb \
    ${CI:+CI=$CI} ${NODE_EXTRA_CA_CERTS:+NODE_EXTRA_CA_CERTS=$NODE_EXTRA_CA_CERTS} "${@:2}"
}

in_root() {
  export -f clean
  isolated bash -c '
    set -e
    mount -t proc proc "$0/proc"
    mount --rbind /sys "$0/sys"
    mount -t tmpfs tmpfs "$0/dev/shm"
    mount -t devpts -o newinstance,ptmxmode=0666 devpts "$0/dev/pts" && ln -sf pts/ptmx "$0/dev/ptmx"
    cp /etc/resolv.conf "$0/etc/resolv.conf"
    clean /root chroot "$0" bash -c "$1"' "$root" "$1"
}

case ${1:-} in
  make) make ;;
  in)
    if [ -e "$root" ]; then
      in_root "cd $home && $3"
    else
      # /tmp is shared with others
      mkdir -p "$place/home" "$place/tmp"
      command=${3//\/tmp\//$place/tmp/}
      { cd "$own" && clean "$place/home" bash -c "$command" 2> >(sed "s,$place/tmp/,/tmp/,g" >&2); } | sed "s,$place/tmp/,/tmp/,g"
    fi
    ;;
  afresh)
    tree=$($program tree "$suite")
    git -C "$tree" update-index -q --refresh || true  # unchanged files are not written again
    git -C "$tree" checkout -q -- .
    git -C "$tree" clean -fdq
    rm -rf "$root"/tmp/* "$root"/root/* "$place"/tmp/* "$place"/home/*  # dotfiles stay: installed tools
    ;;
  tree) [ -e "$root" ] && echo "$root$home" || echo "$own" ;;
  *) sed -n 's/^#   //p' "${BASH_SOURCE[0]}" >&2; exit 2 ;;
esac
