#!/usr/bin/env python3
"""Incremental dynamic analyses, fragilities and the gaps of a study as a user meets them.

The program under test is the environment variable BENTUR, the repository BENTUR_SOURCE. Numbers are checked by other ways
to them: single runs, the free response, and a likelihood maximised here.
"""

import json
import math
import os
import pathlib
import re
import signal
import statistics
import subprocess
import sys
import time
import unittest

from sweep_test import BENTUR, ENVIRONMENT, MPIRUN, SHARED, SOURCE, Sweep, journal_done, shared_folder

STUDIES = SOURCE / "examples" / "studies"
FAR_FIELD = SOURCE / "records" / "far-field"
SANITIZED = os.environ.get("BENTUR_SANITIZED") == "1"  # some twenty times slower
NORMAL = statistics.NormalDist()


def log_likelihood(counts, median, dispersion):
    total = 0
    for count in counts:
        z = math.log(count["intensity"] / median) / dispersion
        # erfc keeps both tails
        for number, sign in ((count["events"], -1), (count["runs"] - count["events"], 1)):
            if number:
                total += number * math.log(0.5 * math.erfc(sign * z / math.sqrt(2)))
    return total


def maximum(counts, start):
    """The θ and β of largest likelihood, by a compass search: nothing but the function itself."""
    at, step = [math.log(start[0]), math.log(start[1])], 0.1
    best = log_likelihood(counts, *map(math.exp, at))
    while step > 1e-9:
        for axis, sign in ((0, 1), (0, -1), (1, 1), (1, -1)):
            other = list(at)
            other[axis] += sign * step
            value = log_likelihood(counts, *map(math.exp, other))
            if value > best:
                at, best = other, value
                break
        else:
            step /= 2
    return [math.exp(x) for x in at]


def gap_between(widths, curves, at, p):
    """Linear in the normal quantile of the probability at the intensity."""
    z = [math.log(at / curve["median"]) / curve["dispersion"] for curve in curves]
    wanted = NORMAL.inv_cdf(p)
    last = max(i for i in range(len(widths)) if z[i] > wanted)
    part = (z[last] - wanted) / (z[last] - z[last + 1])
    return widths[last] + part * (widths[last + 1] - widths[last])


class Ida(Sweep):
    def bentur(self, *arguments, status=0):
        result = subprocess.run([BENTUR, *map(str, arguments)], capture_output=True, text=True, env=ENVIRONMENT, timeout=800)
        self.assertEqual(result.returncode, status, f"{arguments}\n{result.stdout}\n{result.stderr}")
        return result

    def json_of(self, *arguments):
        return json.loads(self.bentur(*arguments, "--json").stdout)

    def shortened(self, name, old, new, *more):
        """An example study in this test's folder, with paths that still hold and something replaced."""
        text = (STUDIES / name).read_text()
        for a, b in ((old, new), *more):
            self.assertIn(a, text)
            text = text.replace(a, b)
        text = text.replace('"../../', f'"{SOURCE}/').replace('case = "', f'case = "{STUDIES}/')
        return self.study(text)

    def shipped_record(self, **keywords):
        """The far-field study with the one record that every checkout has: 20 levels and 5 gaps."""
        return self.shortened("ida-far-field.toml", "../../records/far-field/*.csv", "../../data/el-centro-1940-ns.csv",
                              *keywords.items())

    def check_fits(self, document):
        """Every fit is the maximum of the likelihood of its own counts, and inside its bounds."""
        fitted = 0
        for curve in document["curves"]:
            self.assertEqual(curve["runs"], sum(count["runs"] for count in curve["counts"]))
            self.assertEqual(curve["events"], sum(count["events"] for count in curve["counts"]))
            if curve["kind"] != "fitted":
                self.assertIsNone(curve["median"])
                continue
            fitted += 1
            median, dispersion = maximum(curve["counts"], (0.5, 0.5))
            self.assertAlmostEqual(curve["median"] / median, 1, delta=1e-6)  # the maximum is flat: √ε
            self.assertAlmostEqual(curve["dispersion"] / dispersion, 1, delta=1e-6)
            for name in "median", "dispersion":
                lower, upper = curve[name + "_bounds"]
                self.assertTrue(lower < curve[name] < upper, curve["case"])
        return fitted

    def check_against_free_response(self, study, document, level):
        """A gap is wide enough for a record where the buildings moving freely need no more: counted by bentur gap."""
        needs = self.json_of("gap", study, "--at", level)["studied"][0]["gaps"][0]["records"]
        for curve in document["curves"]:
            at, = [count for count in curve["counts"] if count["intensity"] == level]
            closer = sum(1 for record in needs if record["gap_needed"] > curve["case"]["width"])
            self.assertEqual(at["events"], closer, curve["case"])


