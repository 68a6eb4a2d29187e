# %% [markdown]
# # How wide should the gap be?
#
# The monograph's pair of frames over gaps from none to 0.8 cm, with the second building reached at once and 0.1 s later.

# %%
import matplotlib.pyplot as plt
import numpy as np

import bentur
import bentur.plot

case = bentur.example("m12-el-centro")
results = bentur.vary(
    case,
    {
        "gap[0].width": np.linspace(0.0, 0.8, 17),
        "excitation.delays": [[0.0, 0.0], [0.0, 0.1]],
    },
    labels={"excitation.delays": ["together", "0.1 s apart"]},
)

# %% [markdown]
# A Dataset with units: pick, reduce, plot.

# %%
hardest = results.peak_force.max("point")
for delay in results.delays.values:
    widths = results.width.where(results.impacts.sel(delays=delay).sum("point") == 0, drop=True)
    print(f"{delay}: no impact from {float(widths.min()):.2f} {results.width.units} on")
print(f"hardest of all: {float(hardest.max()):.0f} {results.peak_force.units}")

# %%
bentur.plot.against(results, "peak_force", "width")
plt.savefig("gap_study.png", dpi=200)

# %% [markdown]
# A wider gap is not always a softer blow: the buildings come faster the further they swing. The gap needed in the free
# response settles it.

# %%
needed = bentur.minimum_gap(case)["gaps"][0]["gap_needed"]
impacts = results.impacts.sum("point").sel(delays="0.1 s apart")
assert bool((impacts.where(results.width > needed, drop=True) == 0).all())
assert bool((impacts.where(results.width < needed, drop=True) > 0).all())
