#!/usr/bin/env python3
"""Sweeps as a user meets them: results in xarray, threads and ranks, kills and resumes, exit statuses.

The program under test is the environment variable BENTUR, the repository BENTUR_SOURCE; BENTUR_MPI is 1 where it was
built with MPI. `sweep_test.py --rounds 20` kills and resumes so often; each round begins anew at other moments.
"""

import json
import os
import pathlib
import random
import re
import shutil
import signal
import struct
import subprocess
import sys
import tempfile
import time
import unittest

sys.path.insert(0, os.path.join(os.environ["BENTUR_SOURCE"], "tests"))
from part import part_under_sanitizers
import shared_folder
from shared_folder import SHARED

BENTUR = os.environ["BENTUR"]
SOURCE = pathlib.Path(os.environ["BENTUR_SOURCE"])
MPIRUN = shutil.which("mpirun") if os.environ.get("BENTUR_MPI") == "1" else None
ROUNDS = 3
MPI_FILES = tempfile.TemporaryDirectory(prefix="bentur-mpi-")  # what killed ranks leave behind goes with it
ENVIRONMENT = {
    **os.environ,
    "TMPDIR": MPI_FILES.name,
    "OMPI_MCA_btl_vader_backing_directory": MPI_FILES.name,
    "OMPI_ALLOW_RUN_AS_ROOT": "1",
    "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1",
    # What Open MPI itself never frees is not for the sanitizers to find.
    "ASAN_OPTIONS": os.environ.get("ASAN_OPTIONS", "") + (":" if os.environ.get("ASAN_OPTIONS") else "") + "detect_leaks=0",
}

WIDTHS = 'case = "{case}"\n[[vary]]\nparameter = "gap[0].width"\nfrom = 0.0\nto = 1.0\ncount = {count}\n'


def journal_done(path):
    """Runs that a journal holds, read without the program: those whose slot is not empty."""
    data = path.read_bytes()
    assert data[:14] == b"bentur journal", data[:16]
    size, = struct.unpack_from("<Q", data, 16)
    head = json.loads(data[32:32 + size])
    runs = head["runs"]
    slot = 16 + max(248, 8 * head["values"])
    begin = (32 + size + 4095) // 4096 * 4096
    states = [data[begin + run * slot + 8:begin + run * slot + 12] for run in range(runs)]
    return sum(1 for state in states if any(state)), runs


class Sweep(unittest.TestCase):
    def setUp(self):
        self.folder = pathlib.Path(tempfile.mkdtemp(prefix="bentur-sweep-"))
        self.addCleanup(shutil.rmtree, self.folder)

    def study(self, text, name="study.toml"):
        path = self.folder / name
        path.write_text(text)
        return path

    def widths(self, count):
        return self.study(WIDTHS.format(case=SOURCE / "examples/m12-el-centro.toml", count=count))

    def run_sweep(self, *arguments, ranks=0):
        command = [BENTUR, "sweep", *map(str, arguments)]
        if ranks:
            command = [MPIRUN, "--oversubscribe", "-n", str(ranks), *command]
        return subprocess.run(command, capture_output=True, text=True, env=ENVIRONMENT, timeout=600)

    def done(self, *arguments, **keywords):
        result = self.run_sweep(*arguments, **keywords)
        self.assertEqual(result.returncode, 0, f"{arguments}\n{result.stdout}\n{result.stderr}")
        return result

    def in_python(self, script, *arguments):
        """Runs a script by a Python that has xarray; what it prints last is JSON."""
        for python in (sys.executable, "/usr/bin/python3"):
            if subprocess.run([python, "-c", "import xarray, netCDF4"], capture_output=True).returncode == 0:
                result = subprocess.run([python, "-c", script, *map(str, arguments)], capture_output=True, text=True)
                self.assertEqual(result.returncode, 0, result.stderr)
                return json.loads(result.stdout)
        self.skipTest("no Python with xarray and netCDF4")


