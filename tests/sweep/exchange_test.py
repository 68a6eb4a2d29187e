#!/usr/bin/env python3
"""Numbers for other programs, and a model of another one, as a user meets them.

The program under test is the environment variable BENTUR, the repository BENTUR_SOURCE. pelicun is the one of the Python
that BENTUR_PELICUN names, by default of this one; without it that test is skipped.
"""

import csv
import json
import math
import os
import pathlib
import re
import subprocess
import sys
import unittest
import xml.etree.ElementTree

from sweep_test import BENTUR, ENVIRONMENT, SOURCE, Sweep

PELICUN = os.environ.get("BENTUR_PELICUN", sys.executable)
NRML = "{http://openquake.org/xmlns/nrml/0.5}"

CASE = """
[units]
length = "cm"
force = "kN"

[[building]]
name = "Tower, the tall one"
damping = 0.05
[building.stick]
storey_heights = [320, 320]
masses = [0.30, 0.25]
stiffnesses = [400, 300]
yield_forces = [60, 40]
hardening = 0.05

[[building]]
name = "House"
damping = 0.05
stick = { storey_heights = [320], masses = [0.2], stiffnesses = [600] }

[[gap]]
between = ["Tower, the tall one", "House"]
width = 3
contact = { law = "linear", stiffness = 3e3 }

[excitation]
kind = "record"
file = "FILE"
unit = "g"
pga = "0.3 g"

[analysis]
duration = 12
"""


class Exchange(Sweep):
    def bentur(self, *arguments, status=0):
        result = subprocess.run([BENTUR, *map(str, arguments)], capture_output=True, text=True, env=ENVIRONMENT, timeout=300)
        self.assertEqual(result.returncode, status, f"{arguments}\n{result.stdout}\n{result.stderr}")
        return result

    def case(self):
        path = self.folder / "case.toml"
        path.write_text(CASE.replace("FILE", str(SOURCE / "data/el-centro-1940-ns.csv")))
        return path

    def ida(self):
        self.case()
        study = self.study('case = "case.toml"\n[ida]\nintensity = "pga"\nunit = "g"\nlevels = [0.05, 0.1, 0.2, 0.3, 0.5, 0.8]\n'
                           'polarity = "both"\n[[vary]]\nparameter = "gap[0].width"\nname = "width"\nvalues = [2, 4]\n')
        self.bentur("ida", study, "-o", self.folder / "ida.nc")
        return self.folder / "ida.nc"


