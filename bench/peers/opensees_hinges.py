"""opensees_hinges.py CASE.toml ANSWERS.json [STEP...]: what OpenSees takes for frames whose members yield at their ends.

CASE is a case of frames with lumped masses and mass-proportional damping (hinged-frame.toml beside this file), ANSWERS what
`bentur run CASE --json` printed. Members are elasticBeamColumn elements without vertical displacement, a hinge a zeroLength
spring of Steel01 between the end of a member and its joint, a contact one zeroLength element of ElasticPPGap that does not
yield; walls are left out, with the gaps beside them. OpenSees has no rigid hinge: its springs are 100 to 800 times as
stiff as 6EI/L of the member, with the yield moment and, beyond it, the hardening of the hinge. Newmark's constant average
acceleration, Newton's iteration, steps [s] from coarse to fine. Prints a table in Markdown: the processor time of the
solution, and the largest error of any peak displacement, contact force and rotation of a hinge, each over the largest
number of its kind in its building or gap; the last column is the time over that of `bentur run`.
"""

import json
import math
import pathlib
import sys
import tempfile
import time
import tomllib

import openseespylinux.opensees as ops
from opensees_steps import PlaneModel, envelope, error, per_entry

STIFFNESSES = [100, 200, 400, 800]  # of springs, over 6EI/L
STEPS = [1e-2, 3e-3, 1e-3, 3e-4, 1e-4]  # [s]


class Frame:
    """One building: `floors` the nodes that carry its sways; `hinges` as answers name them, with element and stiffness."""

    def __init__(self, model, building, period, stiffness):
        self.model, self.modulus, self.stiffness = model, building["frame"]["elastic_modulus"], stiffness
        frame = building["frame"]
        heights, bays = frame["storey_heights"], frame["bay_widths"]
        assert frame["mass_matrix"] == "lumped"
        columns, beams = per_entry(frame["columns"], len(heights)), per_entry(frame["beams"], len(heights))
        self.hinges, self.floors, sways = {}, [], []
        self.transformation = model.new()
        ops.geomTransf("Linear", self.transformation)
        places = [sum(bays[:line]) for line in range(len(bays) + 1)]
        below, under = [model.node(x, 0.0, (1, 1, 1)) for x in places], None
        base = 0.0
        for floor, height in enumerate(heights):
            top = base + height
            joints = [model.node(x, top, (0, 1, 0)) for x in places]
            mass = frame["floor_masses"][floor] + self.mass(beams[floor], sum(bays))
            half = len(places) * self.mass(columns[floor], height) / 2
            for joint in joints[1:]:
                ops.equalDOF(joints[0], joint, 1)
            for line, x in enumerate(places):
                capacity = per_entry(columns[floor].get("moment_capacity", math.inf), len(places))[line]
                ends = [self.end(below[line], x, base, under, capacity, columns[floor], height,
                                 ("column", floor + 1, line + 1, "bottom")),
                        self.end(joints[line], x, top, joints[0], capacity, columns[floor], height,
                                 ("column", floor + 1, line + 1, "top"))]
                self.member(*ends, columns[floor])
            for bay, span in enumerate(bays):
                capacity = beams[floor].get("moment_capacity", math.inf)
                assert not isinstance(capacity, list) or len(capacity) == 1, "sagging and hogging alike, here"
                capacity = per_entry(capacity, 1)[0]
                ends = [self.end(joints[bay + side], places[bay + side], top, joints[0], capacity, beams[floor], span,
                                 ("beam", floor + 1, bay + 1, ("left", "right")[side])) for side in (0, 1)]
                self.member(*ends, beams[floor])
            if sways:
                sways[-1][1] += half
            sways.append([joints[0], mass + half])
            self.floors.append(joints[0])
            below, under, base = joints, joints[0], top
        for node, mass in sways:
            ops.mass(node, mass, 0.0, 0.0)
        (key, ratio), = building["damping"].items()
        assert key == "mass_proportional"
        ops.region(model.new(), "-nodeOnly", *self.floors, "-rayleigh", 2 * ratio * 2 * math.pi / period, 0.0, 0.0, 0.0)

    @staticmethod
    def mass(member, length):
        if "mass" in member:
            return member["mass"]
        return member["width"] * member["depth"] * member.get("density", 0.0) * length

    @staticmethod
    def inertia(member):
        return member["width"] * member["depth"] ** 3 / 12

    def end(self, joint, x, z, master, capacity, member, length, name):
        """The node at the end of a member: the joint, or one that a spring joins to it. `master` carries the floor's sway;
        None: it does not move."""
        if math.isinf(capacity):
            return joint
        node = self.model.node(x, z, (1, 1, 0) if master is None else (0, 1, 0))
        if master is not None:
            ops.equalDOF(master, node, 1)
        alone = 6 * self.modulus * self.inertia(member) / length
        hardening = member.get("hardening", 0.0)
        beyond, k = hardening / (1 - hardening) * alone, self.stiffness * alone
        tag = self.model.new()
        ops.uniaxialMaterial("Steel01", tag, capacity, k, beyond / (k + beyond))
        ops.element("zeroLength", tag, joint, node, "-mat", tag, "-dir", 6)
        self.hinges[name] = (tag, k)
        return node

    def member(self, first, second, of):
        tag = self.model.new()
        ops.element("elasticBeamColumn", tag, first, second, of["width"] * of["depth"], self.modulus, self.inertia(of),
                    self.transformation)


