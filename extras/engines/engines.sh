#!/usr/bin/env bash
# Compares third-party engines on the scenes with the approved records:
#   extras/engines/engines.sh PROGRAM [SCENE...]
# Without scenes it runs all but the chain of 100 (25 minutes). Measured orders must be within a tenth. Drifts
# of energy and momentum, and the ends of joints, must be within a tenth of themselves, or both below a
# millionth. Everything else must be equal letter by letter. Engines that are missing or have another version
# are listed, not compared.
set -euo pipefail
program=$1
shift
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
record=$root/reference/approved/engines.csv
if ! compgen -G "$(dirname "$program")/engines/engine_*" >/dev/null && [ ! -d "$root/extras/engines/adapters/node_modules" ]; then
  echo "no engine is built; ./oddity engines installs and builds them"
  exit 77
fi
now=$(mktemp)
trap 'rm -f "$now"' EXIT

"$program" engines --rows "$@" >"$now"
awk -F, '
  function key() { return $1 "," $2 "," $3 "," $4 }
  function told(  i, text) { for (i = 6; i <= 10; ++i) text = text "," $i; return text }
  function apart(a, b) { return (a == "-") != (b == "-") || (a - b) ^ 2 > (0.1 * (a > b ? a : b) + 1e-6) ^ 2 }
  FNR == 1 { next }
  NR == FNR { order[key()] = $5; other[key()] = told(); for (i = 11; i <= 13; ++i) drift[key(), i] = $i; line[key()] = $0; next }
  { tried[$1] = 1 }
  !(key() in order) { print "not on record: " key(); ++unknown; next }
  {
    seen[key()] = 1
    off = order[key()] - $5
    differs = (order[key()] == "-") != ($5 == "-") || off > 0.1 || off < -0.1 || told() != other[key()]
    if ($9 == "same") for (i = 11; i <= 13; ++i) differs = differs || apart(drift[key(), i], $i)
    if (differs) { print "on record: " line[key()]; print "now:       " $0; ++wrong }
    ++compared
  }
  END {
    for (k in order) if (substr(k, 1, index(k, ",") - 1) in tried && !(k in seen)) { print "not here: " k; ++missing }
    print compared + 0 " compared, " wrong + 0 " differ, " missing + 0 " not here, " unknown + 0 " not on record"
    exit wrong > 0 || compared == 0
  }' "$record" "$now"
