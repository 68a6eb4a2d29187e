"""Cases that several tests run."""

import bentur


def pair(**more):
    def stick(stiffness):
        return bentur.Stick(storey_heights=[3.0], masses=[1e5], stiffnesses=[stiffness])

    given = {
        "building": [
            bentur.Building(name="soft", damping=0.05, stick=stick(4e6)),
            bentur.Building(name="stiff", damping=0.05, stick=stick(9e6)),
        ],
        "gap": [bentur.Gap(between=["soft", "stiff"], width=0.02, contact=bentur.Contact(law="linear", stiffness=1e8))],
        "excitation": bentur.Excitation(kind="harmonic", period=0.5, displacement_amplitude=0.02),
        "analysis": bentur.Analysis(duration=10.0),
    }
    return bentur.Case(**{**given, **more})
