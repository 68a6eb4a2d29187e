"""Records as they are, not scaled: the command line and Python alike, against scipy."""

import json
import subprocess

import numpy as np
import pytest
from risk_test import CASE, RATE, X

import bentur

pytest.importorskip("xarray")
pytest.importorskip("netCDF4")

STUDY = """
case = "case.toml"
[ida]
intensity = "sa"
period = 0.6
unit = "g"
levels = "unscaled"
[[vary]]
parameter = "excitation.file"
files = "r*.txt"
unit = "m/s2"
name = "record"
[[vary]]
parameter = "gap[0].width"
values = [0.03, 0.06]
"""
EVENT = "gap_needed > 0.05"
pytestmark = pytest.mark.filterwarnings("ignore::bentur.RemarkWarning")


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    folder = tmp_path_factory.mktemp("cloud")
    random = np.random.default_rng(9)
    for r in range(40):
        t = np.arange(500) * 0.02
        values = np.convolve(random.normal(size=500), np.ones(5) / 5, "same") * np.exp(-(((t - 4) / 3) ** 2))
        np.savetxt(folder / f"r{r:02}.txt", np.column_stack([t, values * np.exp(random.normal(0.6, 0.7))]))
    (folder / "case.toml").write_text(CASE.replace("r0.txt", "r00.txt") + "[analysis]\ncollapse_drift = 1.0\n")
    (folder / "cloud.toml").write_text(STUDY)
    (folder / "hazard.csv").write_text("Sa [g],lambda\n" + "".join(f"{x!r},{r!r}\n" for x, r in zip(X, RATE)))
    return folder


@pytest.fixture(scope="module")
def cloud(folder):
    return bentur.ida(folder / "cloud.toml", output=folder / "cloud.nc")


def test_no_record_is_scaled(folder, cloud):
    assert cloud.gap_needed.dims[:2] == ("record", "width") and "scale_factor" not in cloud
    assert cloud.intensity.dims == ("record",)
    np.testing.assert_array_equal(cloud.intensity, cloud.record_intensity)
    for r in (0, 17, 39):
        record = np.loadtxt(folder / f"r{r:02}.txt")
        found = bentur.response_spectrum(record[:, 1], [0.6], unit="m/s2", time_step=0.02)
        assert float(cloud.intensity[r]) == pytest.approx(found.pseudo_acceleration[0] / 9.80665, rel=1e-12)
    # What a sweep over the same files gives, to the last bit.
    (folder / "sweep.toml").write_text(STUDY.replace(STUDY[STUDY.index("[ida]") : STUDY.index("[[vary]]")], ""))
    swept = bentur.sweep(folder / "sweep.toml")
    np.testing.assert_array_equal(swept.gap_needed, cloud.gap_needed)
    np.testing.assert_array_equal(swept.peak_force, cloud.peak_force)


def test_likelihood_and_line(cloud):
    stats = pytest.importorskip("scipy.stats")
    from estimators_test import largest_likelihood

    x = cloud.intensity.values
    d = cloud.gap_needed.isel(width=0).values.reshape(40, -1).max(axis=1)
    curve = bentur.fragility(cloud, EVENT, resamples=10)["curves"][0]
    median, dispersion = largest_likelihood((d > 0.05).astype(float)[np.argsort(x)], 1, np.sort(x))
    assert curve["median"] == pytest.approx(median, rel=1e-5)
    assert curve["dispersion"] == pytest.approx(dispersion, rel=1e-4)
    assert curve["distance"] is None and not curve["misfit"] and len(curve["counts"]) == 40
    fitted = bentur.fragility(cloud, EVENT, method="cloud", resamples=10)
    assert fitted["intensity"]["scaled"] is False and fitted["intensity"]["levels"] == []
    curve = fitted["curves"][0]
    line = stats.linregress(np.log(x), np.log(d))
    residuals = np.log(d) - line.intercept - line.slope * np.log(x)
    sigma = np.sqrt(np.sum(residuals**2) / 38)
    assert curve["median"] == pytest.approx(np.exp((np.log(0.05) - line.intercept) / line.slope), rel=1e-9)
    assert curve["dispersion"] == pytest.approx(sigma / line.slope, rel=1e-9)
    distance = stats.kstest(residuals / sigma, "norm").statistic
    assert curve["distance"] == curve["cloud"]["distance"] == pytest.approx(distance, rel=1e-9)
    assert curve["misfit"] == (distance > 0.895 / (np.sqrt(40) - 0.01 + 0.85 / np.sqrt(40)))
    with pytest.raises(ValueError, match="stripes needs levels"):
        bentur.fragility(cloud, EVENT, method="stripes")


