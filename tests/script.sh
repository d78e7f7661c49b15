#!/usr/bin/env bash
# Tests the script ./oddity on other machines: its installations, builds and messages. Its tools are fakes
# that log their calls.
set -euo pipefail
tree=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
place=$(mktemp -d)
trap 'rm -rf "$place"' EXIT
cd "$place"

# pretend NAME <SCRIPT: a fake tool of that name, which logs its words.
pretend() {
  { echo '#!/bin/bash'; echo "echo \"$1 \$*\" >>$place/calls"; cat; } >"$place/bin/$1"
  chmod +x "$place/bin/$1"
}
# Resets the machine: a tree with nothing built, and tools.
machine() {
  rm -rf "$place"/*
  mkdir -p tree bin
  cp "$tree/oddity" "$tree/CMakePresets.json" tree/
  touch calls there
  for tool in bash cat cp dirname env find grep head mkdir nproc realpath rm sed sh sleep tail tee touch tr; do
    ln -s "$(command -v $tool)" bin/
  done
  pretend dpkg-query <<<"grep -qx \"\${@: -1}\" $place/there && echo 'install ok installed'"
  pretend apt-get <<<"[ ! -e $place/offline ] || { echo 'E: Unable to locate package cmake'; exit 100; }
                          for word; do case \$word in -*|*=*|update|install) ;; *) echo \$word >>$place/there ;; esac; done"
  pretend sudo <<<'exit 1'
  pretend npm <<<'mkdir -p "${@: -1}"'
  pretend id <<<"cat $place/uid"
  echo 0 >uid
  pretend cmake <<'CMAKE'
case $1 in
  --preset) mkdir -p build/release; echo "ODDITY_OWN:STRING=" >build/release/CMakeCache.txt
            echo "build models_module: phony" >build/release/build.ninja ;;
  --build) echo "[0/2] Re-checking globbed directories..."; [ ! -e ../slow ] || { echo "[57/141] Building CXX object a.o"; sleep 21; }
           [ ! -e ../broken ] || { echo "[1/2] Building CXX object a.o"; echo "a.cpp:3:1: error: no"; exit 1; }
           cp ../program "$2/oddity"; echo "ninja: no work to do." ;;
esac
CMAKE
  cat >program <<'PROGRAM'
#!/bin/bash
case "$*" in
  '--needs prove 9.99') echo "oddity: no exercise '9.99'" >&2; exit 2 ;;
  '--needs prove'*) echo package coq ;;
  '--needs' | '--needs site'*) printf 'package clang\ntarget models_module\n' ;;
  --needs*) ;;
  *) echo "answers $*" ;;
esac
PROGRAM
  chmod +x program
}
# oddity WORD...: the script, its words in `said`, its errors in `told`, how it ended in `ended`.
oddity() {
  : >calls
  ended=0
  (cd tree && PATH=$place/bin CI= ODDITY_OWN= ./oddity "$@") >said 2>told </dev/null || ended=$?
}
# check NAME COMMAND...
check() {
  "${@:2}" || { echo "script: $1: wrong"; head -n 20 said told calls; exit 1; } >&2
  echo "script: $1"
}
called() { grep -q -- "$1" calls; }
not() { ! "$@"; }
line() { [ "$(cat "$1")" = "$2" ]; }

machine
oddity solve 3.5
check "a fresh machine: packages are installed, and it answers" line said "answers solve 3.5"
check "with g++" grep -qx g++ there
check "and ends well" test $ended = 0

oddity solve 3.5
check "then a verb's output stands alone" test ! -s told
check "and nothing is installed again" not called apt-get

for words in "prove --help" "engines -h" "help sweep" "--version" "--completion"; do
  oddity $words
  check "$words is at once" line said "answers $words"
  check "$words calls nothing" test ! -s calls -a ! -s told
done
for words in "test --help" "watch -h" "package --help" "packages --help"; do
  oddity $words
  check "$words says what the script does" grep -q '^  ./oddity package ' said
  check "$words calls nothing" test ! -s calls
done
rm -r tree/build
oddity engines --help
check "help where nothing is built: only the plain build" line said "answers engines --help"
check "and no package but what builds" not called "npm\|libode"

oddity prove 9.99
check "bad arguments end with 2" test $ended = 2
check "in one sentence" line told "oddity: no exercise '9.99'"
check "before anything is installed" not called apt-get

oddity prove 3.5
check "good ones install what they need" grep -qx coq there
check "and are answered" line said "answers prove 3.5"

oddity
check "without a verb, what the whole site takes" grep -qx clang there
check "is installed and built" called "--target models_module"

for user in none sudo; do
  machine
  echo 1000 >uid
  [ $user = sudo ] || rm bin/sudo
  oddity list
  check "no root ($user): one sentence with the packages" grep -qx "oddity: only root can install what is missing: apt-get install g++ cmake .*" told
  check "and no other" test "$(wc -l <told)" = 1
  check "and 2" test $ended = 2
  tail -n 1 told | sed 's/.*apt-get install //' | tr ' ' '\n' >there
  oddity list
  check "works once they are there" line said "answers list"
  oddity prove 3.5
  check "what is not needed to build is left out" line said "answers prove 3.5"
  check "and said" grep -q "apt-get install coq" told
done

machine
touch offline
oddity list
check "no network: 2" test $ended = 2
check "and one sentence" grep -qx "oddity: what is missing could not be installed (Unable to locate package cmake): apt-get install g++ .*" told
check "after what was tried" test "$(wc -l <told)" = 2

machine
touch broken
oddity list
check "what does not compile is shown" grep -q "error: no" told
check "without ninja's lines" not grep -q '^\[' told
check "and ends red" test $ended != 0
rm broken

touch slow
oddity list
check "a build of more than 20 s says how far it is" grep -qx "oddity: building, 57 of 141, 0 min" told
check "and no more" not grep -q "\[" told
