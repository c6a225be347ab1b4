"""ezdxf reads our DXF, and its audit has nothing to say."""

import os
import sys

import client

try:
    import ezdxf
except ImportError:
    # Debian's package is for Debian's Python, which may not be the first.
    debian = "/usr/bin/python3"
    if sys.executable != debian and os.path.exists(debian) and \
            "UNSTEP_DXF_TRIED" not in os.environ:
        os.environ["UNSTEP_DXF_TRIED"] = "1"
        os.execv(debian, [debian, "-B"] + sys.argv)
    client.skip("python3-ezdxf is not installed")

from ezdxf import path as dxf_path


def read(work):
    document = ezdxf.readfile(work.path("a.dxf"))
    audit = document.audit()
    assert not audit.errors, [e.message for e in audit.errors]
    assert not audit.fixes, [e.message for e in audit.fixes]
    return document


def outlines(document):
    for entity in document.modelspace():
        yield [(p.x, p.y)
               for p in dxf_path.make_path(entity).flattening(0.00005)]


def area(points):
    return abs(sum(x1 * y2 - x2 * y1 for (x1, y1), (x2, y2) in
                   zip(points, points[1:] + points[:1]))) / 2


def shapes_are_where_they_belong(work):
    for scale in (1, 16, 100):
        for axis in ("up", "down"):
            shapes = client.Shapes(scale, axis)
            work.write("a.json", shapes.json())
            client.convert(work.path("a.json"), work.path("a.dxf"))
            document = read(work)
            assert document.header["$INSUNITS"] == 1
            count = 0
            for points in outlines(document):
                count += 1
                for x, y in points:
                    # Inches, y up, back to the grid.
                    x, y = x * 127, y * 127
                    if axis == "down":
                        y = 160 - y
                    near = min(abs(d) for d in shapes.signed_distances(x, y))
                    # ezdxf takes cubic curves for arcs.
                    assert near < 0.03, (x, y, near)
            assert count == 5, count
            areas = sorted(area(points) * 127 * 127
                           for points in outlines(document))
            expected = sorted([7853.98, 2827.43, 1906.86, 1472.62, 176.71])
            for seen, wanted in zip(areas, expected):
                assert abs(seen - wanted) < 0.01 * wanted, (areas, expected)


def rows_of(document, unit):
    """What even-odd filling makes of outlines along the pixels' edges: for
    each row, counted upwards, where ink begins and ends."""
    rows = {}
    for entity in document.modelspace():
        points = [(round(v.dxf.location.x * unit), round(v.dxf.location.y *
                                                         unit))
                  for v in entity.vertices]
        for (x, y), (x2, y2) in zip(points, points[1:] + points[:1]):
            assert x == x2 or y == y2, "an edge that is not of a pixel"
            for row in range(min(y, y2), max(y, y2)):
                rows.setdefault(row, []).append(x)
    return rows


def contours_hold_the_ink(work):
    for name in client.RASTERS:
        client.convert(client.sample(name), work.path("a.dxf"))
        client.convert(client.sample(name), work.path("a.pbm"))
        ink = client.read_pbm(work.read("a.pbm"))
        document = read(work)
        unit = {0: 1, 1: 300}[document.header["$INSUNITS"]]
        rows = rows_of(document, unit)
        for row, pixels in enumerate(ink.rows):
            edges = sorted(rows.get(ink.height - 1 - row, []))
            seen = bytearray(ink.width)
            for begin, end in zip(edges[::2], edges[1::2]):
                seen[begin:end] = b"\1" * (end - begin)
            assert seen == pixels, (name, row)
        print(f"{name}: the outlines hold the ink")


def strokes_are_sound(work):
    client.convert(client.sample("strokes.fc"), work.path("a.dxf"))
    assert len(read(work).modelspace()) > 5


with client.Workplace() as place:
    shapes_are_where_they_belong(place)
    contours_hold_the_ink(place)
    strokes_are_sound(place)
