"""pdftocairo draws our PDF, pdfinfo knows its pages."""

import json

import client


def render(work, resolution):
    client.run("pdftocairo", "-png", "-singlefile", "-r", str(resolution),
               work.path("a.pdf"), work.path("seen"))
    return client.read_png(work.read("seen.png"))


def contours_are_exact(work):
    for name, resolution in (("crown.png", 72), ("glyph.pbm", 72),
                             ("text-page.tif", 300)):
        client.convert(client.sample(name), work.path("a.pdf"))
        client.convert(client.sample(name), work.path("a.pbm"))
        ink = client.read_pbm(work.read("a.pbm"))
        different = ink.count_different(render(work, resolution))
        print(f"{name}: {different} of {ink.width * ink.height} pixels differ")
        assert different == 0, name


def arcs_are_where_they_belong(work):
    for scale in (1, 16):
        for axis in ("up", "down"):
            shapes = client.Shapes(scale, axis)
            work.write("a.json", shapes.json())
            client.convert(work.path("a.json"), work.path("a.pdf"))
            shapes.check(render(work, 127), 0.71)


def pages_have_sizes_and_a_title(work):
    document = json.loads(client.Shapes().json())
    document["pages"][0]["name"] = "\u00e4 (b)"
    document["pages"].append(dict(document["pages"][0], canvas=[127, 254]))
    work.write("a.json", json.dumps(document))
    client.convert(work.path("a.json"), work.path("a.pdf"))
    info = client.run("pdfinfo", "-f", "1", "-l", "2", work.path("a.pdf"))
    text = info.decode()
    assert "Pages:           2\n" in text, text
    assert "\u00e4 (b)" in text, text
    assert "Page    2 size:  72 x 144 pts" in text, text
    # Damaged tables are mended with a complaint; ours is sound.
    assert "Syntax" not in text and "xref" not in text, text


client.need("pdftocairo")
client.need("pdfinfo")
with client.Workplace() as place:
    contours_are_exact(place)
    arcs_are_where_they_belong(place)
    pages_have_sizes_and_a_title(place)
