#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <nlohmann/json.hpp>
#include <span>

#include "bentur/io/output/result_kind.h"
#include "bentur/io/results/result_csv.h"
#include "bentur/report/figures/figure.h"
#include "bentur/report/figures/internal/colours.h"
#include "bentur/report/figures/internal/layout.h"
#include "bentur/report/figures/internal/text.h"
#include "bentur/report/figures/internal/visible.h"

namespace bentur {
namespace {

using Json = nlohmann::ordered_json;

// In matplotlib's terms, in the order of Line and Mark; how wide marks are [pt].
constexpr const char* lines[] = {"None", "-", "--", ":", "-.", "long-dash", "dash-dot-dot"};
constexpr const char* marks[] = {"None", "o", "o", "s", "^", "D", "x"};
constexpr double mark_sizes[] = {0, 2.4, 2.7, 2.6, 3, 2.4, 2.7};

/// What every script does with its figure.
constexpr const char* drawing = R"(
# Without this folder, whose files may be named as modules are.
sys.path = [path for path in sys.path if pathlib.Path(path or ".").resolve() != here.parent]
import matplotlib.patheffects as edges
import matplotlib.pyplot as plt
from matplotlib.collections import PatchCollection
from matplotlib.colors import LogNorm, Normalize, to_rgba
from matplotlib.lines import Line2D
from matplotlib.patches import Rectangle
from matplotlib.ticker import NullFormatter

with here.with_name(figure["data"]).open(newline="", encoding="utf-8") as file:
    columns = list(zip(*list(csv.reader(file))[1:]))

dashes = {"long-dash": (0, (9, 2.3)), "dash-dot-dot": (0, (5, 1.9, 1.5, 1.9, 1.5, 1.9))}


def values(column):
    return [float(cell) for cell in columns[column] if cell]


def style(of):
    """Of a line with its marks: open ones show what is below them, large ones have an edge."""
    large = of["mark_size"] >= 1.5
    inside, edge = (of["color"], "white" if large else of["color"]) if of["filled"] else (
        "white" if large else "none", of["color"])
    return {"color": of["color"], "linestyle": dashes.get(of["line"], of["line"]), "linewidth": 0.75 * of["width"], "marker": of["mark"],
            "markersize": of["mark_points"] * of["mark_size"], "markerfacecolor": inside, "markeredgecolor": edge,
            "markeredgewidth": 0.75}


plt.rcParams.update({"font.size": 8, "axes.linewidth": 0.5, "svg.fonttype": "none", "text.parse_math": False,
                     "lines.dashed_pattern": [4.6, 2.3], "lines.dotted_pattern": [1.5, 1.7],
                     "lines.dashdot_pattern": [5, 1.9, 1.5, 1.9]})
sheet = plt.figure(figsize=figure["size"])
for panel in figure["panels"]:
    ax = sheet.add_axes(panel["place"])
    for number, curve in enumerate(panel["curves"]):  # each over those before it, marks over all lines
        data = [values(column) for column in curve["columns"]]
        order = 1 + number / len(panel["curves"])
        if len(data) == 3:
            edge = {"edgecolor": curve["color"], "linewidth": 0.5} if curve["band"] else {"linewidth": 0}
            ax.fill_between(*data, facecolor=to_rgba(curve["color"], curve["band"] or 1), label=curve["label"], zorder=order, **edge)
            continue
        if curve["line"] != "None":
            ax.plot(*data, label=curve["label"], zorder=order, **{**style(curve), "marker": "None"})
        if curve["mark"] != "None":
            ax.plot(*data, label=curve["label"], zorder=order + 1, **{**style(curve), "linestyle": "None"})
    for rule in panel["rules"]:
        (ax.axvline if rule["vertical"] else ax.axhline)(
            rule["at"], linestyle=dashes.get(rule["line"], rule["line"]), color=rule["color"], label=rule["label"], linewidth=0.5, zorder=0.5)
    for event in panel["events"]:
        times = values(event["column"])
        ax.plot(times, [0.97] * len(times), "v", transform=ax.get_xaxis_transform(), color=event["color"], markersize=2,
                markeredgewidth=0.75, label=event["label"])
    for x, y, text, across, up, color, moved in panel["texts"]:
        joined = {"arrowstyle": "-", "color": color, "linewidth": 0.5, "shrinkA": 0, "shrinkB": 0} if moved else None
        ax.annotate(text, (x, y), (4 * across, 4 * up + moved), textcoords="offset points", color=color,
                    arrowprops=joined, annotation_clip=False,
                    path_effects=[edges.withStroke(linewidth=1.8, foreground="white")],
                    ha=("right", "center", "left")[across + 1], va=("top", "center", "bottom")[up + 1])
    for scale in panel["map"]:
        cells = list(zip(*(values(column) for column in scale["columns"])))
        norm = (LogNorm if scale["logarithmic"] else Normalize)(*scale["range"], clip=True)
        boxes = PatchCollection([Rectangle((x0, y0), x1 - x0, y1 - y0) for _, _, x0, x1, y0, y1, _ in cells],
                                cmap="PuOr_r" if scale["ratio"] else "YlGnBu", norm=norm, zorder=0)
        boxes.set_array([cell[-1] for cell in cells])
        ax.add_collection(boxes)
        bar = sheet.colorbar(boxes, cax=sheet.add_axes(scale["place"], label="<colorbar>"))
        bar.set_ticks(scale["ticks"], labels=scale["numbers"])
        bar.minorticks_off()
        bar.ax.tick_params(width=0.5, length=2.3, direction="in", pad=2.8)
        sheet.text(*scale["label_at"], scale["label"], rotation=90, ha="center", va="center")
    for axis, name in (ax.xaxis, "x"), (ax.yaxis, "y"):
        wanted = panel[name]
        getattr(ax, f"set_{name}scale")("log" if wanted["logarithmic"] else "linear")
        getattr(ax, f"set_{name}lim")(*wanted["range"])
        axis.set_ticks(wanted["ticks"], wanted["numbers"])
        axis.set_ticks(wanted["minor"], minor=True)
        axis.set_minor_formatter(NullFormatter())
        axis.set_label_text(wanted["label"], ha="center", va="center")
        axis.set_label_coords(*wanted["label_at"], transform=sheet.transFigure)
    ax.tick_params(which="both", direction="in", top=True, right=True, width=0.5, length=2.7, pad=3.4)
    ax.tick_params(which="minor", length=1.5)
    ax.tick_params("x", pad=5.5)
    if panel["to_scale"]:
        ax.set_frame_on(False)
        ax.tick_params(length=0)
    if panel["upright"]:
        ax.tick_params("x", rotation=90)
    if panel["note"]:
        ax.text(0.5, 0.5, panel["note"], transform=ax.transAxes, ha="center")
    if panel["title"]:
        ax.set_title("\n".join(panel["title"]), fontsize=8, y=panel["title_y"], pad=0, verticalalignment="center")
    for entry in panel["legend"]:
        begin, end, text, y = entry["place"]
        if entry["area"] or entry["outline"]:
            sheet.add_artist(Rectangle((begin, y - entry["half"]), end - begin, 2 * entry["half"],
                                       transform=sheet.transFigure, edgecolor=entry["color"],
                                       facecolor="none" if entry["outline"] else entry["color"],
                                       linewidth=0.75 if entry["outline"] else 0))
        else:
            ends = {**style(entry), "marker": "None"}
            sheet.add_artist(Line2D([begin, end], [y, y], transform=sheet.transFigure, **ends))
            at = {**style(entry), "linestyle": "None"}
            sheet.add_artist(Line2D([(begin + end) / 2], [y], transform=sheet.transFigure, **at))
        sheet.text(text, y, entry["label"], verticalalignment="center")
if figure["part"]:
    sheet.text(0.5, figure["part_at"], figure["part"], ha="center", va="center")
sheet.savefig(sys.argv[1] if len(sys.argv) > 1 else here.with_name(here.stem + "-drawn.svg"), dpi=300)
)";

/// Data and description grow together.
class Writer {
 public:
  explicit Writer(const Figure& figure)
      : layout_(layout(figure)),
        part_(part_lines(figure, layout_)),
        below_(room_of_part(part_)),
        height_(layout_.height + below_) {}

