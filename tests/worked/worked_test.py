#!/usr/bin/env python3
"""The worked examples of docs/examples and tutorials with commands: each command of a page prints what stands below it.

The program under test is the environment variable BENTUR, the repository BENTUR_SOURCE. Numbers may differ by a per cent
(counts by one), as another machine's round-off moves an impact here and there.
"""

import json
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

SOURCE = pathlib.Path(os.environ["BENTUR_SOURCE"]).resolve()
sys.path.insert(0, str(SOURCE / "tools"))
import worked_pages  # noqa: E402

PAGES = sorted((SOURCE / "docs/examples").glob("*.md")) + [
    SOURCE / "docs/tutorials" / page for page in ("yielding-frame.md", "twisting-pair.md")]
NUMBER = re.compile(r"(?<![\w.])\d+(?:\.\d+)?(?:e[+-]?\d+)?")


def words(text):
    """TEXT without numbers, padding and rules."""
    return re.sub(r"[\s─]+", " ", NUMBER.sub("0", text))


class Pages(unittest.TestCase):
    def compare(self, printed, page, command):
        self.assertEqual(words(printed), words(page), f"{command}\n./dev examples writes it anew")
        for a, b in zip(NUMBER.findall(printed), NUMBER.findall(page)):
            allowed = 1 if a.isdigit() and b.isdigit() and float(b) < 100 else 0.01 * abs(float(b))
            # The last digit that is shown may be rounded either way.
            decimals = max(len(x.partition(".")[2]) for x in (a, b))
            self.assertLessEqual(abs(float(a) - float(b)), max(allowed, 1.01 * 10.0 ** -decimals),
                                 f"{command}\n{printed}\n./dev examples writes it anew")

    def test_every_command_prints_what_its_page_says(self):
        self.assertTrue(PAGES)
        for page in PAGES:
            place, ran = worked_pages.Place(os.environ["BENTUR"], SOURCE), 0
            for needs_records, commands in worked_pages.blocks(page.read_text()):
                if needs_records and not (SOURCE / "records/far-field").is_dir():
                    continue
                for command, expected in commands:
                    with self.subTest(page=page.name, command=command):
                        self.compare(place.run(command), expected, command)
                        ran += 1
            self.assertGreater(ran, 0, page.name)

    @unittest.skipUnless((SOURCE / "records/far-field").is_dir(), "no records/: ./dev records fetches them")
    def test_those_with_many_records_ran_too(self):
        self.assertTrue(any(needs for page in PAGES for needs, _ in worked_pages.blocks(page.read_text())))


@unittest.skipUnless(os.environ.get("BENTUR_PART") == "all", "a minute of one processor: ./dev soak runs it")
class Dampers(unittest.TestCase):
    """Those of two-real-buildings.md beside a grid over their whole range."""

    def bentur(self, *arguments):
        run = subprocess.run([os.environ["BENTUR"], *map(str, arguments)], capture_output=True, text=True, timeout=280)
        self.assertEqual(run.returncode, 0, run.stderr)
        return json.loads(run.stdout)

    def test_the_search_finds_what_a_grid_finds(self):
        folder = SOURCE / "examples/two-real-buildings"
        found = self.bentur("remedy", folder / "dampers.toml", "--json")
        chosen, = found["parameters"]
        places = [i / 50 for i in range(51)]
        grid = [chosen["from"] * (chosen["to"] / chosen["from"]) ** place for place in places]
        text = (folder / "dampers.toml").read_text().replace('"record.toml"', f'"{folder}/record.toml"')
        text, count = re.subn(r"from = 1\nto = 100000\nspacing = \"log\"", f"values = {grid}", text)
        self.assertEqual(count, 1)
        head, rest = text.split("[remedy]")
        with tempfile.TemporaryDirectory() as there:
            study = pathlib.Path(there) / "grid.toml"
            study.write_text(head + rest[rest.index("[[vary]]"):])
            studied = self.bentur("gap", study, "--json")["studied"]
        needed = {}
        for one in studied:
            gap, = one["gaps"]
            damping = one["with"]["damping"]
            needed[damping] = max(needed.get(damping, 0), gap["largest"]["gap_needed"])
        self.assertEqual(len(needed), len(grid))
        self.assertLessEqual(found["best"]["objective"], 1.01 * min(needed.values()))
        smallest = min(place for place, need in zip(places, needed.values()) if need <= found["limit"])
        self.assertLessEqual(found["smallest"]["size"], smallest)
        self.assertLessEqual(found["smallest"]["objective"], found["limit"])


if __name__ == "__main__":
    unittest.main()
