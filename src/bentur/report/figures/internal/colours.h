#pragma once

#include <cstddef>

#include "bentur/report/figures/figure.h"

namespace bentur {

/// A colour's name in CSS, on paper, and on a dark screen.
struct Colour {
  const char *name, *paper, *dark;
};
inline constexpr Colour colours[] = {
    // in the order of Tone
    {"ink", "#000000", "#e8ebee"},         {"blue", "#1f5fa8", "#7fb4ee"},  {"orange", "#b4540a", "#f0a05c"},
    {"grey", "#5f6b76", "#a4aeb8"},        {"pale", "#d9d9d9", "#4a525a"},  {"pale-blue", "#c3d7ee", "#2c4a6b"},
    {"pale-orange", "#f2d3b8", "#6b4426"}, {"green", "#3d6b20", "#97cc74"}, {"purple", "#7d4a9c", "#cfa3e6"},
    {"red", "#b3191e", "#ff8a85"},         {"teal", "#0c6b70", "#5cc4c0"},  {"magenta", "#a3276f", "#ef8fc4"},
    {"olive", "#686000", "#cdc36a"},       {"amber", "#946200", "#f2c14e"},
};
inline constexpr Colour paper = {"paper", "#ffffff", "#15191d"};

inline const Colour& colour(Tone tone) { return colours[static_cast<std::size_t>(tone)]; }

}  // namespace bentur
