#!/usr/bin/env bash
# Makes src/codec/centreline_weights.cpp anew from drawings:
#
#     tests/bench/train_centrelines.sh FOLDER [BUILD]
#
# Takes every second image of the set maps_thin of FOLDER, so that the other half
# stays unseen for measuring, in three rounds, each from the weights before.
set -euo pipefail
folder=${1:?usage: train_centrelines.sh FOLDER [BUILD]}
root=$(cd "$(dirname "$0")/../.." && pwd)
build=${2:-$root/build/release}
weights=$root/src/codec/centreline_weights.cpp
mapfile -t images < <(find "$folder/maps_thin" -type f -name '*.tif' |
  LC_ALL=C sort | awk 'NR % 2 == 1')
for _ in 1 2 3; do
  cmake --build "$build" --target train_centrelines
  "$build/tests/bench/train_centrelines" "$weights" "${images[@]}"
done
echo "trained on ${#images[@]} images: $weights"
