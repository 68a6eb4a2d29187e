"""Cases from files, texts and classes; results; records; own laws; Ctrl-C and threads."""

import concurrent.futures
import ctypes
import hashlib
import math
import multiprocessing
import os
import pickle
import signal
import threading
import time

import doors
import numpy as np
import pytest

import bentur
from cases import pair
from refused import refused

try:
    import scipy
except ImportError:
    scipy = None


def same(a, b):
    def numbers(result):
        summary = doors.numbers(result.summary)
        summary["excitation"] = {k: v for k, v in summary["excitation"].items() if k not in ("sha256", "size")}
        return summary

    return numbers(a) == numbers(b)


def test_classes_give_the_numbers_of_the_readme():
    result = bentur.run(pair())
    point = result.summary["gaps"][0]["points"][0]
    assert point["impacts"] == 20  # as the README's program prints
    assert f"{point['peak_force'] / 1e3:.0f}" == "3338"
    assert f"{1e3 * point['gap_needed']:.1f}" == "82.5"


@pytest.mark.parametrize("name", bentur.examples())
def test_a_case_made_of_its_tables_is_the_same(name):
    case = bentur.example(name)
    again = bentur.Case.from_dict(case.to_dict(), folder=case.folder)
    assert same(bentur.run(case, histories=False), bentur.run(again, histories=False))


def test_errors_come_all_at_once_with_their_places():
    text = bentur.example("kelvin-voigt-pair").text.replace("restitution = ", "restitutoin = ")
    with pytest.raises(bentur.CaseError) as caught:
        bentur.Case.from_text(text.replace("damping = 0.05", "damping = 5", 1), name="mine.toml")
    errors = caught.value.errors
    assert len(errors) >= 2
    assert all(one.file == "mine.toml" and one.line > 0 and one.column > 0 for one in errors)
    assert any('did you mean "restitution"?' in one.message for one in errors)
    assert any(one.key.endswith(".damping") for one in errors)


def test_errors_of_a_case_made_in_python_have_its_keys():
    stick = bentur.Stick(storey_heights=[3.0, 3.0], masses=[1e5], stiffnesses=[4e6, -1.0])
    with pytest.raises(bentur.CaseError) as caught:
        pair(building=[bentur.Building(name="A", damping=0.05, stick=stick), {"name": "B", "dampin": 0.05}])
    keys = {one.key for one in caught.value.errors}
    assert {'building["A"].stick.masses', 'building["A"].stick.stiffnesses[1]', 'building["B"].dampin'} <= keys
    assert all(one.line == 0 for one in caught.value.errors)
    assert isinstance(pickle.loads(pickle.dumps(caught.value)).errors[0], bentur.Finding)


def test_errors_have_the_keys_that_the_program_tells():
    folder = refused()
    keys = []
    for file in sorted(folder.glob("*.toml")):
        with pytest.raises(bentur.CaseError) as caught:
            bentur.Case.from_file(file)
        for one in caught.value.errors:
            keys.append(f"{file.name}: {one.key}".rstrip())
            value = "" if not one.value else f" is {one.value}," if one.value.startswith("a ") else f" = {one.value},"
            assert one.message.startswith(one.key + value), one
            told = one.suggestion if one.suggestion and one.value else one.rule
            assert told in one.message and one.suggestion in one.message, one
    assert keys == (folder / "keys.txt").read_text().splitlines()


def test_a_message_without_a_key_has_none(tmp_path):
    case = bentur.example("kelvin-voigt-pair")
    text = case.text
    keys = {}
    for wrong in (text + "\nthis is not TOML", text.replace("[[gap]]", "[[gpa]]"), 'title = "nothing"'):
        with pytest.raises(bentur.CaseError) as caught:
            bentur.Case.from_text(wrong, folder=case.folder)
        keys |= {one.message.split(",")[0]: one.key for one in caught.value.errors}
    (tmp_path / "empty.txt").write_text("no number\n")
    with pytest.raises(bentur.CaseError) as caught:
        bentur.read_record(tmp_path / "empty.txt", time_step=0.01)
    keys |= {one.message: one.key for one in caught.value.errors}
    with pytest.raises(bentur.CaseError, match="over the limit") as caught:
        bentur.run(pair(analysis={"duration": 10.0, "limits": {"memory": 1e-6}}))
    keys |= {one.message: one.key for one in caught.value.errors}
    told = {key for key in keys.values() if key}
    assert told == {"gpa", "gap", "building", "excitation"}, keys
    assert sorted(message.split()[0] for message, key in keys.items() if not key) == ["a", "holds", "not"], keys


