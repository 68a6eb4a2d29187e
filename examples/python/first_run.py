# %% [markdown]
# # A first pounding run
#
# Two buildings made in Python, 3 cm apart, under El Centro 1940: do they collide, how hard, how wide would the gap have
# to be? Run the cells one by one (VS Code, Spyder, Jupyter with jupytext), or the file as it is.

# %%
import bentur

# Units: m, kN, s; mass is then in t.

case = bentur.Case(
    title="Four and three storeys, 3 cm apart",
    units=bentur.Units(length="m", force="kN"),
    building=[
        bentur.Building(
            name="Tall",
            damping=0.05,
            stick=bentur.Stick(storey_heights=[3.2] * 4, masses=[60.0] * 4, stiffnesses=[6.0e4, 5.5e4, 5.0e4, 4.5e4]),
        ),
        bentur.Building(
            name="Low",
            damping=0.05,
            stick=bentur.Stick(storey_heights=[3.2] * 3, masses=[45.0, 45.0, 35.0], stiffnesses=[1.1e5, 1.0e5, 8.5e4]),
        ),
    ],
    gap=[
        bentur.Gap(
            between=["Tall", "Low"],
            width=0.03,
            contact=bentur.Contact(law="kelvin-voigt", stiffness=4.0e5, restitution=0.65),
        )
    ],
    excitation=bentur.Excitation(kind="record", file=bentur.example().folder / "../data/el-centro-1940-ns.csv", unit="g"),
)

# %% [markdown]
# The run. In a notebook `result` alone shows the first screen of the report, with the buildings in motion.

# %%
result = bentur.run(case)
print(result)

# %% [markdown]
# Every impact is a row; every peak is that of the continuous response, not of samples.

# %%
impacts = result.impacts
print(impacts[["elevation", "start", "duration", "peak_force", "restitution"]].head())
for building in result.summary["buildings"]:
    print(building["name"], "drift of", f"{100 * max(building['peak_drift_ratio']):.2f} %")

# %%
needed = bentur.minimum_gap(case)["gaps"][0]
print(f"needed: {1e3 * needed['gap_needed']:.0f} mm simulated, {1e3 * needed['srss']:.0f} mm by SRSS")

# %% [markdown]
# With a gap that is wide enough nothing touches.

# %%
apart = bentur.run(case.replace({"gap[0].width": 1.001 * needed["gap_needed"]}))
assert result.impact_count > 0
assert apart.impact_count == 0
