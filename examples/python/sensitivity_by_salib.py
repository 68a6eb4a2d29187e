# %% [markdown]
# # Which input matters, by SALib
#
# Shares of the variance of the gap needed (Sobol' indices) and elementary effects of Morris. Both designs have rows that
# are alike in most columns, and some that stand twice: `bentur.vary` takes them as they are.

# %%
import pandas
from SALib.analyze import morris as effects
from SALib.analyze import sobol as shares
from SALib.sample import morris, sobol

import bentur

case = bentur.example("m12-el-centro")
problem = {
    "num_vars": 3,
    "names": ["building[0].damping", "building[1].damping", "excitation.pga"],
    "bounds": [[0.02, 0.07], [0.02, 0.07], [150.0, 450.0]],
}


def needed(design):
    """The gap needed of each row [the case's length]."""
    results = bentur.vary(case, pandas.DataFrame(design, columns=problem["names"]))
    return results.gap_needed.values.reshape(len(design), -1).max(axis=1)


# %%
design = sobol.sample(problem, 64, calc_second_order=False, seed=1)
found = shares.analyze(problem, needed(design), calc_second_order=False, seed=1)
for name, first, total in zip(problem["names"], found["S1"], found["ST"], strict=True):
    print(f"{name:20} first {first:.3f}, total {total:.3f}")
assert found["ST"].argmax() == 2  # the strength of the ground motion

# %%
design = morris.sample(problem, 20, seed=1)
values = needed(design)
effect = effects.analyze(problem, design, values, seed=1)
for name, mean in zip(problem["names"], effect["mu_star"], strict=True):
    print(f"{name:20} {mean:.4f} {case.to_dict()['units']['length']}")
assert effect["mu_star"].argmax() == 2

# %% [markdown]
# An elastic pair without contact moves in proportion to its ground motion.

# %%
one, two = needed([[0.05, 0.05, 150.0], [0.05, 0.05, 300.0]])
assert abs(two / one - 2) < 1e-9
