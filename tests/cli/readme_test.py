"""What README.md says of the samples is what the program does."""

import pathlib
import re

import harness

ROOT = pathlib.Path(__file__).resolve().parents[2]
SAMPLES = {
    "book page": "text-page.tif",
    "engraved music": "score-2pages.tif",
    "circuit diagram": "schematic.tif",
    "coast lines": "coast.png",
    "chemical formula": "molecule-8bit.png",
    "icon": "crown.png",
    "pen stroke": "glyph.pbm",
}


class Readme(harness.CliTest):
    def test_bytes_of_the_samples(self):
        text = (ROOT / "README.md").read_text("utf-8")
        rows = re.findall(r"^\| ([a-z ]+).*\*\*(\d+)\*\* \|$", text, re.M)
        told = {name.strip(): int(size) for name, size in rows}
        made = {}
        for name, file in SAMPLES.items():
            out = self.path("sample.ustp")
            self.expect(["compress", "-qf", str(ROOT / "samples" / file),
                         "-o", out])
            made[name] = pathlib.Path(out).stat().st_size
        self.assertEqual(told, made)


if __name__ == "__main__":
    harness.main()
