"""hp2xx plots our HPGL. It crops to what is drawn, so the place of the picture
follows from the shapes."""

import math

import client

# A pixel is 8 plotter units at 127 dpi; lines are a pixel wide.
RESOLUTION = 127


def plot(work, name):
    # It may wait for a key for ever.
    client.run("timeout", "50", "hp2xx", "-q", "-t", "-m", "pbm", "-p", "1",
               "-d", str(RESOLUTION), "-f", work.path("seen.pbm"),
               work.path(name))
    return cropped(client.read_pbm(work.read("seen.pbm")))


def cropped(raster):
    """Without the margins that the program adds."""
    rows = list(raster.rows)
    while not any(rows[0]):
        rows.pop(0)
    while not any(rows[-1]):
        rows.pop()
    left = min(row.index(1) for row in rows if any(row))
    rows = [row[left:] for row in rows]
    return client.Raster(len(rows[0]), len(rows), rows)


def edge_points(shapes):
    """Points along every edge, less than half a unit apart."""
    for (x, y), path in shapes.PATHS:
        for element in path:
            dx, dy = element[0], element[1]
            if len(element) == 2:
                for i in range(201):
                    yield x + dx * i / 200, y + dy * i / 200
            else:
                cx, cy = x + element[2], y + element[3]
                begin = math.atan2(y - cy, x - cx)
                turn = math.atan2(y + dy - cy, x + dx - cx) - begin
                ascending = element[4] == "ccw"
                if ascending and turn <= 0:
                    turn += 2 * math.pi
                if not ascending and turn >= 0:
                    turn -= 2 * math.pi
                radius = math.hypot(element[2], element[3])
                for i in range(1001):
                    angle = begin + turn * i / 1000
                    yield (cx + radius * math.cos(angle),
                           cy + radius * math.sin(angle))
            x, y = x + dx, y + dy


def outlines_are_where_they_belong(work):
    for scale in (1, 16):
        for axis in ("up", "down"):
            shapes = client.Shapes(scale, axis)
            work.write("a.json", shapes.json())
            client.convert(work.path("a.json"), work.path("a.hpgl"))
            seen = plot(work, "a.hpgl")
            points = list(edge_points(shapes))
            left = min(x for x, y in points)
            # The first row is the highest y of a plot.
            top = min(y for x, y in points) if axis == "down" else \
                max(y for x, y in points)

            def pixel(x, y):
                return (x - left, y - top if axis == "down" else top - y)

            # Every edge is drawn, and nothing but edges.
            near = set()
            for x, y in points:
                column, row = (round(v) for v in pixel(x, y))
                around = [(column + i, row + j) for i in (-1, 0, 1)
                          for j in (-1, 0, 1)]
                near.update(around)
                assert any(0 <= r < seen.height and 0 <= c < seen.width and
                           seen.rows[r][c] for c, r in around), (x, y)
            for row in range(seen.height):
                for column in range(seen.width):
                    assert not seen.rows[row][column] or \
                        (column, row) in near, (column, row)


def contours_keep_their_place(work):
    """The plotted contours of a glyph are the edges between ink and paper."""
    client.convert(client.sample("glyph.pbm"), work.path("a.pbm"))
    ink = client.read_pbm(work.read("a.pbm"))
    client.convert(client.sample("glyph.pbm"), work.path("a.json"))
    text = work.read("a.json").decode()
    work.write("b.json", text.replace(
        '"shapes"', '"resolution":{"x":[127,1],"y":[127,1],"unit":"inch"},'
        '"shapes"'))
    client.convert(work.path("b.json"), work.path("b.hpgl"))
    seen = plot(work, "b.hpgl")
    rows = [i for i, row in enumerate(ink.rows) if any(row)]
    columns = [min(i for i, v in enumerate(row) if v)
               for row in ink.rows if any(row)]
    top, left = rows[0], min(columns)

    def at(column, row):
        inside = 0 <= row < ink.height and 0 <= column < ink.width
        return ink.rows[row][column] if inside else 0

    different = 0
    for row in range(seen.height):
        for column in range(seen.width):
            around = {at(left + column + i, top + row + j)
                      for i in (-2, -1, 0, 1) for j in (-2, -1, 0, 1)}
            if seen.rows[row][column] and len(around) == 1:
                different += 1
    print(f"glyph.pbm: {different} plotted pixels away from an edge")
    assert different == 0
    assert sum(map(sum, seen.rows)) > 300


client.need("hp2xx")
client.need("timeout")
with client.Workplace() as place:
    outlines_are_where_they_belong(place)
    contours_keep_their_place(place)
