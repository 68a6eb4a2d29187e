"""The command line and Python give the same numbers, to the bit."""

import csv
import io
import json
import re
import subprocess
from pathlib import Path

import doors
import numpy as np
import pytest
from part import part

import bentur
from bentur import _result, _study
from bentur._dataset import netcdf

NAMES = [case.stem for case in doors.EXAMPLES]
SOME_NAMES = part(NAMES, 6)  # where whole files are compared


def output(program, *arguments):
    return subprocess.run([program, *map(str, arguments)], check=True, capture_output=True, text=True).stdout


@pytest.fixture(scope="module")
def results(root):
    return {name: bentur.run(root / "examples" / f"{name}.toml") for name in NAMES}


@pytest.mark.parametrize("name", NAMES)
def test_summary(name, results, program):
    expected = doors.numbers(doors.command_line(program, doors.ROOT / "examples" / f"{name}.toml"))
    found = doors.numbers(json.loads(results[name].to_json()))
    assert list(doors.differences(expected, found)) == []
    assert doors.count(found) > 50


@pytest.mark.parametrize("case", doors.CASES, ids=lambda case: case.stem)
def test_summary_of_other_cases(case, program):
    expected = doors.numbers(doors.command_line(program, case))
    assert sum(point["impacts"] for gap in expected["gaps"] for point in gap["points"]) > 0
    plain = doors.numbers(json.loads(output(program, "run", case, "--json")))
    found = doors.numbers(json.loads(bentur.run(case).to_json()))
    assert list(doors.differences(expected, plain)) == []
    assert list(doors.differences(expected, found)) == []


@pytest.mark.parametrize("name", SOME_NAMES)
def test_impacts_and_histories(name, results, program, root, tmp_path):
    xarray = pytest.importorskip("xarray")
    subprocess.run([program, "run", root / "examples" / f"{name}.toml", "-q", "-o", tmp_path], check=True)
    rows = list(csv.reader(io.StringIO((tmp_path / "impacts.csv").read_text())))
    table = results[name].impacts
    assert len(table) == len(rows) - 1
    for row, (_, found) in zip(rows[1:], table.iterrows()):
        for cell, value in zip(row, found):
            expected = value if isinstance(value, str) else float(cell) if cell else None
            assert cell == value if isinstance(value, str) else (expected == value or (expected is None and np.isnan(value)))
    with xarray.open_dataset(tmp_path / "histories.nc") as expected:
        datasets_are_equal(expected, results[name].dataset)
    with xarray.open_dataset(tmp_path / "histories.nc", group="exact") as expected:
        found = results[name].exact_dataset
        assert found.attrs == results[name].dataset.attrs  # of the whole file
        datasets_are_equal(expected.assign_attrs(found.attrs), found.drop_vars(set(found.coords) - set(expected.variables)))


def contents(file, group=""):
    """Every variable of a NetCDF file by name: dimensions, type, attributes, values."""
    found = {}
    for name, variable in file.variables.items():
        told = {key: np.asarray(variable.getncattr(key)).tolist() for key in variable.ncattrs()}
        found[group + name] = variable.dimensions, str(variable.dtype), told, np.asarray(variable[...]).tolist()
    for name, inner in file.groups.items():
        found |= contents(inner, name + "/")
    return found


@pytest.mark.parametrize("name", SOME_NAMES)
def test_histories_that_python_saves(name, root, program, tmp_path):
    """The file is the command line's, variable by variable, and so are the attributes of the whole."""
    netCDF4 = pytest.importorskip("netCDF4")
    text = (root / "examples" / f"{name}.toml").read_text().replace("title = \"", "title = \"Süd – ", 1)
    case = root / "examples" / f"{name}.toml"
    if "excitation.file" not in text and "file =" not in text:  # else relative to the examples
        case = tmp_path / "case.toml"
        case.write_text(text, encoding="utf-8")
    bentur.run(case).save(tmp_path / "python")
    subprocess.run([program, "run", case, "-q", "-o", tmp_path / "command"], check=True)
    with (
        netCDF4.Dataset(tmp_path / "python" / "histories.nc") as one,
        netCDF4.Dataset(tmp_path / "command" / "histories.nc") as other,
    ):
        for file in (one, other):
            file.set_auto_mask(False)
        found, expected = contents(one), contents(other)
        assert sorted(found) == sorted(expected)  # in either order: the command puts its file together without the library
        for variable in expected:
            np.testing.assert_equal(found[variable], expected[variable], err_msg=variable)
        assert {key: one.getncattr(key) for key in one.ncattrs()} == {key: other.getncattr(key) for key in other.ncattrs()}


