"""Every estimator of a fragility against scipy, on the same runs: likelihood, cloud, stripes, and their bounds."""

import numpy as np
import pytest
from risk_test import folder, results  # noqa: F401  # the fixtures

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
    medians = []
    for _ in range(2000):
        some = np.log(d[random.integers(0, len(d), len(d))])
        b, a = np.polyfit(np.tile(np.log(x), len(d)), some.ravel(), 1)
        medians.append((np.log(GAP) - a) / b)
    low, high = np.quantile(medians, [0.025, 0.975])
    # Of 2,000 resamples the ends are known to some hundredths of their distance.
    np.testing.assert_allclose(np.log(curve["median_bounds"]), [low, high], atol=0.1 * (high - low))
