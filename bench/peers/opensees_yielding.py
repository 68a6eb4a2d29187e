"""opensees_yielding.py CASE.toml ANSWERS.json [STEP...]: what OpenSees takes for a row of yielding sticks, step by step.

CASE is a case of sticks in SI units (yielding-pair.toml beside this file), ANSWERS what `bentur run CASE --json` printed.
A storey is a zeroLength element of Steel01 (kinematic hardening; ElasticPP without hardening) and one of a dashpot, a
contact one of ElasticPPGap that does not yield. Newmark's constant average acceleration, Newton's iteration, steps [s]
from coarse to fine. Prints a table in Markdown: the largest error of any peak displacement, ductility, peak force, and
of any deformation that remains, each over the largest number of its kind in its building or gap.
"""

import json
import math
import pathlib
import sys
import tempfile
import tomllib

import openseespylinux.opensees as ops

STEPS = [1e-3, 3e-4, 1e-4, 3e-5, 1e-5]  # [s]


def per_storey(value, count):
    return list(value) if isinstance(value, list) else [value] * count


def record(case, folder):
    """Accelerations [m/s²] and their time step: a file of two columns under a heading."""
    excitation = case["excitation"]
    rows = (folder / excitation["file"]).read_text().split("\n")[1:]
    times, values = zip(*(map(float, row.split(",")) for row in rows if row.strip()))
    factor = {"g": case.get("units", {}).get("gravity", 9.80665), "m/s2": 1.0}[excitation["unit"]]
    return times[1] - times[0], [factor * value for value in values]


def dashpot_per_stiffness(damping):
    """β of Rayleigh damping αM + βK; these cases have no α."""
    (z1, z2), (t1, t2) = damping["rayleigh"]["ratios"], damping["rayleigh"]["periods"]
    w1, w2 = 2 * math.pi / t1, 2 * math.pi / t2
    beta = 2 * (z2 * w2 - z1 * w1) / (w2 * w2 - w1 * w1)
    assert abs(2 * z1 * w1 - beta * w1 * w1) < 1e-9 * w1, "mass-proportional damping is not modelled here"
    return beta


class Model:
    """The case in OpenSees; `storeys[b][j]` holds (element, stiffness, yield force), `floors[b][j]` the node above."""

    def __init__(self, case, folder):
        ops.wipe()
        ops.model("basic", "-ndm", 1, "-ndf", 1)
        self.tag, self.floors, self.storeys, self.contacts = 0, [], [], []
        step, acceleration = record(case, folder)
        for building in case["building"]:
            self.building(building, step, acceleration)
        for left, gap in enumerate(case["gap"]):
            count = min(len(self.floors[left]), len(self.floors[left + 1]))
            widths = per_storey(gap["width"], count)
            stiffnesses = per_storey(gap["contact"]["stiffness"], count)
            assert gap["contact"]["law"] == "linear"
            self.contacts.append([self.contact(left, floor, widths[floor], stiffnesses[floor])
                                  for floor in range(count)])
        ops.constraints("Plain")
        ops.numberer("RCM")
        ops.system("BandGeneral")
        ops.test("NormDispIncr", 1e-11, 50)
        ops.algorithm("Newton")
        ops.integrator("Newmark", 0.5, 0.25)
        ops.analysis("Transient")

    def new(self):
        self.tag += 1
        return self.tag

    def node(self):
        tag = self.new()
        ops.node(tag, 0.0)
        return tag

    def element(self, low, high, *material):
        tag = self.new()
        ops.uniaxialMaterial(material[0], tag, *material[1:])
        ops.element("zeroLength", tag, low, high, "-mat", tag, "-dir", 1)
        return tag

    def building(self, building, step, acceleration):
        stick = building["stick"]
        count = len(stick["masses"])
        below = self.node()
        ops.fix(below, 1)
        beta = dashpot_per_stiffness(building["damping"])
        yields, hardening = per_storey(stick["yield_forces"], count), per_storey(stick.get("hardening", 0.0), count)
        nodes, storeys = [], []
        for j, (mass, k) in enumerate(zip(stick["masses"], stick["stiffnesses"])):
            node = self.node()
            ops.mass(node, mass)
            material = ("Steel01", yields[j], k, hardening[j]) if hardening[j] else ("ElasticPP", k, yields[j] / k)
            storeys.append((self.element(below, node, *material), k, yields[j]))
            self.element(below, node, "Viscous", beta * k, 1.0)
            nodes.append(node)
            below = node
        series = self.new()
        ops.timeSeries("Path", series, "-dt", step, "-values", *acceleration)
        ops.pattern("Plain", series, series)
        for node, mass in zip(nodes, stick["masses"]):
            ops.load(node, -mass)
        self.floors.append(nodes)
        self.storeys.append(storeys)

    def contact(self, left, floor, width, stiffness):
        return self.element(self.floors[left][floor], self.floors[left + 1][floor], "ElasticPPGap", stiffness,
                            -1e7 * stiffness, -width, 0.0, "noDamage")


