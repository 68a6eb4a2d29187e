"""How often a year: the command line and Python alike, against quadrature and the closed form."""

import json
import math
import subprocess
from statistics import NormalDist

import numpy as np
import pytest

import bentur

pytest.importorskip("xarray")
pytest.importorskip("netCDF4")

CASE = """
title = "A stiff and a soft one"
[units]
length = "m"
force = "kN"
[[building]]
name = "A"
damping = 0.05
stick = { storey_heights = [3.0], masses = [100.0], stiffnesses = [8000.0] }
[[building]]
name = "B"
damping = 0.05
stick = { storey_heights = [3.0], masses = [100.0], stiffnesses = [20000.0] }
[[gap]]
between = ["A", "B"]
width = 0.03
contact = { law = "linear", stiffness = 1e5 }
[excitation]
kind = "record"
file = "r0.txt"
unit = "m/s2"
"""
STUDY = """
case = "case.toml"
[ida]
intensity = "sa"
period = 0.6
unit = "g"
from = 0.05
to = 1.5
count = 20
[[vary]]
parameter = "excitation.file"
files = "r*.txt"
unit = "m/s2"
name = "record"
[[vary]]
parameter = "gap[0].width"
values = [0.03, 0.06]
"""
X = [0.01 * 1.35**i for i in range(20)]
RATE = [2e-4 * x**-2.1 for x in X]


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    folder = tmp_path_factory.mktemp("risk")
    random = np.random.default_rng(4)
    for r in range(8):
        t = np.arange(600) * 0.02
        values = np.convolve(random.normal(size=600), np.ones(5) / 5, "same") * np.exp(-(((t - 4) / 3) ** 2))
        np.savetxt(folder / f"r{r}.txt", np.column_stack([t, values]))
    (folder / "case.toml").write_text(CASE)
    (folder / "study.toml").write_text(STUDY)
    (folder / "hazard.csv").write_text("Sa [g],lambda\n" + "".join(f"{x!r},{r!r}\n" for x, r in zip(X, RATE)))
    return folder


@pytest.fixture(scope="module")
def results(folder):
    return bentur.ida(folder / "study.toml", output=folder / "ida.nc")


@pytest.mark.filterwarnings("ignore::bentur.RemarkWarning")
def test_the_rate_is_the_integral(results):
    found = bentur.risk(results, (X, RATE))
    assert [one["case"] for one in found["cases"]] == [{"width": 0.03}, {"width": 0.06}]
    fragility = bentur.fragility(results)
    for one, curve in zip(found["cases"], fragility["curves"], strict=True):
        assert one["median"] == curve["median"] and one["dispersion"] == curve["dispersion"]
        s = np.linspace(math.log(X[0]), math.log(X[-1]), 200001)
        p = np.vectorize(NormalDist().cdf)((s - math.log(one["median"])) / one["dispersion"])
        density = 2.1 * 2e-4 * np.exp(-2.1 * s)
        integral = float(np.sum((p * density)[1:] + (p * density)[:-1]) / 2 * (s[1] - s[0])) + RATE[-1]
        assert one["lognormal"]["rate"] == pytest.approx(integral, rel=1e-7)  # of the trapezoids
        assert one["closed_form"] == pytest.approx(
            2e-4 * one["median"] ** -2.1 * math.exp(0.5 * (2.1 * one["dispersion"]) ** 2), rel=1e-12)
        assert sum(record["rate"] for record in one["records"]) == pytest.approx(one["observed"]["rate"], rel=1e-12)
        assert one["probability"] == pytest.approx(1 - math.exp(-50 * one["rate"]), rel=1e-12)
        assert len(one["lognormal"]["parts"]) == len(X)
        assert one["bounds"][0] <= one["lognormal"]["rate"] <= one["bounds"][1]
    assert found["cases"][0]["rate"] > found["cases"][1]["rate"]


