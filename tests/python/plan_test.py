"""Buildings in plan from Python: the numbers of the command line, to the bit."""

import csv
import io
import json
import pickle
import subprocess

import doors
import numpy as np
import pytest

import bentur

CASE = doors.ROOT / "examples" / "plan" / "twisting-pair.toml"


@pytest.fixture(scope="module")
def result():
    return bentur.run(CASE)


@pytest.fixture(scope="module")
def folder(program, tmp_path_factory):
    into = tmp_path_factory.mktemp("command")
    subprocess.run([program, "run", CASE, "-q", "-o", into], check=True)
    return into


def output(program, *arguments):
    return subprocess.run([program, *map(str, arguments)], check=True, capture_output=True, text=True).stdout


def pair(**more):
    """The example as classes."""
    stiff, soft = [9e4, 9e4], [2e4, 2e4]
    return bentur.Case(
        units=bentur.Units(length="m", force="kN"),
        plan=bentur.Plan(clearance=0.1, contact=bentur.Contact(law="linear", stiffness=4e5, friction=0.3)),
        building=[
            bentur.Building(
                name="Walled", damping=0.05,
                plan=bentur.BuildingPlan(corner=[0, 0], size=[12, 18], storey_heights=[3.5, 3.2], masses=[200, 180]),
                plane=[
                    bentur.Plane(name="south wall", along="x", at=0.0, stiffnesses=stiff),
                    bentur.Plane(name="north frame", along="x", at=18.0, stiffnesses=soft),
                    bentur.Plane(name="west frame", along="y", at=0.0, stiffnesses=[4e4, 4e4]),
                    bentur.Plane(name="east frame", along="y", at=12.0, stiffnesses=[4e4, 4e4]),
                ],
            ),
            bentur.Building(
                name="Frame", damping=0.05,
                plan=bentur.BuildingPlan(corner=[12.04, 0], size=[15, 18], storey_heights=[3.5, 3.2], masses=[250, 220]),
                rigidity=bentur.Rigidity(centre=[7.5, 9], x=1.2e5, y=1.2e5, torsion=1.2e7),
            ),
        ],
        excitation=bentur.Excitation(
            kind="record", file=str(doors.ROOT / "data" / "el-centro-1940-ns.csv"), unit="g", pga=3.4, angle=30.0),
        analysis=bentur.Analysis(duration=15.0),
        **more,
    )


def test_summary(result, folder):
    expected = doors.numbers(json.loads((folder / "summary.json").read_text()))
    assert list(doors.differences(expected, doors.numbers(json.loads(result.to_json())))) == []
    assert result.impact_count > 3


def test_a_case_of_classes_is_the_file(result):
    title = {"title": result.summary["title"]}
    found = json.loads(bentur.run(pair(**title)).to_json())
    assert list(doors.differences(doors.numbers(result.summary), doors.numbers(found))) == []


def test_impacts(result, folder):
    rows = list(csv.reader(io.StringIO((folder / "impacts.csv").read_text())))
    table = result.impacts
    assert len(table) == len(rows) - 1 == result.impact_count
    assert list(table.columns) == [head.split(" ")[0] for head in rows[0]]
    for row, (_, found) in zip(rows[1:], table.iterrows()):
        for cell, value in zip(row, found):
            assert cell == value if isinstance(value, str) else float(cell or "nan") == value or (cell == "" and np.isnan(value))


def test_histories(result, folder):
    xarray = pytest.importorskip("xarray")
    with xarray.open_dataset(folder / "histories.nc") as expected:
        found = result.dataset
        assert set(found.variables) == set(expected.variables)
        for name in expected.variables:
            np.testing.assert_array_equal(found[name].values, expected[name].values, err_msg=name)
    histories = result.histories
    assert histories["displacement_x"][0].shape == (1501, 2) == histories["rotation"][1].shape
    assert histories["slip"].shape == histories["force"].shape == (1501, 4)
    exact = result.exact
    assert exact["force"].shape == exact["opening"].shape == (len(exact["time"]), 4)
    assert exact["displacement_x"][0].shape == exact["rotation"][1].shape == (len(exact["time"]), 2)
    peak = max(point["peak_force"] for gap in result.summary["gaps"] for point in gap["points"])
    assert exact["force"].max() == pytest.approx(peak, rel=1e-12)


FRAMES = """
[[building.plane]]
name = "framed"
along = "x"
at = 2.0
frame = { elastic_modulus = 3e7, bay_widths = [5, 5], columns = [{ width = 0.4, depth = 0.5 }], beams = [{ width = 0.3, depth = 0.5 }] }
"""


def test_what_frames_carry_and_spectra_of_floors_are_drawn(program, tmp_path):
    """The same bytes as the command line writes at once, and draws of its files."""
    text = CASE.read_text().replace("../../data", str(doors.ROOT / "data"))
    first = text.index("[[building.plane]]")
    case = tmp_path / "case.toml"
    case.write_text(text[:first] + FRAMES.lstrip() + text[first:])
    subprocess.run([program, "run", case, "-q", "-o", tmp_path / "out", "--figures", "svg"], check=True)
    found = bentur.run(case)
    for kind in "floor-spectrum", "frame-forces", "frame-envelope", "frame-moment", "frame-shear", "frame-axial":
        svg = (tmp_path / f"out/figures/{kind}.svg").read_text()
        assert found.plot(kind).svg == svg, kind
        subprocess.run([program, "plot", tmp_path / "out", kind, "-o", tmp_path / "again.svg"], check=True)
        assert (tmp_path / "again.svg").read_text() == svg, kind
    # At the instant and largest; for a telephone some titles take two lines.
    assert found.report().count("framed, M [kN") >= 2
    with pytest.raises(ValueError, match="members of a frame"):
        bentur.run(CASE).plot("frame-moment")


