#!/usr/bin/env python3
"""Remedies as a user meets them: words, JSON, figure, a search that is stopped and gone on with.

The program under test is the environment variable BENTUR, the repository BENTUR_SOURCE. What is found is confirmed by
plain runs; that it is the best, by src/bentur/study/remedy/remedy_test.cpp.
"""

import json
import pathlib
import shutil
import signal
import subprocess
import tempfile
import time
import unittest

from sweep_test import BENTUR, SOURCE, load_tests

STUDY = SOURCE / "examples" / "studies" / "linked-pair-damper.toml"


class Remedy(unittest.TestCase):
    def setUp(self):
        self.folder = pathlib.Path(tempfile.mkdtemp(prefix="bentur-remedy-"))
        self.addCleanup(shutil.rmtree, self.folder)
        self.output, self.part = self.folder / "remedy.json", self.folder / "remedy.json.part"

    def bentur(self, *arguments, status=0):
        result = subprocess.run([BENTUR, *map(str, arguments)], capture_output=True, text=True, timeout=300)
        self.assertEqual(result.returncode, status, result.stdout + result.stderr)
        return result

    def study(self, *changes):
        """The example's study in a folder of the test, with other words."""
        text = STUDY.read_text().replace('"../linked-pair.toml"', f'"{SOURCE}/examples/linked-pair.toml"')
        for old, new in changes:
            self.assertIn(old, text)
            text = text.replace(old, new)
        path = self.folder / "study.toml"
        path.write_text(text)
        return path

    def gap_needed(self, damping, polarity):
        case = (SOURCE / "examples" / "linked-pair.toml").read_text()
        case = case.replace("damping = [100.0, 200.0]", f"damping = {damping!r}").replace("../data", f"{SOURCE}/data")
        case = case.replace('unit = "g"', f'unit = "g"\npolarity = "{polarity}"')
        path = self.folder / "case.toml"
        path.write_text(case)
        points = json.loads(self.bentur("run", path, "--json").stdout)["gaps"][0]["points"]
        return max(point["gap_needed"] for point in points)

    def test_the_page_shows_what_is_printed_and_plain_runs_confirm_it(self):
        text = self.bentur("remedy", STUDY).stdout
        block = (SOURCE / "docs" / "studies.md").read_text().split("<!-- linked-pair-damper -->")[1]
        self.assertEqual(block.split("```\n")[1], text)
        told = self.bentur("remedy", STUDY, "--json").stdout
        for threads in "1", "3":
            self.assertEqual(self.bentur("remedy", STUDY, "--json", "--threads", threads).stdout, told)
        found = json.loads(told)
        for name in "best", "smallest":
            damping = found[name]["values"]["damping"]
            runs = [self.gap_needed(damping, polarity) for polarity in ("as-recorded", "reversed")]
            self.assertEqual(max(runs), found[name]["objective"])
        self.assertLessEqual(found["smallest"]["objective"], 0.03)
        # A little less does not keep the limit.
        less = found["smallest"]["values"]["damping"] * 0.99
        self.assertGreater(max(self.gap_needed(less, way) for way in ("as-recorded", "reversed")), 0.03)
        self.assertEqual(found["runs_each"], 2)

    def test_a_case_as_it_stands_has_its_least_gap(self):
        case = SOURCE / "examples" / "linked-pair.toml"
        found, = json.loads(self.bentur("remedy", case, "--json").stdout)["gaps"]
        runs = [self.gap_needed([100.0, 200.0], way) for way in ("as-recorded", "reversed")]
        self.assertEqual(found["gap_needed"], max(runs))
        self.assertTrue(max(runs) <= found["least_gap"] <= 1.01 * max(runs))
        said = f"Tall and Low apart in this one motion, as recorded and reversed, is {found['least_gap']} m"
        self.assertIn(said, " ".join(self.bentur("remedy", case).stdout.split()))
        self.assertIn("Celah terkecil", self.bentur("remedy", case, "--lang", "id").stdout)
        # The gap that it says is told as enough.
        text = case.read_text().replace("../data", f"{SOURCE}/data").replace("width = 0.03", f"width = {found['least_gap']}")
        wide = self.folder / "wide.toml"
        wide.write_text(text)
        self.assertFalse(json.loads(self.bentur("remedy", wide, "--json").stdout)["gaps"][0]["too_narrow"])

    def test_of_records_it_says_what_the_code_takes_of_them(self):
        case = SOURCE / "examples" / "two-real-buildings" / "record.toml"
        text = " ".join(self.bentur("remedy", case).stdout.split())
        self.assertIn("apart under 1 record, as recorded and reversed, is 0.211 m", text)
        self.assertIn("EN 1998-1 asks for 3 records or more", text)
        gap, = json.loads(self.bentur("gap", case, "--json").stdout)["studied"][0]["gaps"]
        found, = json.loads(self.bentur("remedy", case, "--json").stdout)["gaps"]
        self.assertEqual(found["gap_needed"], gap["largest"]["gap_needed"])

    def test_words_in_both_languages_file_and_figure(self):
        figure = self.folder / "remedy.svg"
        text = self.bentur("remedy", STUDY, "-o", self.output, "--figure", figure, "--lang", "id").stdout
        self.assertIn("Tindakan terkecil", text)
        self.assertFalse(self.part.exists())
        self.assertEqual(self.output.read_text(), self.bentur("remedy", STUDY, "--json").stdout)
        self.assertIn("batas", figure.read_text())
        for name in "gap_needed", "m-1":
            self.assertNotIn(name, figure.read_text().split("<desc>")[1])
        self.bentur("remedy", STUDY, "-o", self.output)  # its own result may be replaced
        mine = self.folder / "mine.json"
        mine.write_text("{}")
        self.assertIn("not written", self.bentur("remedy", STUDY, "-o", mine, status=2).stderr)

    def test_none_suffices(self):
        study = self.study(("limit = 0.03 ", "limit = 0.001 "), ("to = 20000", "to = 1000"))
        text = self.bentur("remedy", study).stdout
        self.assertIn("NONE SUFFICES: Nothing within the ranges was found that keeps gap_needed at or below 0.001 m.",
                      text)
        self.assertRegex(text, r"damping = (999\.\d|1000) kN·s/m lies at an end of its range")

    def test_control_c_keeps_what_was_tried(self):
        study = self.study(("evaluations = 80", "evaluations = 300"), ("to = 20000", "to = 20001"),
                           ('["as-recorded", "reversed"]', '["as-recorded", "reversed"]\n[[vary]]\nparameter = '
                            '"link[1].yield_force"\nfrom = 1\nto = 500'))
        whole = self.bentur("remedy", study, "--json").stdout
        command = [BENTUR, "remedy", study, "-o", self.output]
        process = subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        while not self.part.exists():
            time.sleep(0.01)
            self.assertIsNone(process.poll(), "it was done before it could be stopped")
        time.sleep(0.3)
        process.send_signal(signal.SIGINT)
        out, err = process.communicate(timeout=60)
        self.assertEqual(process.returncode, 1, err)
        self.assertRegex(out, r"Stopped after \d+ evaluations of at most 300")
        self.assertIn(f"Stopped: what was tried is kept in {self.part}; the same command with --resume goes on", err)
        self.assertFalse(self.output.exists())
        again = self.bentur("remedy", study, "-o", self.output, status=1)
        self.assertIn("go on with --resume, or remove the file", again.stderr)
        self.bentur("remedy", study, "-o", self.output, "--resume")
        self.assertEqual(self.output.read_text(), whole)
        self.assertFalse(self.part.exists())

    def test_what_is_not_asked_well_is_refused(self):
        case = SOURCE / "examples" / "linked-pair.toml"
        for option in ("-o", self.output), ("--figure", self.folder / "x.svg"), ("--resume",):
            self.assertIn("are for a study with [remedy]", self.bentur("remedy", case, *option, status=2).stderr)
        for changes, said in (
                ([('"gap_needed"', '"gap_neded"')], r"study.toml:6:\d+: error: remedy.objective = \"gap_neded\", did "
                                                    "you mean \"gap_needed\""),
                ([('"gap_needed"', '"beauty"')], "a quantity of the results: .*peak_force"),
                ([("[remedy]", "[remedie]")], "remedie.*did you mean|unknown|remedy"),
                ([("from = 100", "from = 100\ncount = 4")], "count.* is for a grid: with \\[remedy\\]"),
                ([("from = 100", "from = -100")], "from = -100")):
            self.assertRegex(self.bentur("remedy", self.study(*changes), status=2).stderr, said)
        study = self.study()
        for command in (["sweep", study, "-o", self.folder / "x.nc"], ["gap", study]):
            self.assertIn("bentur remedy", self.bentur(*command, status=2).stderr)
        self.assertIn("--resume needs --output", self.bentur("remedy", study, "--resume", status=2).stderr)


if __name__ == "__main__":
    unittest.main()