def test_a_case_made_in_python_is_reported_whole(program, tmp_path):
    """What needs no file of the case: modes, envelopes and every figure of the report."""
    pytest.importorskip("netCDF4")
    case = bentur.example("m12-harmonic")
    bentur.run(bentur.Case.from_dict(case.to_dict(), folder=case.folder)).save(tmp_path / "made")
    bentur.run(case).save(tmp_path / "read")
    assert (tmp_path / "made" / "case.toml").read_text() != (tmp_path / "read" / "case.toml").read_text()  # written anew
    listed = [output(program, "plot", tmp_path / folder / "histories.nc", "--list") for folder in ("made", "read")]
    assert listed[0] == listed[1]
    for kind in ("modes", "envelope"):
        subprocess.run([program, "plot", tmp_path / "made", kind, "-o", tmp_path / f"{kind}.svg"], check=True)
    figures = []
    for folder in ("made", "read"):
        subprocess.run([program, "report", tmp_path / folder, "-o", tmp_path / f"{folder}.html"], check=True)
        figures.append((tmp_path / f"{folder}.html").read_text().count("<figure"))
    assert figures[0] == figures[1] > 0


@pytest.mark.parametrize("name", ["row-of-three", "struck-column", "yielding-pair"])
def test_what_python_saves_is_reported_alike(name, root, program, tmp_path):
    """The command line draws a report from a folder that Python has written: the same page, byte for byte."""
    pytest.importorskip("netCDF4")
    bentur.run(root / "examples" / f"{name}.toml").save(tmp_path / "python")
    subprocess.run([program, "run", root / "examples" / f"{name}.toml", "-q", "-o", tmp_path / "command"], check=True)
    for door in ("python", "command"):
        subprocess.run([program, "report", tmp_path / door, "-o", tmp_path / f"{door}.html"], check=True)
    assert (tmp_path / "python.html").read_bytes() == (tmp_path / "command.html").read_bytes()


def test_every_door_says_which_bentur_it_is(root, program, tmp_path):
    xarray = pytest.importorskip("xarray")
    version = bentur.__version__
    assert output(program, "--version") == f"bentur {version}\n"
    case, study = root / "examples" / "m12-el-centro.toml", root / "examples" / "studies" / "m12-gaps.toml"
    result = bentur.run(case)
    subprocess.run([program, "run", case, "-q", "-o", tmp_path / "run"], check=True)
    subprocess.run([program, "sweep", study, "-q", "-o", tmp_path / "sweep.nc"], check=True)
    told = [result.summary, result.gaps, bentur.minimum_gap(case), json.loads((tmp_path / "run" / "summary.json").read_text())]
    told += [json.loads(output(program, *line, "--json")) for line in (("run", case), ("gap", case), ("remedy", case))]
    told += [json.loads(output(program, "spectrum", root / "data" / "el-centro-1940-ns.csv", "--unit", "g", "--json"))]
    assert [one["version"] for one in told] == [version] * len(told)
    files = [result.dataset, bentur.sweep(study)]
    for name in ("run/histories.nc", "sweep.nc"):
        with xarray.open_dataset(tmp_path / name) as file:
            files.append(file)
    for file in files:
        assert file.attrs["bentur_version"] == version and file.attrs["history"] == f"written by bentur {version}"
    pages = [result.report("en"), *(output(program, "report", one, "-o", "-") for one in (case, tmp_path / "run"))]
    assert [page.count(f"Pounding analysis, bentur {version}<") for page in pages] == [1] * len(pages)
    assert f"Pounding study, bentur {version}<" in output(program, "report", tmp_path / "sweep.nc", "-o", "-")


