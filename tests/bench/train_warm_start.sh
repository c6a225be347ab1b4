#!/usr/bin/env bash
# Makes src/codec/warm_start_table.cpp anew from drawings:
#
#     tests/bench/train_warm_start.sh FOLDER [BUILD]
#
# Takes every second image of each sub-folder of FOLDER, so that the other half
# stays unseen for measuring. Two passes: records, then mixer weights.
set -euo pipefail
folder=${1:?usage: train_warm_start.sh FOLDER [BUILD]}
root=$(cd "$(dirname "$0")/../.." && pwd)
build=${2:-$root/build/dev}
table=$root/src/codec/warm_start_table.cpp
mapfile -t images < <(
  find "$folder" -mindepth 1 -maxdepth 1 -type d | sort | while read -r set; do
    find "$set" -type f \( -name '*.tif' -o -name '*.png' -o -name '*.pbm' \) |
      LC_ALL=C sort | awk 'NR % 2 == 1'
  done)
train() {
  cmake --build "$build" --target train_warm_start
  "$build/tests/bench/train_warm_start" "$table" "$@"
}
train
train "${images[@]}"
train "${images[@]}"
echo "trained on ${#images[@]} images: $table"
