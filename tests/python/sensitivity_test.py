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


def test_a_curved_force_has_none():
    case = bentur.example().replace({"gap[0].contact": {"law": "hertz", "stiffness": 1e5}})
    with pytest.raises(bentur.CaseError, match="curved"):
        bentur.run(case).sensitivity  # noqa: B018
