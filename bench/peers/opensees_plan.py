"""opensees_plan.py CASE.toml ANSWERS.json [STEP...]: what OpenSees takes for two buildings in plan that strike and rub.

CASE is a case in plan of planes along x and y, with masses, mass-proportional damping and one gap along x
(plan-pair.toml and plan-pair-rubbing.toml beside this file), ANSWERS what `bentur run CASE --json` printed. The plan is a
plane model: a floor is a node at its centre of mass with u_x, u_y and the rotation, a storey of a plane a zeroLength
spring between nodes that rigidLink ties to the floors below and above, an end of the stretch of a gap a zeroLength
element of ElasticPPGap that does not yield, or where it rubs a zeroLengthContactASDimplex. Newmark's constant average
acceleration, Newton's iteration, steps [s] from coarse to fine. Prints a table in Markdown: the processor time of the
solution, and the largest error of any peak displacement, rotation and contact force, each over the largest of its kind in
its building or gap; the last column is the time over that of `bentur run`.
"""

import json
import math
import pathlib
import sys
import tempfile
import time
import tomllib

import openseespylinux.opensees as ops
from opensees_steps import PlaneModel, envelope, error, per_entry, record, transient

STEPS = [3e-3, 1e-3, 3e-4, 1e-4, 3e-5]  # [s]


class Building:
    """`floors` are the nodes at the centres of mass."""

    def __init__(self, model, building, period):
        self.model, plan = model, building["plan"]
        self.corner, (length, width) = plan["corner"], plan["size"]
        middle = plan.get("centres_of_mass", [length / 2, width / 2])
        self.centre = [self.corner[0] + middle[0], self.corner[1] + middle[1]]
        below, self.floors = model.node(*self.centre, (1, 1, 1)), []
        for storey, mass in enumerate(plan["masses"]):
            floor = model.node(*self.centre, (0, 0, 0))
            ops.mass(floor, mass, mass, mass * (length ** 2 + width ** 2) / 12)
            for plane in building["plane"]:
                x, y = self.corner[0] + length / 2, self.corner[1] + plane["at"]
                if plane["along"] == "y":
                    x, y = self.corner[0] + plane["at"], self.corner[1] + width / 2
                tag = model.new()
                ops.uniaxialMaterial("Elastic", tag, per_entry(plane["stiffnesses"], len(plan["masses"]))[storey])
                ops.element("zeroLength", tag, self.tied(below, x, y), self.tied(floor, x, y), "-mat", tag, "-dir",
                            {"x": 1, "y": 2}[plane["along"]])
            self.floors.append(floor)
            below = floor
        (key, ratio), = building["damping"].items()
        assert key == "mass_proportional"
        ops.region(model.new(), "-nodeOnly", *self.floors, "-rayleigh", 2 * ratio * 2 * math.pi / period, 0.0, 0.0, 0.0)

    def tied(self, floor, x, y):
        """A node there that moves as the floor does."""
        node = self.model.node(x, y, (0, 0, 0))
        ops.rigidLink("beam", floor, node)
        return node


class Model(PlaneModel):
    """`contacts` has the elements of each level, along the stretch."""

    def __init__(self, case, answers, folder):
        super().__init__()
        left, right = self.buildings = [Building(self, building, told["periods"][0])
                                        for building, told in zip(case["building"], answers["buildings"])]
        (told,), (gap,) = answers["gaps"], case["gap"]
        assert told["normal"] == "x" and gap["contact"]["law"] == "linear"
        edges = [left.corner[0] + case["building"][0]["plan"]["size"][0], right.corner[0]]
        stiffness, friction = gap["contact"]["stiffness"] / 2, gap["contact"].get("friction", 0.0)
        self.contacts = []
        for low, high in zip(left.floors, right.floors):
            for y in told["stretch"]:
                ends = [side.tied(floor, x, y) for side, floor, x in zip((left, right), (low, high), edges)]
                self.contacts.append(self.rub(*ends, stiffness, friction) if friction else
                                     self.contact(*ends, {"contact": {"stiffness": stiffness}, "width": told["width"]}))
        for component, excitation in enumerate([case["excitation"], case["excitation"]["y"]], 1):
            step, acceleration = record({**case, "excitation": excitation}, folder)
            series = self.new()
            ops.timeSeries("Path", series, "-dt", step, "-values", *acceleration)
            ops.pattern("UniformExcitation", series, component, "-accel", series)
        transient("Transformation", 1e-12)

    def rub(self, left, right, stiffness, friction):
        tag = self.new()
        ops.element("zeroLengthContactASDimplex", tag, left, right, stiffness, stiffness * 8 / 9, friction, "-orient", 1, 0,
                    0, "-intType", 0)
        return tag


def run(case, answers, folder, step):
    """Peaks as answers name them, and the processor time [s]; None: not solved."""
    model = Model(case, answers, folder)
    with tempfile.TemporaryDirectory() as name:
        out = pathlib.Path(name)
        for b, building in enumerate(model.buildings):
            for dof in (1, 2, 3):
                ops.recorder("EnvelopeNode", "-file", str(out / f"x{b}{dof}"), "-precision", 15, "-node", *building.floors,
                             "-dof", dof, "disp")
        ops.recorder("EnvelopeElement", "-file", str(out / "f"), "-precision", 15, "-ele", *model.contacts, "localForce")
        begun = time.process_time()
        status = ops.analyze(round(case["analysis"]["duration"] / step), step)
        taken = time.process_time() - begun
        ops.wipe()  # closes the recorders
        if status != 0:
            return None, taken
        x, y, rotation = ([envelope(out / f"x{b}{dof}") for b in range(2)] for dof in (1, 2, 3))
        force = envelope(out / "f")  # of what rubs two components each
        both = [force[::2], force[1::2]] if len(force) > len(model.contacts) else [force]
        return {"displacement": x + y, "rotation": rotation, "force": both}, taken


def main():
    path = pathlib.Path(sys.argv[1])
    case, answers = tomllib.loads(path.read_text()), json.loads(pathlib.Path(sys.argv[2]).read_text())
    ours, buildings, points = answers["solver"]["wall_time"], answers["buildings"], answers["gaps"][0]["points"]
    of_points = [[point[key] for point in points] for key in ("peak_force", "peak_tangential_force") if key in points[0]]
    expected = {"displacement": [of[f"peak_displacement_{way}"] for way in "xy" for of in buildings],
                "rotation": [of["peak_rotation"] for of in buildings], "force": of_points}
    print(f"bentur: {1e3 * ours:.3g} ms, {sum(point['impacts'] for point in points)} impacts\n")
    print("| step [s] | time [s] | peak displacement | rotation | contact force | times as long |\n|" + "---|" * 6)
    for step in map(float, sys.argv[3:] or STEPS):
        found, taken = run(case, answers, path.parent, step)
        if found is None:
            print(f"| {step:g} | {taken:.3g} | did not converge | | | |", flush=True)
            continue
        cells = [f"{error(found[kind], expected[kind]):.1e}" for kind in ("displacement", "rotation", "force")]
        print(f"| {step:g} | {taken:.3g} | " + " | ".join(cells) + f" | {taken / ours:,.0f} |", flush=True)


if __name__ == "__main__":
    main()