def envelope(path):
    """Largest size of each column: the last line of an envelope recorder's file."""
    return [abs(float(word)) for word in path.read_text().split("\n")[2].split()]


def run(case, folder, step):
    """Peak displacements and remaining deformations of buildings, ductilities, peak forces of gaps; None: not solved."""
    model = Model(case, folder)
    with tempfile.TemporaryDirectory() as name:
        out = pathlib.Path(name)
        for b, nodes in enumerate(model.floors):
            ops.recorder("EnvelopeNode", "-file", str(out / f"x{b}"), "-precision", 15, "-node", *nodes, "-dof", 1,
                         "disp")
            ops.recorder("EnvelopeElement", "-file", str(out / f"d{b}"), "-precision", 15, "-ele",
                         *[element for element, _, _ in model.storeys[b]], "deformation")
        for g, elements in enumerate(model.contacts):
            ops.recorder("EnvelopeElement", "-file", str(out / f"f{g}"), "-precision", 15, "-ele", *elements,
                         "localForce")
        status = ops.analyze(round(case["analysis"]["duration"] / step), step)
        residuals = []
        for storeys in model.storeys:
            residuals.append([ops.eleResponse(element, "deformation")[0] - ops.eleResponse(element, "localForce")[0] / k
                              for element, k, _ in storeys])
        ops.wipe()  # closes the recorders
        if status != 0:
            return None
        count = range(len(model.floors))
        return {
            "displacement": [envelope(out / f"x{b}") for b in count],
            "ductility": [[d * k / limit for d, (_, k, limit) in zip(envelope(out / f"d{b}"), model.storeys[b])]
                          for b in count],
            "residual": residuals,
            "force": [envelope(out / f"f{g}") for g in range(len(model.contacts))],
        }


def expected(case, answers):
    """The same numbers as `bentur run --json` gives them."""
    buildings, heights = answers["buildings"], [b["stick"]["storey_heights"] for b in case["building"]]
    return {
        "displacement": [b["peak_displacement"] for b in buildings],
        "ductility": [b["ductility"] for b in buildings],
        "residual": [[ratio * h for ratio, h in zip(b["residual_drift_ratio"], list_of)]
                     for b, list_of in zip(buildings, heights)],
        "force": [[point["peak_force"] for point in gap["points"]] for gap in answers["gaps"]],
    }


def error(mine, theirs):
    return max(abs(a - b) / max(map(abs, wanted)) for got, wanted in zip(mine, theirs) for a, b in zip(got, wanted))


def main():
    path = pathlib.Path(sys.argv[1])
    case = tomllib.loads(path.read_text())
    wanted = expected(case, json.loads(pathlib.Path(sys.argv[2]).read_text()))
    print("| step [s] | peak displacement | ductility | residual deformation | peak force |")
    print("|---|---|---|---|---|")
    for step in map(float, sys.argv[3:] or STEPS):
        results = run(case, path.parent, step)
        if results is None:
            print(f"| {step:g} | did not converge | | | |", flush=True)
            continue
        errors = [error(results[kind], wanted[kind]) for kind in ("displacement", "ductility", "residual", "force")]
        print(f"| {step:g} | " + " | ".join(f"{e:.1e}" for e in errors) + " |", flush=True)


main()
