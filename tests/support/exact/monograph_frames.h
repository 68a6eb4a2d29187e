#pragma once

#include <array>

#include "bentur/structure/frame/plane_frame.h"

// The frames of the monograph's study (theory 6), Tables 1 and 3: cm, kgf, s; storeys and bay of 100 cm, E = 2.1e5
// kgf/cm², columns 10 × 10 cm of 0.024 kgf·s²/cm each.

namespace bentur::exact {

inline Section monograph_section(double width, double depth, double mass) {
  return {width * depth, width * depth * depth * depth / 12, mass};
}

/// Model 1 … 4 of Table 1.
inline PlaneFrame monograph_frame(int model) {
  constexpr std::array<std::array<double, 3>, 4> beam_masses = {
      {{0.206, 0.203, 0.203}, {0.202, 0.199, 0.199}, {0.801, 0.799, 0.799}, {0.081, 0.076, 0.076}}};
  const auto& mass = beam_masses.at(static_cast<std::size_t>(model - 1));
  const double depth = model == 1 ? 12 : 10;
  PlaneFrame frame;
  frame.elastic_modulus = 2.1e5;
  frame.storey_heights = {100, 100, 100};
  frame.bay_widths = {100};
  frame.columns.assign(3, monograph_section(10, 10, 0.024));
  frame.beams = {monograph_section(9, depth, mass[0]), monograph_section(8, depth, mass[1]),
                 monograph_section(8, depth, mass[2])};
  return frame;
}

/// Model 2 of Table 3, two storeys.
inline PlaneFrame monograph_two_storeys() {
  PlaneFrame frame = monograph_frame(2);
  frame.storey_heights = {100, 100};
  frame.columns.resize(2);
  frame.beams = {monograph_section(8, 10, 0.109), monograph_section(8, 10, 0.036)};
  return frame;
}

}  // namespace bentur::exact
