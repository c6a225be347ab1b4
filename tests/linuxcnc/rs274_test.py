#!/usr/bin/env python3
"""LinuxCNC's interpreter rs274 as the second opinion on programs.

usage: rs274_test.py PROGRAM_TOOL [--random COUNT] FOLDER...

Every program of the folders: the motions that we read are the canonical moves
that rs274 makes of it, and the motions that we write are those that rs274
reads from what we wrote. Programs that rs274 does not accept are named. With
--random so many programs of loops, branches and subroutines too.
Exit code 77, with a line that says so, where rs274 is not installed.
"""

import math
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

from random_flow import random_program

CALL = re.compile(r"^\s*\d+ N\S+\s+(\w+)\((.*)\)\s*$")
PLANES = {"CANON_PLANE_XY": 0, "CANON_PLANE_XZ": 1, "CANON_PLANE_YZ": 2}
# First, second and third axis of each plane.
AXES = [(0, 1, 2), (2, 0, 1), (1, 2, 0)]


class Move:
    def __init__(self, kind, end, plane=0, turns=1, centre=None):
        self.kind, self.end, self.plane = kind, end, plane
        self.turns, self.centre = turns, centre


def numbers(text):
    return [float(part) for part in text.split(",")]


def canonical_moves(output):
    """rs274 prints four decimals of the unit in force, without offsets."""
    unit, g5x, g92, plane, moves = 1.0, [0.0] * 6, [0.0] * 6, 0, []
    for line in output.splitlines():
        match = CALL.match(line)
        if not match:
            continue
        name, arguments = match.groups()
        shift = [a + b for a, b in zip(g5x, g92)]
        if name == "USE_LENGTH_UNITS":
            unit = 25.4 if "INCH" in arguments else 1.0
        elif name == "SET_G5X_OFFSET":
            g5x = [unit * n for n in numbers(arguments)[1:7]]
        elif name == "SET_G92_OFFSET":
            g92 = [unit * n for n in numbers(arguments)[:6]]
        elif name == "SELECT_PLANE":
            plane = PLANES[arguments.strip()]
        elif name in ("STRAIGHT_TRAVERSE", "STRAIGHT_FEED"):
            end = numbers(arguments)
            end = [n * (unit if i < 3 else 1) + shift[i]
                   for i, n in enumerate(end[:6])]
            moves.append(Move(1 if name == "STRAIGHT_TRAVERSE" else 2, end))
        elif name == "ARC_FEED":
            n = numbers(arguments)
            first, second, third = AXES[plane]
            end = [0.0] * 6
            end[first] = n[0] * unit + shift[first]
            end[second] = n[1] * unit + shift[second]
            end[third] = n[5] * unit + shift[third]
            centre = (n[2] * unit + shift[first], n[3] * unit + shift[second])
            turns = int(n[4])
            moves.append(Move(4 if turns > 0 else 3, end, plane, abs(turns),
                              centre))
    return moves


def our_moves(output):
    moves = []
    for line in output.splitlines():
        n = line.split()
        kind = int(n[0])
        centre = tuple(float(x) for x in n[12:14]) if kind > 2 else None
        moves.append(Move(kind, [float(x) for x in n[3:9]], int(n[1]),
                          int(n[2]), centre))
    return moves


def difference(ours, theirs, near):
    if len(ours) != len(theirs):
        return f"{len(ours)} motions, rs274 has {len(theirs)}"
    for i, (a, b) in enumerate(zip(ours, theirs)):
        place = f"motion {i + 1}: "
        if a.kind != b.kind:
            return place + f"kind {a.kind}, rs274 has {b.kind}"
        if max(abs(x - y) for x, y in zip(a.end, b.end)) > near:
            return place + f"ends at {a.end}, in rs274 at {b.end}"
        if a.kind > 2:
            if (a.plane, a.turns) != (b.plane, b.turns):
                return place + "another plane or number of turns"
            # Where R gives a flat arc its centre amplifies the rounding.
            if math.dist(a.centre, b.centre) > 2 * near:
                return place + f"centre {a.centre}, in rs274 {b.centre}"
    return None