class Results(Sweep):
    def test_example_101_gaps_and_two_ground_motions(self):
        output = self.folder / "r.nc"
        result = self.done(SOURCE / "examples/studies/m12-gaps.toml", "-o", output)
        self.assertRegex(result.stdout, r"^202 runs, \d+ impacts, 0 failed, 202 with remarks, 0 in doubt, \S+ runs/s \(202 runs in \S+ s\): .*r\.nc\n$")
        self.assertRegex(result.stderr, r"^warning: In 101 of 202 runs it is not known .*\n$", "no progress where nobody watches")
        self.assertFalse(pathlib.Path(f"{output}.part").exists())
        found = self.in_python("""
import json, sys, numpy, xarray
d = xarray.open_dataset(sys.argv[1])
one = d.sel(excitation="El Centro")
at = one.sel(width=0.2)
apart = one.where(one.width > one.gap_needed.isel(gap=0), drop=True)
print(json.dumps({
    "force": at.peak_force.values.tolist(), "amplification": at.amplification_1.values.tolist(),
    "duration": at.contact_duration.values.tolist(), "impacts": at.impacts.values.tolist(),
    "other": float(d.peak_force.sel(width=0.35, excitation="harmonic", point=2)),
    "dims": list(d.peak_force.dims), "shape": d.peak_force.shape, "floors": d.elevation_1.values.tolist(),
    "units": [d.width.units, d.peak_force.units, d.peak_acceleration_1.units], "status": int(d.status.sum()),
    "coords": sorted(d.peak_force.coords), "study": d.attrs["study"], "version": d.attrs["bentur_version"],
    "closed": float(one.impacts.sel(width=0).sum()), "needed": float(at.gap_needed[0]),
    "apart": [apart.width.size, float(apart.impacts.sum()), float(abs(apart.amplification_1 - 1).max())],
    "first_apart": float(apart.width[0])}))
""", output)
        self.assertEqual(found["dims"], ["width", "excitation", "point"])
        self.assertEqual(found["shape"], [101, 2, 3])
        self.assertEqual(found["floors"], [100, 200, 300])
        self.assertEqual(found["units"], ["cm", "kgf", "cm s-2"])
        self.assertEqual(found["coords"], ["excitation", "point_elevation", "point_left", "point_right", "width"])
        self.assertEqual(found["status"], 0)
        self.assertEqual(found["study"], (SOURCE / "examples/studies/m12-gaps.toml").read_text())
        # The same gap by itself, whose numbers the README shows.
        summary = json.loads(subprocess.run([BENTUR, "run", SOURCE / "examples/m12-el-centro.toml", "--json"],
                                            capture_output=True, text=True, check=True).stdout)
        self.assertEqual(found["version"], summary["version"])
        points = summary["gaps"][0]["points"]
        for name, key in (("force", "peak_force"), ("duration", "contact_duration"), ("impacts", "impacts")):
            for value, point in zip(found[name], points):
                self.assertAlmostEqual(value, point[key], delta=1e-9 * abs(point[key]))
        for value, expected in zip(found["amplification"], summary["buildings"][0]["amplification"]):
            self.assertAlmostEqual(value, expected, delta=1e-12)
        self.assertAlmostEqual(found["force"][2], 3817.5, delta=0.05)
        self.assertEqual(found["impacts"], [0, 8, 29])
        # Closed from the start they pound at every floor; past the gap they need they never do.
        self.assertGreater(found["closed"], 37)
        self.assertAlmostEqual(found["needed"], 0.7262, delta=5e-5)
        self.assertEqual(found["apart"][:2], [28, 0])
        self.assertLess(found["apart"][2], 1e-14)  # the two responses round apart
        self.assertEqual(found["first_apart"], 0.73)
        # One point of the other half by itself.
        case = (SOURCE / "examples/m12-el-centro.toml").read_text().split("[excitation]")[0]
        case = case.replace("width = 0.2 ", "width = 0.35 ") + """
[excitation]
kind = "harmonic"
period = 0.3
displacement_amplitude = 1.0
delays = [0.0, 0.1]
[analysis]
duration = 10.0
"""
        self.assertIn("width = 0.35", case)
        other = json.loads(subprocess.run([BENTUR, "run", self.study(case, "case.toml"), "--json"],
                                          capture_output=True, text=True, check=True).stdout)
        force = other["gaps"][0]["points"][2]["peak_force"]
        self.assertGreater(force, 0)
        self.assertAlmostEqual(found["other"], force, delta=1e-9 * force)

    def test_gaps_and_ground_motions_meet_the_answers_of_another_program(self):
        reference = SHARED / "reference"
        if not reference.exists():
            self.skipTest("the answers of ../shared are not here")
        study = self.study(f"""
case = "{reference / 'm12-el-centro-gap-02.toml'}"
[[vary]]
parameter = "gap[0].width"
values = [0.0, 0.2, 0.4]
[[vary]]
parameter = "excitation"
together = "motion"
labels = ["El Centro", "harmonic"]
values = [{{ kind = "record", file = "../records/el-centro-1940-s00e.txt", unit = "g", pga = 341.7, delays = [0.0, 0.1] }},
          {{ kind = "harmonic", period = 0.3, displacement_amplitude = 1.0, delays = [0.0, 0.1] }}]
[[vary]]
parameter = "analysis.duration"
together = "motion"
values = [10.0, 6.0]
""")
        output = self.folder / "r.nc"
        self.done(study, "-o", output)
        found = self.in_python("""
import json, sys, xarray
d = xarray.open_dataset(sys.argv[1])
at = lambda width, motion: {"force": d.peak_force.sel(width=width)[motion].values.tolist(),
    "duration": d.contact_duration.sel(width=width)[motion].values.tolist(),
    "amplification": d.amplification_2.sel(width=width)[motion].values.tolist()}
print(json.dumps([at(0, 0), at(0.2, 0), at(0.4, 0), at(0.2, 1)]))
""", output)
        names = ["el-centro-touching", "el-centro-gap-02", "el-centro-gap-04", "harmonic-gap-02"]
        for name, one in zip(names, found, strict=True):
            expected = json.loads((reference / f"m12-{name}.expected.json").read_text())
            points = expected["gaps"][0]["points"]
            for key, kind, values in (("force", "peak_force", [p["peak_force"] for p in points]),
                                      ("duration", "contact_duration", [p["contact_duration"] for p in points]),
                                      ("amplification", "amplification", expected["buildings"][1]["amplification"])):
                tolerance = expected["tolerance"]["relative"][kind]
                for value, other in zip(one[key], values, strict=True):
                    self.assertAlmostEqual(value, other, delta=tolerance * max(map(abs, values)), msg=f"{name} {key}")

    def test_samples_have_one_dimension_and_coordinates(self):
        study = self.study(f"""
case = "{SOURCE / 'examples/m12-el-centro.toml'}"
[sampling]
method = "latin-hypercube"
count = 40
[[vary]]
parameter = "gap[0].width"
from = 0.1
to = 0.5
[[vary]]
parameter = "excitation.pga"
values = [200, 400]
[[vary]]
parameter = 'building["Model 1"].frame.elastic_modulus'
factor = true
name = "modulus"
distribution = {{ lognormal = {{ median = 1, cov = 0.1 }} }}
""")
        output = self.folder / "r.nc"
        self.done(study, "-o", output)
        found = self.in_python("""
import json, sys, numpy, xarray
d = xarray.open_dataset(sys.argv[1])
period = d.first_period_1.values * numpy.sqrt(d.modulus.values)
print(json.dumps({"dims": list(d.peak_force.dims), "coords": sorted(d.peak_force.coords),
    "units": [d.width.units, d.pga.units, d.modulus.units], "pga": float(abs(d.pga - d.peak_ground_acceleration).max()),
    "weak": int((d.pga == 200).sum()), "slices": sorted(((d.width.values - 0.1) / 0.01).astype(int).tolist()),
    "period": [period.min(), period.max()],
    "width": float(abs(d.point_width - d.width).max())}))
""", output)
        self.assertEqual(found["dims"], ["sample", "point"])
        self.assertEqual(found["coords"], ["modulus", "pga", "point_elevation", "point_left", "point_right", "width"])
        self.assertEqual(found["units"], ["cm", "cm s-2", "1"])
        self.assertLess(found["pga"], 1e-9)
        self.assertEqual(found["weak"], 20)
        self.assertEqual(found["slices"], list(range(40)))
        self.assertEqual(found["width"], 0)
        # T₁ goes with one over the root of the modulus, but for the masses being the same to round-off.
        self.assertLess(found["period"][1] / found["period"][0] - 1, 1e-12)

    def test_a_run_that_fails_is_marked_and_the_rest_goes_on(self):
        study = self.study(f"""
case = "{SOURCE / 'examples/m12-el-centro.toml'}"
[[vary]]
parameter = "excitation.pga"
values = [341.7, 1e307]
""")
        output = self.folder / "r.nc"
        result = self.done(study, "-o", output)
        self.assertIn("2 runs, 37 impacts, 1 failed", result.stdout)
        self.assertRegex(result.stderr, r"warning: run 1: .* t = [0-9.]+ s")
        found = self.in_python("""
import json, sys, numpy, xarray
d = xarray.open_dataset(sys.argv[1])
print(json.dumps({"status": d.status.values.tolist(), "message": d.message.values.tolist(),
                  "impacts": float(d.impacts.sel(pga=341.7).sum()), "nan": bool(d.impacts.isel(pga=1).isnull().all())}))
""", output)
        self.assertEqual(found["status"], [0, 1])
        self.assertEqual(found["message"][0], "")
        self.assertRegex(found["message"][1], r"t = [0-9.]+ s")
        self.assertEqual(found["impacts"], 37)
        self.assertTrue(found["nan"])

    def test_what_moves_together_is_chosen_by_its_labels_or_by_number(self):
        study = self.study(f"""
case = "{SOURCE / 'examples/m12-el-centro.toml'}"
[[vary]]
parameter = "gap[0].width"
together = "pair"
values = [0.2, 0.4]
[[vary]]
parameter = "excitation.pga"
together = "pair"
values = [200, 400]
[[vary]]
parameter = "excitation.delays"
together = "wave"
labels = ["late", "at once"]
values = [[0.0, 0.1], [0.0, 0.0]]
[[vary]]
parameter = "analysis.duration"
together = "wave"
values = [10.0, 5.0]
""")
        output = self.folder / "r.nc"
        self.done(study, "-o", output)
        found = self.in_python("""
import json, sys, xarray
d = xarray.open_dataset(sys.argv[1])
one = d.sel(pair=1, wave="late")
print(json.dumps({"pair": d.pair.values.tolist(), "wave": d.wave.values.tolist(), "pga": float(one.pga),
                  "same": bool((one.peak_force == d.peak_force[1, 0]).all()), "duration": float(one.duration),
                  "dims": list(d.peak_force.dims)}))
""", output)
        self.assertEqual(found, {"pair": [0, 1], "wave": ["late", "at once"], "pga": 400, "same": True, "duration": 10,
                                 "dims": ["pair", "wave", "point"]})
        # A figure has along its axis what varies, not its number.
        picture = self.folder / "p.svg"
        subprocess.run([BENTUR, "plot", output, "peak-force", "--at", "wave=late", "-o", picture], check=True, capture_output=True)
        self.assertIn("Gap width w", picture.read_text())

    def test_a_distribution_whose_bounds_leave_nothing_is_said_so_in_plain_words(self):
        for kind in "normal = { mean = 0.05, cov = 0.1, low = 0.9, high = 1.0 }", \
                "lognormal = { median = 0.05, cov = 0.05, low = 0.9, high = 1.0 }", \
                "normal = { mean = 0.9, cov = 0.01, high = 0.1 }":
            study = self.study(f"""
case = "{SOURCE / 'examples/m12-el-centro.toml'}"
[sampling]
method = "sobol"
count = 8
[[vary]]
parameter = "gap[0].width"
distribution = {{ {kind} }}
""")
            result = self.run_sweep(study, "-o", self.folder / "r.nc")
            self.assertEqual(result.returncode, 2, result.stderr)
            self.assertRegex(result.stderr, r"study\.toml:8:\d+: error: .* standard deviations from its (mean|median) 0\.\d+")
            self.assertNotIn("boost", result.stderr)

    def test_check_says_what_would_run(self):
        result = self.done(SOURCE / "examples/studies/m12-gaps.toml", "--check")
        self.assertIn("202 runs\n  width: 101 values\n  excitation: 2 values\n", result.stdout)


    def test_a_log_says_now_and_then_how_far_it_is(self):
        study, out = self.widths(4000), self.folder / "out.nc"
        command = [BENTUR, "sweep", study, "-o", out, "--threads", "1"]
        env = {**ENVIRONMENT, "BENTUR_LOG_SECONDS": "0.05"}
        told = subprocess.run(command, capture_output=True, text=True, env=env, timeout=600).stderr.splitlines()
        self.assertGreater(len(told), 1)
        for line in told[:-1]:
            self.assertRegex(line, r"^\d+ of 4000 runs, [\d.]+ runs/s(, .* left)?$")
        self.assertIn("In 4000 of 4000 runs it is not known what gap they need", told[-1])  # the record goes on
        again = subprocess.run([*command, "--force", "-q"], capture_output=True, text=True, env=env, timeout=600)
        self.assertEqual(again.stderr, told[-1] + "\n")
        out.unlink()
        self.assertEqual(self.done(study, "-o", out).stderr, told[-1] + "\n")  # it takes less than a minute


