#!/usr/bin/env bash
# Checks that the report is short enough to read, and that report/book is its copy without times, byte for
# byte.
#   tests/book.sh PROGRAM
# Uses the program's last results if they are fresh; otherwise runs everything first.
set -euo pipefail
program=$1
kept=$(cd "$(dirname "${BASH_SOURCE[0]}")/../report/book" && pwd)
out=$(mktemp -d)
trap 'rm -rf "$out"' EXIT

"$program" report --out "$out/report"
words=$(cat "$out"/report/*.md | wc -w)
bytes=$(cat "$out"/report/*.md "$out"/report/charts/* | wc -c)
echo "the report has $words words and $bytes bytes"
[ "$words" -le 62000 ] && [ "$bytes" -le 8000000 ]

status=0
"$program" report --book --out "$out/book" || status=$?
[ "$status" -ne 2 ] || exit 77  # a build with SUNDIALS, as the program has reported
diff -r --exclude=.oddity "$out/book" "$kept" ||
  { echo "report/book is another report: './oddity report --book --out report/book' writes it anew"; exit 1; }