def test_the_command_says_the_same(results, folder, program):
    asked = ["--target", "0.1", "--years", "30", "--event", "peak_force > 100"]
    told = subprocess.run([program, "risk", folder / "ida.nc", "--hazard", folder / "hazard.csv", *asked, "--json"],
                          check=True, capture_output=True, text=True).stdout
    for hazard in (folder / "hazard.csv", (X, RATE)):
        found = bentur.risk(results, hazard, "peak_force > 100", target=0.1, years=30)
        lines = found.pop("verdict")
        assert json.loads(told) == found
    for language in ("en", "id"):
        text = subprocess.run(
            [program, "risk", folder / "ida.nc", "--hazard", folder / "hazard.csv", *asked, "--lang", language],
            check=True, capture_output=True, text=True).stdout
        words = " ".join(text.split())
        of_file = {"target": 0.1, "years": 30, "language": language}
        lines = bentur.risk(results, (X, RATE), "peak_force > 100", unit="g", **of_file)["verdict"]
        for line in lines:
            assert " ".join(line.split()) in words, line
        assert len(lines) > 6
        # Of numbers without a unit it is said which one they are taken in.
        more = bentur.risk(results, (X, RATE), "peak_force > 100", **of_file)["verdict"]
        assert more[:-1] == lines and "--unit" in more[-1]


def test_the_gap_for_a_target_keeps_it(results):
    found = bentur.risk(results, (X, RATE), target=0.05)
    (gap,) = found["gaps"]  # one, whatever gaps the runs had
    assert gap["units"] == "m" and gap["rate"] <= -math.log1p(-0.05) / 50
    again = bentur.risk(results, (X, RATE), f"gap_needed > {gap['gap']!r}")
    assert again["cases"][0]["rate"] == gap["rate"]
    wider = bentur.risk(results, (X, RATE), target=0.01)["gaps"][0]
    assert wider["gap"] is None or wider["gap"] > gap["gap"]


def test_what_is_wrong_is_told(results, folder, program):
    with pytest.raises(ValueError, match="is of PGA, but the runs are by levels of SA.0.6."):
        quake = folder / "curve.csv"
        quake.write_text("# investigation_time=50, imt='PGA'\nlon,lat,poe-0.1,poe-0.2\n1,2,0.2,0.1\n")
        bentur.risk(results, quake)
    for hazard, told in ((([0.1, 0.2], [0.1, 0.2]), "must not be larger"), (([0.1], [0.1]), "two intensities")):
        with pytest.raises(bentur.CaseError, match=told):
            bentur.risk(results, hazard)
    with pytest.raises(ValueError, match="target = 2"):
        bentur.risk(results, (X, RATE), target=2)
    failed = subprocess.run([program, "risk", folder / "ida.nc", "--hazard", quake], capture_output=True, text=True)
    assert failed.returncode == 2 and "levels of SA(0.6)" in failed.stderr
    failed = subprocess.run([program, "risk", folder / "ida.nc", "--hazard", quake, "--lang", "id"],
                            capture_output=True, text=True)
    assert "untuk PGA" in failed.stderr


def test_the_page_of_the_analysis_says_it(folder, results, program):
    for language, heading in (("en", "How often a year"), ("id", "Seberapa sering setahun")):
        page = folder / f"page-{language}.html"
        subprocess.run([program, "report", folder / "ida.nc", "--hazard", folder / "hazard.csv", "-o", page, "--lang",
                        language], check=True, capture_output=True)
        text = page.read_text()
        assert heading in text and "exp(k²β²/2)" in text
    bare = folder / "bare.html"
    subprocess.run([program, "report", folder / "ida.nc", "-o", bare], check=True, capture_output=True)
    assert "How often a year" not in bare.read_text()


@pytest.mark.parametrize("language, words", [("en", "Goodness of fit: KS"), ("id", "Kecocokan: KS")])
def test_the_goodness_of_fit_is_said(results, folder, program, language, words):
    found = bentur.risk(results, folder / "hazard.csv", "peak_force > 100", language=language)
    curves = bentur.fragility(results, "peak_force > 100")["curves"]
    assert [one["distance"] for one in found["cases"]] == [one["distance"] for one in curves]
    assert any(words in line for line in found["verdict"])
    told = subprocess.run([program, "risk", folder / "ida.nc", "--hazard", folder / "hazard.csv", "--event",
                           "peak_force > 100", "--lang", language], capture_output=True, text=True).stdout
    # Lines are wrapped.
    assert words in " ".join(told.split())


def test_the_figure(results):
    pytest.importorskip("matplotlib")
    import bentur.plot

    axes = bentur.plot.risk(bentur.risk(results, (X, RATE)))
    assert axes[0].get_xscale() == "log" and axes[1].get_ylabel()