class Identical(Sweep):
    def test_threads_and_ranks_do_not_show(self):
        study = self.widths(60)
        self.done(study, "-o", self.folder / "one.nc", "--threads", 1)
        expected = (self.folder / "one.nc").read_bytes()
        self.done(study, "-o", self.folder / "two.nc", "--threads", 2)
        self.assertEqual((self.folder / "two.nc").read_bytes(), expected)
        if not MPIRUN:
            self.skipTest("threads agree; no mpirun, or built without MPI")
        for ranks in (2, 4):
            self.done(study, "-o", self.folder / "ranks.nc", ranks=ranks)
            self.assertEqual((self.folder / "ranks.nc").read_bytes(), expected, f"{ranks} ranks")

    def test_an_error_is_said_once_by_all_ranks_together(self):
        if not MPIRUN:
            self.skipTest("no mpirun, or built without MPI")
        study = self.study(self.widths(3).read_text().replace("width", "widht"))
        result = self.run_sweep(study, "-o", self.folder / "r.nc", ranks=3)
        self.assertEqual(result.returncode, 2, result.stderr)
        self.assertEqual(result.stderr.count("gap[0].widht is not a known key"), 1)


class Interrupted(Sweep):
    def setUp(self):
        super().setUp()
        self.output = self.folder / "r.nc"
        self.part = self.folder / "r.nc.part"
        began = time.monotonic()
        self.done(self.widths(100), "-o", self.folder / "trial.nc")
        # So many runs that there is time to interrupt them, with or without sanitizers.
        self.count = min(6000, max(100, int(100 * 2.5 / (time.monotonic() - began))))
        self.path = self.widths(self.count)

    def begin(self, *arguments, ranks=0):
        command = [BENTUR, "sweep", str(self.path), "-o", str(self.output), *arguments]
        if ranks:
            command = [MPIRUN, "--oversubscribe", "-n", str(ranks), *command]
        process = subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True,
                                   env=ENVIRONMENT, start_new_session=True)
        self.addCleanup(process.stderr.close)
        self.addCleanup(process.stdout.close)
        return process

    def wait_for_work(self, process, least=1):
        """Until so many runs are in the journal, or the program has ended."""
        while process.poll() is None:
            if self.part.exists() and journal_done(self.part)[0] >= least:
                return True
            time.sleep(0.002)
        return False

    def solved(self, result):
        """How many runs the program says it has solved."""
        return int(re.search(r"\((\d+) runs in", result.stdout)[1])

    def finish(self, expected, **keywords):
        """Goes on to the end: solves what is missing and nothing else, and gives the expected bytes."""
        before = journal_done(self.part)[0] if self.part.exists() else 0
        if self.part.exists() or not self.output.exists():
            result = self.done(self.path, "-o", self.output, "--resume", **keywords)
            self.assertEqual(self.solved(result), self.count - before, "what was done is not done again")
        self.assertFalse(self.part.exists())
        self.assertEqual(self.output.read_bytes(), expected)

    def test_control_c_stops_cleanly_and_says_how_to_go_on(self):
        for ranks in (0, 2) if MPIRUN else (0,):
            for times in (3, 10, 30, 100, 300, 1000):  # on a busy machine the signal may come when all is done
                self.path = self.widths(times * self.count)
                process = self.begin(ranks=ranks)
                if self.wait_for_work(process):
                    process.send_signal(signal.SIGINT)
                out, err = process.communicate(timeout=600)
                if self.part.exists():
                    done, runs = journal_done(self.part)
                    if done < runs:
                        break
                    self.part.unlink()
                self.output.unlink(missing_ok=True)
            self.assertNotEqual(process.returncode, 0)
            done, runs = journal_done(self.part)
            self.assertLess(done, runs)
            self.assertEqual(out, "")
            if ranks == 0:  # mpirun has its own status and words
                self.assertEqual(process.returncode, 1, err)
                self.assertEqual(err, f"Stopped: {done} of {runs} runs are done and kept in {self.part}; the same "
                                      "command with --resume goes on\n")
            self.done(self.path, "-o", self.output, "--resume")
            self.assertFalse(self.part.exists())

    def test_resume_of_finished_work_does_none(self):
        self.path = self.widths(20)
        self.done(self.path, "-o", self.output)
        before = self.output.read_bytes(), self.output.stat().st_mtime_ns, self.output.stat().st_ino
        for ranks in (0, 3) if MPIRUN else (0,):
            result = self.done(self.path, "-o", self.output, "--resume", ranks=ranks)
            self.assertEqual(result.stdout, f"20 runs were done before, nothing to do: {self.output}\n")
            self.assertEqual((self.output.read_bytes(), self.output.stat().st_mtime_ns, self.output.stat().st_ino), before)
            self.assertFalse(self.part.exists())
        # Of another study they are not gone on with, and not lost.
        text = self.path.read_text()
        self.path.write_text(text.replace("to = 1.0", "to = 1.5"))
        changed = self.run_sweep(self.path, "-o", self.output, "--resume")
        self.assertEqual(changed.returncode, 1)
        self.assertIn("begun with another study: line 5 has changed", changed.stderr)
        self.assertEqual(self.output.read_bytes(), before[0])
        self.done(self.path, "-o", self.output)
        self.assertNotEqual(self.output.read_bytes(), before[0])

    def test_a_journal_is_neither_overwritten_nor_mixed(self):
        for times in (1, 10, 100):  # until it is killed before its end, however fast the machine is
            self.path = self.widths(times * self.count)
            process = self.begin()
            self.wait_for_work(process)
            process.kill()
            process.wait()
            if self.part.exists():
                break
            self.output.unlink()
        again = self.run_sweep(self.path, "-o", self.output)
        self.assertEqual(again.returncode, 1)
        self.assertIn("go on with --resume, or remove the file", again.stderr)
        text = self.path.read_text()
        self.path.write_text(text.replace("to = 1.0", "to = 1.5"))
        changed = self.run_sweep(self.path, "-o", self.output, "--resume")
        self.assertEqual(changed.returncode, 1)
        self.assertIn("was begun with another study: line 5 has changed", changed.stderr)
        self.path.write_text(text)
        self.done(self.path, "-o", self.output, "--resume")

    def test_killed_at_any_moment_nothing_is_lost(self):
        self.done(self.path, "-o", self.folder / "whole.nc")
        expected = (self.folder / "whole.nc").read_bytes()
        generator = random.Random()
        seed = generator.randrange(1 << 30)
        generator.seed(seed)
        kinds = ["process"] + (["rank", "all"] if MPIRUN else [])
        for turn in range(ROUNDS):
            with self.subTest(round=turn, seed=seed):
                self.output.unlink(missing_ok=True)
                for kind in kinds:  # each goes on where the one before was killed
                    process = self.begin("--resume", ranks=0 if kind == "process" else 3)
                    before = journal_done(self.part)[0] if self.part.exists() else 0
                    least = before + generator.randrange(1, max(2, (self.count - before) // 3))
                    if self.wait_for_work(process, least):
                        time.sleep(generator.uniform(0, 0.05))
                        self.kill(process, kind, generator)
                    process.communicate(timeout=600)
                    if self.part.exists():
                        self.assertGreaterEqual(journal_done(self.part)[0], min(least, self.count))
                self.finish(expected, ranks=2 if MPIRUN and turn % 2 else 0)

    def kill(self, process, kind, generator):
        if kind == "rank":  # one of them; mpirun then ends the others
            children = subprocess.run(["ps", "-o", "pid=", "--ppid", str(process.pid)], capture_output=True, text=True)
            ranks = [int(pid) for pid in children.stdout.split()]
            if ranks:
                try:
                    os.kill(generator.choice(ranks), signal.SIGKILL)
                except ProcessLookupError:
                    pass  # finished in the meantime
                return
        os.killpg(process.pid, signal.SIGKILL) if kind != "all" else self.kill_tree(process)

    def kill_tree(self, process):
        children = subprocess.run(["ps", "-o", "pid=", "--ppid", str(process.pid)], capture_output=True, text=True)
        for pid in [process.pid, *map(int, children.stdout.split())]:
            try:
                os.kill(pid, signal.SIGKILL)
            except ProcessLookupError:
                pass


def load_tests(loader, tests, pattern):
    return part_under_sanitizers(tests, 3)


if __name__ == "__main__":
    if "--rounds" in sys.argv:
        place = sys.argv.index("--rounds")
        ROUNDS = int(sys.argv[place + 1])
        del sys.argv[place:place + 2]
    shared_folder.main(verbosity=2)
