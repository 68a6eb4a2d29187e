"""verification.py [FILE]: the checks of docs/verification.md, each a number that should be zero and what it may be at most;
with a file the table in it is written anew. The package bentur is taken from PYTHONPATH.

Each check is a function that gives a relative error; its first line says what is compared, the rest of its text against
what. Closed forms stand here, not stored results.
"""

import math
import pathlib
import re
import sys

import numpy as np

import bentur

CHECKS = []
M, K = 1e5, 4e6  # kg, N/m


def check(limit):
    def add(function):
        CHECKS.append((function, limit))
        return function

    return add


def stick(name, mass=M, stiffness=K, damping=0.0):
    return bentur.Building(
        name=name, damping=damping, stick=bentur.Stick(storey_heights=[3.0], masses=[mass], stiffnesses=[stiffness])
    )


def thrown(contact, speeds=(0.5, -0.5), masses=(M, M), width=0.0, duration=0.2, soft=1.0, **more):
    """Two one-storey buildings thrown at each other; with a stiffness of `soft` times K."""
    return bentur.Case(
        building=[stick("left", masses[0], soft * K), stick("right", masses[1], soft * K)],
        gap=[bentur.Gap(between=["left", "right"], width=width, contact=contact)],
        excitation=bentur.Excitation(kind="none"),
        initial=bentur.Initial(velocities={"left": [speeds[0]], "right": [speeds[1]]}),
        analysis=bentur.Analysis(duration=duration, **more),
    )


def relative(found, expected):
    return abs(found / expected - 1)


@check(1e-12)
def free_vibration():
    """Free vibration of an undamped oscillator | x = (v/ω) sin ωt, at 2,001 instants"""
    case = thrown({"law": "linear", "stiffness": 1e8}, speeds=(0.1, 0.1), width=1.0, duration=20.0)
    found = bentur.run(case).histories
    omega = math.sqrt(K / M)
    expected = 0.1 / omega * np.sin(omega * found["time"])
    return np.abs(found["displacement"][0][:, 0] - expected).max() / (0.1 / omega)


@check(1e-12)
def damped_vibration():
    """Free vibration with 5 % damping | x = (v/ω_d) e^{−ζωt} sin ω_d t"""
    tables = thrown({"law": "linear", "stiffness": 1e8}, speeds=(0.1, 0.1), width=1.0, duration=10.0).to_dict()
    tables["building"][0]["damping"] = 0.05
    found = bentur.run(bentur.Case.from_dict(tables)).histories
    omega, zeta = math.sqrt(K / M), 0.05
    damped = omega * math.sqrt(1 - zeta**2)
    expected = 0.1 / damped * np.exp(-zeta * omega * found["time"]) * np.sin(damped * found["time"])
    return np.abs(found["displacement"][0][:, 0] - expected).max() / (0.1 / omega)


@check(1e-10)
def instant_of_contact():
    """Instant at which two swinging buildings touch | asin(ωw/2v)/ω"""
    found = bentur.run(thrown({"law": "linear", "stiffness": 1e8}, width=0.02)).impact_arrays
    omega = math.sqrt(K / M)
    return relative(found["start"][0], math.asin(omega * 0.02 / (2 * 0.5)) / omega)


@check(1e-10)
def peak_of_contact():
    """Peak force of that impact, springs of the buildings included | k(√(b² + (c/ω_c)²) − b)"""
    found = bentur.run(thrown({"law": "linear", "stiffness": 1e8}, width=0.02)).impact_arrays
    omega = math.sqrt(K / M)
    closing = 2 * 0.5 * math.cos(math.asin(omega * 0.02 / (2 * 0.5)))
    contact = math.sqrt(omega**2 + 2 * 1e8 / M)
    offset = omega**2 * 0.02 / contact**2
    return relative(found["peak_force"][0], 1e8 * (math.hypot(offset, closing / contact) - offset))


@check(1e-6)
def duration_of_impact():
    """Duration of a free elastic impact of unlike masses | π√(m_e/k)"""
    found = bentur.run(thrown({"law": "linear", "stiffness": 1e8}, masses=(M, 3 * M), soft=1e-7)).impact_arrays
    return relative(found["duration"][0], math.pi * math.sqrt(0.75 * M / 1e8))


@check(1e-6)
def hertz():
    """Largest penetration of Hertz's contact | (5 m_e v²/4β)^{2/5}"""
    found = bentur.run(thrown({"law": "hertz", "stiffness": 2e9}, soft=1e-7)).impact_arrays
    return relative(found["peak_penetration"][0], (1.25 * (M / 2) * 1.0**2 / 2e9) ** 0.4)


def restitution_of(contact):
    found = bentur.run(thrown(contact, soft=1e-9, duration=1.0)).impact_arrays
    return relative(found["restitution"][0], contact["restitution"])


for _law, _stiffness in [("kelvin-voigt", 1e8), ("kelvin-voigt-approach", 1e8), ("hertz-damp", 2e9), ("jankowski", 2e9),
                         ("restitution", None)]:
    def _one(law=_law, stiffness=_stiffness):
        contact = {"law": law, "restitution": 0.65} | ({"stiffness": stiffness} if stiffness else {})
        return restitution_of(contact)

    _one.__doc__ = f"Restitution obtained by `{_law}` in a free impact | 0.65 asked for"
    check(1e-6)(_one)


