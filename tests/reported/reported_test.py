#!/usr/bin/env python3
"""Cases that readers found reported wrongly, as the command line answers them now.

Inputs are beside this file, in cases/. Environment: BENTUR, BENTUR_SOURCE, BENTUR_SANITIZED."""

import csv
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
from part import part_under_sanitizers

BENTUR = os.environ["BENTUR"]
SOURCE = pathlib.Path(os.environ["BENTUR_SOURCE"])
CASES = SOURCE / "tests" / "reported" / "cases"


def bentur(*arguments):
    return subprocess.run([BENTUR, *map(str, arguments)], capture_output=True, text=True, timeout=120)


class Reported(unittest.TestCase):
    def setUp(self):
        self.folder = pathlib.Path(tempfile.mkdtemp(prefix="bentur-reported-"))
        self.addCleanup(shutil.rmtree, self.folder)

    def output(self, *arguments):
        result = bentur(*arguments)
        self.assertEqual(result.returncode, 0, f"{arguments}\n{result.stderr}")
        return result.stdout

    def said(self, *arguments):
        """What is printed, without line breaks."""
        return " ".join(self.output(*arguments).split())

    def json(self, command, case):
        return json.loads(self.output(command, case, "--json"))

    def edited(self, case, *changes):
        """A copy of a case with texts replaced, that finds the records of the first."""
        text = (CASES / case).read_text()
        for old, new in changes:
            self.assertIn(old, text)
            text = text.replace(old, new)
        text = re.sub(r'file = "(?!/)', f'file = "{CASES}/', text)
        file = self.folder / case
        file.write_text(text)
        return file


class HingesThatHaveFailed(Reported):
    """Nothing holds them, and they turn either way between events."""

    def test_a_failed_hinge_is_followed_in_both_directions(self):
        summary = self.json("run", CASES / "beam-hinges-fail.toml")
        frame = summary["buildings"][0]
        # Beam ends without moments: the joints of a portal turn by 1.5 u/h.
        by_hand = 1.5 * frame["peak_displacement"][0] / 3.0
        for hinge in frame["hinges"]:
            self.assertAlmostEqual(hinge["peak_rotation"] / by_hand, 1, delta=1e-9)
            self.assertAlmostEqual(hinge["rotation_demand"][1], by_hand / 0.01, delta=1e-6)
            self.assertGreaterEqual(hinge["peak_rotation"], abs(hinge["residual_rotation"]))
            self.assertIsNotNone(hinge["failed_time"])
        self.assertAlmostEqual(by_hand, 0.01632, delta=1e-5)
        self.assertRegex(self.said("run", CASES / "beam-hinges-fail.toml"), "beyond LS")

    def test_thrown_to_either_side_it_is_the_same_frame(self):
        right = self.json("run", CASES / "column-hinges-fail.toml")
        left = self.json("run", self.edited("column-hinges-fail.toml", ("A = [1.0]", "A = [-1.0]")))
        of = [[(hinge["line"], hinge["end"], hinge["peak_rotation"], hinge["half_cycles"])
               for hinge in one["buildings"][0]["hinges"]] for one in (right, left)]
        self.assertEqual(len(of[0]), 4)
        for line, end, rotation, cycles in of[0]:
            same = next(one for one in of[1] if one[:2] == (3 - line, end))
            self.assertAlmostEqual(rotation / same[2], 1, delta=1e-9)
            self.assertAlmostEqual(rotation, 0.1163, delta=1e-4)
            self.assertEqual(cycles, same[3])
        for motion in (["A = [1.0]"], ["A = [-1.0]"]):
            case = self.edited("column-hinges-fail.toml", ("A = [1.0]", motion[0]))
            self.assertRegex(self.said("run", case), "beyond CP.* 3.877 times")


class UnevenStoreys(Reported):
    """Whose backbones differ to the right and to the left."""

    def test_ductility_is_over_the_yield_drift_of_the_side(self):
        weak_left = CASES / "weak-to-the-left.toml"
        summary = self.json("run", weak_left)
        # Δ_y = 100 kN/10 MN/m on the side to which it goes.
        drift = summary["buildings"][0]["peak_displacement"][0]
        self.assertAlmostEqual(summary["buildings"][0]["ductility"][0], drift / 0.01, delta=1e-9)
        self.assertAlmostEqual(summary["buildings"][0]["ductility"][0], 42.2986, delta=1e-3)
        slow = self.json("run", self.edited("weak-to-the-left.toml", ("A = [-1.0]", "A = [-0.25]")))
        self.assertAlmostEqual(slow["buildings"][0]["ductility"][0],
                               slow["buildings"][0]["peak_displacement"][0] / 0.01, delta=1e-9)
        self.assertRegex(self.said("run", self.edited("weak-to-the-left.toml", ("A = [-1.0]", "A = [-0.25]"))),
                         r"Storey 1 of A reaches a ductility of 3\.6")

    def test_wear_is_the_same_in_a_mirror(self):
        # Both buildings as they move without contact, up to where one falls, so that no gap needed is known.
        found = []
        for case in ("wears-unevenly.toml", "wears-unevenly-mirrored.toml"):
            summary = self.json("run", CASES / case)
            self.assertIsNone(summary["gaps"][0]["gap_needed"])
            found.append({one["name"]: one["peak_displacement_no_contact"] for one in summary["buildings"]})
        for name in ("B0", "B1"):
            for one, other in zip(found[0][name], found[1][name]):
                self.assertAlmostEqual(one / other, 1, delta=1e-9)
        # By the positive side's wear the sum was 0.517109 in one of both.
        self.assertAlmostEqual(found[0]["B0"][0] + found[0]["B1"][0], 0.590429, delta=1e-5)