def test_a_value_of_another_type_is_told_by_its_key():
    with pytest.raises(TypeError, match=r"gap\[0\]\.width is a object"):
        pair(gap=[{"between": ["soft", "stiff"], "width": object()}])


def test_replace():
    case = pair()
    wide = case.replace({"gap[0].width": 0.2, 'building["soft"].stick.masses[0]': 2e5})
    assert bentur.run(wide).impact_count == 0
    assert case.to_dict()["gap"][0]["width"] == 0.02
    with pytest.raises(bentur.CaseError, match="gap.0..width = -1, must be >= 0"):
        case.replace({"gap[0].width": -1})
    with pytest.raises(bentur.CaseError, match="gap"):
        case.replace({"gap[3].width": 1})
    with pytest.raises(bentur.CaseError, match="gap"):
        case.replace({"gap[x].contact": {"law": "linear", "stiffness": 1e8}})
    with pytest.raises(bentur.CaseError, match="gap.0..width = \"own\", must be a number"):
        case.replace({"gap[0].width": bentur.ForceLaw(force=hertz)})


def test_replaced_cases_share_what_is_alike_and_see_what_has_changed(tmp_path):
    """Records and buildings that stay are not read again: results are those of the case as a file all the same, with
    the hash of the record, and a record that is written anew is read anew, at once or much later."""
    def write(scale):
        text = "".join(f"{scale * math.sin(0.2 * i):+.6f}\n" for i in range(400))
        (tmp_path / "record.txt").write_text(text)
        return hashlib.sha256(text.encode()).hexdigest()

    hashes = [write(scale) for scale in (1, 2, 3, 4)]
    write(1)
    motion = bentur.Excitation(kind="record", file=str(tmp_path / "record.txt"), unit="m/s2", time_step=0.02)
    case = pair(excitation=motion)

    def told(width):
        made = case.replace({"gap[0].width": width})
        return made, bentur.run(made).summary["excitation"]

    for scale in (2, 3):  # at once, and of one size
        write(scale)
        assert told(0.01)[1]["sha256"] == hashes[scale - 1]
    time.sleep(2.5)
    for width in (0.01, 0.02):
        made, excitation = told(width)
        assert excitation["sha256"] == hashes[2] and excitation["pga_read"] == pytest.approx(3, rel=1e-2)
        again = bentur.Case.from_text(made.to_toml())
        assert same(bentur.run(made), bentur.run(again))
    write(4)
    assert told(0.02)[1]["sha256"] == hashes[3]


def test_a_component_is_named_and_what_the_heading_says_is_held_against_arguments(tmp_path):
    file = tmp_path / "three.csv"
    file.write_text("Time (ms);N-S (cm/s2);E-W (cm/s2)\n0;1.5;2.5\n10;-2.5;1.5\n20;0.5;0.25\n")
    record = bentur.read_record(file, component="north")
    assert (record.unit, record.time_step, record.channel) == ("cm/s2", 0.01, "column 2 of 3 (N-S (cm/s2))")
    assert record.values.tolist() == [1.5, -2.5, 0.5]
    with pytest.raises(bentur.CaseError, match='has no component "Up", but "N-S'):
        bentur.read_record(file, component="Up")
    with pytest.raises(bentur.CaseError, match="time_step is 0.02 s, but the file says 0.01 s"):
        bentur.read_record(file, component="N-S", time_step=0.02)
    with pytest.raises(ValueError, match='unit is g but the file says "cm/s2"'):
        bentur.response_spectrum(record, unit="g")


