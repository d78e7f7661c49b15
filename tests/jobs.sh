#!/usr/bin/env bash
# CI jobs, by name, one or several:
#   tests/jobs.sh NAME ...      runs these, shows how long each took, and ends with 1 if one is red.
#   tests/jobs.sh               shows the names.
# LAST_BEGINS=MINUTES: a job that would begin later is reported as not run. On Debian each job installs its
# packages. A job that builds has its own folder under build/. Warnings are errors.
set -euo pipefail
export CI=${CI:-true}
cd "$(dirname "${BASH_SOURCE[0]}")/.."
jobs=${JOBS:-$(nproc)}

# build PRESET TARGET...
build() {
  cmake --preset "$1" >/dev/null
  cmake --build "build/$1" --parallel "$jobs" --target "${@:2}"
}

# If a tool of a job cannot be installed, for example offline, the job is reported as not run.
tools() { ./oddity packages "$@" || { echo "not run: $* cannot be installed"; exit 77; }; }

sources() { git ls-files -- "$@"; }

# on_record FILE <ROWS: replaces the rows of the same subjects (the first cell) by these, preceded by date and
# commit.
on_record() {
  local head rows
  rows=$(sed "s/^/$(date -u +%F),$(git rev-parse --short HEAD),/")
  [ -n "$rows" ] || return 0
  head=$(head -n 1 "$1")
  { echo "$head"; { echo "$rows"; tail -n +2 "$1"; } | awk -F, -v rows="$(cut -d, -f3 <<<"$rows")" '
      BEGIN { for (n = split(rows, names, "\n"); n > 0; --n) fresh[names[n]] }
      NR <= split(rows, names, "\n") || !($3 in fresh)' | sort -t, -k3,3 -s; } >"$1.part"
  mv "$1.part" "$1"
}

# ---- jobs -------------------------------------------------------------------------------------------------

job_newcomer() {  # the commands of README.md, of the help's examples, of CONTRIBUTING.md and of the rooms' READMEs, in a bare Debian 12. SUITE=trixie for 13; SLOW=1 for those that take minutes; RECORD=1 records the README's times
  local suite=${SUITE:-bookworm} processor
  tests/newcomer/run.sh "$suite"
  [ -n "${RECORD:-}" ] || return 0
  processor=$(sed -n 's/^model name.*: //p' /proc/cpuinfo | head -n 1)
  awk -F '\t' -v OFS=, -v on="$suite,$(nproc),$processor" '
      { sub(/ *#.*/, "", $3) }
      $1 == "ok" && $3 ~ /^[.]\/oddity( test| verify .\[3[.]5\].)?$/ && !seen[$3]++ { print $3 " on " on, $2 }' \
    "build/newcomer/$suite/said/seconds" | on_record tests/newcomer/record.csv
}

job_tests() {  # g++: all tests
  ./oddity test
}

job_report() {  # g++: verifies everything, and writes the report and the site
  ./oddity
}

job_book() {  # g++: report/book is this machine's output, byte for byte
  ./oddity report >/dev/null
  ctest --test-dir build/release --build-config book --tests-regex '^book$' --output-on-failure
}

job_format() {  # clang-format: every source follows .clang-format
  tools clang-format
  sources '*.cpp' '*.hpp' | xargs -d '\n' clang-format --dry-run -Werror
}

job_prose() {  # comments, texts and pages: their wording, their spelling, and the length of commits' subjects
  tools g++ codespell
  mkdir -p build
  g++ -std=c++20 -O1 -I. tests/prose/prose.cpp tests/prose/main.cpp -o build/prose
  git ls-files | build/prose .
  sources '*.md' '*.cpp' '*.hpp' '*.js' '*.mjs' '*.sh' '*.cmake' | grep -v ^report/book/ |
    xargs -d '\n' codespell --quiet-level 3 --ignore-words tests/prose/spelling.txt
  ! git log -30 --no-merges --format=%s | grep -E '.{73}' || { echo "these subjects are longer than 72 letters"; return 1; }
}

job_site() {  # chromium: every page and player of the site, opened from their files
  tools chromium
  command -v npm >/dev/null || tools nodejs npm
  npm ci --prefix tests/site --no-audit --no-fund || exit 77
  ./oddity site
  build release oddity_tests
  build/release/tests/oddity_tests 'the site of the last run*'
  printf '%s\n' tests/site/*.test.mjs | xargs -P "$jobs" -n 1 node --test
}

job_languages() {  # mono, node: the programs of choose --code in C# and JavaScript have the program's numbers
  tools mono-mcs mono-runtime nodejs
  build release oddity_tests
  build/release/tests/oddity_tests '[languages]'
}

job_engines() {  # third-party engines on the scenes match the approved records
  ./oddity engines --finest 1 3.5 >/dev/null  # installs and builds them
  ctest --test-dir build/release --build-config engines --tests-regex '^engines$' --output-on-failure
}

job_witness() {  # PARI/GP's results on the errata match the approved records
  tools pari-gp
  tests/witness.sh
}

job_sweep() {  # sweeps with HDF5 and under mpirun, and killed ODDITY_KILLS (100) times
  ./oddity packages libhdf5-dev libopenmpi-dev openmpi-bin || exit 77
  cmake --preset release -DODDITY_HDF5=ON -DODDITY_MPI=ON >/dev/null
  cmake --build build/release --parallel "$jobs" --target oddity_tests
  ODDITY_KILLS=${ODDITY_KILLS:-100} build/release/tests/oddity_tests '[sweep]'
}

job_namespaces() {  # a sweep by Open MPI on four network namespaces, the same as by one thread, also where a rank is killed
  tools iproute2 libopenmpi-dev openmpi-bin
  cmake --preset release -DODDITY_MPI=ON >/dev/null
  cmake --build build/release --parallel "$jobs" --target oddity
  extras/sweep/namespaces.sh build/release/oddity
}

job_slurm() {  # a sweep by its array script for Slurm, whose daemons are started for it, killed on the way
  tools munge slurmctld slurmd slurm-client
  ./oddity list >/dev/null
  extras/sweep/slurm.sh build/release/oddity
}

job_ode-files() {  # xppaut: its package's examples are answered or refused, and each motion is compared with xppaut's
  tools xppaut
  build release oddity
  tests/ode_files.sh build/release/oddity
}

job_thorough() {  # limits of stability by scans of all steps are the approved ones, as verify finds them by a few
  build release oddity
  build/release/oddity verify --thorough '[scene]'
}

job_prove() {  # Coq: every recorded proof, checked again, and every .v file alone
  tools coq libcoq-interval libcoq-coquelicot
  local file copy
  copy=$(mktemp -d)
  git ls-files '*.v' | tar -cT - | tar -xC "$copy"
  for file in $(git ls-files '*.v'); do
    (cd "$copy/${file%/*}" && coqc -q "${file##*/}") || { echo "coqc refuses $file"; exit 1; }
  done
  rm -r "$copy"
  ./oddity prove
}

job_syntax() {  # g++: every source alone, without precompiled headers; compile_commands.json has all of them
  ./oddity packages
  build developer generated_sources
  local listed missing
  listed=$(sed -n 's|^ *"file": "'"$PWD"'/\(.*\)".*|\1|p' build/developer/compile_commands.json | sort -u)
  # except those of the page's module, which another compiler makes, and of engines, libclang, MPI and Arb,
  # which may be missing
  missing=$(comm -23 <(sources '*.cpp' ':!report/site/module/*' ':!tests/site/nudged.cpp' ':!extras/engines/adapters/*' ':!extras/mutation/*' ':!extras/sweep/mpi/*' ':!reference/enclosures/*' ':!tests/enclosed_motions.cpp' | sort) <(echo "$listed"))
  [ -z "$missing" ] || { echo "not in compile_commands.json: $missing"; return 1; }
  sed -n 's|^ *"command": "\(.*\)",$|\1|p' build/developer/compile_commands.json | sed 's|\\"|"|g; s|\\\\|\\|g' |
    (cd build/developer && xargs -d '\n' -P "$jobs" -n 1 bash -c 'eval "$0 -fsyntax-only"')
}

job_tidy() {  # clang-tidy: the solvers and the tables are clean, except Arb's part; TIDY='files' selects others
  tools clang-tidy
  cmake --preset developer >/dev/null
  # without g++'s flags that clang does not know
  mkdir -p build/tidy
  sed 's/ -fno-toplevel-reorder//' build/developer/compile_commands.json >build/tidy/compile_commands.json
  sources ${TIDY:-'formula/*.cpp' 'solvers/*.cpp' 'reference/*.cpp' ':!reference/make/*' ':!reference/enclosures/*'} |
    xargs -d '\n' -P "$jobs" -n 1 clang-tidy --quiet --warnings-as-errors='*' -p build/tidy \
      --extra-arg=-Wno-unknown-warning-option --extra-arg=-Wno-unused-command-line-argument
}

job_libcxx() {  # clang with libc++, without exceptions: every scene's models
  tools clang libc++-dev libc++abi-dev
  tests/models_with_libcxx.sh
}

job_install() {  # an installed build works, a program of another project finds the models, and a package installs on a bare Debian
  ./oddity packages debootstrap || true
  rm -f build/oddity_*.deb
  ./oddity package
  tests/installed.sh build/release
  tests/packaged.sh build/oddity_*.deb
}

job_clang() {  # clang: the tests, except the tables made again and the page's module
  tools clang
  build clang all
  ctest --test-dir build/clang --output-on-failure --parallel "$jobs" --exclude-regex tables_made_again
}

job_sanitize() {  # address and undefined-behaviour sanitizers: the suite
  ./oddity packages
  build sanitize oddity
  build/sanitize/oddity verify ${SUITE:+"$SUITE"}
}

job_thread() {  # thread sanitizer: a part of the suite in parallel, and choices that throw (ODDITY_THROWS, 6, in each scene)
  ./oddity packages
  build thread oddity oddity_stops
  TSAN_OPTIONS=halt_on_error=1 build/thread/oddity verify "${SUITE:-[3.5],[3.1],[2.13],[7.1]}"
  TSAN_OPTIONS=halt_on_error=1 ODDITY_THROWS=${ODDITY_THROWS:-6} build/thread/tests/oddity_stops '[stop]'
}

job_mutate() {  # libclang: mutants of a chapter, drawn by the commit's name; the suite has to notice as many as recorded; SAMPLE (300), MINUTES (12), PATHS
  ./oddity packages libclang-dev || exit 77
  build release oddity_mutate
  local recorded chapter
  mapfile -t recorded < <(sed -n 's/^[^#,]*,[^,]*,\(chapters\/[^,]*\),.*/\1/p' reference/trust/mutation.csv)
  chapter=${recorded[0x$(git rev-parse --short=6 HEAD | cut -c1-6) % ${#recorded[@]}]}
  build/release/extras/oddity_mutate --sample "${SAMPLE:-300}" --minutes "${MINUTES:-12}" ${PATHS:-$chapter}
}

# read_on_record READER INPUTS SECONDS: adds them to the record if RECORD is set. A crash would have ended the
# job before.
read_on_record() {
  [ -z "${RECORD:-}" ] || awk -F, -v name="$1" -v inputs="$2" -v seconds="$3" '
      $3 == name { inputs += $4; seconds += $5 }
      END { printf "%s,%d,%d,0\n", name, inputs, seconds }' reference/trust/fuzz.csv | on_record reference/trust/fuzz.csv
}

job_fuzz() {  # libFuzzer, and our own fuzzer of links: every reader (FUZZ) for FUZZ_SECONDS (60), or with FUZZ_INPUTS, with sanitizers, from the inputs in extras/fuzz/corpus. RECORD=1 adds these to the record
  tools clang
  build release fuzz
  local target name found inputs seconds longest ran=0 until=-max_total_time=${FUZZ_SECONDS:-60}
  [ -z "${FUZZ_INPUTS:-}" ] || until=-runs=$FUZZ_INPUTS
  found=$(mktemp -d)
  for target in build/release/extras/fuzz_*; do
    name=${target##*fuzz_}
    [[ ${FUZZ:-$name} == *$name* ]] || continue
    ran=$((ran + 1))
    mkdir -p "$found/$name"
    seconds=$SECONDS
    longest=4096
    case $name in words | quantity) longest=256 ;; esac  # typed by users
    # Without stacks of allocations, with a small quarantine of freed memory, and without weighing inputs by
    # the rarity of their paths: several times as many inputs.
    ASAN_OPTIONS=malloc_context_size=0:quarantine_size_mb=1 "$target" $until -max_len=$longest -entropic=0 -timeout=60 -rss_limit_mb=1024 -print_final_stats=1 -verbosity=0 \
      -artifact_prefix="build/fuzz_$name-" "$found/$name" "extras/fuzz/corpus/$name" 2>&1 | tee "$found/said"
    inputs=$(sed -n 's/^stat::number_of_executed_units: *//p' "$found/said")
    read_on_record "$name" "$inputs" $((SECONDS - seconds))
  done
  rm -r "$found"
  if [[ ${FUZZ:-links} != *links* ]]; then
    [ $ran -gt 0 ] || { echo "no reader is called $FUZZ"; return 2; }
    return
  fi
  tools nodejs
  seconds=$SECONDS
  inputs=${FUZZ_INPUTS:-$((10000 * ${FUZZ_SECONDS:-60}))}  # to a player, and as many to the chooser
  FUZZ_LINKS=$inputs node --test tests/site/links.test.mjs
  read_on_record links $((2 * inputs)) $((SECONDS - seconds))
}

job_faults() {  # kills, full disks, too little memory and more, at every command that writes (FAULTS); ODDITY_KILLS (20); RECORD=1
  build release oddity_faults
  local table ended=0
  table=$(mktemp)
  ODDITY_FAULTS_TABLE=$table build/release/extras/oddity_faults ${FAULTS:+"$FAULTS"} || ended=$?
  [ -z "${RECORD:-}" ] || tail -n +2 "$table" | tr -d '"' | on_record reference/trust/faults.csv
  rm "$table"
  return $ended
}

job_properties() {  # properties of all parameters, at ODDITY_SETS (1000) random ones of every scene
  build release oddity_tests
  ODDITY_SETS=${ODDITY_SETS:-1000} build/release/tests/oddity_tests '[properties]'
}

job_choices() {  # choose: usual answers to ODDITY_NEEDS (200) random needs and eight of chaos, compared with thorough ones, in a quarter of an hour; RECORD=1
  build release oddity_tests
  local table
  table=$(mktemp)
  echo number,asked,usually,thoroughly,verdict,usual_ns,thorough_ns,usual_cpu_s,thorough_cpu_s >"$table"
  ODDITY_CHOICES_TABLE=$table build/release/tests/oddity_tests '[choices]'
  grep -oE ',(same|another that costs no more|worse),' "$table" | sort | uniq -c
  [ -z "${RECORD:-}" ] || cp "$table" tests/choices.csv
  rm "$table"
}

job_questions() {  # choose: QUESTIONS (100) random questions of SECONDS_EACH (3) seconds by SEED (48), and those once answered falsely, judged by a separate program
  build release oddity oddity_lanes oddity_questions
  local judge=build/release/tests/oddity_questions false=0
  "$judge" tables reference/tables
  "$judge" record build/release/oddity tests/questions/once_false.txt || false=1
  "$judge" ask build/release/oddity "${QUESTIONS:-100}" "${SEED:-48}" "${SECONDS_EACH:-3}" || false=1
  return $false
}

job_lockstep() {  # choose --lockstep: its programs by g++ and clang, for x86-64 with and without FMA, WebAssembly, arm64 and i386, have the same bits; SCENES for a part
  tools clang lld nodejs wasi-libc libc++-dev-wasm32 libclang-rt-dev-wasm32 g++-aarch64-linux-gnu g++-i686-linux-gnu qemu-user
  build release oddity
  # shellcheck disable=SC2086
  tests/lockstep.sh build/release/oddity ${SCENES:-}
}

job_same() {  # one thread and another order: the same bits; functions with other rounding errors, and programs of the presets in BUILDS: a green suite, and differences listed; SUITE for a part
  build release oddity oddity_same shaken_libm
  local same=build/release/extras/oddity_same found seed preset
  found=$(mktemp -d)
  # results NAME COMMAND...: results of the command's suite
  results() { "${@:2}" verify ${SUITE:+"$SUITE"} --results "$found/$1.json" >"$found/suite" || { cat "$found/suite"; return 1; }; }
  beside_usual() {
    local ended=0
    "$same" "$found/usual.json" "$found/$1.json" >"$found/rows" || ended=$?
    grep -v ',value,' "$found/rows" || true
    return $ended
  }
  results usual build/release/oddity
  results one_thread taskset -c 0 build/release/oddity
  "$same" --bits "$found/usual.json" "$found/one_thread.json"
  build/release/oddity verify ${SUITE:+"$SUITE"} --order rand --rng-seed 7 --results "$found/shuffled.json" >/dev/null
  "$same" --bits "$found/usual.json" "$found/shuffled.json"
  for seed in 1 2 3; do
    results shaken env LD_PRELOAD="$PWD/build/release/extras/libshaken_libm.so" ODDITY_SEED=$seed build/release/oddity
    beside_usual shaken
  done
  # glibc's variants of its functions for a processor without AVX and FMA
  results without_fma env GLIBC_TUNABLES=glibc.cpu.hwcaps=-AVX512F,-AVX2,-AVX,-FMA,-FMA4 build/release/oddity
  beside_usual without_fma
  for preset in ${BUILDS:-}; do
    build "$preset" oddity
    results "$preset" "build/$preset/oddity"
    echo "beside $preset:"
    beside_usual "$preset"
  done
  rm -r "$found"
}

job_odr() {  # link-time optimization: no name has two definitions in the program
  ./oddity packages
  build odr oddity oddity_lanes
}

job_turn() {  # one of the long jobs, by the commit's name
  local long=(thread odr witness clang tidy syntax sanitize fuzz) name
  name=${long[0x$(git rev-parse --short=6 HEAD | cut -c1-6) % ${#long[@]}]}
  echo "it is the turn of $name"
  "job_$name"
}

# -----------------------------------------------------------------------------------------------------------

if [ $# -eq 0 ]; then
  sed -n 's/^job_\([a-z-]*\)() {  # \(.*\)$/\1: \2/p' "${BASH_SOURCE[0]}"
  exit
fi
for name in "$@"; do
  declare -F "job_$name" >/dev/null || { echo "jobs.sh: there is no job $name; without a name it shows them" >&2; exit 2; }
done
took=()
passed=0 failed=0 skipped=0
for name in "$@"; do
  echo "== $name"
  start=$SECONDS
  ended=0
  if [ $((SECONDS / 60)) -ge "${LAST_BEGINS:-999999}" ]; then
    echo "not run: after $LAST_BEGINS minutes no job begins"
    ended=77
  fi
  # Runs in a separate shell, so that its first failure ends the job.
  [ $ended -ne 0 ] || JOBS=$jobs bash -c 'set -euo pipefail; '"$(declare -p jobs; declare -f)"'; job_'"$name" || ended=$?
  case $ended in
    0) verdict=green passed=$((passed + 1)) ;;
    77) verdict='not run' skipped=$((skipped + 1)) ;;
    *) verdict=RED failed=$((failed + 1)) ;;
  esac
  took+=("$(printf '%-10s %-7s %4d s' "$name" "$verdict" $((SECONDS - start)))")
done
printf '%s\n' "== jobs" "${took[@]}" "$passed passed, $failed failed, $skipped skipped"
[ $failed -eq 0 ]
