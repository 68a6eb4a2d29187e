#pragma once

#include <string>
#include <vector>

#include "bentur/report/figures/figure.h"
#include "bentur/report/figures/internal/ticks.h"

namespace bentur {

// Room [cm].
constexpr double line_height = 0.38;
constexpr double sample_width = 0.7;               ///< of the line in front of a legend's text
constexpr double sample_height = 7.6 * 2.54 / 96;  ///< of an area there
constexpr double beside_sample = 0.1;              ///< between it and the text
constexpr double events_height = 0.09;             ///< of a frame, kept free for marks along its upper edge

/// One line of a legend.
struct LegendEntry {
  std::string label;
  Tone tone = Tone::black;
  Line line = Line::none;
  Mark mark = Mark::none;
  double width = 1;
  bool area = false, event = false;
  double mark_size = 1;
  double x = 0, y = 0;  ///< left end and middle height in the figure, from its lower left corner [cm]
};

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
};

struct Layout {
  double width = 0, height = 0;  ///< [cm]
  std::vector<PlacedPanel> panels;
};

/// Of the colours of a map that at a part of its scale, both from 0 to 1: 1 is in the middle of those of ratios.
[[nodiscard]] double colour_at(const HeatMap& map, const Ticks& scale, double along);

/// The lines of a text in a panel that is placed; none where it has no room.
[[nodiscard]] std::vector<std::string> text_lines(const PlaceText& one, const PlacedPanel& placed);

/// Places panels, numbers and legends so that no text lies on another or on a curve. @throws as check() does.
[[nodiscard]] Layout layout(const Figure& figure);

}  // namespace bentur