class TheLeastGapOfARow(Reported):
    def test_what_was_asked_comes_before_the_other_gaps(self):
        said = self.said("remedy", SOURCE / "examples" / "row-of-three.toml")
        self.assertRegex(said, r"^Row of three[^:]*?El Centro TOO SMALL: The least gap that keeps West and Middle apart")
        self.assertIn("Another gap closes.", said)


class EdgesThatAreNotParallel(Reported):
    def test_the_gap_needed_is_one_number_at_every_door(self):
        case = CASES / "oblique-edges.toml"
        gap = self.json("run", case)["gaps"][0]
        self.assertAlmostEqual(gap["gap_needed"], 0.2089465, delta=1e-6)
        self.assertAlmostEqual(gap["gap_needed_reversed"], 0.2237983, delta=1e-6)
        for command in ("run", "gap"):
            self.assertRegex(self.said(command, case), r"0\.2089 m")
        self.assertRegex(self.said("remedy", case), r"0\.224 m at every level")
        # With a little more than that they stay apart, with a little less they do not.
        for shift, pounds in ((-0.235 + 0.2089465 * 1.001, False), (-0.235 + 0.2089465 * 0.998, True)):
            text = (CASES / "oblique-edges.toml").read_text()
            normal = gap["normal"]
            corner = [3.6141 + shift * normal[0], -7.7242 + shift * normal[1]]
            moved = self.folder / "moved.toml"
            moved.write_text(text.replace("corner = [3.6141, -7.7242]", f"corner = {corner}"))
            impacts = sum(point["impacts"] for point in self.json("run", moved)["gaps"][0]["points"])
            self.assertEqual(impacts > 0, pounds, shift)


class CollapseInPlan(Reported):
    def test_a_collapse_is_a_result_and_no_failure(self):
        result = bentur("ida", CASES / "collapse-in-plan-ida.toml", "-o", self.folder / "plan.nc")
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertRegex(result.stdout + result.stderr, r"\b0 failed")
        fitted = self.said("fragility", self.folder / "plan.nc", "--event", "collapsed >= 1")
        self.assertRegex(fitted, "collapsed >= 1")
        self.assertEqual(self.json("run", CASES / "collapse-in-plan.toml")["collapsed"], 0)


class ContactsFromRest(Reported):
    def impacts_of(self, case):
        self.output("run", case, "-q", "-o", self.folder / "results")
        with open(self.folder / "results" / "impacts.csv", encoding="utf-8") as file:
            return list(csv.DictReader(file))

    def test_an_impact_from_rest_has_no_restitution(self):
        for case in ("touching-hertz-damp.toml", "touching-hertz-damp-in-plan.toml"):
            with self.subTest(case):
                impacts = self.impacts_of(CASES / case)
                self.assertGreater(len(impacts), 4)
                for impact in impacts:
                    self.assertLess(float(impact["restitution"] or 0), 2)
                self.assertTrue(any(impact["restitution"] == "" for impact in impacts))

    def test_bounces_on_the_way_to_rest_are_counted_apart(self):
        counts = []
        for mass in ("1e5", "1.0000000000001e5", "1.0000000000003e5", "0.9999999999998e5"):
            case = self.edited("coming-to-rest.toml", ("masses = [1e5]", f"masses = [{mass}]"))
            point = self.json("run", case)["gaps"][0]["points"][0]
            counts.append(point["impacts"])
            self.assertGreater(point["settling"], 20)
            listed = self.impacts_of(case)
            self.assertEqual(len(listed), point["impacts"] + point["settling"])
            self.assertEqual(sum(impact["settling"] == "1" for impact in listed), point["settling"])
            self.assertAlmostEqual(sum(float(impact["impulse [N s]"]) for impact in listed) / point["impulse"], 1,
                                   delta=1e-9)
            self.assertRegex(self.said("run", case), rf"collide {counts[0]} times")
        self.assertEqual(len(set(counts)), 1, counts)


class WallsInPlan(Reported):
    def test_a_wall_in_plan_says_what_one_in_a_row_says(self):
        wall = next(one for one in self.json("run", CASES / "touching-hertz-damp-in-plan.toml")["buildings"]
                    if one["name"] == "W")
        self.assertEqual(wall["periods"], [])
        self.assertEqual(wall["peak_rotation"], [0])


class Joints(Reported):
    def test_rotations_that_no_equation_determines_are_said_to_be(self):
        text = self.said("run", CASES / "balanced-joint.toml")
        self.assertRegex(text, "At 1 joints? of A the capacities of the members balance exactly")
        harder = self.edited("balanced-joint.toml", ("hardening = 0.0", "hardening = 0.01"))
        self.assertNotRegex(self.said("run", harder), "balance exactly")


class WhatAnEngineerReads(Reported):
    def test_a_column_beyond_its_capacity_is_said_first(self):
        case = SOURCE / "examples/struck-column.toml"
        verdict = self.output("run", case).split("\n\n")[1]
        self.assertRegex(verdict, r"^COLUMN FAILS IN SHEAR: D/C 2\.416 in the column of Office at level 19\.4 m")
        report = self.folder / "report.html"
        self.output("report", case, "-o", report)
        badge, sentence = re.findall(r"<p[^>]*>(.*?)</p>", report.read_text().split('id="verdict"')[1], re.S)[:2]
        self.assertEqual(badge, "Column fails in shear")
        self.assertRegex(sentence, r"^<strong>D/C 2\.416 in the column of Office")


def load_tests(loader, tests, pattern):
    return part_under_sanitizers(tests, 6)


if __name__ == "__main__":
    unittest.main()
