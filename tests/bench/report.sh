#!/bin/bash
# Measures unstep beside its peers and rewrites the section "Results" of
# docs/benchmarks.md and the table that opens README.md.
#
# usage: tests/bench/report.sh FOLDER [option of compare.py]...
#
# FOLDER holds the sets of images as sub-folders. Takes an hour, most of
# it for JPEG XL; the tables are also left in build/release/bench as Markdown and JSON.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
if [ $# -lt 1 ] || [ ! -d "$1" ]; then
  echo "usage: tests/bench/report.sh FOLDER [option of compare.py]..." >&2
  exit 2
fi
folder=$1
shift

generator=()
if [ ! -e build/release/CMakeCache.txt ] && command -v ninja >/dev/null; then
  generator=(-G Ninja)
fi
cmake --preset release "${generator[@]}" -D UNSTEP_BENCH=ON \
  --log-level=WARNING >/dev/null
cmake --build build/release -j "$(nproc)"

results=build/release/bench
mkdir -p "$results"
tests/bench/compare.py --json "$results/compare.json" "$@" "$folder" \
  >"$results/compare.md"
tests/bench/compare.py --runs 1 --json "$results/samples.json" samples \
  >"$results/samples.md"
tests/bench/readme_table.py "$results/samples.json"
build/release/tests/bench/unstep_bench "$folder" >"$results/library.md"
missed=0
tests/bench/limits.py --json "$results/limits.json" >"$results/limits.md" ||
  missed=1

{
  sed '/^## Results$/q' docs/benchmarks.md
  echo
  cat "$results/compare.md"
  printf '\n### The library in one process\n\n'
  cat "$results/library.md"
  printf '\n### Memory and fixed costs of the program\n\n'
  cat "$results/limits.md"
  echo
  # What follows was measured by other programs.
  sed '1,/^## Results$/d' docs/benchmarks.md | sed -n '/^## /,$p'
} >"$results/benchmarks.md"
cp "$results/benchmarks.md" docs/benchmarks.md
if [ $missed = 1 ]; then
  echo "a limit was missed, see docs/benchmarks.md" >&2
  exit 1
fi
