#!/usr/bin/env bash
# Checks that the linker cannot take code for AVX2 and AVX-512 for that of every machine. Each weak inline
# function in these objects must have its registers in its name. Nothing of it may run when the library is
# loaded, on any machine.
#   extras/lanes/lanes_apart.sh BUILD
set -euo pipefail
build=${1:?the build}
found=0
for object in "$build"/extras/lanes/CMakeFiles/oddity_lanes.dir/Avx*_*.o; do
  [ -f "$object" ] || continue
  found=$((found + 1))
  case $object in
    */Avx2_*) own='lanes::Avx2|(double|long) __vector\(4\)|(float|int) __vector\(8\)' ;;
    *) own='lanes::Avx512|(double|long) __vector\(8\)|(float|int) __vector\(16\)' ;;
  esac
  if nm -C --defined-only "$object" | grep ' W ' | grep -vE "$own" >&2; then
    echo "lanes_apart: $object defines these, which another file may have too" >&2
    exit 1
  fi
  if nm -C --defined-only "$object" | grep '_GLOBAL__sub_I_' >&2; then
    echo "lanes_apart: what $object defines is made where the library is loaded" >&2
    exit 1
  fi
done
if [ "$found" = 0 ] && [ "$(uname -m)" = x86_64 ]; then
  echo "lanes_apart: $build has no objects of lanes for AVX2 and AVX-512: build oddity_lanes first" >&2
  exit 1
fi
echo "lanes_apart: $found objects share no inline function, and run nothing when they are loaded"
