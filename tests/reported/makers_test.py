#!/usr/bin/env python3
"""Every file that the makers of public files write comes out right, or is refused for its reason.

They make records of networks, models of ETABS and blocks of houses, with values that follow from formulas. Skipped where
they are not beside the sources. Environment: BENTUR, BENTUR_SOURCE."""

import json
import math
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

sys.path.insert(0, os.path.join(os.environ["BENTUR_SOURCE"], "tests"))
from shared_folder import SHARED

BENTUR = os.environ["BENTUR"]
MAKERS = SHARED / "findings" / "cases" / "public"


def bentur(*arguments):
    return subprocess.run([BENTUR, *map(str, arguments)], capture_output=True, text=True, timeout=120)


class Makers(unittest.TestCase):
    maker = None

    @classmethod
    def setUpClass(cls):
        script = MAKERS / f"{cls.maker}.py"
        if not script.exists():
            raise unittest.SkipTest("the makers of public files are not beside the sources")
        cls.folder = pathlib.Path(tempfile.mkdtemp(prefix="bentur-makers-"))
        cls.addClassCleanup(shutil.rmtree, cls.folder)
        made = subprocess.run([sys.executable, script], cwd=cls.folder, capture_output=True, text=True)
        assert made.returncode == 0, made.stderr
        cls.made = {file.name for file in cls.folder.iterdir()}

    def refused(self, *arguments):
        result = bentur(*arguments)
        self.assertEqual(result.returncode, 2, f"{arguments}\n{result.stdout}")
        return result.stderr.replace(f"{self.folder}/", "")

    def answered(self, *arguments):
        result = bentur(*arguments)
        self.assertEqual(result.returncode, 0, f"{arguments}\n{result.stderr}")
        return result.stdout + result.stderr


def wave(amplitude, count=400):
    """The values of the maker's records, from a formula."""
    return [amplitude * math.sin(0.1 * i) for i in range(count)]


def without_mean(values):
    return [value - sum(values) / len(values) for value in values]


class Records(Makers):
    maker = "make_records"
    three = {"N-S": wave(100), "E-W": wave(50), "U-D": wave(25)}
    # format, unit, step, accuracy of the values as they are written, and values by component; None: a file of one
    right = {
        "geonet-one.V2A": ("geonet", "mm/s2", 0.02, 0.1, {None: wave(1000)}),
        "afad.txt": ("afad", "cm/s2", 0.01, 1e-6, three),
        "asa.dat": ("asa", "cm/s2", 0.005, 1e-4, {"E-W": wave(100), "N00E": wave(50), "V": wave(25)}),
        "knet.csv": ("knet-csv", "cm/s2", 0.01, 0.01,
                     {"N-S": without_mean(wave(100)), "E-W": without_mean(wave(50)), "U-D": without_mean(wave(20))}),
        "touching.acc": ("values", "m/s2", 0.005, 1e-7, {None: wave(1)}),
        "csmip-f9.RAW": ("csmip", "g", 0.005, 1e-6, {None: wave(0.1)}),
        "pairs-g10.V1": ("csmip", "g", 0.01, 1e-4, {None: wave(0.1)}),
        "simcenter.AT2": ("peer-at2", "g", 0.02, 1e-5, {None: wave(0.1)}),
    }

    def test_every_file_has_its_answer(self):
        self.assertEqual(self.made, {*self.right, "geonet.V2A"})

    def test_each_component_is_that_of_the_formula(self):
        for name, (kind, unit, step, digit, components) in self.right.items():
            for component, values in components.items():
                with self.subTest(file=name, component=component):
                    chosen = ["--component", component] if component else []
                    of = ["--periods", "0.1:2:7", "--json"]
                    found = json.loads(self.answered("spectrum", self.folder / name, *chosen, *of))
                    record = found["record"]
                    self.assertEqual((record["format"], record["unit"], record["count"]), (kind, unit, len(values)))
                    self.assertAlmostEqual(record["time_step"], step, delta=1e-12)
                    peak = max(map(abs, values))
                    self.assertAlmostEqual(record["pga_read"], peak, delta=0.51 * digit)
                    # The same motion in two columns has the same spectrum, to the digits of the file.
                    plain = self.folder.parent / f"{self.folder.name}-plain.csv"
                    self.addCleanup(plain.unlink, missing_ok=True)
                    plain.write_text("".join(f"{step * i:.6f},{value:.9g}\n" for i, value in enumerate(values)))
                    expected = json.loads(self.answered("spectrum", plain, "--unit", unit, *of))
                    for key in ("displacement", "absolute_acceleration"):
                        for a, b in zip(found[key], expected[key], strict=True):
                            self.assertAlmostEqual(a / b, 1, delta=4 * digit / peak + 1e-6)

    def test_three_components_are_chosen_not_guessed(self):
        told = self.refused("spectrum", self.folder / "geonet.V2A")
        self.assertIn('has 3 channels of accelerations: say in --channel or --component which one', told)
        for channel in (1, 2, 3):
            found = json.loads(self.answered("spectrum", self.folder / "geonet.V2A", "--channel", channel, "--json"))
            self.assertAlmostEqual(found["record"]["pga_read"], max(map(abs, wave(1000))), delta=0.06)
        for name in ("afad.txt", "asa.dat", "knet.csv"):
            self.assertIn("has 3 channels of accelerations", self.refused("spectrum", self.folder / name))

    def test_what_a_user_says_against_the_heading_is_refused(self):
        """Whatever step, unit and format somebody gives who does not read the heading."""
        for name, (_, unit, step, _, components) in self.right.items():
            chosen = ["--component", next(iter(components))] if None not in components else []
            for wrong in (["--time-step", 2 * step], ["--unit", "g" if unit != "g" else "m/s2"]):
                with self.subTest(file=name, wrong=wrong):
                    told = self.refused("spectrum", self.folder / name, *chosen, *wrong)
                    self.assertRegex(told, r"--(time-step|unit) is .*, but the file says")
        asked = "--column 1 --time-step 0.01 --unit g".split()
        told = self.refused("spectrum", self.folder / "asa.dat", *asked)  # 100 g, as it was once read
        self.assertIn('--time-step is 0.01 s, but the file says 0.005 s in line 5', told)
        self.assertIn('--unit is "g", but the file says "cm/s2" in line 9', told)
        asked = "--format values --time-step 0.02 --unit mm/s2".split()
        told = self.refused("spectrum", self.folder / "geonet-one.V2A", *asked)  # 6.68 g, as it was once read
        self.assertIn("is a geonet file, whose numbers are not accelerations alone", told)


