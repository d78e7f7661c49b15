#!/usr/bin/env bash
# Installs a build into a separate folder, and checks the result as another project and a user find it.
#   tests/installed.sh BUILD
set -euo pipefail
build=$(realpath "${1:?the build to install}")
place=$(mktemp -d)
trap 'rm -rf "$place"' EXIT
prefix=$place/moved
export HOME=$place/home
unset XDG_CACHE_HOME

# check NAME COMMAND...
check() {
  "${@:2}" || { echo "installed: $1: wrong" >&2; exit 1; }
  echo "installed: $1"
}
has() { grep -qF -- "$2" <<<"$1"; }
lacks() { ! has "$@"; }

cmake --install "$build" --prefix "$place/first" >/dev/null
mv "$place/first" "$prefix"  # an installed program finds its own files, wherever it is

# ---- a program of another project, with its own loop ------------------------------------------------------

mkdir "$place/game"
cat >"$place/game/CMakeLists.txt" <<'CMAKE'
cmake_minimum_required(VERSION 3.25)
project(game LANGUAGES CXX)
find_package(oddity 0.1 REQUIRED)
add_executable(game game.cpp)
target_link_libraries(game PRIVATE oddity::models)
foreach(registers baseline avx2 avx512)
  add_executable(lanes_${registers} lanes.cpp)
  target_compile_options(lanes_${registers} PRIVATE -O2 -ffp-contract=off)
  target_link_libraries(lanes_${registers} PRIVATE oddity::models)
endforeach()
if(CMAKE_SYSTEM_PROCESSOR STREQUAL x86_64)
  target_compile_options(lanes_avx2 PRIVATE -march=haswell)
  target_compile_options(lanes_avx512 PRIVATE -march=skylake-avx512)
endif()
CMAKE
cat >"$place/game/game.cpp" <<'CPP'
#include <cstdio>

#include "chapters/03_rigid_body_motion/05_pendulum/models.hpp"

/// The time from 30 degrees to the lowest point, in units of sqrt(L/2g), by velocity Verlet.
int main() {
  const oddity::pendulum::OneAngle<double> pendulum{{std::numbers::pi / 6, 2, 1}};
  const double h = 1e-4;
  std::array<double, 1> q{pendulum.p.a}, a{};
  double v = 0, t = 0;
  for (pendulum.acceleration(q, a); q[0] > 0; t += h) {
    v += h / 2 * a[0];
    q[0] += h * v;
    pendulum.acceleration(q, a);
    v += h / 2 * a[0];
  }
  std::printf("%.6f\n", t - q[0] / v);
}
CPP
awk '/^```cpp$/ {text = ""; inside = 1; next} /^```$/ {if (inside && text ~ /oddity::Lanes/) print text; inside = 0} inside {text = text $0 "\n"}' \
  "$(dirname "${BASH_SOURCE[0]}")/../extras/lanes/README.md" >"$place/game/lanes.cpp"
cmake -S "$place/game" -B "$place/game/build" -DCMAKE_PREFIX_PATH="$prefix" >/dev/null
cmake --build "$place/game/build" >/dev/null
check "the models in another project's loop" test "$("$place/game/build/game")" = 2.260114
swung=$("$place/game/build/lanes_baseline")
check "ten thousand pendulums in lanes" test "$swung" = "0.4179 -0.4912"
for registers in avx2 avx512; do
  grep -qw "${registers/avx512/avx512vl}" /proc/cpuinfo || continue
  check "the same with $registers" test "$("$place/game/build/lanes_$registers")" = "$swung"
done
check "no header of a library in the models" lacks "$(grep -rh '#include <' "$prefix/include")" /
check "nothing of Catch2" test -z "$(find "$prefix" -iname '*catch*')"

# ---- the program ------------------------------------------------------------------------------------------

