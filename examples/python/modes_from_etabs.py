# %% [markdown]
# # Modal tables from ETABS
#
# What ETABS exports, "Modal Periods And Frequencies", "Joint Displacements" at a floor's centre for each mode, and "Mass
# Summary by Story", as text. Periods, shapes and floor masses are all that `building.modal` needs.

# %%
import io

import numpy as np
import pandas

import bentur

PERIODS = """Case,Mode,Period,Frequency
Modal,1,0.722,1.386
Modal,2,0.272,3.671
Modal,3,0.181,5.528
"""
SHAPES = """Story,Mode,UX
Story4,1,0.0710
Story3,1,0.0597
Story2,1,0.0425
Story1,1,0.0223
Story4,2,-0.0681
Story3,2,0.0080
Story2,2,0.0586
Story1,2,0.0515
Story4,3,0.0451
Story3,3,-0.0691
Story2,3,0.0002
Story1,3,0.0599
"""
STORIES = """Story,Elevation,Mass
Story4,13.2,84.0
Story3,10.0,98.0
Story2,6.8,98.0
Story1,3.6,101.0
"""

# %% [markdown]
# ETABS lists storeys from the top, bentur from the bottom.

# %%
stories = pandas.read_csv(io.StringIO(STORIES)).sort_values("Elevation")
periods = pandas.read_csv(io.StringIO(PERIODS)).sort_values("Mode")
shapes = pandas.read_csv(io.StringIO(SHAPES)).pivot(index="Mode", columns="Story", values="UX")[stories["Story"]]

modal = bentur.Modal(
    elevations=stories["Elevation"].to_numpy(),
    masses=stories["Mass"].to_numpy(),
    periods=periods["Period"].to_numpy(),
    shapes=shapes.to_numpy(),
)

# %%
tables = bentur.example("two-frames-si").to_dict()
case = bentur.Case(
    units={"length": "m", "force": "kN"},
    building=[
        bentur.Building(name="From ETABS", damping=0.05, modal=modal),
        bentur.Building(
            name="Neighbour",
            damping=0.05,
            generic=bentur.Generic(storeys=4, storey_height=[3.6, 3.2, 3.2, 3.2], floor_mass=60.0, period=0.45, system="wall"),
        ),
    ],
    gap=[
        bentur.Gap(
            between=["From ETABS", "Neighbour"],
            width=0.04,
            contact=bentur.Contact(law="kelvin-voigt", stiffness=5.0e5, restitution=0.65),
        )
    ],
    excitation=tables["excitation"],
    folder=bentur.example("two-frames-si").folder,
)
result = bentur.run(case)
print(result)
given = result.summary["buildings"][0]["modal"]
print(f"shapes as given are orthogonal within {given['largest_product']:.3f}; three of four modes move")
print("of each floor's mass", np.round(given["mass_shares"], 3))

# %%
np.testing.assert_allclose(bentur.modes(case)["From ETABS"]["periods"], periods["Period"], rtol=1e-9)
assert result.impact_count > 0
