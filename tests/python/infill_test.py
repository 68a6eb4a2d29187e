"""Infill of a frame in Python: as classes and tables, in results and in what varies; what `bentur check` says of it."""

import os
import subprocess

import bentur
import pytest
from refused import refused


def filled(infill):
    member = {"density": 2.4}
    frame = bentur.Frame(elastic_modulus=2.6e7, storey_heights=[3.0, 3.0], bay_widths=[4.0, 6.0], floor_masses=60.0,
                         columns=[{"width": 0.4, "depth": 0.4, **member}],
                         beams=[{"width": 0.3, "depth": 0.5, **member}],
                         infill=infill)
    stick = bentur.Stick(storey_heights=[3.0, 3.0], masses=[60.0, 50.0], stiffnesses=[9e4, 7e4])
    return bentur.Case(units=bentur.Units(length="m", force="kN"),
                       building=[bentur.Building(name="Filled", damping={"mass_proportional": 0.03}, frame=frame),
                                 bentur.Building(name="Stick", damping=0.03, stick=stick)],
                       gap=[bentur.Gap(between=["Filled", "Stick"], width=0.01,
                                       contact=bentur.Contact(law="linear", stiffness=1e5))],
                       excitation=bentur.Excitation(kind="harmonic", period=0.3, displacement_amplitude=0.02),
                       analysis=bentur.Analysis(duration=4.0))


MASONRY = {"thickness": 0.1, "modulus": 3e6, "strength": 2000.0, "plastic_drift": 0.002, "softening_drift": 0.005}


def test_infill_stands_in_the_results_of_its_storey():
    building, other = bentur.run(filled([{}, MASONRY])).summary["buildings"]
    assert building["infill_force"][0] is None
    assert building["infill_force"][1] > building["infill_shear"][1] > 0
    assert building["infill_strength_left"][1] == 0 and building["infill_failed_time"][1] > 0
    assert "infill_force" not in other


def test_infill_varies():
    pytest.importorskip("xarray")
    found = bentur.vary(filled([{}, MASONRY]), {"building[0].frame.infill[1].strength": [1000.0, 2000.0]})
    weak, strong = (float(one) for one in found.infill_shear_1[:, 1])
    assert 0 < weak < strong
    assert strong == bentur.run(filled([{}, MASONRY])).summary["buildings"][0]["infill_shear"][1]


def test_what_is_wrong_of_infill_has_its_key():
    with pytest.raises(bentur.CaseError) as caught:
        filled([{"strength": 2000.0}])
    assert 'building["Filled"].frame.infill[0].strength' in str(caught.value)


def test_check_says_what_infill_comes_to(root, tmp_path):
    program = os.environ.get("BENTUR_PROGRAM", "")
    if not program:
        pytest.skip("BENTUR_PROGRAM does not name the command line")
    text = (refused() / "infill-count.toml").read_text()
    file = tmp_path / "case.toml"
    for infill, said in (("[{}, { stiffness = 2e4, yield = 50.0 }]",
                          "A: infill in 1 of 2 storeys, a panel has 20000 kN/m and yields at 50 kN\n"), ("[{}]", "")):
        file.write_text(text.replace("[{}, { stiffness = 3e4, yield = 50.0 }, {}]", infill))
        told = subprocess.run([program, "check", str(file)], check=True, capture_output=True, text=True).stdout
        assert ("A: infill" in told) == bool(said) and said in told