class Demands(Exchange):
    def demands(self, *arguments):
        text = self.bentur("export", "pelicun", self.ida(), "--building", "Tower, the tall one", *arguments).stdout
        return list(csv.reader(text.splitlines()))

    def test_are_those_of_single_runs_in_metres(self):
        head, units, *rows = self.demands("--only", "intensity=0.3", "--only", "width=4")
        self.assertEqual(head[1:], ["1-PFA-0-1", "1-PFA-1-1", "1-PFA-2-1", "1-PID-1-1", "1-PID-2-1", "1-RID-1-1", "1-RID-2-1",
                                    "1-ERROR"])
        self.assertEqual(units, ["Units", "mps2", "mps2", "mps2", *["unitless"] * 5])
        self.assertEqual(len(rows), 2)  # both ways round
        for row, reverse in zip(rows, ("", 'polarity = "reversed"\n')):
            path = self.case()
            path.write_text(path.read_text().replace("width = 3", "width = 4").replace('pga = "0.3 g"', 'pga = "0.3 g"\n' + reverse))
            run = json.loads(self.bentur("run", path, "--json").stdout)
            tower = run["buildings"][0]
            expected = [run["excitation"]["pga"] / 100, *(a / 100 for a in tower["peak_acceleration"]),
                        *tower["peak_drift_ratio"], *(abs(r) for r in tower["residual_drift_ratio"])]
            for value, other in zip(row[1:-1], expected):
                self.assertAlmostEqual(float(value), other, delta=1e-9 * max(1, abs(other)))
            self.assertEqual(row[-1], "0")

    def test_levels_are_no_sample_and_what_is_not_there_is_named(self):
        file = self.ida()
        tower = ("export", "pelicun", file, "--building", "Tower, the tall one")
        self.assertIn("several levels of intensity", self.bentur(*tower, status=2).stderr)
        self.assertIn("there are 0.05, 0.1, 0.2, 0.3, 0.5, 0.8", self.bentur(*tower, "--only", "intensity=7", status=2).stderr)
        self.assertIn("nothing named \"size\" varies", self.bentur(*tower, "--only", "size=7", status=2).stderr)
        self.assertIn("must be NAME=VALUE", self.bentur(*tower, "--only", "size", status=2).stderr)
        self.assertIn("there are Tower, the tall one, House",
                      self.bentur("export", "pelicun", file, "--building", "Barn", "--only", "intensity=0.3", status=2).stderr)
        self.assertIn("4 runs over width (2), polarity (2)", self.bentur(*tower, "--only", "intensity=0.3").stderr)

    def test_errors_and_counts_in_indonesian(self):
        file = self.ida()
        tower = ("export", "pelicun", file, "--building", "Tower, the tall one", "--lang", "id")
        for options, said in (
                ((), "kesalahan: memuat beberapa tingkat intensitas"), (("--only", "intensity=7"), "yang ada 0.05, 0.1, 0.2"),
                (("--only", "size=7"), 'tidak ada yang bernama "size"'), (("--only", "size"), "harus NAMA=NILAI"),
                (("--only", "intensity=0.3", "--building", "Barn"), "tidak punya bangunan")):
            options = tower[:3] + options + tower[5:] if "--building" in options else tower + options
            self.assertIn(said, self.bentur(*options, status=2).stderr)
        self.assertIn("4 hitungan atas width (2), polarity (2)", self.bentur(*tower, "--only", "intensity=0.3").stderr)
        openquake = ("export", "openquake", file, "--taxonomy", "X", "--lang", "id", "--event")
        self.assertIn("tidak punya besaran", self.bentur(*openquake, "size > 1", status=2).stderr)
        self.assertIn("harus besaran, salah satu dari", self.bentur(*openquake, "size", status=2).stderr)
        broken = self.case()
        broken.write_text(broken.read_text().replace("width = 3\n", "width = -3\n"))
        self.assertIn("kesalahan: gap[0].width = -3", self.bentur("export", "gem", broken, "--lang", "id", status=2).stderr)
        self.assertIn("bukan berkas NetCDF",
                      self.bentur("export", "openquake", broken, "--taxonomy", "X", "--lang", "id", status=2).stderr)

    def test_inputs_and_what_others_wrote_stay(self):
        file = self.ida()
        before = file.read_bytes()
        tower = ("export", "pelicun", file, "--building", "House", "--only", "intensity=0.3")
        self.assertIn("not written", self.bentur(*tower, "-o", file, status=2).stderr)
        self.assertEqual(file.read_bytes(), before)
        mine = self.folder / "mine.csv"
        mine.write_text("a,b\n1,2\n")
        self.assertIn("not written", self.bentur(*tower, "-o", mine, status=2).stderr)
        self.assertEqual(mine.read_text(), "a,b\n1,2\n")
        for _ in range(2):  # its own file is replaced
            self.bentur(*tower, "-o", self.folder / "demands.csv")
        self.assertEqual(sorted(path.name for path in self.folder.iterdir()),
                         ["case.toml", "demands.csv", "ida.nc", "mine.csv", "study.toml"])

    def test_pelicun_loads_them(self):
        if subprocess.run([PELICUN, "-c", "import pelicun"], capture_output=True).returncode != 0:
            self.skipTest(f"{PELICUN} has no pelicun")
        rows = self.demands("--only", "intensity=0.8")
        rows[2][-1] = "1"  # as of a run that collapses
        sample = self.folder / "sample.csv"
        with sample.open("w", newline="") as file:
            csv.writer(file).writerows(rows)
        found = json.loads(subprocess.run([PELICUN, "-c", """
import json, sys
from pelicun.assessment import Assessment
assessment = Assessment({"PrintLog": False})
assessment.demand.load_sample(sys.argv[1])
sample, units = assessment.demand.sample, assessment.demand.user_units
print(json.dumps({"columns": ["-".join(c) for c in sample.columns], "rows": sample.values.tolist(),
                  "units": {"-".join(k).strip("-"): v for k, v in units.items()}}))
""", sample], capture_output=True, text=True, check=True).stdout.splitlines()[-1])
        self.assertEqual(len(found["rows"]), len(rows) - 3)  # but for names, units, and the one with an error
        wanted = {name[2:]: [float(row[i]) for row in rows[3:]] for i, name in enumerate(rows[0][:-1]) if i > 0}
        self.assertEqual(set(found["columns"]), set(wanted))
        for place, name in enumerate(found["columns"]):
            self.assertEqual(found["units"][name], "mps2" if name.startswith("PFA") else "unitless")
            for value, other in zip((row[place] for row in found["rows"]), wanted[name]):
                self.assertAlmostEqual(value, other, delta=1e-12 * max(1, other))


