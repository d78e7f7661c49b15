#!/usr/bin/env bash
# The third witness: compares PARI/GP's output for every script of reference/witness with witness.csv.
#   tests/witness.sh            compares
#   tests/witness.sh --write    writes the record
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
command -v gp >/dev/null || { echo "not run: no gp (./oddity packages pari-gp)"; exit 77; }

record=reference/witness/witness.csv

said() {
  echo "# What PARI/GP says of the errata, by tests/witness.sh --write: what of it the suite has too, in which check"
  echo "# and at which letters, what is right, and what is printed."
  echo "claim,seen,check,at,right,printed"
  local script exercise row
  for script in reference/witness/[0-9]*/*.gp; do
    exercise=$(basename "$(dirname "$script")")
    row=$(gp -q -f "$script" </dev/null 2>&1)
    [[ $row =~ ^(both|right|formula|case),[^,]*,[^,]*,[^,]+,[^,]+$ ]] || { echo "$script says: $row" >&2; return 1; }
    echo "$((10#${exercise%_*})).$((10#${exercise#*_}))-$(basename "$script" .gp),$row"
  done
}

if [ "${1:-}" = --write ]; then
  new=$(said) && echo "$new" >"$record"
else
  new=$(said) && diff "$record" <(echo "$new") && echo "$(grep -c '^[0-9]' "$record") errata, as on record"
fi
