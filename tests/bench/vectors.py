#!/usr/bin/env python3
"""Lines at a tolerance beside potrace: bytes and deviation, set by set.

usage: tests/bench/vectors.py [--unstep PROGRAM] [--distance PROGRAM]
         [--tolerance E]... [--json FILE] FOLDER

FOLDER holds the sets of images as sub-folders. Every page is traced by
`unstep compress --tolerance E` and `unstep convert --tolerance E` to SVG, and
by `potrace -s` with its defaults; SVG counts after gzip -9. Every .ustp file
is measured by `unstep verify` against its page and must be within E. Distances
of both programs' SVG from the contours are measured by the same program,
`vector_distance` (tests/bench). Prints Markdown.
"""

import argparse
import gzip
import json
import os
import re
import subprocess
import sys
import tempfile

import images

SETS = ["openmoji", "mpeg7", "ocsr", "maps_fill"]


def run(*command):
    return subprocess.run(command, check=True, capture_output=True).stdout


def zipped(path):
    with open(path, "rb") as file:
        return len(gzip.compress(file.read(), 9, mtime=0))


def measure_page(options, pbm, tolerance, scratch):
    """Bytes and distances of one page."""
    def out(name):
        return os.path.join(scratch, name)

    run(options.unstep, "compress", "-q", "-f", "--tolerance", tolerance, pbm,
        "-o", out("a.ustp"))
    said = run(options.unstep, "verify", pbm, out("a.ustp")).decode()
    found = re.search(r"deviates by up to ([\d.e+-]+) px", said)
    run(options.unstep, "convert", "-q", "-f", "--tolerance", tolerance, pbm,
        out("a.svg"))
    info = json.loads(run(options.unstep, "info", "--json", out("a.ustp")))
    row = {
        "ustp": os.path.getsize(out("a.ustp")),
        "svg": zipped(out("a.svg")),
        "elements": info[0].get("lines", 0) + info[0].get("arcs", 0),
        "deviation": float(found.group(1)) if found else 0.0,
    }
    if options.potrace:
        run("potrace", "-s", pbm, "-o", out("p.svg"))
        row["potrace"] = zipped(out("p.svg"))
        if options.distance:
            row["potrace_distance"] = float(
                run(options.distance, pbm, out("p.svg")))
            row["svg_distance"] = float(run(options.distance, pbm,
                                            out("a.svg")))
    return row


def measure_set(options, files, tolerance, scratch):
    rows = []
    for path in files:
        for page in images.read_pages(path):
            pbm = os.path.join(scratch, "page.pbm")
            with open(pbm, "wb") as file:
                file.write(page.file())
            lossless = os.path.join(scratch, "exact.ustp")
            run(options.unstep, "compress", "-q", "-f", "--no-verify", pbm,
                "-o", lossless)
            row = measure_page(options, pbm, tolerance, scratch)
            row["lossless"] = os.path.getsize(lossless)
            row["page"] = path
            rows.append(row)
    return rows


def total(rows, key):
    return sum(row.get(key, 0) for row in rows)


def worst(rows, key):
    return max((row[key] for row in rows if key in row), default=0.0)


def print_table(tolerance, sets):
    print(f"\n#### Tolerance {tolerance}\n")
    print("| set | pages | lossless | .ustp | / lossless | lines and arcs "
          "| bits each | SVG, gzip | potrace SVG, gzip | .ustp / potrace "
          "| SVG / potrace | deviation, worst | distance of our SVG "
          "| of potrace's |")
    print("|---|" + "--:|" * 13)
    for name, rows in sets.items():
        ustp, lossless = total(rows, "ustp"), total(rows, "lossless")
        peer = total(rows, "potrace")
        elements = total(rows, "elements")
        share = (f"{ustp / peer:.3f}", f"{total(rows, 'svg') / peer:.3f}"
                 ) if peer else ("", "")
        print(f"| {name} | {len(rows)} | {lossless} | {ustp} "
              f"| {ustp / lossless:.3f} | {elements} "
              f"| {8 * ustp / max(elements, 1):.2f} | {total(rows, 'svg')} "
              f"| {peer or ''} | {share[0]} | {share[1]} "
              f"| {worst(rows, 'deviation'):.4g} "
              f"| {worst(rows, 'svg_distance'):.4g} "
              f"| {worst(rows, 'potrace_distance'):.4g} |")


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--unstep", default="build/release/cli/unstep")
    parser.add_argument("--distance",
                        default="build/release/tests/bench/vector_distance")
    parser.add_argument("--tolerance", action="append")
    parser.add_argument("--no-potrace", dest="potrace", action="store_false")
    parser.add_argument("--json")
    parser.add_argument("folder")
    options = parser.parse_args()
    if not os.path.exists(options.distance):
        print(f"{options.distance} is not built: no distances",
              file=sys.stderr)
        options.distance = None
    results = {}
    for tolerance in options.tolerance or ["1"]:
        sets = {}
        with tempfile.TemporaryDirectory() as scratch:
            for name, files in images.find_sets([options.folder]).items():
                if name in SETS:
                    sets[name] = measure_set(options, files, tolerance,
                                             scratch)
        print_table(tolerance, sets)
        results[tolerance] = sets
    if options.json:
        with open(options.json, "w", encoding="utf-8") as file:
            json.dump(results, file, indent=1)


if __name__ == "__main__":
    main()
