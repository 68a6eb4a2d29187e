"""opensees_column.py CASE.toml ANSWERS.json [STEP...]: what OpenSees takes for frames whose floors strike columns.

CASE is a case of frames with lumped masses in SI units (struck-column.toml beside this file), ANSWERS what `bentur run
CASE --json` printed. Members are elasticBeamColumn elements without vertical displacement, a floor is one node's sway
that the other joints take over, a struck column two elements with a node between, a contact one zeroLength element of
ElasticPPGap that does not yield. Newmark's constant average acceleration, Newton's iteration, steps [s] from coarse to
fine. Prints a table in Markdown: the largest error of any peak displacement, contact force, and shear and moment of a
struck column, each over the largest number of its kind in its building or gap.
"""

import pathlib
import tempfile

import openseespylinux.opensees as ops
from opensees_steps import PlaneModel, envelope, per_entry, rayleigh, tell

ROUND_OFF = 1e-9


def section(member):
    """Area, second moment of area, mass per length."""
    width, depth = member["width"], member["depth"]
    return width * depth, width * depth ** 3 / 12, width * depth * member["density"]


class Frame:
    """One building: `floors` the nodes that carry its sways, `nodes` by elevation those in struck columns, `pieces` by
    elevation the two elements that meet there."""

    def __init__(self, model, building, struck, struck_left):
        frame = building["frame"]
        heights, bays = frame["storey_heights"], frame["bay_widths"]
        assert frame["mass_matrix"] == "lumped"
        columns, beams = per_entry(frame["columns"], len(heights)), per_entry(frame["beams"], len(heights))
        self.floors, self.nodes, self.pieces, self.elements, self.masses = [], {}, {}, [], []
        transformation, modulus = model.new(), frame["elastic_modulus"]
        ops.geomTransf("Linear", transformation)

        def member(low, high, of):
            area, inertia, _ = section(of)
            tag = model.new()
            ops.element("elasticBeamColumn", tag, low, high, area, modulus, inertia, transformation)
            self.elements.append(tag)
            return tag

        facing = 0 if struck_left else len(bays)  # the line next to the gap, at x = 0
        places = [sum(bays[:line]) - sum(bays[:facing]) for line in range(len(bays) + 1)]
        below = [model.node(x, 0.0, (1, 1, 1)) for x in places]
        base, sways = 0.0, []
        for floor, height in enumerate(heights):
            top = base + height
            joints = [model.node(x, top, (0, 1, 0)) for x in places]
            mass = frame["floor_masses"][floor] + sum(bays) * section(beams[floor])[2]
            per_length = section(columns[floor])[2]
            upper = 0.0  # halves of the columns below this floor
            for line, x in enumerate(places):
                inside = [z for z in struck if line == facing and base + ROUND_OFF < z < top - ROUND_OFF]
                assert len(inside) <= 1
                if inside:
                    z = inside[0]
                    node = model.node(x, z, (0, 1, 0))
                    self.nodes[z] = node
                    self.pieces[z] = (member(below[line], node, columns[floor]), member(node, joints[line], columns[floor]))
                    ops.mass(node, per_length * height / 2, 0.0, 0.0)
                    self.masses.append(node)
                    upper += per_length * (top - z) / 2
                    if sways:
                        sways[-1][1] += per_length * (z - base) / 2
                else:
                    member(below[line], joints[line], columns[floor])
                    upper += per_length * height / 2
                    if sways:
                        sways[-1][1] += per_length * height / 2
            for left, right in zip(joints, joints[1:]):
                member(left, right, beams[floor])
            for line, other in enumerate(joints):
                if line != facing:
                    ops.equalDOF(joints[facing], other, 1)
            self.floors.append(joints[facing])
            sways.append([joints[facing], mass + upper])
            below, base = joints, top
        for node, mass in sways:
            ops.mass(node, mass, 0.0, 0.0)
            self.masses.append(node)
        self.elevations = [sum(heights[:n + 1]) for n in range(len(heights))]
        alpha, beta = rayleigh(building["damping"])
        ops.region(model.new(), "-eleOnly", *self.elements, "-rayleigh", 0.0, beta, 0.0, 0.0)
        ops.region(model.new(), "-nodeOnly", *self.masses, "-rayleigh", alpha, 0.0, 0.0, 0.0)

    def node_at(self, elevation):
        for z, node in [*zip(self.elevations, self.floors), *self.nodes.items()]:
            if abs(z - elevation) < 1e-6:
                return node
        raise KeyError(elevation)


class Model(PlaneModel):
    def __init__(self, case, folder):
        super().__init__()
        gap = case["gap"][0]
        elevations = gap["elevations"]
        assert len(case["building"]) == 2 and gap["contact"]["law"] == "linear"
        self.frames = []
        for b, building in enumerate(case["building"]):
            own = [sum(building["frame"]["storey_heights"][:n + 1]) for n in range(len(building["frame"]["storey_heights"]))]
            struck = [z for z in elevations if all(abs(z - floor) > 1e-6 for floor in own)]
            self.frames.append(Frame(self, building, struck, b == 1))
        self.contacts = [self.contact(self.frames[0].node_at(z), self.frames[1].node_at(z), gap) for z in elevations]
        self.shake(case, folder)


def run(case, folder, step):
    """Peaks as bentur tells them; None: not solved."""
    model = Model(case, folder)
    with tempfile.TemporaryDirectory() as name:
        out = pathlib.Path(name)
        for b, frame in enumerate(model.frames):
            ops.recorder("EnvelopeNode", "-file", str(out / f"x{b}"), "-precision", 15, "-node", *frame.floors, "-dof", 1,
                         "disp")
            for z, pieces in frame.pieces.items():
                ops.recorder("EnvelopeElement", "-file", str(out / f"c{z}"), "-precision", 15, "-ele", *pieces, "localForce")
        ops.recorder("EnvelopeElement", "-file", str(out / "f"), "-precision", 15, "-ele", *model.contacts, "localForce")
        status = ops.analyze(round(case["analysis"]["duration"] / step), step)
        ops.wipe()  # closes the recorders
        if status != 0:
            return None
        results = {"displacement": [envelope(out / f"x{b}") for b in range(2)], "force": [envelope(out / "f")]}
        shears, moments = [], []
        for frame in model.frames:
            for z in sorted(frame.pieces):
                below, above = envelope(out / f"c{z}")[:6], envelope(out / f"c{z}")[6:]  # N V M at either end
                shears.append([below[1], above[1]])
                moments.append([below[2], max(below[5], above[2]), above[5]])
        return results | {"shear": shears, "moment": moments}


def expected(case, answers):
    """The same numbers as `bentur run --json` gives them."""
    points = answers["gaps"][0]["points"]
    columns = [point["column"] for building in case["building"] for point in points
               if point.get("struck") == building["name"]]
    return {
        "displacement": [b["peak_displacement"] for b in answers["buildings"]],
        "force": [[point["peak_force"] for point in points]],
        "shear": [[c["peak_shear_below"], c["peak_shear_above"]] for c in columns],
        "moment": [[c["peak_moment_bottom"], c["peak_moment_node"], c["peak_moment_top"]] for c in columns],
    }


if __name__ == "__main__":
    tell(run, expected, {"displacement": "peak displacement", "force": "peak contact force", "shear": "column shear",
                         "moment": "column moment"})