  FigureText write(const std::string& name) {
    // What JSON and Python write alike: numbers, texts, lists and tables, and no true, false or null.
    std::string panels;
    for (const PlacedPanel& placed : layout_.panels) {
      std::string members;
      const Json described = panel(placed);
      for (const auto& [key, value] : described.items()) {
        members += fmt::format("  {}: {},\n", Json(key).dump(), value.dump());
      }
      panels += fmt::format(" {{\n{} }},\n", members);
    }
    const Json size = {layout_.width / 2.54, height_ / 2.54};
    const double part_at = up(-line_height * static_cast<double>(part_.size()) / 2);  // the middle of its lines
    const std::string figure = fmt::format(R"({{"data": {}, "size": {}, "part": {}, "part_at": {}, "panels": [)"
                                           "\n{}]}}",
                                           Json(name + std::string(figure_data_ending)).dump(), size.dump(),
                                           Json(plain_lines(part_)).dump(), Json(part_at).dump(), panels);
    std::string script = fmt::format(
        "{}, by matplotlib: python3 THIS [FILE]\n"
        "# FILE ends in .svg, .pdf or .png. Change at will how it looks.\n"
        "import csv\nimport pathlib\nimport sys\n\nhere = pathlib.Path(__file__).resolve()\nfigure = {}\n{}",
        figure_script_mark, figure, drawing);
    return {table(), std::move(script)};
  }

