#!/usr/bin/env bash
# Makes src/codec/stroke_warm_start_table.cpp anew from drawings:
#
#     tests/bench/train_strokes.sh FOLDER [BUILD]
#
# Takes every second image of the set ocsr of FOLDER, so that the others stay
# unseen for measuring.
set -euo pipefail
folder=${1:?usage: train_strokes.sh FOLDER [BUILD]}
root=$(cd "$(dirname "$0")/../.." && pwd)
build=${2:-$root/build/release}
table=$root/src/codec/stroke_warm_start_table.cpp
mapfile -t images < <(find "$folder/ocsr" -type f -name '*.png' |
  LC_ALL=C sort | awk 'NR % 2 == 1')
cmake --build "$build" --target train_strokes
"$build/tests/bench/train_strokes" "$table" "${images[@]}"
echo "trained on ${#images[@]} images: $table"
