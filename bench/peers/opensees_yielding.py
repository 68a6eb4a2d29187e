"""opensees_yielding.py CASE.toml ANSWERS.json [STEP...]: what OpenSees takes for a row of yielding sticks, step by step.

CASE is a case of sticks in SI units (yielding-pair.toml beside this file), ANSWERS what `bentur run CASE --json` printed.
A storey is a zeroLength element of Steel01 (kinematic hardening; ElasticPP without hardening) and one of a dashpot, a
contact one of ElasticPPGap that does not yield. Newmark's constant average acceleration, Newton's iteration, steps [s]
from coarse to fine. Prints a table in Markdown: the largest error of any peak displacement, ductility, peak force, and
of any deformation that remains, each over the largest number of its kind in its building or gap.
"""

import pathlib
import tempfile

import openseespylinux.opensees as ops
from opensees_steps import envelope, per_entry, rayleigh, record, tell, transient


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
            widths = per_entry(gap["width"], count)
            stiffnesses = per_entry(gap["contact"]["stiffness"], count)
            assert gap["contact"]["law"] == "linear"
            self.contacts.append([self.contact(left, floor, widths[floor], stiffnesses[floor])
                                  for floor in range(count)])
        transient("Plain", 1e-11)

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
        alpha, beta = rayleigh(building["damping"])
        assert abs(alpha) < 1e-9, "mass-proportional damping is not modelled here"
        yields, hardening = per_entry(stick["yield_forces"], count), per_entry(stick.get("hardening", 0.0), count)
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


if __name__ == "__main__":
    tell(run, expected, {"displacement": "peak displacement", "ductility": "ductility", "residual": "residual deformation",
                         "force": "peak force"})
