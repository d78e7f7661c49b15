#!/usr/bin/env bash
# Compiles every scene's models with clang and libc++ and without exceptions, like a WebAssembly toolchain.
#   tests/models_with_libcxx.sh      needs clang, libc++-dev and libc++abi-dev
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
unit=$(mktemp --suffix=.cpp)
trap 'rm -f "$unit"' EXIT
for header in chapters/*/*/models.hpp; do
  scene=$(basename "$(dirname "$header")" | sed 's/^[0-9]*_//')
  cat >"$unit" <<CPP
#include "$header"
auto in_double(const oddity::$scene::Given<double>& given) { return oddity::$scene::models(given); }
auto in_float(const oddity::$scene::Given<float>& given) { return oddity::$scene::models(given); }
CPP
  clang++ -std=c++20 -stdlib=libc++ -fno-exceptions -I. -Wall -Wextra -Wno-missing-braces -Werror -fsyntax-only "$unit"
  echo "$scene: as it should be"
done
