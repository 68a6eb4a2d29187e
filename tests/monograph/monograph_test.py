#!/usr/bin/env python3
"""docs/monograph: a fresh run writes the committed page and pictures, and its cases and studies meet the reference values.

The program under test is the environment variable BENTUR, the repository BENTUR_SOURCE. The record and the reference values
stand beside the repository, in ../shared; without them what needs them is skipped.
"""

import csv
import importlib.util
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest
import xml.etree.ElementTree as xml

BENTUR = os.environ["BENTUR"]
SOURCE = pathlib.Path(os.environ["BENTUR_SOURCE"]).resolve()
sys.path[:0] = [str(SOURCE / "tests"), str(SOURCE / "tests/support")]
from same_picture import same_picture  # noqa: E402
from shared_folder import SHARED  # noqa: E402

RECORD = SHARED / "records/el-centro-1940-s00e.txt"
NUMBER = re.compile(r"\d+(?:\.\d+)?")
OWN = ("calibrate_period = .*\n", "")


# Pictures with curves of these pairs.
CHAOTIC = {"figure-4-08.svg", "figure-b15.svg", "figure-b16.svg", "amplification-third-floor.svg", "contact-duration.svg"}


def words(line):
    """LINE without numbers, signs of differences and padding."""
    return re.sub(r"[ -]+", " ", re.sub(r"[+-](?=0)", "", NUMBER.sub("0", line)))


class Page(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = pathlib.Path(tempfile.mkdtemp(prefix="bentur-monograph-"))
        cls.addClassCleanup(shutil.rmtree, cls.folder)
        record = ["--record", RECORD] if RECORD.is_file() else []
        subprocess.run([sys.executable, SOURCE / "tools/monograph.py", BENTUR, SOURCE, cls.folder / "page", cls.folder / "work", *record],
                       check=True, timeout=280)
        cls.page = (cls.folder / "page/README.md").read_text()
        cls.committed = (SOURCE / "docs/monograph/README.md").read_text()

    def test_the_committed_page(self):
        """The same words; numbers within one unit of their last digit, which is round-off. Two pairs, one undamped, have chaotic
        motions (the page's section on sensitivity): what they do with contact may have other numbers on another machine."""
        chaotic_from = self.page[:self.page.index("## The conclusions in numbers")].count("\n")
        again = "; ./dev monograph --record ../shared/records/el-centro-1940-s00e.txt writes it anew"
        for line, (new, old) in enumerate(zip(self.page.splitlines(), self.committed.splitlines()), 1):
            self.assertEqual(words(new), words(old), f"line {line}{again}")
            if line > chaotic_from and re.match(r"\| (3-2 storeys|M1-4, harmonic)", new):
                continue
            for a, b in zip(NUMBER.findall(new), NUMBER.findall(old)):
                digits = len(b.partition(".")[2])
                self.assertLess(abs(float(a) - float(b)), 1.01 * 10 ** -digits, f"line {line}: {new}\n{old}{again}")
        self.assertEqual(len(self.page.splitlines()), len(self.committed.splitlines()))

    def test_the_committed_pictures(self):
        pictures = {file.name for file in (self.folder / "page").glob("*.svg")}
        self.assertEqual(pictures, {file.name for file in (SOURCE / "docs/monograph").glob("*.svg")})
        self.assertEqual(pictures, set(re.findall(r"\]\(([^)]+\.svg)\)", self.page)))
        for name in sorted(pictures):
            new, old = (folder.joinpath(name).read_text() for folder in (self.folder / "page", SOURCE / "docs/monograph"))
            if name not in CHAOTIC:
                self.assertTrue(same_picture(new, old, 0.05), name)  # of which 0.01 are written

    def test_every_axis_has_a_label_and_every_curve_is_there(self):
        for file in (self.folder / "page").glob("*.svg"):
            root = xml.fromstring(file.read_text())
            texts = ["".join(text.itertext()) for text in root.iter("{http://www.w3.org/2000/svg}text")]
            self.assertGreaterEqual(len([text for text in texts if re.search(r"\[.+\]$", text)]), 2, f"{file.name}: {texts}")
        for file in (self.folder / "work/data/examples/monograph").glob("*-data.csv"):
            with file.open(newline="") as stream:
                for column in zip(*csv.reader(stream)):
                    self.assertNotEqual(column[1], "", f"{file.name}: an empty curve: {column[0]}")

    def test_the_section_on_digitisation_names_its_record(self):
        """A run without a record, as in a fresh clone, keeps the committed section."""
        for text in (self.page, self.committed):
            section = text.split("<!-- digitisation -->")[1].split("<!-- /digitisation -->")[0]
            self.assertIn(f"`{RECORD.name}`", section)

    def test_periods_of_the_page(self):
        """Those of the printed sections, checked against another program."""
        for name, period in (("Model 1", "0.1440"), ("Model 2", "0.1627"), ("Model 3", "0.3083"), ("Model 4", "0.1114"), ("Two storeys", "0.0640")):
            row = next(line for line in self.page.splitlines() if line.startswith(f"| {name} "))
            self.assertEqual(row.split("|")[3].strip(), period)


@unittest.skipUnless(RECORD.is_file() and (SHARED / "reference").is_dir() and (SHARED / "tools/compare.py").is_file(),
                     "no reference values beside the repository")
class Reference(unittest.TestCase):
    """The cases from their own sections, which is what the reference values are of."""

    def check(self, reference, case, *changes):
        text = (SOURCE / f"examples/monograph/{case}.toml").read_text()
        for old, new in (OWN, *changes):
            self.assertRegex(text, old)
            text = re.sub(old, new, text)
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder) / "case.toml"
            file.write_text(text)
            actual = pathlib.Path(folder) / "actual.json"
            actual.write_text(subprocess.run([BENTUR, "run", file, "--json"], check=True, capture_output=True, text=True).stdout)
            result = subprocess.run([sys.executable, SHARED / "tools/compare.py", SHARED / f"reference/{reference}.expected.json", actual],
                                    capture_output=True, text=True)
            self.assertEqual(result.returncode, 0, f"{reference}\n{result.stdout}\n{result.stderr}")

    def width(self, value):
        return ("width = 0.0 ", f"width = {value} ")

    def duration(self, value):
        return ("duration = 10.0", f"duration = {value}")

    RECORD = ('file = "[^"]*"', f"file = {json.dumps(str(RECORD))}")

    def test_models_1_and_2_under_el_centro(self):
        self.check("m12-el-centro-touching", "m12-el-centro", self.RECORD)
        self.check("m12-el-centro-gap-02", "m12-el-centro", self.RECORD, self.width(0.2))
        self.check("m12-el-centro-gap-04", "m12-el-centro", self.RECORD, self.width(0.4))

    def test_models_1_and_2_harmonic(self):
        self.check("m12-harmonic-gap-02", "m12-harmonic", self.width(0.2), self.duration(6.0))

    def test_three_storeys_against_two(self):
        self.check("three-and-two-storeys-undamped", "m32-el-centro", self.RECORD, self.width(0.4), self.duration(5.0))


if __name__ == "__main__":
    if importlib.util.find_spec("netCDF4") is None:
        if sys.executable == "/usr/bin/python3" or subprocess.run(["/usr/bin/python3", "-c", "import netCDF4"], capture_output=True).returncode:
            print("skipped: no Python with netCDF4")
            sys.exit(77)
        os.execv("/usr/bin/python3", ["/usr/bin/python3", *sys.argv])
    unittest.main()
