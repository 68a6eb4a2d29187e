"""Every estimator of a fragility against scipy, on the same runs: likelihood, cloud, collapse, stripes, their bounds."""

import json
import subprocess

import numpy as np
import pytest
from risk_test import RATE, X, folder, results  # noqa: F401  # the fixtures

import bentur

stats = pytest.importorskip("scipy.stats")
optimize = pytest.importorskip("scipy.optimize")

GAP = 0.06  # m; a demand that most runs come near


def demands(data, width):
    """Gap needed, records × levels, and the levels [g]."""
    one = data.gap_needed.isel(width=width).transpose("record", "intensity", ...)
    return one.values.reshape(one.sizes["record"], one.sizes["intensity"], -1).max(axis=2), data.intensity.values


def largest_likelihood(share, runs, x):
    """θ and β that make `share` of so many `runs` at each x most probable."""

    def unlikely(at):
        p = stats.norm.cdf((np.log(x) - at[0]) / np.exp(at[1]))
        p = np.clip(p, 1e-300, 1 - 1e-16)
        return -np.sum(runs * (share * np.log(p) + (1 - share) * np.log1p(-p)))

    # From several places, as the surface is flat far from its top.
    tried = [optimize.minimize(unlikely, [np.log(m), np.log(s)], method="Nelder-Mead", options={"xatol": 1e-10, "fatol": 1e-13, "maxiter": 9999})
             for m in x[::4] for s in (0.2, 0.5)]
    best = min(tried, key=lambda found: found.fun)
    return np.exp(best.x[0]), np.exp(best.x[1])


@pytest.mark.filterwarnings("ignore::bentur.RemarkWarning")
@pytest.mark.parametrize("width", [0, 1])
def test_likelihood(results, width):  # noqa: F811
    d, x = demands(results, width)
    curve = bentur.fragility(results, f"gap_needed > {GAP}", resamples=10)["curves"][width]
    median, dispersion = largest_likelihood((d > GAP).mean(axis=0), len(d), x)
    # Nelder and Mead end where the likelihood changes by 1e-13, at 1e-6 of the place.
    assert curve["median"] == pytest.approx(median, rel=1e-5)
    assert curve["dispersion"] == pytest.approx(dispersion, rel=1e-4)
    told = curve["distance"]
    p = stats.lognorm.cdf(x, s=curve["dispersion"], scale=curve["median"])
    assert told == pytest.approx(np.abs(p - (d > GAP).mean(axis=0)).max(), rel=1e-9)
    np.testing.assert_allclose([one["probability"] for one in curve["counts"]], p, rtol=1e-9, atol=1e-15)


def test_cloud(results):  # noqa: F811
    d, x = demands(results, 0)
    curve = bentur.fragility(results, f"gap_needed > {GAP}", method="cloud", resamples=10)["curves"][0]
    line = stats.linregress(np.tile(np.log(x), len(d)), np.log(d).ravel())
    residuals = np.log(d) - line.intercept - line.slope * np.log(x)
    sigma = np.sqrt(np.sum(residuals**2) / (d.size - 2))
    cloud = curve["cloud"]
    for key, value in (("a", line.intercept), ("b", line.slope), ("sigma", sigma), ("determination", line.rvalue**2)):
        assert cloud[key] == pytest.approx(value, rel=1e-9, abs=1e-12)
    assert curve["median"] == pytest.approx(np.exp((np.log(GAP) - line.intercept) / line.slope), rel=1e-9)
    assert curve["dispersion"] == pytest.approx(sigma / line.slope, rel=1e-9)


def collapsed_at(data, gone):
    """The same results where these runs, records × levels, collapse, at any width."""
    made = data.copy()
    of_all = np.broadcast_to(gone[:, :, None], (*gone.shape, data.sizes["width"]))
    made["collapsed"] = (("record", "intensity", "width"), of_all.astype(float))
    made["collapsed"] = made["collapsed"].transpose(*data.status.dims)
    return made


def with_collapses(data):
    """The same results where some runs collapse, the more of them the larger the intensity; and which do."""
    x = data.intensity.values
    gone = np.random.default_rng(11).random((data.sizes["record"], x.size)) < 1 / (1 + (x / 0.9) ** -3.0)
    return collapsed_at(data, gone), gone


