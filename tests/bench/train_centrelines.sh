#!/usr/bin/env bash
# Makes src/codec/centreline_warm_start_table.cpp and centreline_weights.cpp anew from
# drawings:
#
#     tests/bench/train_centrelines.sh FOLDER [BUILD]
#
# Takes every second image of the set maps_thin of FOLDER, so that the other half
# stays unseen for measuring: records, then weights in three rounds, each from those
# before.
set -euo pipefail
folder=${1:?usage: train_centrelines.sh FOLDER [BUILD]}
root=$(cd "$(dirname "$0")/../.." && pwd)
build=${2:-$root/build/release}
mapfile -t images < <(find "$folder/maps_thin" -type f -name '*.tif' |
  LC_ALL=C sort | awk 'NR % 2 == 1')
train() { # train records|weights OUT
  cmake --build "$build" --target train_centrelines
  "$build/tests/bench/train_centrelines" "$1" "$root/src/codec/$2" "${images[@]}"
}
train records centreline_warm_start_table.cpp
for _ in 1 2 3; do train weights centreline_weights.cpp; done
echo "trained on ${#images[@]} images"
