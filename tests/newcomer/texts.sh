# Reads the steps that a text has its reader do: to be sourced. read_page FILE and read_help fill the arrays
wheres=()  # file and line
marks=()   # how the step should end, by the text's mark; tests/README.md explains it
words=()   # the command, or the text that a block replaces, or "into FILE"
shown=()   # the output in the text, or the block's lines
kinds=()   # run or fill

add() { kinds+=("$1") wheres+=("$2") marks+=("$3") words+=("$4") shown+=("${5:-}"); }

# add_command WHERE MARK COMMAND SHOWN: if the mark has an exit code for each of a block's commands, takes the
# next one.
add_command() {
  local mark=$2
  if [[ $2 =~ ^exit(\ [0-9]+){2,}$ ]]; then
    read -ra codes <<<"$2"
    mark="exit ${codes[++of_block]:-?}"
  fi
  add run "$1" "$mark" "$3" "$4"
}

# add_block WHERE MARK LANGUAGE LINES
add_block() {
  local line command='' output='' codes of_block=0
  case $3 in
    sh)
      while IFS= read -r line; do
        command+=$line
        [[ $line == *\\ ]] && { command=${command%\\}; continue; }
        add_command "$1" "$2" "$command" ''
        command=
      done <<<"$4"
      ;;
    '')  # a session: commands after a $, each with its output
      while IFS= read -r line; do
        if [[ $line == '$ '* ]]; then
          [ -z "$command" ] || add_command "$1" "$2" "$command" "$output"
          command=${line#'$ '} output=
        else
          output+=$line$'\n'
        fi
      done <<<"$4"
      [ -z "$command" ] || add_command "$1" "$2" "$command" "$output"
      ;;
    *)
      line=${4%%$'\n'*}
      if [[ $line == '// instead of '* ]]; then
        add fill "$1" '' "${line#// instead of }" "${4#*$'\n'}"
      elif [[ $2 == 'into '* ]]; then
        add fill "$1" '' "$2" "$4"
      fi
      ;;
  esac
}

# The pages of the rooms, in order: every README except the first page and those written by the program.
room_pages() { git ls-files -- '*README.md' | grep -v -x -e README.md -e 'report/book/.*'; }

# Reads the blocks of a page, and the table columns named "run".
read_page() {
  local line number=0 mark='' language block='' inside= column='' cells i from
  while IFS= read -r line; do
    ((++number))
    if [ -n "$inside" ]; then
      if [ "$line" = '```' ]; then
        add_block "$1:$from" "$mark" "$language" "${block%$'\n'}"
        inside= mark=
      else
        block+=$line$'\n'
      fi
    elif [[ $line == '```'* ]]; then
      inside=1 language=${line#'```'} block='' from=$number
    elif [[ $line =~ ^'<!-- run: '(.*)' -->'$ ]]; then
      mark=${BASH_REMATCH[1]}
    elif [[ $line == '|'* ]]; then
      IFS='|' read -ra cells <<<"$line"
      if [ -z "$column" ]; then
        column=none
        for i in "${!cells[@]}"; do [ "${cells[i]}" != ' run ' ] || column=$i; done
      elif [ "$column" != none ]; then
        add_cell "$1:$number" "${cells[column]}"
      fi
    else
      column= mark=
    fi
  done <"$1"
}

# add_cell WHERE CELL: the commands in it, and its mark.
add_cell() {
  local rest=$2 mark=
  if [[ $rest =~ '<!-- run: '(.*)' -->' ]]; then mark=${BASH_REMATCH[1]}; fi
  while [[ $rest =~ \`(\./oddity[^\`]*)\`(.*) ]]; do
    add run "$1" "$mark" "${BASH_REMATCH[1]}"
    rest=${BASH_REMATCH[2]}
  done
}

# Reads the examples of the program's help: one per line, each after its mark.
read_help() {
  local mark command
  while IFS=$'\t' read -r mark command; do add run --help "${mark#-}" "$command"; done
}
