# awk -f shows.awk SHOWN PRINTED: whether what was printed is what the text shows of it; else the first words that are not.
# Words count, not the spaces between them; "..." stands for anything. Times are left out, with what is computed from
# them, and so is how small an error of rounding is.

function is_number(word) { return word ~ /^[(]?[0-9][0-9.,]*(e[-+]?[0-9]+)?$/ }
function ends(word) { return match(word, /[.,;:)]+$/) ? substr(word, RSTART) : "" }

# The words of a file, one space between them.
function words_of(file,    line, n, word, i, text, next_word) {
  n = 0
  while ((getline line < file) > 0) {
    split(line, parts, /[ \t]+/)
    for (i = 1; i in parts; ++i) if (parts[i] != "") word[++n] = parts[i]
  }
  text = ""
  for (i = 1; i <= n; ++i) {
    next_word = i < n ? word[i + 1] : ""
    if (is_number(word[i]) && next_word ~ /^(ns|us|ms|s|minutes?|seconds?)[.,;:)]*$/) {
      ++i
      sub(/TIME $/, "", text)
      text = text "TIME" ends(next_word) " "
    } else if (is_number(word[i]) && (next_word " " word[i + 2] " " word[i + 3] " " word[i + 4]) ~ /^(% of the budget|times the cost|chunks)/) {
      text = text "SHARE "
    } else if (word[i] ~ /^[(]?[0-9][0-9.]*e[-+][1-9][0-9][.,;:)]*$/) {
      text = text "ROUNDING" ends(word[i]) " "
    } else {
      text = text word[i] " "
    }
  }
  return text
}

# What of a piece is not in the rest, from a few words before on.
function from_difference(text, at_start,    n, i, same, words) {
  n = split(text, words, / /)
  same = ""
  for (i = 1; i < n && (at_start ? index(rest, same words[i]) == 1 : index(rest, same words[i])); ++i) same = same words[i] " "
  return substr(text, length(same) > 60 ? length(same) - 60 : 1, 240)
}

BEGIN {
  shown = words_of(ARGV[1])
  rest = words_of(ARGV[2])
  pieces = split(shown, piece, /[.][.][.]/)
  for (i = 1; i <= pieces; ++i) {
    sub(/^ /, "", piece[i])
    if (i < pieces) sub(/ $/, "", piece[i])
    if (piece[i] == "") continue
    at = index(rest, piece[i])
    if (at == 0 || (i == 1 && at != 1 && !ANYWHERE)) {
      print "the text shows, and it did not print: " from_difference(piece[i], i == 1 && !ANYWHERE)
      exit 1
    }
    rest = substr(rest, at + length(piece[i]))
  }
  if (piece[pieces] != "" && rest != "" && !ANYWHERE) {
    print "it prints more than the text shows: " substr(rest, 1, 300)
    exit 1
  }
}