def test_what_is_told(result, program):
    told = output(program, "run", CASE)
    assert result.verdict()[0].startswith("POUNDING: ")
    assert result.verdict()[0].split(". ")[0] in " ".join(told.split())
    assert "<svg" in result.plot().svg and set(result.figures) > {"scene", "orbit", "friction-cone"}
    assert "Walled" in result.report("id")
    gaps = json.loads(output(program, "gap", CASE, "--json"))
    assert list(doors.differences(gaps["gaps"], bentur.minimum_gap(CASE)["gaps"])) == []
    assert list(doors.differences(gaps["gaps"], result.gaps["gaps"])) == []
    rules = json.loads(output(program, "gap", CASE, "--rules", "--json"))
    assert rules == bentur.height_rules(CASE)
    modes = json.loads(output(program, "modes", CASE, "--json"))["buildings"]
    np.testing.assert_array_equal(bentur.modes(CASE)["Walled"]["periods"], modes[0]["periods"])


def test_saves_what_the_command_line_writes(result, folder, tmp_path):
    pytest.importorskip("netCDF4")
    files = result.save(tmp_path / "python")
    assert {file.name for file in files} == {file.name for file in folder.iterdir()}
    for name in ("impacts.csv", "case.toml"):
        assert (tmp_path / "python" / name).read_bytes() == (folder / name).read_bytes()
    assert result.save(tmp_path / "python")  # results of the same kind are replaced


def test_other_values(result):
    case = bentur.Case.from_file(CASE).replace({"plan.contact.friction": 0.0})
    assert bentur.run(case).summary["gaps"] != result.summary["gaps"]
    assert pickle.loads(pickle.dumps(case)).to_dict() == case.to_dict()
    assert case.matrices("Frame")["stiffness"].shape == (6, 6)
    with pytest.raises(bentur.CaseError, match="^[^\n]*building.\"Frame\"..plan.size.0. = -1, must be > 0$"):
        case.replace({"building[1].plan.size": [-1.0, 2.0]})


def test_known_by_its_modes(result):
    """Modes that NumPy finds of the first building's matrices, in place of its planes."""
    case = bentur.Case.from_file(CASE)
    matrices = case.matrices("Walled")
    root = np.sqrt(np.diag(matrices["mass"]))
    squares, vectors = np.linalg.eigh(matrices["stiffness"] / np.outer(root, root))
    tables = case.to_dict()
    del tables["building"][0]["plane"]
    tables["building"][0]["modal"] = bentur.Modal(periods=2 * np.pi / np.sqrt(squares), shapes=(vectors / root[:, None]).T)
    known = bentur.run(bentur.Case.from_dict(tables, folder=CASE.parent))
    assert known.summary["buildings"][0]["modal"]["modes"] == 6
    forces = [[point["peak_force"] for point in one.summary["gaps"][0]["points"]] for one in (known, result)]
    np.testing.assert_allclose(*forces, rtol=1e-8)
    with pytest.raises(bentur.CaseError, match="does not go with modal"):
        bentur.Case.from_dict(tables, folder=CASE.parent).replace({"building[0].rigidity": {"centre": [1, 1]}})


def test_sweep(result, tmp_path):
    pytest.importorskip("xarray")
    study = tmp_path / "study.toml"
    study.write_text(f"case = '{CASE}'\n[[vary]]\nparameter = 'plan.contact.friction'\nvalues = [0.3, 0.6]\n")
    data = bentur.sweep(study)
    peak = max(point["peak_force"] for point in result.summary["gaps"][0]["points"])
    assert float(data.peak_force.isel(friction=0).max()) == peak
    assert data.plane_peak_drift_ratio_1.dims == ("friction", "plane_1", "elevation_1")


def test_ida(tmp_path):
    pytest.importorskip("xarray")
    study = tmp_path / "study.toml"
    study.write_text(f"case = '{CASE}'\n[ida]\nintensity = 'pga'\nunit = 'g'\nlevels = [0.1, 3.4, 8.0]\npolarity = 'both'\n")
    data = bentur.ida(study)
    assert data.sizes["intensity"] == 3
    assert data.impacts.sum("point").isel(intensity=0).values.tolist() == [0, 0]
    fragility = bentur.fragility(data)
    assert fragility["curves"][0]["runs"] == 6


def test_every_solver_follows_friction():
    case = bentur.Case.from_file(CASE)
    exact, *others = (
        bentur.run(case.replace({"analysis": {"duration": 5.0, "solver": solver, **more}}), histories=False)
        for solver, more in (("exact", {}), ("adaptive", {"tolerance": 1e-11}), ("runge-kutta", {"step": 5e-4}))
    )
    loss = [sum(point["friction_loss"] for point in run.summary["gaps"][0]["points"]) for run in (exact, *others)]
    assert loss[0] > 0
    assert loss[1:] == pytest.approx([loss[0]] * 2, rel=1e-6)


def test_remarks_of_buildings_in_plan(result):
    assert result.remarks and str(result).splitlines()[-1].startswith("remark: ")
    assert len(result.summary["remarks"]) >= len(result.remarks)  # those that are alike are one sentence
