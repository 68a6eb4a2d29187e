#pragma once

namespace bentur::test {

/// A wall, a building on bearings, one on soil that may collapse, one known by its modes and one known by little.
inline const char* const every_kind = R"(
[units]
length = "m"
force = "kN"

[[building]]
name = "Wall"
rigid = true
elevations = [0.0]

[[building]]
name = "Isolated"
damping = 0.02
stick = { storey_heights = [3.0], masses = [100.0], stiffnesses = [9e4] }
isolation = { mass = 80.0, friction_pendulum = { coefficient = 0.05, radius = 2.0, yield_displacement = 0.001 } }

[[building]]
name = "Weak"
damping = 0.03
p_delta = true
stick = { storey_heights = [3.0, 3.0], masses = [80, 70], stiffnesses = [3e4, 2.5e4], yield_forces = [150, 120] }

[building.soil]
half_space = { shear_wave_velocity = 200.0, density = 1.9, poisson = 0.33, radius = 6.0 }
foundation = { mass = 100.0, inertia = 900.0 }

[[building]]
name = "Modes"
damping = 0.03
modal = { elevations = [3.0, 6.0], masses = [60, 50], periods = [0.4, 0.15], shapes = [[0.6, 1.0], [1.0, -0.72]] }

[[building]]
name = "Little"
damping = 0.03
generic = { storeys = 2, storey_height = 3.0, floor_mass = 90.0, period = 0.5, stiffness_ratio = 30.0 }

[[gap]]
between = ["Wall", "Isolated"]
width = 0.05
contact = { law = "linear", stiffness = 3e5 }

[[gap]]
between = ["Isolated", "Weak"]
width = 0.05
contact = { law = "linear", stiffness = 3e5 }

[[gap]]
between = ["Weak", "Modes"]
width = 0.03
contact = { law = "linear", stiffness = 3e5 }

[[gap]]
between = ["Modes", "Little"]
width = 0.03
contact = { law = "linear", stiffness = 3e5 }

[excitation]
kind = "harmonic"
period = 0.6
displacement_amplitude = 0.002

[analysis]
duration = 3.0
collapse_drift = 0.03
)";

}  // namespace bentur::test
