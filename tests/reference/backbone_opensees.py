#!/usr/bin/env python3
"""Writes backbone_opensees.txt: what OpenSees's IMKBilin, IMKPeakOriented and IMKPinching answer along given histories.

    pip install openseespylinux==3.7.1.2; python3 tests/reference/backbone_opensees.py

Its materials take the state at the end of the step before for that where there is no force, and energies by
trapezoids, so that their answers have an error of the square of a step; the steps here are FINE of the yield
deformation. Units kN, m. Histories stop before what OpenSees does otherwise than the rules: docs/theory/elements.md.
"""

import random
from pathlib import Path

import openseespylinux.opensees as ops

STIFFNESS, YIELD = 15e3, 300.0
YIELD_DEFORMATION = YIELD / STIFFNESS
FINE = 2e-4
POINTS = 4  # told of each leg
NONE = 1e9  # of ultimate deformations: none


def side(yield_force=YIELD, cap=1.1, plastic=0.06, softening=0.24, residual=0.2, ultimate=NONE):
    return [yield_force, cap, plastic, softening, residual, ultimate]


def backbone_of(one):
    """In the order of OpenSees: plastic, softening, ultimate, yield, cap, residual."""
    return [one[2], one[3], one[5], one[0], one[1], one[4]]


def material(law, up, down, gammas, exponent, pinching):
    ops.wipe()
    energies = [0.0 if g is None else g * YIELD_DEFORMATION * up[0] / YIELD for g in gammas]
    strength, cap, reloading, unloading = energies
    sides = [*backbone_of(up), *backbone_of(down)]
    if law == "bilinear":
        wear = [strength, cap, unloading, exponent, exponent, exponent, 1.0, 1.0]
        ops.uniaxialMaterial("IMKBilin", 1, STIFFNESS, *sides, *wear)
        return
    wear = [strength, cap, reloading, unloading, exponent, exponent, exponent, exponent, 1.0, 1.0]
    if law == "peak-oriented":
        ops.uniaxialMaterial("IMKPeakOriented", 1, STIFFNESS, *sides, *wear)
    else:
        ops.uniaxialMaterial("IMKPinching", 1, STIFFNESS, *sides, *wear, *pinching)


def answers(turns):
    """(deformation, force) at POINTS of each leg."""
    ops.testUniaxialMaterial(1)
    at, told = 0.0, []
    for turn in turns:
        steps = max(POINTS, int(abs(turn - at) / (FINE * YIELD_DEFORMATION)) // POINTS * POINTS)
        start = at
        for n in range(1, steps + 1):
            at = start + (turn - start) * n / steps
            ops.setStrain(at)
            if n % (steps // POINTS) == 0:
                told.append((at, ops.getStress()))
    return told


def protocol(amplitudes, cycles=2):
    return [sign * a * YIELD_DEFORMATION for a in amplitudes for _ in range(cycles) for sign in (1, -1)]


def wandering(seed, most, legs=24):
    numbers = random.Random(seed)
    turns, at = [], 0.0
    for _ in range(legs):
        kind = numbers.random()
        x = numbers.uniform(-1, 1)
        at = x if kind < 0.15 else max(-most, min(most, at + 0.5 * x)) if kind < 0.35 else most * x
        turns.append(at * YIELD_DEFORMATION)
    return turns


def cases():
    growing = protocol([0.5, 1.5, 2.5, 3.5, 5, 7])
    weak = side(220.0, 1.25, 0.03, 0.15, 0.1)
    for law in ("bilinear", "peak-oriented", "pinching"):
        most = 4.5 if law == "bilinear" else 9.0
        none = [None] * 4
        worn = [30.0, 40.0, None if law == "bilinear" else 50.0, 60.0]
        pinch = [0.4, 0.3]
        yield f"{law} growing", law, side(), side(), none, 1.0, pinch, growing if law != "bilinear" else growing[:16]
        yield f"{law} growing and worn", law, side(), side(), worn, 1.0, pinch, growing[:16]
        yield f"{law} two sides", law, side(), weak, none, 1.0, pinch, protocol([1.2, 2, 3, 4], 1)
        yield f"{law} one way until it has failed", law, side(ultimate=0.4), side(), none, 1.0, pinch, [0.38, 0.41]
        yield f"{law} one way to nothing", law, side(residual=0.0), side(residual=0.0), none, 1.0, pinch, [0.33, 0.2]
        for seed in range(3):
            yield f"{law} wandering {seed}", law, side(), side(), none, 1.0, pinch, wandering(seed, most)
        # 6 and 8 of pinching head for their last turn with more than the initial stiffness.
        for seed in (4, 5, 7):
            yield f"{law} wandering and worn {seed}", law, side(), side(), worn, 1.0, pinch, wandering(seed, 0.7 * most)
        for seed in (9, 11):
            yield (f"{law} wandering, worn, two sides {seed}", law, side(), weak, worn, 1.2, pinch,
                   wandering(seed, 0.4 * most))


def main():
    lines = ["# case: law; yield cap plastic softening residual ultimate of both sides; gamma of strength cap reloading"
             " unloading (0: none), exponent; pinching force and deformation. Then deformation [m] and force [kN]."]
    for name, law, up, down, gammas, exponent, pinching, turns in cases():
        material(law, up, down, gammas, exponent, pinching)
        numbers = [*up, *down, *(g or 0.0 for g in gammas), exponent, *pinching]
        lines.append(f"case {name}: {law} {' '.join(f'{x:g}' for x in numbers)}")
        lines += [f"{u!r} {f:.10g}" for u, f in answers(turns)]
    Path(__file__).with_suffix(".txt").write_text("\n".join(lines) + "\n")


if __name__ == "__main__":
    main()
