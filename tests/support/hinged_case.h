#pragma once

namespace bentur::test {

/// A frame on bearings whose hinges form near resonance, beside one whose columns are struck between floors; each has
/// its limits of rotation, the second of its beams alone.
inline const char* const hinged = R"(
units = { length = "m", force = "kN" }
excitation = { kind = "harmonic", period = 0.9, displacement_amplitude = 0.06 }
analysis = { duration = 4.0 }
[[building]]
name = "Isolated"
damping = { mass_proportional = 0.1 }
isolation = { mass = 60.0, stiffness = 2e4 }
[building.frame]
elastic_modulus = 2.5e7
storey_heights = [3.5, 3.5]
bay_widths = [6.0, 4.0]
columns = [{ width = 0.3, depth = 0.4, mass = 0.0, moment_capacity = [60.0, 80.0, 70.0], hardening = 0.03, rotation_limits = [0.002, 0.006, 0.03] }]
beams = [{ width = 0.45, depth = 0.4, mass = 0.0, moment_capacity = [90.0, 120.0], hardening = 0.03, rotation_limits = [0.003, 0.01, 0.02] }]
floor_masses = [40.0, 40.0]
mass_matrix = "lumped"
[[building]]
name = "Struck"
damping = { mass_proportional = 0.1 }
[building.frame]
elastic_modulus = 2.5e7
storey_heights = [4.4, 4.4]
bay_widths = [5.0]
columns = [{ width = 0.3, depth = 0.4, density = 2.5, moment_capacity = 60.0, hardening = 0.03 }]
beams = [{ width = 0.45, depth = 0.4, mass = 0.0, moment_capacity = 50.0, hardening = 0.03, rotation_limits = [0.003, 0.01, 0.02] }]
floor_masses = [40.0, 30.0]
mass_matrix = "lumped"
[[gap]]
between = ["Isolated", "Struck"]
width = 0.03
elevations = [3.5, 7.0]
strikes_columns = true
contact = { law = "linear", stiffness = 2e4 }
)";

/// Without limits.
inline const char* const hinged_alone = R"(
units = { length = "m", force = "kN" }
excitation = { kind = "harmonic", period = 0.6, displacement_amplitude = 0.04 }
analysis = { duration = 3.0 }
[[building]]
name = "Frame"
damping = { mass_proportional = 0.1 }
[building.frame]
elastic_modulus = 2.5e7
storey_heights = [3.5, 3.5]
bay_widths = [6.0]
columns = [{ width = 0.3, depth = 0.4, mass = 0.0, moment_capacity = 150.0, hardening = 0.02 }]
beams = [{ width = 0.45, depth = 0.4, mass = 0.0, moment_capacity = 120.0, hardening = 0.02 }]
floor_masses = [40.0, 40.0]
mass_matrix = "lumped"
[[building]]
name = "Wall"
rigid = true
elevations = [7.0]
[[gap]]
between = ["Frame", "Wall"]
width = 0.03
contact = { law = "linear", stiffness = 2e4 }
)";

}  // namespace bentur::test
