#!/bin/bash
# Installs what is missing, builds unstep, compresses the samples, decodes
# them, compares, and prints a table. The comparison trusts nothing of unstep:
# netpbm reads the originals, and PBM files are compared byte by byte.
#
# usage: samples/demo.sh [--no-install] [--unstep PROGRAM]
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
. tests/needs.sh

install=yes
unstep=
while [ $# -gt 0 ]; do
  case $1 in
    --no-install) install=no; shift ;;
    --unstep)
      if [ $# -lt 2 ]; then echo "demo.sh: $1 needs a value" >&2; exit 2; fi
      unstep=$2; shift 2 ;;
    *) echo "usage: samples/demo.sh [--no-install] [--unstep PROGRAM]" >&2
       exit 2 ;;
  esac
done

if [ $install = yes ]; then
  # Lists of words, from needs.sh.
  # shellcheck disable=SC2086,SC2154
  install_missing $needs_build $needs_demo
fi

if [ -z "$unstep" ]; then
  generator=()
  if [ ! -e build/demo/CMakeCache.txt ] && command -v ninja >/dev/null; then
    generator=(-G Ninja)
  fi
  echo "building ..."
  cmake --preset release -B build/demo "${generator[@]}" \
    -D UNSTEP_TESTS=OFF --log-level=WARNING >/dev/null
  cmake --build build/demo -j "$(nproc)" >build/demo/build.log || {
    cat build/demo/build.log >&2
    exit 1
  }
  unstep=build/demo/cli/unstep
fi

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# original FILE: its pages as concatenated raw PBM, read by netpbm.
original() {
  case $1 in
    *.tif) tifftopnm -quiet "$1" ;;
    *8bit.png) pngtopnm -quiet "$1" | pamthreshold -simple -threshold 0.5 |
      pamtopnm ;;
    *.png) pngtopnm -quiet "$1" ;;
    *.pbm) cat "$1" ;;
  esac
}

# png_bytes PBM: of all its pages as the smallest 1-bit PNGs of pnmtopng.
png_bytes() {
  pamsplit -quiet "$1" "$work/page%d.pbm" 2>/dev/null
  local page
  for page in "$work"/page*.pbm; do
    pnmtopng -quiet -compression 9 "$page"
    rm "$page"
  done | wc -c
}

pixels() {
  pamfile -allimages "$1" |
    sed -E 's/.*, ([0-9]+) by ([0-9]+).*/\1 \2/' |
    awk '{ sum += $1 * $2 } END { print sum }'
}

# Freeman text without comments and blanks, for comparison: a writer may break
# lines elsewhere.
bare_text() { sed 's/#.*//' "$1" | tr -d ' \t\n'; }

differing=0
row='%-24s %10s %10s %12s %7s  %s\n'
# shellcheck disable=SC2059
print_row() { printf "$row" "$@"; }
print_row file pixels 'PNG bytes' '.ustp bytes' ratio identical
for file in samples/*.tif samples/*.png samples/*.pbm samples/*.fc; do
  name=$(basename "$file")
  "$unstep" compress --quiet "$file" -o "$work/$name.ustp"
  bytes=$(stat -c %s "$work/$name.ustp")
  identical=no
  if [ "${name##*.}" = fc ]; then
    # Chains are no picture; the text itself is what they are weighed against.
    "$unstep" decompress --quiet "$work/$name.ustp" -o "$work/$name"
    size=- png=$(stat -c %s "$file")
    if [ "$(bare_text "$file")" = "$(bare_text "$work/$name")" ]; then
      identical=yes
    fi
    name="$name (text bytes)"
  else
    original "$file" >"$work/original.pbm"
    "$unstep" decompress --quiet --to pbm "$work/$name.ustp" \
      -o "$work/decoded.pbm"
    cat "$work"/decoded*.pbm >"$work/all.pbm"
    rm "$work"/decoded*.pbm
    size=$(pixels "$work/original.pbm")
    png=$(png_bytes "$work/original.pbm")
    if cmp -s "$work/original.pbm" "$work/all.pbm"; then identical=yes; fi
  fi
  if [ $identical = no ]; then differing=$((differing + 1)); fi
  ratio=$(awk -v a="$bytes" -v b="$png" 'BEGIN { printf "%.2f", a / b }')
  print_row "$name" "$size" "$png" "$bytes" "$ratio" "$identical"
done

if [ $differing -gt 0 ]; then
  echo "$differing of the samples came back different" >&2
  exit 1
fi
