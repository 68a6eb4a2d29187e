# %% [markdown]
# # A design by scipy.stats.qmc
#
# Stiffness, damping and the strength of the ground motion of a pair are uncertain. A Sobol sequence fills their ranges
# evenly; its rows go into `bentur.vary` as they are.

# %%
import numpy as np
import pandas
from scipy.stats import qmc, spearmanr

import bentur

case = bentur.example("m12-el-centro")
ranges = {
    "building[0].damping": (0.02, 0.07),
    "building[1].damping": (0.02, 0.07),
    "excitation.pga": (150.0, 450.0),
    "gap[0].width": (0.1, 0.6),
}
low, high = np.transpose(list(ranges.values()))
points = qmc.scale(qmc.Sobol(len(ranges), seed=1).random_base2(7), low, high)
rows = pandas.DataFrame(points, columns=list(ranges))
results = bentur.vary(case, rows)
print(results.sizes)

# %% [markdown]
# What the need for a gap and the force of the blows depend on, by rank:

# %%
needed = results.gap_needed.values.reshape(len(rows), -1).max(axis=1)
force = results.peak_force.values.reshape(len(rows), -1).max(axis=1)
for key in ranges:
    print(f"{key:20} need {spearmanr(rows[key], needed)[0]:+.2f}, force {spearmanr(rows[key], force)[0]:+.2f}")

# %% [markdown]
# Each row is the run of its own case, to the last digit; and the free response does not know the gap that is given.

# %%
row = 17
alone = bentur.run(case.replace(dict(rows.loc[row]))).summary["gaps"][0]
assert force[row] == max(point["peak_force"] for point in alone["points"])
assert spearmanr(rows["excitation.pga"], needed)[0] > 0.8
wider = bentur.vary(case, rows.assign(**{"gap[0].width": 0.6})).gap_needed.values.reshape(len(rows), -1).max(axis=1)
assert (wider == needed).all()
