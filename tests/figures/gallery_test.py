#!/usr/bin/env python3
"""The pictures of docs/gallery.md: the same twice, the same as those in docs/figures, well formed, and with a label on
every axis.

Against the committed ones numbers may differ by half a point: some of the runs collide a hundred times under harmonic
motion, where a last digit of the processor's sine grows to what can just be seen.
"""

import os
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest
import xml.etree.ElementTree as xml

BENTUR = os.environ["BENTUR"]
SOURCE = pathlib.Path(os.environ["BENTUR_SOURCE"])
sys.path.insert(0, str(SOURCE / "tests/support"))
from same_picture import same_picture  # noqa: E402


def draw(folder):
    subprocess.run([sys.executable, SOURCE / "tools/gallery.py", BENTUR, SOURCE, folder], check=True)
    return {file.name: file.read_text() for file in pathlib.Path(folder).glob("*.svg")}


class Gallery(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        with tempfile.TemporaryDirectory() as first, tempfile.TemporaryDirectory() as second:
            cls.pictures, cls.again = draw(first), draw(second)

    def test_the_same_twice(self):
        self.assertEqual(self.pictures.keys(), self.again.keys())
        for name, picture in self.pictures.items():
            self.assertEqual(picture, self.again[name], name)

    def test_the_committed_ones(self):
        for name, picture in self.pictures.items():
            committed = (SOURCE / "docs/figures" / name).read_text()
            self.assertTrue(same_picture(picture, committed, 0.5), f"{name}: ./dev gallery draws it anew")

    def test_every_picture_of_the_page_is_there_and_no_other(self):
        pages = "".join((SOURCE / "docs" / page).read_text() for page in ("gallery.md", "performance.md"))
        shown = set(re.findall(r"\]\(figures/([^)]+)\)", pages))
        self.assertEqual(shown, {file.name for file in (SOURCE / "docs/figures").iterdir()})

    def test_numbers_have_the_sign_for_minus(self):
        signs = "".join(file.read_text() for folder in ("figures", "monograph") for file in (SOURCE / "docs" / folder).glob("*.svg"))
        self.assertEqual(re.findall(r"<text[^>]*>[^<]*(?<!\w)-\d[^<]*<", signs), [])
        self.assertGreater(len(re.findall(r">−\d", signs)), 50)

    def test_small_and_well_formed(self):
        for name, picture in self.pictures.items():
            self.assertLess(len(picture), 250_000, name)
            root = xml.fromstring(picture)
            texts = ["".join(text.itertext()) for text in root.iter("{http://www.w3.org/2000/svg}text")]
            if name.endswith(("-scene.svg", "-hinges.svg", "-frame-forces.svg")):
                continue  # have no axes
            # A label with a unit on both axes of at least one panel.
            self.assertGreaterEqual(len([text for text in texts if re.search(r"\[.+\]$", text)]), 2, f"{name}: {texts}")


if __name__ == "__main__":
    unittest.main()
