#pragma once

namespace bentur::test {

/// A frame of three floors and one of two, whose floors strike each other's columns; their roofs meet.
inline const char* const struck_columns = R"(
[units]
length = "m"
force = "kN"

[[building]]
name = "West"
damping = 0.03

[building.frame]
elastic_modulus = 2.6e7
storey_heights = [3.0, 3.0, 2.5]
bay_widths = [4.0, 6.0]
columns = [{ width = 0.4, depth = 0.4, density = 2.4 }]
beams = [{ width = 0.3, depth = 0.5, density = 2.4 }]
floor_masses = 60

[[building]]
name = "East"
damping = 0.03

[building.frame]
elastic_modulus = 2.6e7
storey_heights = [4.4, 4.1]
bay_widths = [5.0, 3.5]
columns = [{ width = 0.5, depth = 0.5, density = 2.4 }]
beams = [{ width = 0.3, depth = 0.6, density = 2.4 }]
floor_masses = 50

[[gap]]
between = ["West", "East"]
width = 0.01
strikes_columns = true
elevations = [3.0, 4.4, 6.0, 8.5]
column_capacity = { shear = [400.0, 300.0, 400.0, 500.0], moment = 350.0 }
contact = { law = "linear", stiffness = 1e5 }

[excitation]
kind = "harmonic"
period = 0.5
displacement_amplitude = 0.02

[analysis]
duration = 4.0
output_step = 0.001
)";

}  // namespace bentur::test
