"""The spectra of a suite, recomputed by the recurrence of Nigam and Jennings (1969) in numpy, which shares nothing with the
library: each record's factor, the mean of the spectra, and the clause at every period of the band."""

import json
import math
import os
import pathlib
import re
import signal
import subprocess
import sys
import tempfile
import time
import unittest

try:
    import numpy
except ImportError:
    numpy = None

sys.path.insert(0, os.path.join(os.environ["BENTUR_SOURCE"], "tests"))
import shared_folder
from part import part_under_sanitizers
from shared_folder import SHARED

BENTUR = os.environ["BENTUR"]
SOURCE = pathlib.Path(os.environ["BENTUR_SOURCE"])
SANITIZED = os.environ.get("BENTUR_SANITIZED") == "1"
RECORDS = SHARED / "records"
FAR_FIELD = SOURCE / "records" / "far-field"
GRAVITY = 9.80665
# Steps are cut until ω h ≤ 2π/40: a peak that lies between two of them is then missed by less than (π/40)²/2 of it.
STEPS_A_PERIOD = 40
MISSED = (math.pi / STEPS_A_PERIOD) ** 2 / 2

BUILDINGS = """
title = "Two frames of sticks"
[units]
length = "m"
force = "kN"
[[building]]
name = "West"
damping = 0.05
stick = { storey_heights = [3.5, 3.0, 3.0, 3.0], masses = [60, 55, 55, 50], stiffnesses = [16e3, 15e3, 14e3, 12e3] }
[[building]]
name = "East"
damping = 0.05
stick = { storey_heights = [3.5, 3.0, 3.0, 3.0], masses = [80, 75, 75, 60], stiffnesses = [40e3, 38e3, 35e3, 30e3] }
[[gap]]
between = ["West", "East"]
width = 0.05
contact = { law = "linear", stiffness = 3e5 }
"""
# The same in plan: stiff across, so that the suite along x moves them as it moves the row.
STIFF = "stiffnesses = [16e5, 15e5, 14e5, 12e5]"
PLAN = """
title = "Two frames in plan"
analysis = { collapse_drift = 1.0 }  # soft as they are, what they need is to be known
[units]
length = "m"
force = "kN"
[plan]
clearance = 0.5
contact = { law = "linear", stiffness = 3e5 }
[[building]]
name = "West"
damping = 0.05
plan = { corner = [0, 0], size = [12, 10], storey_heights = [3.5, 3.0, 3.0, 3.0], masses = [60, 55, 55, 50] }
plane = [{ name = "x", along = "x", at = 5.0, stiffnesses = [16e3, 15e3, 14e3, 12e3] },
         { name = "w", along = "y", at = 0.0, STIFF }, { name = "e", along = "y", at = 12.0, STIFF }]
[[building]]
name = "East"
damping = 0.05
plan = { corner = [12.05, 0], size = [12, 10], storey_heights = [3.5, 3.0, 3.0, 3.0], masses = [80, 75, 75, 60] }
plane = [{ name = "x", along = "x", at = 5.0, stiffnesses = [40e3, 38e3, 35e3, 30e3] },
         { name = "w", along = "y", at = 0.0, STIFF }, { name = "e", along = "y", at = 12.0, STIFF }]
""".replace("STIFF", STIFF)
TARGET = 'target = { shape = "en-1998-1", ground_acceleration = "0.35 g", ground_type = "D", spectrum_type = 1 }\n'


