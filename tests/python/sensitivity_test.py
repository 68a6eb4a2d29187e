"""Derivatives of a run in Python: those of the command line, and those of runs with a little more."""

import json
import os
import subprocess

import doors
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


def test_in_plan_places_are_numbers_and_points_have_theirs():
    pytest.importorskip("pandas")
    case = bentur.Case.from_file(doors.ROOT / "examples" / "plan" / "twisting-pair.toml").replace(
        {"plan.contact": {"law": "linear", "stiffness": 4e5}, "analysis.duration": 6.0}
    )
    result = bentur.run(case, histories=False)
    table, path = result.gradient, "building[1].plan.corner[0]"
    h = 12.04e-6
    above, below = (bentur.run(case.replace({path: 12.04 + by}), histories=False) for by in (h, -h))

    def points(run):
        return np.array([point["peak_force"] for point in run.summary["gaps"][0]["points"]])

    known = points(result) > 0
    different = (points(above) - points(below))[known] / (2 * h)
    assert np.max(np.abs(different)) > 0
    np.testing.assert_allclose(table.loc[path, "peak_force"].to_numpy(), different, atol=1e-4 * np.max(np.abs(different)))
    assert table.columns.names == ["quantity", "of", "level", "x", "y"] and table.columns.is_unique
    assert result.sensitivity["peaks"][0]["at"] == result.summary["gaps"][0]["points"][0]["at"]


def random_plan(seed):
    """Two twisting buildings side by side, some corner to corner; of three laws, under two motions."""
    random = np.random.default_rng(seed)
    storeys = random.integers(1, 4)

    def any_of(low, high):
        return f"[{', '.join(f'{value:.9g}' for value in random.uniform(low, high, storeys))}]"

    def building(name, corner, size):
        u = random.uniform
        return f"""
[[building]]
name = "{name}"
damping = {u(0.02, 0.06):.6g}
[building.plan]
corner = [{corner[0]:.9g}, {corner[1]:.9g}]
size = [{size[0]:.9g}, {size[1]:.9g}]
storey_heights = {[3.0] * storeys}
masses = {any_of(80, 300)}
centres_of_mass = [{size[0] * u(0.4, 0.6):.9g}, {size[1] * u(0.4, 0.6):.9g}]
[[building.plane]]
along = "x"
at = {size[1] * u(0.02, 0.3):.9g}
stiffnesses = {any_of(2e4, 9e4)}
[[building.plane]]
along = "x"
at = {size[1] * u(0.7, 0.98):.9g}
stiffnesses = {any_of(2e4, 9e4)}
[[building.plane]]
angle = {u(70, 110):.9g}
through = [{size[0] * u(0.1, 0.9):.9g}, 1.0]
stiffnesses = {any_of(5e4, 12e4)}
"""

    sizes = random.uniform(8, 16, (2, 2))
    beside = sizes[0][1] + random.uniform(-0.1, 0.02) if seed % 3 == 0 else random.uniform(-0.5, 0.8) * sizes[0][1]
    more = ["", ", damping_ratio = 0.15", ", damping_ratio = 0.1"][seed % 3]
    law = ["linear", "kelvin-voigt", "kelvin-voigt-approach"][seed % 3]
    motions = [f'kind = "harmonic"\nperiod = {random.uniform(0.3, 0.8):.6g}\ndisplacement_amplitude = {a}\n' for a in (0.02, 0.012)]
    return f"""
units = {{ length = "m", force = "kN" }}
plan = {{ clearance = 0.1, contact = {{ law = "{law}", stiffness = {random.uniform(5e4, 5e5):.6g}{more} }} }}
{building("A", (1.0, 2.0), sizes[0])}
{building("B", (1.0 + sizes[0][0] + random.uniform(0.005, 0.03), 2.0 + beside), sizes[1])}
[excitation]
{motions[0]}angle = {random.uniform(3, 40):.6g}
[excitation.y]
{motions[1]}
[analysis]
duration = 2.5
"""


def of_plan(run):
    gap = {(quantity, n): point[quantity] for n, point in enumerate(run.summary["gaps"][0]["points"]) for quantity in ("gap_needed", "peak_force")}
    floors = {
        (f"displacement_{axis}", building["name"], floor): value
        for building in run.summary["buildings"]
        for axis in "xy"
        for floor, value in enumerate(building[f"peak_displacement_{axis}"])
    }
    return {**gap, **floors}