 private:
  /// No two headings are alike: of what is there again the number is added.
  std::size_t column(const std::string& heading, std::span<const double> values) {
    const std::string first = plain_text(heading);
    std::string name = first;
    const auto is_there = [&] { return std::find(headings_.begin(), headings_.end(), name) != headings_.end(); };
    for (int n = 2; is_there(); ++n) name = fmt::format("{}, {}", first, n);
    headings_.push_back(std::move(name));
    columns_.emplace_back(values.begin(), values.end());
    return columns_.size() - 1;
  }

  /// The columns side by side, the shorter ones with nothing below their last value.
  [[nodiscard]] std::string table() const {
    std::string text;
    std::size_t longest = 0;
    for (std::size_t c = 0; c < headings_.size(); ++c) {
      text += (c > 0 ? "," : "") + csv_field(headings_[c]);
      longest = std::max(longest, columns_[c].size());
    }
    text += '\n';
    for (std::size_t row = 0; row < longest; ++row) {
      for (std::size_t c = 0; c < columns_.size(); ++c) {
        if (c > 0) text += ',';
        if (row >= columns_[c].size()) continue;
        const double value = columns_[c][row];
        text += std::isnan(value) ? "nan" : fmt::format("{}", value);
      }
      text += '\n';
    }
    return text;
  }

  static std::string plain_lines(const std::vector<std::string>& lines) {
    std::string text;
    for (const std::string& line : lines) text += (text.empty() ? "" : "\n") + plain_text(line);
    return text;
  }

  /// A place in the layout as a part of the sheet.
  [[nodiscard]] double across(double cm) const { return cm / layout_.width; }
  [[nodiscard]] double up(double cm) const { return (cm + below_) / height_; }

  /// @param label its lines, around (x, y) [cm]
  [[nodiscard]] Json axis(const Axis& axis, const Ticks& ticks, bool to_scale, const std::string& label, double x,
                          double y) const {
    Json places = Json::array(), numbers = Json::array();
    for (const auto& [at, text] : ticks.labels) {
      const std::string above(numbers.size() % static_cast<std::size_t>(ticks.lines), '\n');
      places.push_back(at);
      numbers.push_back(axis.numbers || to_scale ? above + plain_text(text) : "");
    }
    return {{"label", label},
            {"label_at", {across(x), up(y)}},
            {"range", {ticks.from, ticks.to}},
            {"logarithmic", static_cast<int>(ticks.logarithmic)},
            {"ticks", std::move(places)},
            {"minor", ticks.minor},
            {"numbers", std::move(numbers)}};
  }