def test_every_door_says_the_same(folder, cloud, program):
    def run(*arguments):
        return subprocess.run([program, *arguments], capture_output=True, text=True)

    told = run("fragility", folder / "cloud.nc", "--event", EVENT, "--method", "cloud", "--json").stdout
    assert json.loads(told)["curves"] == bentur.fragility(cloud, EVENT, method="cloud")["curves"]
    text = run("fragility", folder / "cloud.nc").stdout
    assert "40 records, not scaled, by their spectral acceleration" in text and "No KS" in text
    for method in ("likelihood", "cloud"):
        told = run("risk", folder / "cloud.nc", "--hazard", folder / "hazard.csv", "--event", EVENT, "--method", method,
                   "--target", "0.05", "--json")
        found = bentur.risk(cloud, folder / "hazard.csv", EVENT, method=method, target=0.05)
        told = json.loads(told.stdout)
        assert told["cases"] == found["cases"] and told["gaps"] == found["gaps"]
        assert told["cases"][0]["by"] == "lognormal" and told["cases"][0]["records"] == []
        # Of some of these records it is not known what they need, so that no gap keeps the target for certain.
        gap, open_needs = found["gaps"][0], found["open_needs"]["runs"]
        assert open_needs == gap["open"] > 0 and gap["failed"] == 0
        assert gap["gap"] is None and gap["gap_by_what_is_known"] > 0
    # The gap each record needs, with its intensity.
    told = json.loads(run("gap", folder / "cloud.toml", "--json").stdout)
    records = told["studied"][0]["gaps"][0]["records"]
    assert told["intensity"]["value"] is None
    np.testing.assert_allclose([one["intensity"] for one in records], cloud.intensity, rtol=1e-15)
    refused = run("gap", folder / "cloud.toml", "--at", "0.2")
    assert refused.returncode == 2 and '--at scales records, which are "unscaled" by [ida]' in refused.stderr
    # One sample for the losses that others compute.
    sample = run("export", "pelicun", folder / "cloud.nc", "--building", "A", "--only", "width=0.03")
    assert sample.returncode == 0 and len(sample.stdout.splitlines()) == 2 + 40, sample.stderr


def test_the_page_and_its_figures(folder, cloud, program):
    for language, words in (("en", "not scaled"), ("id", "tidak diskalakan")):
        page = folder / f"page-{language}.html"
        subprocess.run([program, "report", folder / "cloud.nc", "--event", EVENT, "--method", "cloud", "--hazard",
                        folder / "hazard.csv", "-o", page, "--lang", language], check=True, capture_output=True)
        text = page.read_text()
        assert words in text and "ln d = " in text and f"{EVENT.replace('>', '&gt;')}: " in text
    assert subprocess.run([program, "report", folder / "cloud.nc", "--method", "cloud", "-o", folder / "no.html"],
                          capture_output=True).returncode == 2  # collisions are no demand
    kinds = subprocess.run([program, "plot", folder / "cloud.nc", "--list"], capture_output=True, text=True).stdout
    assert "cloud" in kinds and "ida " not in kinds
    for kind, more in (("cloud", []), ("fragility", ["--event", EVENT, "--method", "cloud"])):
        picture = folder / f"{kind}.svg"
        subprocess.run([program, "plot", folder / "cloud.nc", kind, *more, "-o", picture], check=True,
                       capture_output=True)
        assert picture.stat().st_size > 5000


def test_drawn_with_its_buildings(folder):
    """With [sampling] each draw is a record and a building."""
    (folder / "drawn.toml").write_text(
        STUDY.replace("[[vary]]", '[sampling]\nmethod = "sobol"\ncount = 64\n[[vary]]', 1)
        + '[[vary]]\nparameter = "building[0].damping"\ndistribution = { lognormal = { median = 0.05, cov = 0.3 } }\n')
    drawn = bentur.ida(folder / "drawn.toml")
    assert drawn.sizes["draw"] == 64 and drawn.intensity.dims == ("draw",)
    curve = bentur.fragility(drawn, EVENT, method="cloud", resamples=10)["curves"][0]
    assert curve["cloud"]["runs"] == 64 and curve["median"] > 0


def test_the_figure_of_python(cloud):
    pytest.importorskip("matplotlib")
    import bentur.plot

    axes = bentur.plot.fragility(bentur.fragility(cloud, EVENT, resamples=10))
    assert len(axes.lines) == 4  # two curves, and the runs of both