@pytest.mark.filterwarnings("ignore::bentur.RemarkWarning")
@pytest.mark.parametrize("seed", range(1, 7))
def test_of_random_plans(seed):
    """Of footprints a millionth moves corners too far for differences: the C++ tests have these."""
    case = bentur.Case.from_text(random_plan(seed))
    run = bentur.run(case, histories=False)
    found, values = bentur.sensitivity(case), of_plan(run)
    places = [(point["elevation"], point["at"]) for point in run.summary["gaps"][0]["points"]]

    def key_of(peak):
        if "building" in peak:
            return peak["quantity"], peak["building"], round(peak["level"] / 3) - 1
        near = [(peak["quantity"], n) for n, place in enumerate(places) if place == (peak["level"], peak["at"])]
        return next(key for key in near if values[key] == pytest.approx(peak["value"], rel=1e-7))

    peaks = [(key_of(peak), peak) for peak in found["peaks"] if not peak["quantity"].endswith("_no_contact") and peak["grazing"] > 1e-3]
    compared = 0
    for i, number in enumerate(found["numbers"]):
        if number["path"].endswith(": width") or found["peaks"][0]["elasticity"][i] is None:
            continue
        step = 2e-7 * abs(number["value"])
        above, below = (of_plan(bentur.run(case.replace({number["path"]: number["value"] + h}), histories=False)) for h in (step, -step))
        for key, peak in peaks:
            different = (above[key] - below[key]) / (2 * step) * number["value"] / values[key]
            scale = 1 + max(abs(e) for e in peak["elasticity"] if e is not None)
            assert different == pytest.approx(peak["elasticity"][i], abs=1e-5 * scale), (number["path"], key)
            compared += 1
    assert compared >= 300


SUITE = """
title = "Three records"
[units]
length = "m"
force = "kN"
[[building]]
name = "A"
damping = 0.05
stick = { storey_heights = [3.0, 3.0], masses = [30.0, 25.0], stiffnesses = [9000.0, 8000.0] }
[[building]]
name = "B"
damping = 0.05
stick = { storey_heights = [3.0, 3.0], masses = [30.0, 25.0], stiffnesses = [26000.0, 21000.0] }
[[gap]]
between = ["A", "B"]
width = 0.02
contact = { law = "linear", stiffness = 1e5 }
[excitation]
kind = "suite"
files = [FILES]
scale = "en-1998-1"
target = { shape = "en-1998-1", ground_acceleration = "0.3 g", ground_type = "C", spectrum_type = 1 }
"""


@pytest.mark.parametrize("count, takes", [(4, "largest"), (7, "mean")])
def test_of_a_suite_each_record_and_what_its_code_takes(tmp_path, count, takes):
    random = np.random.default_rng(3)
    for r in range(count):
        t = np.arange(300) * 0.02
        values = np.convolve(random.normal(size=300), np.ones(4) / 4, "same") * np.exp(-(((t - 3) / 2) ** 2))
        np.savetxt(tmp_path / f"r{r}.txt", np.column_stack([t, 4 * values]))
    files = ", ".join(f'{{ file = "r{r}.txt", unit = "m/s2" }}' for r in range(count))
    suite = SUITE.replace("FILES", files)
    file = tmp_path / "suite.toml"
    file.write_text(suite)
    printed = subprocess.run([os.environ["BENTUR_PROGRAM"], "sensitivity", str(file), "--json"], capture_output=True, text=True)
    assert printed.returncode == 0, printed.stderr
    told = json.loads(printed.stdout)
    found = bentur.sensitivity(file)
    assert found["peaks"] == told["peaks"] and found["records"] == told["records"]
    assert found["takes"] == takes and len(found["records"]) == count
    paths = [one["path"] for one in found["numbers"]]
    scale, width = paths.index("excitation.scale"), paths.index("gap[0].width")
    assert found["numbers"][scale]["value"] == 1
    assert any("how the suite is chosen" in one["why"] for one in found["left_out"])

    def needs(peaks):
        return [one for one in peaks if one["quantity"] == "gap_needed"]

    of_records = [needs(one["peaks"]) for one in found["records"]]
    for i, peak in enumerate(needs(found["peaks"])):
        values = np.array([one[i]["value"] for one in of_records])
        gradients = np.array([one[i]["gradient"] for one in of_records])
        if takes == "mean":
            assert peak["value"] == pytest.approx(values.mean(), rel=1e-12) and peak["time"] is None
            np.testing.assert_allclose(peak["gradient"], gradients.mean(axis=0), rtol=1e-9, atol=1e-15)
        else:
            assert peak["value"] == values.max() and peak["record"] == found["records"][values.argmax()]["record"]
            np.testing.assert_array_equal(peak["gradient"], gradients[values.argmax()])
        # The response without contact grows as its records do.
        assert peak["elasticity"][scale] == pytest.approx(1, rel=1e-9)
    # What a record gives is what the run of that record changes by, scaled as it is: the band of periods that a code
    # scales by follows the buildings, which the derivative leaves out.
    path, h = "building[0].stick.stiffnesses[0]", 9e-3
    for number in (1, count):
        motion = bentur.run(bentur.Case.from_file(file), record=number, histories=False).summary["excitation"]
        alone = {"kind": "record", "file": str(tmp_path / f"r{number - 1}.txt"), "unit": "m/s2", "scale": motion["pga"] / motion["pga_read"]}
        case = bentur.Case.from_file(file).replace({"excitation": alone})

        def runs(value, case=case):
            gap = bentur.run(case.replace({path: value}), histories=False).summary["gaps"][0]
            return np.array([point["gap_needed"] for point in gap["points"]])

        different = (runs(9000 + h) - runs(9000 - h)) / (2 * h)
        ours = [one["gradient"][paths.index(path)] for one in needs(found["records"][number - 1]["peaks"])]
        assert np.max(np.abs(different - ours)) < 1e-5 * np.max(np.abs(different))
    words = subprocess.run([os.environ["BENTUR_PROGRAM"], "sensitivity", str(file), "--lang", "id"], capture_output=True, text=True)
    assert ("rata-rata" if takes == "mean" else "terbesar") in words.stdout and words.returncode == 0


