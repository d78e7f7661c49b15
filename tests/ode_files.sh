#!/usr/bin/env bash
# Runs XPPAUT's own example files, from its package. Each is answered, or refused in one sentence, and each
# motion is compared with xppaut's own.
#   tests/ode_files.sh PROGRAM [FILE...]
# Compares at four times of oddity's horizon, relative to the requested error (a thousandth of the widest
# range). xppaut runs the classical Runge-Kutta method at 20,000 and at 80,000 steps, or at 50 times as many
# if it does not reach the end. Its output has eight digits. If oddity and xppaut differ by more than a tenth,
# xppaut is right if its own two runs agree. Otherwise neither is refuted, and only oddity's own two routes
# check its motion.
set -euo pipefail
program=$(realpath "$1")
shift
[ $# -gt 0 ] || mapfile -t < <(dpkg -L xppaut | grep -E '\.ode(\.gz)?$' | sort) && set -- "${@:-${MAPFILE[@]}}"
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"

# by_xppaut FILE HORIZON STEPS: prints time and variables at the start and at sixteen times
by_xppaut() {
  # A set of parameters would be a separate run.
  awk 'tolower($1) == "done" || tolower($0) ~ /^d[ \t\r]*$/ { exit }
       tolower($1) == "only" || tolower($1) == "set" || goes_on { goes_on = /\\[ \t\r]*$/; next }
       { print }' "$1" >copy.ode
  awk -v t="$2" -v n="$3" 'BEGIN {
      printf "@ total=%.15g,dt=%.15g,nout=%d,trans=0,meth=rungekutta,maxstor=1000\n", t, t / n, n / 16
      print "@ bound=1e12,output=rows.dat\ndone" }' >>copy.ode
  rm -f rows.dat
  timeout 300 xppaut copy.ode -silent >said 2>&1 || true
  [ -s rows.dat ] && head -n 17 rows.dat
}

answered=0 moving=0 refused=0 late=0 differing=0 wrong=0
for file in "$@"; do
  name=${file##*/ode/}
  name=${name##*/html/}
  case $file in
    *.gz) zcat "$file" >own.ode ;;
    *) cp "$file" own.ode ;;
  esac
  ended=0
  timeout 600 "$program" solve own.ode --json >solved.json 2>why || ended=$?
  if [ $ended -eq 124 ]; then
    echo "$name: not answered within ten minutes"
    late=$((late + 1))
    continue
  elif [ $ended -ne 0 ]; then
    place='^oddity: own.ode\(:[0-9]*:[0-9]*: \)'
    grep -q "$place" why || { echo "$name: refused without a place: $(grep -v 'so far$' why | head -n 1)"; wrong=$((wrong + 1)); continue; }
    echo "$name: refused: $(sed -n "s/$place/\\1/p" why | head -n 1)"
    refused=$((refused + 1))
    continue
  fi
  answered=$((answered + 1))
  awk '/"reference": \[/ { on = 1; next } on && /\]/ { exit } on { gsub(/[ ,]/, ""); print }' solved.json >true.txt
  horizon=$(sed -n 's/^ *"says": ".* at 4 times up to \(.*\) s",$/\1/p' solved.json | head -n 1)
  need=$(sed -n 's/^ *"allowed": \([^,]*\),$/\1/p' solved.json | head -n 1)
  for steps in 20000 1000000; do  # a stiff motion needs more to be stable
    by_xppaut own.ode "$horizon" $steps >rows.coarse || true
    by_xppaut own.ode "$horizon" $((4 * steps)) >rows.fine || true
    [ "$(wc -l <rows.coarse)" -lt 17 ] || [ "$(wc -l <rows.fine)" -lt 17 ] || break
  done
  verdict=$(awk -v need="$need" '
      function off(a, b) { return a > b ? a - b : b - a }
      FILENAME == "true.txt" { truth[++n] = $1; next }
      FILENAME == "rows.coarse" { for (i = 2; i <= n / 4 + 1; ++i) coarse[FNR, i] = $i; next }
      FNR == 1 { for (i = 2; i <= n / 4 + 1; ++i) start[i] = $i; next }
      { for (i = 2; i <= n / 4 + 1; ++i) if (off($i, start[i]) > need) moves = 1 }
      FNR % 4 == 1 {
        for (i = 2; i <= n / 4 + 1; ++i) {
          v = truth[rows * n / 4 + i - 1]
          d = off(v, $i); if (d > most) most = d
          d = off(coarse[FNR, i], $i); if (d > own) own = d
          digits = (v < 0 ? -v : v) * 3e-8; if (digits > least) least = digits
        }
        ++rows }
      END {
        if (rows < 4) { print "xppaut has no motion of it"; exit }
        printf "%s, differs by %.2g, xppaut from itself by %.2g", moves ? "moves" : "rests", most / need, own / need
        if (most > 0.1 * need && most > 3 * least) printf ": DIFFERS, %s", (own > most / 20) ? "as xppaut does from itself" : "xppaut is right"
      }' true.txt rows.coarse rows.fine)
  echo "$name: $verdict"
  case $verdict in
    moves*) moving=$((moving + 1)) ;;
  esac
  case $verdict in
    *"xppaut is right"*) wrong=$((wrong + 1)) ;;
    *DIFFERS*) differing=$((differing + 1)) ;;
  esac
done
echo "$# files: $answered answered, of which $moving move; $refused refused; $late not answered in time; $differing differ as xppaut does from itself, $wrong are wrong"
# At least 56 of the package's 120 files must be answered with motions that move, and none too late.
[ $wrong -eq 0 ] && { [ $# -lt 100 ] || { [ $moving -ge 56 ] && [ $late -eq 0 ]; }; }