def test_a_record_given_as_an_array_is_the_record_of_the_file():
    case = bentur.example("m12-el-centro")
    tables = case.to_dict()
    record = bentur.read_record(case.folder / tables["excitation"].pop("file"))
    tables["excitation"] |= {"values": record.values, "time_step": record.time_step}
    again = bentur.Case.from_dict(tables)
    a, b = bentur.run(case), bentur.run(again)
    assert a.summary["buildings"] == b.summary["buildings"]
    assert a.summary["gaps"] == b.summary["gaps"]
    assert same(b, bentur.run(pickle.loads(pickle.dumps(again))))
    times, values = again.acceleration
    still = again.replace({"excitation": {"kind": "harmonic", "period": 0.5, "displacement_amplitude": 0.02}})
    assert same(bentur.run(still), bentur.run(pickle.loads(pickle.dumps(still))))
    assert len(times) == len(values) == 1560 and np.abs(values).max() == pytest.approx(341.7, rel=1e-15)


def test_errors_of_a_record_given_as_an_array_name_no_file():
    def motion(**more):
        return {"kind": "record", "values": [0.0, 1.0, 0.5], "time_step": 0.01, "unit": "m/s2", **more}

    bad = motion(values=[0.0, float("nan"), 0.5]), motion(unit=None), motion(time_step=None), motion(values=[])
    for one in bad:
        with pytest.raises(bentur.CaseError) as caught:
            pair(excitation=one)
        assert "excitation" in str(caught.value) and "bentur-" not in str(caught.value), str(caught.value)
    with pytest.raises(bentur.CaseError) as caught:
        pair(excitation=motion()).replace({"excitation.unit": "parsec"})
    assert "bentur-" not in str(caught.value)


def test_a_record_given_as_an_array_leaves_the_folder_to_other_files(tmp_path):
    pytest.importorskip("xarray")
    (tmp_path / "shapes.csv").write_text("mode 1\n1.0\n")
    modal = {"elevations": [3.0], "masses": [1e5], "periods": [0.5], "shapes_file": "shapes.csv"}
    tables = pair().to_dict()
    tables["building"][0] = {"name": "soft", "damping": 0.05, "modal": modal}
    tables["excitation"] = {"kind": "record", "unit": "m/s2", "time_step": 0.01, "values": np.sin(np.arange(500) / 8)}
    case = bentur.Case.from_dict(tables, folder=tmp_path)
    assert case.folder == tmp_path
    result = bentur.run(case)
    assert same(result, bentur.run(pickle.loads(pickle.dumps(case))))
    varied = bentur.vary(case, {"gap[0].width": [0.0, 0.02]})
    assert float(varied.peak_force.sel(width=0.02).squeeze()) == result.summary["gaps"][0]["points"][0]["peak_force"]


def test_files_that_vary_are_relative_to_the_case(tmp_path, monkeypatch):
    pytest.importorskip("xarray")
    (tmp_path / "records").mkdir()
    times = np.arange(500) / 100
    for name, scale in (("weak.txt", 1.0), ("strong.txt", 2.0)):
        np.savetxt(tmp_path / "records" / name, np.column_stack([times, scale * np.sin(times / 0.08)]))
    tables = pair().to_dict()
    tables["excitation"] = {"kind": "record", "unit": "m/s2", "file": "records/weak.txt"}
    case = bentur.Case.from_dict(tables, folder=tmp_path)
    monkeypatch.chdir(tmp_path.parent)
    found = bentur.vary(case, {"excitation.file": ["records/weak.txt", "records/strong.txt"]})
    assert found.file.values.tolist() == ["records/weak.txt", "records/strong.txt"]
    assert found.peak_ground_acceleration.values.tolist() == pytest.approx([1.0, 2.0], rel=1e-3)
    both = [{"kind": "record", "unit": "m/s2", "file": tmp_path / "records" / n} for n in ("weak.txt", "strong.txt")]
    whole = bentur.vary(case, {"excitation": both}, labels={"excitation": ["a", "b"]})
    assert whole.peak_force.values.tolist() == found.peak_force.values.tolist()


def test_arrays_are_views_that_cannot_be_written_and_outlive_the_result():
    result = bentur.run(pair())
    moved = result.histories["displacement"][0]
    assert moved.shape == (1001, 1) and not moved.flags.owndata and not moved.flags.writeable
    largest = np.abs(moved).max()
    del result
    assert np.abs(moved).max() == largest
    peaks = bentur.run(pair()).summary["buildings"][0]["peak_displacement"]
    assert largest <= peaks[0]


