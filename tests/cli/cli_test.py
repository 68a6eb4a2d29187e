#!/usr/bin/env python3
"""Every command of bentur as a user meets it: output, files, exit statuses, help, completion.

The program under test is the environment variable BENTUR, the repository BENTUR_SOURCE.
"""

import csv
import html
import itertools
import json
import math
import os
import pathlib
import pty
import random
import re
import resource
import shlex
import shutil
import signal
import stat
import subprocess
import sys
import tempfile
import time
import unicodedata
import unittest
from collections import Counter

sys.path.insert(0, os.path.join(os.environ["BENTUR_SOURCE"], "tests"))
from part import part_under_sanitizers

BENTUR = os.environ["BENTUR"]
SOURCE = pathlib.Path(os.environ["BENTUR_SOURCE"])
BASH = os.environ.get("BENTUR_BASH", "bash")
SANITIZED = os.environ.get("BENTUR_SANITIZED") == "1"
EXAMPLES = ["m12-el-centro", "breaking-column", "frame-and-wall", "free-impact", "generic-neighbour", "hinged-frame", "isolated-moat", "kelvin-voigt-pair", "linked-pair",
            "m12-harmonic", "m12-runge-kutta", "restitution-asked", "row-of-three", "struck-column", "two-frames-si",
            "yielding-pair"]
STUDIES = {"linked-pair-damper": "remedy", "m12-gap-period": "sweep", "m12-gaps": "sweep", "two-frames-ida": "ida"}
EL_CENTRO = SOURCE / "examples" / "m12-el-centro.toml"
COMMANDS = ["run", "report", "gap", "sweep", "ida", "fragility", "risk", "remedy", "sensitivity", "modes", "check", "spectrum", "plot", "example",
            "import", "schema"]


def bentur(*arguments, cwd=None, env=None):
    return subprocess.run([BENTUR, *map(str, arguments)], capture_output=True, text=True, cwd=cwd, env=env, timeout=120)


class CommandLine(unittest.TestCase):
    def setUp(self):
        self.folder = pathlib.Path(tempfile.mkdtemp(prefix="bentur-cli-"))
        self.addCleanup(shutil.rmtree, self.folder)

    def done(self, *arguments, **keywords):
        result = bentur(*arguments, **keywords)
        self.assertEqual(result.returncode, 0, f"{arguments}\n{result.stderr}")
        return result

    def fails(self, status, *arguments, **keywords):
        result = bentur(*arguments, **keywords)
        self.assertEqual(result.returncode, status, f"{arguments}\n{result.stdout}\n{result.stderr}")
        self.assertEqual(result.stdout, "", "errors go to standard error alone")
        self.assertTrue(result.stderr.strip(), "a failure says why")
        self.assertNotIn("terminate called", result.stderr)
        return result

    def written(self, name):
        self.done("example", name, "-o", self.folder)
        return self.folder / f"{name}.toml"

    def edited(self, name, old, new):
        file = self.written(name)
        text = file.read_text()
        self.assertIn(old, text)
        file.write_text(text.replace(old, new))
        return file


class Numerics(CommandLine):
    def test_numbers_that_fail_are_status_3_with_reason_and_time(self):
        case = self.edited("m12-el-centro", "pga = 341.7", "pga = 1e307")
        message = self.fails(3, "run", case, "-o", self.folder / "out").stderr
        self.assertRegex(message, r"no longer a finite number at t = [0-9.]+ s")
        self.assertFalse((self.folder / "out" / "summary.json").exists())