def test_of_pairs_each_direction_has_its_scale(tmp_path):
    """Of buildings in plan: without contact all grows as both do."""
    random = np.random.default_rng(3)
    for r in range(8):
        t = np.arange(300) * 0.02
        values = np.convolve(random.normal(size=300), np.ones(4) / 4, "same") * np.exp(-(((t - 3) / 2) ** 2))
        np.savetxt(tmp_path / f"r{r}.txt", np.column_stack([t, 4 * values]))
    files = [", ".join(f'{{ file = "r{2 * k + y}.txt", unit = "m/s2" }}' for k in range(4)) for y in (0, 1)]
    plan = "storey_heights = [3.0, 3.0], masses = [30.0, 25.0]"
    (tmp_path / "suite.toml").write_text(f"""
units = {{ length = "m", force = "kN" }}
plan = {{ clearance = 0.1, contact = {{ law = "linear", stiffness = 1e5 }} }}
[[building]]
name = "A"
damping = 0.05
plan = {{ corner = [0.0, 0.0], size = [10.0, 12.0], {plan} }}
rigidity = {{ centre = [4.0, 6.0], x = 9e3, y = 9e3, torsion = 4e5 }}
[[building]]
name = "B"
damping = 0.05
plan = {{ corner = [10.02, 2.0], size = [10.0, 13.0], {plan} }}
rigidity = {{ centre = [5.0, 6.0], x = 2e4, y = 1e4, torsion = 8e5 }}
[excitation]
kind = "suite"
files = [{files[0]}]
scale = "en-1998-1"
target = {{ shape = "en-1998-1", ground_acceleration = "0.3 g", ground_type = "C", spectrum_type = 1 }}
[excitation.y]
kind = "suite"
files = [{files[1]}]
""")
    found = bentur.sensitivity(tmp_path / "suite.toml")
    paths = [number["path"] for number in found["numbers"]]
    x, y = paths.index("excitation.scale"), paths.index("excitation.y.scale")
    assert found["numbers"][x]["value"] == found["numbers"][y]["value"] == 1
    needs = [peak for peak in found["peaks"] if peak["quantity"] == "gap_needed"]
    assert len(needs) == 4
    for peak in needs:
        assert peak["elasticity"][x] + peak["elasticity"][y] == pytest.approx(1, abs=1e-8)
        assert abs(peak["elasticity"][y]) > 1e-3


def test_the_report_of_results_finds_its_record(tmp_path):
    """Beside the results, by its hash; another record of that name is none."""
    program = os.environ["BENTUR_PROGRAM"]
    subprocess.run([program, "example", "m12-el-centro", "-o", str(tmp_path)], check=True, capture_output=True)
    case = next(tmp_path.rglob("m12-el-centro.toml"))

    def section(what, name):
        page = tmp_path / name
        subprocess.run([program, "report", str(what), "-o", str(page)], check=True, capture_output=True, cwd=tmp_path)
        text = page.read_text()
        start = text.find('<section id="sensitivity">')
        return text[start : text.find("</section>", start)] if start >= 0 else ""

    subprocess.run([program, "run", str(case), "-o", str(case.parent / "out"), "-q"], check=True, capture_output=True)
    of_case = section(case, "case.html")
    assert of_case and section(case.parent / "out", "results.html") == of_case
    record = next(tmp_path.rglob("el-centro*.csv"))
    record.write_text(record.read_text().replace("0.", "1.", 1))
    assert section(case.parent / "out", "other.html") == ""
