#pragma once

#include <cstddef>
#include <functional>
#include <iterator>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace bentur {

// A figure as plain data: what is drawn, not how. Texts are shown as they are, whatever characters they have.

enum class Line { none, solid, dashed, dotted, dash_dot, long_dash, dash_dot_dot };
enum class Mark { none, disc, circle, square, triangle, diamond, cross };
/// Blue, orange, green, purple, magenta, olive, indigo, brown, cyan and navy are buildings, of many bark and stone by
/// turns; black, teal and grey all that is not, red blows and what is not enough, amber what nearly is; gold and pale
/// ones are for areas, where amber and teal would be as dark as red.
enum class Tone {
  black,
  blue,
  orange,
  grey,
  pale,
  pale_blue,
  pale_orange,
  green,
  purple,
  red,
  teal,
  magenta,
  olive,
  amber,
  indigo,
  brown,
  cyan,
  navy,
  gold,
  pale_teal,
  bark,
  stone
};
/// Those of buildings, in their order, dark and less dark by turns, so that neighbours are distinct in grey.
inline constexpr Tone building_tones[] = {Tone::blue,  Tone::orange, Tone::green, Tone::purple, Tone::magenta,
                                          Tone::olive, Tone::indigo, Tone::brown, Tone::navy,   Tone::cyan};
/// Two of many buildings, left and right.
using BuildingPair = std::optional<std::pair<std::size_t, std::size_t>>;
/// That of building number `index` of `count` in every picture, and of nothing else. Of more than ten buildings those
/// of the hardest impact have the first two, those of the gap that lacks most the next two, and all others bark and
/// stone by turns, which say nothing.
[[nodiscard]] Tone building_tone(std::size_t index, std::size_t count = std::size(building_tones),
                                 const BuildingPair& struck = {}, const BuildingPair& worst = {});
/// Whether lines of two tones are distinct on paper without colours; others need dashes.
[[nodiscard]] bool are_distinct_in_grey(Tone one, Tone other);

constexpr double column_width = 8.8;  ///< of a journal [cm]
constexpr double page_width = 17;     ///< [cm]
constexpr double page_height = 22;    ///< what a figure of many panels is no higher than [cm]

/// The texts of figures in another language, given the English ones; empty: these.
using FigureWords = std::function<std::string(std::string_view)>;

/// Points joined by a line, marks at them, or both; or an area.
struct Curve {
  std::string label = {};  ///< in the legend, and in data; empty: not there
  std::vector<double> x = {}, y = {};
  std::vector<double> top = {};  ///< where given, the area between y and top is filled in place of a line
  Tone tone = Tone::black;
  Line line = Line::solid;
  Mark mark = Mark::none;
  Mark legend_mark = Mark::none;  ///< on the line in the legend alone: that of another curve that goes with it
  double width = 1;               ///< of the line [-], 1 for 0.75 pt
  bool complete = false;          ///< every point is drawn; others are thinned to what can be seen
  double mark_size = 1;           ///< of its marks [-]; large discs have an edge that parts them from lines below
  bool of_several = false;        ///< its label is of several that are alike, so that it stands in the legend
  bool is_bar = false;            ///< a line around a bar, as which the legend shows it
  bool in_legend = true;          ///< else its label stands in data alone, as what it is of is named where it is
};

/// A short text beside a place of a panel.
struct PlaceText {
  enum class Side { right, left, above, below, middle };
  double x = 0, y = 0;
  std::string text = {};
  Side side = Side::right;
  /// How wide it may be, as x; more is set in lines, and of a word that is wider the text is not there. 0: as it is.
  double room = 0;
  Tone tone = Tone::black;
};

/// Instants marked along the upper edge of a panel.
struct Events {
  std::string label = {};
  std::vector<double> x = {};
};

/// A straight line across a panel: x = at where vertical, else y = at.
struct RuleLine {
  double at = 0;
  bool vertical = false;
  std::string label = {};  ///< in the legend; empty: not there
  Tone tone = Tone::grey;
  Line line = Line::solid;
};

/// Cells of one colour each: cell (i, j) lies between x_edges[i] and x_edges[i + 1], y_edges[j] and y_edges[j + 1].
struct HeatMap {
  std::vector<double> x_edges, y_edges;  ///< ascending
  std::vector<double> values;            ///< i fastest; NaN: nothing there
  std::string label;                     ///< of the scale, with its unit
  bool ratio = false;                    ///< colours diverge from 1, where nothing changes
  /// Ends of the scale; values beyond have the colour of the end. By default those of the data. The scale is
  /// logarithmic where half of all positive data would be squashed into a tenth of it.
  std::optional<std::pair<double, double>> range = {};
};

