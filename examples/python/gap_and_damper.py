# %% [markdown]
# # Gap and damper, chosen together
#
# As a researcher writes it: an objective in Python, the solver inside it, scipy around it. How strong a damper between
# two buildings, and how wide a gap, for the least cost where they must not collide?

# %%
import numpy as np
from scipy.optimize import minimize_scalar

import bentur

case = bentur.example("linked-pair")
tables = case.to_dict()
tables["link"] = [
    {"between": ["Tall", "Low"], "elevations": [9.6], "law": "spring-dashpot", "stiffness": 0.0, "damping": 1.0}
]
pair = bentur.Case.from_dict(tables, folder=case.folder)


def needed(damping: float) -> float:
    """The gap [m] that keeps the buildings apart with this damper [kN·s/m] at the roof of the low one."""
    return float(bentur.minimum_gap(pair.replace({"link[0].damping": damping}))["gaps"][0]["gap_needed"])


# %% [markdown]
# The gap needed falls with the damper, the more slowly the stronger it is.

# %%
dampings = np.geomspace(10.0, 10000.0, 13)
gaps = np.array([needed(c) for c in dampings])
for c, gap in zip(dampings, gaps, strict=True):
    print(f"{c:8.0f} kN·s/m {1e3 * gap:7.1f} mm")

# %% [markdown]
# The cost: land at 1 per mm of gap, the damper at 0.02 per kN·s/m.

# %%
price_of_land, price_of_damper = 1.0, 0.02


def cost(exponent: float) -> float:
    damping = 10.0**exponent
    return float(1e3 * needed(damping) * price_of_land + damping * price_of_damper)


best = minimize_scalar(cost, bounds=(1.0, 4.0), method="bounded", options={"xatol": 1e-3})
damping = 10.0**best.x
gap = needed(damping)
print(f"damper {damping:.0f} kN·s/m, gap {1e3 * gap:.1f} mm, cost {best.fun:.1f}, {best.nfev} runs")

# %%
chosen = bentur.run(pair.replace({"link[0].damping": damping, "gap[0].width": 1.0001 * gap}))
assert chosen.impact_count == 0
assert best.fun <= min(1e3 * gaps * price_of_land + dampings * price_of_damper)
