"""Cases that can be kept, results that say what was run, and both across processes."""

import concurrent.futures
import copy
import json
import multiprocessing
import pickle
import shutil
import subprocess
import sys

import doors
import numpy as np
import pytest

import bentur
from cases import pair


def shaken(values=None, **more):
    values = np.sin(np.arange(500) / 8) if values is None else values
    return pair(excitation=bentur.Excitation(kind="record", values=values, time_step=0.01, unit="m/s2", **more))


def numbers(result):
    return doors.numbers(result.summary)


@pytest.mark.parametrize("name", bentur.examples())
def test_what_is_written_reads_back(name, tmp_path):
    case = bentur.example(name)
    assert case.to_toml() == case.text
    again = bentur.Case.from_text(bentur._core.toml_file(case.to_dict()), folder=case.folder)
    assert again == case and hash(again) == hash(case)
    saved = bentur.Case.from_file(case.save(tmp_path / "saved.toml"))  # files are found from there
    run = bentur.run
    if case.excitation.kind == "spectrum":
        run = bentur.minimum_gap
        assert doors.numbers(run(saved)) == doors.numbers(run(case))
    elif case.excitation.kind != "suite":
        a, b = (doors.numbers(run(one).summary) for one in (case, saved))
        assert list(doors.differences(a, b)) == []


def test_a_case_made_in_python_goes_to_the_command_line(program, tmp_path):
    for case in (pair(), shaken(), shaken(pga="0.3 g", polarity="reversed")):
        file = case.save(tmp_path / "case.toml")
        told = json.loads(subprocess.run([program, "run", file, "--json"], check=True, capture_output=True, text=True).stdout)
        assert list(doors.differences(doors.numbers(told), numbers(bentur.run(case)))) == []
        assert bentur.Case.from_file(file) == bentur.Case.from_dict(case.to_dict(), folder=tmp_path)


def test_results_say_what_was_run(tmp_path):
    netCDF4 = pytest.importorskip("netCDF4")
    for case in (pair(), bentur.example().replace({"gap[0].width": 0.4}), shaken()):
        result = bentur.run(case)
        written = result.save(tmp_path / "out", force=True)
        assert {file.name for file in written} == {"summary.json", "impacts.csv", "case.toml", "histories.nc"}
        text = (tmp_path / "out" / "case.toml").read_text()
        assert text == case.to_toml()
        summary = json.loads((tmp_path / "out" / "summary.json").read_text())
        assert summary["case"]["file"] == "case.toml" and summary["case"]["copied"]
        assert summary["version"] == bentur.__version__
        with netCDF4.Dataset(tmp_path / "out" / "histories.nc") as file:
            assert text in [file.getncattr(name) for name in file.ncattrs()]
        shutil.rmtree(tmp_path / "out")
    varied = bentur.vary(pair(), {"gap[0].width": [0.0, 0.02]})
    assert varied.attrs["case"] == pair().to_toml() and "bentur_version" in varied.attrs


def test_a_case_reads_back():
    case = pair()
    assert isinstance(case.building[0], bentur.Building) and case.building[0].stick.masses == [1e5]
    assert case.gap[0].contact.law == "linear" and case.excitation.period == 0.5 and case.analysis.duration == 10.0
    assert case.units == bentur.Units() and case.link == [] and case.plan is None and case.project is None
    changed = case.building[0]
    changed.stick.masses = [2e5]
    assert case.building[0].stick.masses == [1e5]  # a case does not change
    assert case.replace({"building[0]": changed}) == case.replace({'building["soft"].stick.masses[0]': 2e5})
    frame = bentur.example("two-frames-si").building[0].frame
    assert isinstance(frame.beams[0], bentur.Section) and isinstance(frame.columns[0], bentur.Section)
    values = shaken().excitation.values
    assert isinstance(values, np.ndarray) and len(values) == 500


@pytest.mark.parametrize("name", bentur.examples())
def test_every_example_reads_back(name):
    case = bentur.example(name)
    tables = "building gap excitation units plan link initial analysis code screening project".split()
    given = {key: getattr(case, key) for key in tables if case.to_dict().get(key) is not None}
    again = bentur.Case(title=case.title or None, folder=case.folder, **given)
    assert again == (case.replace({"units": case.units}) if "units" in given else case)  # these with their defaults


def test_equal_cases():
    assert pair() == pair() and len({pair(), pair()}) == 1
    assert pair() == pair(analysis={"duration": 10})
    assert pair() != pair(analysis={"duration": 11}) and pair() != pair(title="x") and pair() != 3
    assert shaken() == shaken() and shaken() != shaken(np.cos(np.arange(500) / 8))
    law = bentur.BranchLaw(branches=[bentur.Branch(stiffness=1e8, guards=[bentur.Guard(deformation=1.0, then=0)])])
    own = pair().replace({"gap[0].contact": law})
    assert own == pickle.loads(pickle.dumps(own)) and own != pair()
    assert 'law = "own"' in own.to_toml() and "law of Python's own" in own.to_toml()
    with pytest.raises(ValueError, match="no file can say"):
        own.save("never.toml")


@pytest.mark.parametrize("table", [bentur.Stick, bentur.Gap, bentur.Excitation, bentur.Contact])
def test_tables_refuse_names_that_they_do_not_have(table):
    one = bentur.Gap(between=["a", "b"], width=0.1) if table is bentur.Gap else (
        bentur.Excitation(kind="none") if table is bentur.Excitation else (
            bentur.Contact(law="linear") if table is bentur.Contact else
            bentur.Stick(storey_heights=[3.0], masses=[1.0], stiffnesses=[1.0])))
    with pytest.raises(AttributeError, match="mases"):
        one.mases = [3e5]
    with pytest.raises(TypeError, match="mases"):
        table(mases=[3e5])