class Bounds(CommandLine):
    """What a run takes is said, limited, shown and can be stopped."""

    def stiff(self):
        case = self.folder / "stiff.toml"
        storeys = "storey_heights = [3.0, 3.0], masses = [30e3, 25e3]"
        case.write_text(f'''
[[building]]
name = "A"
damping = 0.05
stick = {{ {storeys}, stiffnesses = [40e6, 3e21] }}

[[building]]
name = "B"
damping = 0.05
stick = {{ {storeys}, stiffnesses = [60e6, 50e6] }}

[[gap]]
between = ["A", "B"]
width = 0.001
contact = {{ law = "linear", stiffness = 3e8 }}

[excitation]
kind = "harmonic"
period = 0.4
displacement_amplitude = 0.05

[analysis]
duration = 5.0
''')
        return case

    def endless(self):
        """No machine comes to the end of it before it is stopped."""
        case = self.stiff()
        case.write_text(case.read_text().replace("duration = 5.0", "duration = 1e5\noutput_step = 10.0\nlimits = { steps = 1e15 }"))
        return case

    @staticmethod
    def processor_time(process):
        """[s]"""
        times = pathlib.Path(f"/proc/{process.pid}/stat").read_text().rpartition(")")[2].split()[11:13]
        return sum(map(int, times)) / os.sysconf("SC_CLK_TCK")

    def with_duration(self, text):
        case = self.folder / "m12-harmonic.toml"
        case.unlink(missing_ok=True)
        self.written("m12-harmonic")
        kept = [line for line in case.read_text().splitlines() if not line.startswith(("duration", "output_step"))]
        case.write_text("\n".join(kept).replace("[analysis]", f"[analysis]\nduration = {text}") + "\n")
        return case

    def test_check_says_what_a_run_takes(self):
        text = self.done("check", self.written("m12-el-centro")).stdout
        self.assertRegex(text, r"\nFastest: [0-9.]+ Hz, mode 3 of Model [12]\nFastest in contact: [0-9.]+ Hz, the contact of")
        steps = float(re.search(r"\nA run takes ([0-9.]+) steps,", text)[1])
        in_contact = float(re.search(r"and ([0-9.]+) for every second in contact", text)[1])
        document = json.loads(self.done("run", self.folder / "m12-el-centro.toml", "--json").stdout)
        taken, events = document["solver"]["steps"], document["solver"]["events"]
        time = sum(point["contact_duration"] for point in document["gaps"][0]["points"])
        self.assertLessEqual(steps, taken)
        self.assertLess(taken, steps + in_contact * time + 6 * events)
        self.assertRegex(text, r"histories [0-9]+ samples; memory [0-9]+ MB\n")
        self.assertNotIn("may take", text)

    def test_a_long_run_is_announced_and_ends_at_its_limit(self):
        case = self.stiff()
        self.assertRegex(self.done("check", case).stdout, r"(?s)may take up to some [0-9]+ (s|min) .*mode\s+2\s+of\s+A")
        case.write_text(case.read_text() + "limits = { steps = 1e5 }\n")
        message = self.fails(3, "run", case).stderr
        self.assertIn("the limit of 100000 steps is reached at t = ", message)

    def test_what_certainly_exceeds_a_limit_is_refused_before_work(self):
        for limit in ("output_step = 1.1e-5\nlimits = { memory = 100 }", "limits = { steps = 100 }"):
            with self.subTest(limit):
                case = self.with_duration("20.0\n" + limit)
                for command in (["check", case], ["run", case, "-o", self.folder / "out"]):
                    message = self.fails(2, *command).stderr
                    self.assertRegex(message, r"over the limit of 100\b")
                    self.assertIn("limits = {", message)

    @unittest.skipIf(SANITIZED, "the sanitizers reserve more memory than is allowed here")
    def test_memory_that_is_not_there_is_said(self):
        case = self.with_duration("100.0\noutput_step = 1.1e-5\nlimits = { memory = 1e6 }")
        size = 600 << 20
        result = subprocess.run([BENTUR, "run", case, "-o", self.folder / "out"], capture_output=True, text=True,
                                preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_AS, (size, size)))
        self.assertEqual((result.returncode, result.stdout), (3, ""), result.stderr)
        self.assertIn("the memory of this machine is not enough", result.stderr)
        self.assertFalse((self.folder / "out" / "summary.json").exists())

    def start_on_terminal(self, *arguments):
        ours, theirs = pty.openpty()
        self.addCleanup(os.close, ours)
        process = subprocess.Popen([BENTUR, *map(str, arguments)], stdout=subprocess.PIPE, stderr=theirs)
        os.close(theirs)
        return process, ours

    def read_until(self, terminal, pattern):
        text = ""
        while not re.search(pattern, text):
            try:
                text += os.read(terminal, 4096).decode()
            except OSError:  # the other side is closed
                break
        self.assertRegex(text, pattern)
        return text

    @unittest.skipIf(SANITIZED, "a minute there")
    def test_a_case_that_takes_more_than_a_second_to_check_says_what_is_done(self):
        case = self.folder / "tall.toml"
        storeys = {"storey_heights": [3] * 1000, "masses": [100] * 1000, "stiffnesses": [1e6] * 1000}
        stick = "{ " + ", ".join(f"{key} = {value}" for key, value in storeys.items()) + " }"
        case.write_text(f"""[units]\nlength = "m"\nforce = "kN"
[[building]]\nname = "tall"\ndamping = 0.05\nstick = {stick}
[[building]]\nname = "taller"\ndamping = 0.05\nstick = {stick}
[[gap]]\nbetween = ["tall", "taller"]\nwidth = 0.1\ncontact = {{ law = "linear", stiffness = 1e6 }}
[excitation]\nkind = "harmonic"\nperiod = 0.5\ndisplacement_amplitude = 0.01\n[analysis]\nduration = 1\n""")
        process, terminal = self.start_on_terminal("check", case)
        self.read_until(terminal, "computing the modes of its buildings")
        self.read_until(terminal, r"\x1b\[K")
        self.assertIn(b"1000 floors", process.communicate(timeout=120)[0])
        self.assertEqual(process.returncode, 0)

    def test_progress_on_a_terminal_and_what_a_stop_leaves(self):
        case = self.endless()
        process, terminal = self.start_on_terminal("run", case, "-o", self.folder / "out")
        self.addCleanup(process.stdout.close)
        self.read_until(terminal, r"[0-9]+ % of the duration simulated")
        process.send_signal(signal.SIGINT)
        self.read_until(terminal, r"Stopped at [0-9]+ % of the work. Nothing is written")
        self.assertEqual(process.wait(timeout=60), 1)
        self.assertFalse((self.folder / "out" / "summary.json").exists())

    def test_no_progress_in_a_pipe(self):
        process = subprocess.Popen([BENTUR, "run", self.endless()], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        while self.processor_time(process) < 2.5:  # longer than what is said of work that takes its time
            time.sleep(0.05)
        process.send_signal(signal.SIGTERM)
        _, message = process.communicate(timeout=60)
        self.assertNotIn("\r", message)
        self.assertIn("Stopped at", message)


class Remarks(CommandLine):
    def test_what_is_unusual_is_said_everywhere(self):
        case = self.edited("m12-el-centro", "elastic_modulus = 2.1e5", "elastic_modulus = 2.1e3")
        self.assertNotIn("remark", self.done("check", SOURCE / "examples" / "m12-el-centro.toml").stdout)
        expected = r"IN DOUBT: Model 1, Model 2: the elastic modulus is 2100 kgf/cm², usual are 100000 to 2100000 kgf/cm²"
        self.assertRegex(self.done("check", case).stdout, expected)
        self.assertRegex(self.done("run", case).stdout, expected)
        keys = [remark["key"] for remark in json.loads(self.done("run", case, "--json").stdout)["remarks"]]
        self.assertIn("elastic_modulus", keys)
        for language, word in [("en", "usual are 100000 to"), ("id", "lazimnya 100000 sampai")]:
            file = self.folder / f"{language}.html"
            self.done("report", case, "-o", file, "--lang", language)
            self.assertIn(word, file.read_text())

    def test_milliseconds_taken_for_seconds_are_remarked_on(self):
        """The same motion in ms: 200 values every 10 s leave the buildings apart, and every door says that it is odd."""
        record = self.folder / "ms.csv"
        values = [0.1 * math.sin(0.3 * i) for i in range(200)]
        record.write_text("".join(f"{10 * i},{value:.5f}\n" for i, value in enumerate(values)))
        case = self.edited("m12-el-centro", 'file = "el-centro-1940-ns.csv"', f'file = "{record}"')
        for command in ("check", "run"):
            text = " ".join(self.done(command, case).stdout.split())
            self.assertIn("IN DOUBT: the record has a value every 10 s, usual is up to 0.05 s. Are these milliseconds", text)
            self.assertIn("remark: the record is 1990 s long, usual are 5 to 600 s.", text)
        keys = [remark["key"] for remark in json.loads(self.done("run", case, "--json").stdout)["remarks"]]
        self.assertTrue({"record_step", "record_length"} <= set(keys), keys)
        text = " ".join(self.done("spectrum", record, "--unit", "g").stdout.split())
        self.assertTrue(text.endswith("is it the whole record?"), text[-500:])
        self.assertIn("Are these milliseconds, or the numbers of rows?", text)
        document = json.loads(self.done("spectrum", record, "--unit", "g", "--json").stdout)
        self.assertEqual([remark["key"] for remark in document["remarks"]], ["record_step", "record_length"])
        result = self.done("spectrum", record, "--unit", "g", "-o", self.folder / "ms-spectrum.csv")
        self.assertIn("IN DOUBT: the record has a value every 10 s", result.stderr)
        # 94.87 g, because cm/s2 were called g.
        record.write_text("".join(f"{0.01 * i:.2f},{949 * value:.4f}\n" for i, value in enumerate(values * 3)))
        self.assertIn("peak ground acceleration is 94.", self.done("spectrum", record, "--unit", "g").stdout)

    def test_the_model_is_stated(self):
        self.assertIn("The model: linear elastic buildings", self.done("run").stdout)

    def test_weight_and_base_shear(self):
        document = json.loads(self.done("run", "--json").stdout)
        building = document["buildings"][0]
        # Three beams and five halves of two columns, in kgf: 0.612 + 2 · 0.024 · 2.5 times 980.
        gravity = 980.0
        self.assertAlmostEqual(building["weight"] / ((0.206 + 2 * 0.203 + 0.024 * 2 * 2.5) * gravity), 1, delta=1e-12)
        self.assertAlmostEqual(building["base_shear_coefficient"], building["peak_storey_shear"][0] / building["weight"])
        self.assertAlmostEqual(building["period_per_storey"], building["periods"][0] / 3)
        self.assertIn(f"Base shear {building['base_shear_coefficient']:.4g} of the weight; weight",
                      self.done("run").stdout)


class Readme(CommandLine):
    def test_the_sample_is_what_the_program_prints(self):
        readme = (SOURCE / "README.md").read_text()
        sample = readme.split("<!-- sample -->")[1].split("```\n")[1].rstrip()
        self.assertTrue(self.done("run").stdout.startswith(sample + "\n"))


class FramesThatYield(CommandLine):
    """The reason why: numbers of README and of the example, which an independent program computed too."""

    def roof(self, text):
        case = self.folder / "frame-and-wall.toml"
        case.write_text(text)
        frame = json.loads(self.done("run", case, "--json").stdout)["buildings"][0]
        return frame["peak_displacement_no_contact"][-1], frame["peak_displacement"][-1], frame["amplification"][-1]

    def test_an_elastic_frame_can_tell_the_opposite(self):
        hinged = self.written("frame-and-wall").read_text()
        elastic, count = re.subn(r", moment_capacity = [0-9.]+, hardening = [0-9.]+", "", hinged)
        self.assertEqual(count, 2)
        reference = {hinged: (0.1723136741973112, 0.2385584515274739, 1.3844429505595),
                     elastic: (0.11944352567253175, 0.06241716085546586, 0.5225662965323857)}
        said = re.sub(r"\s+", " ", (SOURCE / "README.md").read_text())
        for text, wanted in reference.items():
            found = self.roof(text)
            for one, other in zip(found, wanted):
                self.assertAlmostEqual(one, other, delta=1e-8 * other)
            for page in said, hinged:
                for number in f"{found[0]:.4f} m", f"{found[1]:.4f} m", f"{found[2]:.2f}":
                    self.assertIn(number, page)


class Restitution(CommandLine):
    """examples/restitution-asked: each contact is hit once, freely."""

    def test_the_documented_table_is_what_the_program_prints(self):
        for document in (SOURCE / "docs").rglob("*.md"):
            for block in document.read_text().split("<!-- restitution -->")[1::2]:
                table = block.split("```\n")[1].rstrip()
                self.assertIn("obtained", table)
                self.assertIn(table + "\n", self.done("run", SOURCE / "examples" / "restitution-asked.toml").stdout)
                return
        self.fail("no table in docs/")

    def test_exact_calibration_gives_what_is_asked_and_the_published_ones_what_they_do(self):
        case = self.written("restitution-asked")
        document = json.loads(self.done("run", case, "--json").stdout)
        # Springs of 1 N/m change the speeds by less than a part in 1e7 during an impact.
        obtained = {"published": {"kelvin-voigt": 0.675, "kelvin-voigt-approach": 0.654, "jankowski": 0.647},
                    "muthukumar-desroches": {"hertz-damp": 0.775}, "ye": {"hertz-damp": 0.630}}
        seen = set()
        for gap in document["gaps"]:
            point, = gap["points"]
            self.assertEqual(point["impacts"], 1)
            contact, restitution = point["contact"], point["restitution"]
            self.assertEqual(restitution["smallest"], restitution["largest"])
            calibration = contact.get("calibration", "exact")
            seen.add((contact["law"], calibration))
            if restitution["asked"] is None:
                self.assertAlmostEqual(restitution["largest"], 0.739, delta=5e-4)  # Hunt-Crossley's damping_factor
            elif calibration == "exact":
                self.assertAlmostEqual(restitution["largest"], 0.65, delta=1e-7)
            else:
                self.assertAlmostEqual(restitution["largest"], obtained[calibration][contact["law"]], delta=5e-4)
            self.assertEqual(point["peak_tension"] > 1, contact.get("release") == "separation")
        self.assertEqual(len(seen), 10)


class Solvers(CommandLine):
    def peaks(self, case, solver):
        text = re.sub(r'solver = "exact".*', solver, case.read_text())
        other = self.folder / "other.toml"
        other.write_text(text)
        return json.loads(self.done("run", other, "--json").stdout)

    def test_three_solvers_one_answer(self):
        case = self.written("kelvin-voigt-pair")
        exact = self.peaks(case, 'solver = "exact"')
        adaptive = self.peaks(case, 'solver = "adaptive"')
        stepwise = self.peaks(case, 'solver = "runge-kutta"\nstep = 0.0005')
        for summary, name in (exact, "exact"), (adaptive, "adaptive"), (stepwise, "runge-kutta"):
            self.assertEqual(summary["solver"]["name"], name)
        self.assertEqual((adaptive["solver"]["tolerance"], stepwise["solver"]["step"]), (1e-9, 0.0005))
        for other in adaptive, stepwise:
            for one, two in zip(exact["buildings"], other["buildings"], strict=True):
                for a, b in zip(one["peak_displacement"], two["peak_displacement"], strict=True):
                    self.assertAlmostEqual(a / b, 1, delta=1e-7)  # a tolerance of 1e-9 in some hundred steps

    def test_energy_audit(self):
        case = self.written("kelvin-voigt-pair")
        self.assertRegex(self.done("run", case).stdout, r"\nEnergy: [0-9.]+ kN·m put in, accounted for within [0-9.]+ × 10\S+ of it\n")
        document = json.loads(self.done("run", case, "--json").stdout)
        self.assertGreater(document["solver"]["peak_input_energy"], 0)
        self.assertLess(document["solver"]["energy_residual"], 1e-9)
        case.write_text(case.read_text().replace("energy_audit = true", "energy_audit = false"))
        plain = json.loads(self.done("run", case, "--json").stdout)
        self.assertIsNone(plain["solver"]["energy_residual"])
        self.assertNotIn("\nEnergy: ", self.done("run", case).stdout)
        self.assertEqual(plain["gaps"], document["gaps"], "the audit changes nothing")

    def test_the_solver_is_named(self):
        self.assertIn("Solver runge-kutta, step 0.006 s:", self.done("run", self.written("m12-runge-kutta")).stdout)
        self.assertIn("solver exact, energy audit", self.done("check", self.written("kelvin-voigt-pair")).stdout)


class StillNeighbour(CommandLine):
    """Nothing that is asked for beside the answer changes it, where a building stands exactly still."""

    def test_run_files_audit_adaptive_and_sweep_find_the_same_impact(self):
        case = self.folder / "case.toml"
        case.write_text((SOURCE / "tests/doors/still-neighbour.toml").read_text())
        plain = json.loads(self.done("run", case, "--json").stdout)
        point, = (p for p in plain["gaps"][0]["points"] if p["impacts"])
        self.assertEqual(point["impacts"], 1)
        self.assertAlmostEqual(point["peak_force"], 383519, delta=1)
        self.done("run", case, "-q", "-o", self.folder / "out")
        audited = self.folder / "audited.toml"
        audited.write_text(case.read_text() + "energy_audit = true\n")
        for other in json.loads((self.folder / "out/summary.json").read_text()), \
                json.loads(self.done("run", audited, "--json").stdout):
            self.assertEqual(other["gaps"], plain["gaps"])
            for one, same in zip(other["buildings"], plain["buildings"]):
                self.assertEqual(one, same)
        adaptive = self.folder / "adaptive.toml"
        adaptive.write_text(case.read_text() + 'solver = "adaptive"\ntolerance = 1e-11\n')
        force = max(p["peak_force"] for p in json.loads(self.done("run", adaptive, "--json").stdout)["gaps"][0]["points"])
        self.assertAlmostEqual(force / point["peak_force"], 1, delta=1e-7)
        study = self.folder / "study.toml"
        study.write_text('case = "case.toml"\n[[vary]]\nparameter = "gap[0].width"\nvalues = [0.0005, 0.001, 0.1]\n')
        self.done("sweep", study, "-o", self.folder / "r.nc")
        self.done("report", self.folder / "r.nc", "-o", self.folder / "r.html")
        self.assertIn("The buildings collide in 2 of 3 runs.",
                      html.unescape((self.folder / "r.html").read_text()).replace("\u00a0", " "))


class Help(CommandLine):
    def test_version(self):
        self.assertRegex(self.done("--version").stdout, r"^bentur \d+\.\d+\.\d+(\.\w+)?(\+g[\w.]+)?\n$")

    def test_every_help_has_an_example_that_names_its_command(self):
        self.assertIn("bentur run", self.done("--help").stdout)
        for command in COMMANDS:
            text = self.done(command, "--help").stdout
            self.assertRegex(text, rf"Example: bentur {command}\b")

    def test_help_tells_the_exit_statuses(self):
        self.assertIn("Exit status: 0 done, 2 bad input, 3 the numbers failed, 1 anything else", self.done("-h").stdout)

    def test_wrong_usage_is_bad_input(self):
        for wrong in ([], ["nonsense"], ["run", "--nonsense"], ["modes"], ["gap"], ["check"], ["run", "a", "b"],
                      ["example", "-o", "somewhere"]):
            with self.subTest(wrong):
                self.fails(2, *wrong)


class Example(CommandLine):
    def test_list(self):
        """One line each, narrow enough for a terminal."""
        result = self.done("example")
        names = [line.split()[0] for line in result.stdout.splitlines()]
        self.assertEqual(names, [*EXAMPLES, *STUDIES])
        for line in result.stdout.splitlines():
            self.assertLessEqual(len(line), 100)
            self.assertGreater(len(line.split()), 4, "a name and a description")

    def test_the_command_that_runs_it_can_be_copied(self):
        for folder in ("plain", "my folder", "it's $HOME; \"so\""):
            said = self.done("example", "free-impact", "-o", self.folder / folder).stderr
            words = shlex.split(said.partition("Run it: ")[2])
            self.assertEqual(words, ["bentur", "run", str(self.folder / folder / "free-impact.toml")])

    def test_studies_are_written_with_their_case_and_record(self):
        for name, command in STUDIES.items():
            with self.subTest(name):
                folder = self.folder / name
                result = self.done("example", name, "-o", folder)
                study = pathlib.Path(result.stdout.strip())
                self.assertEqual(study, folder / f"{name}.toml")
                self.assertIn("#:schema ./bentur-study.schema.json", study.read_text())
                self.assertTrue((folder / "bentur-study.schema.json").exists())
                self.assertIn(f"Run it: bentur {command} ", result.stderr)
                if command != "remedy":
                    self.assertIn("numbers are kept of each run", self.done(command, study, "--check").stdout)

    def test_each_is_written_checked_and_run(self):
        for name in EXAMPLES:
            with self.subTest(name):
                folder = self.folder / name / "deeper"
                case = pathlib.Path(self.done("example", name, "-o", folder).stdout.strip())
                self.assertEqual(case, folder / f"{name}.toml")
                self.done("check", case)
                self.done("modes", case)
                self.done("gap", case)
                result = self.done("run", case)
                self.assertIn("POUNDING", result.stdout)
                for line in result.stdout.splitlines():
                    self.assertLessEqual(len(line), 100, line)

    def test_repository_copy_gives_the_same_numbers(self):
        for name in EXAMPLES:
            with self.subTest(name):
                case = self.written(name)
                summaries = [json.loads(self.done("run", file, "--json").stdout)
                             for file in (case, SOURCE / "examples" / f"{name}.toml")]
                for summary in summaries:
                    del summary["solver"]["wall_time"]
                    summary["excitation"].pop("file", None)
                    del summary["case"]  # it names the record in another folder
                self.assertEqual(*summaries)

    def test_default_folder_is_the_current_one(self):
        self.done("example", "free-impact", "--no-schema", cwd=self.folder)
        self.assertEqual([file.name for file in self.folder.iterdir()], ["free-impact.toml"])
        self.assertEqual((self.folder / "free-impact.toml").read_text(), (SOURCE / "examples" / "free-impact.toml").read_text())

    def test_a_case_names_the_schema_beside_it(self):
        case = self.written("free-impact").read_text().split("\n")
        head = next(n for n, line in enumerate(case) if not line.startswith("#"))
        self.assertEqual(case[head - 1], "#:schema ./bentur.schema.json")
        schema = (self.folder / "bentur.schema.json").read_text()
        self.assertEqual(schema, self.done("schema").stdout)
        self.done("schema", "case", "-o", self.folder / "other.json")
        self.assertEqual((self.folder / "other.json").read_text(), schema)
        self.assertNotEqual(self.done("schema", "study").stdout, schema)
        self.assertIn("not written", self.fails(2, "schema", "-o", self.folder / "free-impact.toml").stderr)

    def test_never_overwrites_an_edited_case(self):
        case = self.written("m12-el-centro")
        self.done("example", "m12-el-centro", "-o", self.folder)
        case.write_text("mine")
        self.assertIn("not written", self.fails(2, "example", "m12-el-centro", "-o", self.folder).stderr)
        self.assertEqual(case.read_text(), "mine")

    def test_unknown_name(self):
        self.assertIn("nonsense", self.fails(2, "example", "nonsense", "-o", self.folder / "new").stderr)
        self.assertFalse((self.folder / "new").exists())


class Run(CommandLine):
    def test_without_case_the_built_in_example_is_run_and_said_so(self):
        before = set(pathlib.Path(tempfile.gettempdir()).glob("bentur-*"))
        result = self.done("run", cwd=self.folder)
        self.assertIn("m12-el-centro", result.stderr)
        self.assertIn("Monograph M1-2, El Centro", result.stdout)
        self.assertEqual(list(self.folder.iterdir()), [], "nothing is written without -o")
        left = set(pathlib.Path(tempfile.gettempdir()).glob("bentur-*")) - before
        self.assertFalse([path for path in left if (path / "m12-el-centro.toml").exists()])

    def test_only_a_bare_run_is_that_of_the_example(self):
        for wrong in [""], ["", "--json"], ["-o", self.folder / "out"], ["--figures", "svg", "-o", self.folder / "out"]:
            with self.subTest(wrong):
                self.fails(2, "run", *wrong)
        self.assertIn("bentur example m12-el-centro", self.fails(2, "run", "-o", self.folder / "out").stderr)
        self.assertEqual(list(self.folder.iterdir()), [])
        self.assertEqual(self.done("run", "--quiet").stderr, "")

    def test_tables_echo_the_record_and_give_units(self):
        text = self.done("run").stdout
        for word in ["1560 values every 0.02 s", "peak 0.3188 g", "applied 341.7 cm/s²", "POUNDING", "Level",
                     "kgf·s", "cm/s²", "Amplification", "Storey shear", "Without contact"]:
            self.assertIn(word, text)
        self.assertLess(text.index("POUNDING"), text.index("Level  "), "the verdict comes first")

    def test_tables_fit_the_width_asked_for(self):
        for width in 60, 80, 100:
            environment = {**os.environ, "COLUMNS": str(width)}
            for command, case, language in itertools.product(("run", "gap"), ("m12-el-centro", "row-of-three", "yielding-pair"), ("en", "id")):
                shown = subprocess.run([BENTUR, command, str(SOURCE / "examples" / f"{case}.toml"), "--lang", language],
                                       capture_output=True, text=True, env=environment, timeout=60).stdout
                self.assertLessEqual(max(map(len, shown.splitlines())), width, f"{command} {case} {language} at {width}")
                self.assertNotIn("\x1b", shown, "no colour but on a terminal")

    def test_letters_of_two_columns_fit_too(self):
        case = self.edited("m12-el-centro", "Model 1", "北の建物" * 6)
        shown = subprocess.run([BENTUR, "run", str(case)], capture_output=True, text=True, timeout=60,
                               env={**os.environ, "COLUMNS": "80"}).stdout
        self.assertIn("北の建物", shown)

        def columns(line):
            return sum(2 if unicodedata.east_asian_width(letter) in "WF" else 1 for letter in line)

        self.assertLessEqual(max(map(columns, shown.splitlines())), 80)

    def test_verdicts_are_coloured_on_a_terminal_alone(self):
        for environment, coloured in ({}, True), ({"NO_COLOR": "1"}, False):
            leader, follower = pty.openpty()
            with os.fdopen(leader, "rb") as stream:
                run = subprocess.Popen([BENTUR, "run"], stdout=follower, stderr=subprocess.DEVNULL,
                                       env={**os.environ, "TERM": "xterm", **environment})
                os.close(follower)
                shown = b""
                try:
                    while part := stream.read1(4096):
                        shown += part
                except OSError:  # the end of a terminal
                    pass
                self.assertEqual(run.wait(60), 0)
            self.assertEqual(b"\x1b[1;31mPOUNDING:" in shown, coloured)

    def test_json_has_every_key(self):
        result = self.done("run", "--json")
        summary = json.loads(result.stdout)
        self.assertEqual(list(summary), ["title", "units", "version", "case", "status", "solver", "excitation",
                                         "statements", "remarks", "buildings", "gaps", "judged_by", "open_needs",
                                         "collapsed", "remark_counts"])
        self.assertEqual(summary["open_needs"], ["motion_left"])  # the record goes on after 10 s
        self.assertEqual(summary["units"], {"length": "cm", "force": "kgf"})
        counts = summary["remark_counts"]
        self.assertEqual(counts["all"], len(summary["remarks"]))
        self.assertEqual(set(counts["kinds"]), {one["key"] for one in summary["remarks"]})
        self.assertEqual(set(summary["solver"]), {
            "end_time",
            "name", "steps", "events", "wall_time", "energy_residual", "peak_input_energy"})
        self.assertEqual(summary["excitation"]["count"], 1560)
        self.assertEqual([building["name"] for building in summary["buildings"]], ["Model 1", "Model 2"])
        for building in summary["buildings"]:
            self.assertEqual(set(building), {
                "name", "elevations", "periods", "peak_displacement", "peak_displacement_no_contact", "amplification",
                "peak_drift_ratio", "peak_drift_ratio_no_contact", "peak_acceleration",
                "peak_acceleration_no_contact", "acceleration_ratio",
                "peak_storey_shear", "peak_storey_shear_no_contact", "storey_shear_ratio", "weight",
                "base_shear_coefficient", "period_per_storey", "first_period"})
            for key in "acceleration", "storey_shear":
                for ratio, with_contact, without in zip(*(building[name] for name in (
                        f"{key}_ratio", f"peak_{key}", f"peak_{key}_no_contact"))):
                    self.assertAlmostEqual(ratio, with_contact / without, delta=1e-12 * ratio)
            self.assertEqual({len(values) for values in building.values() if isinstance(values, list)}, {3})
        self.assertAlmostEqual(summary["buildings"][0]["periods"][0], 0.1440, places=4)
        self.assertAlmostEqual(summary["buildings"][1]["periods"][0], 0.1627, places=4)
        gap, = summary["gaps"]
        self.assertEqual(set(gap), {
            "between", "judgement", "gap_needed", "gap_needed_reversed", "unmodelled_contact", "unmodelled_contacts",
            "points", "watched_floors"})
        self.assertEqual(gap["gap_needed"], max(point["gap_needed"] for point in gap["points"]))
        self.assertEqual((gap["unmodelled_contact"], gap["watched_floors"]), ([], []), "all floors meet")
        self.assertEqual([point["elevation"] for point in gap["points"]], [100, 200, 300])
        for point in gap["points"]:
            self.assertEqual(set(point), {
                "elevation", "width", "gap_needed", "gap_needed_reversed", "peak_left_no_contact",
                "peak_right_no_contact", "impacts", "contact_duration", "peak_force",
                "peak_force_time", "peak_penetration", "peak_closing_speed", "impulse", "energy_lost", "peak_tension",
                "slow_starts", "settling", "contact", "restitution"})
            self.assertEqual(point["contact"]["law"], "linear")
        self.assertGreater(gap["points"][2]["impacts"], 0)

    def test_wide_gap_does_not_pound(self):
        case = self.edited("m12-el-centro", "width = 0.2 ", "width = 5.0 ")
        cut = self.done("run", case).stdout  # 10 s of a record of 31.18 s
        self.assertNotIn("NO POUNDING", cut)
        self.assertRegex(cut, r"NOT KNOWN: Whether the gap[^.]*\.?[^.]*is\s+not\s+known:\s+the\s+motion\s+goes\s+on")
        case.write_text(case.read_text().replace("duration = 10.0", ""))
        self.assertIn("NO POUNDING", self.done("run", case).stdout)
        point = json.loads(self.done("run", case, "--json").stdout)["gaps"][0]["points"][0]
        self.assertEqual((point["impacts"], point["peak_force"], point["peak_force_time"]), (0, 0, None))

    def test_quiet_says_nothing(self):
        result = self.done("run", EL_CENTRO, "--quiet", "-o", self.folder / "out")
        self.assertEqual((result.stdout, result.stderr), ("", ""))
        self.assertTrue((self.folder / "out" / "summary.json").exists())

    def test_no_progress_unless_on_a_terminal(self):
        self.assertNotIn("%", self.done("run").stderr)

    def test_full_standard_output_is_an_error(self):
        if not os.path.exists("/dev/full"):
            self.skipTest("no /dev/full")
        with open("/dev/full", "w") as full:
            result = subprocess.run([BENTUR, "run"], stdout=full, stderr=subprocess.PIPE, text=True)
        self.assertEqual(result.returncode, 1)
        self.assertIn("standard output", result.stderr)


class StandardError(CommandLine):
    def test_a_message_that_nobody_can_read_leaves_the_status(self):
        bad = self.edited("m12-el-centro", "pga = 341.7", "pga = -1")
        for case, status in ((EL_CENTRO, 0), (bad, 2), (self.folder / "none.toml", 2)):
            for redirection in ("2>&-", "2>/dev/full" if os.path.exists("/dev/full") else "2>&-"):
                out = self.folder / "quiet"
                command = f'"{BENTUR}" run "{case}" -o "{out}" {redirection}'
                run = subprocess.run(["sh", "-c", command], stdout=subprocess.DEVNULL)
                self.assertEqual(run.returncode, status, command)
                if status == 0:  # nothing of what would have been told stands in the files
                    self.assertEqual(json.loads((out / "summary.json").read_text())["solver"]["name"], "exact")


class ResultFiles(CommandLine):
    def python_with_xarray(self, script):
        for python in (sys.executable, "/usr/bin/python3"):
            if subprocess.run([python, "-c", "import xarray, netCDF4"], capture_output=True).returncode == 0:
                subprocess.run([python, "-c", script, self.folder / "histories.nc", self.folder / "summary.json"],
                               check=True)
                return
        self.skipTest("no Python with xarray and netCDF4")

    def test_three_files_that_agree(self):
        folder = self.folder / "a" / "b"
        summary = json.loads(self.done("run", EL_CENTRO, "-o", folder, "--json").stdout)
        self.assertEqual(sorted(file.name for file in folder.iterdir()), ["case.toml", "histories.nc", "impacts.csv", "summary.json"])
        self.assertEqual(json.loads((folder / "summary.json").read_text()), summary)
        with open(folder / "impacts.csv", newline="") as stream:
            rows = list(csv.DictReader(stream))
        points = summary["gaps"][0]["points"]
        self.assertEqual(len(rows), sum(point["impacts"] for point in points))
        for point in points:
            mine = [row for row in rows if float(row["elevation [cm]"]) == point["elevation"]]
            self.assertEqual(len(mine), point["impacts"])
            self.assertEqual(len({row["restitution"] for row in mine if row["open_ended"] == "0"} - {""}) > 0, bool(mine))
            self.assertEqual(max((float(row["peak_force [kgf]"]) for row in mine), default=0), point["peak_force"])
            total = sum(float(row["end [s]"]) - float(row["start [s]"]) for row in mine)
            self.assertAlmostEqual(total, point["contact_duration"], delta=1e-9)  # sums of rounded times up to 10 s
        starts = [float(row["start [s]"]) for row in rows]
        self.assertEqual(starts, sorted(starts))

    def test_nothing_of_this_machine_is_in_the_files(self):
        case = self.written("m12-el-centro")
        self.done("run", case, "-o", self.folder / "out")
        for file in (self.folder / "out").iterdir():
            self.assertNotIn(str(self.folder).encode(), file.read_bytes(), file)

    def test_the_same_run_gives_the_same_bytes(self):
        for name in "one", "two":
            self.done("run", EL_CENTRO, "-o", self.folder / name)
        for name in "impacts.csv", "histories.nc":
            self.assertEqual((self.folder / "one" / name).read_bytes(), (self.folder / "two" / name).read_bytes())

    def test_histories_open_in_xarray(self):
        script = (
            "import sys, json, xarray\n"
            "d = xarray.open_dataset(sys.argv[1])\n"
            "summary = json.load(open(sys.argv[2]))\n"
            "assert d.attrs['Conventions'].startswith('CF-'), d.attrs\n"
            "assert d.displacement_1.dims == ('time', 'elevation_1') and d.opening.dims == ('time', 'point')\n"
            "assert abs(float(d.time[1]) - 0.005) < 1e-12 and abs(float(d.time[-1]) - 10) < 1e-9\n"
            "for v in d.variables.values():\n"
            "    assert 'long_name' in v.attrs and ('units' in v.attrs or v.dtype.kind in 'OUTi'), v\n"  # text, number of a point
            "for b, building in enumerate(summary['buildings'], 1):\n"
            "    for z, peak in zip(building['elevations'], building['peak_displacement']):\n"
            "        seen = float(abs(d[f'displacement_{b}'].sel({f'elevation_{b}': z})).max())\n"
            "        assert 0.9 * peak < seen <= peak * (1 + 1e-9), (seen, peak)\n"
            "for i, point in enumerate(summary['gaps'][0]['points']):\n"
            "    assert float(d.force[:, i].max()) <= point['peak_force'] * (1 + 1e-9)\n"
            "    assert float(d.opening[0, i]) == point['width']\n"
            "assert list(d.building_name.values) == ['Model 1', 'Model 2']\n"
            "for b, building in enumerate(summary['buildings'], 1):\n"
            "    for name in 'drift_ratio', 'storey_shear':\n"
            "        for floor, peak in enumerate(building[f'peak_{name}']):\n"
            "            seen = float(abs(d[f'{name}_{b}'].isel({f'elevation_{b}': floor})).max())\n"
            "            assert 0.9 * peak < seen <= peak * (1 + 1e-9), (name, seen, peak)\n"
            "    assert (d[f'base_shear_{b}'] == d[f'storey_shear_{b}'][:, 0]).all() and d[f'base_shear_{b}'].dims == ('time',)\n"
            "    heights = d[f'elevation_{b}'].diff(f'elevation_{b}').values\n"
            "    drift = d[f'displacement_{b}'].diff(f'elevation_{b}').values / heights\n"
            "    assert abs(d[f'drift_ratio_{b}'][:, 1:].values - drift).max() < 1e-12\n"
            "assert d.case_file == 'm12-el-centro.toml' and d.case_sha256 == summary['case']['sha256']\n"
            "assert d.record_sha256 == summary['excitation']['sha256'] and d.storey_shear_1.units == 'kgf'\n")
        self.done("run", EL_CENTRO, "-o", self.folder)
        self.python_with_xarray(script)

    def test_histories_hold_the_energies_of_an_audit(self):
        script = (
            "import sys, json, xarray\n"
            "d = xarray.open_dataset(sys.argv[1])\n"
            "solver = json.load(open(sys.argv[2]))['solver']\n"
            "parts = ('kinetic', 'strain', 'damping', 'contact_stored', 'contact_lost')\n"
            "left = d.energy_input - sum(d['energy_' + part] for part in parts)\n"
            # The residual is the largest of the whole run, to which rounding of the samples comes.
            "assert float(abs(left).max()) <= solver['peak_input_energy'] * (solver['energy_residual'] + 1e-13)\n"
            "assert 0.9 * solver['peak_input_energy'] < float(abs(d.energy_input).max())\n"
            "assert float(d.energy_contact_lost[-1]) > 0 and d.energy_input.attrs['units'] == 'kN m'\n")
        self.done("run", self.written("kelvin-voigt-pair"), "-o", self.folder)
        self.python_with_xarray(script)

    def test_a_file_in_place_of_the_folder(self):
        (self.folder / "plain").write_text("mine")
        self.assertIn("plain", self.fails(2, "run", EL_CENTRO, "-q", "-o", self.folder / "plain").stderr)
        self.assertIn("plain", self.fails(2, "run", EL_CENTRO, "-q", "-o", self.folder / "plain" / "below").stderr)
        self.assertEqual((self.folder / "plain").read_text(), "mine")

    def test_a_folder_that_cannot_be_written(self):
        locked = self.folder / "locked"
        locked.mkdir(mode=0o555)
        self.folder.chmod(0o755)
        other_user = {"user": 65534} if os.geteuid() == 0 else {}  # root may write anywhere
        try:
            for target in locked, locked / "below":
                result = subprocess.run([BENTUR, "run", EL_CENTRO, "-q", "-o", target], capture_output=True, text=True, **other_user)
                self.assertEqual(result.returncode, 1, result.stderr)
                self.assertIn(str(target), result.stderr)
        except PermissionError:
            self.skipTest("another user may not run the program")
        self.assertEqual(list(locked.iterdir()), [])

    def test_nothing_is_half_written(self):
        """histories.nc cannot be replaced, so the other two must not be either."""
        (self.folder / "histories.nc").mkdir()
        (self.folder / "summary.json").write_text("old")
        self.fails(2, "run", EL_CENTRO, "-q", "-o", self.folder, "--force")
        self.assertEqual((self.folder / "summary.json").read_text(), "old")
        self.assertEqual(sorted(file.name for file in self.folder.iterdir()), ["histories.nc", "summary.json"])

    def test_bad_input_makes_no_folder(self):
        case = self.edited("m12-el-centro", "duration = 10.0", "duration = -1.0")
        self.fails(2, "run", case, "-o", self.folder / "new")
        self.assertFalse((self.folder / "new").exists())

    def test_killed_while_at_work_leaves_no_result_file(self):
        case = self.edited("two-frames-si", "duration = 20.0", "duration = 2000.0")
        folder = self.folder / "out"
        process = subprocess.Popen([BENTUR, "run", str(case), "-o", str(folder)], stdout=subprocess.DEVNULL,
                                   stderr=subprocess.DEVNULL)
        time.sleep(0.05)
        process.kill()
        process.wait()
        if folder.exists():
            visible = [file.name for file in folder.iterdir() if not file.name.startswith(".")]
            self.assertIn(sorted(visible), [[], ["case.toml", "histories.nc", "impacts.csv", "summary.json"]])


class BadInput(CommandLine):
    def test_missing_case(self):
        for command in "run", "gap", "modes", "check":
            with self.subTest(command):
                self.assertIn("absent.toml", self.fails(2, command, self.folder / "absent.toml").stderr)

    def test_all_errors_at_once_with_their_place(self):
        case = self.edited("m12-el-centro", "duration = 10.0", "duration = -1.0\ndurations = 3")
        case.write_text(case.read_text().replace('law = "linear"', 'law = "liner"'))
        for command in "run", "gap", "modes", "check":
            with self.subTest(command):
                stderr = self.fails(2, command, case).stderr
                self.assertRegex(stderr, r"m12-el-centro\.toml:\d+:\d+: error: .*durations")
                self.assertRegex(stderr, r"m12-el-centro\.toml:\d+:\d+: error: .*duration = -1")
                self.assertRegex(stderr, r"m12-el-centro\.toml:\d+:\d+: error: .*liner")

    def test_only_regular_files_are_read(self):
        """A pipe that nobody writes to would be waited for, a device without end read for ever."""
        case = self.written("m12-el-centro")
        record = self.folder / "el-centro-1940-ns.csv"
        record.unlink()
        pipe = self.folder / "pipe.toml"
        os.mkfifo(pipe)
        os.mkfifo(record)
        nodes = [pipe]
        device = self.folder / "device.toml"
        try:
            os.mknod(device, 0o600 | stat.S_IFCHR, os.makedev(1, 5))  # zeros without end
            nodes.append(device)
        except PermissionError:
            pass
        for command in ["check"], ["run"], ["modes"], ["gap"], ["report", "-o", self.folder / "report.html"]:
            for node in nodes:
                with self.subTest(command[0], node=node):
                    self.assertIn("a case file is read from a regular file only",
                                  self.fails(2, command[0], node, *command[1:]).stderr)
        self.assertIn("is a pipe, but a record is read from a regular file only",
                      self.fails(2, "check", case).stderr)
        for node in nodes:
            self.assertIn("a study is read from a regular file only",
                          self.fails(2, "sweep", node, "-o", self.folder / "a.nc").stderr)
            self.assertIn("a record is read from a regular file only",
                          self.fails(2, "spectrum", node).stderr)
            self.fails(2, "fragility", node)

    def test_a_missing_record(self):
        case = self.written("m12-el-centro")
        (self.folder / "el-centro-1940-ns.csv").unlink()
        self.assertIn("el-centro-1940-ns.csv", self.fails(2, "check", case).stderr)


class Messages(CommandLine):
    def test_names_that_are_not_given(self):
        for command in ["run", ""], ["check", ""], ["modes", ""], ["gap", ""], ["report", "", "-o", "x"], ["plot", ""], \
                ["report", EL_CENTRO, "-o", ""], ["run", EL_CENTRO, "-o", ""], ["sweep", "", "-o", "x"], ["fragility", ""], \
                ["spectrum", ""], ["example", "free-impact", "-o", ""]:
            with self.subTest(command):
                self.assertIn("must not be empty", self.fails(2, *command, cwd=self.folder).stderr)
        self.assertEqual(list(self.folder.iterdir()), [])

    def test_a_mistyped_command_or_option(self):
        self.assertIn('did you mean "run"?', self.fails(2, "runn", EL_CENTRO).stderr)
        self.assertIn('did you mean "report"?', self.fails(2, "repotr").stderr)
        self.assertNotIn("did you mean", self.fails(2, "xylophone").stderr)
        self.assertIn('did you mean "--figures"?', self.fails(2, "run", EL_CENTRO, "--figure=svg").stderr)

    def test_numbers_that_must_be_positive(self):
        for command in ["gap", EL_CENTRO, "--at"], ["spectrum", EL_CENTRO, "--time-step"]:
            for wrong in "0", "-1", "x", "1e999", "":
                message = self.fails(2, *command, wrong).stderr
                self.assertIn("must be a number above 0", message)
                self.assertLess(len(message), 200)

    def test_control_characters_of_a_case_never_reach_a_terminal(self):
        nasty = "\\u001b]0;pwned\\u0007\\u001b[2J\\u009b31m\\u007f"
        case = self.edited("m12-el-centro", '"Model 1"', f'"Model {nasty}"')
        case.write_text(re.sub("^title = .*", lambda _: f'title = "{nasty}"', case.read_text(), flags=re.MULTILINE))
        control = re.compile("[\x00-\x08\x0b-\x1f\x7f-\x9f]")
        for command in ["run", case], ["run", case, "--json"], ["check", case], ["modes", case], ["gap", case]:
            output = self.fails(2, *command)
            self.assertIsNone(control.search(output.stdout + output.stderr), command)
            self.assertIn('title = "\\x1b]0;pwned', output.stderr)
            self.assertIn('].name = "Model \\x1b]0;pwned', output.stderr)
        broken = self.folder / "\x1b[2Jbroken.toml"
        broken.write_text("x = 1")
        self.assertIsNone(control.search(self.fails(2, "check", broken).stderr))

    def test_errors_end_after_twenty(self):
        case = self.written("m12-el-centro")
        case.write_text("".join(f"unknown_{i} = 1\n" for i in range(250)) + case.read_text())
        lines = self.fails(2, "check", case).stderr.splitlines()
        self.assertEqual(len(lines), 21)
        self.assertEqual(lines[-1], "and 230 more errors")
        self.assertIn("unknown_19 ", lines[19])

    def test_results_that_cannot_be_read_are_bad_input_for_every_command(self):
        self.done("run", EL_CENTRO, "-q", "-o", self.folder)
        whole = (self.folder / "histories.nc").read_bytes()
        for content, word in (b"text", "is not a NetCDF file"), (whole[:len(whole) // 2], "cut short or damaged"):
            (self.folder / "histories.nc").write_bytes(content)
            for command in ["plot", self.folder, "opening"], ["plot", self.folder / "histories.nc", "--list"], \
                    ["report", self.folder, "-o", self.folder / "x.html"], ["fragility", self.folder / "histories.nc"]:
                message = self.fails(2, *command).stderr
                self.assertIn(word, message)
                self.assertNotIn("HDF", message)

    def test_no_zero_has_a_sign(self):
        for case in EXAMPLES:
            self.done("run", SOURCE / "examples" / f"{case}.toml", "-q", "-o", self.folder / case)
            for row in (self.folder / case / "impacts.csv").read_text().splitlines():
                self.assertNotIn("-0", row.split(","))


class Modes(CommandLine):
    def test_table_and_json(self):
        case = self.written("m12-el-centro")
        text = self.done("modes", case).stdout
        for word in ["Model 1", "Model 2", "Period", "Participation", "Mass", "%", "Mode 3", "0.144"]:
            self.assertIn(word, text)
        document = json.loads(self.done("modes", case, "--json").stdout)
        self.assertEqual(list(document), ["buildings"])
        for building in document["buildings"]:
            self.assertEqual(list(building),
                             ["name", "periods", "weight", "period_per_storey", "participation",
                              "effective_mass_fraction", "shapes"])
            self.assertEqual(len(building["shapes"]), 3)
            self.assertAlmostEqual(sum(building["effective_mass_fraction"]), 1, places=12)
            self.assertEqual(building["periods"], sorted(building["periods"], reverse=True))
            self.assertTrue(all(shape[0] > 0 for shape in building["shapes"]))

    def test_has_two_languages_with_the_same_numbers(self):
        for case in "two-frames-si", "gaps/known-by-modes", "plan/twisting-pair":
            english, indonesian = (self.done("modes", SOURCE / "examples" / f"{case}.toml", "--lang", language).stdout
                                   for language in ("en", "id"))
            numbers = [re.findall(r"[0-9.]+", text) for text in (english, indonesian)]
            self.assertGreater(len(numbers[0]), 10)
            self.assertEqual(*numbers)
            for word in "Mode ", "Mass ", "first period", "it has no modes", "Rotation":
                self.assertNotIn(word, indonesian)

    def test_both_methods_agree(self):
        case = self.written("m12-el-centro")
        library = json.loads(self.done("modes", case, "--json").stdout)["buildings"]
        jacobi = json.loads(self.done("modes", case, "--json", "--method", "jacobi").stdout)["buildings"]
        for one, other in zip(library, jacobi, strict=True):
            for a, b in zip(one["periods"], other["periods"], strict=True):
                self.assertAlmostEqual(a / b, 1, delta=1e-12)
        self.assertIn("jacobi", self.fails(2, "modes", case, "--method", "magic").stderr)


class Gap(CommandLine):
    def test_several_gaps_have_one_sentence_of_rules_and_the_larger_need(self):
        for example in "row-of-three", "plan/crossroads":
            text = " ".join(self.done("gap", SOURCE / f"examples/{example}.toml").stdout.split("What else is known")[0].split())
            self.assertEqual(text.count("would be less than this motion needs"), 1)
            gaps = json.loads(self.done("gap", SOURCE / f"examples/{example}.toml", "--json").stdout)["gaps"]
            short = {way: max(p[way] - p["width"] for gap in gaps for p in gap["points"])
                     for way in ("gap_needed", "gap_needed_reversed")}
            says = "the same motion reversed would need" in text
            self.assertEqual(says, short["gap_needed_reversed"] > short["gap_needed"], example)

    def test_table_and_json(self):
        case = self.written("m12-el-centro")
        text = self.done("gap", case).stdout
        for word in ["too small", "Needed as recorded", "Needed reversed", "ABS", "SRSS", "DDC", "governs", "Given", "0.2 cm"]:
            self.assertIn(word, text)
        document = json.loads(self.done("gap", case, "--json").stdout)
        summary = json.loads(self.done("run", case, "--json").stdout)
        gap, = document["gaps"]
        self.assertEqual(gap["gap_needed"], summary["gaps"][0]["gap_needed"])
        peaks = [building["peak_displacement_no_contact"] for building in summary["buildings"]]
        for floor, point in enumerate(gap["points"]):
            self.assertEqual(list(point), ["elevation", "width", "gap_needed", "abs", "srss", "ddc", "codes", "gap_needed_reversed"])
            left, right = peaks[0][floor], peaks[1][floor]
            self.assertAlmostEqual(point["abs"], left + right, delta=1e-12)
            self.assertAlmostEqual(point["srss"], (left**2 + right**2) ** 0.5, delta=1e-12)
            self.assertLess(point["ddc"], point["srss"])
            self.assertLessEqual(point["gap_needed"], point["abs"] * (1 + 1e-12))

    def test_the_needed_gap_is_enough_and_a_smaller_one_is_not(self):
        case = self.written("m12-el-centro")
        needed = json.loads(self.done("gap", case, "--json").stdout)["gaps"][0]["gap_needed"]
        original = case.read_text()
        for factor, impacts in (1.001, False), (0.999, True):
            case.write_text(original.replace("width = 0.2 ", f"width = {factor * needed} "))
            points = json.loads(self.done("run", case, "--json").stdout)["gaps"][0]["points"]
            self.assertEqual(sum(point["impacts"] for point in points) > 0, impacts)
        whole = original.replace("duration = 10.0", "")
        case.write_text(whole)
        gap = json.loads(self.done("gap", case, "--json").stdout)["gaps"][0]
        needed = max(gap["gap_needed"], gap["gap_needed_reversed"])
        case.write_text(whole.replace("width = 0.2 ", f"width = {1.001 * needed} "))
        self.assertRegex(self.done("gap", case).stdout, r"to\s+spare")


    CODE = """
[code]
asce-7-16 = { deflection_amplification = [5.5, 4.5], importance_factor = 1 }
gb-50011-2010 = { intensity = 8, system = "frame" }
"""

    def test_codes_say_clause_and_wording_and_what_is_missing(self):
        case = self.written("m12-el-centro")
        self.assertIn("when the case gives their factors in [code]", self.done("gap", case).stdout)
        case.write_text(case.read_text() + self.CODE)
        text = self.done("gap", case).stdout
        self.assertRegex(text, r"ASCE 7-16, IBC +12\.12\.3 .*read in the 2010 edition")
        self.assertRegex(text, r"GB 50011-2010 +6\.1\.4 +10[.0]* .*read; steel second hand, to check")
        self.assertNotIn("EN 1998", text)
        self.assertIn("code.en-1998-1: behaviour_factor\n", text)
        self.assertNotIn("code.asce-7-16:", text)
        document = json.loads(self.done("gap", case, "--json").stdout)
        self.assertEqual([rule["rule"] for rule in document["code_rules"]], ["asce-7-16", "gb-50011-2010"])
        peaks = [b["peak_displacement_no_contact"] for b in json.loads(self.done("run", case, "--json").stdout)["buildings"]]
        for floor, point in enumerate(document["gaps"][0]["points"]):
            asce, chinese = point["codes"]
            left, right = 5.5 * peaks[0][floor], 4.5 * peaks[1][floor]
            self.assertAlmostEqual(asce["gap"], left + right, delta=1e-12)  # across a property line
            self.assertAlmostEqual(asce["to_property_line"][1], right, delta=1e-12)
            self.assertEqual(chinese["gap"], 10)  # 100 mm in the case's centimetres
            self.assertEqual(chinese["to_property_line"], [None, None])

    def test_the_documented_table_is_read_and_shows_every_rule(self):
        example = (SOURCE / "docs" / "separation-rules.md").read_text().split("```toml\n")[1].split("```")[0]
        case = self.written("m12-el-centro")
        case.write_text(case.read_text() + "\n" + example)
        text = self.done("gap", case).stdout
        self.assertNotIn("Not shown", text)
        rules = json.loads(self.done("gap", case, "--json").stdout)["code_rules"]
        self.assertEqual(len(rules), 21)
        for rule in rules:
            self.assertRegex(text, re.escape(rule["title"]) + r" +" + re.escape(rule["clause"]))
            page = (SOURCE / "docs" / "separation-rules.md").read_text()
            self.assertIn(f"| `{rule['rule']}` |", page)
            kinds = {"displacement expected|elastic reference": "reduced by nothing", "^the height alone|^no disp": "none: the height",
                     "": "under reduced design forces"}
            kind = next(kind for words, kind in kinds.items() if re.search(words, rule["assumes"]))
            self.assertRegex(page, rf"(?m)^[|] .*{kind}.* [|] .*{re.escape(rule['title'])}")
            self.assertIn(f"{rule['title']}: {rule['assumes']}; {rule['motion']}", " ".join(text.split()))


    def test_rules_from_heights_alone(self):
        """h = 12 m, by hand; nothing is computed, so that a motion that cannot be solved does not matter."""
        case = self.folder / "twelve.toml"
        storeys = "stick = { storey_heights = [3, 3, 3, 3], masses = [9e4, 9e4, 9e4, 9e4], stiffnesses = [9e7, 9e7, 9e7, 9e7] }"
        case.write_text(
            "".join(f'[[building]]\nname = "{name}"\ndamping = 0.05\n{storeys}\n' for name in "AB")
            + '[[gap]]\nbetween = ["A", "B"]\nwidth = 0.065\ncontact = { law = "linear", stiffness = 3e8 }\n'
            '[excitation]\nkind = "harmonic"\nperiod = 0.4\ndisplacement_amplitude = 0.05\n[analysis]\nduration = 5\n'
            "[code]\nsame_owner = OWNER\nen-1998-1 = { behaviour_factor = 3 }\ne-030-2018 = {}\nrpa-2024 = {}\n"
            'nsr-10 = { neighbour = "NEIGHBOUR" }\nntc-2018 = { ground_acceleration = "0.2 g", soil_factor = 1.25 }\n')
        template = case.read_text()
        for neighbour, to_line in ("coincides", 0.24), ("differs", 0.36), ("none", 0.12):
            case.write_text(template.replace("OWNER", "false").replace("NEIGHBOUR", neighbour))
            document = json.loads(self.done("gap", "--rules", case, "--json").stdout)
            rules = {one["rule"]: one for one in document["gaps"][0]["rules"]}
            self.assertEqual(rules["en-1998-1"]["given_is"], "not_evaluated")
            self.assertEqual(rules["en-1998-1"]["reason"], "displacements")
            for rule, asked, least in (("e-030-2018", 0.072, True), ("rpa-2024", 0.04, True), ("ntc-2018", 0.06, False)):
                self.assertAlmostEqual(rules[rule]["gap"], asked, delta=1e-12)
                self.assertEqual(rules[rule]["at_least"], least)
                self.assertEqual(rules[rule]["given_is"], "too_small" if asked > 0.065 else "as_much_as_the_least" if least else "enough")
            top = rules["nsr-10"]["levels"][-1]
            self.assertEqual(top["elevation"], 12)
            for distance in top["to_property_line"]:
                self.assertAlmostEqual(distance, to_line, delta=1e-12)
            self.assertEqual([level["elevation"] for level in rules["e-030-2018"]["levels"]], [3, 6, 9, 12])
        text = self.done("gap", "--rules", case).stdout
        self.assertRegex(text, r"E\.030-2018 \(Peru\) +art\. 33 +0\.072 .*too small")
        self.assertIn("it needs displacements", text)
        self.assertIn("E.030-2018", self.done("gap", "--rules", case, "--lang", "id").stdout)
        case.write_text(template.replace("OWNER", "true").replace("NEIGHBOUR", "none"))
        text = re.sub(r"\s+", " ", self.done("gap", "--rules", case).stdout)
        self.assertIn("NSR-10 (Colombia) (it needs displacements)", text)
        refused = self.fails(2, "gap", "--rules", "--record", "1", case).stderr
        self.assertIn("--record is for simulated gaps", refused)

    def test_the_exception_of_the_code_is_quoted(self):
        case = self.written("m12-el-centro")
        self.assertNotIn("rational analyses", self.done("gap", case).stdout)
        case.write_text(case.read_text() + self.CODE)
        for command in "gap", "run":
            self.assertIn("rational analyses", self.done(command, case).stdout)
        self.done("report", case, "-o", self.folder / "quoted.html")
        self.assertIn("rational analyses", (self.folder / "quoted.html").read_text())


class PlanCases(CommandLine):
    CASE = SOURCE / "examples" / "plan" / "twisting-pair.toml"

    def case(self, old, new):
        """The example with one line changed."""
        text = self.CASE.read_text().replace("../../data", str(SOURCE / "data"))
        self.assertIn(old, text)
        (self.folder / "case.toml").write_text(text.replace(old, new))
        return self.folder / "case.toml"

    def test_tells_in_words_and_tables_what_the_summary_has(self):
        summary = json.loads(self.done("run", self.CASE, "--json").stdout)
        text = self.done("run", self.CASE).stdout
        points = summary["gaps"][0]["points"]
        hardest = max(points, key=lambda point: point["peak_force"])
        words = " ".join(text.split())
        self.assertIn(f"collide {len(summary['impacts'])} times in 15 s, at 2 of 4 contact points. The hardest impact "
                      f"reaches {hardest['peak_force']:.0f} kN at level 6.7 m (x = 12.02 m, y = 18 m: the upper right "
                      "corner of Walled)", words)
        needed = max(points, key=lambda point: point["gap_needed"])
        self.assertIn(f"they need {needed['gap_needed']:.4g} m at level {needed['elevation']} m", words)
        self.assertIn("Contact turns Frame, which would not turn alone,", words)
        self.assertIn("Ground motion along x + 30°, peak 0.347 g 3.4 m/s²", words)
        table = text[text.index("Contact Walled | Frame"):text.index("Peaks of Walled")]
        rows = [line.split() for line in table.splitlines()[6:] if line.strip()]
        self.assertEqual(" ".join(rows.pop()), "No energy is lost across the gap: the contact is elastic.")
        points.sort(key=lambda point: -point["elevation"])
        self.assertEqual(len(rows), len(points))
        for row, point in zip(rows, points):
            self.assertEqual([float(cell) for cell in row[:3]], [point["elevation"], *point["at"]])
            self.assertAlmostEqual(float(row[4]), point["gap_needed"], delta=1e-3 * point["gap_needed"])
            self.assertEqual(int(row[5]), point["impacts"])
        # What would be round-off is told as none.
        self.assertNotIn("⁻", text)
        for plane in ("south wall", "north frame", "west frame", "east frame"):
            self.assertEqual(len(re.findall(rf"^ *{plane} ", text, re.M)), 2)

    def test_output(self):
        results = self.folder / "results"
        told = self.done("run", self.CASE, "-o", results, "--json")
        self.assertIn("Wrote summary.json, impacts.csv, histories.nc and case.toml into", told.stderr)
        summary = json.loads(told.stdout)
        self.assertEqual(json.loads((results / "summary.json").read_text()), summary)
        self.assertEqual((results / "case.toml").read_bytes(), self.CASE.read_bytes())
        with open(results / "impacts.csv", newline="") as file:
            rows = list(csv.DictReader(file))
        self.assertEqual(len(rows), len(summary["impacts"]))
        for row, impact in zip(rows, summary["impacts"]):
            self.assertEqual([row["left"], row["right"]], impact["between"])
            for column in ("elevation [m]", "x [m]", "y [m]", "peak_force [kN]", "tangential_impulse [kN s]"):
                self.assertEqual(float(row[column]), impact[column.split()[0]])
        self.assertTrue((results / "histories.nc").stat().st_size > 1e5)
        # Its own results are written over; a file of somebody else is not.
        self.done("run", self.CASE, "-o", results, "-q")
        (results / "histories.nc").write_text("mine")
        self.fails(2, "run", self.CASE, "-o", results)
        self.assertEqual((results / "histories.nc").read_text(), "mine")

    def test_figures(self):
        results = self.folder / "results"
        self.done("run", self.CASE, "-o", results, "-q", "--figures", "svg")
        kinds = [line.split()[0] for line in self.done("plot", results, "--list").stdout.splitlines()]
        self.assertEqual(kinds, ["overview", "scene", "displacement", "opening", "orbit", "force", "friction-cone", "floor-spectrum"])
        self.assertEqual(sorted(f.stem for f in (results / "figures").glob("*.svg")), sorted(kinds))
        for kind in kinds:  # read back, a figure is the one that the run has drawn
            picture = self.folder / f"{kind}.svg"
            self.done("plot", results / "histories.nc", kind, "-o", picture)
            self.assertEqual(picture.read_text(), (results / "figures" / f"{kind}.svg").read_text())
        self.done("plot", results, "scene", "--lang", "id", "-o", self.folder / "id.svg")
        self.assertIn("pusat kekakuan", (self.folder / "id.svg").read_text())
        self.assertIn("of buildings in plan, but of a row", self.fails(2, "plot", results, "envelope").stderr)
        self.assertIn("there is no gap 1", self.fails(2, "plot", results, "scene", "--gap", "1").stderr)
        self.done("run", self.CASE, "-o", results, "-q")  # of a run without figures none are left
        self.assertFalse((results / "figures").exists())
        (results / "case.toml").unlink()
        self.assertIn("case.toml", self.fails(2, "plot", results, "scene", "-o", self.folder / "b.svg").stderr)
        self.assertIn("case.toml", self.fails(2, "report", results, "-o", self.folder / "b.html").stderr)

    def test_report(self):
        results = self.folder / "results"
        self.done("run", self.CASE, "-o", results, "-q")
        pages = []
        for source in self.CASE, results, results / "histories.nc":
            self.done("report", source, "-o", self.folder / "report.html", "--lang", "id", "--force")
            pages.append((self.folder / "report.html").read_text())
            self.assertIn("berbenturan 7 kali", pages[-1].replace("\u00a0", " "))
        self.assertEqual(pages[1], pages[2])
        case = self.folder / "project.toml"
        case.write_text(self.CASE.read_text().replace("../../data", str(SOURCE / "data")) + '\n[project]\nengineer = "Office of towers"\n')
        self.done("run", case, "-o", results, "-q")
        for source in case, results:
            self.done("report", source, "-o", self.folder / "r.html", "--force")
            page = (self.folder / "r.html").read_text()
            for said in "Office of towers", "What was not checked", "Assumptions", "Vertical motion":
                self.assertIn(said, page)

    def test_speaks_indonesian(self):
        words = " ".join(self.done("run", self.CASE, "--lang", "id").stdout.split())
        self.assertIn("berbenturan 7 kali", words)
        self.assertIn("sudut kanan atas Walled", words)
        self.assertIn("Kontak memutar Frame", words)
        self.assertNotIn("story.", words)
        self.assertNotRegex(words, r"\{\w+\}")

    def test_says_where_contact_is_not_modelled(self):
        case = self.case("clearance = 0.10 ", "clearance = 0.03 ")
        wall = 'name = "W"\nrigid = true\nelevations = [3.5]\nplan = { corner = [-0.52, 0], size = [0.5, 18] }'
        case.write_text(case.read_text() + "\n[[building]]\n" + wall + "\n")
        words = " ".join(self.done("run", case).stdout.split())
        self.assertIn("CONTACT NOT MODELLED: Walled and Frame are 0.04 m apart", words)

    def test_watches_floors_that_face_edges(self):
        case = self.case("[3.5, 3.2]\nmasses = [250", "[3.5, 2.0]\nmasses = [250")
        for command in "run", "gap":
            words = " ".join(self.done(command, case).stdout.split())
            self.assertIn("POUNDING THAT IS NOT MODELLED: The floor of", words)
            self.assertIn("between two of its floors at", words)
            self.assertIn("strike columns of frames of", words)
        gap = json.loads(self.done("gap", case, "--json").stdout)["gaps"][0]
        self.assertEqual({(floor["floor_of"], floor["elevation"], floor["faces"]) for floor in gap["watched_floors"]},
                         {("Walled", 5.5, "edge")} if gap["watched_floors"][0]["floor_of"] == "Walled"
                         else {("Frame", 5.5, "edge")})
        self.assertEqual(sorted(floor["at"][1] for floor in gap["watched_floors"]), [0, 18])
        case.write_text(case.read_text().replace("corner = [12.04, 0.0]", "corner = [12.4, 0.0]")
                        .replace("clearance = 0.10 ", "clearance = 0.50 ").replace("duration = 15.0", ""))
        words = " ".join(self.done("run", case).stdout.split())
        self.assertIn("the 0.4 m given there leave", words)
        self.assertNotIn("NOT MODELLED", words)

    def test_gap(self):
        told = json.loads(self.done("gap", self.CASE, "--json").stdout)
        run = json.loads(self.done("run", self.CASE, "--json").stdout)
        gap = told["gaps"][0]
        self.assertEqual(gap["gap_needed"], run["gaps"][0]["gap_needed"])
        self.assertEqual(gap["gap_needed_reversed"], run["gaps"][0]["gap_needed_reversed"])
        text = self.done("gap", self.CASE).stdout
        levels = text[text.index("The gap needed at every level"):text.index("What the rules ask for")]
        rows = [line.split() for line in levels.split("─\n")[1].splitlines() if line.strip()]
        self.assertEqual(len(rows), 4)
        points = {(point["elevation"], *point["at"]): point for point in gap["points"]}
        for row in rows:
            point = points[tuple(float(cell) for cell in row[:3])]
            for cell, key in zip(row[4:], ("gap_needed", "gap_needed_reversed", "abs", "srss")):
                self.assertAlmostEqual(float(cell), point[key], delta=1e-3 * point[key])
        words = " ".join(text.split())
        self.assertRegex(text, r"DDC +– +– +– +– +– +needs periods of one direction")
        self.assertIn("the upper right corner of Walled", words)
        # Rules of codes, from displacements and from heights alone.
        case = self.case("[analysis]", '[code]\nen-1998-1 = { behaviour_factor = 3 }\n'
                         'gb-50011-2010 = { intensity = 8, system = "frame" }\n[analysis]')
        asked = json.loads(self.done("gap", case, "--json").stdout)["gaps"][0]["points"][3]
        codes = {one["rule"]: one["gap"] for one in asked["codes"]}
        self.assertAlmostEqual(codes["gb-50011-2010"], 0.1)
        self.assertAlmostEqual(codes["en-1998-1"], 3 * asked["abs"])  # across a property line
        self.assertIn("EN 1998-1:2004", self.done("gap", case).stdout)
        self.assertIn("too small", self.done("gap", "--rules", case).stdout)
        heights = json.loads(self.done("gap", "--rules", case, "--json").stdout)["gaps"][0]
        self.assertEqual([rule["given_is"] for rule in heights["rules"]], ["not_evaluated", "too_small"])
        for arguments in ([], ["--rules"]):
            indonesian = " ".join(self.done("gap", case, "--lang", "id", *arguments).stdout.split())
            self.assertIn("GB 50011-2010", indonesian)
            self.assertNotRegex(indonesian, r"\{\w+\}|\bstory\.|\bgap\.[a-z]")
        self.assertIn("suite", self.fails(2, "gap", self.CASE, "--record", "1").stderr)
        self.assertIn("[ida]", self.fails(2, "gap", self.CASE, "--at", "1").stderr)

    def test_beyond_its_limits_nothing_is_run(self):
        for limit, english, indonesian in (("steps = 10", "steps or more, over the limit of 10. The fastest motion is",
                                            "langkah atau lebih, melebihi batas 10."),
                                           ("memory = 1", "MB of memory, over the limit of 1:", "perlu memori")):
            case = self.case("duration = 15.0", f"duration = 15.0\nlimits = {{ {limit} }}")
            results = self.folder / "results"
            self.assertIn(english, self.fails(2, "run", case, "-o", results).stderr)
            self.assertIn(indonesian, self.fails(2, "run", case, "--lang", "id").stderr)
            self.assertFalse(results.exists())

    def test_check_says_what_a_run_takes(self):
        told = self.done("check", self.CASE).stdout
        self.assertRegex(told, r"Fastest: [0-9.]+ Hz, mode 6 of Walled\nFastest in contact: [0-9.]+ Hz, the contact of "
                               r"Walled \| Frame at level 6\.7 m\nA run takes [0-9]+ steps, and [0-9]+ for every")

    def test_modes(self):
        told = self.done("modes", self.CASE).stdout
        self.assertEqual(len(re.findall(r"^ +\d ", told, re.M)), 12)


def documented(document, name):
    """The texts of a page that stand in fences between <!-- NAME --> and <!-- /NAME -->."""
    text = (SOURCE / "docs" / document).read_text()
    block = text.split(f"<!-- {name} -->")[1].split(f"<!-- /{name} -->")[0]
    return block.split("```")[1].split("\n", 1)[1].rstrip() + "\n"


class BlockOfHouses(CommandLine):
    """docs/howto/block-of-houses.md: GeoJSON becomes a case in plan that runs."""

    def setUp(self):
        super().setUp()
        self.text = documented("howto/block-of-houses.md", "block")
        (self.folder / "block.geojson").write_text(self.text)

    def test_the_page_shows_what_is_printed_and_the_case_runs(self):
        page, case = "howto/block-of-houses.md", self.folder / "block.toml"
        made = self.done("import", "block.geojson", "-o", case, cwd=self.folder)
        self.assertEqual(made.stderr, documented(page, "taken"))
        self.assertIn(documented(page, "hall"), case.read_text())
        said = re.sub(r"\n?#", "", case.read_text().split("title")[0])
        for line in re.findall(r"^taken: (.*)", made.stderr, re.M):
            self.assertIn(line, " ".join(said.split()))
        checked = self.done("check", case).stdout
        self.assertIn("Hotel | Clinic: 0 m apart along x", checked)
        self.assertIn("Market hall: 1 floor, 3 degrees of freedom, 0 planes, first period 0.2161 s", checked)
        told = self.done("run", case, "-o", self.folder / "out").stdout
        self.assertIn("the hardest impact,", " ".join(told.split()))
        self.done("report", case, "-o", self.folder / "report.html")
        case.write_text(case.read_text().replace("first", "second"))  # the user's own
        self.assertIn("not written", self.fails(2, "import", "block.geojson", "-o", case, cwd=self.folder).stderr)

    def test_options_change_what_is_taken_and_belong_to_one_kind_of_file(self):
        block = self.folder / "block.geojson"
        ordered = ["--hull", "--floor-mass", 0.5, "--storey-height", 4, "--period-formula", "0.0488,0.75"]
        text = self.done("import", block, *ordered).stdout
        self.assertIn("masses = [107.553, 107.553, 107.553]  # 215.1 m² a floor", text)
        self.assertIn(f"T = {0.0488 * 12 ** 0.75:.3f} s of H = 12 m", text)
        self.assertNotIn("ASCE", text)
        self.assertIn("--snap 0.01 m", self.fails(2, "import", block, "--hull", "--snap", 0.01).stderr)
        self.assertIn("--at is of ETABS models", self.fails(2, "import", block, "--at", 3).stderr)
        model = self.folder / "model.e2k"
        model.write_text("$ nothing\n")
        self.assertIn("--hull is of GeoJSON", self.fails(2, "import", model, "--hull").stderr)
        for wrong in ["--snap", -1], ["--clearance", "wide"], ["--storeys", 0], ["--period-formula", "0.05"]:
            self.fails(2, "import", block, "--hull", *wrong)
        block.write_text(self.text.replace('"height": 9.6', '"use": "none"'))
        self.assertIn('features[2] ("Clinic") has neither storeys', self.fails(2, "import", block, "--hull").stderr)
        self.assertIn('neither storeys nor a height are given: "Clinic"',
                      self.done("import", block, "--hull", "--storeys", 2).stderr)

    def test_one_bad_house_does_not_stop_a_block(self):
        block = self.folder / "block.geojson"
        bad = self.text.replace('"height": 9.6', '"height": "tall", "building:levels": "3;4", "layer_no": 7')
        block.write_text(bad)
        refused = self.fails(2, "import", block, "--hull").stderr
        self.assertIn('.properties.height = "tall", must be metres in (0, 1000]', refused)
        self.assertIn('--storeys takes it as not given; --without "Clinic" leaves it out', refused)
        done = self.done("import", block, "--hull", "--storeys", 2)
        self.assertIn('taken: storeys are whole (of several the most, a part of one is one, of a sum all): '
                      '"Clinic", 3;4 as 4', done.stderr)
        self.assertIn('taken: what cannot be read is as if not given, as there is --storeys: '
                      '"Clinic", height = "tall"', done.stderr)
        self.assertIn("# - what cannot be read is as if not given", done.stdout)
        self.assertEqual(done.stdout.count("storey_heights = [3, 3, 3, 3]\n"), 1)
        without = self.done("import", block, "--hull", "--without", "Clinic", "--without", "Flats")
        self.assertIn('taken: --without leaves out: "Clinic"; "Flats"\n', without.stderr)
        self.assertEqual(without.stdout.count("[[building]]"), 3)
        self.assertIn('--without = "Flat", did you mean "Flats"?',
                      self.fails(2, "import", block, "--without", "Flat").stderr)
        named = self.done("import", block, "--hull", "--storeys", 2, "--levels", "layer_no").stdout
        self.assertIn("storey_heights = [3, 3, 3, 3, 3, 3, 3]\n", named)

    def test_houses_around_one(self):
        block = self.folder / "block.geojson"
        for place, radius in ("Bakery", 4), ("107.61005,-6.91992", 12):  # of walls, and of a place within
            made = self.done("import", block, "--around", place, "--radius", radius)
            self.assertEqual(re.findall(r'^name = "(.*)"', made.stdout, re.M), ["Bakery", "Hotel", "Market hall"])
            self.assertIn(f'taken: who is further than --radius {radius} m from "{place}" is left out: 2 houses', made.stderr)
        self.assertEqual(self.done("import", block, "--around", "Hotel", "--hull").stdout.count("[[building]]"), 5)
        self.assertIn("LON,LAT in degrees", self.fails(2, "import", block, "--around", "Theatre").stderr)
        self.assertIn("--radius needs --around", self.fails(2, "import", block, "--radius", 12).stderr)
        self.fails(2, "import", block, "--around", "Hotel", "--radius", 0)

    def test_features_one_a_line(self):
        lines = [json.dumps(one) for one in json.loads(self.text)["features"]]
        whole = self.done("import", self.folder / "block.geojson", "--hull").stdout
        for name, text in ("block.geojsonl", "\n".join(lines)), ("block.txt", "".join(f"\x1e{one}\n" for one in lines)):
            (self.folder / name).write_text(text)
            self.assertEqual(self.done("import", self.folder / name, "--hull").stdout, whole)
        (self.folder / "one.geojson").write_text(lines[0])
        self.assertIn("has 1 polygon, a block has two or more",
                      self.fails(2, "import", self.folder / "one.geojson").stderr)

    def extract(self, seed):
        """Some 110 houses along five streets as a map has them, every kind of trouble among them."""
        draw = random.Random(seed)
        degree = 111320.0

        def feature(number, tags, *parts):
            rings = [[[[107.6 + x / degree, -0.01 + y / degree] for x, y in [*ring, ring[0]]] for ring in part]
                     for part in parts]
            kind = "Polygon" if len(rings) == 1 else "MultiPolygon"
            return {"type": "Feature", "id": f"way/{number}", "properties": {"building": "yes", **tags},
                    "geometry": {"type": kind, "coordinates": rings[0] if len(rings) == 1 else rings}}

        def box(x, y, a, b):
            return [(x, y), (x + a, y), (x + a, y + b), (x, y + b)]

        features, kinds = [], Counter()
        for street in range(5):
            x = 0.0
            for _ in range(20):
                a, b, y = draw.uniform(6, 14), draw.uniform(9, 15), 45.0 * street
                number, shape = len(features), draw.choice(["box"] * 6 + ["court", "wing", "shed"])
                tags = draw.choice([{"building:levels": draw.randint(1, 6)}, {"building:levels": "3;4"}, {},
                                    {"building:levels": "2.5", "height": "8,7"}, {"height": "31'6\""},
                                    {"num_floors": 4, "height": 12.8}, {"building:levels": "many"},
                                    {"tags": {"building:levels": "2-3", "roof:shape": "gabled"}}])
                parts = [[box(x, y, a, b)]]
                if shape == "court":
                    parts = [[box(x, y, a, b), box(x + 2, y + 3, a - 4, b - 6)]]
                if shape == "wing":  # an L whose inner corner is to the yard
                    parts = [[[(x, y), (x + a, y), (x + a, y + b), (x + a / 2, y + b), (x + a / 2, y + b / 2),
                               (x, y + b / 2)]]]
                if shape == "shed":
                    parts.append([box(x, y + 20, 4, 4)])
                features.append(feature(number, tags, *parts))
                kinds[shape] += 1
                x += a + draw.choice([0, 0, -draw.uniform(0, 0.08), draw.uniform(0, 0.4)])
        features.insert(7, {"type": "Feature", "id": "node/1", "properties": {"amenity": "cafe"},
                            "geometry": {"type": "Point", "coordinates": [107.6, -0.01]}})
        features.insert(40, {"type": "Feature", "id": "way/gone", "properties": {}, "geometry": None})
        return features, kinds

    def test_an_extract_of_a_map_comes_in_by_one_command(self):
        for seed in 1, 2, 3:
            features, kinds = self.extract(seed)
            ward, case = self.folder / "ward.geojson", self.folder / f"ward-{seed}.toml"
            ward.write_text(json.dumps({"type": "FeatureCollection", "features": features}))
            hull = self.done("import", ward, "--parts", "--hull", "--storeys", 2)
            for said in "holes are left out", "the hull stands for an outline":
                self.assertIn(said, hull.stderr)
            made = self.done("import", ward, "--parts", "--storeys", 2, "-o", case)
            self.assertEqual(case.read_text().count("[[building]]"), 100 + kinds["shed"])
            self.assertEqual(case.read_text().count("[[building.plan.court]]"), kinds["court"])
            for said in ("features without geometry are left out: \"way/gone\"", "are houses of their own", "3;4 as 4",
                         "2.5 as 3", "2-3 as 3", "8,7 as 8.7 m", "31'6\" as 9.601 m", 'building:levels = "many"',
                         "2 storeys of 3 m, where neither storeys nor a height are given", "are cut off the later one"):
                self.assertIn(said, made.stderr)
            self.assertIn('not read: geometry "Point" of 1 feature', made.stderr)
            self.assertIn("no errors", self.done("check", case).stdout)
        case.write_text(case.read_text().replace("duration = 5.0", "duration = 0.5"))
        self.done("run", case)

    def test_metres_and_what_is_no_geojson(self):
        block = self.folder / "block.geojson"
        metres = re.sub(r"\[(107\.\d+), (-6\.\d+)\]", lambda place: "[{}, {}]".format(
            round((float(place[1]) - 107.61) * 1e5, 2), round((float(place[2]) + 6.92) * 1e5, 2)), self.text)
        block.write_text(metres.replace("[0.0, 0.0]", "[500.0, 0.0]"))
        self.assertIn("give --metres", self.fails(2, "import", block, "--hull").stderr)
        block.write_text(metres)
        text = self.done("import", block, "--hull", "--metres").stdout
        self.assertIn("polygon = [[-19, -17], [-8, -17], [-8, -1], [-19, -1]]", text)
        for text in "", "7", "{", "[" * 100000, '{"type": "FeatureCollection", "features": [null, 7]}':
            block.write_text(text)
            self.fails(2, "import", block, "-o", self.folder / "none.toml")
            self.assertFalse((self.folder / "none.toml").exists())


class DesignSpectrum(CommandLine):
    """Gaps by a design spectrum: peaks of modes combined, no run."""

    FOLDER = SOURCE / "examples" / "gaps"

    ONE_MASS = """
[[building]]
name = "A"
damping = 0.05
stick = { storey_heights = [3.0], masses = [100e3], stiffnesses = [4e6] }

[[building]]
name = "B"
damping = 0.10
stick = { storey_heights = [3.0], masses = [100e3], stiffnesses = [1e6] }

[[gap]]
between = ["A", "B"]
width = 0.1
contact = { law = "linear", stiffness = 1e9 }

[excitation]
kind = "spectrum"
"""

    def one_mass(self, spectrum):
        case = self.folder / "one-mass.toml"
        case.write_text(self.ONE_MASS + spectrum)
        return json.loads(self.done("gap", case, "--json").stdout)

    def test_the_documented_table_is_what_the_program_prints(self):
        text = self.done("gap", self.FOLDER / "spectrum-table.toml").stdout
        self.assertTrue(text.startswith(documented("separation-rules.md", "spectral-gap")))
        self.assertLessEqual(max(map(len, text.splitlines())), 110)

    def test_one_mass_has_the_spectral_displacement(self):
        omega = [(4e6 / 100e3) ** 0.5, (1e6 / 100e3) ** 0.5]  # T = 0.993 s and 1.987 s
        period = [2 * math.pi / one for one in omega]
        g = 9.80665
        eta = (10 / 15) ** 0.5
        euro = [2.5 * 0.3 * g * 1.2 * 0.5 / period[0], 2.5 * 0.3 * g * 1.2 * eta * 0.5 / period[1]]  # B: T_C 0.5, T_D 2 s
        american = [0.6 * g / period[0], 0.6 * g / period[1] * eta]
        for spectrum, accelerations in (
                ('shape = "en-1998-1"\nground_acceleration = 0.3\nspectrum_type = 1\nground_type = "B"\n', euro),
                ('shape = "sni-1726-2019"\nshort_period = 0.9\none_second = 0.6\nlong_period = 12\n', american),
                ('shape = "asce-7-22"\nshort_period = 0.9\none_second = 0.6\nlong_period = 12\n', american)):
            document = self.one_mass(spectrum)
            peaks = [a / w**2 for a, w in zip(accelerations, omega, strict=True)]
            for building, peak in zip(document["buildings"], peaks, strict=True):
                for name in "peak_displacement_srss", "peak_displacement_cqc", "spectral_displacement":
                    self.assertAlmostEqual(building[name][0], peak, delta=1e-12)
            gap, = document["gaps"]
            self.assertAlmostEqual(gap["abs"], sum(peaks), delta=1e-12)
            self.assertAlmostEqual(gap["srss"], math.hypot(*peaks), delta=1e-12)
            self.assertAlmostEqual(gap["gap_needed"], gap["ddc"], delta=1e-12)
            self.assertNotIn("simulated", gap)
            self.assertEqual(document["excitation"]["kind"], "spectrum")

    def test_a_table_of_the_case_and_one_beside_it_are_the_same(self):
        rows = "0,0.4\n0.2,1\n1,0.9\n2.5,0.3\n"
        (self.folder / "s.csv").write_text("period [s],Sa [g]\n" + rows)
        (self.folder / "three.csv").write_text("".join(f"{row.split(',')[0]};7;{row.split(',')[1]}\n"
                                                       for row in rows.splitlines()).replace(".", ","))
        inline = 'periods = [0, 0.2, 1, 2.5]\naccelerations = [0.4, 1, 0.9, 0.3]\n'
        documents = [self.one_mass('shape = "table"\nunit = "g"\n' + how)
                     for how in (inline, 'file = "s.csv"\n', 'file = "three.csv"\ncolumn = 3\n')]
        for document in documents[1:]:
            self.assertEqual(document["gaps"], documents[0]["gaps"])
        self.assertEqual(documents[1]["excitation"]["file"], "s.csv")

    def test_a_spectrum_of_this_program_is_read(self):
        """Of one mass, the gap's own record by its response spectrum is the record's own peak."""
        record = SOURCE / "data" / "el-centro-1940-ns.csv"
        self.done("spectrum", record, "--unit", "g", "--length", "m", "--periods", "0.9:2.1:400", "-o",
                  self.folder / "s.csv")
        case = 'shape = "table"\nunit = "m/s2"\nfile = "s.csv"\ncolumn = 4\n'
        by_spectrum = self.one_mass(case)["buildings"][0]["peak_displacement_cqc"][0]
        run = self.folder / "run.toml"
        run.write_text(self.ONE_MASS.replace('"spectrum"', '"record"') + f'file = "{record}"\nunit = "g"\n')
        peak = json.loads(self.done("run", run, "--json").stdout)["buildings"][0]["peak_displacement_no_contact"][0]
        self.assertAlmostEqual(by_spectrum / peak, 1, delta=2e-3)  # straight lines between 400 ordinates

    def test_reduction_is_for_the_codes_alone(self):
        codes = '[code]\nen-1998-1 = { behaviour_factor = 3.0 }\n'
        table = 'shape = "table"\nunit = "g"\nperiods = [0, 3]\naccelerations = [0.4, 0.2]\n'
        whole, reduced = (self.one_mass(table + extra + codes)["gaps"][0] for extra in ("", "reduction = 3.0\n"))
        self.assertEqual(whole["srss"], reduced["srss"])
        self.assertAlmostEqual(whole["codes"][0]["gap"], 3 * reduced["codes"][0]["gap"], delta=1e-12)
        self.assertAlmostEqual(reduced["codes"][0]["gap"], reduced["abs"], delta=1e-12)  # across a property line

    def test_what_needs_a_run_says_so_with_the_place(self):
        case = self.FOLDER / "design-spectrum.toml"
        study = self.folder / "study.toml"
        study.write_text(f'case = "{case}"\n[[vary]]\nparameter = "gap[0].width"\nvalues = [0.1, 0.2]\n')
        line = next(i for i, text in enumerate(case.read_text().splitlines(), 1) if text.startswith("kind ="))
        for command in (["run", case], ["run", case, "-o", self.folder / "r"], ["gap", study],
                        ["sweep", study, "-o", self.folder / "r.nc"]):
            message = self.fails(2, *command).stderr
            self.assertIn(f"design-spectrum.toml:{line}:8: error: excitation.kind = \"spectrum\"", message)
            self.assertIn('needs kind = "record"', message)
        self.assertEqual([file.name for file in self.folder.iterdir()], ["study.toml"])
        self.assertIn("no errors", self.done("check", case).stdout)
        self.assertIn("Eight storeys", self.done("modes", case).stdout)

    def test_a_report_of_gaps_peaks_and_screening(self):
        case = self.FOLDER / "spectrum-table.toml"
        gap, = json.loads(self.done("gap", case, "--json").stdout)["gaps"]
        for language, words in (("en", ["Difference", "Screening", "0.004232 m too small", "nothing was simulated",
                                       "What codes amplify is divided by</th><td>8, 5<"]),
                                ("id", ["Selisih", "Penapisan", "kurang 0.004232 m", "tidak ada yang disimulasikan"])):
            output = self.folder / "r.html"
            self.done("report", case, "-o", output, "--lang", language)
            page = html.unescape(output.read_text()).replace("\u00a0", " ")
            for word in [*words, "CQC", "ASCE 7-16, IBC", "FEMA P-154", "site-spectrum.csv", "Six | Four",
                         f"{gap['gap_needed']:.4g}", f"{gap['abs']:.4g}"]:
                self.assertIn(word, page)
            self.assertIn('<meta http-equiv="Content-Security-Policy"', page)

    def test_srss_and_cqc_are_told_and_one_is_combined(self):
        text = (self.FOLDER / "design-spectrum.toml").read_text()
        case = self.folder / "case.toml"
        needed = {}
        for method in "cqc", "srss":
            case.write_text(text.replace('kind = "spectrum"', f'kind = "spectrum"\nmodal_combination = "{method}"'))
            document = json.loads(self.done("gap", case, "--json").stdout)
            needed[method] = document["gaps"][0]["watched_floors"]
            for building in document["buildings"]:
                self.assertEqual(len(building["peak_displacement_srss"]), len(building["elevations"]))
                self.assertNotEqual(building["peak_displacement_srss"], building["peak_displacement_cqc"])
        self.assertNotEqual(needed["cqc"], needed["srss"])
        self.assertEqual(len(needed["cqc"]), 9)


    def test_in_plan_it_acts_along_both_axes(self):
        text = (SOURCE / "examples" / "plan" / "twisting-pair.toml").read_text()
        case = self.folder / "plan.toml"
        spectrum = 'kind = "spectrum"\nshape = "en-1998-1"\nground_acceleration = 0.25\nspectrum_type = 1\nground_type = "C"\n'
        case.write_text(re.sub(r"(?ms)^\[excitation\].*", "", text) + "[excitation]\n" + spectrum)
        document = json.loads(self.done("gap", case, "--json").stdout)
        gap, = document["gaps"]
        self.assertEqual(gap["judgement"]["value"], "too small")
        self.assertIn("spectrum_both", [one["kind"] for one in document["statements"]])
        self.assertEqual([rule["reason"] for rule in gap["rules"] if rule["rule"] == "ddc"], ["turning"])
        needed = max(point["gap_needed"] for point in gap["points"])
        self.assertAlmostEqual(gap["gap_needed"], needed, delta=1e-15)
        for building in document["buildings"]:
            self.assertEqual(len(building["peak_displacement_y_cqc"]), len(building["elevations"]))
        said = f"{needed:.4g}"
        self.assertIn(said, self.done("gap", case).stdout)
        least = json.loads(self.done("remedy", case, "--json").stdout)["gaps"][0]
        self.assertGreaterEqual(least["least_gap"], needed)
        self.assertIn("which makes no run", self.done("check", case).stdout)
        page = self.folder / "r.html"
        for project in ("", '\n[project]\nname = "Hotel"\n'):
            case.write_text(case.read_text() + project)
            self.done("report", case, "-o", page)
            self.assertIn(said, page.read_text())
        for more, why in (("angle = 30\n", "a spectrum acts along x and along y alike"),
                          ('y = { kind = "none" }\n', "a spectrum acts along x and along y alike")):
            case.write_text(re.sub(r"(?ms)^\[excitation\].*", "", text) + "[excitation]\n" + spectrum + more)
            self.assertIn(why, self.fails(2, "check", case).stderr)


class Screening(CommandLine):
    def test_in_table_json_and_report(self):
        case = SOURCE / "examples" / "gaps" / "design-spectrum.toml"
        text = self.done("gap", case).stdout
        for words in (r"Floors apart in height +1\.5 +0\.61 +m +attention +FEMA P-154", r"Difference in storeys +3 +2\.00 +attention",
                      r"Pounding to be scored +yes", r"Gap over height +0\.5714 +1\.50 +% +attention +ASCE 41-17",
                      r"Mass ratio +2\.048 +2\.00 +attention +ours", "by memory: check the text"):
            self.assertRegex(text, words)
        gap, = json.loads(self.done("gap", case, "--json").stdout)["gaps"]
        rules = {one["rule"]: one for one in gap["screening"]}
        page = (SOURCE / "docs" / "separation-rules.md").read_text()
        for rule, one in rules.items():
            self.assertEqual(list(one), ["rule", "value", "limit", "unit", "verdict", "source", "wording"])
            self.assertIn(f"| `{rule}` |", page)
            self.assertTrue(one["wording"] == "ours" or one["wording"] == "by memory, check the text")
        self.assertAlmostEqual(rules["gap-per-storey"]["limit"], 5 * 1.5 * 0.0254, delta=1e-12)
        self.assertEqual(rules["end-of-row"]["verdict"], "does not apply")

    def test_without_seismicity_the_rules_that_need_it_say_so(self):
        case = self.written("two-frames-si")
        self.assertRegex(self.done("gap", case).stdout, r"Gap for the storeys .* needs seismicity")
        output = self.folder / "r.html"
        self.done("report", case, "-o", output)
        page = output.read_text()
        self.assertIn("needs seismicity", page)
        self.assertIn("FEMA P-154", page)
        self.done("report", case, "-o", output, "--lang", "id")
        self.assertIn("perlu tingkat kegempaan", output.read_text())


class KnownByModes(CommandLine):
    """docs/howto/etabs_sap2000.md: the tables of another program, read and printed back."""

    CASE = SOURCE / "examples" / "gaps" / "known-by-modes.toml"

    def test_the_page_shows_the_files_and_what_the_program_prints(self):
        page = "howto/etabs_sap2000.md"
        self.assertIn(documented(page, "case"), self.CASE.read_text())
        self.assertEqual(documented(page, "shapes"), self.CASE.with_name("known-by-modes-shapes.csv").read_text())
        self.assertTrue(self.done("modes", self.CASE).stdout.startswith(documented(page, "modes")))
        self.assertTrue(self.done("gap", self.CASE).stdout.startswith(documented(page, "gap")))

    def test_modes_prints_the_table_back(self):
        office = json.loads(self.done("modes", self.CASE, "--json").stdout)["buildings"][0]
        self.assertEqual([round(period, 3) for period in office["periods"]], [0.66, 0.239, 0.151])
        self.assertLess(sum(office["effective_mass_fraction"]), 0.99)  # three modes of six
        lines = self.CASE.with_name("known-by-modes-shapes.csv").read_text().splitlines()
        rows = list(csv.reader(lines))[1:][::-1]
        for mode, shape in enumerate(office["shapes"]):
            given = [float(row[mode + 1]) for row in rows]
            scale = max(given, key=abs) / max(shape, key=abs)
            for a, b in zip(given, shape, strict=True):
                self.assertAlmostEqual(a, scale * b, delta=2e-4)  # four figures, made orthogonal

    def test_shapes_beside_the_case_are_those_in_it(self):
        rows = [row.split(",") for row in self.CASE.with_name("known-by-modes-shapes.csv").read_text().splitlines()[1:]]
        text = self.CASE.read_text().replace("../../data", str(SOURCE / "data"))
        shapes = [[float(row[mode]) for row in rows[::-1]] for mode in (1, 2, 3)]
        inside, bare = self.folder / "inside.toml", self.folder / "bare.toml"
        inside.write_text(text.replace('shapes_file = "known-by-modes-shapes.csv"', f"shapes = {shapes}"))
        bare.write_text(text.replace("known-by-modes-shapes.csv", "bare.txt"))
        (self.folder / "bare.txt").write_text("".join(" ".join(row[1:]) + "\n" for row in rows[::-1]))
        answers = {self.done("run", case, "--json").stdout.split('"buildings"')[1]
                   for case in (self.CASE, inside, bare)}
        self.assertEqual(len(answers), 1)

    def test_what_is_wrong_in_the_table_is_said_with_its_line(self):
        shapes = self.CASE.with_name("known-by-modes-shapes.csv").read_text()
        (self.folder / "known-by-modes-shapes.csv").write_text(shapes.replace("14.7,", "14.2,"))
        case = self.folder / "case.toml"
        case.write_text(self.CASE.read_text().replace("../../data", str(SOURCE / "data")))
        message = "known-by-modes-shapes.csv:4:1: error: elevation 14.2 is of no floor of the case"
        self.assertIn(message, self.fails(2, "check", case).stderr)
        self.assertIn(message, " ".join((SOURCE / "docs/howto/etabs_sap2000.md").read_text().split()))

    def test_shapes_are_an_input_that_no_output_may_overwrite(self):
        for name in "known-by-modes.toml", "known-by-modes-shapes.csv":
            shutil.copy(self.CASE.with_name(name), self.folder)
        case = self.folder / "known-by-modes.toml"
        case.write_text(case.read_text().replace("../../data", str(SOURCE / "data")))
        shapes = self.folder / "known-by-modes-shapes.csv"
        before = shapes.read_bytes()
        self.fails(2, "report", case, "-o", shapes)
        self.assertEqual(shapes.read_bytes(), before)


class WatchedFloors(CommandLine):
    """Floors that face a column: in the gap needed and in every verdict."""

    CASE = """
[[building]]
name = "A"
damping = 0.02
stick = { storey_heights = [3.0, 3.0, 3.0], masses = [30e3, 30e3, 30e3], stiffnesses = [9e6, 9e6, 9e6] }

[[building]]
name = "B"
damping = 0.05
stick = { storey_heights = [4.0, 4.0, 4.0], masses = [20e3, 20e3, 20e3], stiffnesses = [60e6, 60e6, 60e6] }

[[gap]]
between = ["A", "B"]
width = WIDTH
elevations = []

[excitation]
kind = "harmonic"
period = 0.8
displacement_amplitude = 0.02

[analysis]
duration = 5.0
"""

    def with_width(self, width):
        file = self.folder / "case.toml"
        file.write_text(self.CASE.replace("WIDTH", str(width)))
        return file

    def summary(self, case):
        return json.loads(self.done("run", case, "--json").stdout)["gaps"][0]

    def test_the_verdict_says_so_first_and_how_to_model_it(self):
        case = self.with_width(0.01)
        gap = self.summary(case)
        met = gap["unmodelled_contact"]
        self.assertEqual(gap["points"], [])
        self.assertEqual((met[0]["floor_of"], met[0]["elevation"]), ("A", 9))
        self.assertLess(met[0]["least_opening"], -0.001)
        self.assertEqual([one["least_opening"] for one in met], sorted(one["least_opening"] for one in met))
        self.assertIn("give B as building.frame, whose column it can strike", met[0]["to_model"])
        text = self.done("run", case).stdout
        verdict = text.split("\n\n")[1].splitlines()
        self.assertRegex(" ".join(verdict).replace("   ", " "),
                         r"^POUNDING THAT IS NOT MODELLED: The floor of A at level 9 m goes 0\.\d+ m into the column of B "
                         r"at\s+[\d.]+ s of the motion as recorded, where no contact is modelled")
        self.assertNotIn("NO POUNDING", text)
        self.assertRegex(text, r"There the floor of A\s+faces the column of B\.")

    def test_the_gap_needed_is_enough_and_a_smaller_one_is_not(self):
        needed = self.summary(self.with_width(0.01))["gap_needed"]
        gap = json.loads(self.done("gap", self.with_width(0.01), "--json").stdout)["gaps"][0]
        reversed_too = max(needed, gap["gap_needed_reversed"])
        self.assertEqual(gap["gap_needed"], needed)
        self.assertEqual(max(floor["gap_needed"] for floor in gap["watched_floors"]), needed)
        self.assertRegex(self.done("gap", self.with_width(0.999 * needed)).stdout, r"(?s)they need .* too\s+small")
        self.assertEqual(len(self.summary(self.with_width(0.999 * needed))["unmodelled_contact"]), 1)
        wide = self.with_width(1.001 * needed)
        self.assertEqual(self.summary(wide)["unmodelled_contact"], [])
        wide = self.with_width(1.001 * reversed_too)
        judged = json.loads(self.done("gap", wide, "--json").stdout)["gaps"][0]["judgement"]
        self.assertEqual({one["kind"] for one in judged["reasons"]}, {"motion left"})  # the harmonic motion goes on
        self.assertEqual(judged["value"], "not known")

    def test_the_deepest_is_told_and_the_others_counted(self):
        case = self.with_width(0.01)
        self.assertEqual(len(self.summary(case)["unmodelled_contact"]), 5)
        text = self.done("run", case).stdout
        self.assertEqual(text.count("To model it"), 1)
        self.assertRegex(text, r"So do 4\s+more\s+floors")
        for thousandths in range(999, 900, -1):  # narrower and narrower
            case = self.with_width(thousandths / 1000 * self.summary(self.with_width(0.01))["gap_needed"])
            if len(self.summary(case)["unmodelled_contact"]) == 2:
                self.assertRegex(self.done("run", case).stdout, r"So does one\s+more\s+floor")
                return
        self.fail("two floors never meet")

    def test_floors_that_nearly_meet_are_told_of_the_tolerance(self):
        # A's middle floor at 6 faces B's column 0.5 m below a floor, B's lowest floor meets A's.
        case = self.with_width(0.01)
        case.write_text(case.read_text().replace("[4.0, 4.0, 4.0]", "[3.0, 3.5, 4.0]")
                        .replace("elevations = []", 'contact = { law = "linear", stiffness = 1e7 }'))
        texts = {one["elevation"]: one["to_model"] for one in self.summary(case)["unmodelled_contact"]}
        self.assertRegex(texts[6], r"gap.level_tolerance = 0.5\d* lets it meet the floor of B at level 6.5 m")
        case.write_text(case.read_text().replace("width = 0.01", "width = 0.01\nlevel_tolerance = 0.51"))
        gap = self.summary(case)
        self.assertEqual([point["elevation"] for point in gap["points"]], [3, 6.25])
        self.assertNotIn(6, [one["elevation"] for one in gap["unmodelled_contact"]])

    def test_report_of_the_case_and_of_its_results(self):
        case, page = self.with_width(0.01), self.folder / "report.html"
        for language, badge in ("en", "Pounding that is not modelled"), ("id", "Benturan yang tidak dimodelkan"):
            self.done("report", case, "-o", page, "--lang", language)
            text = page.read_text()
            self.assertEqual(re.findall('<p class="badge">(.*?)</p>', text), [badge])
        self.done("run", "-q", case, "-o", self.folder / "out")
        leads = []
        for source in case, self.folder / "out":
            self.done("report", source, "-o", page)
            leads.append(re.findall('<p class="lead">(.*?)</p>', page.read_text()))
            self.assertNotIn("to spare", page.read_text())
        self.assertIn("the column of B", leads[0][0])
        self.assertEqual(*leads)

    def test_sweep_counts_and_warns(self):
        self.with_width(0.01)
        study, results, page = self.folder / "study.toml", self.folder / "r.nc", self.folder / "report.html"
        study.write_text('case = "case.toml"\n[[vary]]\nparameter = "gap[0].width"\nvalues = [0.01, 0.02, 5.0]\n')
        met = sum(len(self.summary(self.with_width(width))["unmodelled_contact"]) > 0 for width in (0.01, 0.02, 5.0))
        self.with_width(0.01)
        warning = self.done("sweep", study, "-o", results).stderr
        self.assertIn(f"In {met} of 3 runs a floor meets a column", warning)
        error = self.fails(2, "plot", results, "peak-force", "-o", self.folder / "force.svg").stderr
        self.assertIn('no figure "peak-force"', error)
        self.done("report", results, "-o", page)
        text = html.unescape(page.read_text()).replace("\u00a0", " ")
        self.assertIn(f"The buildings collide in {met} of 3 runs.", text)
        needed = self.summary(self.with_width(0.01))["gap_needed"]
        self.assertIn(f"a gap of up to {needed:.4g} m", text)
        self.with_width(0.01)
        of_study = json.loads(self.done("gap", study, "--json").stdout)["studied"][0]["gaps"][0]["largest"]
        self.assertEqual(of_study["gap_needed"], needed)


class Spectrum(CommandLine):
    RECORD = SOURCE / "data" / "el-centro-1940-ns.csv"

    def test_table_json_and_csv_agree(self):
        out = self.folder / "spectrum.csv"
        document = json.loads(self.done("spectrum", self.RECORD, "--unit", "g", "--periods", "0.1:2:7", "--length", "cm",
                                        "--json", "-o", out).stdout)
        self.assertEqual(len(document["period"]), 7)
        self.assertEqual((document["period"][0], document["period"][-1]), (0.1, 2))
        with out.open() as file:
            rows = list(csv.DictReader(file))
        self.assertEqual([float(row["period [s]"]) for row in rows], document["period"])
        self.assertEqual([float(row["displacement [cm]"]) for row in rows], document["displacement"])
        english, indonesian = (self.done("spectrum", self.RECORD, "--unit", "g", "--lang", language).stdout for language in ("en", "id"))
        self.assertEqual(*(re.findall(r"[0-9.]+", text) for text in (english, indonesian)))
        self.assertIn("Percepatan semu", indonesian)
        self.assertEqual([float(row["pseudo_acceleration [cm/s2]"]) for row in rows], document["pseudo_acceleration"])
        for row, g in zip(rows, document["pseudo_acceleration"], strict=True):
            self.assertAlmostEqual(float(row["pseudo_acceleration [g]"]), g / 980.665, delta=1e-12)
        self.assertAlmostEqual(document["pga"] / 980.665, 0.31882, delta=1e-12)
        text = self.done("spectrum", self.RECORD, "--unit", "g").stdout
        self.assertIn("(two-column, g, 1 header line): 1560 values every 0.02 s, 31.18 s long", text)
        self.assertIn("damping 5 %, peak ground acceleration 0.3188 g\n", text)
        self.assertEqual(len(text.splitlines()), 3 + 3 + 41)
        self.assertEqual(document["record"], {
            "file": str(self.RECORD), "format": "two-column", "unit": "g", "channel": "", "header_lines": 1,
            "mean_removed": 0, "time_step": document["record"]["time_step"], "count": 1560, "duration": 31.18,
            "pga_read": 0.31882, "polarity": "as-recorded", "pga": document["pga"]})
        self.assertAlmostEqual(document["record"]["time_step"], 0.02, delta=1e-15)

    def test_short_periods_have_the_peak_ground_acceleration(self):
        document = json.loads(self.done("spectrum", self.RECORD, "--unit", "g", "--periods", "0.001:0.002:2",
                                        "--json").stdout)
        self.assertAlmostEqual(document["pseudo_acceleration"][0] / document["pga"], 1, delta=1e-2)

    def test_what_is_read_is_chosen_and_told(self):
        """A file of two channels, a heading that looks like rows, and values row by row."""
        two = SOURCE / "tests" / "bad_input" / "good-two-channels.V2"
        self.assertIn("say in --channel or --component which one", self.fails(2, "spectrum", two).stderr)
        self.assertIn("channel 2 of 2 (Chan 2: Up)", self.done("spectrum", two, "--component", "U-D").stdout)
        self.assertIn('has no component "N-S", but "Chan 1: 90 Deg", "Chan 2: Up"',
                      self.fails(2, "spectrum", two, "--component", "N-S").stderr)
        text = self.done("spectrum", two, "--channel", "1").stdout
        self.assertIn("(csmip, cm/s², channel 1 of 2 (Chan 1: 90 Deg), 12 header lines): 3 values every 0.02 s", text)
        self.assertIn("peak ground acceleration 123 cm/s² = 0.1254 g", text)
        heading = self.folder / "heading.txt"
        heading.write_text("4000 points\n0.00 0.01\n0.02 -0.02\n0.04 0.03\n")
        self.assertIn("give --skip-lines 1", self.fails(2, "spectrum", heading, "--unit", "g").stderr)
        self.assertIn("1 header line", self.done("spectrum", heading, "--unit", "g", "--skip-lines", "1").stdout)
        block = SOURCE / "tests" / "bad_input" / "bad-block.txt"
        self.assertIn("--format values", self.fails(2, "spectrum", block, "--unit", "g").stderr)
        text = self.done("spectrum", block, "--unit", "g", "--format", "values", "--time-step", "0.01").stdout
        self.assertIn("(values, g, 1 header line): 15 values every 0.01 s", text)
        self.assertIn("the file says 0.02 s",
                      self.fails(2, "spectrum", two, "--channel", "1", "--time-step", "0.01").stderr)

    def test_what_the_heading_says_is_held_against_the_user(self):
        """A file that says Gal and 0.005 s, of three channels, once read as 100 g every 0.01 s without a word."""
        rows = "".join(f"{100 * math.sin(0.1 * i):10.4f}{50 * math.sin(0.1 * i):10.4f}{0:10.4f}\n" for i in range(400))
        asa = self.folder / "asa.dat"
        asa.write_text("ARCHIVO ESTANDAR DE ACELERACION:\nORIENTACION C1-C6 (rumbo;orientacion)  : /N90E;/N00E;/V;+\n"
                       "INTERVALO DE MUESTREO, C1-C6, (s)      : /0.005/0.005/0.005\n"
                       "NUM. TOTAL DE MUESTRAS, C1-C6          : /400/400/400\n"
                       "UNIDADES DE LOS DATOS                  : Gal (cm/s/s)\nDATOS DE ACELERACION:\n" + rows)
        result = self.fails(2, "spectrum", asa, "--column", "1", "--time-step", "0.01", "--unit", "g")
        self.assertEqual(result.stderr,
                         f"{asa}:3:1: error: --time-step is 0.01 s, but the file says 0.005 s in line 3\n"
                         f'{asa}:5:1: error: --unit is "g", but the file says "cm/s2" in line 5\n')
        text = self.done("spectrum", asa, "--component", "N-S").stdout
        self.assertIn("(asa, cm/s², channel 2 of 3 (N00E), 6 header lines): 400 values every 0.005 s, 1.995 s long", text)

    def test_bad_input(self):
        self.assertIn("--unit", self.fails(2, "spectrum", self.RECORD).stderr)
        self.assertIn("no such file", self.fails(2, "spectrum", self.folder / "none.AT2").stderr)
        for wrong in (["--periods", "1:2"], ["--periods", "2:1:5"], ["--periods", "0:1:5"], ["--periods", "1:2:x"],
                      ["--periods", "1:2:5:6"], ["--damping", "1"], ["--damping", "-0.1"], ["--unit", "furlong"],
                      ["--length", "yard"], ["--column", "0"], ["--periods", "1e-9:1:5"]):
            self.fails(2, "spectrum", self.RECORD, "--unit", "g", *wrong)
        at2 = SOURCE / "tests" / "bad_input" / "good.AT2"
        self.assertIn("the file says", self.fails(2, "spectrum", at2, "--unit", "cm/s2").stderr)
        one_column = SOURCE / "tests" / "bad_input" / "good-one-column.txt"
        self.assertIn("give --time-step", self.fails(2, "spectrum", one_column, "--unit", "g").stderr)
        self.done("spectrum", at2)
        self.fails(1, "spectrum", at2, "-o", "/proc/none/spectrum.csv")


class Sensitivity(CommandLine):
    def test_words_tables_and_json_agree(self):
        found = json.loads(self.done("sensitivity", EL_CENTRO, "--json").stdout)
        numbers = [number["path"] for number in found["numbers"]]
        force = next(p for p in found["peaks"] if p["quantity"] == "peak_force" and p["largest"])
        most = max(range(len(numbers)), key=lambda i: abs(force["elasticity"][i]))
        for language, way in (("en", "smaller"), ("id", "lebih kecil")):
            text = " ".join(self.done("sensitivity", EL_CENTRO, "--lang", language).stdout.split())
            part = f"{abs(force['elasticity'][most]):.3f}".rstrip("0")
            self.assertIn(f"{part} % {way}", text)
            self.assertIn(numbers[most], text)
        # The gap needed is that of the run without contact, which grows as the motion does.
        needed = next(p for p in found["peaks"] if p["quantity"] == "gap_needed" and p["largest"])
        self.assertAlmostEqual(needed["elasticity"][numbers.index("excitation.pga")], 1, 9)
        self.assertEqual(needed["elasticity"][numbers.index("gap[0].width")], 0)

    def test_numbers_that_are_asked_for_and_the_file(self):
        file = self.folder / "s.json"
        self.done("sensitivity", EL_CENTRO, "--by", "gap[0].width", "-o", file)
        found = json.loads(file.read_text())
        self.assertEqual([number["path"] for number in found["numbers"]], ["gap[0].width"])
        self.done("sensitivity", EL_CENTRO, "--by", "gap[0].width", "-o", file)  # its own result is replaced
        file.write_text("mine")
        self.fails(2, "sensitivity", EL_CENTRO, "-o", file)
        self.assertEqual(file.read_text(), "mine")

    def test_what_is_not_followed_is_refused_with_the_reason(self):
        for case, why in (("hinged-frame", "yields"), ("restitution-asked", "curved")):
            self.assertIn(why, self.fails(2, "sensitivity", SOURCE / "examples" / f"{case}.toml").stderr)
        self.assertIn("no number", self.fails(2, "sensitivity", EL_CENTRO, "--by", "gap[0].between").stderr)
        self.assertIn('did you mean "width"?', self.fails(2, "sensitivity", EL_CENTRO, "--by", "gap[0].widht").stderr)


class Report(CommandLine):
    """What a browser makes of the page: tests/report."""

    def test_one_file_in_two_languages(self):
        case = self.written("m12-el-centro")
        for language, word in ("en", "collide 37 times"), ("id", "berbenturan 37 kali"):
            page = self.folder / "made" / f"{language}.html"
            result = self.done("report", case, "-o", page, "--lang", language)
            self.assertEqual(result.stdout, "")
            self.assertRegex(result.stderr, rf"^Wrote {re.escape(str(page))} \(\d+ kB\)\n$")
            text = page.read_text()
            self.assertIn(word, text)
            self.assertTrue(text.startswith("<!DOCTYPE html>") and text.endswith("</html>\n"))
            self.assertEqual([file.name for file in page.parent.glob(".*")], [], "nothing temporary is left")
        self.assertEqual(len(list((self.folder / "made").iterdir())), 2)

    def test_the_same_case_gives_the_same_bytes_and_nothing_of_this_machine(self):
        case = self.written("row-of-three")
        pages = [self.folder / "one.html", self.folder / "two.html"]
        for page in pages:
            self.done("report", case, "-o", page)
        self.assertEqual(*(page.read_bytes() for page in pages))
        self.assertNotIn(str(self.folder), pages[0].read_text())

    def test_figures_need_no_other_program(self):
        case, page = self.written("m12-el-centro"), self.folder / "report.html"
        self.done("report", case, "-o", page, env={"PATH": str(self.folder)})
        self.assertEqual(len(re.findall("<figure(?! class=.overview)[^>]*>", page.read_text())), 13)

    def test_results_give_the_verdict_of_their_case(self):
        for name in "m12-el-centro", "row-of-three", "restitution-asked", "free-impact":
            case = self.written(name)
            self.done("run", "-q", case, "-o", self.folder / name)
            pages = []
            for source in case, self.folder / name:
                page = self.folder / "report.html"
                self.done("report", source, "-o", page)
                pages.append(page.read_text())
            from_case, from_results = (re.findall('<p class="lead">(.*?)</p>', page) for page in pages)
            self.assertEqual(from_case, from_results)
            lists = [re.search('<table id="impact-list".*?</table>', page, re.DOTALL)[0] for page in pages]
            self.assertEqual(*lists)
            for text in pages:
                self.assertIn("DDC", text)
            # Without the case's copy there is less to tell.
            (self.folder / name / "case.toml").unlink()
            self.done("report", self.folder / name, "-o", page)
            self.assertIn("DDC and the rules of building codes are in a report made from the case", page.read_text())

    def test_a_sweep_counts_the_runs_that_collide(self):
        case = self.written("m12-el-centro")
        study, results, page = self.folder / "study.toml", self.folder / "r.nc", self.folder / "report.html"
        study.write_text('case = "m12-el-centro.toml"\n[[vary]]\nparameter = "gap[0].width"\n'
                         'from = 0.0\nto = 1.0\ncount = 5\n')
        self.done("sweep", study, "-o", results)
        self.done("report", results, "-o", page)
        text = html.unescape(page.read_text()).replace("\u00a0", " ")
        forces = {}
        for width in 0.0, 0.25, 0.5, 0.75, 1.0:
            other = self.folder / "other.toml"
            other.write_text(re.sub(r"width = 0.2 ", f"width = {width} ", case.read_text()))
            points = json.loads(self.done("run", other, "--json").stdout)["gaps"][0]["points"]
            forces[width] = max(point["peak_force"] for point in points)
        colliding = sum(force > 0 for force in forces.values())
        self.assertTrue(0 < colliding < 5)
        self.assertIn(f"The buildings collide in {colliding} of 5 runs.", text)
        hardest = max(forces, key=forces.get)
        self.assertIn(f"The largest contact force is {forces[hardest]:.4g} kgf, at gap {hardest:g} cm.", text)
        self.assertIn("In 5 of 5 runs it is not known", text)  # the record goes on after them
        self.assertIn(study.read_text(), text)
        self.assertIn("bentur report: ", self.fails(2, "report", self.folder / "none.nc", "-o", page).stderr)

    def test_results_that_are_none(self):
        page, folder = self.folder / "report.html", self.folder / "results"
        self.done("run", EL_CENTRO, "-q", "-o", folder)
        whole = {file.name: file.read_bytes() for file in folder.iterdir()
                 if file.name not in ("case.toml", "impacts.csv")}
        self.done("run", "-q", self.written("free-impact"), "-o", self.folder / "other")
        for name in whole:
            for content in None, b"", b"nonsense", (self.folder / "other" / name).read_bytes():
                with self.subTest(name, content=content and content[:20]):
                    (folder / name).unlink()
                    if content is not None:
                        (folder / name).write_bytes(content)
                    message = self.fails(2, "report", folder, "-o", page).stderr
                    self.assertRegex(message, r"^bentur report: \S*/(summary\.json|histories\.nc)")
                    self.assertFalse(page.exists())
                    (folder / name).write_bytes(whole[name])

    def test_bad_input_writes_nothing(self):
        case = self.edited("m12-el-centro", "duration = 10.0", "duration = -1.0")
        page = self.folder / "new" / "report.html"
        self.assertIn("analysis.duration = -1", self.fails(2, "report", case, "-o", page).stderr)
        self.assertIn("none.toml", self.fails(2, "report", self.folder / "none.toml", "-o", page).stderr)
        self.fails(2, "report", self.written("free-impact"))
        self.assertIn("--lang", self.fails(2, "report", self.written("free-impact"), "-o", page, "--lang", "fr").stderr)
        self.assertFalse(page.parent.exists())

    def test_an_output_that_cannot_be_written(self):
        case = self.written("free-impact")
        self.assertIn("is a folder", self.fails(2, "report", case, "-o", self.folder).stderr)
        self.fails(1, "report", case, "-o", "/proc/none/report.html")


class Completion(CommandLine):
    def complete(self, *words):
        """What the last of `words` completes to."""
        script = (f'source "{SOURCE}/apps/bentur/completion.bash"\n'
                  'COMP_WORDS=("$@"); COMP_CWORD=$(($# - 1)); _bentur; printf "%s\\n" "${COMPREPLY[@]}"')
        result = subprocess.run([BASH, "-c", script, "bash", BENTUR, *words], capture_output=True, text=True,
                                cwd=self.folder)
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertEqual(result.stderr, "")
        return sorted(result.stdout.split())

    def test_commands_and_options(self):
        self.assertEqual(self.complete(""), sorted(COMMANDS + ["--help", "--version"]))
        self.assertEqual(self.complete("m"), ["modes"])
        self.assertEqual(self.complete("modes", "--method", "j"), ["jacobi"])
        self.assertEqual(self.complete("report", "--lang", "i"), ["id"])
        for command in COMMANDS:
            text = self.done(command, "--help").stdout
            for option in self.complete(command, "--"):
                self.assertIn(option, text, f"{command} knows {option}")
            self.assertRegex(text, r"Example: bentur " + command, "help ends with an example")

    def test_cases_folders_and_examples(self):
        (self.folder / "case.toml").touch()
        (self.folder / "notes.txt").touch()
        (self.folder / "cases").mkdir()
        for command in "run", "report", "gap", "modes", "check":
            self.assertEqual(self.complete(command, "ca"), ["case.toml", "cases"])
        (self.folder / "results.nc").touch()
        self.assertEqual(self.complete("report", ""), ["case.toml", "cases", "results.nc"])
        self.assertEqual(self.complete("run", ""), ["case.toml", "cases"])
        self.assertEqual(self.complete("run", "case.toml", "-o", ""), ["cases"])
        self.assertEqual(self.complete("example", ""), sorted([*EXAMPLES, *STUDIES]))
        self.assertEqual(self.complete("example", "m12-h"), ["m12-harmonic"])
        (self.folder / "results.nc").touch()
        self.assertEqual(self.complete("plot", ""), ["cases", "results.nc"])
        self.done("run", EL_CENTRO, "-o", self.folder)
        self.assertEqual(self.complete("plot", "histories.nc", "e"), ["envelope"])


def load_tests(loader, tests, pattern):
    return part_under_sanitizers(tests, 9)


if __name__ == "__main__":
    unittest.main()
