# %% [markdown]
# # A model of OpenSeesPy, solved by both
#
# Mass and stiffness of a model of OpenSeesPy become `building.matrices`. The same two buildings, with the same gap
# elements, are then solved by OpenSees with smaller and smaller steps: it comes to the answer that bentur gives at once.

# %%
import math

import numpy as np

try:
    import openseespy.opensees as ops
except ImportError:
    import openseespylinux.opensees as ops

import bentur

HEIGHTS = [3.2, 3.2, 3.2]  # m
MASSES = {"A": [30.0, 30.0, 25.0], "B": [24.0, 24.0, 20.0]}  # t
STIFFNESSES = {"A": [3.0e4, 2.6e4, 2.0e4], "B": [5.5e4, 5.0e4, 4.0e4]}  # kN/m
GAP, CONTACT = 0.02, 2.0e5  # m, kN/m

# %% [markdown]
# One building in OpenSees: its mass and stiffness by the print of the system, the way most users take.


# %%
def stick(first: int, masses: list[float], stiffnesses: list[float]) -> list[int]:
    """Nodes of a shear building, from the base up."""
    nodes = [first]
    ops.node(first, 0.0)
    ops.fix(first, 1)
    for floor, (mass, stiffness) in enumerate(zip(masses, stiffnesses, strict=True), 1):
        node = first + floor
        ops.node(node, 0.0)
        ops.mass(node, mass)
        ops.uniaxialMaterial("Elastic", node, stiffness)
        ops.element("zeroLength", node, node - 1, node, "-mat", node, "-dir", 1)
        nodes.append(node)
    return nodes


def matrices(masses: list[float], stiffnesses: list[float]) -> tuple[np.ndarray, np.ndarray]:
    ops.wipe()
    ops.model("basic", "-ndm", 1, "-ndf", 1)
    stick(0, masses, stiffnesses)
    ops.constraints("Plain")
    ops.numberer("Plain")
    ops.system("FullGeneral")
    ops.algorithm("Linear")
    ops.analysis("Transient", "-noWarnings")
    found = []
    for m, c, k in ((1.0, 0.0, 0.0), (0.0, 0.0, 1.0)):
        ops.integrator("GimmeMCK", m, c, k)
        ops.analyze(1, 0.0)
        size = ops.systemSize()
        found.append(np.array(ops.printA("-ret")).reshape(size, size))
    return found[0], found[1]


elevations = np.cumsum(HEIGHTS)
buildings = []
for name in ("A", "B"):
    mass, stiffness = matrices(MASSES[name], STIFFNESSES[name])
    given = bentur.Matrices(elevations=elevations, mass=mass, stiffness=stiffness)
    buildings.append(bentur.Building(name=name, damping=0.0, matrices=given))

record = bentur.read_record(bentur.example().folder / "../data/el-centro-1940-ns.csv")
case = bentur.Case(
    units={"length": "m", "force": "kN"},
    building=buildings,
    gap=[{"between": ["A", "B"], "width": GAP, "contact": {"law": "linear", "stiffness": CONTACT}}],
    excitation={"kind": "record", "values": record.values, "time_step": record.time_step, "unit": "g"},
    analysis={"duration": 6.0},
)
result = bentur.run(case)
exact = max(p["peak_force"] for p in result.summary["gaps"][0]["points"])
print(result)

# %% [markdown]
# The same by OpenSees: both sticks in one model, gap materials between their floors, Newmark's method.


# %%
def solved(step: float) -> float:
    """The largest contact force [kN] with this time step [s]."""
    ops.wipe()
    ops.model("basic", "-ndm", 1, "-ndf", 1)
    left = stick(0, MASSES["A"], STIFFNESSES["A"])
    right = stick(100, MASSES["B"], STIFFNESSES["B"])
    gaps = []
    for i, j in zip(left[1:], right[1:], strict=True):
        ops.uniaxialMaterial("ElasticPPGap", 1000 + i, CONTACT, -1e12 * CONTACT, -GAP)
        ops.element("zeroLength", 1000 + i, i, j, "-mat", 1000 + i, "-dir", 1)
        gaps.append(1000 + i)
    values = (9.80665 * record.values).tolist()
    ops.timeSeries("Path", 1, "-dt", record.time_step, "-values", *values)
    ops.pattern("UniformExcitation", 1, 1, "-accel", 1)
    ops.constraints("Plain")
    ops.numberer("RCM")
    ops.system("BandGeneral")
    ops.test("NormDispIncr", 1e-12, 50)
    ops.algorithm("Newton")
    ops.integrator("Newmark", 0.5, 0.25)
    ops.analysis("Transient")
    peak = 0.0
    for _ in range(math.ceil(6.0 / step)):
        assert ops.analyze(1, step) == 0
        peak = max(peak, *(abs(ops.eleForce(gap)[0]) for gap in gaps))
    return peak


errors = []
for step in (2e-3, 5e-4, 1e-4):
    peak = solved(step)
    errors.append(abs(peak / exact - 1))
    print(f"step {1e3 * step:.1f} ms: {peak:.1f} kN, {100 * errors[-1]:.2f} % off; bentur {exact:.1f} kN")
ops.wipe()

# %%
assert errors[-1] < 0.01 and errors[-1] < errors[0]