@pytest.mark.parametrize("case", ["m12-el-centro.toml", "plan/twisting-pair.toml", "studies/m12-gaps.toml"])
def test_a_report_says_which_bentur_made_the_results(case, root, program, tmp_path, monkeypatch):
    pytest.importorskip("netCDF4")
    for module in (_result, _study):  # as if an earlier one had written them
        monkeypatch.setattr(module, "netcdf", lambda told, variables: netcdf({**told, "history": "written by bentur 0.1.9"}, variables))
    results = tmp_path / "histories.nc"
    if case.startswith("studies"):
        bentur.sweep(root / "examples" / case, output=results)
    else:
        bentur.run(root / "examples" / case).save(tmp_path)
    for language, drawn in (("en", "drawn by"), ("id", "digambar oleh")):
        page = output(program, "report", results, "--lang", language, "-o", "-")
        assert f", bentur 0.1.9, {drawn} {bentur.__version__}<" in page


@pytest.mark.parametrize("name", NAMES)
def test_gap_and_modes(name, root, program):
    case = root / "examples" / f"{name}.toml"
    expected = json.loads(output(program, "gap", case, "--json"))
    found = bentur.minimum_gap(case)
    assert list(doors.differences(expected["gaps"], found["gaps"])) == []
    for building in json.loads(output(program, "modes", case, "--json"))["buildings"]:
        one = bentur.modes(case)[building["name"]]
        for key, value in building.items():
            if isinstance(value, list):
                np.testing.assert_array_equal(np.array(value), one[key])
            else:
                assert one[key] == value


def test_remedy(root, program, tmp_path):
    study = root / "examples" / "studies" / "linked-pair-damper.toml"
    expected = json.loads(output(program, "remedy", study, "--json"))
    assert list(doors.differences(expected, bentur.remedy(study))) == []
    assert list(doors.differences(expected, bentur.remedy(study, journal=tmp_path / "kept"))) == []
    assert not (tmp_path / "kept").exists()
    for case in ("row-of-three.toml", "plan/twisting-pair.toml", "two-real-buildings/record.toml"):
        case = root / "examples" / case
        assert list(doors.differences(json.loads(output(program, "remedy", case, "--json")), bentur.remedy(case))) == []
    with pytest.raises(ValueError, match="journal"):
        bentur.remedy(case, journal=tmp_path / "kept")
    with pytest.raises(bentur.CaseError, match="remedy"):
        bentur.remedy(root / "examples" / "studies" / "m12-gaps.toml")
    with pytest.raises(ValueError, match="journal"):
        bentur.remedy(study, resume=True)


SPECTRUM = """
[excitation]
kind = "spectrum"
shape = "en-1998-1"
ground_acceleration = 0.25
spectrum_type = 1
ground_type = "C"
"""


def test_gap_by_a_design_spectrum(root, program, tmp_path):
    text = (root / "examples" / "two-frames-si.toml").read_text()
    case = tmp_path / "case.toml"
    case.write_text(re.sub(r"^\[excitation\]\n(?:[^\[].*\n|\n)*", SPECTRUM, text, flags=re.MULTILINE))
    expected = json.loads(output(program, "gap", case, "--json"))
    assert expected["gaps"][0]["srss"] > 0
    assert list(doors.differences(expected, bentur.minimum_gap(case))) == []
    with pytest.raises(bentur.CaseError, match='excitation.kind = "spectrum"') as caught:
        bentur.run(case)
    assert caught.value.errors[0].line > 0


def test_gap_by_a_design_spectrum_in_plan(root, program, tmp_path):
    text = (root / "examples" / "plan" / "twisting-pair.toml").read_text()
    case = tmp_path / "case.toml"
    case.write_text(re.sub(r"(?ms)^\[excitation\].*", "", text) + SPECTRUM)
    expected = json.loads(output(program, "gap", case, "--json"))
    assert expected["gaps"][0]["gap_needed"] > 0
    assert list(doors.differences(expected, bentur.minimum_gap(case))) == []
    with pytest.raises(bentur.CaseError, match='excitation.kind = "spectrum"'):
        bentur.run(case)