def test_collapse_of_a_cloud(results):  # noqa: F811
    """α₀ and α₁ by scipy's optimiser, P of all runs by hand, its rate by trapezoids."""
    data, gone = with_collapses(results)
    event = f"gap_needed > {GAP}"
    curve = bentur.fragility(data, event, method="cloud", resamples=200)["curves"][0]
    d, x = demands(results, 0)
    ln_x = np.tile(np.log(x), (len(d), 1))

    def unlikely(at):
        z = at[0] + at[1] * ln_x
        return np.sum(np.logaddexp(0, np.where(gone, -z, z)))

    best = optimize.minimize(unlikely, [0.0, 1.0], method="Nelder-Mead", options={"xatol": 1e-10, "fatol": 1e-13}).x
    cloud = curve["cloud"]
    found = cloud["collapse"]
    assert found["kind"] == "fitted" and found["collapsed"] == gone.sum() and found["runs"] == gone.size
    assert found["intercept"] == pytest.approx(best[0], rel=1e-5, abs=1e-5)
    assert found["slope"] == pytest.approx(best[1], rel=1e-5)

    line = stats.linregress(ln_x[~gone], np.log(d[~gone]))  # of the runs that stand
    assert cloud["a"] == pytest.approx(line.intercept, rel=1e-9, abs=1e-12)
    assert cloud["b"] == pytest.approx(line.slope, rel=1e-9)
    assert cloud["runs"] == (~gone).sum()

    def probability(at):
        collapse = 1 / (1 + np.exp(-(found["intercept"] + found["slope"] * np.log(at))))
        return collapse + (1 - collapse) * stats.lognorm.cdf(at, s=curve["dispersion"], scale=curve["median"])

    ends = [optimize.brentq(lambda at, p=p: probability(at) - p, 1e-4, 50) for p in (stats.norm.cdf(-1), 0.5, stats.norm.cdf(1))]
    assert cloud["of_all"]["median"] == pytest.approx(ends[1], rel=1e-9)
    assert cloud["of_all"]["dispersion"] == pytest.approx(0.5 * np.log(ends[2] / ends[0]), rel=1e-9)
    low, high = cloud["of_all"]["median_bounds"]
    assert low < ends[1] < high
    share = ((d > GAP) | gone).mean(axis=0)
    assert curve["distance"] == pytest.approx(np.abs(probability(x) - share).max(), rel=1e-9)

    risk = bentur.risk(data, (X, RATE), event, method="cloud", resamples=20)["cases"][0]
    s = np.linspace(np.log(X[0]), np.log(X[-1]), 200001)
    density = probability(np.exp(s)) * 2.1 * 2e-4 * np.exp(-2.1 * s)
    expected = float(np.sum(density[1:] + density[:-1]) / 2 * (s[1] - s[0])) + RATE[-1]
    assert risk["lognormal"]["rate"] == pytest.approx(expected, rel=1e-7)
    assert risk["collapse"] == found and risk["closed_form"] is None
    if risk["misfit"]:
        assert risk["by"] == "observed"
    else:
        assert risk["by"] == "lognormal" and risk["rate"] == risk["lognormal"]["rate"]