def test_the_exact_course_has_every_impact_and_the_peak():
    result = bentur.run(pair())
    exact, points = result.exact, result.summary["gaps"][0]["points"]
    assert exact["force"][:, 0].max() == pytest.approx(points[0]["peak_force"], rel=1e-12)
    area = np.sum(np.diff(exact["time"]) * (exact["force"][1:, 0] + exact["force"][:-1, 0]) / 2)
    assert area == pytest.approx(points[0]["impulse"], rel=1e-3)  # as docs/result-files.md promises
    assert [values.shape for values in exact["displacement"]] == [(len(exact["time"]), 1)] * 2
    assert "drift_ratio" not in exact and not exact["opening"].flags.writeable
    with pytest.raises(ValueError, match="histories=True"):
        bentur.run(pair(), histories=False).exact  # noqa: B018


def test_the_exact_course_with_units():
    pytest.importorskip("xarray")
    found = bentur.run(bentur.example("yielding-pair")).exact_dataset
    assert found.force.attrs["units"] == "N" and found.displacement_1.dims == ("time", "elevation_1")
    assert "storey_shear_1" in found and "elevation_1" in found.coords and "point_left" in found.coords


def test_save(tmp_path):
    written = bentur.run(bentur.example("row-of-three")).save(tmp_path / "results")
    assert {file.name for file in written} >= {"summary.json", "impacts.csv", "case.toml"}
    assert not list(tmp_path.glob("**/*.new"))


def test_report_and_notebook(monkeypatch):
    result = bentur.run(pair())
    page = result.report("id")
    assert page.startswith("<!DOCTYPE html>") or page.startswith("<!doctype html>")
    shown = result._repr_html_()
    assert shown.startswith("<iframe srcdoc=") and shown.count('"') == 8
    bare = bentur.run(pair(), histories=False)
    motion = bare.report("id")
    monkeypatch.delattr(bentur._core, "solve")  # what has been shown is not solved again
    assert result._repr_html_() == shown and bare.report("id") == motion and "<iframe" in bare._repr_html_()


def test_limits_refuse_before_any_work():
    with pytest.raises(bentur.CaseError, match="over the limit"):
        bentur.run(pair(analysis={"duration": 10.0, "limits": {"memory": 1e-6}}))


def hertz(penetration, speed):
    return 2e9 * penetration**1.5


def test_a_force_of_python_is_the_law_it_copies():
    inner = pair(analysis={"duration": 3.0, "solver": "adaptive", "tolerance": 1e-11})
    own = inner.replace({"gap[0].contact": bentur.ForceLaw(force=hertz, name="mine")})
    expected = bentur.run(inner.replace({"gap[0].contact": {"law": "hertz", "stiffness": 2e9}}))
    found = bentur.run(own)
    a, b = (r.summary["gaps"][0]["points"][0] for r in (expected, found))
    assert b["contact"]["law"] == "mine"
    assert a["impacts"] == b["impacts"] > 0
    for key in ("peak_force", "peak_penetration", "impulse", "contact_duration"):
        assert a[key] == pytest.approx(b[key], rel=1e-6)
    # what a spring gives back is the work of its force, here by quadrature
    assert abs(b["energy_lost"]) < 1e-6 * 0.4 * b["peak_force"] * b["peak_penetration"]


def test_a_compiled_force_is_the_function_it_was_made_of():
    two = ctypes.CFUNCTYPE(ctypes.c_double, ctypes.c_double, ctypes.c_double)(hertz)
    one = ctypes.CFUNCTYPE(ctypes.c_double, ctypes.c_double)(lambda d: 0.8e9 * d**2.5)
    compiled = [two, type("FromNumba", (), {"ctypes": two})()]
    if scipy is not None:
        compiled.append(scipy.LowLevelCallable(two))
    expected = bentur.run(pair().replace({"gap[0].contact": bentur.ForceLaw(force=hertz, energy=lambda d: 0.8e9 * d**2.5)}))
    for force in compiled:
        found = bentur.run(pair().replace({"gap[0].contact": bentur.ForceLaw(force=force, energy=one)}))
        assert found.impacts.equals(expected.impacts) and len(found.impacts) > 0
    with pytest.raises(TypeError, match="argtypes"):
        pair().replace({"gap[0].contact": bentur.ForceLaw(force=one)})
    if scipy is not None:
        with pytest.raises(TypeError, match=r"must be 'double \(double, double\)'"):
            pair().replace({"gap[0].contact": bentur.ForceLaw(force=scipy.LowLevelCallable(one))})


