#pragma once

#include <array>
#include <cstddef>
#include <string_view>

#include "bentur/report/figures/figure.h"

namespace bentur {

/// A colour's name in CSS, on paper, and on a dark screen. All colours of figures and pages stand here; the studio's
/// page and the documentation take them from these lines.
struct Colour {
  const char *name, *paper, *dark;
};
inline constexpr Colour colours[] = {
    // in the order of Tone
    {"ink", "#000000", "#e8ebee"},         {"blue", "#143f7d", "#7fb4ee"},      {"orange", "#b4540a", "#f0a05c"},
    {"grey", "#5f6b76", "#a4aeb8"},        {"pale", "#d9d9d9", "#4a525a"},      {"pale-blue", "#c3d7ee", "#2c4a6b"},
    {"pale-orange", "#f2d3b8", "#6b4426"}, {"green", "#26480f", "#97cc74"},     {"purple", "#9054b2", "#cfa3e6"},
    {"red", "#b3191e", "#ff8a85"},         {"teal", "#0c6b70", "#5cc4c0"},      {"magenta", "#75154d", "#ef8fc4"},
    {"olive", "#746a00", "#cdc36a"},       {"amber", "#946200", "#f2c14e"},     {"indigo", "#332aa3", "#a39bff"},
    {"brown", "#935a37", "#c79a7f"},       {"cyan", "#007ba8", "#5fd0f5"},      {"navy", "#12284f", "#c9d6f5"},
    {"gold", "#d79a2b", "#b48326"},        {"pale-teal", "#b5dad7", "#2b5557"}, {"bark", "#3a2e26", "#e3d6c8"},
    {"stone", "#7b6e60", "#a8998a"},
};
inline constexpr Colour paper = {"paper", "#ffffff", "#15191d"};
/// Of pages, around the figures: lines of tables, grounds, edges of what can be pressed, links, and that all is well.
inline constexpr Colour page_colours[] = {
    {"rule", "#868f99", "#6c7580"},  {"band", "#f3f5f8", "#22282f"}, {"stage", "#fcfdfe", "#1a1f24"},
    {"mark", "#fdeceb", "#47262a"},  {"edge", "#7d8894", "#7c8894"}, {"link", "#1b5e9b", "#8ec1f2"},
    {"clear", "#24713b", "#7fd196"},
};

/// Of a map, from the begin of its scale to the end; those of a ratio are palest in the middle.
using Rgb = std::array<double, 3>;
inline constexpr Rgb one_way[] = {{255, 255, 224}, {199, 233, 180}, {127, 205, 187}, {65, 182, 196},
                                  {29, 145, 192},  {34, 94, 168},   {8, 29, 88}};
inline constexpr Rgb both_ways[] = {{31, 79, 138}, {111, 156, 203}, {245, 245, 245}, {221, 149, 88}, {148, 67, 10}};

/// Of two colours "#rrggbb", from 1 to 21: relative luminance and contrast ratio of WCAG 2.2.
[[nodiscard]] double contrast(std::string_view one, std::string_view other);

inline const Colour& colour(Tone tone) { return colours[static_cast<std::size_t>(tone)]; }

}  // namespace bentur
