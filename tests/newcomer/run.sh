#!/usr/bin/env bash
# Runs the commands in README.md, the help's examples, CONTRIBUTING.md and the rooms' READMEs, in order, where
# nothing else has run.
#   tests/newcomer/run.sh [SUITE]    of Debian: bookworm by default; SLOW=1 includes commands that take minutes.
# Each text begins with an unchanged tree, except its build, and with an empty /tmp. Output goes to
# `build/newcomer/SUITE/said`.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
source tests/newcomer/texts.sh
suite=${1:-bookworm}
place=tests/newcomer/place.sh
said=build/newcomer/$suite/said
passed=0 failed=0 skipped=0
engines_page=extras/engines/README.md

verdict() {  # VERDICT SECONDS PLACE COMMAND
  printf '%-7s %5d s  %-22s %s\n' "$@"
  printf '%s\t%s\t%s\n' "$1" "$2" "$4" >>"$said/seconds"
  case $1 in ok) ((++passed)) ;; RED) ((++failed)) ;; *) ((++skipped)) ;; esac
}

# ends_as MARK STATUS
ends_as() {
  local codes=0
  [[ $1 =~ (^|, )exit\ ([0-9]+( or [0-9]+)*) ]] && codes=${BASH_REMATCH[2]}
  [[ $1 == *'until interrupted'* ]] && codes='124 or 130'
  [[ " $codes " == *" $2 "* ]]
}

# run_step WHERE MARK COMMAND SHOWN
run_step() {
  local start=$SECONDS status=0 file anywhere= command=$3
  file=$said/$(printf '%03d' $((passed + failed + skipped)))
  case $2 in
    not,*) verdict "${2%%,*}" 0 "$1" "$3  (${2#not, })"; return ;;
    *slow*) [ -n "${SLOW:-}" ] || { verdict slow 0 "$1" "$3"; return; } ;;
    *'until interrupted'*) command="timeout --signal=INT 60 $command" ;;
  esac
  $place in "$suite" "$command" </dev/null >"$file.out" 2>"$file.err" || status=$?
  printf '%s' "$4" >"$file.shown"
  printf '%s  %s\n' "$1" "$3" >"$file.command"
  # Error messages are on the other stream, next to messages of a build.
  [ -s "$file.out" ] || { cp "$file.err" "$file.out"; anywhere=1; }
  if ! ends_as "$2" $status; then
    verdict RED $((SECONDS - start)) "$1" "$3"
    { echo "it ended with $status"; tail -n 20 "$file.err"; [ -n "$anywhere" ] || tail -n 40 "$file.out"; } >"$file.why"
    cat "$file.why"
  elif [[ -n $4 && $2 != *'output varies'* ]] && ! awk -v ANYWHERE=$anywhere -f tests/newcomer/shows.awk "$file.shown" "$file.out" >"$file.why"; then
    verdict RED $((SECONDS - start)) "$1" "$3"
    cat "$file.why"
  else
    verdict ok $((SECONDS - start)) "$1" "$3"
  fi
}

# fill_step PLACE TARGET BLOCK: puts the block at the target. "into FILE" means after the { of a .json, before
# the first call of the same function, or at the end.
fill_step() {
  local file files text at=
  if [[ $2 == 'into '* ]]; then
    file=$tree/${2#into }
    case $file in
      *.json) at=1 ;;
      *.cmake) at=$(($(grep -n -m 1 "^${3%%(*}(" "$file" | cut -d: -f1) - 1)) ;;
    esac
    if [[ -n $at && -e $file ]]; then
      sed -i "${at}r /dev/stdin" "$file" <<<"$3"
    else
      printf '%s\n' "$3" >>"$file"
    fi
  else
    mapfile -t files < <(cd "$tree" && git ls-files --others --exclude-standard -z | xargs -0 -r grep -lF -- "$2")
    [ ${#files[@]} -gt 0 ] || { verdict RED 0 "$1" "no file that was begun has: $2"; return; }
    for file in "${files[@]}"; do
      text=$(cat "$tree/$file")
      printf '%s\n' "${text//"$2"/"$3"}" >"$tree/$file"
    done
  fi
}

# read_on TITLE: runs the steps read, in the unchanged tree.
read_on() {
  local i
  [ ${#kinds[@]} -gt 0 ] || { verdict RED 0 "$1" 'it has no commands'; return; }
  $place afresh "$suite"
  for i in "${!kinds[@]}"; do
    case ${kinds[i]} in
      run) run_step "${wheres[i]}" "${marks[i]}" "${words[i]}" "${shown[i]}" ;;
      fill) fill_step "${wheres[i]}" "${words[i]}" "${shown[i]}" ;;
    esac
  done
  kinds=() wheres=() marks=() words=() shown=()
}

$place make "$suite"
tree=$($place tree "$suite")
rm -rf "$said"
mkdir -p "$said"
chroot=
[[ $tree != */root/* ]] || chroot=1

# A user without root and sudo, before anything is installed.
[ -z "$chroot" ] || run_step 'no root' 'exit 2' 'su reader -c "./oddity list"' 'only root can install'

read_page README.md
read_on README.md
read_page cmake/README.md  # installs the program, whose help is read next
read_on cmake/README.md
read_help < <($place in "$suite" 'oddity --examples')
read_on --help
mapfile -t pages < <(room_pages | grep -v -x -e cmake/README.md -e $engines_page)
for page in "${pages[@]}"; do
  read_page "$page"
  [ ${#kinds[@]} -eq 0 ] || read_on "$page"
done
read_page CONTRIBUTING.md
read_page $engines_page  # its scene for engines is the spring of CONTRIBUTING.md
read_on CONTRIBUTING.md

# That user again, once everything is installed.
$place afresh "$suite"
if [ -n "$chroot" ]; then
  run_step 'no root' '' 'chown -R reader . && su reader -c "./oddity solve 3.5 && ./oddity verify [3.5]"' ''
  $place in "$suite" 'chown -R root .'
fi

# Repeated at the end, for those who read only the last lines.
for why in "$said"/*.why; do
  [ -s "$why" ] || continue
  echo "newcomer: red: $(cat "${why%.why}.command")"
  cat "$why"
done
echo "newcomer: $passed passed, $failed failed, $skipped skipped"
[ $failed -eq 0 ]