def test_what_a_force_raises_is_raised():
    def broken(penetration, speed):
        raise ZeroDivisionError("mine")

    with pytest.raises(ZeroDivisionError, match="mine"):
        bentur.run(pair().replace({"gap[0].contact": bentur.ForceLaw(force=broken)}))
    with pytest.raises(TypeError, match="must be a number"):
        bentur.run(pair().replace({"gap[0].contact": bentur.ForceLaw(force=lambda d, v: "much")}))


def test_branches_are_exact():
    """Kelvin and Voigt's contact with release at zero force, as branches: the same to round-off."""
    mass = 1e5 * 1e5 / 2e5
    damping = 2 * 0.1 * np.sqrt(1e8 * mass)
    touching = bentur.Branch(
        stiffness=1e8,
        damping=damping,
        guards=[bentur.Guard(deformation=1e8, speed=damping, then=2)],
    )
    # the force is zero until the surfaces are apart, or until it would push again
    free = bentur.Branch(
        guards=[bentur.Guard(deformation=1.0, then=0), bentur.Guard(deformation=-1e8, speed=-damping, then=1)],
        unloading_stiffness=1e8,
    )
    own = bentur.BranchLaw(branches=[touching, free])
    expected = bentur.run(pair(gap=[{"between": ["soft", "stiff"], "width": 0.02,
                                     "contact": {"law": "kelvin-voigt", "stiffness": 1e8, "damping_ratio": 0.1}}]))
    found = bentur.run(pair().replace({"gap[0].contact": own}))
    a, b = (r.summary["gaps"][0]["points"][0] for r in (expected, found))
    assert a["impacts"] == b["impacts"] > 0
    for key in ("peak_force", "peak_penetration", "impulse"):
        assert a[key] == pytest.approx(b[key], rel=1e-9)


def test_branches_that_cannot_be_are_refused():
    with pytest.raises(ValueError, match="branches"):
        pair().replace({"gap[0].contact": bentur.BranchLaw(branches=[])})
    with pytest.raises(ValueError, match="then = 4"):
        pair().replace({"gap[0].contact": bentur.BranchLaw(branches=[bentur.Branch(guards=[bentur.Guard(then=4)])])})


def linked(law, **more):
    link = bentur.Link(between=["soft", "stiff"], elevations=[3.0], law=law, **more)
    return pair(link=[link], analysis={"duration": 5.0, "energy_audit": True})


def yielding(hysteresis, **more):
    stick = bentur.Stick(storey_heights=[3.0, 3.0], masses=[1e5, 8e4], stiffnesses=[9e6, 6e6], yield_forces=[1e5, 4e4],
                         hysteresis=hysteresis, **more)
    building = [bentur.Building(name="soft", damping=0.05, stick=stick),
                {"name": "stiff", "damping": 0.05,
                 "stick": {"storey_heights": [3.0], "masses": [1e5], "stiffnesses": [9e6]}}]
    return pair(building=building, analysis={"duration": 5.0, "energy_audit": True})


def hardening(ratio):
    """Kinematic hardening, in units of yield force and yield deformation."""
    def to(branch, sign):  # while V stays inside r Δ ± (1 − r)
        return bentur.Guard(constant=1 - ratio, force=-sign, deformation=sign * ratio, then=branch)

    def line(sign):
        return bentur.Branch(base=sign * (1 - ratio), stiffness=ratio, guards=[bentur.Guard(speed=sign, then=1)],
                             unloading_stiffness=1.0)

    elastic = bentur.Branch(base=None, stiffness=1.0, guards=[to(2, 1), to(3, -1)])
    return bentur.BranchLaw(branches=[elastic, line(1), line(-1)], name="mine")


