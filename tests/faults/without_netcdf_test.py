#!/usr/bin/env python3
"""What works on a machine without NetCDF, and what is said where a file of NetCDF is asked for: the program opens the library
itself (src/bentur/files/netcdf.cpp). It is BENTUR, the repository BENTUR_SOURCE, WITHOUT_NETCDF a library that is loaded
before all others and lets it not be opened.
"""

import os
import pathlib
import subprocess
import tempfile
import unittest

SOURCE = pathlib.Path(os.environ["BENTUR_SOURCE"])
CASE = SOURCE / "examples" / "m12-el-centro.toml"


class WithoutNetcdf(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory(prefix="bentur-without-netcdf-")
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def bentur(self, *arguments, without=True):
        environment = {**os.environ, "LD_PRELOAD": os.environ["WITHOUT_NETCDF"]} if without else None
        return subprocess.run([os.environ["BENTUR"], *map(str, arguments)], capture_output=True, text=True, cwd=self.folder,
                              env=environment, timeout=60)

    def refused(self, *arguments, status=1):
        result = self.bentur(*arguments)
        self.assertEqual(result.returncode, status, result.stderr)
        self.assertRegex(result.stderr, r"^bentur[a-z ]*: results in NetCDF need the library \S*netcdf\S*, which is not installed")
        self.assertEqual(len(result.stderr.splitlines()), 1)

    def test_a_run_is_told(self):
        result = self.bentur("run", CASE, "--json")
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertIn('"impacts"', result.stdout)

    def test_a_report_is_written(self):
        result = self.bentur("report", CASE, "-o", "report.html")
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertTrue((self.folder / "report.html").exists())

    def test_results_of_a_run_are_written(self):
        for without in True, False:
            result = self.bentur("run", CASE, "-o", f"results-{without}", without=without)
            self.assertEqual(result.returncode, 0, result.stderr)
        files = [(self.folder / f"results-{one}/histories.nc").read_bytes() for one in (True, False)]
        self.assertEqual(*files)

    def test_a_study_is_refused_before_it_is_run(self):
        (self.folder / "study.toml").write_text(
            f'case = "{CASE}"\n[[vary]]\nparameter = "gap[0].width"\nvalues = [0.2, 0.4]\n')
        self.refused("sweep", "study.toml", "-o", "sweep.nc")
        self.assertEqual([file.name for file in self.folder.iterdir()], ["study.toml"])

    def test_results_are_not_read(self):
        self.assertEqual(self.bentur("run", CASE, "-o", "results", without=False).returncode, 0)
        self.refused("plot", "results", "-o", "figures", status=2)


if __name__ == "__main__":
    unittest.main()
