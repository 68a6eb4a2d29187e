# %% [markdown]
# # Comparing contact laws
#
# One pair of buildings, every law with the same restitution and as stiff as one another, and two laws of one's own.

# %%
import bentur

E = 0.65  # restitution
case = bentur.example("kelvin-voigt-pair").replace({"analysis.energy_audit": False})
points = bentur.run(case).summary["gaps"][0]["points"]
stiffness = max(float(point["contact"]["stiffness"]) for point in points)

laws: dict[str, bentur.Contact | bentur.ForceLaw | bentur.BranchLaw] = {
    "kelvin-voigt": bentur.Contact(law="kelvin-voigt", stiffness=stiffness, restitution=E),
    "on approach": bentur.Contact(law="kelvin-voigt-approach", stiffness=stiffness, restitution=E),
    "hertz-damp": bentur.Contact(law="hertz-damp", stiffness=10 * stiffness, restitution=E),
    "jankowski": bentur.Contact(law="jankowski", stiffness=10 * stiffness, restitution=E),
    "restitution": bentur.Contact(law="restitution", restitution=E),
    "linear": bentur.Contact(law="linear", stiffness=stiffness),
}

# %% [markdown]
# A law of one's own is a function of penetration and closing speed …

# %%


def rubber(penetration: float, speed: float) -> float:
    """A pad of 5 cm that stiffens as it is crushed, with some damping."""
    return 0.1 * stiffness * penetration / max(1 - penetration / 0.05, 0.02) * (1 + 0.3 * speed)


laws["rubber (a function)"] = bentur.ForceLaw(force=rubber, name="rubber")

# %% [markdown]
# … or branches with guards, which the exact solver takes as its own: a spring that softens 2 mm deep.

# %%
laws["two slopes (branches)"] = bentur.BranchLaw(
    name="two slopes",
    branches=[
        bentur.Branch(
            stiffness=stiffness,
            guards=[bentur.Guard(deformation=1.0, then=0), bentur.Guard(constant=0.002, deformation=-1.0, then=2)],
        ),
        bentur.Branch(
            base=0.001 * stiffness,
            stiffness=stiffness / 2,
            guards=[bentur.Guard(constant=-0.002, deformation=1.0, then=1)],
        ),
    ],
)

# %%
print(f"{'law':24}{'impacts':>8}{'hardest [kN]':>14}{'drift of Old [%]':>18}")
drifts = {}
for name, law in laws.items():
    result = bentur.run(case.replace({"gap[0].contact": law}), histories=False)
    peaks = result.impact_arrays["peak_force"]
    old = result.summary["buildings"][0]
    drifts[name] = 100 * max(old["peak_drift_ratio"])
    hardest = f"{peaks.max():.0f}" if peaks.max() > 0 else "–"
    print(f"{name:24}{result.impact_count:8}{hardest:>14}{drifts[name]:18.3f}")

# %% [markdown]
# What the building feels depends on the energy lost, hardly on the law that loses it (docs/modelling.md has 44 records).

# %%
same = [drifts[name] for name in ("kelvin-voigt", "on approach", "hertz-damp", "jankowski", "restitution")]
assert max(same) < 1.05 * min(same)
assert drifts["linear"] > 1.2 * max(same)