def test_a_link_of_ones_own_is_the_one_it_copies():
    expected = bentur.run(linked("spring-dashpot", stiffness=2e6, damping=3e4))
    law = bentur.BranchLaw(branches=[bentur.Branch(stiffness=2e6, damping=3e4)], name="mine")
    found = bentur.run(linked(law))
    assert found.summary["links"][0]["points"][0]["link"]["law"] == "mine"
    a, b = (one.summary["links"][0]["points"][0] for one in (expected, found))
    assert a["peak_compression"] == b["peak_compression"] > 0 and a["energy_dissipated"] == b["energy_dissipated"] > 0
    assert expected.summary["buildings"] == found.summary["buildings"]
    # a cable: two branches, of which the first has no force
    cable = bentur.BranchLaw(branches=[bentur.Branch(guards=[bentur.Guard(constant=0.01, deformation=1.0, then=2)]),
                                       bentur.Branch(base=2e4, stiffness=2e6,
                                                     guards=[bentur.Guard(constant=-0.01, deformation=-1.0, then=1)])])
    expected, found = bentur.run(linked("cable", stiffness=2e6, slack=0.01)), bentur.run(linked(cable))
    assert expected.summary["links"][0]["points"][0]["peak_tension"] > 0
    assert expected.summary["buildings"] == found.summary["buildings"]


@pytest.mark.parametrize("ratio", [0.0, 0.1])
def test_storeys_of_ones_own_are_those_they_copy(ratio):
    expected = bentur.run(yielding("bilinear", hardening=ratio))
    found = bentur.run(yielding(hardening(ratio)))
    assert expected.summary["buildings"][0]["ductility"][0] > 2  # both storeys yield, many times
    for key in ("ductility", "residual_drift_ratio", "peak_displacement", "peak_storey_shear"):
        a, b = (one.summary["buildings"][0][key] for one in (expected, found))
        assert a == pytest.approx(b, rel=1e-9), key
    assert found.summary["solver"]["energy_residual"] < 1e-9
    if ratio == 0:  # else a law of one's own gives back what its unloading stiffness says, without the hardening
        a, b = (one.summary["buildings"][0]["hysteretic_energy"] for one in (expected, found))
        assert a == pytest.approx(b, rel=1e-9)
    assert same(found, bentur.run(pickle.loads(pickle.dumps(found.case))))


def test_laws_of_ones_own_that_cannot_stand_there_are_refused():
    of_contacts = bentur.ForceLaw(force=hertz, name="mine")
    for make, key in ((linked, "link[0].law"), (yielding, 'building["soft"].stick.hysteresis')):
        with pytest.raises(bentur.CaseError) as caught:
            make(of_contacts)
        assert str(caught.value).startswith(f'error: {key} = "mine", is a law of contacts alone')
    with pytest.raises(bentur.CaseError, match="branches.0. = another line, must be F = δ in a storey"):
        yielding(bentur.BranchLaw(branches=[bentur.Branch(stiffness=2.0)]))
    with pytest.raises(bentur.CaseError, match="then = 0, must be the number of a branch, from 1 to 1"):
        linked(bentur.BranchLaw(branches=[bentur.Branch(guards=[bentur.Guard(then=0)])]))
    with pytest.raises(bentur.CaseError, match="hardening.* is not for a law of one's own"):
        yielding(hardening(0.1), hardening=0.1)
    with pytest.raises(ValueError, match='name = "cable", is that of a law'):
        linked(bentur.BranchLaw(name="cable", branches=[bentur.Branch(stiffness=1e5)]))
    with pytest.raises(bentur.CaseError, match='stiffness .*is not for law = "mine"'):
        linked(hardening(0.1), stiffness=1.0)


def long_case():
    return pair(analysis={"duration": 2e5, "output_step": 1.0, "solver": "adaptive", "limits": {"steps": 1e12}})


@pytest.fixture
def ctrl_c():
    """Where a shell has started this in the background SIGINT is ignored, and Python leaves it so."""
    before = signal.signal(signal.SIGINT, signal.default_int_handler)
    timer = threading.Timer(0.5, os.kill, (os.getpid(), signal.SIGINT))
    yield timer
    timer.join()
    signal.signal(signal.SIGINT, before)


def test_ctrl_c_stops_a_run(ctrl_c):
    with pytest.raises(KeyboardInterrupt):  # to its end it would take minutes
        ctrl_c.start()
        bentur.run(long_case(), histories=False)


