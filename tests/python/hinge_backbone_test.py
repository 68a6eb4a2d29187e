"""Hinges of a frame that lose strength, in Python: in results and words, in what varies, by every solver."""

import bentur
import pytest

BACKBONE = {"plastic_rotation": 0.004, "softening_rotation": 0.03, "residual": 0.2}


def softening(backbone, solver="exact"):
    member = {"density": 2.4}
    frame = bentur.Frame(elastic_modulus=2.6e7, storey_heights=[3.0, 3.0], bay_widths=[4.0, 6.0], floor_masses=60.0,
                         columns=[{"width": 0.4, "depth": 0.4, **member, "moment_capacity": 120.0, **backbone}],
                         beams=[{"width": 0.3, "depth": 0.5, **member}])
    stick = bentur.Stick(storey_heights=[3.0, 3.0], masses=[60.0, 50.0], stiffnesses=[9e4, 7e4])
    return bentur.Case(units=bentur.Units(length="m", force="kN"),
                       building=[bentur.Building(name="Frame", damping={"mass_proportional": 0.03}, frame=frame),
                                 bentur.Building(name="Stick", damping=0.03, stick=stick)],
                       gap=[bentur.Gap(between=["Frame", "Stick"], width=0.01,
                                       contact=bentur.Contact(law="linear", stiffness=1e5))],
                       excitation=bentur.Excitation(kind="harmonic", period=0.5, displacement_amplitude=0.03),
                       analysis=bentur.Analysis(duration=4.0, solver=solver))


def weakest(run):
    return min(run.summary["buildings"][0]["hinges"], key=lambda hinge: hinge["strength_left"])


def test_hinges_say_what_they_have_left():
    run = bentur.run(softening({"backbone": BACKBONE}))
    hinge = weakest(run)
    assert 0 < hinge["strength_left"] < 1
    assert hinge["cap_time"] > hinge["first_yield"] > 0
    assert hinge["failed_time"] is None and hinge["snap_energy"] >= 0
    assert hinge["peak_rotation"] > BACKBONE["plastic_rotation"]
    assert run.summary["buildings"][0]["peak_displacement"]
    assert "strength_left" not in bentur.run(softening({})).summary["buildings"][0]["hinges"][0]


def test_hinges_that_fail_are_told():
    failing = bentur.run(softening({"backbone": {**BACKBONE, "ultimate_rotation": 0.006}}))
    hinge = weakest(failing)
    assert hinge["strength_left"] == 0 and hinge["failed_time"] >= hinge["cap_time"] and hinge["snap_energy"] > 0


def test_all_solvers_agree():
    one, other = (weakest(bentur.run(softening({"backbone": BACKBONE}, solver))) for solver in ("exact", "adaptive"))
    for name in ("strength_left", "cap_time", "peak_rotation"):
        assert other[name] == pytest.approx(one[name], rel=1e-6)


def test_hinges_wear_by_repetition():
    worn, never = (weakest(bentur.run(softening({"backbone": {**BACKBONE, **wear}})))
                   for wear in ({"strength_wear": 20.0, "wear_exponent": 1.2}, {}))
    assert worn["strength_left"] < never["strength_left"]


def test_the_gap_needed_is_that_of_frames_that_lose_strength():
    def needed(given):
        return bentur.minimum_gap(softening(given))["gaps"][0]["gap_needed"]
    whole, weak = (needed(given) for given in ({}, {"backbone": BACKBONE}))
    assert weak != pytest.approx(whole, rel=0.05)
    case = softening({"backbone": BACKBONE})
    for share, strikes in ((0.999, True), (1.001, False)):
        assert bool(len(bentur.run(case.replace({"gap[0].width": share * weak})).impacts)) == strikes


def test_backbones_vary():
    pytest.importorskip("xarray")
    case = softening({"backbone": BACKBONE})
    found = bentur.vary(case, {"building[0].frame.columns[0].backbone.softening_rotation": [0.03, 0.2]})
    given, long = (float(one.min()) for one in found.hinge_strength_left_1)
    assert long > given == weakest(bentur.run(case)).get("strength_left")


def test_what_is_wrong_of_a_backbone_has_its_key():
    for backbone, key in (({"softening_rotation": 0.1}, "plastic_rotation"),
                          ({**BACKBONE, "ultimate_rotation": 0.001}, "ultimate_rotation"),
                          ({**BACKBONE, "softening_rotation": 0.001}, "softening_rotation")):
        with pytest.raises(bentur.CaseError) as caught:
            softening({"backbone": backbone})
        assert f"columns[0].backbone.{key}" in str(caught.value)
