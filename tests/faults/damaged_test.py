#!/usr/bin/env python3
"""Results whose bytes have changed: every command that opens one either reads it or says with status 2 why not.

The library that reads NetCDF dies of some of them. BENTUR is the program, BENTUR_DAMAGED how
many files are damaged (300). What is damaged how follows from its number, so that each can be made again.
"""

import os
import pathlib
import random
import re
import shutil
import subprocess
import tempfile
import unittest

BENTUR = os.environ["BENTUR"]
# What the library does not free of a damaged file is not for the sanitizers to find.
ENVIRONMENT = {**os.environ, "ASAN_OPTIONS": ":".join(filter(None, [os.environ.get("ASAN_OPTIONS"), "detect_leaks=0"]))}
COUNT = int(os.environ.get("BENTUR_DAMAGED", "150"))
STUDY = 'case = "m12-el-centro.toml"\n[[vary]]\nparameter = "gap[0].width"\nvalues = [0.2, 0.4]\n'
IDA = 'case = "m12-el-centro.toml"\n[ida]\nintensity = "pga"\nunit = "g"\nlevels = [0.1, 0.2]\n'


def damaged(whole, seed):
    """Up to twelve bytes changed, most of them where the library keeps what stands where; one in eight is cut short too."""
    chance = random.Random(seed)
    content = bytearray(whole)
    for _ in range(chance.randint(1, 12)):
        last = len(content) if chance.random() < 0.4 else min(len(content), 20000)
        content[chance.randrange(last)] = chance.choice([0, 1, 255, chance.randrange(256)])
    return bytes(content[:chance.randrange(len(content))] if chance.random() < 0.125 else content)


class Damaged(unittest.TestCase):
    def bentur(self, *arguments):
        return subprocess.run([BENTUR, *arguments], capture_output=True, text=True, cwd=self.folder, timeout=60,
                              env=ENVIRONMENT)

    def made(self, file, *arguments):
        result = self.bentur(*arguments)
        self.assertEqual(result.returncode, 0, result.stderr)
        return (self.folder / file).read_bytes()

    def test_every_command_reads_it_or_says_why_not(self):
        self.folder = pathlib.Path(tempfile.mkdtemp(prefix="bentur-damaged-"))
        self.addCleanup(shutil.rmtree, self.folder)
        self.bentur("example", "m12-el-centro", "-o", ".", "--no-schema")
        (self.folder / "study.toml").write_text(STUDY)
        (self.folder / "ida.toml").write_text(IDA)
        runs = self.made("r/histories.nc", "run", "m12-el-centro.toml", "-q", "-o", "r")
        sweep = self.made("sweep.nc", "sweep", "study.toml", "-q", "-o", "sweep.nc")
        ida = self.made("ida.nc", "ida", "ida.toml", "-q", "-o", "ida.nc")
        ways = [(runs, "r/histories.nc", ("plot", "r", "displacement", "-o", "x.svg", "--force")),
                (runs, "r/histories.nc", ("report", "r", "-o", "x.html")),
                (sweep, "sweep.nc", ("plot", "sweep.nc", "peak-force", "-o", "x.svg", "--force")),
                (sweep, "sweep.nc", ("report", "sweep.nc", "-o", "x.html")),
                (sweep, "sweep.nc", ("sweep", "study.toml", "-q", "--resume", "-o", "sweep.nc")),
                (ida, "ida.nc", ("fragility", "ida.nc")),
                (ida, "ida.nc", ("ida", "ida.toml", "-q", "-o", "ida.nc"))]
        refused = 0
        for seed in range(1, COUNT + 1):
            whole, file, command = ways[seed % len(ways)]
            (self.folder / file).write_bytes(damaged(whole, seed))
            result = self.bentur(*command)
            self.assertIn(result.returncode, (0, 2), f"seed {seed}: {command}\n{result.stderr}")
            if result.returncode == 2:
                refused += 1
                self.assertRegex(result.stderr, re.compile(r"^\S.*: \S.*\n", re.M), f"seed {seed}: {command}")
        self.assertGreater(refused, COUNT // 10, "damage is seen")


if __name__ == "__main__":
    unittest.main()
