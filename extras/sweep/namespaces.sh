#!/usr/bin/env bash
# Imitates a sweep on four machines: network namespaces that meet at a bridge, with Open MPI over TCP between
# them, started as by ssh. One rank is killed on the way; the result must be that of one thread.
#   extras/sweep/namespaces.sh PROGRAM
# Exits with 77 if namespaces cannot be made.
set -euo pipefail
program=$(realpath "$1")
machines=4

# In a separate network and mount table, which disappear with the last of these processes.
if [ -z "${ODDITY_APART:-}" ]; then
  as_root=()
  [ "$(id -u)" -eq 0 ] || as_root=(--map-root-user)
  apart=(unshare "${as_root[@]}" --mount --net)
  "${apart[@]}" sh -c 'mount -t tmpfs none /run && ip netns add tried' 2>/dev/null ||
    { echo "not run: no network namespaces can be made here"; exit 77; }
  ODDITY_APART=1 exec "${apart[@]}" "$0" "$program"
fi

mount -t tmpfs none /run
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

ip link set lo up
ip link add bridge type bridge
ip address add 10.77.0.100/24 dev bridge
ip link set bridge up
hosts=
for i in $(seq $machines); do
  ip netns add "machine$i"
  ip link add "port$i" type veth peer name net netns "machine$i"
  ip link set "port$i" master bridge up
  ip -n "machine$i" address add "10.77.0.$i/24" dev net
  ip -n "machine$i" link set lo up
  ip -n "machine$i" link set net up
  hosts+=${hosts:+,}10.77.0.$i
done

cat >"$work/agent" <<'END'
#!/bin/sh
# Called like ssh: a machine's address, and a command.
machine=machine${1##*.}
shift
exec ip netns exec "$machine" unshare --uts sh -c "hostname $machine; $*"
END
cat >"$work/ranks" <<END
#!/bin/sh
hostname >>"$work/ran_on"
exec "$program" sweep run "\$1"
END
chmod +x "$work/agent" "$work/ranks"

on_machines() {
  OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 mpirun -n $machines --host "$hosts" --map-by node \
    --mca plm_rsh_agent "$work/agent" --mca btl tcp,self --mca pml ob1 \
    --mca oob_tcp_if_include 10.77.0.0/24 --mca btl_tcp_if_include 10.77.0.0/24 "$work/ranks" "$1"
}

same_chunks() { diff -r --brief "$work/one/chunks" "$1/chunks"; }

"$program" sweep plan "$work/one" 3.5 --model 'one angle' --algorithm 'velocity Verlet' \
  --over a=10deg..170deg:520 --over step=5ms..1:520 --looks 4 --chunk-time 0.5ms
for folder in four killed; do
  mkdir "$work/$folder"
  cp "$work/one/plan.json" "$work/$folder"
done
"$program" sweep run --threads 1 "$work/one" >/dev/null

on_machines "$work/four"
same_chunks "$work/four"
[ "$(sort -u "$work/ran_on" | wc -l)" -eq $machines ] || { echo "not on $machines machines"; cat "$work/ran_on"; exit 1; }

on_machines "$work/killed" >/dev/null 2>&1 &
until [ -n "$(ls "$work/killed/chunks" 2>/dev/null)" ]; do
  kill -0 $! 2>/dev/null || { echo "it ended without a chunk"; exit 1; }
  sleep 0.01
done
ip netns pids machine3 | while read -r process; do
  [ "$(readlink "/proc/$process/exe")" != "$program" ] || kill -9 "$process" || true
done
wait $! && echo "all ran through, though one was killed" && exit 1
echo "one of $machines was killed: $(ls "$work/killed/chunks" | grep -c 'txt$') chunks were there"
on_machines "$work/killed"
same_chunks "$work/killed"
echo "the same, byte for byte, on $machines machines and on one"
