#pragma once

namespace bentur::test {

/// An elastic building beside one that yields, with every kind of link between them.
inline const char* const yielding_case = R"(
[[building]]
name = "Elastic"
damping = 0.05
stick = { storey_heights = [3.0, 3.0], masses = [20e3, 18e3], stiffnesses = [60e6, 50e6] }

[[building]]
name = "Yields"
damping = { stiffness_proportional = 0.02 }

[building.stick]
storey_heights = [3.0, 3.0]
masses = [30e3, 25e3]
stiffnesses = [20e6, 15e6]
yield_forces = [6e4, 4e4]
hardening = [0.05, 0.02]
hysteresis = "peak-oriented"
unloading_exponent = 0.3

[[gap]]
between = ["Elastic", "Yields"]
width = 0.02
contact = { law = "linear", stiffness = 3e8 }

[[link]]
between = ["Elastic", "Yields"]
elevations = [3.0, 6.0]
law = "spring-dashpot"
stiffness = 1e5
damping = [1e3, 2e3]

[[link]]
between = ["Elastic", "Yields"]
elevations = [6.0]
law = "yielding"
stiffness = 2e6
yield_force = 1e4
hardening = 0.01

[[link]]
between = ["Elastic", "Yields"]
elevations = [6.0]
law = "cable"
stiffness = 1e6
slack = 0.01

[excitation]
kind = "harmonic"
period = 0.4
displacement_amplitude = 0.02

[analysis]
duration = 2.0
)";

}  // namespace bentur::test
