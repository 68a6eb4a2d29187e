#!/usr/bin/env python3
"""Cases that readers found told wrong, as the command line answers them now. Environment: BENTUR, BENTUR_SOURCE."""

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

BENTUR = os.environ["BENTUR"]
SOURCE = pathlib.Path(os.environ["BENTUR_SOURCE"])
CASES = SOURCE.parent / "shared" / "findings" / "cases"


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

    def json(self, command, case):
        return json.loads(self.output(command, case, "--json"))

    def edited(self, case, name, *changes):
        """A copy of a case with texts replaced, that finds the records of the first."""
        text = (CASES / case).read_text()
        for old, new in changes:
            self.assertIn(old, text)
            text = text.replace(old, new)
        text = text.replace('file = "../../../', f'file = "{CASES.parent.parent}/')
        text = re.sub(r'file ?= ?"([a-z0-9]+\.txt)"', lambda found: f'file = "{(CASES / case).parent}/{found[1]}"', text)
        file = self.folder / name
        file.write_text(text)
        return file


class ImpactsThatWereLost(Reported):
    """A building that stands exactly still beside one that yields."""

    def test_run_with_files_and_audit_finds_the_impacts_of_run(self):
        for name, impacts, force in [("missed-minimal", 1, 383519), ("missed-70038", 1, 445799.6),
                                     ("missed-70095", 1, 217439.3), ("delay-2135", 3, 2342360)]:
            with self.subTest(name):
                case = CASES / "missed" / f"{name}.toml"
                plain = self.json("run", case)
                points = plain["gaps"][0]["points"]
                self.assertEqual(sum(p["impacts"] for p in points), impacts)
                self.assertAlmostEqual(max(p["peak_force"] for p in points) / force, 1, delta=1e-5)
                self.output("run", case, "-q", "-o", self.folder / name)
                written = json.loads((self.folder / name / "summary.json").read_text())
                self.assertEqual(written["gaps"], plain["gaps"])
                self.assertEqual(written["buildings"], plain["buildings"])
                old = (CASES / "missed" / f"{name}.toml").read_text()
                heads = "[analysis]\n" if "[analysis]\n" in old else "[analysis]"
                audited = self.edited(f"missed/{name}.toml", f"{name}-audited.toml", (heads, heads + "energy_audit = true\n"))
                self.assertEqual(self.json("run", audited)["gaps"], plain["gaps"])

    def test_what_needs_more_than_is_given_is_said_to_collide(self):
        text = self.output("run", CASES / "missed/missed-minimal.toml")
        self.assertIn("POUNDING", text)
        self.assertNotIn("NO POUNDING", text)


class LevelsAtTolerance(Reported):
    def test_floors_exactly_a_tolerance_apart_meet_in_any_unit(self):
        metres, centimetres = (self.json("run", CASES / f"missed/tolerance-{unit}.toml") for unit in ("m", "cm"))
        of = [[(p["elevation"] * scale, p["impacts"]) for p in one["gaps"][0]["points"]]
              for one, scale in ((metres, 100), (centimetres, 1))]
        self.assertEqual(len(of[0]), 2)
        for (one, impacts), (other, same) in zip(*of):
            self.assertAlmostEqual(one, other, delta=1e-9)
            self.assertEqual(impacts, same)
        for one, other in zip(metres["gaps"][0]["points"], centimetres["gaps"][0]["points"]):
            self.assertAlmostEqual(one["peak_force"] / other["peak_force"], 1, delta=1e-9)