NEIGHBOUR = """[[building]]
name = "Wall"
rigid = true
elevations = [{height!r}]
[[gap]]
between = ["Imported", "Wall"]
width = {width!r}
contact = {{ law = "linear", stiffness = {stiffness!r} }}
[excitation]
kind = "harmonic"
period = 0.4
displacement_amplitude = {width!r}
[analysis]
duration = 1
"""


class Models(Makers):
    maker = "make_e2k"
    # First periods with 30 t a floor by a model of its own in numpy: cubic beams with consistent masses, axially rigid,
    # rotations condensed. Columns of version 9 have no mass (MMOD 0); line modifiers are 0.5 in place of 0.7 and 0.35.
    new, old = 0.8018896362, 0.7680336673
    period = {"v9": old, "similar": old, "rigid": old, "comma": old, "mass": old, "v19": new, "v19long": new, "mm": new,
              "kipin": new, "tonf": new, "kgfcm": new, "linemod": 0.7913201091, "tee": 0.6850972}
    metre = {"m": 1.0, "cm": 100.0, "mm": 1000.0, "in": 1 / 0.0254}
    kilonewton = {"kN": 1.0, "N": 1000.0, "kgf": 1000 / 9.80665, "tf": 1 / 9.80665, "kip": 1 / 4.4482216153}

    def test_every_file_has_its_answer(self):
        self.assertEqual({name.removesuffix(".e2k") for name in self.made}, {*self.period, "pinned"})

    def test_frames_have_the_periods_of_their_models(self):
        for name, period in self.period.items():
            with self.subTest(file=name):
                text = self.answered("import", self.folder / f"{name}.e2k").split("\n")
                text = "\n".join(line for line in text if not re.match(r".*: not read: |taken: ", line))
                length, force = (re.search(rf'^{key} = "(\w+)"', text, re.M)[1] for key in ("length", "force"))
                metre, kilonewton = self.metre[length], self.kilonewton[force]
                self.assertEqual("floor_masses" in text, name == "mass")
                case = text.replace("# damping = 0.05", "damping = 0.05")
                if name != "mass":
                    case += f"floor_masses = {30 * kilonewton / metre!r}\n"
                case += NEIGHBOUR.format(height=4 * metre, width=0.05 * metre, stiffness=1e5 * kilonewton / metre)
                file = self.folder.parent / f"{self.folder.name}-{name}.toml"
                self.addCleanup(file.unlink, missing_ok=True)
                file.write_text(case)
                found = json.loads(self.answered("modes", file, "--json"))["buildings"][0]["periods"][0]
                self.assertAlmostEqual(found / period, 1, delta=1e-6)

    def test_supports_that_give_way_are_errors(self):
        told = self.refused("import", self.folder / "pinned.e2k")
        for line, point in ((26, 1), (27, 2), (28, 3)):
            self.assertIn(f'pinned.e2k:{line}:1: error: RESTRAINT of point "{point}" at "BASE" leaves RY free', told)

    def test_what_is_not_read_is_named(self):
        told = self.answered("import", self.folder / "rigid.e2k")
        self.assertIn("LENGTHOFFI, LENGTHOFFJ, RIGIDZONE of LINE ASSIGNS", told)
        self.assertIn("taken: masses at joints of the frame are its floor_masses",
                      self.answered("import", self.folder / "mass.e2k"))
        for name in self.period:
            self.assertIn('taken: the mass of columns of storey "STORY1" times 0' if self.period[name] == self.old
                          else "not read: ", self.answered("import", self.folder / f"{name}.e2k"))


