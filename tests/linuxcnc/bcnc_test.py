#!/usr/bin/env python3
"""bCNC's reader of G-code as another opinion on the programs that we write.

usage: bcnc_test.py PROGRAM_TOOL PROGRAM...

bCNC sends programs to GRBL and draws them first. What we write of each
program, shortened or not, with centres or radii, has the motions there that it
has here: kinds, ends, and arcs on their circles in their order. Its reader
knows no offsets and keeps no unit. Exit code 77, with a line that says so,
where bCNC is not installed; UNSTEP_BCNC names another folder of its sources.
"""

import math
import os
import pathlib
import subprocess
import sys
import tempfile
import types

from rs274_test import our_moves

FOLDER = os.environ.get("UNSTEP_BCNC", "/usr/share/bcnc/bCNC")
NEAR = 0.002


def reader():
    """bCNC's module CNC, without its windows and other file formats."""
    if not os.path.exists(os.path.join(FOLDER, "CNC.py")):
        return None
    sys.path[:0] = [FOLDER, os.path.join(FOLDER, "lib")]
    for name, item in {"dxf": "DXF", "bstl": "Binary_STL_Writer",
                       "svgcode": "SVGcode", "Utils": "to_zip"}.items():
        sys.modules[name] = types.ModuleType(name)
        setattr(sys.modules[name], item, None)
    import CNC  # pylint: disable=import-outside-toplevel,import-error
    return CNC.CNC


def their_moves(cnc_class, path):
    """(G word, points of the way, [R] if given) of every motion that goes
    somewhere."""
    cnc = cnc_class()
    cnc.initPath(0, 0, 0)
    moves = []
    for line in path.read_text().splitlines():
        words = cnc_class.parseLine(line)
        if words is None:
            continue
        cnc.motionStart(words)
        # A line of other words in the mode of arcs would be a circle.
        moves_axes = any(word[0].upper() in "XYZIJKR" for word in words)
        way = cnc.motionPath() if moves_axes else None
        cnc.motionEnd()
        if way:
            radius = [float(word[1:]) for word in words
                      if word[0].upper() == "R"]
            moves.append((cnc.gcode, way, radius))
    return moves


def difference(ours, theirs):
    # What goes nowhere is no motion there.
    at, moving = [0.0] * 3, []
    for move in ours:
        if move.kind > 2 or move.end[:3] != at:
            moving.append((at, move))
        at = move.end[:3]
    if len(moving) != len(theirs):
        return f"{len(moving)} motions, bCNC has {len(theirs)}"
    for i, ((start, move), (word, way, r)) in enumerate(zip(moving, theirs)):
        place = f"motion {i + 1}: "
        if word != move.kind - 1:
            return place + f"G{word} in bCNC, kind {move.kind} here"
        if math.dist(way[-1], move.end[:3]) > NEAR:
            return place + f"ends at {move.end[:3]}, in bCNC at {way[-1]}"
        # It draws R below 0, and R of other planes, about another centre.
        if move.kind < 3 or (r and (r[0] < 0 or move.plane != 0)):
            continue
        axes = [(0, 1), (2, 0), (1, 2)][move.plane]
        radius = math.dist([start[a] for a in axes], move.centre)
        turned = 0
        for one, next_one in zip(way, way[1:]):
            a, b = ([p[axis] - c for axis, c in zip(axes, move.centre)]
                    for p in (one, next_one))
            if abs(math.hypot(*b) - radius) > NEAR:
                return place + f"{next_one} is off the circle"
            turned += math.atan2(a[0] * b[1] - a[1] * b[0],
                                 a[0] * b[0] + a[1] * b[1])
        if (turned > 0) != (move.kind == 4):
            return place + "turns the other way in bCNC"
    return None


def main():
    cnc_class = reader()
    if cnc_class is None:
        print("SKIPPED: bCNC is not installed (Debian: bcnc); programs were "
              "not compared with its reader", file=sys.stderr)
        return 77
    tool, failures, checked = sys.argv[1], 0, 0
    with tempfile.TemporaryDirectory() as folder:
        out = pathlib.Path(folder) / "out.nc"
        for path in sys.argv[2:]:
            for tolerance in ("0", "0.005", "0.025"):
                for form in ("as_read", "centre", "radius"):
                    # The radius form cuts some arcs in two: as it is written.
                    subprocess.run([tool, path, tolerance, out, "grbl", form],
                                   check=True, stdout=subprocess.DEVNULL,
                                   stderr=subprocess.DEVNULL)
                    run = subprocess.run([tool, out], check=True,
                                         capture_output=True, text=True)
                    wrong = difference(our_moves(run.stdout),
                                       their_moves(cnc_class, out))
                    checked += 1
                    if wrong:
                        failures += 1
                        print(f"FAILED {path} at {tolerance}, {form}: {wrong}")
    print(f"{checked} comparisons, {failures} failed")
    return 1 if failures or checked == 0 else 0


if __name__ == "__main__":
    sys.exit(main())