class PlanDemands(Exchange):
    def test_are_those_of_single_runs_along_both_axes(self):
        text = (SOURCE / "examples/plan/twisting-pair.toml").read_text()
        text = text.replace("../../data/el-centro-1940-ns.csv", str(SOURCE / "data/el-centro-1940-ns.csv"))
        west = '[[building.plane]]\nname = "west frame"'
        self.assertIn(west, text)
        text = text.replace(west, "yield_forces = [700, 500]\nhardening = 0.05\n\n" + west)  # of the north frame, along x
        (self.folder / "case.toml").write_text(text)
        study = self.study('case = "case.toml"\n[[vary]]\nparameter = "excitation.pga"\nvalues = [2.0, 4.0]\n')
        self.bentur("sweep", study, "-o", self.folder / "sweep.nc")
        pga = 'pga = 3.4'
        self.assertIn(pga, text)
        for building, place in (("Walled", 0), ("Frame", 1)):
            made = self.bentur("export", "pelicun", self.folder / "sweep.nc", "--building", building)
            head, units, *rows = list(csv.reader(made.stdout.splitlines()))
            self.assertEqual(len(rows), 2)
            for row, value in zip(rows, ("2.0", "4.0")):
                (self.folder / "one.toml").write_text(text.replace(pga, "pga = " + value))
                run = json.loads(self.bentur("run", self.folder / "one.toml", "--json").stdout)
                told = run["buildings"][place]
                expected = {}
                for direction, axis, sides in ((1, "x", ("south", "north")), (2, "y", ("west", "east"))):
                    expected[f"1-PFA-0-{direction}"] = run["excitation"][f"peak_ground_acceleration_{axis}"]
                    planes = [one for one in told["planes"] if one["name"].startswith(sides)]
                    for floor in range(2):
                        expected[f"1-PFA-{floor + 1}-{direction}"] = told[f"peak_acceleration_{axis}"][floor]
                        drifts = [one["peak_drift_ratio"][floor] for one in planes] or [
                            told["peak_edge_drift_ratio"][side][floor] for side in sides]
                        expected[f"1-PID-{floor + 1}-{direction}"] = max(drifts)
                        left = [abs(one["residual_drift_ratio"][floor]) for one in planes if "residual_drift_ratio" in one]
                        if left:
                            expected[f"1-RID-{floor + 1}-{direction}"] = max(left)
                self.assertEqual(set(head[1:-1]), set(expected))
                self.assertEqual("1-RID-1-1" in expected, building == "Walled")
                for name, number in zip(head[1:-1], row[1:-1]):
                    self.assertEqual(float(number), expected[name], name)
                self.assertEqual(row[-1], "0")
            self.assertEqual(units[1:], ["mps2" if "PFA" in name else "unitless" for name in head[1:]])

    def test_what_cannot_be_told_is_an_error(self):
        text = (SOURCE / "examples/plan/twisting-pair.toml").read_text()
        text = text.replace("../../data/el-centro-1940-ns.csv", str(SOURCE / "data/el-centro-1940-ns.csv"))
        along_y = re.findall(r'\[\[building\.plane\]\]\nname = "(?:west|east) frame"\n(?:.+\n)+', text)
        self.assertEqual(len(along_y), 2)
        for plane in along_y:
            text = text.replace(plane, "")
        text = text.replace('[[building]]\nname = "Frame"',
                            '[building.rigidity]\ncentre = [6, 9]\nx = 0\ny = 8e4\ntorsion = 0\n\n[[building]]\nname = "Frame"')
        (self.folder / "case.toml").write_text(text)
        study = self.study('case = "case.toml"\n[[vary]]\nparameter = "plan.contact.friction"\nvalues = [0.3]\n')
        self.bentur("sweep", study, "-o", self.folder / "sweep.nc")
        walled = ("export", "pelicun", self.folder / "sweep.nc", "--building", "Walled")
        self.assertIn('has no drifts along y of building "Walled"', self.bentur(*walled, status=2).stderr)
        self.assertIn('tidak punya simpangan sepanjang y dari bangunan "Walled"', self.bentur(*walled, "--lang", "id", status=2).stderr)