class Blocks(Makers):
    maker = "make_geojson"
    # storeys, of all houses but those of 4, and a height that is not 3 m a storey [m]
    four = ({}, None)
    right = {
        "z3d": four, "points": four, "crs84": four, "epsg4326": four, "multi1": four, "bom": four, "nl": four,
        "dup": four, "levels_float": four, "levels_strfloat": four, "underground": four, "num_floors": four,
        "levels_half": four, "levels_semicolon": four, "levels_range": ({"way/101": 3}, None),
        "levels_plus": ({"way/101": 5}, None), "minlevel": ({"way/101": 6}, None),
        "tags": ({"way/100": 3}, None), "levels_null": ({}, 12.0), "roof": ({"way/101": 3}, 12.0),
        "overture": ({}, 12.8), "height_ft": ({}, 12.192), "height_ft2": ({}, 12.192), "height_ftin": ({}, 12.344),
        "height_comma": ({}, 12.5), "height_m": ({}, 12.5), "height_huge": ({"way/101": 2}, 60.0),
    }
    refusals = {
        "levels_zero": "building:levels = 0, must be a whole number from 1 to 200",
        "levels_null2": "has neither storeys (building:levels) nor a height",
        "height_minus1": "height = -1.0, must be metres in (0, 1000]",
        "height_tiny": "has storeys of 0.75 m, must be in [1.5, 30] m",
        "nullgeom": 'features without geometry are left out: "way/101"',
        "poly_unclosed": "must end where it begins (RFC 7946, 3.1.6)",
        "bowtie": "must go round once",
        "same_twice": 'overlaps "way/100" by 10 m',
        "part": 'overlaps "way/100" by 10 m',
        "utm": "must be WGS 84 (CRS84), in degrees; give --metres where coordinates are metres",
        "single": "has 1 polygon, a block has two or more",
    }

    def test_every_file_has_its_answer(self):
        self.assertEqual({name.removesuffix(".geojson") for name in self.made}, {*self.right, *self.refusals})

    def test_houses_have_their_storeys(self):
        for name, (others, height) in self.right.items():
            with self.subTest(file=name):
                file = self.folder.parent / f"{self.folder.name}-{name}.toml"
                self.addCleanup(file.unlink, missing_ok=True)
                self.answered("import", self.folder / f"{name}.geojson", "-o", file)
                self.answered("check", file)
                found = {}
                for house in re.split(r"^\[\[building\]\]", file.read_text(), flags=re.M)[1:]:
                    called = re.search(r'^name = "(.*?)"', house, re.M)[1]
                    found[called] = json.loads(re.search(r"^storey_heights = (\[.*?\])", house, re.M | re.S)[1])
                self.assertGreaterEqual(len(found), 2)
                for called, storeys in found.items():
                    self.assertEqual(len(storeys), others.get(called, 4), called)
                heights = {round(sum(one), 3) for one in found.values()}
                self.assertLessEqual(heights, {3.0 * n for n in (3, 4, 5, 6)} | {height})
                if height:
                    self.assertIn(height, heights)

    def test_what_is_no_block_is_refused_for_its_reason(self):
        for name, why in self.refusals.items():
            with self.subTest(file=name):
                told = self.refused("import", self.folder / f"{name}.geojson")
                self.assertIn(why, told)
                if name in ("levels_zero", "height_minus1", "same_twice", "part", "bowtie"):
                    self.assertIn("--without", told)


if __name__ == "__main__":
    unittest.main()
