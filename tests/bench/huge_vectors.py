#!/usr/bin/env python3
"""A huge bilevel page as vectors: time and memory beside potrace.

usage: huge_vectors.py [--build DIR] [--size W H] [--tolerance E] [IMAGE...]

Makes the page of the images (default: samples/) with make_large.py, 371 Mpx,
and measures whole processes with process_cost: `unstep convert` to SVG and
`potrace -s`, and `unstep compress` exact and within the tolerance. Prints a
Markdown table. Without potrace its row is left out.
"""

import argparse
import os
import shutil
import subprocess
import sys
import tempfile

import limits

HERE = os.path.dirname(os.path.abspath(__file__))


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--build", default=os.path.join(limits.ROOT, "build",
                                                        "release"))
    parser.add_argument("--size", type=int, nargs=2, default=(21000, 17700))
    parser.add_argument("--tolerance", default="1")
    parser.add_argument("--tmp", metavar="DIR")
    parser.add_argument("image", nargs="*")
    args = parser.parse_args()
    machine = limits.Machine(args.build)
    width, height = args.size
    within = ["--tolerance", args.tolerance, "--force", "--quiet"]
    with tempfile.TemporaryDirectory(dir=args.tmp) as folder:
        page = os.path.join(folder, "page.pbm")
        subprocess.run([sys.executable, os.path.join(HERE, "make_large.py"),
                        "--size", str(width), str(height), page] + args.image,
                       check=True)
        svg = os.path.join(folder, "page.svg")
        ustp = os.path.join(folder, "page.ustp")
        compress = [machine.unstep, "compress", page, "-o", ustp]
        rows = [("unstep convert, SVG", svg,
                 [machine.unstep, "convert", page, svg] + within)]
        if shutil.which("potrace"):
            rows.append(("potrace, SVG", svg, ["potrace", "-s", page, "-o",
                                               svg]))
        else:
            print("potrace is not installed: left out", file=sys.stderr)
        rows += [("unstep compress --effort fast", ustp,
                  compress + within + ["--effort", "fast"]),
                 ("unstep compress", ustp, compress + within),
                 ("unstep compress, exact", ustp,
                  compress + ["--force", "--quiet"])]
        print("| %d x %d, %.0f Mpx | processor time, s | memory, MB | bytes |\n"
              "|---|--:|--:|--:|" % (width, height, width * height / 1e6))
        for label, output, command in rows:
            _, cpu, peak = machine.measure([command], 1)[0]
            print("| %s | %.2f | %.0f | %d |" % (
                label, cpu / 1e3, peak / limits.MB, os.path.getsize(output)))
            sys.stdout.flush()


if __name__ == "__main__":
    main()