SUITE = """
[excitation]
kind = "suite"
files = [{{ file = "{folder}/*.txt", unit = "m/s2" }}]
scale = "en-1998-1"
target = {{ shape = "en-1998-1", ground_acceleration = "0.25 g", spectrum_type = 1, ground_type = "C" }}
"""


def test_suite_of_records(root, program, tmp_path):
    for n in range(3):
        times = np.arange(400) * 0.01
        values = np.sin(np.pi * times / 4) * np.sin((7 + 2 * n) * times)
        np.savetxt(tmp_path / f"r{n}.txt", np.column_stack([times, values]), fmt="%.6f")
    text = (root / "examples" / "two-frames-si.toml").read_text()
    case = tmp_path / "case.toml"
    suite = SUITE.format(folder=tmp_path)
    case.write_text(re.sub(r"^\[excitation\]\n(?:[^\[].*\n|\n)*", lambda _: suite, text, flags=re.MULTILINE))
    assert list(doors.differences(json.loads(output(program, "run", case, "--json")), bentur.run_suite(case))) == []
    assert list(doors.differences(json.loads(output(program, "gap", case, "--json")), bentur.minimum_gap(case))) == []
    one = json.loads(output(program, "run", case, "--record", "2", "--json"))
    found = bentur.run(case, record=2, histories=False).summary
    assert found["excitation"]["pga"] == one["excitation"]["pga"]
    assert list(doors.differences(one["gaps"], found["gaps"])) == []
    with pytest.raises(bentur.CaseError, match='excitation.kind = "suite"'):
        bentur.run(case)
    with pytest.raises(ValueError, match="record = 4, must be 1 to 3"):
        bentur.run(case, record=4)


def test_spectrum(root, program):
    record = root / "data" / "el-centro-1940-ns.csv"
    expected = json.loads(output(program, "spectrum", record, "--unit", "g", "--damping", "0.02", "--length", "cm", "--json"))
    found = bentur.response_spectrum(record, damping=0.02, unit="g", length="cm")
    for name in ("period", "displacement", "pseudo_velocity", "pseudo_acceleration", "absolute_acceleration"):
        np.testing.assert_array_equal(np.array(expected[name]), getattr(found, name))


def datasets_are_equal(expected, found):
    assert set(expected.variables) == set(found.variables)
    assert set(expected.coords) == set(found.coords)
    for name in expected.variables:
        a, b = expected[name], found[name]
        assert a.dims == b.dims, name
        np.testing.assert_equal(dict(a.attrs), dict(b.attrs), err_msg=name)
        np.testing.assert_array_equal(a.to_numpy(), b.to_numpy(), err_msg=name)
    assert expected.attrs == found.attrs


STUDY = """
case = "{case}"

[[vary]]
parameter = "gap[0].width"
values = [0.0, 0.2, 0.4]

[[vary]]
parameter = "excitation.polarity"
values = ["as-recorded", "reversed"]
"""

SAMPLES = """
case = "{case}"

[[vary]]
parameter = "gap[0].width"
from = 0.0
to = 1.0

[[vary]]
parameter = "building[0].damping"
distribution = {{ lognormal = {{ median = 0.05, cov = 0.3, high = 0.2 }} }}

[sampling]
method = "sobol"
count = 8
"""

IDA = STUDY + """
[ida]
intensity = "pga"
unit = "g"
levels = [0.1, 0.2, 0.3, 0.4]
"""