def spectra(values, step, periods, damping=0.05):
    """S_a of a record [its unit] at periods [s]: peaks of ω²|x|, the free vibration of half a period after it included."""
    cuts = max(1, math.ceil(step * STEPS_A_PERIOD / periods.min()))
    h = step / cuts
    times = numpy.arange(len(values) * cuts) * h
    samples = numpy.interp(times, numpy.arange(len(values)) * step, values)
    samples = samples[:(len(values) - 1) * cuts + 1]
    # The record ends at once.
    rest = int(math.ceil(periods.max() / h))
    w, z = 2 * math.pi / periods, damping
    wd, root = w * math.sqrt(1 - z * z), math.sqrt(1 - z * z)
    e, s, c = numpy.exp(-z * w * h), numpy.sin(wd * h), numpy.cos(wd * h)
    a11, a12 = e * (z / root * s + c), e / wd * s
    a21, a22 = -w / root * e * s, e * (c - z / root * s)
    t1, t2 = (2 * z * z - 1) / (w * w * h), 2 * z / (w ** 3 * h)
    b11 = e * (s / wd * (t1 + z / w) + c * (t2 + 1 / w ** 2)) - t2
    b12 = -e * (s / wd * t1 + c * t2) - 1 / w ** 2 + t2
    b21 = e * ((c - z / root * s) * (t1 + z / w) - (wd * s + z * w * c) * (t2 + 1 / w ** 2)) + 1 / (w * w * h)
    b22 = -e * ((c - z / root * s) * t1 - (wd * s + z * w * c) * t2) - 1 / (w * w * h)
    x, v, peak = numpy.zeros_like(w), numpy.zeros_like(w), numpy.zeros_like(w)
    for now, then in zip(samples[:-1], samples[1:], strict=True):
        x, v = a11 * x + a12 * v + b11 * now + b12 * then, a21 * x + a22 * v + b21 * now + b22 * then
        numpy.maximum(peak, numpy.abs(x), out=peak)
    for _ in range(rest):
        x, v = a11 * x + a12 * v, a21 * x + a22 * v
        numpy.maximum(peak, numpy.abs(x), out=peak)
    return w * w * peak


def at2(file):
    lines = file.read_text(errors="replace").splitlines()
    step = float(re.search(r"DT\s*=\s*([0-9.]+)", lines[3].upper())[1])
    return step, GRAVITY * numpy.array([float(x) for line in lines[4:] for x in line.split()])


def columns(file, factor):
    rows = [re.split(r"[,\s]+", line.strip()) for line in file.read_text().splitlines() if not line.startswith("#")]
    times = [float(row[0]) for row in rows if row[0]]
    return times[1] - times[0], factor * numpy.array([float(row[1]) for row in rows if row[0]])


def eurocode(periods, ground=0.35 * GRAVITY, soil=1.35, b=0.2, c=0.8, d=2.0):
    """Type 1, ground D, (3.2) to (3.5)."""
    plateau = 2.5 * ground * soil
    return numpy.where(periods < b, ground * soil * (1 + 1.5 * periods / b),
                       numpy.where(periods <= c, plateau,
                                   plateau * c / numpy.maximum(periods, c) * numpy.minimum(1, d / numpy.maximum(periods, d))))


