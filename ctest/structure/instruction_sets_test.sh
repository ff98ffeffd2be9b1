#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-2.0-or-later
# instruction_sets_test.sh BUILD: fails when an object of the native kernel defines a symbol outside its own namespace.
# The linker could choose such a copy, compiled for wide vectors, for code that runs on any processor.
set -euo pipefail

objects=0 strangers=0
for set in baseline avx2 avx512; do
  object=$1/core/CMakeFiles/flowslide_native_passes_$set.dir/dem/native/isa/passes_isa.cpp.o
  [[ -e $object ]] || continue
  objects=$((objects + 1))
  while IFS= read -r symbol; do
    echo "$set: $symbol is outside flowslide::native::$set"
    strangers=$((strangers + 1))
  done < <(nm --demangle --defined-only --extern-only "$object" | grep -v "flowslide::native::$set::" || true)
done
echo "$objects objects, $strangers symbols outside their namespaces"
((objects > 0 && strangers == 0))
