# %% [markdown]
# # Risk of pounding of two frames: from records to a rate a year
#
# Twelve motions of a simple stochastic model stand for records, so that the example needs no download: white noise through
# the ground's own oscillator (Kanai and Tajimi), in an envelope. Put files of your own in their place.

# %%
import tempfile
from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np

import bentur
import bentur.plot

folder = Path(tempfile.mkdtemp())
random = np.random.default_rng(7)
step, count = 0.02, 1000
time = step * np.arange(count)
envelope = (time / 4) ** 2 * (time < 4) + (time >= 4) * np.exp(-0.15 * np.maximum(time - 8, 0))
for number in range(12):
    omega, zeta = 2 * np.pi * random.uniform(1.5, 3.5), 0.6
    frequency = 2 * np.pi * np.fft.rfftfreq(count, step)
    ratio = frequency / omega
    soil = (1 + 2j * zeta * ratio) / (1 - ratio**2 + 2j * zeta * ratio)
    high_pass = (frequency / (frequency + 2 * np.pi * 0.2)) ** 2
    noise = np.fft.irfft(np.fft.rfft(random.normal(size=count)) * soil * high_pass, count) * envelope
    np.savetxt(folder / f"motion-{number + 1:02d}.txt", np.column_stack([time, 0.3 * noise / np.abs(noise).max()]))

# %% [markdown]
# The last of them.

# %%
with plt.rc_context(bentur.plot.STYLE):
    _, axes = plt.subplots(figsize=(6, 2), layout="constrained")
axes.plot(time, 0.3 * noise / np.abs(noise).max(), linewidth=0.7, color="black")
axes.set(xlabel="time [s]", ylabel="acceleration [g]")
axes.figure.savefig(folder / "motion.png", dpi=200)

# %% [markdown]
# The case as a file, and a study of it: every motion at 30 levels of spectral acceleration, 360 runs.

# %%
case = bentur.example("two-frames-si")
pair = {key: value for key, value in case.to_dict().items() if key != "analysis"}
pair["excitation"] = {"kind": "record", "file": "motion-01.txt", "unit": "g"}
bentur.Case.from_dict(pair, folder=folder).save(folder / "pair.toml")
(folder / "study.toml").write_text("""
case = "pair.toml"
[ida]
intensity = "sa"
period = 1.0
unit = "g"
from = 0.02
to = 1.2
count = 30
spacing = "log"
[[vary]]
parameter = "excitation.file"
files = "motion-*.txt"
unit = "g"
name = "record"
""")
results = bentur.ida(folder / "study.toml", progress=True)

# %% [markdown]
# Fragility: the part of the motions that make the frames collide, at each level, and the lognormal fitted to it, with its
# bounds by resampled motions. KS is the largest distance of the two.

# %%
curve = bentur.fragility(results)["curves"][0]
low, high = curve["median_bounds"]
print(f"θ {curve['median']:.3f} g ({low:.3f} to {high:.3f}), β {curve['dispersion']:.2f}, KS {curve['distance']:.2f}:",
      "not lognormal" if curve["misfit"] else "the motions follow it")
bentur.plot.fragility(results).figure.savefig(folder / "fragility.png", dpi=200)

# %% [markdown]
# The hazard of the site, Sa(1 s) [g] and how often a year it is exceeded: a power law, as the curves of many sites nearly are.
# A file of OpenQuake does as well.

# %%
intensity = np.geomspace(0.02, 2.0, 15)
rate = 1e-3 * (intensity / 0.3) ** -2.3
found = bentur.risk(results, (intensity, rate), unit="g", target=0.1)
print("\n".join(found["verdict"]))

# %% [markdown]
# Where the rate comes from.

# %%
bentur.plot.risk(found)[0].figure.savefig(folder / "risk.png", dpi=200)

# %% [markdown]
# The frames of this case are elastic. Beyond a drift of 1 % real ones would not be, so ask how much of the rate comes from
# there.

# %%
drifts = [results[name].max(name.replace("peak_drift_ratio", "elevation")) for name in ("peak_drift_ratio_1", "peak_drift_ratio_2")]
elastic = float(results.intensity[(np.maximum(*drifts) < 0.01).all("record")].max())
parts = np.array(found["cases"][0]["lognormal"]["parts"])
beyond = parts[np.append(intensity[:-1] > elastic, True)].sum() / parts.sum()
print(f"Up to {elastic:.2f} g no drift exceeds 1 %; about {100 * beyond:.0f} % of the rate come from above.")

# %% [markdown]
# The wider the gap, the rarer: how often more than it is needed, and the gap for the target, 10 % in 50 years.

# %%
gaps = np.geomspace(0.03, 0.3, 12)
cases = [bentur.risk(results, (intensity, rate), f"gap_needed > {gap}", unit="g", resamples=200)["cases"][0] for gap in gaps]
bounds = np.array([one["bounds"] or [one["rate"]] * 2 for one in cases])
wanted, target = found["gaps"][0]["gap"], -np.log(0.9) / 50
with plt.rc_context(bentur.plot.STYLE):
    _, axes = plt.subplots(figsize=(bentur.plot.COLUMN, 2.4), layout="constrained")
axes.loglog(gaps, [one["rate"] for one in cases], "o-", markersize=3, color="black", label="rate")
axes.fill_between(gaps, *bounds.T, color="0.85", label="95 % of resamples")
axes.axhline(target, linestyle="--", color=bentur.plot.TEAL, label="10 % in 50 years")
axes.plot(wanted, found["gaps"][0]["rate"], "s", color=bentur.plot.TEAL, label=f"{100 * wanted:.1f} cm")
axes.set(xlabel="gap [m]", ylabel="more is needed [1/year]", xticks=[0.03, 0.05, 0.1, 0.2, 0.3])
axes.xaxis.set_major_formatter("{x:g}")
axes.xaxis.set_minor_formatter("")
axes.legend(frameon=False, fontsize=7)
axes.figure.savefig(folder / "gaps.png", dpi=200)
print("figures in", folder)
