"""rsvg-convert draws our SVG, xmllint finds its syntax sound."""

import client


def render(work, name, width, height):
    # It exits 0 on bad path data, so only the picture tells.
    client.run("xmllint", "--noout", "--huge", work.path(name))
    png = client.run("rsvg-convert", "--unlimited", "-w", str(width), "-h",
                     str(height), work.path(name))
    return client.read_png(png)


def contours_are_exact(work):
    for name in client.RASTERS:
        client.convert(client.sample(name), work.path("a.svg"))
        client.convert(client.sample(name), work.path("a.pbm"))
        ink = client.read_pbm(work.read("a.pbm"))
        seen = render(work, "a.svg", ink.width, ink.height)
        different = ink.count_different(seen)
        print(f"{name}: {different} of {ink.width * ink.height} pixels differ")
        assert different == 0, name


def tolerances_hold(work):
    """Pixels that differ are within the tolerance of an edge, half a pixel's
    diagonal aside."""
    for name in ("crown.png", "glyph.pbm"):
        client.convert(client.sample(name), work.path("a.pbm"))
        ink = client.read_pbm(work.read("a.pbm"))
        distance = ink.edge_distances()
        for tolerance in (1, 2):
            client.convert(client.sample(name), work.path("a.svg"),
                           "--tolerance", str(tolerance))
            seen = render(work, "a.svg", ink.width, ink.height)
            farthest = max([distance(x, y) for y, (row, other) in
                            enumerate(zip(ink.rows, seen.rows))
                            for x, (a, b) in enumerate(zip(row, other))
                            if a != b] or [0])
            print(f"{name} at {tolerance}: pixels up to {farthest:.2f} from "
                  "an edge differ")
            assert farthest <= tolerance + 0.71, name


def arcs_are_where_they_belong(work):
    for scale in (1, 10, 16):
        for axis in ("up", "down"):
            shapes = client.Shapes(scale, axis)
            work.write("a.json", shapes.json())
            client.convert(work.path("a.json"), work.path("a.svg"))
            shapes.check(render(work, "a.svg", 200, 160), 0.71)


def strokes_are_drawn(work):
    shapes = client.Shapes(paint="stroke")
    work.write("a.json", shapes.json())
    client.convert(work.path("a.json"), work.path("a.svg"))
    seen = render(work, "a.svg", 200, 160)
    ink = sum(map(sum, seen.rows))
    # All edges together are 955 units long.
    assert 700 < ink < 1800, ink
    client.convert(client.sample("strokes.fc"), work.path("a.svg"))
    client.run("xmllint", "--noout", work.path("a.svg"))


def names_are_sound(work):
    text = client.Shapes().json().replace(
        '"shapes"', '"name": "<&\\"\\u00e4\\u0001>", "metadata": '
        '[["a<b", "c&d\\n"]], "shapes"')
    work.write("a.json", text)
    client.convert(work.path("a.json"), work.path("a.svg"))
    title = client.run("xmllint", "--xpath", "string(/*/*[local-name()="
                       "'title'])", work.path("a.svg"))
    assert title.decode().rstrip("\n") == '<&"\u00e4>', title


client.need("rsvg-convert")
client.need("xmllint")
with client.Workplace() as place:
    contours_are_exact(place)
    tolerances_hold(place)
    arcs_are_where_they_belong(place)
    strokes_are_drawn(place)
    names_are_sound(place)