/// One axis of a panel.
struct Axis {
  /// With symbol and unit; empty: that of a neighbouring panel serves. That of one panel for a row of three or more
  /// whose axes have numbers stands below the middle of the row.
  std::string label = {};
  std::optional<double> from = {}, to = {};  ///< where the axis ends; by default round numbers beyond the data
  bool logarithmic = false;
  /// Of the places 0, 1, 2, …, where these are not numbers; of a picture to scale below it, at `places`.
  std::vector<std::string> names = {};
  std::vector<std::string> short_names = {};  ///< below a picture, where the names have no room in one line
  std::string number = "number";              ///< what its label calls the numbers that stand for names without room
  std::vector<double> places = {};  ///< where its numbers stand if there is room for all; else round numbers do
  bool numbers = true;              ///< has numbers; else those of a neighbouring panel serve
  /// What an axis without ends of its own shows at least, so that round-off does not look like a finding.
  std::optional<std::pair<double, double>> least = {};
};

/// One frame with its axes and what is drawn in it.
struct Panel {
  std::string title = {};
  Axis x = {}, y = {};
  double height = 4.2;      ///< of the frame [cm]
  int rows = 1;             ///< of the figure that it takes: of more than one as high as those beside it
  int across = 1;           ///< columns of the figure that it takes, from the first on where these are more than one
  bool begins_row = false;  ///< stands in the first column, some way below what is before it
  /// A picture of things: lengths are alike both ways, there are no axes but a label below, and the frame is at most
  /// as high as is needed.
  bool to_scale = false;
  std::string unit = {};  ///< of lengths of a picture to scale, for its data
  std::vector<Curve> curves = {};
  std::vector<RuleLine> rules = {};
  Events events = {};
  std::vector<PlaceText> texts = {};
  std::optional<HeatMap> map = {};
  /// Curves have their names where they end, in place of a legend, as far as there is room for that.
  bool names_at_ends = false;
  std::string note = {};  ///< in the middle of the frame, where there is little else to see
};

/// Panels in rows, from the upper left.
struct Figure {
  std::string title = {};    ///< what is shown, for the comment of the data file; not drawn
  std::string finding = {};  ///< what it tells, "peak 5,300 kN at 3.57 s", for readers who do not see it
  std::string part = {};     ///< what of many things it shows, "8 of 12 buildings"; a page says it below the caption
  std::string lacks = {};    ///< what of its kind is not there, "bounds": a page then has a caption of its own
  std::vector<Panel> panels = {};
  int columns = 1;                  ///< panels side by side
  std::vector<double> shares = {};  ///< of the columns in the width; empty: they are alike
  double width = column_width;      ///< of the whole [cm]
  bool shared_legend = false;       ///< one legend of all panels stands above them
};

/// The figure as SVG: texts are texts, measured in DejaVu Sans. The same figure gives the same bytes.
/// @throws InvalidParameter when a panel has nothing to draw, or sizes disagree.
[[nodiscard]] std::string figure_svg(const Figure& figure);

/// The same as an element of a page, whose style sheet holds page_style(). `label`: what it says, before the
/// finding, to readers who do not see it.
[[nodiscard]] std::string figure_element(const Figure& figure, std::string_view label);

/// Whether some line goes up and down so often that its envelope is drawn in its place.
[[nodiscard]] bool has_bands(const Figure& figure);

/// The letters of a figure that DejaVu Sans, the font it names first, has not, each once; most machines have some other
/// font for them, and where none has, boxes stand in their place.
[[nodiscard]] std::string letters_beyond_font(const Figure& figure);

/// Where the frame of a panel stands in a figure [px], from the upper left corner, and the values at its ends.
struct PanelPlace {
  double left = 0, top = 0, width = 0, height = 0;
  std::pair<double, double> x = {}, y = {};
  bool x_logarithmic = false, y_logarithmic = false;
};
/// figure_element() with the places of its panels, in their order.
struct PlacedFigure {
  std::string svg;
  std::vector<PanelPlace> panels;
};
[[nodiscard]] PlacedFigure placed_figure(const Figure& figure, std::string_view label);

/// The colours of figures on paper, each with its name: "blue", "#143f7d".
[[nodiscard]] std::vector<std::pair<std::string, std::string>> palette();

/// Those of buildings, in their order.
[[nodiscard]] std::vector<std::string> building_colours();

/// The colours of figures as CSS, on paper and on a dark screen, for a figure that stands alone and for a page, whose
/// own are among them.
[[nodiscard]] std::string figure_style();
[[nodiscard]] std::string page_style();

/// The colour of a map, or of a map of ratios, at a part of its scale from 0 to 1: "#ffffe0".
[[nodiscard]] std::string shade(double part, bool ratio);

/// What is needed to draw the figure in another style: a script in Python with matplotlib and the table it reads,
/// NAME-data.csv, whose columns stand side by side, each below what it is. The same figure gives the same texts.
/// @throws InvalidParameter as figure_svg().
struct FigureText {
  std::string data, script;
};
[[nodiscard]] FigureText figure_text(const Figure& figure, const std::string& name);

}  // namespace bentur
