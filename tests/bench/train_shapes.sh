#!/usr/bin/env bash
# Makes src/codec/shape_warm_start_table.cpp anew from pages:
#
#     tests/bench/train_shapes.sh FOLDER [BUILD]
#
# Takes every second image of the sets ccitt, text300 and schematic of FOLDER, so
# that the other half stays unseen for measuring, in four rounds from equal weights.
set -euo pipefail
folder=${1:?usage: train_shapes.sh FOLDER [BUILD]}
root=$(cd "$(dirname "$0")/../.." && pwd)
build=${2:-$root/build/release}
mapfile -t images < <(
  for set in ccitt text300 schematic; do
    find "$folder/$set" -type f \
      \( -name '*.tif' -o -name '*.png' -o -name '*.pbm' \) |
      LC_ALL=C sort | awk 'NR % 2 == 1'
  done)
train() { # train IMAGE...
  cmake --build "$build" --target train_shapes
  "$build/tests/bench/train_shapes" \
    "$root/src/codec/shape_warm_start_table.cpp" "$@"
}
train
for _ in 1 2 3 4; do train "${images[@]}"; done
echo "trained on ${#images[@]} images"
