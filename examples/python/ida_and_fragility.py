# %% [markdown]
# # Incremental dynamic analysis and fragility
#
# Records are made here so that the example needs no download: one motion of the package, cut at different places and
# applied both ways round. With `./dev records` use the 44 components of FEMA P-695 in their place.

# %%
import tempfile
from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np

import bentur
import bentur.plot

pair = bentur.example("two-frames-si")
record = bentur.read_record(pair.folder / pair.to_dict()["excitation"]["file"])
folder = Path(tempfile.mkdtemp())
for start in range(0, 1000, 125):
    np.savetxt(folder / f"from-{start}.txt", record.values[start : start + 500])

# %% [markdown]
# A study is a file that names a case, so that the command line runs the same one.

# %%
case_file = folder / "case.toml"
case_file.write_text((pair.text or "").replace("../data", str((pair.folder / "../data").resolve())))
study = folder / "study.toml"
study.write_text(
    """
case = "case.toml"

[ida]
intensity = "pga"
unit = "g"
from = 0.05
to = 1.2
count = 12
polarity = "both"

[[vary]]
parameter = "excitation.file"
files = "from-*.txt"
format = "one-column"
unit = "g"
time_step = 0.02
name = "record"

[[vary]]
parameter = "gap[0].width"
values = [0.08, 0.12, 0.16]
"""
)
results = bentur.ida(study, progress=True)
print(dict(results.sizes))

# %% [markdown]
# The fragility is fitted by maximum likelihood; bounds come from resampling whole records.

# %%
found = bentur.fragility(results, at=0.3, probabilities=[0.1, 0.5], resamples=200)
for curve in found["curves"]:
    print(curve["case"], "median", curve["median"], "dispersion", curve["dispersion"])
for gap in found["gaps"]:
    print(f"P(pounding | 0.3 g) ≤ {gap['probability']}: {gap['width']} m ({gap['kind']})")

# %%
bentur.plot.fragility(found)
plt.savefig("fragility.png", dpi=200)

# %%
medians = [curve["median"] for curve in found["curves"] if curve["median"] is not None]
assert medians == sorted(medians) and len(medians) > 1
