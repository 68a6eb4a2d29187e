"""What opensees_column.py, opensees_hinges.py, opensees_plan.py and opensees_yielding.py share: a case is solved at ever smaller steps, a
table told of it."""

import json
import math
import pathlib
import sys
import tomllib

import openseespylinux.opensees as ops

STEPS = [1e-3, 3e-4, 1e-4, 3e-5, 1e-5]  # [s]


def per_entry(value, count):
    """One entry for each of `count`: a list as it is, one value for all."""
    if isinstance(value, list) and len(value) > 1:
        return value
    return [value[0] if isinstance(value, list) else value] * count


def record(case, folder):
    """Accelerations in the units of the case, and their time step: a file of two columns under a heading."""
    excitation = case["excitation"]
    rows = (folder / excitation["file"]).read_text().split("\n")[1:]
    times, values = zip(*(map(float, row.split(",")) for row in rows if row.strip()))
    units = case.get("units", {})
    metre = {"m": 1.0, "cm": 100.0, "mm": 1000.0}[units.get("length", "m")]
    factor = {"g": units.get("gravity", 9.80665 * metre), "m/s2": metre}[excitation["unit"]] * excitation.get("scale", 1.0)
    if "pga" in excitation:
        factor = excitation["pga"] / max(map(abs, values))
    return times[1] - times[0], [factor * value for value in values]


class PlaneModel:
    """Frames in a plane: nodes that sway, rise and turn, and contacts between them."""

    def __init__(self):
        ops.wipe()
        ops.model("basic", "-ndm", 2, "-ndf", 3)
        self.tag = 0

    def new(self):
        self.tag += 1
        return self.tag

    def node(self, x, z, fixed):
        tag = self.new()
        ops.node(tag, x, z)
        if any(fixed):
            ops.fix(tag, *fixed)
        return tag

    def contact(self, left, right, gap):
        """Between two nodes. What it yields at is far away."""
        tag, stiffness = self.new(), gap["contact"]["stiffness"]
        ops.uniaxialMaterial("ElasticPPGap", tag, stiffness, -1e7 * stiffness, -gap["width"], 0.0, "noDamage")
        ops.element("zeroLength", tag, left, right, "-mat", tag, "-dir", 1)
        return tag

    def shake(self, case, folder):
        step, acceleration = record(case, folder)
        series = self.new()
        ops.timeSeries("Path", series, "-dt", step, "-values", *acceleration)
        ops.pattern("UniformExcitation", series, 1, "-accel", series)
        transient("Transformation", 1e-12)


def rayleigh(damping):
    """α and β of αM + βK."""
    (z1, z2), (t1, t2) = damping["rayleigh"]["ratios"], damping["rayleigh"]["periods"]
    w1, w2 = 2 * math.pi / t1, 2 * math.pi / t2
    beta = 2 * (z2 * w2 - z1 * w1) / (w2 * w2 - w1 * w1)
    return 2 * z1 * w1 - beta * w1 * w1, beta


def transient(constraints, tolerance):
    """Newmark's constant average acceleration with Newton's iteration. `tolerance` [m] of displacements."""
    ops.constraints(constraints)
    ops.numberer("RCM")
    ops.system("BandGeneral")
    ops.test("NormDispIncr", tolerance, 50)
    ops.algorithm("Newton")
    ops.integrator("Newmark", 0.5, 0.25)
    ops.analysis("Transient")


def envelope(path):
    """Largest size of each column: the last line of an envelope recorder's file."""
    return [abs(float(word)) for word in path.read_text().split("\n")[2].split()]


def error(mine, theirs):
    """The largest over the groups, each by its largest number."""
    return max(abs(a - b) / max(map(abs, wanted)) for got, wanted in zip(mine, theirs) for a, b in zip(got, wanted))


def tell(run, expected, kinds):
    """The table, of sys.argv: CASE.toml ANSWERS.json [STEP...].

    run(case, folder, step) and expected(case, answers) give groups of numbers by kind, run None where it failed; `kinds`
    has what the table calls them.
    """
    path = pathlib.Path(sys.argv[1])
    case = tomllib.loads(path.read_text())
    wanted = expected(case, json.loads(pathlib.Path(sys.argv[2]).read_text()))
    print("| step [s] | " + " | ".join(kinds.values()) + " |")
    print("|---" * (1 + len(kinds)) + "|")
    for step in map(float, sys.argv[3:] or STEPS):
        results = run(case, path.parent, step)
        cells = [f"{error(results[kind], wanted[kind]):.1e}" for kind in kinds] if results else \
            ["did not converge", *[""] * (len(kinds) - 1)]
        print(f"| {step:g} | " + " | ".join(cells) + " |", flush=True)