def test_the_lock_is_released():
    steps = []
    done = threading.Event()

    def count():
        while not done.is_set():
            steps.append(None)
            time.sleep(0.001)

    def stop(fraction):
        if len(steps) > 50:
            raise InterruptedError

    thread = threading.Thread(target=count)
    thread.start()
    try:
        with pytest.raises(InterruptedError):
            bentur.run(long_case(), histories=False, progress=stop)
    finally:
        done.set()
        thread.join()
    with concurrent.futures.ThreadPoolExecutor(2) as pool:
        results = list(pool.map(lambda _: bentur.run(pair()), range(8)))
    assert all(same(one, results[0]) for one in results)


def test_a_name_that_is_taken_in_the_results_is_refused(tmp_path):
    pytest.importorskip("xarray")
    study = tmp_path / "study.toml"
    case = bentur.example().folder / "m12-el-centro.toml"
    study.write_text(f'case = "{case}"\n[[vary]]\nparameter = "gap[0].width"\nname = "impacts"\nvalues = [0.1, 0.2]\n')
    with pytest.raises(bentur.CaseError, match='"impacts" is the name of something else'):
        bentur.sweep(study)


def test_ctrl_c_stops_a_sweep(ctrl_c):
    pytest.importorskip("xarray")
    case = long_case().replace({"analysis.duration": 2e4})
    ctrl_c.start()
    with pytest.raises(KeyboardInterrupt):  # to their end they would take hours
        bentur.vary(case, {"gap[0].width": np.linspace(0, 0.1, 400)}, threads=2)


def test_vary():
    pytest.importorskip("xarray")
    found = bentur.vary(pair(), {"gap[0].width": [0.0, 0.02, 0.2], "building[0].damping": np.array([0.02, 0.05])})
    assert dict(found.sizes) | {"width": 3, "damping": 2} == dict(found.sizes)
    expected = bentur.run(pair()).summary["gaps"][0]["points"][0]["peak_force"]
    assert float(found.peak_force.sel(width=0.02, damping=0.05).squeeze()) == expected
    assert found.peak_force.attrs["units"] == "N"


def test_laws_of_ones_own_vary():
    pytest.importorskip("xarray")
    laws = [bentur.ForceLaw(force=hertz, name="mine"), {"law": "linear", "stiffness": 1e8}]
    found = bentur.vary(pair(), {"gap[0].contact": laws, "gap[0].width": [0.0, 0.02]},
                        labels={"gap[0].contact": ["mine", "linear"]}, threads=2)
    for label, law in zip(("mine", "linear"), laws, strict=True):
        expected = bentur.run(pair().replace({"gap[0].contact": law})).summary["gaps"][0]["points"][0]["peak_force"]
        assert float(found.peak_force.sel(contact=label, width=0.02).squeeze()) == expected
    dampers = [bentur.BranchLaw(name=str(c), branches=[bentur.Branch(damping=c)]) for c in (1e4, 1e5)]
    forces = bentur.vary(linked(dampers[0]), {"link[0].law": dampers}).link_peak_compression
    assert forces.law.values.tolist() == ["10000.0", "100000.0"] and len(set(forces.values.ravel())) == 2

    def broken(penetration, speed):
        raise ZeroDivisionError("mine")

    with pytest.raises(ZeroDivisionError, match="mine"):
        bentur.vary(pair(), {"gap[0].contact": [bentur.ForceLaw(force=broken)]})


def stiffening(penetration, speed):
    return 4e7 * penetration**1.5 * (1 + 0.1 * speed)


def impacts_of(case):
    return bentur.run(case).impact_count


def test_a_law_of_ones_own_goes_to_other_processes():
    case = pair().replace({"gap[0].contact": bentur.ForceLaw(force=stiffening)})
    again = pickle.loads(pickle.dumps(case))
    assert bentur.run(case).impact_count > 0
    assert same(bentur.run(case), bentur.run(again))
    widths = [0.0, 0.02]
    with concurrent.futures.ProcessPoolExecutor(2, multiprocessing.get_context("spawn")) as pool:
        counts = list(pool.map(impacts_of, [case.replace({"gap[0].width": width}) for width in widths]))
    assert counts == [bentur.run(case.replace({"gap[0].width": width})).impact_count for width in widths]
    with pytest.raises((pickle.PicklingError, AttributeError), match="lambda"):
        pickle.dumps(pair().replace({"gap[0].contact": bentur.ForceLaw(force=lambda d, v: 1e8 * d)}))