def test_collapses_that_no_curve_describes(results):  # noqa: F811
    data, gone = with_collapses(results)
    event = f"gap_needed > {GAP}"
    x = data.intensity.values
    for name, which in (("separated", x > 0.5), ("falling", x < 0.3)):
        # by "falling" some of the records alone, lest the two be separated
        some = np.arange(len(gone))[:, None] < (8 if name == "separated" else 5)
        collapsed = np.broadcast_to(which & some, gone.shape)
        one = collapsed_at(data, collapsed)
        curve = bentur.fragility(one, event, method="cloud", resamples=2)["curves"][0]
        assert curve["cloud"]["collapse"]["kind"] == name and curve["cloud"]["collapse"]["slope"] is None
        assert curve["cloud"]["of_all"] is None
        risk = bentur.risk(one, (X, RATE), event, method="cloud", resamples=2)
        assert risk["cases"][0]["by"] == "observed" and risk["cases"][0]["lognormal"] is None
        assert any(f"{collapsed.sum()} of {collapsed.size} runs collapse" in line for line in risk["verdict"])
        at = {"at": 0.4, "probabilities": [0.1]}
        assert bentur.fragility(one, event, method="cloud", resamples=2, **at)["gaps"][0]["width"] is None
    curve = bentur.fragility(results, event, method="cloud", resamples=2)["curves"][0]
    assert curve["cloud"]["collapse"]["kind"] == "none" and curve["cloud"]["of_all"] is None
    every = collapsed_at(data, np.ones_like(gone))
    assert bentur.fragility(every, event, method="cloud", resamples=2)["curves"][0]["kind"] == "all_events"


def test_the_command_says_what_collapses(results, folder, program):  # noqa: F811
    data, gone = with_collapses(results)
    file = folder / "collapses.nc"
    data.to_netcdf(file)
    asked = [program, "fragility", file, "--event", f"gap_needed > {GAP}", "--method", "cloud", "--resamples", "50"]
    text = " ".join(subprocess.run(asked, check=True, capture_output=True, text=True).stdout.split())
    assert f"{gone.sum()} of {gone.size} runs collapse, P_C = 1/(1 + exp(" in text
    assert "P(event) with them is ½ at" in text and "P = P_C + (1 − P_C) Φ" in text
    told = json.loads(subprocess.run([*asked, "--json"], check=True, capture_output=True, text=True).stdout)
    found = bentur.fragility(data, f"gap_needed > {GAP}", method="cloud", resamples=50)
    assert told["curves"] == found["curves"]
    asked[2] = folder / "ida.nc"
    assert "no run collapses" in subprocess.run(asked, check=True, capture_output=True, text=True).stdout


def test_stripes(results):  # noqa: F811
    d, x = demands(results, 0)
    curve = bentur.fragility(results, f"gap_needed > {GAP}", method="stripes", resamples=10)["curves"][0]
    median, dispersion = np.exp(np.log(d).mean(axis=0)), np.log(d).std(axis=0, ddof=1)
    told = curve["stripes"]
    np.testing.assert_allclose([one["median"] for one in told], median, rtol=1e-9)
    np.testing.assert_allclose([one["dispersion"] for one in told], dispersion, rtol=1e-7)
    exceeded = stats.norm.cdf(np.log(median / GAP) / dispersion)
    theta, beta = largest_likelihood(exceeded, len(d), x)
    assert curve["median"] == pytest.approx(theta, rel=1e-5)
    assert curve["dispersion"] == pytest.approx(beta, rel=1e-4)


def test_bounds_are_those_of_resampled_records(results):  # noqa: F811
    """Of a cloud, whose fit is quick: the spread of θ over resamples, by other random numbers."""
    d, x = demands(results, 0)
    curve = bentur.fragility(results, f"gap_needed > {GAP}", method="cloud", resamples=2000)["curves"][0]
    random = np.random.default_rng(1)
    near = min(curve["counts"], key=lambda one: abs(np.log(one["intensity"] / curve["median"])))
    medians, probabilities = [], []
    for _ in range(2000):
        some = np.log(d[random.integers(0, len(d), len(d))])
        b, a = np.polyfit(np.tile(np.log(x), len(d)), some.ravel(), 1)
        sigma = np.sqrt(np.sum((some - a - b * np.log(x)) ** 2) / (d.size - 2))
        medians.append((np.log(GAP) - a) / b)
        probabilities.append(stats.norm.cdf((np.log(near["intensity"]) - medians[-1]) * b / sigma))
    low, high = np.quantile(medians, [0.025, 0.975])
    # Of 2,000 resamples the ends are known to some hundredths of their distance.
    np.testing.assert_allclose(np.log(curve["median_bounds"]), [low, high], atol=0.1 * (high - low))
    ends = np.quantile(probabilities, [0.025, 0.975])
    np.testing.assert_allclose(near["bounds"], ends, atol=0.1 * (ends[1] - ends[0]))
