#!/bin/bash
# smoke.sh PYTHON UNSTEP SAMPLES WORK: the scripts run and their tables hold
# what they promise. Peers that are not installed are left out.
set -euo pipefail
python=$1 unstep=$2 samples=$3 work=$4
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)

rm -rf "$work"
mkdir -p "$work/icons" "$work/large"
cp "$samples/crown.png" "$samples/glyph.pbm" "$work/icons"

"$python" "$here/make_large.py" --size 1100 1000 "$work/large/a.pbm"
"$python" "$here/make_large.py" --size 1100 1000 "$work/again.pbm"
cmp "$work/large/a.pbm" "$work/again.pbm"
rm "$work/again.pbm"

"$python" "$here/compare.py" --runs 1 --unstep "$unstep" \
  --json "$work/out.json" "$work" >"$work/out.md"
grep -q '^| icons | 2 | 0.4 |' "$work/out.md"
grep -q '^| large | 1 | 1.1 |' "$work/out.md"
grep -q '^| total | 3 | 1.5 |' "$work/out.md"
"$python" - "$work/out.json" <<'END'
import json, sys
pages = json.load(open(sys.argv[1]))["pages"]
assert len(pages) == 3
assert all(p["coders"]["unstep"]["verified"] for p in pages)
assert "decode_s" in [p for p in pages if p["set"] == "large"][0][
    "coders"]["unstep"]
END

"$python" "$here/huge_vectors.py" --build "$(dirname "$unstep")/.." \
  --size 700 600 --tmp "$work" >"$work/huge.md"
grep -q '^| unstep convert, SVG | ' "$work/huge.md"
grep -q '^| unstep compress, exact | ' "$work/huge.md"
