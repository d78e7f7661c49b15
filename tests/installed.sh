#!/usr/bin/env bash
# Installs a build into a folder of its own, and checks what is there, as another project and a user find it.
#   tests/installed.sh BUILD
set -euo pipefail
build=$(realpath "${1:?the build to install}")
place=$(mktemp -d)
trap 'rm -rf "$place"' EXIT
prefix=$place/moved
export HOME=$place/home
unset XDG_CACHE_HOME

# check WHAT COMMAND...
check() {
  "${@:2}" || { echo "installed: $1: wrong" >&2; exit 1; }
  echo "installed: $1"
}
has() { grep -qF -- "$2" <<<"$1"; }
lacks() { ! has "$@"; }

cmake --install "$build" --prefix "$place/first" >/dev/null
mv "$place/first" "$prefix"  # what is installed finds its own, wherever it is

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
  "$(dirname "${BASH_SOURCE[0]}")/../README.md" >"$place/game/lanes.cpp"
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
rm "$prefix/bin/liboddity_lanes.so"
check "without it, what is missing" has "$("$oddity" choose 3.5 --error 1deg --bodies 1000 2>&1)" "without its models in lanes"
[ ! -f "$build/models.js" ] || check "the page's models" cmp -s "$build/models.js" "$prefix/share/oddity/models.js"
cp -r "$prefix/share/oddity/reference" "$place/others"
find "$place/others" -name 03_05_quarter_period.csv -delete
check "it asks others for theirs" has "$("$oddity" --reference "$place/others" solve 3.5 2>&1)" "$place/others/tables/03_05_quarter"
check "what it keeps is the user's" has "$("$oddity" chart --help)" "$HOME/.cache/oddity"

# ---- its manual and its completion ------------------------------------------------------------------------

verbs=$("$oddity" --help | sed -n '/^Verbs:/,/^$/s/^  \([a-z][a-z]*\) .*/\1/p')
check "it has verbs" has "$verbs" solve
manual=$(cat "$prefix/share/man/man1/oddity.1")
for verb in ${verbs/help/}; do check "the manual on $verb" has "$manual" ".SS $verb"; done
check "the manual knows no folder of the build" lacks "$manual" "$(dirname "$(dirname "$build")")/"

source "$prefix/share/bash-completion/completions/oddity"
# completed WORD...: what the last word may become.
completed() {
  COMP_WORDS=("$oddity" "$@") COMP_CWORD=$# COMPREPLY=()
  _oddity
  echo "${COMPREPLY[*]}"
}
check "completion of a verb" test "$(completed so)" = solve
check "completion of an exercise" test "$(completed solve 3.2)" = "3.21 3.23 3.25 3.27 3.29"
check "completion of an option" test "$(completed choose --hor)" = --horizon