def test_tables_show_themselves():
    shown = pair().building[0]._repr_html_()
    assert "storey_heights" in shown and "None" not in shown
    assert "<h4>soft | stiff</h4>" in pair()._repr_html_()
    assert "500 values" in shaken()._repr_html_()
    assert "&lt;b&gt;" in pair(title="<b>")._repr_html_()


def test_records_are_values_like_others(monkeypatch):
    pytest.importorskip("xarray")
    a, b = np.sin(np.arange(500) / 8), np.cos(np.arange(500) / 9)
    case = shaken(a)
    assert numbers(bentur.run(case.replace({"excitation.values": b}))) == numbers(bentur.run(shaken(b)))
    whole = bentur.Excitation(kind="record", values=b, time_step=0.01, unit="m/s2")
    assert case.replace({"excitation": whole}) == shaken(b)
    by_values = bentur.vary(case, {"excitation.values": [a, b]}, labels={"excitation.values": ["a", "b"]})
    by_tables = bentur.vary(case, {"excitation": [case.excitation, whole]}, labels={"excitation": ["a", "b"]})
    expected = [bentur.run(one).summary["gaps"][0]["points"][0]["peak_force"] for one in (case, shaken(b))]
    for found in (by_values, by_tables):
        assert found.peak_force.values.ravel().tolist() == expected
    assert bentur.vary(case, {"gap[0].width": [0.02]}).peak_force.values.ravel().tolist() == expected[:1]


def test_a_record_is_one_list():
    two = np.column_stack([np.arange(500) / 100, np.sin(np.arange(500) / 8)])
    for make in (lambda: shaken(two), lambda: shaken().replace({"excitation.values": two})):
        with pytest.raises(bentur.CaseError) as caught:
            make()
        (error,) = caught.value.errors
        assert error.key == "excitation.values" and "500 × 2" in error.message and "values[:, 1]" in error.message
    assert shaken(two[:, 1:]) == shaken(two[:, 1])  # a column is one
    with pytest.raises(bentur.CaseError, match=r"excitation.values\[1\] = nan, must be finite"):
        shaken([0.0, float("nan"), 0.5])
    with pytest.raises(bentur.CaseError, match=r"excitation.values\[1\].*must be a number"):
        shaken([0.0, "a", 0.5])
    with pytest.raises(bentur.CaseError, match="excitation.column is of a file"):
        shaken(column=2)
    with pytest.raises(bentur.CaseError, match="file and values, but these exclude one another"):
        shaken(file="a.csv")


def test_a_result_goes_to_other_processes():
    pytest.importorskip("pandas")
    case = pair()
    expected = bentur.run(case)
    with concurrent.futures.ProcessPoolExecutor(2, multiprocessing.get_context("spawn")) as pool:
        found = list(pool.map(bentur.run, [case, case.replace({"gap[0].width": 0.2})]))
    assert [one.impact_count for one in found] == [expected.impact_count, 0]
    assert numbers(found[0]) == numbers(expected) and str(found[0]) == str(expected)
    assert found[0].impacts.equals(expected.impacts) and found[0].remarks == expected.remarks


@pytest.mark.parametrize("name", ["yielding-pair", "m12-harmonic"])  # with an account of energies, and without
@pytest.mark.parametrize("copied", [copy.copy, copy.deepcopy, lambda one: pickle.loads(pickle.dumps(one))])
def test_copies_of_a_result(copied, name, monkeypatch):
    result = bentur.run(bentur.example(name), output_step=0.02)
    again = copied(result)
    assert again.case == result.case and again.summary == result.summary
    assert np.array_equal(again.histories["force"], result.histories["force"])  # solved anew, the same to the bit
    assert len(again.histories["time"]) == len(result.histories["time"])
    assert again.report() == result.report()
    looked_at = copied(result)
    without = copied(bentur.run(result.case, histories=False))
    monkeypatch.delattr(bentur._core, "solve")
    assert np.array_equal(looked_at.histories["force"], result.histories["force"])
    assert not looked_at.histories["force"].flags.writeable
    with pytest.raises(ValueError, match="histories=True"):
        without.histories  # noqa: B018


def test_histories_are_made_when_they_are_asked_for(monkeypatch):
    solved = []
    solve = bentur._core.solve
    monkeypatch.setattr(bentur._core, "solve", lambda *given: solved.append(given[1]) or solve(*given))
    result = bentur.run(pair())
    assert result.summary["gaps"] and result.impact_count == 20 and str(result) and solved == [0.0]
    at_once = bentur.run(pair(), histories=True)
    assert len(result.histories["time"]) == len(at_once.histories["time"]) == 1001
    assert solved == [0.0, 0.01, 0.01]
    assert numbers(result) == numbers(at_once) == numbers(bentur.run(pair(), histories=False))


def test_a_run_costs_its_solution_and_its_summary():
    """By calls of functions and not by a clock, which other work on the machine moves: bench/python_rates.py has times."""

    def calls_of(function):
        called = []
        sys.setprofile(lambda frame, event, argument: called.append(event) if event in ("call", "c_call") else None)
        try:
            function()
        finally:
            sys.setprofile(None)
        return len(called)

    case = bentur.example()
    bentur.run(case)  # the first run of a case warns of what is remarkable
    assert calls_of(lambda: bentur.run(case).summary) <= 80  # 42, of them 4 of the core
    assert calls_of(lambda: bentur.run(case).histories) > 500