class RulesAtEveryLevel(Reported):
    def by_rule(self, case):
        gap = self.json("gap", case)["gaps"][0]
        return gap, {one["rule"]: one for one in gap["rules"]}

    def printed(self, case):
        """Peak displacements by CQC as the terminal prints them, building by building, by level."""
        tables = re.findall(r"Peak displacements of .*?\n\n.*?─\n(.*?)\n\n", self.output("gap", case), re.S)
        return [{float(row.split()[0]): float(row.split()[2]) for row in table.splitlines()} for table in tables]

    def test_a_floor_against_a_column_governs(self):
        case = CASES / "engineer/spec.toml"
        gap, rules = self.by_rule(case)
        tower, infilled = self.printed(case)
        # The column of the tower between its floors at 16.0 and 19.2 m, as a straight line.
        left = tower[16.0] + (tower[19.2] - tower[16.0]) * (17.5 - 16.0) / 3.2
        right = infilled[17.5]
        self.assertAlmostEqual(gap["gap_needed"], 0.2415, delta=5e-5)
        by_hand = {"abs": left + right, "srss": math.hypot(left, right), "en-1998-1": math.hypot(left, right)}
        for rule, asked in by_hand.items():
            with self.subTest(rule):
                # A frame's line between floors is a curve; generic buildings have straight ones.
                self.assertAlmostEqual(rules[rule]["gap"] / asked, 1, delta=1e-3)
        for rule, one in rules.items():
            with self.subTest(rule):
                self.assertEqual(one["elevation"], 17.5)
                self.assertEqual(one["given_is"], "too_small")

    def test_every_code_rule_at_the_highest_pair_of_floors(self):
        case = CASES / "engineer/codes_tol.toml"
        gap, rules = self.by_rule(case)
        tower, infilled = self.printed(case)
        left, right = tower[16.0], infilled[17.5]
        of_left, of_right = left / 3.9, right / 3.0  # under the reduced spectrum
        by_hand = {
            "abs": left + right,
            "srss": math.hypot(left, right),
            "asce-7-16": math.hypot(5.5 * of_left, 4.5 * of_right),
            "en-1998-1": math.hypot(3.9 * of_left, 3.0 * of_right),
            "is-1893-1": 3.9 * of_left + 3.0 * of_right,
            "nbcc": 4.0 * 1.7 * math.hypot(of_left, of_right),
            "tbdy-2018": 0.5 * 8.0 * math.hypot(of_left, of_right),
            "gb-50011-2010": 0.1 + 0.02 * (17.5 - 15) / 3,
            "ntc-2004": 2.0 * of_left + 0.006 * 16.0 + 2.0 * of_right + 0.006 * 17.5,
        }
        self.assertEqual(set(rules), {*by_hand, "ddc"})
        for rule, asked in by_hand.items():
            with self.subTest(rule):
                self.assertAlmostEqual(rules[rule]["gap"] / asked, 1, delta=5e-4)  # four digits are printed
        for rule, one in rules.items():
            with self.subTest(rule):
                self.assertEqual(one["elevation"], 16.75)
                self.assertEqual(one["given_is"], "too_small")

    def test_what_cannot_be_evaluated_says_so(self):
        linked, _ = self.by_rule(CASES / "engineer/d.toml")
        ddc = next(one for one in linked["rules"] if one["rule"] == "ddc")
        self.assertEqual(ddc["given_is"], "not_evaluated")
        self.assertTrue(ddc["reason"])
        # Without contact points rules look at watched floors.
        _, rules = self.by_rule(CASES / "engineer/e.toml")
        self.assertEqual(rules["srss"]["elevation"], 17.5)
        self.assertEqual(rules["srss"]["given_is"], "too_small")


class CalibratedPeriod(Reported):
    def test_shears_and_moments_of_struck_columns_are_scaled(self):
        summary = self.json("run", CASES / "engineer/frame.toml")
        factors = [one["stiffness_factor"] for one in summary["buildings"]]
        self.assertGreater(max(factors), 3)
        text = (CASES / "engineer/frame.toml").read_text()
        text = re.sub(r"calibrate_period = .*\n", "", text)
        for factor in factors:
            text = text.replace("elastic_modulus = 15e6\n", f"elastic_modulus = {15e6 * factor!r}\n", 1)
        text = text.replace('file = "../../../', f'file = "{CASES.parent.parent}/')
        scaled = self.folder / "scaled.toml"
        scaled.write_text(text)
        other = json.loads(self.output("run", scaled, "--json"))
        compared = 0
        for one, same in zip(summary["buildings"], other["buildings"]):
            for key in ("peak_storey_shear", "peak_displacement", "peak_acceleration"):
                largest = max(map(abs, same[key]))
                for a, b in zip(one[key], same[key]):
                    self.assertAlmostEqual(a / largest, b / largest, delta=1e-7, msg=key)
                    compared += 1
        for point, same_point in zip(summary["gaps"][0]["points"], other["gaps"][0]["points"]):
            one, same = ({"force": p["peak_force"], **p.get("column", {})} for p in (point, same_point))
            for key, value in one.items():
                if value:
                    self.assertAlmostEqual(same[key] / value, 1, delta=1e-7, msg=key)
                    compared += 1
        self.assertGreater(compared, 120)
        self.assertRegex(self.output("run", CASES / "engineer/frame.toml"), r"stiffness times 9\.182 by calibrate_period")