@check(1e-12)
def momentum():
    """Momentum of two floors that collide in no time, masses 1 and 3 | m₁v₁ + m₂v₂ kept"""
    case = thrown({"law": "restitution", "restitution": 0.5}, speeds=(0.8, -0.1), masses=(M, 3 * M), soft=1e-9,
                  duration=0.02, output_step=0.01)
    after = [v[-1, 0] for v in bentur.run(case).histories["velocity"]]
    return relative(after[0] + 3 * after[1], 0.8 - 3 * 0.1)


@check(1e-12)
def energy():
    """Energy that is not accounted for, five and four storeys under El Centro | 0 of what went in"""
    solver = bentur.run(bentur.example("kelvin-voigt-pair"), histories=False).summary["solver"]
    return solver["energy_residual"]


@check(1e-9)
def yielding_energy():
    """The same of a pair whose storeys yield | 0 of what went in"""
    solver = bentur.run(bentur.example("yielding-pair"), histories=False).summary["solver"]
    return solver["energy_residual"]


@check(1e-7)
def other_solver():
    """Largest difference of a peak force between `exact` and `adaptive`, first impact of six examples | the same"""
    worst = 0.0
    for name in ("m12-el-centro", "m12-harmonic", "kelvin-voigt-pair", "two-frames-si", "linked-pair", "row-of-three"):
        case = bentur.example(name)
        exact = bentur.run(case, histories=False).impact_arrays["peak_force"][0]
        other = bentur.run(case.replace({"analysis.solver": "adaptive", "analysis.tolerance": 1e-12}), histories=False)
        worst = max(worst, relative(other.impact_arrays["peak_force"][0], exact))
    return worst


@check(1e-12)
def resonance():
    """Peak of an undamped oscillator in resonance, ten cycles of harmonic motion | (A/2)(ωt cos ωt − sin ωt)"""
    period = 2 * math.pi / math.sqrt(K / M)
    case = bentur.Case(
        building=[stick("left"), stick("right", stiffness=9 * K)],
        gap=[bentur.Gap(between=["left", "right"], width=100.0, contact={"law": "linear", "stiffness": 1e8})],
        excitation=bentur.Excitation(kind="harmonic", period=period, displacement_amplitude=0.01),
        analysis=bentur.Analysis(duration=10 * period),
    )
    found = bentur.run(case).histories
    omega, t = math.sqrt(K / M), found["time"]
    expected = 0.01 / 2 * (np.sin(omega * t) - omega * t * np.cos(omega * t))
    return np.abs(found["displacement"][0][:, 0] - expected).max() / np.abs(expected).max()


@check(6.4e-4)  # a kink of the motion makes it overshoot by Δȧ/ω, Δȧ ≤ 4 a_max/Δt: 4 T/(2π Δt), Δt = 0.02 s
def short_period():
    """Spectral acceleration of El Centro at 0.02 ms | its peak ground acceleration"""
    record = bentur.read_record(bentur.example().folder / "../data/el-centro-1940-ns.csv")
    found = bentur.response_spectrum(record, [2e-5], unit="g", damping=0.05)
    return relative(found.absolute_acceleration[0], record.peak * 9.80665)


@check(1e-12)
def frame_period():
    """First period of a stick of ten equal storeys | 2π/(2√(k/m) sin(π/42))"""
    tables = bentur.example("two-frames-si").to_dict()
    tall = bentur.Stick(storey_heights=[3.0] * 10, masses=[30.0] * 10, stiffnesses=[4e4] * 10)
    tables["building"] = [bentur.Building(name=n, damping=0.05, stick=tall) for n in ("A", "B")]
    tables["gap"] = [{"between": ["A", "B"], "width": 1.0, "contact": {"law": "linear", "stiffness": 1e5}}]
    case = bentur.Case.from_dict(tables, folder=bentur.example("two-frames-si").folder)
    return relative(bentur.modes(case)["A"]["periods"][0], math.pi / (math.sqrt(4e4 / 30.0) * math.sin(math.pi / 42)))


def rows():
    for function, limit in CHECKS:
        what, against = function.__doc__.split(" | ")
        yield what, against, float(function()), limit


def table(found):
    lines = ["| what | against | error | at most |", "|---|---|---:|---:|"]
    lines += [f"| {what} | {against} | {error:.0e} | {limit:.0e} |" for what, against, error, limit in found]
    return "\n".join(lines)


def main(file=None):
    found = list(rows())
    print(table(found))
    if file:
        path = pathlib.Path(file)
        text = path.read_text()
        new = f"<!-- checks -->\n{table(found)}\n<!-- /checks -->"
        path.write_text(re.sub(r"<!-- checks -->.*<!-- /checks -->", lambda _: new, text, flags=re.DOTALL))
    failed = [what for what, _, error, limit in found if not error <= limit]
    if failed:
        sys.exit("over what it may be: " + "; ".join(failed))


if __name__ == "__main__":
    main(*sys.argv[1:])
