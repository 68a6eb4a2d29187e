"""opensees_model.py RUNS.csv CASE.json... : what OpenSees takes for the cases of `bentur_compare`, one row a step.

Each case comes twice:
  frames    as its users model it: elasticBeamColumn frames, floors tied, masses at the joints, Newmark's method with
            constant average acceleration, Newton's iteration, contact by a zeroLength element of ElasticPPGap;
  matrices  as fast as OpenSees can be made: the condensed equations as one-dimensional trusses between floors, mass
            terms off the diagonal as consistent truss mass, explicit Newmark, one factorisation for all.
Both in displacements relative to the ground, with the ground motion as forces at the floors, as delays between
buildings ask for. Only `analyze` is timed (processor time). See bench/README.md.
"""

import json
import pathlib
import sys
import time

import openseespylinux.opensees as ops

CAP = 20.0  # a step that would take longer is not tried [s]
WANTED = 1e-3  # relative error of the peak force at which the search ends, two steps in a row
STEPS = [5e-3, 2e-3, 1e-3, 5e-4, 2e-4, 1e-4, 5e-5, 2e-5, 1e-5, 5e-6, 2e-6, 1e-6]  # [s]


def motion(case, building, loads):
    """The ground motion as forces -load * a_g(t - delay) at nodes; loads: (node, mass) pairs. dofs: those of a node."""
    tag = building + 1
    ops.timeSeries("Path", tag, "-dt", case["time_step"], "-values", *case["acceleration"],
                   "-startTime", case["delays"][building])
    ops.pattern("Plain", tag, tag)
    for node, force in loads:
        ops.load(node, *force)


def gap_material(tag, point, length=1.0):
    """An elastic gap that never yields: no force until the right node has come `width` nearer to the left one.

    In strains of an element of that length; a gap of zero is made one of next to nothing, as the material wants one.
    """
    ops.uniaxialMaterial("ElasticPPGap", tag, point["stiffness"] * length, -1e12 * point["stiffness"],
                         -max(point["width"], 1e-15) / length)


def frames(case):
    """Joints (x, y, rotation) with rigid floors; returns contact elements."""
    ops.model("basic", "-ndm", 2, "-ndf", 3)
    ops.geomTransf("Linear", 1)
    node, element, rows, origin = 0, 0, [], 0.0
    for building, frame in enumerate(case["frames"]):
        joints, elevation = [], 0.0
        for floor in range(len(frame["storey_heights"]) + 1):
            x, row = origin, []
            for bay in [0.0, *frame["bay_widths"]]:
                x, node = x + bay, node + 1
                ops.node(node, x, elevation)
                row.append(node)
                ops.fix(node, *((1, 1, 1) if floor == 0 else (0, 1, 0)))  # columns do not shorten
            joints.append(row)
            if floor < len(frame["storey_heights"]):
                elevation += frame["storey_heights"][floor]
        origin = x
        loads = []
        for floor, row in enumerate(joints[1:]):
            mass = frame["masses"][floor] / len(row)
            for joint in row:
                ops.mass(joint, mass, 0.0, 0.0)
                loads.append((joint, (-mass, 0.0, 0.0)))
            for joint in row[1:]:
                ops.equalDOF(row[0], joint, 1)
            column, beam = frame["columns"][floor], frame["beams"][floor]
            for low, high in zip(joints[floor], row):
                element += 1
                ops.element("elasticBeamColumn", element, low, high, column["area"], frame["elastic_modulus"],
                            column["inertia"], 1)
            for one, next_one in zip(row, row[1:]):
                element += 1
                ops.element("elasticBeamColumn", element, one, next_one, beam["area"], frame["elastic_modulus"],
                            beam["inertia"], 1)
        motion(case, building, loads)
        rows.append(joints[1:])
    contacts = []
    for point in case["contacts"]:
        element += 1
        gap_material(element, point)
        ops.element("zeroLength", element, rows[point["left"]][point["left_floor"]][-1],
                    rows[point["left"] + 1][point["right_floor"]][0], "-mat", element, "-dir", 1)
        contacts.append(element)
    ops.rayleigh(case["rayleigh"]["alpha"], 0.0, case["rayleigh"]["beta"], 0.0)
    ops.constraints("Transformation")
    ops.numberer("RCM")
    ops.system("BandGeneral")
    ops.test("NormDispIncr", 1e-8, 10)
    ops.algorithm("Newton")
    ops.integrator("Newmark", 0.5, 0.25)
    ops.analysis("Transient")
    return contacts