  Json panel(const PlacedPanel& placed) {
    const Panel& panel = *placed.panel;
    title_ = panel.title.empty() ? "" : panel.title + ": ";
    Json title = Json::array();
    for (const std::string& text : placed.title) title.push_back(plain_text(text));
    const double middle = placed.title_y - line_height * (static_cast<double>(title.size()) - 1) / 2;
    Json curves = Json::array(), rules = Json::array(), events = Json::array(), map = Json::array();
    if (panel.map) map.push_back(cells(placed));
    for (const Curve& one : panel.curves) curves.push_back(curve(placed, one));
    for (const RuleLine& rule : panel.rules) {
      const Ticks& across = rule.vertical ? placed.x : placed.y;
      if (rule.at < across.from || rule.at > across.to) continue;
      rules.push_back({{"at", rule.at},
                       {"vertical", static_cast<int>(rule.vertical)},
                       {"label", plain_text(rule.label)},
                       {"color", colour(rule.tone).paper},
                       {"line", lines[static_cast<std::size_t>(rule.line)]}});
    }
    std::vector<double> instants = panel.events.x;
    std::erase_if(instants, [&](double at) { return at < placed.x.from || at > placed.x.to; });
    if (!instants.empty()) {
      events.push_back({{"label", plain_text(panel.events.label)},
                        {"color", colour(Tone::grey).paper},
                        {"column", column(title_ + panel.events.label, instants)}});
    }
    Json texts = Json::array();
    constexpr std::pair<int, int> sides[] = {// in the order of PlaceText::Side
                                             {1, 0},
                                             {-1, 0},
                                             {0, 1},
                                             {0, -1},
                                             {0, 0}};
    const double width = placed.right - placed.left;
    const auto add = [&](const PlaceText& one, const std::vector<std::string>& text, Tone tone, double moved) {
      const auto& [across, up] = sides[static_cast<std::size_t>(one.side)];
      const double at = along(placed.x, one.x), shown = text_x(one, text, placed.x, width);
      const double x = shown == at * width ? one.x : value_at(placed.x, shown / width);
      if (!text.empty()) texts.push_back({x, one.y, plain_lines(text), across, up, colour(tone).paper, moved});
    };
    for (const PlaceText& one : panel.texts) add(one, text_lines(one, placed), one.tone, 0);
    constexpr double points = 72 / 2.54;  // of a centimetre
    for (const CurveName& name : placed.names) {
      const double moved = std::abs(name.up) > 0.02 ? name.up * points : 0;
      add({.x = name.x, .y = name.y, .side = name.side}, {name.label}, panel.curves[name.curve].tone, moved);
    }
    const double height = placed.top - placed.bottom;
    Json legend = Json::array();
    for (const LegendEntry& entry : placed.legend) legend.push_back(entry_of(entry));
    return {{"place", {across(placed.left), up(placed.bottom), across(placed.right - placed.left), height / height_}},
            {"title", std::move(title)},
            {"title_y", (middle - placed.bottom) / height},
            {"note", plain_text(panel.note)},
            {"to_scale", static_cast<int>(panel.to_scale)},
            {"legend", std::move(legend)},
            {"upright", static_cast<int>(placed.x.upright)},
            {"x", axis(panel.x, placed.x, panel.to_scale, plain_lines(placed.x_label), placed.x_label_x,
                       placed.x_label_y -
                           line_height * (std::max(1.0, static_cast<double>(placed.x_label.size())) - 1) / 2)},
            {"y", axis(panel.y, placed.y, panel.to_scale, plain_text(scaled(panel.y.label, placed.y, panel.y.number)),
                       placed.y_label_x, (placed.bottom + placed.top) / 2)},
            {"curves", std::move(curves)},
            {"rules", std::move(rules)},
            {"events", std::move(events)},
            {"texts", std::move(texts)},
            {"map", std::move(map)}};
  }

  /// What an axis is of: of one without a label that of the first other panel that has, of a picture to scale lengths.
  [[nodiscard]] std::string label(const PlacedPanel& placed, Axis Panel::*axis) const {
    if (const Panel& panel = *placed.panel; panel.to_scale) {
      const std::string name = axis == &Panel::x ? "x" : "y";
      return panel.unit.empty() ? name : with_unit(name, panel.unit);
    }
    std::string label = (placed.panel->*axis).label;
    for (const PlacedPanel& other : layout_.panels) {
      if (label.empty() && !other.panel->to_scale) label = (other.panel->*axis).label;
    }
    return label;
  }

