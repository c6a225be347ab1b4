#!/usr/bin/env python3
"""How well grey scans become ink again.

usage: scans.py --unstep UNSTEP --make-scan MAKE_SCAN [--a4] IMAGE...

Every bilevel image is made grey in four ways by make_scan (even light, a
gradient, a dark gutter, much noise) and read back with every --threshold. A
table tells the ink pixels of the original and how many pixels differ. With
--a4 the images are enlarged to A4 at 600 dpi and turned by 0.7 degrees, and the
time to compress the grey page is compared with that of its bilevel result.
"""

import argparse
import os
import re
import resource
import subprocess
import tempfile

WAYS = (
    ("even", ["gradient=0", "gutter=0", "noise=4"]),
    ("gradient", ["gradient=0.35", "gutter=0", "noise=6"]),
    ("gutter", ["gradient=0.3", "gutter=0.45", "noise=6"]),
    ("noisy", ["gradient=0.2", "gutter=0.2", "noise=14", "ink=70",
               "paper=210"]),
)
METHODS = ("otsu", "sauvola", "local", "auto")


def run(*arguments):
    return subprocess.run(arguments, capture_output=True, text=True)


def seconds(*arguments):
    """User time of the fastest of three runs."""
    best = None
    for _ in range(3):
        before = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
        subprocess.run(arguments, check=True, capture_output=True)
        spent = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - before
        best = spent if best is None else min(best, spent)
    return best


def differing(unstep, truth, packed):
    text = run(unstep, "verify", truth, packed).stdout
    found = re.search(r"([\d,]+) pixels? differ", text)
    return int(found.group(1).replace(",", "")) if found else 0


def ink(pbm):
    with open(pbm, "rb") as file:
        return sum(bin(byte).count("1") for byte in file.read()[20:])


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--unstep", required=True)
    parser.add_argument("--make-scan", required=True)
    parser.add_argument("--a4", action="store_true")
    parser.add_argument("images", nargs="+")
    options = parser.parse_args()
    print("| page | light | ink | " + " | ".join(METHODS) + " | auto is |"
          + (" time of bilevel |" if options.a4 else ""))
    print("|---" * (len(METHODS) + 4 + options.a4) + "|")
    best = 0
    rows = 0
    with tempfile.TemporaryDirectory() as folder:
        grey = os.path.join(folder, "grey.pgm")
        truth = os.path.join(folder, "truth.pbm")
        packed = os.path.join(folder, "packed.ustp")
        for image in options.images:
            for way, settings in WAYS:
                if options.a4:
                    settings = settings + ["a4=1", "skew=0.7", "blur=1.6"]
                subprocess.run([options.make_scan, image, grey, truth]
                               + settings, check=True)
                counts = {}
                for method in METHODS:
                    done = run(options.unstep, "compress", grey, "--force",
                               "--no-verify", "--effort", "fast",
                               "--threshold", method, "-o", packed)
                    chosen = "otsu" if "(otsu)" in done.stdout else "local"
                    counts[method] = differing(options.unstep, truth, packed)
                line = [os.path.basename(image), way, str(ink(truth))]
                line += [str(counts[method]) for method in METHODS] + [chosen]
                if options.a4:
                    bilevel = os.path.join(folder, "bilevel.tif")
                    run(options.unstep, "decompress", packed, "--force", "-o",
                        bilevel)
                    compress = (options.unstep, "compress", "--force", "-j1",
                                "-o", packed)
                    line.append("%.2f" % (
                        seconds(*compress, grey, "--threshold", "auto")
                        / seconds(*compress, bilevel)))
                print("| " + " | ".join(line) + " |", flush=True)
                rows += 1
                best += counts["auto"] <= min(counts["otsu"],
                                              counts["sauvola"])
    print("\nauto is the best or equal on %d of %d pages" % (best, rows))


if __name__ == "__main__":
    main()