class Example(Ida):
    def test_part_of_the_far_field_study_with_the_shipped_record(self):
        study, output = self.shipped_record(), self.folder / "r.nc"
        result = self.bentur("ida", study, "-o", output)
        self.assertIn("100 runs, ", result.stdout)
        found = self.in_python("""
import json, sys, xarray
d = xarray.open_dataset(sys.argv[1])
at = d.sel(intensity=0.6, width=0.2).isel(record=0)
print(json.dumps({"dims": list(d.peak_force.dims), "coords": sorted(d.impacts.coords), "units": d.intensity.units,
    "name": d.intensity.long_name, "period": d.intensity.period, "damping": d.intensity.damping,
    "scale_dims": list(d.scale_factor.dims), "scale": float(at.scale_factor), "record": float(at.record_intensity),
    "levels": d.intensity.values.tolist(), "force": at.peak_force.values.tolist(), "impacts": at.impacts.values.tolist(),
    "drift": at.peak_drift_ratio_2.values.tolist(), "needed": float(at.gap_needed[0])}))
""", output)
        self.assertEqual(found["dims"], ["record", "width", "intensity", "point"])
        self.assertEqual(found["coords"], ["intensity", "point_elevation", "point_left", "point_right", "record",
                                           "record_intensity", "scale_factor", "width"])
        self.assertEqual((found["units"], found["period"], found["damping"]), ("gravity", 1.2, 0.05))
        self.assertEqual(found["name"], "spectral acceleration, period 1.2 s, damping 5 %")
        self.assertEqual(found["scale_dims"], ["record", "intensity"])
        self.assertEqual(found["levels"], [round(0.05 * i, 2) for i in range(1, 21)])
        # The spectrum of the record by itself, and the case with its record scaled by hand.
        spectrum = self.json_of("spectrum", SOURCE / "data/el-centro-1940-ns.csv", "--unit", "g", "--periods", "1.2:2.4:2",
                                "--damping", "0.05")
        intensity = spectrum["pseudo_acceleration"][0] / 9.80665
        self.assertAlmostEqual(found["record"] / intensity, 1, delta=1e-14)
        self.assertAlmostEqual(found["scale"] * intensity, 0.6, delta=1e-14)
        case = (STUDIES / "eight-and-six.toml").read_text().replace("width = 0.05", "width = 0.2")
        case = case.replace('"../../data/', f'"{SOURCE}/data/') + f"scale = {found['scale']!r}\n"
        summary = self.json_of("run", self.study(case, "case.toml"))
        points = summary["gaps"][0]["points"]
        self.assertGreater(max(point["peak_force"] for point in points), 1000)
        self.assertEqual(found["impacts"], [point["impacts"] for point in points])
        for value, point in zip(found["force"], points, strict=True):
            self.assertAlmostEqual(value, point["peak_force"], delta=1e-9 * point["peak_force"])
        for value, expected in zip(found["drift"], summary["buildings"][1]["peak_drift_ratio"], strict=True):
            self.assertAlmostEqual(value, expected, delta=1e-9)
        # One record pounds from one level on, where its free response needs more than the gap: in proportion to the level.
        document = self.json_of("fragility", output, "--at", 0.6, "--probability", "0.5")
        for curve in document["curves"]:
            first = curve["case"]["width"] / found["needed"] * 0.6
            if first > 1:
                self.assertEqual(curve["kind"], "no_event")
                continue
            self.assertEqual(curve["kind"], "separated")
            lower, upper = curve["median_between"]
            self.assertTrue(lower <= first < upper, curve["case"])
            self.assertAlmostEqual(upper - lower, 0.05, delta=1e-12)
        gap, = document["gaps"]
        self.assertEqual(gap["width"], min(w for w in (0.1, 0.2, 0.3, 0.4, 0.5) if w >= found["needed"]))
        text = self.bentur("fragility", output).stdout
        self.assertRegex(text, r"width = 0\.1 m: no event up to \S+ g and nothing else from \S+ g on: θ is between, β cannot")
        self.assertNotIn("nan", text)
        self.check_against_free_response(study, document, 0.6)

    def test_every_shared_record(self):
        if not (SHARED / "records").exists():
            self.skipTest("the records of ../shared are not here")
        text = (STUDIES / "ida-own-records.toml").read_text().replace('"eight-and-six.toml"', f'"{STUDIES}/eight-and-six.toml"')
        study, output, records = self.folder / "study.toml", self.folder / "r.nc", SHARED / "records"
        study.write_text(re.sub(r"files = \[.*?\n\]", lambda _: f"""files = [
  "{records}/*.AT2",
  {{ file = "{records}/el-centro-1940-s00e.txt", unit = "g" }},
  {{ file = "{records}/mexico-sct-1985.txt", unit = "g", column = 3 }},
  {{ file = "{records}/[ch]*.txt", unit = "m/s2" }},
  {{ file = "{records}/imperial-valley.txt", unit = "m/s2" }},
  {{ file = "{records}/[klns]*.txt", unit = "m/s2" }},
]""", text, flags=re.DOTALL))
        self.assertIn("552 runs, ", self.bentur("ida", study, "-o", output).stdout)
        document = self.json_of("fragility", output, "--at", 0.4, "--probability", "0.1,0.5")
        self.assertEqual(document["records"], len(list((SHARED / "records").glob("*.*"))) - 1)  # README.md
        self.assertEqual(self.check_fits(document), 3)
        self.check_against_free_response(study, document, 0.4)
        self.assertEqual([curve["events"] for curve in document["curves"]], [129, 83, 42])
        tenth, half = document["gaps"]
        self.assertEqual((tenth["kind"], tenth["width"], tenth["bounds"][1]), ("beyond", 0.3, None))
        self.assertAlmostEqual(half["width"], gap_between([0.05, 0.15, 0.3], document["curves"], 0.4, 0.5), delta=1e-9)
        self.assertAlmostEqual(half["width"], 0.157, delta=5e-4)
        found = self.in_python("""
import json, sys, xarray
d = xarray.open_dataset(sys.argv[1])
print(json.dumps({"records": dict(zip(d.record.values.tolist(), d.record_intensity.values.tolist())),
    "scaled": float(abs(d.peak_ground_acceleration / 9.80665 / d.intensity - 1).max()),
    "product": float(abs(d.scale_factor * d.record_intensity / d.intensity - 1).max())}))
""", output)
        self.assertLess(found["scaled"], 1e-14)
        self.assertLess(found["product"], 1e-14)
        for name, intensity in found["records"].items():  # the files once more, read here
            lines = (SHARED / "records" / name).read_text(errors="replace").splitlines()
            if name.endswith(".AT2"):
                values = [float(x) for line in lines[4:] for x in line.split()]
                unit = 1
            else:
                rows = [line.split() for line in lines if line.strip() and not line.startswith("#")]
                values = [float(row[2 if name.startswith("mexico") else 1]) for row in rows]
                unit = 1 if name.startswith(("mexico", "el-centro")) else 9.80665
            self.assertAlmostEqual(intensity, max(map(abs, values)) / unit, delta=1e-12, msg=name)

    def test_the_far_field_set(self):
        if not FAR_FIELD.exists():
            self.skipTest("no records/far-field: ./dev records fetches it")
        if SANITIZED:
            self.skipTest("4,400 runs take too long under the sanitizers")
        study, output = STUDIES / "ida-far-field.toml", self.folder / "r.nc"
        self.assertIn("4400 runs, ", self.bentur("ida", study, "-o", output).stdout)
        document = self.json_of("fragility", output, "--at", 0.5, "--probability", "0.01,0.1")
        self.assertEqual(document["records"], 44)
        self.assertEqual(self.check_fits(document), 5)
        self.check_against_free_response(study, document, 0.5)
        self.check_against_free_response(study, document, 1.0)
        self.assertEqual([curve["events"] for curve in document["curves"]], FAR_FIELD_EVENTS)
        for curve, (median, dispersion) in zip(document["curves"], FAR_FIELD_FITS, strict=True):
            self.assertAlmostEqual(curve["median"], median, delta=5e-5)
            self.assertAlmostEqual(curve["dispersion"], dispersion, delta=5e-5)
        widths = [curve["case"]["width"] for curve in document["curves"]]
        for gap, expected in zip(document["gaps"], FAR_FIELD_GAPS, strict=True):
            by_hand = gap_between(widths, document["curves"], 0.5, gap["probability"])
            self.assertAlmostEqual(gap["width"], by_hand, delta=1e-9)
            self.assertAlmostEqual(gap["width"], expected, delta=5e-5)
            self.assertTrue(gap["bounds"][0] < gap["width"] < gap["bounds"][1])
        # What docs/studies.md shows is what this prints.
        text = self.bentur("fragility", output, "--at", 0.5, "--probability", "0.01,0.1").stdout
        self.assertIn(text.strip(), (SOURCE / "docs" / "studies.md").read_text())