oddity=$prefix/bin/oddity
cd "$place"
check "its tables are the installed ones" has "$("$oddity" --help)" "$prefix/share/oddity/reference"
check "list" has "$("$oddity" list)" "3.5  Pendulum from 30 degrees"
check "solve, from its tables" has "$("$oddity" solve 3.5)" "(table 03_05_quarter_period.csv)"
check "a thousand bodies in lanes, from their library" has "$("$oddity" choose 3.5 --error 1deg --bodies 1000)" "side by side in lanes"
code=$prefix/lib/oddity
chmod g+w "$code"
check "a library where others can write is not loaded" has "$("$oddity" choose 3.5 --error 1deg --bodies 1000 2>&1)" "$code is not loaded or run"
chmod g-w "$code"
chmod o+w "$prefix/lib"
check "nor one whose folder others can exchange" has "$("$oddity" choose 3.5 --error 1deg --bodies 1000 2>&1)" "$prefix/lib is not loaded or run"
chmod +t "$prefix/lib"
check "but where the sticky bit forbids that" has "$("$oddity" choose 3.5 --error 1deg --bodies 1000)" "side by side in lanes"
chmod o-w,-t "$prefix/lib"
if [ "$(id -u)" -eq 0 ]; then
  chown 12345 "$code/liboddity_lanes.so"
  check "nor one of another user" has "$("$oddity" choose 3.5 --error 1deg --bodies 1000 2>&1)" "$code/liboddity_lanes.so is not loaded or run"
fi
rm "$code/liboddity_lanes.so"
printf 'no library\n' | tee "$prefix/liboddity_lanes.so" >"$prefix/bin/liboddity_lanes.so"
check "without it, one body as JSON" has "$("$oddity" choose 3.5 --error 1deg --json)" '"lanes": null'
check "without it, what is missing" has "$("$oddity" choose 3.5 --error 1deg --bodies 1000 2>&1)" "without its models in lanes: in a clone of oddity's sources './oddity' builds them"
[ ! -f "$build/models.js" ] || check "the page's models" cmp -s "$build/models.js" "$prefix/share/oddity/models.js"
[ ! -f "$build/own.js" ] || check "the page's reader of files" cmp -s "$build/own.js" "$prefix/share/oddity/own.js"
cp -r "$prefix/share/oddity/reference" "$place/others"
find "$place/others" -name 03_05_quarter_period.csv -delete
check "it asks others for theirs" has "$("$oddity" --reference "$place/others" solve 3.5 2>&1)" "$place/others/tables/03_05_quarter"
check "what it keeps is the user's" has "$("$oddity" chart --help)" "$HOME/.cache/oddity"

# ---- kept files belong to their user alone -----------------------------------------------------------------

# refused WHY COMMAND...: it ends with 2, and prints WHY.
refused() {
  local said code=0
  said=$("${@:2}" 2>&1) || code=$?
  [ "$code" -eq 2 ] && has "$said" "$1"
}
choose=("$oddity" choose 3.5 --error 1deg)
(umask 000; "${choose[@]}" >/dev/null)
check "its cache is private whatever the umask" test "$(stat -c %a "$HOME/.cache/oddity")" = 700
chmod o+w "$HOME/.cache/oddity"
check "a cache that others can write to is refused" refused "can be written by others" "${choose[@]}"
chmod o-w "$HOME/.cache/oddity"
mkdir "$place/elsewhere"
rm -r "$HOME/.cache/oddity/prices"
ln -s "$place/elsewhere" "$HOME/.cache/oddity/prices"
check "and one with a link in it" refused "is a link" "${choose[@]}"
check "through which nothing is written" test -z "$(ls "$place/elsewhere")"
rm "$HOME/.cache/oddity/prices"
mkfifo "$HOME/.cache/oddity/engines.json"
check "a pipe in it is not waited for" refused "it is not a regular file" timeout 60 "$oddity" engines 3.5 --kept
rm "$HOME/.cache/oddity/engines.json"
check "a list without a home and a place for temporary files" env -i TMPDIR=/nonexistent "$oddity" list 3.5 >/dev/null
check "a choice without a home" env -i TMPDIR="$place/elsewhere" "${choose[@]}" >/dev/null
check "of which nothing is kept" test -z "$(ls "$place/elsewhere")"
check "a report without a home" refused "--out names another" env -i "$oddity" report
(cd "$place/elsewhere" && HOME=home XDG_CACHE_HOME=cache "${choose[@]}" >/dev/null)
check "folders that are relative are none" test -z "$(ls "$place/elsewhere")"