class Model(PlaneModel):
    def __init__(self, case, answers, folder, stiffness):
        super().__init__()
        self.contacts = []
        periods = [building.get("periods") for building in answers["buildings"]]
        self.frames = [Frame(self, building, period[0], stiffness) if not building.get("rigid") else None
                       for building, period in zip(case["building"], periods)]
        for gap, (left, right) in zip(case["gap"], zip(self.frames, self.frames[1:])):
            count = min(len(left.floors), len(right.floors)) if left and right else 0
            self.contacts.append([self.contact(left.floors[floor], right.floors[floor], gap) for floor in range(count)])
        self.shake(case, folder)


def run(case, answers, folder, stiffness, step):
    """Peaks as answers name them, and the processor time [s]; None: not solved."""
    model = Model(case, answers, folder, stiffness)
    moving = [b for b, frame in enumerate(model.frames) if frame]
    with tempfile.TemporaryDirectory() as name:
        out = pathlib.Path(name)

        def record(kind, elements, what):
            if elements:
                ops.recorder("EnvelopeElement", "-file", str(out / kind), "-precision", 15, "-ele", *elements, what)

        for b in moving:
            ops.recorder("EnvelopeNode", "-file", str(out / f"x{b}"), "-precision", 15, "-node", *model.frames[b].floors,
                         "-dof", 1, "disp")
            springs = [tag for tag, _ in model.frames[b].hinges.values()]
            record(f"d{b}", springs, "deformation")
            record(f"m{b}", springs, "localForce")
        for g, points in enumerate(model.contacts):
            record(f"f{g}", points, "localForce")
        begun = time.process_time()
        status = ops.analyze(round(case["analysis"]["duration"] / step), step)
        taken = time.process_time() - begun
        ops.wipe()  # closes the recorders
        if status != 0:
            return None, taken
        rotations = [{name: d - m / k for name, d, m, (_, k) in
                      zip(model.frames[b].hinges, envelope(out / f"d{b}"), envelope(out / f"m{b}"),
                          model.frames[b].hinges.values())} for b in moving]
        return {"displacement": [envelope(out / f"x{b}") for b in moving],
                "force": [envelope(out / f"f{g}") for g, points in enumerate(model.contacts) if points],
                "rotation": rotations}, taken


def named(hinge):
    """As Frame names it."""
    if hinge["member"] == "column":
        return "column", hinge["storey"], hinge["line"], hinge["end"]
    return "beam", hinge["floor"], hinge["bay"], hinge["end"]


def main():
    path = pathlib.Path(sys.argv[1])
    case, answers = tomllib.loads(path.read_text()), json.loads(pathlib.Path(sys.argv[2]).read_text())
    moving = [b for b, building in enumerate(case["building"]) if not building.get("rigid")]
    ours = answers["solver"]["wall_time"]
    displacement = [answers["buildings"][b]["peak_displacement"] for b in moving]
    force = [[point["peak_force"] for point in gap["points"]] for g, gap in enumerate(answers["gaps"])
             if g in moving and g + 1 in moving]
    hinges = [{named(hinge): hinge["peak_rotation"] for hinge in answers["buildings"][b]["hinges"]} for b in moving]
    print(f"bentur: {1e3 * ours:.3g} ms\n")
    print("| springs | step [s] | time [s] | peak displacement | contact force | rotation | times as long |\n|" + "---|" * 7)
    for stiffness in STIFFNESSES:
        for step in map(float, sys.argv[3:] or STEPS):
            found, taken = run(case, answers, path.parent, stiffness, step)
            if found is None:
                print(f"| {stiffness} | {step:g} | {taken:.3g} | did not converge | | | |", flush=True)
                continue
            theirs = [[found["rotation"][b][name] for name in hinges[b]] for b in range(len(hinges))]
            cells = [f"{error(found['displacement'], displacement):.1e}",
                     f"{error(found['force'], force):.1e}" if force else "–",
                     f"{error(theirs, [list(of.values()) for of in hinges]):.1e}"]
            print(f"| {stiffness} | {step:g} | {taken:.3g} | " + " | ".join(cells) + f" | {taken / ours:,.0f} |", flush=True)


if __name__ == "__main__":
    main()