class WhatAnEngineerReads(Reported):
    def test_a_slip_of_units_is_remarked_and_a_unit_accepted(self):
        slip = self.edited("engineer/w.toml", "slip.toml", ("pga = 3.43", "pga = 0.35"))
        self.assertRegex(self.output("run", slip).replace("\n  ", " "), r'remark: .*0\.03569 g.*"0\.35 g"')
        right = self.edited("engineer/w.toml", "right.toml", ("pga = 3.43", 'pga = "0.35 g"'))
        needed = [self.json("run", case)["gaps"][0]["gap_needed"] for case in (slip, right)]
        self.assertAlmostEqual(needed[1] / needed[0], 9.80665, delta=1e-8)

    def test_enough_in_one_motion_tells_the_reversed_one(self):
        needed = self.json("run", CASES / "engineer/crev.toml")["gaps"][0]
        case = self.edited("engineer/crev.toml", "as-recorded.toml", ('polarity = "reversed"\n', ""))
        other = self.json("run", case)["gaps"][0]
        self.assertNotAlmostEqual(needed["gap_needed"] / other["gap_needed"], 1, delta=0.3)
        self.assertEqual(needed["gap_needed_reversed"], other["gap_needed"])
        self.assertEqual(other["gap_needed_reversed"], needed["gap_needed"])
        said = self.output("run", case).replace("\n  ", " ")
        self.assertRegex(said, "one ground motion")
        self.assertRegex(said, "reversed needs")

    def test_floors_that_a_wide_tolerance_joins_are_remarked(self):
        self.assertRegex(self.output("run", CASES / "engineer/y1.toml").replace("\n  ", " "),
                         r"remark: .*1\.5 m apart in height")

    def test_a_column_beyond_its_capacity_is_said_first(self):
        case = SOURCE / "examples/struck-column.toml"
        verdict = self.output("run", case).split("\n\n")[1]
        self.assertRegex(verdict, r"^COLUMN FAILS IN SHEAR: D/C 2\.416 in the column of Office at level 19\.4 m")
        report = self.folder / "report.html"
        self.output("report", case, "-o", report)
        badge, sentence = re.findall(r"<p[^>]*>(.*?)</p>", report.read_text().split('id="verdict"')[1], re.S)[:2]
        self.assertEqual(badge, "Column fails in shear")
        self.assertRegex(sentence, "^D/C 2\.416 in the column of Office")


class HostileInput(Reported):
    def test_a_damaged_study_is_refused_with_its_place(self):
        for name in ("study-segv", "study-segv2", "study-segv3", "study-segv4"):
            with self.subTest(name):
                result = bentur("sweep", CASES / f"hostile/{name}.toml", "--check")
                self.assertEqual(result.returncode, 2)
                self.assertRegex(result.stderr, rf"{name}\.toml:\d+:\d+: error: vary\[0\]")

    def test_no_output_claims_success_with_numbers_that_are_none(self):
        for name in ("inf-drift", "inf-pga-in-g", "jacobi-rc1"):
            with self.subTest(name):
                result = bentur("run", CASES / f"hostile/{name}.toml", "--json")
                self.assertEqual(result.returncode, 2, result.stdout)
                self.assertRegex(result.stderr, rf"{name}\.toml:\d+:\d+: error: .*must be in \[1e-9, 1e9\]")
                self.assertEqual(result.stdout, "")


if __name__ == "__main__":
    if not CASES.is_dir():
        print("skipped: no ../shared/findings")
        sys.exit(77)
    unittest.main()
