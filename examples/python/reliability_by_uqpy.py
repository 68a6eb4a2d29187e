# %% [markdown]
# # How likely is a gap too small, by UQpy
#
# UQpy draws the inputs, bentur runs the rows, and the share of those that need more than the gap is the probability.

# %%
import numpy as np
import pandas
from UQpy.distributions import Lognormal, Uniform
from UQpy.sampling import LatinHypercubeSampling

import bentur

case = bentur.example("m12-el-centro")
inputs = {
    "building[0].damping": Uniform(0.02, 0.05),
    "building[1].damping": Uniform(0.02, 0.05),
    "excitation.pga": Lognormal(s=0.3, scale=300.0),
}
drawn = LatinHypercubeSampling(distributions=list(inputs.values()), nsamples=200, random_state=1)
rows = pandas.DataFrame(drawn.samples, columns=list(inputs))
results = bentur.vary(case, rows)
needed = results.gap_needed.values.reshape(len(rows), -1).max(axis=1)

# %%
for width in (0.3, 0.4, 0.5, 0.6):
    share = float((needed > width).mean())
    print(f"{width} {results.gap_needed.units}: too small with a probability of {share:.3f} ± {np.sqrt(share * (1 - share) / len(rows)):.3f}")

# %% [markdown]
# The need is nearly in proportion to the lognormal peak, so that its own dispersion is about that of the peak.

# %%
assert 0.25 < np.log(needed).std() < 0.4