FAR_FIELD_EVENTS = [732, 562, 395, 224, 97]
FAR_FIELD_FITS = [(0.1901, 0.1675), (0.3792, 0.1780), (0.5669, 0.1755), (0.7624, 0.1876), (0.9424, 0.1825)]
FAR_FIELD_GAPS = [0.4063, 0.3369]


class Work(Ida):
    def test_threads_ranks_and_kills_do_not_show(self):
        # Analyses without end, as far as the killing goes: begun with many levels, 5 gaps each.
        study = self.shipped_record(**{"count = 20": "count = 20" if SANITIZED else "count = 200"})
        output, part = self.folder / "r.nc", self.folder / "r.nc.part"
        self.bentur("ida", study, "-o", self.folder / "one.nc", "--threads", 1)
        expected = (self.folder / "one.nc").read_bytes()
        process = subprocess.Popen([BENTUR, "ida", str(study), "-o", str(output), "--threads", "2"], env=ENVIRONMENT,
                                   stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        while process.poll() is None and not (part.exists() and journal_done(part)[0] > 5):
            time.sleep(0.002)
        process.send_signal(signal.SIGKILL)
        process.wait()
        self.bentur("ida", study, "-o", output, "--resume")
        self.assertEqual(output.read_bytes(), expected)
        if not MPIRUN:
            self.skipTest("threads and a kill do not show; no mpirun, or built without MPI")
        result = subprocess.run([MPIRUN, "--oversubscribe", "-n", "2", BENTUR, "ida", str(study), "-o", str(output)],
                                capture_output=True, text=True, env=ENVIRONMENT, timeout=600)
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertEqual(output.read_bytes(), expected)

    def test_a_changed_level_does_not_resume(self):
        output, part = self.folder / "r.nc", self.folder / "r.nc.part"
        for count in (20, 200, 2000, 20000):  # until it is killed before its end, however fast the machine is
            study = self.shipped_record(**{"count = 20": f"count = {count}"})
            process = subprocess.Popen([BENTUR, "ida", str(study), "-o", str(output)], env=ENVIRONMENT,
                                       stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
            while process.poll() is None and not part.exists():
                time.sleep(0.001)
            process.kill()
            process.wait()
            if part.exists():
                break
            output.unlink(missing_ok=True)
        study.write_text(study.read_text().replace("to = 1.0", "to = 1.1"))
        self.assertIn("another study: line", self.bentur("ida", study, "-o", output, "--resume", status=1).stderr)

    def test_sweep_and_ida_send_to_one_another(self):
        self.assertIn("use bentur ida", self.bentur("sweep", self.shipped_record(), "--check", status=2).stderr)
        self.assertIn("use bentur sweep", self.bentur("ida", STUDIES / "m12-gaps.toml", "--check", status=2).stderr)
        self.assertIn("100 runs\n  record: 1 values\n  width: 5 values\n  intensity: 20 values\n",
                      self.bentur("ida", self.shipped_record(), "--check").stdout)
        self.assertIn("bentur ida: --output is required", self.bentur("ida", self.shipped_record(), status=2).stderr)


class Fragility(Ida):
    def test_arguments_and_files_that_will_not_do(self):
        output = self.folder / "r.nc"
        self.bentur("ida", self.shipped_record(), "-o", output, "-q")
        for arguments, words in ((["--event", "impact > 0"], 'did you mean "impacts"?'),
                                 (["--event", "impacts"], "must be a quantity"),
                                 (["--event", "nonsense > 0"], "peak_force"),
                                 (["--at", "0.5"], "--probability"),
                                 (["--probability", "0.1"], "--at"),
                                 (["--at", "0.5", "--probability", "1.5"], "must be in (0, 1)"),
                                 (["--at", "5", "--probability", "0.1"], "must be from 0.05 to 1"),
                                 (["--at", "0.5", "--probability", "0.1", "--along", "gap"], "width"),
                                 (["--confidence", "1"], "must be in (0, 1)"),
                                 (["--resamples", "0"], "--resamples")):
            self.assertIn(words, self.bentur("fragility", output, *arguments, status=2).stderr, arguments)
        self.assertIn("no such file", self.bentur("fragility", self.folder / "none.nc", status=2).stderr)
        self.assertIn("NetCDF", self.bentur("fragility", SOURCE / "README.md", status=2).stderr)
        sweep = self.folder / "sweep.nc"
        self.bentur("sweep", self.widths(3), "-o", sweep)
        self.assertIn("those of bentur ida", self.bentur("fragility", sweep, status=2).stderr)

    def test_other_events_and_the_seed(self):
        study = self.shortened("ida-far-field.toml", "../../records/far-field/*.csv", "../../data/el-centro-1940-ns.csv",
                               ('name = "record"\n', 'name = "record"\n\n[[vary]]\nparameter = "building[0].damping"\n'
                                                     'values = [0.02, 0.05]\n'))
        output = self.folder / "r.nc"
        self.bentur("ida", study, "-o", output, "-q")
        document = self.json_of("fragility", output, "--event", "drift > 0.005")
        self.assertEqual(document["event_units"], "1")
        self.assertEqual([curve["case"] for curve in document["curves"]][:6],
                         [{"damping": d, "width": w} for d in (0.02, 0.05) for w in (0.1, 0.2, 0.3, 0.4, 0.5)][:6])
        self.assertTrue(all(curve["events"] > 0 for curve in document["curves"]))
        text = self.bentur("fragility", output, "--event", "drift > 0.5").stdout
        self.assertEqual(text.count("no run has the event: θ cannot be found, it is above 1 g"), 10)
        self.assertIn("every run has the event", self.bentur("fragility", output, "--event", "drift > 0").stdout)
        for method in ("likelihood", "cloud", "stripes"):
            english, indonesian = (self.bentur("fragility", output, "--event", "drift > 0.005", "--method", method, "--at", 0.4,
                                               "--probability", 0.1, "--along", "width", "--lang", language).stdout
                                   for language in ("en", "id"))
            self.assertEqual(*(re.findall(r"[0-9.]+", text) for text in (english, indonesian)))
            for word in "Event", "cannot be found", "KS:  the", "runs", "resamples":
                self.assertNotIn(word, indonesian)
        for method in ("cloud", "stripes"):
            demands = self.json_of("fragility", output, "--event", "drift > 0.005", "--method", method)
            self.assertTrue(any(method in curve for curve in demands["curves"]), method)
        twice = [self.bentur("fragility", output, "--seed", 3, "--json").stdout for _ in range(2)]
        self.assertEqual(*twice)


class Gap(Ida):
    def test_over_the_records_of_a_study_each_is_the_case_by_itself(self):
        document = self.json_of("gap", STUDIES / "m12-gaps.toml")
        gap, = document["studied"][0]["gaps"]
        self.assertEqual([record["record"] for record in gap["records"]], ["El Centro", "harmonic"])
        alone = self.json_of("gap", SOURCE / "examples/m12-el-centro.toml")["gaps"][0]
        for name in "gap_needed", "abs", "srss", "ddc":
            first, second = (record[name] for record in gap["records"])
            self.assertAlmostEqual(first, alone[name], delta=1e-12)
            self.assertEqual(gap["largest"][name], max(first, second))
            self.assertEqual(gap["median"][name], (first + second) / 2)
        text = self.bentur("gap", STUDIES / "m12-gaps.toml").stdout
        for word in "El Centro", "harmonic", "largest", "median", "Needed", "DDC", "Model 1 | Model 2":
            self.assertIn(word, text)

    def test_a_neighbour_of_whom_little_is_known(self):
        study = STUDIES / "generic-neighbour-gap.toml"
        text = self.bentur("gap", study).stdout
        block = (SOURCE / "docs" / "studies.md").read_text().split("<!-- generic-neighbour-gap -->")[1]
        self.assertIn(block.split("```\n")[1].rstrip() + "\n", text)
        document = self.json_of("gap", study)
        self.assertEqual(len(document["studied"]), 15)
        each = sorted(record["gap_needed"] for one in document["studied"] for record in one["gaps"][0]["records"])
        together = document["together"]
        self.assertEqual(together["runs"], 30)
        self.assertEqual(len(each), 30)
        gap, = together["gaps"]
        quantile = {one["probability"]: one["gap_needed"] for one in gap["quantiles"]}
        # Linear between the two runs next to it, [HyndmanFan1996] type 7.
        place = 0.9 * 29
        low = int(place)
        self.assertAlmostEqual(quantile[0.9], each[low] + (place - low) * (each[low + 1] - each[low]), delta=1e-12)
        self.assertEqual(gap["largest"]["gap_needed"], each[-1])
        given, = gap["given"]
        beyond = sum(one > 0.1 for one in each)
        self.assertEqual(given["records_beyond"], beyond)
        # What it comes to stands first, at both doors and in both languages.
        first, second = document["statements"]
        self.assertEqual([first["kind"], first["severity"]], ["runs_short", "warning"])
        self.assertEqual([first["values"]["beyond"], first["values"]["runs"]], [beyond, 30])
        self.assertEqual(first["values"]["share"], {"value": 100 * beyond / 30, "unit": "%"})
        self.assertEqual(second["kind"], "gaps_over_runs")
        self.assertEqual(second["values"]["median"]["value"], gap["median"]["gap_needed"])
        self.assertEqual(second["values"]["most"]["value"], quantile[0.84])
        self.assertTrue(text.split("\n\n")[1].startswith(f"{beyond} of 30 runs (33.33 %) need more than the 0.1 m given."))
        said = self.bentur("gap", study, "--lang", "id").stdout.split("\n\n")[1]
        self.assertTrue(said.startswith(f"{beyond} dari 30 hitungan (33.33 %) memerlukan lebih dari 0.1 m"), said)

    def test_codes_other_axes_and_levels(self):
        case = (STUDIES / "eight-and-six.toml").read_text().replace('"../../data/', f'"{SOURCE}/data/')
        case = self.study(case + "\n[code]\nen-1998-1 = { behaviour_factor = 1.0 }\n", "case.toml")
        study = self.study(f"""
case = "{case}"
[ida]
intensity = "pga"
unit = "g"
levels = [0.2, 0.4]
[[vary]]
parameter = "building[0].damping"
values = [0.03, 0.05]
[[vary]]
parameter = "gap[0].width"
values = [0.1, 0.2]
""")
        high, low = (self.json_of("gap", study, *at) for at in ([], ["--at", 0.1]))
        self.assertEqual(high["intensity"], {"name": "peak ground acceleration", "unit": "g", "value": 0.4})
        self.assertEqual([rule["rule"] for rule in high["code_rules"]], ["en-1998-1"])
        self.assertEqual([one["with"] for one in high["studied"]], [{"damping": "0.03"}, {"damping": "0.05"}])
        for one, other in zip(high["studied"], low["studied"], strict=True):
            a, b = (document["gaps"][0]["records"][0] for document in (one, other))
            self.assertAlmostEqual(a["gap_needed"] / b["gap_needed"], 4, delta=1e-9)  # linear, four times the record
            code, = a["codes"]
            self.assertAlmostEqual(code["gap"], a["abs"], delta=1e-9)  # q = 1, across a property line
        self.assertIn("damping = 0.03", self.bentur("gap", study).stdout)
        self.assertIn("EN 1998-1", self.bentur("gap", study).stdout)

    def test_bad_input(self):
        self.assertIn("needs [ida]", self.bentur("gap", STUDIES / "m12-gaps.toml", "--at", 1, status=2).stderr)
        self.assertIn("for a study", self.bentur("gap", SOURCE / "examples/m12-el-centro.toml", "--at", 1, status=2).stderr)
        samples = self.study(self.widths(3).read_text().replace("count = 3", "") + "[sampling]\nmethod='random'\ncount=4\n")
        self.assertIn("has no records to draw from", self.bentur("gap", samples, status=2).stderr)
        wrong = self.study(self.widths(3).read_text().replace("width", "widht"))
        self.assertIn("gap[0].widht is not a known key", self.bentur("gap", wrong, status=2).stderr)


if __name__ == "__main__":
    shared_folder.main(verbosity=2)