class Suites(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def case(self, excitation, more=""):
        file = self.folder / "case.toml"
        file.write_text(BUILDINGS + '[excitation]\nkind = "suite"\n' + excitation + TARGET + more)
        return file

    def told(self, *arguments, status=0):
        done = subprocess.run([BENTUR, *map(str, arguments)], capture_output=True, text=True)
        self.assertEqual(done.returncode, status, done.stderr)
        return done.stdout if status == 0 else done.stderr

    def gap(self, file):
        return json.loads(self.told("gap", file, "--json"))

    def check_clause(self, suite, read, scale, every=1):
        """`read`: step and values [m/s²] of a file."""
        periods = numpy.array(suite["periods"])[::every]
        self.assertLess(max(numpy.diff(numpy.log(suite["periods"]))), 0.01)
        low, high = suite["band"]
        self.assertAlmostEqual(periods[0] / low, 1, places=12)
        target = eurocode(periods)
        numpy.testing.assert_allclose(numpy.array(suite["target"])[::every], target, rtol=1e-12)
        all_spectra, peaks = [], []
        for record in suite["records"]:
            step, values = read(record["file"])
            own = spectra(values, step, periods)
            ratio = numpy.log(target / own)
            if every == 1:
                # (1) and (2) of model/suite/suite.h
                self.assertAlmostEqual(record["factor"] / math.exp(ratio.mean()) / suite["common_factor"], 1, delta=2 * MISSED)
                self.assertAlmostEqual(record["misfit"], ratio.std(), delta=2 * MISSED)
            all_spectra.append(record["factor"] * own)
            peaks.append(record["factor"] * numpy.abs(values).max())
        mean = numpy.mean(all_spectra, axis=0)
        # What the recurrence misses is all that it may differ by.
        numpy.testing.assert_allclose(numpy.array(suite["mean"])[::every], mean, rtol=1.05 * MISSED)
        self.assertGreaterEqual((mean / target).min(), 0.9 * (1 - MISSED))
        if scale == "en-1998-1":
            self.assertGreaterEqual(numpy.mean(peaks), eurocode(numpy.array([0.0]))[0] * (1 - 1e-12))
        if suite["common_factor"] > 1:  # no more than is needed
            spare = min((numpy.array(suite["mean"]) / (0.9 * numpy.array(suite["target"]))).min(),
                        suite["zero_period"]["mean"] / suite["zero_period"]["target"] if scale == "en-1998-1" else math.inf)
            self.assertAlmostEqual(spare, 1, places=12)

    @unittest.skipUnless(numpy and RECORDS.exists(), "no numpy, or no records of ../shared")
    def test_shared_records(self):
        shared = RECORDS.resolve()
        texts = sorted(f.name for f in shared.glob("*.txt") if not f.name.startswith(("mexico", "el-centro")))
        files = ", ".join([f'"{shared}/*.AT2"', f'{{ file = "{shared}/el-centro*.txt", unit = "g" }}',
                           *(f'{{ file = "{shared}/{name}", unit = "m/s2" }}' for name in texts)])
        for scale, select in (("en-1998-1", ""), ("asce-7-16", "select = 3\n")):
            with self.subTest(scale):
                told = self.gap(self.case(f'files = [{files}]\nscale = "{scale}"\n{select}'))
                suite = told["suite"]
                self.assertEqual(len(suite["records"]), 3 if select else len(texts) + 1 + len(list(shared.glob("*.AT2"))))

                def read(name):
                    file = self.folder / name
                    if file.suffix == ".AT2":
                        return at2(file)
                    return columns(file, GRAVITY if "el-centro" in name else 1)

                self.check_clause(suite, read, scale, every=8 if SANITIZED else 1)

    @unittest.skipUnless(RECORDS.exists(), "the records of ../shared are not here")
    def test_one_of_each_event(self):
        # Four of the PEER files are of Cape Mendocino, two of Borah Peak, spelled in two ways.
        shared = RECORDS.resolve()
        suite = self.gap(self.case(f'files = ["{shared}/*.AT2"]\nscale = "asce-7-16"\nper_event = 1\n'))["suite"]
        events = [one["event"] for one in suite["records"] if one["event"]]
        self.assertEqual(len(set(events)), len(events))
        self.assertEqual(sum(event.startswith("CAPE MENDOCINO") for event in events), 1)
        self.assertEqual(sum(event.startswith("BORAH PEAK") for event in events), 1)

    @unittest.skipUnless(numpy and FAR_FIELD.exists(), "no numpy, or no records/far-field: ./dev records")
    def test_far_field_records(self):
        told = self.gap(self.case(f'files = [{{ file = "{FAR_FIELD.resolve()}/*.csv", unit = "g" }}]\nscale = "en-1998-1"\n'))
        self.assertEqual(len(told["suite"]["records"]), 44)
        self.check_clause(told["suite"], lambda name: columns(self.folder / name, GRAVITY), "en-1998-1")

    def synthetic(self, count, events=()):
        """Records of sines that swell and fade, no two alike."""
        for n in range(count):
            step, lines = 0.01, []
            for i in range(600):
                t = i * step
                swell = math.sin(math.pi * t / 6) ** 2
                lines.append(f"{t:.2f} {swell * sum(math.sin(2 * math.pi * t * f * (1 + 0.03 * n) + n * f) for f in (0.6, 1.1, 2.3, 4.1)):.6f}")
            (self.folder / f"r{n:02}.txt").write_text("\n".join(lines) + "\n")
        return '{ file = "r*.txt", unit = "m/s2" }'

    def test_runs_and_gap_of_every_record(self):
        files = self.synthetic(7)
        file = self.case(f'files = [{files}]\nscale = "en-1998-1"\n')
        runs = json.loads(self.told("run", file, "--json"))
        self.assertEqual([one["record"] for one in runs["records"]], list(range(1, 8)))
        for name in ("impacts", "gap_needed", "peak_drift_ratio_1"):
            values = [one["values"][name] for one in runs["records"]]
            self.assertAlmostEqual(runs["mean"][name], sum(values) / 7, places=9)
            self.assertEqual(runs["largest"][name], max(values))
        text = self.told("run", file)
        for record in runs["suite"]["records"]:
            self.assertIn(f" {pathlib.Path(record['file']).stem} ", text)
        self.assertIn("◄ mean", text)
        wide = file.with_name("wide.toml")  # with which the neediest three collide
        needs = sorted(one["values"]["gap_needed"] for one in runs["records"])
        wide.write_text(file.read_text().replace("width = 0.05", f"width = {(needs[3] + needs[4]) / 2}"))
        said = {one["kind"]: one["values"] for one in json.loads(self.told("run", wide, "--json"))["statements"]}
        self.assertEqual((said["records_too_small"]["count"], said["records_too_small"]["records"]), (3, 7))
        self.assertNotIn("records_collapsed", said)
        self.assertNotIn("collapse", said)
        found, = json.loads(self.told("gap", wide, "--json"))["judgements"]
        self.assertEqual(found["value"], "too small")
        self.assertEqual(found["records"], {"too_small": 3, "not_known": 0, "enough": 4})
        # One of them in full is the run of that record by itself, times its factor.
        one = json.loads(self.told("run", file, "--record", 3, "--json"))
        record = runs["suite"]["records"][2]
        alone = file.with_name("alone.toml")
        alone.write_text(BUILDINGS + f'[excitation]\nkind = "record"\nfile = "{record["file"]}"\nunit = "m/s2"\nscale = {record["factor"]!r}\n')
        same = json.loads(self.told("run", alone, "--json"))
        self.assertEqual(one["excitation"]["pga"], same["excitation"]["pga"])
        self.assertEqual(one["gaps"], same["gaps"])
        # The gap is the mean of the larger of both ways of each record, as bentur gap has them one by one.
        told = self.gap(file)
        code = told["studied"][0]["gaps"][0]["code"]
        needs = []
        for n in range(1, 8):
            single = json.loads(self.told("gap", file, "--record", n, "--json"))["gaps"][0]
            needs.append([max(level["gap_needed"], level["gap_needed_reversed"]) for level in single["points"]])
        means = [sum(column) / 7 for column in zip(*needs, strict=True)]
        self.assertEqual((code["code"], code["takes"]), ("EN 1998-1", "mean"))
        self.assertAlmostEqual(code["gap_needed"], max(means), places=12)
        self.assertEqual(code["too_narrow"], max(means) > 0.05)
        self.assertIn("4.3.3.4.3(3)", self.told("gap", file))
        self.assertIn("rata-rata", self.told("gap", file, "--lang", "id"))

    def test_records_that_take_too_much_are_no_runs(self):
        files = self.synthetic(3)
        file = self.case(f'files = [{files}]\nscale = "en-1998-1"\n', "[analysis]\nduration = 60.0\nlimits = { steps = 100 }\n")
        runs = json.loads(self.told("run", file, "--json"))
        self.assertEqual({one["status"] for one in runs["records"]}, {"failed"})
        self.assertEqual([one["kind"] for one in runs["statements"]][0], "suite_failed")
        self.assertIn("over the limit of 100", runs["records"][0]["message"])

    def test_what_codes_take(self):
        files = self.synthetic(12)
        for scale, select, takes in (("en-1998-1", 6, "largest"), ("en-1998-1", 2, None), ("asce-7-16", 11, "mean"),
                                     ("asce-7-16", 10, None)):
            with self.subTest(scale=scale, select=select):
                file = self.case(f'files = [{files}]\nscale = "{scale}"\nselect = {select}\n')
                gap = self.gap(file)["studied"][0]["gaps"][0]
                self.assertEqual(gap["code"]["takes"], takes)
                if takes == "largest":
                    self.assertAlmostEqual(gap["code"]["gap_needed"], max(one["gap_needed"] for one in gap["records"]), places=12)
                if takes is None:
                    self.assertIn("records or more", self.told("gap", file))

    def test_a_study_varies_the_records(self):
        files = self.synthetic(3)
        case = self.case(f'files = [{files}]\nscale = {{ factors = [1.0, 2.0, 0.5] }}\n')
        study = self.folder / "study.toml"
        study.write_text('case = "case.toml"\n[[vary]]\nparameter = "gap[0].width"\nvalues = [0.01, 0.05]\n')
        self.told("sweep", study, "-o", self.folder / "out.nc")
        told = self.gap(study)
        alone = self.gap(case)
        self.assertEqual([one["gap_needed"] for one in told["studied"][0]["gaps"][0]["records"]],
                         [one["gap_needed"] for one in alone["studied"][0]["gaps"][0]["records"]])
        self.assertEqual(len(told["studied"][0]["gaps"][0]["given"]), 2)

    def test_report_and_figure(self):
        file = self.case(f"files = [{self.synthetic(3)}]\nscale = \"en-1998-1\"\n")
        for language, words in (("en", "counts"), ("id", "dipakai")):
            report = self.folder / f"{language}.html"
            self.told("report", file, "-o", report, "--lang", language)
            text = report.read_text()
            self.assertIn(words, text)
            self.assertRegex(text, r">r02<")
            self.assertIn("<svg", text)
        # To hand in, with what the code takes of them as a check.
        file.write_text(file.read_text() + '\n[project]\nname = "Hotel"\n')
        report = self.folder / "hand-in.html"
        self.told("report", file, "-o", report)
        rows = re.findall(r"<tr.*?</tr>", report.read_text().split('<section id="checks"')[1].split("</section>")[0], re.DOTALL)
        row, = (row for row in rows if "4.3.3.4.3(3)" in row)
        code = self.gap(file)["studied"][0]["gaps"][0]["code"]
        self.assertEqual(float(re.search(r">([\d.]+)\u00a0m<", row)[1]), float(f"{code['gap_needed']:.4g}"))
        self.assertIn("NOT met" if code["too_narrow"] else ">met<", row)
        self.told("plot", file, "suite", "-o", self.folder / "suite.svg")
        self.assertIn("target", (self.folder / "suite.svg").read_text())
        self.needs_are_drawn(file)

    def needs_are_drawn(self, file):
        """What each record needs, the largest told, in the figure and in the report."""
        self.told("plot", file, "gap-needed", "-o", self.folder / "needs.svg")
        drawn = (self.folder / "needs.svg").read_text()
        records = self.gap(file)["studied"][0]["gaps"][0]["records"]
        self.assertIn(f"largest {max(one['gap_needed'] for one in records):.4g} m under ", drawn)
        self.assertIn("given: 0.05 m", drawn)
        code = self.gap(file)["studied"][0]["gaps"][0]["code"]
        self.assertIn(f"{code['takes']}, by EN 1998-1: {code['gap_needed']:.4g} m<", drawn)
        values = {float(value) for line in (self.folder / "needs-data.csv").read_text().splitlines()
                  for value in re.findall(r"[-+.\de]+", line) if re.fullmatch(r"[\d.]+(e[-+]?\d+)?", value)}
        for one in records:
            self.assertLess(min(abs(value - one["gap_needed"]) for value in values), 1e-6 * one["gap_needed"])
        self.assertIn("has no figure", self.told("plot", file, "needs", status=2))

    def pairs(self, count):
        """Records along x, and others of another period along y."""
        along_x = self.synthetic(count)
        for n in range(count):
            lines = [f"{0.01 * i:.2f} {0.8 * math.sin(math.pi * i / 600) ** 2 * math.sin(2 * math.pi * 0.01 * i * (1.7 + 0.2 * n)):.6f}"
                     for i in range(580)]
            (self.folder / f"y{n:02}.txt").write_text("\n".join(lines) + "\n")
        return along_x, '{ file = "y*.txt", unit = "m/s2" }'

    def plan(self, excitation, along_y="", more=""):
        file = self.folder / "plan.toml"
        y = f'[excitation.y]\nkind = "suite"\n{along_y}\n' if along_y else ""
        file.write_text(PLAN + f'[excitation]\nkind = "suite"\n{excitation}{TARGET}{y}{more}')
        return file

    def test_in_plan_along_x_alone_it_is_the_row(self):
        # EN's band depends on periods along y too: factors are given.
        files = f'files = [{self.synthetic(3)}]\nscale = {{ factors = [1.0, 1.5, 0.7] }}\n'
        row, plan = self.case(files), self.plan(files)
        of_row, of_plan = (json.loads(self.told("run", one, "--json")) for one in (row, plan))
        for a, b in zip(of_row["records"], of_plan["records"], strict=True):
            for name in ("gap_needed", "impacts", "base_shear_coefficient_1"):
                same = name.replace("coefficient", "coefficient_x")
                other = b["values"][same if same in b["values"] else name]
                # Two contact points share each level.
                self.assertAlmostEqual(other / (2 if name == "impacts" else 1) / a["values"][name], 1, places=9, msg=name)
        self.assertEqual([one["value"] for one in of_row["judgements"]], [one["value"] for one in of_plan["judgements"]])
        gaps = [self.gap(one)["studied"][0]["gaps"][0] for one in (row, plan)]
        for a, b in zip(*(one["records"] for one in gaps), strict=True):
            self.assertAlmostEqual(a["gap_needed"], b["gap_needed"], places=12)

    def test_pairs_of_components_in_plan(self):
        along_x, along_y = self.pairs(7)
        file = self.plan(f'files = [{along_x}]\nscale = "en-1998-1"\n', f"files = [{along_y}]")
        runs = json.loads(self.told("run", file, "--json"))
        kinds = [one["kind"] for one in runs["statements"]]
        self.assertIn("suite_pairs", kinds)
        suite = runs["suite"]
        self.assertEqual([one["building"] for one in suite["buildings"]], ["West, x", "West, y", "East, x", "East, y"])
        self.assertEqual(suite["records"][2]["along_y"]["file"], "y02.txt")
        if numpy is not None:
            periods, means = numpy.array(suite["periods"])[::8], []
            for record in suite["records"]:
                both = [spectra(columns(self.folder / name, 1)[1], 0.01, periods)
                        for name in (record["file"], record["along_y"]["file"])]
                means.append(record["factor"] * numpy.sqrt(both[0] * both[1]))
            numpy.testing.assert_allclose(numpy.array(suite["mean"])[::8], numpy.mean(means, axis=0), rtol=1.05 * MISSED)
        # One of them in full is both components times the factor.
        record = suite["records"][2]
        one = json.loads(self.told("run", file, "--record", 3, "--json"))
        alone = file.with_name("alone.toml")
        motion = 'kind = "record"\nunit = "m/s2"\nfile = "{}"\nscale = {!r}\n'
        alone.write_text(PLAN + "[excitation]\n" + motion.format(record["file"], record["factor"]) +
                         "[excitation.y]\n" + motion.format(record["along_y"]["file"], record["factor"]))
        same = json.loads(self.told("run", alone, "--json"))
        self.assertEqual(one["gaps"], same["gaps"])
        self.assertEqual(one["statements"], same["statements"])
        self.assertEqual(one["impacts"], same["impacts"])
        values = runs["records"][2]["values"]
        self.assertEqual(values["impacts"], sum(point["impacts"] for gap in same["gaps"] for point in gap["points"]))
        # The gap is what each record needs by itself, both ways; remedy, check and the report take such a case.
        told = self.gap(file)
        for n, need in enumerate(told["studied"][0]["gaps"][0]["records"], 1):
            levels = json.loads(self.told("gap", file, "--record", n, "--json"))["gaps"][0]["points"]
            self.assertAlmostEqual(need["gap_needed"], max(max(level["gap_needed"], level["gap_needed_reversed"]) for level in levels),
                                   places=12)
            self.assertAlmostEqual(runs["records"][n - 1]["values"]["gap_needed"], need["gap_needed"], places=12)
        self.assertIn("0.05", self.told("remedy", file))
        self.assertIn("suite", self.told("check", file))
        self.told("plot", file, "suite", "-o", self.folder / "suite.svg")
        self.needs_are_drawn(file)
        file.write_text(file.read_text() + '\n[project]\nname = "Hotel"\n')
        for language, words in (("en", "counts"), ("id", "dipakai")):
            report = self.folder / f"{language}.html"
            self.told("report", file, "-o", report, "--lang", language)
            self.assertRegex(report.read_text(), r"r02 \+ y02\b")
            self.assertIn(words, report.read_text())

    def test_the_largest_direction_is_that_of_asce(self):
        along_x, along_y = self.pairs(1)
        file = self.plan(f'files = [{along_x}]\nscale = "asce-7-16"\n', f"files = [{along_y}]")
        record, = json.loads(self.told("run", file, "--json"))["suite"]["records"]
        if numpy is None:
            self.skipTest("no numpy")
        x, y = (columns(self.folder / name, 1)[1] for name in ("r00.txt", "y00.txt"))
        y = numpy.concatenate([y, numpy.zeros(len(x) - len(y))])
        suite = self.gap(file)["suite"]
        periods = numpy.array(suite["periods"])[::8]
        largest = numpy.max([spectra(x * math.cos(a) + y * math.sin(a), 0.01, periods)
                             for a in numpy.arange(0, math.pi, math.pi / 90)], axis=0)
        # A degree beside the largest, and what both miss between their steps.
        numpy.testing.assert_allclose(numpy.array(record["spectrum"])[::8], record["factor"] * largest, rtol=MISSED + 6e-4)

    def test_a_study_varies_pairs(self):
        along_x, along_y = self.pairs(3)
        case = self.plan(f'files = [{along_x}]\nscale = {{ factors = [1.0, 2.0, 0.5] }}\n', f"files = [{along_y}]")
        study = self.folder / "study.toml"
        study.write_text('case = "plan.toml"\n[[vary]]\nparameter = "building[0].damping"\nvalues = [0.02, 0.05]\n')
        self.told("sweep", study, "-o", self.folder / "out.nc")
        told, alone = self.gap(study), self.gap(case)
        self.assertEqual([one["gap_needed"] for one in told["studied"][1]["gaps"][0]["records"]],
                         [one["gap_needed"] for one in alone["studied"][0]["gaps"][0]["records"]])

    def test_pairs_that_are_none(self):
        along_x, along_y = self.pairs(2)
        (self.folder / "y05.txt").write_text("".join(f"{0.02 * i:.2f} {math.sin(i)}\n" for i in range(300)))
        wrong = (('files = [{ file = "y00.txt", unit = "m/s2" }]', "must be one per file along x: there are 2"),
                 (f"files = [{along_x}]", "along x too"),
                 ('files = [{ file = "y00.txt", unit = "m/s2" }, { file = "y05.txt", unit = "m/s2" }]', "with a step of 0.02 s"))
        for files, why in wrong:
            file = self.plan(f'files = [{along_x}]\nscale = "en-1998-1"\n', files)
            found = subprocess.run([BENTUR, "check", str(file)], capture_output=True, text=True, encoding="utf-8")
            self.assertEqual(found.returncode, 2)
            self.assertIn(why, found.stderr)
        file.write_text(file.read_text().replace('[excitation.y]\nkind = "suite"', '[excitation.y]\nkind = "record"'))
        found = subprocess.run([BENTUR, "check", str(file)], capture_output=True, text=True, encoding="utf-8")
        self.assertIn('must be "suite", as along x', found.stderr)

    @unittest.skipIf(SANITIZED, "how long it takes is another matter there")
    def test_stopped(self):
        files = self.synthetic(12)
        file = self.case(f'files = [{files}]\nscale = "en-1998-1"\n', '[analysis]\nduration = 60.0\nsolver = "runge-kutta"\nstep = 0.002\n')
        written = self.folder / "told.json"  # a pipe that nobody reads would hold the program up
        with written.open("w") as told, (self.folder / "errors").open("w") as errors:
            started = subprocess.Popen([BENTUR, "run", str(file), "--json"], stdout=told, stderr=errors)
        caught = 0
        while started.poll() is None and not caught:  # once the records are read it catches Ctrl-C
            mask = re.search(r"SigCgt:\s*(\w+)", pathlib.Path(f"/proc/{started.pid}/status").read_text())[1]
            caught = int(mask, 16) >> (signal.SIGINT - 1) & 1
            time.sleep(0.01)
        used = 0  # processor time, which does not depend on what else this machine does [s]
        while started.poll() is None and used < 1.2:
            fields = pathlib.Path(f"/proc/{started.pid}/stat").read_text().rsplit(")", 1)[1].split()
            used = int(fields[11]) / os.sysconf("SC_CLK_TCK")
            time.sleep(0.02)
        started.send_signal(signal.SIGINT)
        started.wait(timeout=60)
        out = written.read_text()
        if started.returncode == 0:
            self.skipTest("this machine was faster")
        self.assertEqual(started.returncode, 1)
        if not out:
            self.skipTest("stopped before the first record")
        told = json.loads(out)
        self.assertLess(len(told["records"]), 12)
        self.assertIsNone(told["mean"]["gap_needed"])
        self.assertIsNotNone(told["largest"]["gap_needed"])


def load_tests(loader, tests, pattern):
    return part_under_sanitizers(tests, 6)


if __name__ == "__main__":
    shared_folder.main()
