#!/bin/bash
# round_trip.sh UNSTEP SAMPLES WORK: compress, verify, decompress to the
# natural format, and verify that against the archive too.
set -euo pipefail
unstep=$1 samples=$2 work=$3

rm -rf "$work"
mkdir -p "$work"
count=0
for file in "$samples"/*.tif "$samples"/*.png "$samples"/*.pbm "$samples"/*.fc
do
  name=$(basename "$file")
  mkdir "$work/$name"
  packed=$work/$name/drawing.ustp
  "$unstep" compress --quiet "$file" -o "$packed"
  "$unstep" verify "$packed"
  "$unstep" verify "$file" "$packed"
  "$unstep" decompress --quiet "$packed"
  back=$(find "$work/$name" -type f ! -name '*.ustp')
  if [ "$(wc -l <<<"$back")" -ne 1 ] || [ -z "$back" ]; then
    echo "$name: expected one decoded file, got: $back" >&2
    exit 1
  fi
  "$unstep" verify "$back" "$packed"
  count=$((count + 1))
done
if [ $count -lt 9 ]; then
  echo "only $count samples" >&2
  exit 1
fi