class Bench:
    def __init__(self, tool, folder):
        self.tool, self.folder, self.failures = tool, folder, 0
        self.checked = 0
        (folder / "tool.tbl").write_text(
            "".join(f"T{n} P{n} D0.1 Z0\n" for n in range(1, 9)))

    def rs274(self, path):
        """The moves, or None if it does not accept the program."""
        variables = self.folder / "var"
        variables.unlink(missing_ok=True)
        run = subprocess.run(
            ["rs274", "-g", "-t", self.folder / "tool.tbl", "-v", variables,
             path],
            capture_output=True, text=True, errors="replace", check=False)
        if run.returncode != 0 or "PROGRAM_END" not in run.stdout:
            return None, " ".join((run.stderr or "no end").split())
        return canonical_moves(run.stdout), ""

    def ours(self, *arguments):
        run = subprocess.run([self.tool, *map(str, arguments)],
                             capture_output=True, text=True, check=False)
        if run.returncode != 0:
            return None, run.stderr.strip()
        return our_moves(run.stdout), ""

    def report(self, name, problem):
        self.checked += 1
        if problem:
            self.failures += 1
            print(f"FAILED {name}: {problem}")

    def check(self, path):
        text = path.read_text(encoding="utf-8", errors="replace")
        near = 0.00011 * (25.4 if re.search("[gG]20", text) else 1)
        moves, reason = self.rs274(path)
        read, our_reason = self.ours(path)
        if moves is None:
            print(f"not accepted by rs274: {path.name}: {reason}")
        else:
            self.report(f"{path.name} read",
                        our_reason or difference(read, moves, near))
        if read is None:
            return
        for tolerance in (0, 0.005, 0.025):
            for form in ("as_read", "centre", "radius"):
                for profile in ("linuxcnc", "mm", "inch"):
                    if profile != "linuxcnc" and form != "as_read":
                        continue
                    self.check_written(path, tolerance, profile, form)

    def check_random(self, count):
        """Programs of control flow: one in ten may be kept as it stands."""
        path, kept = self.folder / "random.ngc", 0
        for seed in range(count):
            path.write_text(random_program(seed))
            moves, reason = self.rs274(path)
            run = subprocess.run([self.tool, path], capture_output=True,
                                 text=True, check=False)
            if moves is None:
                self.report(f"random {seed}", "rs274: " + reason)
            elif run.returncode != 0:
                self.report(f"random {seed}", run.stderr.strip())
            elif "kept as it stands" in run.stderr:
                kept += 1
            else:
                self.report(f"random {seed}", difference(
                    our_moves(run.stdout), moves, 0.00011))
        if kept > count / 10:
            self.report("random programs", f"{kept} of {count} were kept")

    def check_written(self, path, tolerance, profile, form):
        out = self.folder / "out.ngc"
        name = f"{path.name} at {tolerance} as {profile}, arcs {form}"
        ours, reason = self.ours(path, tolerance, out, profile, form)
        if ours is None:
            self.report(name, reason)
            return
        theirs, reason = self.rs274(out)
        if theirs is None:
            self.report(name, "not accepted: " + reason)
            return
        inches = re.search("[gG]20", out.read_text(errors="replace"))
        near = 0.00011 * (25.4 if inches else 1)
        if form == "radius":
            self.report(name, difference_of_ends(ours, theirs, near))
        else:
            self.report(name, difference(ours, theirs, near))


def difference_of_ends(ours, theirs, near):
    """R form splits long arcs: our ends come in order among rs274's."""
    at = 0
    for i, move in enumerate(ours):
        while at < len(theirs) and (
                theirs[at].kind != move.kind or
                max(abs(x - y) for x, y in zip(move.end, theirs[at].end))
                > near):
            at += 1
        if at == len(theirs):
            return f"motion {i + 1} is missing in rs274"
        at += 1
    return None


def main():
    tool, *folders = sys.argv[1:]
    count = 0
    if folders[:1] == ["--random"]:
        count, folders = int(folders[1]), folders[2:]
    if shutil.which("rs274") is None:
        print("SKIPPED: rs274 is not installed (Debian: linuxcnc-uspace); "
              "programs were not compared with LinuxCNC", file=sys.stderr)
        return 77
    with tempfile.TemporaryDirectory() as folder:
        bench = Bench(tool, pathlib.Path(folder))
        bench.check_random(count)
        for where in folders:
            for path in sorted(pathlib.Path(where).iterdir()):
                if path.suffix in (".ngc", ".nc", ".gcode"):
                    bench.check(path)
    print(f"{bench.checked} comparisons, {bench.failures} failed")
    return 1 if bench.failures or bench.checked == 0 else 0


if __name__ == "__main__":
    sys.exit(main())
