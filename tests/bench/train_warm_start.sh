#!/usr/bin/env bash
# Makes src/codec/warm_start_small.cpp, _large.cpp, _clean.cpp and
# deep_warm_start.cpp anew:
#
#     tests/bench/train_warm_start.sh FOLDER [BUILD]
#
# Takes every second image of each sub-folder of FOLDER, so that the other half
# stays unseen for measuring: those in files below 10 kB for the small tables, all
# for the large one, of these the program picks maps and the like for the clean
# one. A pass for records, then one for the weights of mixers, three if each
# vector has its own, twelve of the deep model.
set -euo pipefail
folder=${1:?usage: train_warm_start.sh FOLDER [BUILD]}
root=$(cd "$(dirname "$0")/../.." && pwd)
build=${2:-$root/build/dev}
mapfile -t images < <(
  find "$folder" -mindepth 1 -maxdepth 1 -type d | sort | while read -r set; do
    find "$set" -type f \( -name '*.tif' -o -name '*.png' -o -name '*.pbm' \) |
      LC_ALL=C sort | awk 'NR % 2 == 1'
  done)
mapfile -t small < <(
  for image in "${images[@]}"; do
    if [ "$(stat -c %s "$image")" -lt 10000 ]; then echo "$image"; fi
  done)
train() { # train small|large|clean IMAGE...
  cmake --build "$build" --target train_warm_start
  "$build/tests/bench/train_warm_start" "$1" \
    "$root/src/codec/warm_start_$1.cpp" "${@:2}"
}
train_deep() { # train_deep IMAGE...
  cmake --build "$build" --target train_deep_turns
  "$build/tests/bench/train_deep_turns" \
    "$root/src/codec/deep_warm_start.cpp" "$@"
}
for name in small large clean; do train "$name"; done
for _ in 1 2; do train large "${images[@]}"; done
for _ in 1 2 3 4; do
  train small "${small[@]}"
  train clean "${images[@]}"
done
train_deep
# Means of what images came to move slowly towards what all want.
for _ in {1..13}; do train_deep "${small[@]}"; done
echo "trained on ${#small[@]} and ${#images[@]} images"
