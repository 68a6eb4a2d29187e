"""Arrays have the numbers of the command line under NumPy 1 and NumPy 2.

They are made by the Python that BENTUR_NUMPY_PYTHON names, whose NumPy ./dev test --all has put into build/numpy, else by this one.
"""

import csv
import json
import os
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

import bentur
from bentur import _core, _numpy

PYTHON = os.environ.get("BENTUR_NUMPY_PYTHON") or sys.executable
CASES = ["m12-el-centro", "row-of-three"]  # one of two buildings, one of three


def test_the_build_knows_numpy_2_where_dev_has_seen_to_it(root):
    if (root / "build" / "pybind11").exists():
        assert _core.pybind11 >= (2, 12)


def test_the_other_numpy_is_another():
    told = subprocess.run([PYTHON, "-c", "import numpy; print(numpy.__version__)"], check=True, capture_output=True, text=True)
    is_same = told.stdout.split(".")[0] == np.__version__.split(".")[0]
    assert is_same == ("BENTUR_NUMPY_PYTHON" not in os.environ)


@pytest.mark.parametrize("pybind11", [(2, 10), (2, 11)])
@pytest.mark.parametrize("numpy", ["2.0.0", "2.4.6", "2.1.0rc1", "3.0", "10.0.1"])
def test_what_would_read_wrong_numbers_is_refused(pybind11, numpy):
    with pytest.raises(ImportError) as caught:
        _numpy.check(pybind11, numpy)
    assert str(caught.value) == (
        f"this bentur was built with pybind11 2.{pybind11[1]}, which reads arrays of NumPy {numpy} wrongly: build it with "
        "pybind11 2.12 or newer, as `pip install .` does, or `pip install 'numpy<2'`"
    )


@pytest.mark.parametrize("pybind11, numpy", [((2, 10), "1.24.2"), ((2, 11), "1.26.4"), ((2, 12), "2.0.0"), ((2, 12), "1.26.4"),
                                             ((2, 13), "2.4.6"), ((3, 0), "2.4.6")])
def test_what_reads_right_numbers_is_not(pybind11, numpy):
    _numpy.check(pybind11, numpy)


def test_the_package_asks_when_it_is_imported(tmp_path):
    """Of this very module, said to be an older build's beside NumPy 2."""
    code = "\n".join([
        "import numpy",
        "numpy.__version__ = '2.4.6'",
        "import importlib.util, sys",
        f"spec = importlib.util.spec_from_file_location('bentur._core', {_core.__file__!r})",
        "core = sys.modules['bentur._core'] = importlib.util.module_from_spec(spec)",
        "spec.loader.exec_module(core)",
        "core.pybind11 = (2, 10)",
        "import bentur",
    ])
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, cwd=tmp_path)
    assert done.returncode == 1
    assert done.stderr.splitlines()[-1].startswith("ImportError: this bentur was built with pybind11 2.10, which reads arrays")


@pytest.fixture(scope="module")
def record(root):
    return root / "data" / "el-centro-1940-ns.csv"


@pytest.fixture(scope="module", params=CASES)
def both(request, program, root, record, tmp_path_factory):
    """What that Python gives, the folder that the command line has written, and the case."""
    case = root / "examples" / f"{request.param}.toml"
    folder = tmp_path_factory.mktemp("command")
    subprocess.run([program, "run", case, "-q", "-o", folder], check=True)
    made = subprocess.run([PYTHON, Path(__file__).with_name("arrays.py"), case, record], capture_output=True, text=True)
    assert made.returncode == 0, made.stderr
    return json.loads(made.stdout), folder, case


def test_impacts(both):
    found, folder, _ = both
    rows = list(csv.DictReader((folder / "impacts.csv").open()))
    columns = {name.partition(" [")[0]: name for name in rows[0]}
    assert len(rows) > 30
    assert {"start", "peak_force", "closing_speed"} <= {*found["impacts"]} <= {*columns}
    for name, values in found["impacts"].items():
        expected = [float(row[columns[name]] or "nan") for row in rows]
        np.testing.assert_array_equal(values, expected, err_msg=name)
    assert len(set(found["impacts"]["peak_force"])) > 30
    points = [point for gap in found["summary"]["gaps"] for point in gap["points"]]
    assert max(found["impacts"]["peak_force"]) == max(point["peak_force"] or 0 for point in points)


@pytest.mark.parametrize("group", ["histories", "exact"])
def test_histories(both, group):
    netCDF4 = pytest.importorskip("netCDF4")
    found, folder, _ = both
    compared = 0
    with netCDF4.Dataset(folder / "histories.nc") as file:
        file.set_auto_mask(False)
        place = file if group == "histories" else file["exact"]
        for name, values in found[group].items():
            of_buildings = not isinstance(values[0], float) and name not in place.variables
            for variable, one in ((f"{name}_{n}", one) for n, one in enumerate(values, 1)) if of_buildings else [(name, values)]:
                if one is None:
                    continue
                expected = place[variable][...]
                assert np.ptp(expected) > 0 or name == "ground_acceleration"
                np.testing.assert_array_equal(one, expected, err_msg=variable)
                compared += expected.size
    assert compared > 10_000


def test_modes(both, program):
    found, _, case = both
    told = subprocess.run([program, "modes", case, "--json"], check=True, capture_output=True, text=True)
    for building in json.loads(told.stdout)["buildings"]:
        one = found["modes"][building["name"]]
        assert len(one["periods"]) > 1
        assert {name: building[name] for name in one} == one


def test_record(both, record):
    found, _, _ = both
    rows = [line.split(",") for line in record.read_text().splitlines() if line[:1].isdigit()]
    assert len(rows) > 1000
    np.testing.assert_allclose(found["record"]["time"], [float(row[0]) for row in rows], rtol=0, atol=1e-9)
    assert found["record"]["values"] == [float(row[1]) for row in rows]


def test_spectrum(both, program, record):
    line = ["spectrum", record, "--unit", "g", "--damping", "0.02", "--length", "cm", "--json"]
    expected = json.loads(subprocess.run([program, *line], check=True, capture_output=True, text=True).stdout)
    found, _, _ = both
    for name in ("period", "displacement", "pseudo_velocity", "pseudo_acceleration", "absolute_acceleration"):
        assert found["spectrum"][name] == expected[name], name
    assert len(set(found["spectrum"]["displacement"])) > 10