def matrices(case):
    """Floors on a line, a truss for every pair of them and for every floor and the ground; returns contact elements."""
    ops.model("basic", "-ndm", 1, "-ndf", 1)
    node, element, floors = 0, 0, []
    for building, of in enumerate(case["matrices"]):
        first, count = node + 1, len(of["load"])
        floors.append(list(range(first, first + count)))
        ground = first + count
        for i in range(count + 1):
            ops.node(first + i, float(first + i))
        node = ground
        ops.fix(ground, 1)
        mass = [of["mass"][i][i] for i in range(count)]
        for i in range(count):
            for j in range(i + 1, count + 1):
                to_ground = j == count
                if to_ground:
                    stiffness, damping, coupling = sum(of["stiffness"][i]), sum(of["damping"][i]), 0.0
                else:
                    stiffness, damping = -of["stiffness"][i][j], -of["damping"][i][j]
                    coupling = of["mass"][i][j]
                    mass[i] -= 2.0 * coupling  # what a consistent truss mass adds on the diagonal
                    mass[j] -= 2.0 * coupling
                element += 1
                length = float(j - i)
                ops.uniaxialMaterial("Elastic", element, stiffness * length, damping * length)
                ops.element("Truss", element, first + i, first + j, 1.0, element, "-rho", 6.0 * coupling / length,
                            "-cMass", 1)
        for i in range(count):
            ops.mass(first + i, mass[i])
        motion(case, building, [(first + i, (-of["load"][i],)) for i in range(count)])
    contacts = []
    for point in case["contacts"]:
        element += 1
        left, right = floors[point["left"]][point["left_floor"]], floors[point["left"] + 1][point["right_floor"]]
        gap_material(element, point, right - left)
        ops.element("Truss", element, left, right, 1.0, element)
        contacts.append(element)
    ops.constraints("Plain")
    ops.numberer("RCM")
    ops.system("ProfileSPD")
    ops.integrator("NewmarkExplicit", 0.5)
    ops.algorithm("Linear", False, False, True)
    ops.analysis("Transient")
    return contacts


def peak_force(contacts, folder):
    """Largest force of any contact element, from its envelope recorder."""
    values = (folder / "opensees-envelope.txt").read_text().split()
    return max(abs(float(value)) for value in values)


def run(case, build, step, folder):
    """Processor time of `analyze` and the peak force; no peak where the step would take too long or diverges."""
    ops.wipe()
    contacts = build(case)
    count = round(case["duration"] / step)
    ops.recorder("EnvelopeElement", "-file", str(folder / "opensees-envelope.txt"), "-precision", 15, "-ele", *contacts, "force")
    began = time.process_time()
    probe = min(count, 200)
    status = ops.analyze(probe, step)
    spent = time.process_time() - began
    if status == 0 and spent * count / probe > CAP:
        ops.wipe()
        return spent * count / probe, None
    if status == 0 and count > probe:
        status = ops.analyze(count - probe, step)
    spent = time.process_time() - began
    ops.wipe()  # closes the recorder
    peak = peak_force(contacts, folder)
    return spent, peak if status == 0 and peak < 1e30 else None


def search(path, name, build, reference, out):
    """Steps from coarse to fine until two in a row are good enough, or the cap is reached."""
    case = json.loads(path.read_text())
    good = 0
    for step in STEPS:
        try:
            seconds, peak = run(case, build, step, path.parent)
        except Exception as error:  # OpenSees says why on standard error
            print(f"{path.stem}: opensees {name} at {step:g} s: {error}", file=sys.stderr)
            continue
        if peak is None:
            print(f"{path.stem}: opensees {name} at {step:g} s: " +
                  (f"about {seconds:.0f} s, not tried" if seconds > CAP else "did not converge"), file=sys.stderr)
            if seconds > CAP:
                break
            continue
        times = sorted([seconds] + [run(case, build, step, path.parent)[0] for _ in range(2 if seconds < 1 else 0)])
        error = abs(peak / case[reference] - 1)
        print(f"{path.stem},opensees {name},{step:.0e} s,{times[0]:.6e},{times[len(times) // 2]:.6e},{len(times)},"
              f"{peak:.15g},{error:.3e},,"
              f"{round(case['duration'] / step)}", file=out, flush=True)
        good = good + 1 if error <= WANTED else 0
        if good == 2:
            break


def main():
    with open(sys.argv[1], "a") as out:
        for path in map(pathlib.Path, sys.argv[2:]):
            print(f"bench: {path.stem}, OpenSees", file=sys.stderr)
            search(path, "frames", frames, "frames_peak_force", out)
            search(path, "matrices", matrices, "matrices_peak_force", out)


main()
