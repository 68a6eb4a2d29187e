"""Derivatives of a run in Python: those of the command line, and those of runs with a little more."""

import json
import os
import subprocess

import numpy as np
import pytest

import bentur


def test_the_command_line_gives_the_same(tmp_path):
    case = bentur.example()
    file = case.save(tmp_path / "case.toml")
    printed = subprocess.run(
        [os.environ["BENTUR_PROGRAM"], "sensitivity", str(file), "--json"], capture_output=True, text=True, check=True
    )
    found, told = bentur.run(case).sensitivity, json.loads(printed.stdout)
    assert found["peaks"] == told["peaks"]
    assert found["numbers"] == told["numbers"]


def test_the_table_has_what_a_little_more_changes():
    pytest.importorskip("pandas")
    case = bentur.example()
    result = bentur.run(case)
    table = result.gradient
    for path, value in (("gap[0].width", 0.2), ("building[0].frame.elastic_modulus", 2.1e5), ("excitation.pga", 341.7)):
        step = 1e-6 * value
        above, below = (bentur.run(case.replace({path: value + h}), histories=False) for h in (step, -step))
        for name in ("peak_force", "gap_needed"):

            def points(run, name=name):
                return np.array([point[name] for point in run.summary["gaps"][0]["points"]])

            known = points(result) > 0
            different = (points(above) - points(below))[known] / (2 * step)
            # Of differences: 1e-6 of what the peak itself is for the number, times what blows multiply.
            scale = np.max(points(result)) / value
            np.testing.assert_allclose(table.loc[path, name].to_numpy(), different, atol=1e-4 * scale)


def of_points(run):
    """Gap needed and peak force of every contact point, by gap and by rank from below: elevations may be what changes."""
    gaps = [sorted(gap["points"], key=lambda point: point["elevation"]) for gap in run.summary["gaps"]]
    return {
        (quantity, gap, rank): point[quantity]
        for gap, points in enumerate(gaps)
        for rank, point in enumerate(points)
        for quantity in ("gap_needed", "peak_force")
    }


@pytest.mark.filterwarnings("ignore::bentur.RemarkWarning")
@pytest.mark.parametrize("name", ["m12-harmonic", "generic-neighbour", "row-of-three", "free-impact"])
def test_every_number_of_an_example(name):
    """Frames, soil, gravity, a row of three, no ground motion; by runs with a little more and a little less."""
    case = bentur.example(name)
    run = bentur.run(case, histories=False)
    found, values = run.sensitivity, of_points(run)
    gaps = list(dict.fromkeys(peak["gap"] for peak in found["peaks"] if "gap" in peak))
    levels = [sorted(point["elevation"] for point in gap["points"]) for gap in run.summary["gaps"]]
    compared = 0
    for i, number in enumerate(found["numbers"]):
        step = 1e-6 * abs(number["value"])
        above, below = (
            of_points(bentur.run(case.replace({number["path"]: number["value"] + h}), histories=False)) for h in (step, -step)
        )
        for peak in found["peaks"]:
            if "gap" not in peak:
                continue
            gap = gaps.index(peak["gap"])
            place = (peak["quantity"], gap, levels[gap].index(peak["level"]))
            different = (above[place] - below[place]) / (2 * step) * number["value"] / values[place]
            scale = max(abs(e) for e in peak["elasticity"])
            # Of differences: rounding 1e-10, and 1e-12 times what blows multiply.
            assert different == pytest.approx(peak["elasticity"][i], abs=1e-6 * scale), (number["path"], place)
            compared += 1
    assert compared >= 2 * len(found["numbers"])


def test_a_number_with_its_unit_is_one():
    found = bentur.run(bentur.example().replace({"excitation.pga": "0.35 g"})).sensitivity
    at = [number["path"] for number in found["numbers"]].index("excitation.pga")
    assert found["numbers"][at]["value"] == 0.35
    for peak in found["peaks"]:
        if peak["quantity"] == "gap_needed":
            assert peak["elasticity"][at] == pytest.approx(1, abs=1e-9)
            assert peak["gradient"][at] == pytest.approx(peak["value"] / 0.35, rel=1e-9)


def test_a_curved_force_has_none():
    case = bentur.example().replace({"gap[0].contact": {"law": "hertz", "stiffness": 1e5}})
    with pytest.raises(bentur.CaseError, match="curved"):
        bentur.run(case).sensitivity  # noqa: B018
