#pragma once

#include <string>
#include <vector>

#include "bentur/report/figures/figure.h"

namespace bentur {

// Room [cm].
constexpr double line_height = 0.38;
constexpr double sample_width = 0.7;               ///< of the line in front of a legend's text
constexpr double sample_height = 7.6 * 2.54 / 96;  ///< of an area there
constexpr double beside_sample = 0.1;              ///< between it and the text
constexpr double events_height = 0.09;             ///< of a frame, kept free for marks along its upper edge
constexpr std::size_t most_lines = 4;              ///< of a title, or of a label in a legend

struct PlacedPanel;

/// One line of a legend.
struct LegendEntry {
  std::string label;
  Tone tone = Tone::black;
  Line line = Line::none;
  Mark mark = Mark::none;
  double width = 1;
  bool area = false, event = false;
  bool outline = false;  ///< of an area
  double mark_size = 1;
  double x = 0, y = 0;  ///< left end and middle height in the figure, from its lower left corner [cm]
};

/// A text in lines no wider than `width` [cm], divided at spaces; of more than `most` lines, and of words that are too
/// wide, the end is cut.
[[nodiscard]] std::vector<std::string> lines_of(const std::string& text, double width, std::size_t most);

/// Adds the entries of a panel but those of curves that are named where they end; what has a label that is there
/// already is the same.
void add_entries(const PlacedPanel& placed, std::vector<LegendEntry>& list);

/// Places the entries in rows and columns within a width, or where that takes some lines fewer one behind the other, x
/// and y measured from the upper left corner; labels that are too long go on below. @return the height they take [cm]
double arrange(std::vector<LegendEntry>& list, double width);

/// Moves entries to the right, so that they stand about `middle` but end within `width`.
void centre(std::vector<LegendEntry>& list, double middle, double width);

void shift(std::vector<LegendEntry>& list, double right, double up);

}  // namespace bentur
