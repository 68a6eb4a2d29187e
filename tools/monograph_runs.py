"""Runs the cases and studies of examples/monograph and returns their numbers, for monograph.py."""

import csv
import json
import pathlib
import re
import statistics
import subprocess
import sys

import netCDF4

PAIRS = ["m12", "m13", "m14", "m32"]
MOTIONS = ["harmonic", "El Centro"]
READINGS = ["printed", "sections", "periods"]
SUFFIX = {"harmonic": "harmonic", "El Centro": "el-centro"}


class Runs:
    """Runs of the program on a copy of examples/monograph in FOLDER, with another record where one is given."""

    def __init__(self, bentur, root, folder, record=None):
        self.bentur, self.folder = bentur, folder / "examples/monograph"
        self.folder.mkdir(parents=True, exist_ok=True)
        if not (folder / "data").exists():
            (folder / "data").symlink_to(root / "data")
        for file in sorted((root / "examples/monograph").glob("*.toml")):
            text = file.read_text()
            if record is not None:
                text = re.sub(r'file = "[^"]*"', lambda _: f"file = {json.dumps(str(record))}", text)
            (self.folder / file.name).write_text(text)

    def call(self, *arguments):
        result = subprocess.run([self.bentur, *map(str, arguments)], cwd=self.folder, capture_output=True, text=True)
        if result.returncode != 0:
            sys.exit(f"bentur {' '.join(map(str, arguments))}\n{result.stderr}")
        return result.stdout

    def run(self, case, name, changes=(), figures=False):
        """The summary of a case, its texts changed by (old, new); results in the folder NAME."""
        text = (self.folder / f"{case}.toml").read_text()
        for old, new in changes:
            if not re.search(old, text, re.MULTILINE):
                sys.exit(f"examples/monograph/{case}.toml has no {old}")
            text = re.sub(old, new, text, flags=re.MULTILINE)
        (self.folder / f"{name}.toml").write_text(text)
        self.call("run", f"{name}.toml", "-o", name, "-q", *(["--figures", "svg"] if figures else []))
        return json.loads((self.folder / name / "summary.json").read_text())

    def fails(self, case, name, changes):
        """The message of a run that is to fail."""
        text = (self.folder / f"{case}.toml").read_text()
        for old, new in changes:
            text = re.sub(old, new, text, flags=re.MULTILINE)
        (self.folder / f"{name}.toml").write_text(text)
        result = subprocess.run([self.bentur, "run", f"{name}.toml", "-q"], cwd=self.folder, capture_output=True, text=True)
        return result.stderr.strip() if result.returncode == 3 else None

    def histories(self, name):
        with netCDF4.Dataset(self.folder / name / "histories.nc") as data:
            return {key: variable[:].filled(float("nan")).tolist() for key, variable in data.variables.items()
                    if variable.dtype is not str}

    def impacts(self, name):
        with (self.folder / name / "impacts.csv").open() as file:
            return list(csv.DictReader(file))

    def gaps(self, study):
        """(what varies, motion) -> the gap needed: largest, points, ABS."""
        found = {}
        for part in json.loads(self.call("gap", f"{study}.toml", "--json"))["studied"]:
            for record in part["gaps"][0]["records"]:
                found[(tuple(part["with"].values()), record["record"])] = record
        return found

    def sweep(self, study):
        self.call("sweep", f"{study}.toml", "-o", f"{study}.nc", "-q")
        with netCDF4.Dataset(self.folder / f"{study}.nc") as data:
            return {key: variable[:].filled(float("nan")) if variable.dtype is not str else list(variable[:])
                    for key, variable in data.variables.items()}


class Curves:
    """What one pair does under one motion in one reading, against the gap: lists over the widths below the gap needed."""

    def __init__(self, swept, gap, motion, reading):
        index = (slice(None), MOTIONS.index(motion), READINGS.index(reading))
        self.needed = gap["gap_needed"]
        self.points = [point["gap_needed"] for point in gap["points"]]
        self.sum_of_peaks = gap["abs"]
        widths = [float(width) for width in swept["width"]]
        if widths[-1] < self.needed:
            sys.exit(f"the study ends at {widths[-1]} cm, but {self.needed} cm are needed: widen its range")
        below = [i for i, width in enumerate(widths) if width < self.needed]
        self.widths = [widths[i] for i in below]

        def lists(name):
            values = swept[name][index]
            return [[float(value) for value in values[i]] for i in below]

        self.force, self.duration = lists("peak_force"), lists("contact_duration")
        self.amplification = [lists("amplification_1"), lists("amplification_2")]
        self.displacement = [lists("peak_displacement_1"), lists("peak_displacement_2")]
        self.free = [lists("peak_displacement_no_contact_1")[0], lists("peak_displacement_no_contact_2")[0]]
        self.impacts = lists("impacts")
        self.at_zero = {key: [float(v) for v in swept[key][(0, *index[1:])]] for key in ("peak_force", "contact_duration", "impacts")}

    def relative(self):
        return [width / self.needed for width in self.widths]

    def largest_force(self):
        """(w / needed, force) where the force of any point is largest."""
        forces = [max(row) for row in self.force]
        i = max(range(len(forces)), key=forces.__getitem__)
        return self.widths[i] / self.needed, forces[i]

    def force_near(self, fraction):
        i = min(range(len(self.widths)), key=lambda k: abs(self.widths[k] - fraction * self.needed))
        return max(self.force[i])

    def durations(self):
        return [sum(row) for row in self.duration]

    def quarters(self):
        """Median time in contact within each quarter of the gap needed."""
        parts = [[], [], [], []]
        for x, value in zip(self.relative(), self.durations()):
            parts[min(int(4 * x), 3)].append(value)
        return [statistics.median(part) for part in parts]

    def ratios(self, building, floor=None):
        rows = self.amplification[building]
        return [value for row in rows for k, value in enumerate(row) if floor is None or k == floor]


def curves(runs):
    """(pair, motion, reading) -> Curves."""
    found = {}
    for pair in PAIRS:
        swept = runs.sweep(pair)
        if list(swept["reading"]) != READINGS or list(swept["excitation"]) != MOTIONS:
            sys.exit(f"{pair}.toml: other readings or motions than expected")
        gaps = runs.gaps(pair)
        for reading in READINGS:
            for motion in MOTIONS:
                found[pair, motion, reading] = Curves(swept, gaps[(reading,) * 3, motion], motion, reading)
    return found
