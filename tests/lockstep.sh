#!/usr/bin/env bash
# Programs of `choose --lockstep --code` have the same bits by every compiler, at every optimization, on every
# machine.
#   tests/lockstep.sh PROGRAM [SCENE...]       a scene is an exercise's number or a problem's file.
# Each scene gives three programs: its choice, its choice without closed forms, and the second in float. Each
# is compiled by g++ and clang++ for x86-64 with and without FMA, for WebAssembly, arm64 and i386, the last
# two run by qemu-user. The hashes that they print are compared. A scene without such a program must report it
# in one sentence.
set -euo pipefail
program=$(realpath "$1")
shift
here=$(dirname "$(realpath "${BASH_SOURCE[0]}")")/..
jobs=${JOBS:-$(nproc)}
if [ $# -eq 0 ]; then
  mapfile -t scenes < <("$program" list --json | node -e '
    const rows = JSON.parse(require("fs").readFileSync(0)), scenes = new Set();
    for (const row of rows) if (row.scene === 1) scenes.add(row.exercise);
    console.log([...scenes].join("\n"));')
  set -- "${scenes[@]}" "$here"/chapters/examples/problems/*.toml
fi
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

cat >"$folder/wasi.mjs" <<'JS'
import { WASI } from 'node:wasi';
import { readFile } from 'node:fs/promises';
const wasi = new WASI({ version: 'preview1' });
const module = await WebAssembly.compile(await readFile(process.argv[2]));
wasi.start(await WebAssembly.instantiate(module, wasi.getImportObject()));
JS

# A line each: name, compile command, run command.
ways() {
  local compiler level
  for compiler in g++ clang++; do
    for level in -O0 -O2 -O3; do
      echo "$compiler $level|$compiler $level -march=x86-64|"
      ! grep -qw fma /proc/cpuinfo || echo "$compiler $level with FMA|$compiler $level -march=x86-64-v3|"
    done
  done
  for level in -O0 -O2 -O3; do
    echo "WebAssembly $level|clang++ --target=wasm32-wasi -fno-exceptions $level|node --no-warnings $folder/wasi.mjs"
    echo "arm64 $level|aarch64-linux-gnu-g++ -static $level|qemu-aarch64"
    echo "i386 $level|i686-linux-gnu-g++ -static -msse2 -mfpmath=sse $level|qemu-i386"
  done
}

# compare CODE: prints a line "FILE: HASH in N ways", or the differences and returns 1
compare() {
  local file=$1 name compile run hash first= count=0
  while IFS='|' read -r name compile run; do
    if ! $compile -std=c++20 "$file" -o "$file.out" 2>"$file.said"; then
      echo "$(basename "$file"), $name: does not compile: $(head -n 1 "$file.said")"
      return 1
    fi
    hash=$($run "$file.out" | sed -n 's/^bits of all.*: //p')
    first=${first:-$hash}
    if [ -z "$hash" ] || [ "$hash" != "$first" ]; then
      echo "$(basename "$file"), $name: ${hash:-no hash} instead of $first"
      return 1
    fi
    count=$((count + 1))
  done < <(ways)
  echo "$(basename "$file" .cpp): $first in $count ways"
}
export -f compare ways
export folder

asked=0 refused=0
for scene in "$@"; do
  for more in '' '--exclude closed' '--exclude closed --precision float'; do
    asked=$((asked + 1))
    name=$(basename "$scene" .toml)${more:+ without closed forms}
    [[ $more != *float ]] || name+=' in float'
    ended=0
    # if three digits are too many, no program is printed: a fast scene is asked for less
    for digits in 3 2 1; do
      ended=0
      "$program" choose "$scene" --digits $digits --starts 1 --lockstep --code $more >"$folder/$name.cpp" 2>"$folder/why" || ended=$?
      [ $ended -ne 1 ] || [ -s "$folder/$name.cpp" ] || continue
      break
    done
    if [ ! -s "$folder/$name.cpp" ]; then
      rm "$folder/$name.cpp"
      if grep -q "algorithm of .* has 'closed' in its name" "$folder/why"; then
        asked=$((asked - 1))  # a file without a closed form
        continue
      fi
      refused=$((refused + 1))
      echo "$name: none: $(tr '\n' ' ' <"$folder/why" | cut -c1-300)"
      [ -s "$folder/why" ] || { echo "$name: no program and no reason"; exit 1; }
    fi
  done
done
differing=0
find "$folder" -name '*.cpp' -print0 | sort -z | xargs -0 -P "$jobs" -n 1 bash -c 'compare "$0"' || differing=1
echo "$asked asked, $refused have no such program"
exit $differing
