#!/usr/bin/env bash
# by_clang.sh CLANG COMPILER ARGUMENT...: compiles by clang with libFuzzer and sanitizers instead
set -euo pipefail
arguments=()
for one in "${@:3}"; do
  case $one in
    -Wl,*) arguments+=("$one") ;;
    --param=* | -fpch-preprocess | -fno-tree-* | -W[a-z]*) ;;  # options that clang does not know or
                                                               # interprets otherwise
    *) arguments+=("$one") ;;
  esac
done
sanitizers=address,undefined,float-cast-overflow
main=-fsanitize=fuzzer-no-link
case " $* " in *" -c "*) ;; *) main=-fsanitize=fuzzer ;; esac
exec "$1" "${arguments[@]}" -w -O1 -g1 -fno-omit-frame-pointer "$main" -fsanitize=$sanitizers \
  -fno-sanitize=vptr -fno-sanitize-recover=all