@pytest.mark.parametrize("kind, text", [("sweep", STUDY), ("sweep", SAMPLES), ("ida", IDA)])
def test_studies(kind, text, root, program, tmp_path):
    xarray = pytest.importorskip("xarray")
    pytest.importorskip("netCDF4")
    study = tmp_path / "study.toml"
    if kind == "ida":  # [ida] asks for the polarity itself
        text = text.split("[[vary]]")[0] + "[[vary]]" + text.split("[[vary]]")[1] + text[text.index("[ida]") :]
        text += 'polarity = "both"\n'
    study.write_text(text.format(case=root / "examples" / "m12-el-centro.toml"))
    subprocess.run([program, kind, study, "-o", tmp_path / "results.nc", "-q"], check=True)
    found = getattr(bentur, kind)(study, threads=2)
    with xarray.open_dataset(tmp_path / "results.nc") as expected:
        datasets_are_equal(expected, found)
        if kind != "ida":
            return
        asked = {"at": 0.25, "probabilities": [0.1, 0.5], "resamples": 200, "seed": 7}
        line = ["--at", 0.25, "--probability", "0.1,0.5", "--resamples", 200, "--seed", 7]
        for event in ("impacts > 0", "drift > 0.001", "peak_force > 2000"):
            told = json.loads(output(program, "fragility", tmp_path / "results.nc", "--event", event, "--json", *line))
            for results in (found, expected):
                assert list(doors.differences(told, bentur.fragility(results, event, **asked))) == []
        pytest.importorskip("matplotlib").use("Agg")
        from bentur import plot

        given, fitted = (plot.fragility(one) for one in (found, bentur.fragility(found)))
        assert len(given.lines) == len(fitted.lines) > 0
    gaps = json.loads(output(program, "gap", study, "--json"))
    assert list(doors.differences(gaps, bentur.minimum_gap(study))) == []


class Enough(Exception):
    """Raised to stop a study."""


def stopped(study, output, **more):
    """A sweep in Python that is stopped after some of its runs."""
    def stop(done):
        if done > 0:
            raise Enough

    with pytest.raises(Enough):
        bentur.sweep(study, output=output, threads=1, progress=stop, **more)
    assert Path(f"{output}.part").exists() and not output.exists()


def test_studies_resume(root, program, tmp_path):
    xarray = pytest.importorskip("xarray")
    pytest.importorskip("netCDF4")
    study, output = tmp_path / "study.toml", tmp_path / "results" / "r.nc"
    text = STUDY.format(case=root / "examples" / "m12-el-centro.toml").replace("[0.0, 0.2, 0.4]", str([0.01 * i for i in range(40)]))
    study.write_text(text)
    expected = bentur.sweep(study)
    subprocess.run([program, "sweep", study, "-o", tmp_path / "program.nc", "-q"], check=True)

    stopped(study, output)
    part = Path(f"{output}.part")
    with pytest.raises(RuntimeError, match="r.nc.part: results of an unfinished sweep are there: go on with resume=True, or remove"):
        bentur.sweep(study, output=output)
    study.write_text(text + "# another\n")
    with pytest.raises(RuntimeError, match="was begun with another study: line 11 has changed. Remove it to begin anew"):
        bentur.sweep(study, output=output, resume=True)
    study.write_text(text)
    shares = []
    datasets_are_equal(expected, bentur.sweep(study, output=output, resume=True, threads=1, progress=shares.append))
    assert not part.exists() and shares[-1] == 1
    with xarray.open_dataset(output) as here, xarray.open_dataset(tmp_path / "program.nc") as there:
        datasets_are_equal(there, here)

    # finished results are left as they are, those of another study are not lost
    written = output.stat().st_mtime_ns
    datasets_are_equal(expected, bentur.sweep(study, output=output, resume=True))
    assert output.stat().st_mtime_ns == written
    study.write_text(text + "# another\n")
    with pytest.raises(RuntimeError, match="these finished results were begun with another study: line 11 has changed. "
                                           "Without resume=True they are replaced"):
        bentur.sweep(study, output=output, resume=True)
    study.write_text(text)

    # either door goes on with what the other one has begun
    output.unlink()
    stopped(study, output)
    subprocess.run([program, "sweep", study, "-o", output, "-q", "--resume"], check=True)
    with xarray.open_dataset(output) as found:
        datasets_are_equal(expected, found)
    datasets_are_equal(expected, bentur.sweep(study, output=output, resume=True))

    case = root / "examples" / "m12-el-centro.toml"
    with pytest.raises(bentur.RefusedOutput, match="m12-el-centro.toml: not written"):
        bentur.sweep(study, output=case, force=True)
    other = tmp_path / "notes.nc"
    other.write_text("mine")
    with pytest.raises(bentur.RefusedOutput, match="force=True"):
        bentur.sweep(study, output=other)
    with pytest.raises(ValueError, match="resume goes with output"):
        bentur.sweep(study, resume=True)