class FragilityFunctions(Exchange):
    def test_give_back_median_and_dispersion(self):
        self.case()
        study = self.study('case = "case.toml"\n[ida]\nintensity = "pga"\nunit = "g"\nfrom = 0.05\nto = 0.8\ncount = 16\n'
                           'polarity = "both"\n[[vary]]\nparameter = "gap[0].width"\nname = "width"\nvalues = [2, 4]\n'
                           '[[vary]]\nparameter = "building[1].stick.masses[0]"\nname = "mass"\nvalues = [0.1, 0.2, 0.3]\n')
        file = self.folder / "ida.nc"
        self.bentur("ida", study, "-o", file)
        curves = json.loads(self.bentur("fragility", file, "--json", "--resamples", 10).stdout)["curves"]
        fitted = [curve for curve in curves if curve["kind"] == "fitted"]
        made = self.bentur("export", "openquake", file, "--taxonomy", "CR/LFM", status=0 if fitted else 2)
        if not fitted:
            self.assertIn("no case has a median and a dispersion", made.stderr)
            return
        model = xml.etree.ElementTree.fromstring(made.stdout)[0]
        functions = model.findall(NRML + "fragilityFunction")
        self.assertEqual(len(functions), len(fitted))
        for function, curve in zip(functions, fitted):
            self.assertEqual((function.get("format"), function.get("shape")), ("continuous", "logncdf"))
            imls, params = function
            self.assertEqual((imls.get("imt"), float(imls.get("minIML")), float(imls.get("maxIML"))), ("PGA", 0.05, 0.8))
            mean, deviation = float(params.get("mean")), float(params.get("stddev"))
            square = math.log1p((deviation / mean) ** 2)
            self.assertAlmostEqual(mean * math.exp(-square / 2) / curve["median"], 1, delta=1e-12)
            self.assertAlmostEqual(math.sqrt(square) / curve["dispersion"], 1, delta=1e-12)
        self.assertEqual(made.stderr.count("mass="), len(curves) - len(fitted))

    def test_a_wrong_event_is_told_as_ever(self):
        self.assertIn("has no quantity", self.bentur("export", "openquake", self.ida(), "--taxonomy", "X", "--event",
                                                      "size > 1", status=2).stderr)


class Taxonomy(Exchange):
    def test_pounding_is_an_atom_where_the_gap_is_too_narrow(self):
        case = self.case()
        case.write_text(case.read_text().replace("width = 3\n", "width = 0.1\n"))
        rows = list(csv.reader(self.bentur("export", "gem", case).stdout.splitlines()))
        self.assertEqual(rows, [["building", "taxonomy"], ["Tower, the tall one", "HEX:2/BP1/IRIR+IRVP:POP"],
                                ["House", "HEX:1/BP1/IRIR+IRVP:POP"]])
        case.write_text(case.read_text().replace("width = 0.1\n", "width = 300\n"))
        self.assertNotIn("POP", self.bentur("export", "gem", case).stdout)

    def test_of_a_suite_its_records_say_what_pounds(self):
        case = pathlib.Path(SOURCE) / "examples" / "two-real-buildings" / "record.toml"
        self.assertIn("POUNDING", self.bentur("run", case).stdout)
        rows = list(csv.reader(self.bentur("export", "gem", case).stdout.splitlines()))[1:]
        self.assertEqual([name for name, taxonomy in rows if taxonomy.endswith(":POP")], ["Office", "Hotel"])

    def test_of_buildings_in_plan(self):
        case = pathlib.Path(SOURCE) / "examples" / "plan" / "crossroads.toml"
        rows = list(csv.reader(self.bentur("export", "gem", case).stdout.splitlines()))[1:]
        found = json.loads(self.bentur("gap", case, "--json").stdout)
        small = {name for gap in found["gaps"] if gap["judgement"]["value"] == "too small" for name in gap["between"]}
        self.assertTrue(small)
        for name, taxonomy in rows:
            self.assertRegex(taxonomy, r"HEX:\d+/BP[123]")
            self.assertEqual("POP" in taxonomy, name in small, name)


class Import(Exchange):
    MODEL = (SOURCE / "src/bentur/io/exchange/e2k_test.cpp").read_text().split('R"(')[1].split(')";')[0]

    def test_a_frame_becomes_the_beginning_of_a_case(self):
        model = self.folder / "model.e2k"
        model.write_text(self.MODEL)
        self.assertIn("say which with --at", self.bentur("import", model, status=2).stderr)
        made = self.bentur("import", model, "--at", 0, "-o", self.folder / "frame.toml")
        self.assertIn("37-38: not read: AREA CONNECTIVITIES", made.stderr)
        self.assertIn("taken: columns of storey \"FIRST\"", made.stderr)
        text = (self.folder / "frame.toml").read_text()
        self.assertIn("storey_heights = [3.6, 3]", text)
        self.assertIn("not written", self.bentur("import", model, "--at", 0, "-o", model, status=2).stderr)
        self.assertIn("not written", self.bentur("import", model, "--at", 0, "-o", self.folder / "frame.toml", status=2).stderr)
        self.assertIn("is missing", self.bentur("check", self.folder / "frame.toml", status=2).stderr)


if __name__ == "__main__":
    unittest.main()