  Json curve(const PlacedPanel& placed, const Curve& curve) {
    const std::string of = curve.label.empty() ? "" : " (" + curve.label + ")";
    const std::string x = title_ + label(placed, &Panel::x) + of, y = title_ + label(placed, &Panel::y) + of;
    const Points points = visible(curve, placed.right - placed.left);
    Json columns;
    if (points.top.empty()) {
      columns = {column(x, points.x), column(y, points.y)};
    } else {
      columns = {column(x, points.x), column(y + ", from", points.y), column(y + ", to", points.top)};
    }
    Json described = {{"label", plain_text(curve.label)}, {"columns", std::move(columns)}};
    described.update(drawn(curve.tone, curve.line, curve.mark, curve.width, curve.mark_size));
    described["band"] = points.top.empty() || !curve.top.empty() ? 0 : band_opacity;
    return described;
  }

  static Json drawn(Tone tone, Line line, Mark mark, double width, double mark_size) {
    return {{"color", colour(tone).paper},
            {"line", lines[static_cast<std::size_t>(line)]},
            {"mark", marks[static_cast<std::size_t>(mark)]},
            {"filled", static_cast<int>(mark == Mark::disc)},
            {"width", width},
            {"mark_points", mark_sizes[static_cast<std::size_t>(mark)]},
            {"mark_size", mark_size}};
  }

  /// Where its line begins and ends, where its text begins, and at what height.
  [[nodiscard]] Json entry_of(const LegendEntry& entry) const {
    const double end = entry.x + sample_width;
    Json described = {{"label", plain_text(entry.label)},
                      {"place", {across(entry.x), across(end), across(end + beside_sample), up(entry.y)}},
                      {"area", static_cast<int>(entry.area)},
                      {"outline", static_cast<int>(entry.outline)},
                      {"half", sample_height / 2 / height_}};
    described.update(
        drawn(entry.event ? Tone::grey : entry.tone, entry.line, entry.mark, entry.width, entry.mark_size));
    if (entry.event) described.update({{"mark", "v"}, {"filled", 1}, {"mark_points", 2.0}});
    return described;
  }

  Json cells(const PlacedPanel& placed) {
    const HeatMap map = merged(*placed.panel->map);
    const std::size_t nx = map.x_edges.size() - 1;
    std::vector<double> parts[7];
    for (std::size_t i = 0; i < map.values.size(); ++i) {
      if (!std::isfinite(map.values[i]) || (map.ratio && map.values[i] <= 0)) continue;
      const double *x = &map.x_edges[i % nx], *y = &map.y_edges[i / nx];
      const double row[] = {(x[0] + x[1]) / 2, (y[0] + y[1]) / 2, x[0], x[1], y[0], y[1], map.values[i]};
      for (std::size_t c = 0; c < 7; ++c) parts[c].push_back(row[c]);
    }
    const std::string x = title_ + label(placed, &Panel::x), y = title_ + label(placed, &Panel::y);
    const std::string headings[] = {x, y, x + ", from", x + ", to", y + ", from", y + ", to", title_ + map.label};
    Json columns = Json::array();
    for (std::size_t c = 0; c < 7; ++c) columns.push_back(column(headings[c], parts[c]));
    Ticks scale = placed.scale;
    Json places = Json::array(), numbers = Json::array();
    for (const auto& [at, text] : scale.labels) {
      places.push_back(at);
      numbers.push_back(plain_text(text));
    }
    if (map.ratio) {  // 1 in the middle of the colours
      scale.to = std::max(scale.to, 1 / scale.from);
      scale.from = 1 / scale.to;
    }
    const double scale_left = placed.right + scale_gap;
    return {{"place",
             {across(scale_left), up(placed.bottom), across(scale_thickness), (placed.top - placed.bottom) / height_}},
            {"label_at", {across(placed.scale_label_x), up((placed.bottom + placed.top) / 2)}},
            {"columns", std::move(columns)},
            {"label", plain_text(scaled(map.label, scale))},
            {"ticks", std::move(places)},
            {"numbers", std::move(numbers)},
            {"range", {scale.from, scale.to}},
            {"logarithmic", static_cast<int>(scale.logarithmic)},
            {"ratio", static_cast<int>(map.ratio)}};
  }

  Layout layout_;
  std::vector<std::string> part_;  // what of many things it shows, in lines
  double below_, height_;          // their room below all panels, and that of all [cm]
  std::string title_;
  std::vector<std::string> headings_;
  std::vector<std::vector<double>> columns_;
};

}  // namespace

FigureText figure_text(const Figure& figure, const std::string& name) { return Writer(figure).write(name); }

}  // namespace bentur
