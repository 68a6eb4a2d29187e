"""The pair of docs/tutorials/teacher.md: what its first cell defines, for the cells that follow."""

import bentur


def pair(width, **contact):
    def one(name, stiffness):
        return bentur.Building(name=name, damping=0.05,
                               stick=bentur.Stick(storey_heights=[3.0], masses=[1e5], stiffnesses=[stiffness]))
    return bentur.Case(
        building=[one("soft", 4e6), one("stiff", 9e6)],
        gap=[bentur.Gap(between=["soft", "stiff"], width=width, contact=contact or {"law": "linear", "stiffness": 1e8})],
        excitation=bentur.Excitation(kind="harmonic", period=0.7, displacement_amplitude=0.02),
        analysis=bentur.Analysis(duration=10.0, energy_audit=True),
    )
