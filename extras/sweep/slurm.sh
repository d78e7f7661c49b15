#!/usr/bin/env bash
# Runs the array script of `sweep run --slurm` by Slurm itself: a cluster of one machine, whose daemons are
# started here with separate keys, ports and files. The array's jobs are killed on their way, and the array
# runs again.
#   extras/sweep/slurm.sh PROGRAM
# Exits with 77 if the daemons do not start.
set -euo pipefail
program=$(realpath "$1")
PATH=/usr/sbin:$(dirname "$program"):$PATH
[ "$(id -u)" -eq 0 ] || { echo "not run: Slurm's daemons are started as root"; exit 77; }
work=$(mktemp -d)
started=()
stop() {
  [ ${#started[@]} -eq 0 ] || kill "${started[@]}" 2>/dev/null || true
  wait
  rm -rf "$work"
}
trap stop EXIT
start() {
  "$@" >>"$work/log" 2>&1 &
  started+=($!)
}
not_run() {
  echo "not run: $1"
  tail -n 20 "$work/log"
  exit 77
}

export SLURM_CONF=$work/slurm.conf
mkdir "$work/state" "$work/spool"
dd if=/dev/urandom of="$work/munge.key" bs=1024 count=1 2>/dev/null
chmod 400 "$work/munge.key"
chmod 755 "$work"
cat >"$SLURM_CONF" <<END
ClusterName=here
SlurmctldHost=$(hostname -s)(127.0.0.1)
SlurmUser=root
SlurmctldPort=27817
SlurmdPort=27818
AuthType=auth/munge
AuthInfo=socket=$work/munge.socket
CryptoType=crypto/munge
StateSaveLocation=$work/state
SlurmdSpoolDir=$work/spool
SlurmctldPidFile=$work/slurmctld.pid
SlurmdPidFile=$work/slurmd.pid
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SelectType=select/cons_tres
SelectTypeParameters=CR_Core
ReturnToService=2
NodeName=$(hostname -s) NodeAddr=127.0.0.1 CPUs=$(nproc)
PartitionName=all Nodes=ALL Default=YES MaxTime=INFINITE State=UP
END
start munged --foreground --force --key-file "$work/munge.key" --socket "$work/munge.socket" \
  --pid-file "$work/munged.pid" --log-file "$work/munged.log" --seed-file "$work/munge.seed"
for _ in $(seq 100); do [ ! -S "$work/munge.socket" ] || break; sleep 0.1; done
[ -S "$work/munge.socket" ] || not_run "munged does not start"
start slurmctld -D
start slurmd -D
for _ in $(seq 300); do
  [ "$(sinfo --noheader --format %t 2>/dev/null)" != idle ] || break
  sleep 0.1
done
[ "$(sinfo --noheader --format %t 2>/dev/null)" = idle ] || not_run "Slurm's machine is not up: $(sinfo 2>&1)"

cd "$work"
same_chunks() { diff -r --brief one/chunks "$1/chunks"; }
oddity sweep plan one 3.5 --model 'one angle' --algorithm 'velocity Verlet' \
  --over a=10deg..170deg:520 --over step=5ms..1:520 --looks 4 --chunk-time 0.5ms
for folder in array killed; do
  mkdir $folder
  cp one/plan.json $folder
done
oddity sweep run --threads 1 one >/dev/null

oddity sweep run array --slurm 7 | sbatch --wait --output 'array_%a'
for task in $(seq 7); do grep -q 'chunks are there' "array_$task" || { echo "task $task:"; cat "array_$task"; exit 1; }; done
same_chunks array

oddity sweep run killed --slurm 7 | sbatch --parsable --output 'killed_%a' >job
until [ -n "$(ls killed/chunks 2>/dev/null)" ]; do
  [ -n "$(squeue --noheader)" ] || { echo "it ended without a chunk"; cat killed_*; exit 1; }
  sleep 0.01
done
scancel --signal KILL --full "$(cat job)"
until [ -z "$(squeue --noheader)" ]; do sleep 0.1; done
echo "what ran of the array was killed: $(ls killed/chunks | grep -c 'txt$') of $(ls one/chunks | wc -l) chunks are there"
oddity sweep run killed --slurm 7 | sbatch --wait --output 'again_%a'
same_chunks killed
echo "the same, byte for byte, by an array of $(sinfo --version) and by one thread"
