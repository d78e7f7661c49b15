# Completion of oddity's verbs, exercises and options. It asks the program, so that it knows what the program does.
_oddity() {
  local program=${COMP_WORDS[0]} word=${COMP_WORDS[COMP_CWORD]} verb= i
  for ((i = 1; i < COMP_CWORD; i++)); do
    [[ ${COMP_WORDS[i]} == [a-z]* ]] && { verb=${COMP_WORDS[i]}; break; }
  done
  local words
  if [[ $word == -* ]]; then
    words=$("$program" $verb --help 2>/dev/null | grep -oE '(^ +|,)--?[a-z][a-z-]*' | tr -d ' ,')
  elif [[ -z $verb || $verb == help ]]; then
    words=$("$program" --help 2>/dev/null | sed -n '/^Verbs:/,/^$/s/^  \([a-z][a-z]*\) .*/\1/p')
  else
    words=$("$program" list --csv 2>/dev/null | sed -n '2,$s/,.*//p' | sort -u)
  fi
  COMPREPLY=($(compgen -W "$words" -- "$word"))
  [ ${#COMPREPLY[@]} -gt 0 ] || COMPREPLY=($(compgen -f -- "$word"))
}
complete -F _oddity oddity
