#!/usr/bin/env bash
# Checks how the job newcomer reads a text, and that it notices output that differs from the text.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
source tests/newcomer/texts.sh
place=$(mktemp -d)
trap 'rm -rf "$place"' EXIT

# same NAME EXPECTED ACTUAL
same() {
  [ "$2" = "$3" ] || { printf 'newcomer: %s: wrong\nexpected: %s\nread:     %s\n' "$@" >&2; exit 1; }
  echo "newcomer: $1"
}
read_steps() {
  local i
  kinds=() wheres=() marks=() words=() shown=()
  read_page "$1"
  for i in "${!kinds[@]}"; do echo "${kinds[i]}|${wheres[i]##*:}|${marks[i]}|${words[i]}|${shown[i]//$'\n'/;}"; done
}

cat >"$place/page.md" <<'PAGE'
`./oddity prose` is none.

<!-- run: exit 0 0 1 -->
```sh
./oddity one   # first
./oddity two \
  three
./oddity four
```

```
$ ./oddity shown
a

b
$ ./oddity next
```

| you want to | run |
| --- | --- |
| see | `./oddity list`, `'[3.5]'`, `./oddity all` |
| wait | `./oddity bench` <!-- run: slow --> |

| option | says |
| --- | --- |
| x | `./oddity none` |

<!-- run: exit 2 -->

```sh
./oddity apart
```

```cpp
// instead of hole()
whole(
```

<!-- run: into some/file.cpp -->
```cpp
int i;
```

```cpp
int none;
```
PAGE
same 'the steps of a page' "run|4|exit 0|./oddity one   # first|
run|4|exit 0|./oddity two   three|
run|4|exit 1|./oddity four|
run|11||./oddity shown|a;;b;
run|11||./oddity next|
run|21||./oddity list|
run|21||./oddity all|
run|22|slow|./oddity bench|
run|30||./oddity apart|
fill|34||hole()|whole(
fill|40||into some/file.cpp|int i;" "$(read_steps "$place/page.md")"

# The marks in the pages of the tree are known, and each is before a block.
for page in README.md CONTRIBUTING.md $(room_pages); do
  kinds=() wheres=() marks=() words=() shown=()
  read_page "$page"
  for mark in "${marks[@]}"; do
    [[ $mark =~ ^((slow|output\ varies|until\ interrupted|exit\ [0-9]+(\ or\ [0-9]+)*)(,\ |$))*$|^not,\ . ]] ||
      { echo "newcomer: $page has an unknown mark: $mark" >&2; exit 1; }
  done
  same "marks of $page" '' "$(awk '
    /^```/ { inside = !inside; mark = "" }
    inside || /^$/ { next }
    mark { print mark; mark = "" }
    /^<!-- run: / { mark = $0 }
    END { if (mark) print mark }' "$page")"
done

# differs SHOWN PRINTED [ANYWHERE]: prints "yes" or "no".
differs() {
  printf '%s\n' "$1" >"$place/shown"
  printf '%s\n' "$2" >"$place/printed"
  awk -v ANYWHERE="${3:-}" -f tests/newcomer/shows.awk "$place/shown" "$place/printed" >/dev/null && echo no || echo yes
}
same 'the same' no "$(differs 'a b' 'a  b')"
same 'another word' yes "$(differs 'a b' 'a c')"
same 'another number' yes "$(differs 'an error of 0.24 deg' 'an error of 0.25 deg')"
same 'more before' yes "$(differs 'a b' 'x a b')"
same 'more behind' yes "$(differs 'a b' 'a b x')"
same 'more around, left out' no "$(differs '... a b ...' 'x a b x')"
same 'more around, anywhere' no "$(differs 'a b' 'x a b x' 1)"
same 'the rest left out, another order' yes "$(differs '... b ... a ...' 'a b')"
same 'another time' no "$(differs 'All results match the approved records, after 1 minute.' 'All results match the approved records, after 2 minutes 3 seconds.')"
same 'what is computed from times' no "$(differs '23.5 ns per frame, 0.47 % of the budget: 1.8 times the cost, 2 chunks' '2 us per frame, 4 % of the budget: 9 times the cost, 4 chunks')"
same 'rounding of another size' no "$(differs 'error 4.4e-16' 'error 2.2e-15')"
same 'rounding that is none' yes "$(differs 'error 4.4e-16' 'error 4.4e-06')"
