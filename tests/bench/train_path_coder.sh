#!/usr/bin/env bash
# Makes src/reverse/line_price_prior.cpp, src/codec/path_warm_start_table.cpp and
# src/codec/chain_weights.cpp anew from drawings:
#
#     tests/bench/train_path_coder.sh FOLDER [BUILD]
#
# Takes every second image of the sets openmoji, mpeg7, ocsr and maps_fill of
# FOLDER, so that the other half stays unseen for measuring. The prices of lines
# come in three rounds, each with the lines that the prices before led to; the
# weights too, each from those before.
set -euo pipefail
folder=${1:?usage: train_path_coder.sh FOLDER [BUILD]}
root=$(cd "$(dirname "$0")/../.." && pwd)
build=${2:-$root/build/release}
prices=$root/src/reverse/line_price_prior.cpp
table=$root/src/codec/path_warm_start_table.cpp
weights=$root/src/codec/chain_weights.cpp
mapfile -t images < <(
  for set in maps_fill mpeg7 ocsr openmoji; do
    find "$folder/$set" -type f \
      \( -name '*.tif' -o -name '*.png' -o -name '*.pbm' \) |
      LC_ALL=C sort | awk 'NR % 2 == 1'
  done)
run() {
  cmake --build "$build" --target "$1"
  "$build/tests/bench/$1" "$2" "${images[@]}"
}
for _ in 1 2 3; do run train_lines "$prices"; done
run train_path_coder "$table"
for _ in 1 2 3; do run train_chains "$weights"; done
echo "trained on ${#images[@]} images: $prices $table $weights"
