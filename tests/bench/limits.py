#!/usr/bin/env python3
"""Memory and fixed costs of the program against their targets.

usage: limits.py [--build DIR] [--runs N] [--json FILE]

Makes its pages from samples/ with make_large.py, measures whole processes
with process_cost (built with UNSTEP_BENCH) and prints a Markdown table of
target and measurement. Exit code 1 if a target is missed.
"""

import argparse
import filecmp
import json
import os
import subprocess
import sys
import tempfile

import images

HERE = os.path.dirname(os.path.abspath(__file__))
ROOT = os.path.normpath(os.path.join(HERE, "..", ".."))
MB = 1e6


class Machine:
    """The programs of one build folder."""

    def __init__(self, build):
        self.unstep = os.path.join(build, "cli", "unstep")
        self.cost = os.path.join(build, "tests", "bench", "process_cost")
        self.empty = os.path.join(build, "tests", "bench", "empty_program")
        for program in (self.unstep, self.cost, self.empty):
            if not os.access(program, os.X_OK):
                sys.exit("limits.py: %s is not built" % program)

    def measure(self, commands, runs):
        """[(wall ms, processor ms, peak bytes)] of commands, interleaved."""
        line = [self.cost, str(runs)]
        for i, command in enumerate(commands):
            line += (["--"] if i else []) + command
        done = subprocess.run(line, stdout=subprocess.PIPE, check=False)
        if done.returncode != 0:
            sys.exit("limits.py: a command failed")
        return [tuple(map(float, row.split()))
                for row in done.stdout.decode().splitlines()]

    def compress(self, source, target):
        return [self.unstep, "compress", "--no-verify", "--force", "--jobs",
                "1", source, "-o", target]

    def decompress(self, source, target):
        return [self.unstep, "decompress", "--force", "--jobs", "1", "--to",
                "pbm", source, "-o", target]


def make_page(path, width, height):
    subprocess.run([sys.executable, os.path.join(HERE, "make_large.py"),
                    "--size", str(width), str(height), path], check=True)


def memory(machine, folder, label, width, height, target_mb):
    """Peak memory of compress, compress with the check, and decompress."""
    page = os.path.join(folder, "page.pbm")
    file = os.path.join(folder, "page.ustp")
    back = os.path.join(folder, "back.pbm")
    make_page(page, width, height)
    checked = machine.compress(page, file)
    checked.remove("--no-verify")
    rows = []
    for verb, command in (("compress --no-verify",
                           machine.compress(page, file)),
                          ("compress", checked),
                          ("decompress", machine.decompress(file, back))):
        wall, cpu, peak = machine.measure([command], 1)[0]
        rows.append({"what": "%s, %s" % (label, verb), "unit": "MB",
                     "target": target_mb, "measured": peak / MB,
                     "note": "%.2f s, %.0f Mpx/s" % (
                         wall / 1e3, width * height / 1e3 / cpu)})
    if not filecmp.cmp(page, back, shallow=False):
        sys.exit("limits.py: %s came back different" % label)
    return rows


def fixed_costs(machine, folder, runs):
    """Processor time of short processes beyond an empty C++ program."""
    page = os.path.join(folder, "icon.pbm")
    file = os.path.join(folder, "icon.ustp")
    back = os.path.join(folder, "icon.back.pbm")
    crown = images.read_pages(os.path.join(ROOT, "samples", "crown.png"))[0]
    with open(page, "wb") as out:
        out.write(on_canvas(crown, 1000, 1000).file())
    subprocess.run(machine.compress(page, file), check=True,
                   stdout=subprocess.DEVNULL)
    empty, version, decode = machine.measure(
        [[machine.empty], [machine.unstep, "--version"],
         machine.decompress(file, back)], runs)
    rows = []
    for label, cost in (("unstep --version", version),
                        ("decompress 1 Mpx icon to PBM", decode)):
        rows.append({"what": label + ", beyond an empty program",
                     "unit": "ms", "target": 10,
                     "measured": cost[1] - empty[1],
                     "note": "wall %.1f ms beyond %.1f" % (
                         cost[0] - empty[0], empty[0])})
    return rows


def on_canvas(page, width, height):
    stride = (page.width + 7) // 8
    wide = (width + 7) // 8
    rows = b"".join(page.rows[y * stride:(y + 1) * stride].ljust(wide, b"\0")
                    for y in range(page.height))
    return images.Pbm(width, height, rows.ljust(wide * height, b"\0"))


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--build", default=os.path.join(ROOT, "build",
                                                        "release"))
    parser.add_argument("--runs", type=int, default=100)
    parser.add_argument("--json", metavar="FILE")
    parser.add_argument("--tmp", metavar="DIR")
    args = parser.parse_args()
    machine = Machine(args.build)

    rows = []
    with tempfile.TemporaryDirectory(dir=args.tmp) as folder:
        rows += fixed_costs(machine, folder, args.runs)
        rows += memory(machine, folder, "35 Mpx page (5000 x 7000)", 5000,
                       7000, 25)
        rows += memory(machine, folder, "400 Mpx page (20000 x 20000)", 20000,
                       20000, 300)

    print("| what | target | measured | |\n|---|--:|--:|---|")
    for row in rows:
        row["met"] = row["measured"] <= row["target"]
        print("| %s | %g %s | %.1f %s%s | %s |" % (
            row["what"], row["target"], row["unit"], row["measured"],
            row["unit"], "" if row["met"] else " (missed)", row["note"]))
    if args.json:
        with open(args.json, "w", encoding="utf-8") as out:
            json.dump(rows, out, indent=1)
    sys.exit(0 if all(row["met"] for row in rows) else 1)


if __name__ == "__main__":
    main()
