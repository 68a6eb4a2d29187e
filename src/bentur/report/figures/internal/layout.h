#pragma once

#include <string>
#include <vector>

#include "bentur/report/figures/figure.h"
#include "bentur/report/figures/internal/curve_names.h"
#include "bentur/report/figures/internal/legend.h"
#include "bentur/report/figures/internal/ticks.h"

namespace bentur {

/// Where one panel stands, in cm from the lower left corner of the figure.
struct PlacedPanel {
  const Panel* panel = nullptr;
  Ticks x = {}, y = {};
  double left = 0, right = 0, bottom = 0, top = 0;    ///< of the frame
  double cell_left = 0, cell_right = 0;               ///< of all its texts
  std::vector<std::string> title = {}, x_label = {};  ///< lines
  double title_y = 0, x_label_y = 0;                  ///< middle of the first line
  double x_label_x = 0, y_label_x = 0;                ///< middle
  Ticks scale = {};                                   ///< of the colours of a map
  double scale_label_x = 0;
  std::vector<LegendEntry> legend = {};
  std::vector<CurveName> names = {};  ///< of curves that are not in the legend
};

struct Layout {
  double width = 0, height = 0;  ///< [cm]
  std::vector<PlacedPanel> panels;
};

/// Where the lines of a text stand along x in a frame of this width: above or below a place within the frame, beside
/// which numbers stand [cm from its left edge].
[[nodiscard]] double text_x(const PlaceText& one, const std::vector<std::string>& lines, const Ticks& x, double width);

constexpr double scale_gap = 0.2, scale_thickness = 0.25;  ///< of a map's colours: from the frame, and across [cm]

/// Of what a figure shows of many things the lines below all panels, and their room [cm].
[[nodiscard]] std::vector<std::string> part_lines(const Figure& figure, const Layout& layout);
[[nodiscard]] double room_of_part(const std::vector<std::string>& lines);

/// Of the colours of a map that at a part of its scale, both from 0 to 1: 1 is in the middle of those of ratios.
[[nodiscard]] double colour_at(const HeatMap& map, const Ticks& scale, double along);

/// The lines of a text in a panel that is placed; none where it has no room.
[[nodiscard]] std::vector<std::string> text_lines(const PlaceText& one, const PlacedPanel& placed);

/// Places panels, numbers and legends so that no text lies on another or on a curve. @throws as check() does.
[[nodiscard]] Layout layout(const Figure& figure);

}  // namespace bentur