# ---- without the tree, in whose place somebody has put other programs --------------------------------------

tree=$(dirname "$(dirname "$build")")
# hidden COMMAND...: runs it with the planted tree in the tree's place.
hidden() {
  unshare --mount ${rootless:+--map-root-user} sh -c 'mount --bind "$0" "$1" && shift && exec "$@"' "$place/planted" "$tree" "$@"
}
mkdir -p "$place/planted/extras/engines/adapters/node_modules" "$place/tools"
echo '{"planted.mjs": []}' >"$place/planted/extras/engines/adapters/variants.json"
touch "$place/planted/extras/engines/adapters/runner.mjs"
printf '#!/bin/sh\ntouch "%s/ran"\n' "$place" >"$place/tools/node"
chmod +x "$place/tools/node"
rootless=
hidden true 2>/dev/null || rootless=1
if hidden true 2>/dev/null; then
  # verb VERB STATUS ARGUMENTS...: it ends with this status, and does not mention the tree.
  verb() {
    local said code=0
    said=$(PATH=$place/tools:$PATH hidden "$oddity" "$1" "${@:3}" 2>&1) || code=$?
    check "$1 without the tree" test "$code" -eq "$2"
    check "of which it says nothing" lacks "$said" "$tree/"
    verbs_tried+=" $1"
  }
  verbs_tried=" help"
  results=$tree/build/results.json
  [ ! -f "$results" ] || cp -p "$results" "$HOME/.cache/oddity/results.json"
  verb list 0
  verb solve 0 3.5
  verb choose 0 3.5 --error 1deg
  verb choose 2 3.5 --error 1deg --engine bullet
  verb engines "$(ls "$prefix"/lib/oddity/engines/engine_* >/dev/null 2>&1 && echo 0 || echo 2)" 3.33 --hz 60
  verb verify 0 '[9.1]'
  verb stability 0 3.5 --out "$place/maps"
  verb chart 0 9.1 --out "$place/charts"
  verb sweep 0 plan "$place/sweep" 3.5 --model "one angle" --algorithm "Runge-Kutta 4" --over a=1deg..179deg:3 --over step=1ms..2.5s:3 --looks 4
  verb sweep 0 run "$place/sweep"
  verb new 2 40.2 comet
  verb new 0 40.2 comet --topic space --in "$place/own"
  verb report 0 --out "$place/report"
  verb site 0 --out "$place/site"
  verb trust 0
  verb bench 0 --help
  verb prove 0 --help
  source "$prefix/share/bash-completion/completions/oddity"
  for one in $(_oddity_words ""; echo "$verbs"); do check "$one was tried" has "$verbs_tried " " $one "; done
  check "nothing of it ran" test ! -e "$place/ran"
else
  echo "installed: no right to hide the tree; what the program does without it is not tried" >&2
fi

# ---- its manual and its completion ------------------------------------------------------------------------

source "$prefix/share/bash-completion/completions/oddity"
verbs=$(_oddity_words ""; echo "$verbs")
check "it has verbs" has "$verbs" solve
manual=$(cat "$prefix/share/man/man1/oddity.1")
for verb in ${verbs/help/}; do check "the manual on $verb" has "$manual" ".SS $verb"; done
check "the manual knows no folder of the build" lacks "$manual" "$(dirname "$(dirname "$build")")/"

# completed WORD...: the completions of the last word.
completed() {
  COMP_WORDS=(oddity "$@") COMP_CWORD=$# COMPREPLY=()
  _oddity
  echo "${COMPREPLY[*]}"
}
check "completion of a verb" test "$(completed so)" = solve
check "completion of an exercise" test "$(completed solve 3.2)" = "3.21 3.23 3.25 3.27 3.29"
check "completion of an option" test "$(completed choose --hor)" = --horizon
