#!/usr/bin/env python3
"""Rewrites the table that opens README.md.

usage: readme_table.py COMPARE.json

COMPARE.json is what compare.py --json wrote for samples/. The smallest file
of each row is bold.
"""

import json
import os
import sys

README = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..",
                      "README.md")
SHOWN = {"text-page.tif": "book page, 300 dpi",
         "score-2pages.tif": "engraved music, 2 pages, 300 dpi",
         "schematic.tif": "circuit diagram, 400 dpi",
         "coast.png": "coast lines, 1 px wide",
         "molecule-8bit.png": "chemical formula",
         "crown.png": "icon",
         "glyph.pbm": "pen stroke"}
CODERS = {"png": "PNG", "g4": "TIFF G4", "jbig1": "JBIG", "djvu": "DjVu",
          "unstep": "unstep"}


def main():
    if len(sys.argv) != 2:
        sys.exit("usage: readme_table.py COMPARE.json")
    with open(sys.argv[1], encoding="utf-8") as file:
        pages = json.load(file)["pages"]
    table = ["| bytes | " + " | ".join(CODERS.values()) + " |",
             "|---|" + "--:|" * len(CODERS)]
    for name, label in SHOWN.items():
        sizes = [sum(p["coders"][coder]["bytes"] for p in pages
                     if p["file"] == name) for coder in CODERS]
        if 0 in sizes:
            sys.exit("readme_table.py: no figures for %s" % name)
        cells = ["**%d**" % s if s == min(sizes) else str(s) for s in sizes]
        table.append("| %s | %s |" % (label, " | ".join(cells)))

    with open(README, encoding="utf-8") as file:
        lines = file.read().split("\n")
    first = next(i for i, l in enumerate(lines) if l.startswith("| bytes |"))
    after = lines.index("", first)
    lines[first:after] = table
    with open(README, "w", encoding="utf-8") as file:
        file.write("\n".join(lines))


if __name__ == "__main__":
    main()
