#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <span>

#include "bentur/io/output/result_kind.h"
#include "bentur/report/figures/figure.h"
#include "bentur/report/figures/internal/colours.h"
#include "bentur/report/figures/internal/layout.h"
#include "bentur/report/figures/internal/text.h"
#include "bentur/report/figures/internal/visible.h"

namespace bentur {
namespace {

// In gnuplot's terms, in the order of Tone, Line and Mark.
constexpr const char* gnuplot_dashes[] = {"solid", "solid", "(9,4)", "(3,3)", "(9,3,2,3)"};
constexpr int point_types[] = {7, 7, 6, 4, 8, 12, 2};
constexpr const char* event_style = "pt 11 ps 0.35 lc rgb '#606060'";

/// Widths differ by a little between dashes: gnuplot's SVG takes a new dash for a line of equal colour and width only
/// where something else has changed.
std::string gnuplot_line(Tone tone, Line line, double width) {
  width += 0.01 * static_cast<double>(line);
  return fmt::format("lc rgb '{}' dt {} lw {:.3g}", colour(tone).paper, gnuplot_dashes[static_cast<std::size_t>(line)],
                     width);
}

std::string mark_style(Tone tone, Mark mark) {
  return fmt::format("pt {} ps {} lc rgb '{}'", point_types[static_cast<std::size_t>(mark)],
                     mark == Mark::disc ? 0.4 : 0.5, colour(tone).paper);
}

std::string value_text(double value) { return std::isnan(value) ? "NaN" : fmt::format("{}", value); }

/// Data and script grow together.
class Writer {
 public:
  Writer(const Figure& figure, const std::string& name) : figure_(figure), name_(name), layout_(layout(figure)) {}

  FigureText write() {
    head();
    for (const PlacedPanel& placed : layout_.panels) panel(placed);
    script_ += "unset multiplot\nunset output\n";
    return {std::move(data_), std::move(script_)};
  }

 private:
  [[nodiscard]] std::string x(double cm) const { return fmt::format("{:.5f}", cm / layout_.width); }
  [[nodiscard]] std::string y(double cm) const { return fmt::format("{:.5f}", cm / layout_.height); }
  [[nodiscard]] std::string screen(double x_cm, double y_cm) const {
    return fmt::format("screen {}, screen {}", x(x_cm), y(y_cm));
  }

  void head() {
    const double pixels = 96 / 2.54;  // of SVG: an inch is 96
    const double dense = 300 / 2.54;  // of PNG
    data_ += "# " + plain_text(figure_.title) + "\n";
    script_ += fmt::format(
        "{} (gnuplot 5.4 or newer, in this folder):\n"
        "#   gnuplot THIS                      as SVG\n"
        "#   gnuplot -e \"format='pdf'\" THIS    as PDF; 'png' as PNG\n"
        "reset\n"
        "set encoding utf8\n"
        "name = {}\n"
        "data = './'.name.'.dat'\n"
        "if (!exists('format')) format = 'svg'\n"
        "if (format eq 'svg') set terminal svg name '{}' size {:.0f},{:.0f} noenhanced font "
        "'Helvetica,Arial,sans-serif,10.67' "
        "linewidth 1 background rgb 'white'\n"
        "if (format eq 'pdf') set terminal pdfcairo size {:.4g}cm,{:.4g}cm noenhanced font 'Helvetica,8' fontscale "
        "0.75 "
        "linewidth 1.5 pointscale 1\n"
        "if (format eq 'png') set terminal pngcairo size {:.0f},{:.0f} noenhanced font 'Helvetica,8' fontscale 3.125 "
        "linewidth 3.1 pointscale 3.1\n"
        "set output './'.name.'.'.format\n"
        "set multiplot\n"
        "unset key\n"
        "set tics in scale 0.5,0.3 front\n"
        "set xtics offset 0,0.3\nset ytics offset 0.4,0\n",
        figure_script_mark, gnuplot_string(name_), identifier(name_), layout_.width * pixels, layout_.height * pixels,
        layout_.width, layout_.height, layout_.width * dense, layout_.height * dense);
  }

  /// What gnuplot's SVG has as the name of the picture: letters, digits, underscores.
  static std::string identifier(const std::string& name) {
    std::string result = "bentur_";
    for (const char c : name) result += std::isalnum(static_cast<unsigned char>(c)) != 0 ? c : '_';
    return result;
  }

  void axis(const char* name, const Ticks& ticks, bool has_numbers = true) {
    std::vector<std::string> list;
    for (const auto& [at, text] : ticks.labels) {
      list.push_back(fmt::format("{} {}", gnuplot_string(has_numbers ? text : ""), at));
    }
    for (const double at : ticks.minor) list.push_back(fmt::format("'' {} 1", at));
    script_ += fmt::format("{} logscale {}\nset {}range [{}:{}]\nset {}tics {} ({})\n",
                           ticks.logarithmic ? "set" : "unset", name, name, ticks.from, ticks.to, name,
                           ticks.upright ? "rotate by 90 right" : "norotate", fmt::join(list, ", "));
  }

  void label(const std::string& text, double x_cm, double y_cm, const char* how) {
    if (!text.empty()) script_ += fmt::format("set label {} at {} {}\n", gnuplot_string(text), screen(x_cm, y_cm), how);
  }

  void lines(const std::vector<std::string>& texts, double x_cm, double y_cm) {
    for (const std::string& text : texts) {
      label(text, x_cm, y_cm, "center");
      y_cm -= line_height;
    }
  }

  void legend(const PlacedPanel& placed) {
    for (const LegendEntry& entry : placed.legend) {
      const double end = entry.x + sample_width;
      if (entry.area) {
        script_ += fmt::format("set object rectangle from {} to {} fc rgb '{}' fs solid noborder front\n",
                               screen(entry.x, entry.y - 0.1), screen(end, entry.y + 0.1), colour(entry.tone).paper);
      } else if (entry.line != Line::none) {
        script_ += fmt::format("set arrow from {} to {} nohead {}\n", screen(entry.x, entry.y), screen(end, entry.y),
                               gnuplot_line(entry.tone, entry.line, entry.width));
      }
      if (entry.mark != Mark::none || entry.event) {
        script_ += fmt::format("set label '' at {} point {}\n", screen((entry.x + end) / 2, entry.y),
                               entry.event ? event_style : mark_style(entry.tone, entry.mark));
      }
      label(entry.label, end + 0.1, entry.y, "left");
    }
  }

  std::size_t block(const std::string& what, const std::vector<std::span<const double>>& columns) {
    data_ += fmt::format("{}# {}\n", blocks_ > 0 ? "\n\n" : "", plain_text(what));
    for (std::size_t i = 0; i < columns.front().size(); ++i) {
      for (std::size_t c = 0; c < columns.size(); ++c) data_ += (c > 0 ? " " : "") + value_text(columns[c][i]);
      data_ += '\n';
    }
    return blocks_++;
  }

  /// What the numbers along an axis mean, where names would have been too many.
  void names(const Axis& axis) {
    for (std::size_t i = 0; i < axis.names.size(); ++i) {
      data_ += fmt::format("# {} {}: {}\n", plain_text(axis.label), i + 1, plain_text(axis.names[i]));
    }
  }

  void panel(const PlacedPanel& placed) {
    const Panel& panel = *placed.panel;
    if (blocks_ > 0 && !(panel.x.names.empty() && panel.y.names.empty())) data_ += "\n";
    names(panel.x);
    names(panel.y);
    script_ += "\nunset label\nunset arrow\nunset object\n";
    script_ += fmt::format(
        "set lmargin at screen {}\nset rmargin at screen {}\nset bmargin at screen {}\nset tmargin at screen {}\n",
        x(placed.left), x(placed.right), y(placed.bottom), y(placed.top));
    script_ += panel.to_scale ? "unset border\n" : "set border 31 lw 0.7\n";
    axis("x", placed.x, panel.x.numbers);
    axis("y", placed.y, panel.y.numbers);
    const double middle = (placed.left + placed.right) / 2;
    lines(placed.title, middle, placed.title_y);
    lines(placed.x_label, placed.x_label_x, placed.x_label_y);
    label(panel.note, middle, (placed.bottom + placed.top) / 2, "center");
    label(scaled(panel.y.label, placed.y, panel.y.number), placed.cell_left + 0.25, (placed.bottom + placed.top) / 2,
          "center rotate");
    legend(placed);
    std::vector<std::string> plots;
    if (panel.map) plots.push_back(map(placed));
    for (const RuleLine& rule : panel.rules) {
      const Ticks& across = rule.vertical ? placed.x : placed.y;
      if (rule.at < across.from || rule.at > across.to) continue;
      const auto end = [&](int edge) {
        return rule.vertical ? fmt::format("first {}, graph {}", rule.at, edge)
                             : fmt::format("graph {}, first {}", edge, rule.at);
      };
      script_ += fmt::format("set arrow from {} to {} nohead back {}\n", end(0), end(1),
                             gnuplot_line(rule.tone, rule.line, 0.7));
    }
    for (const Curve& curve : panel.curves) this->curve(placed, curve, plots);
    events(placed, plots);
    script_ += fmt::format("plot {}\n", fmt::join(plots, ", \\\n     "));
  }

  void curve(const PlacedPanel& placed, const Curve& curve, std::vector<std::string>& plots) {
    const Panel& panel = *placed.panel;
    const std::string what =
        fmt::format("{}; columns: {}, {}", curve.label.empty() ? "curve" : curve.label, panel.x.label, panel.y.label);
    if (!curve.top.empty()) {
      plots.push_back(fmt::format("data index {} using 1:2:3 title {} with filledcurves fc rgb '{}' fs solid noborder",
                                  block(what + ", upper edge", {curve.x, curve.y, curve.top}),
                                  gnuplot_string(curve.label), colour(curve.tone).paper));
      return;
    }
    const Points points = visible(curve, placed.right - placed.left);
    const std::string columns = fmt::format("data index {} using 1:2 title {} with ", block(what, {points.x, points.y}),
                                            gnuplot_string(curve.label));
    if (curve.line != Line::none)
      plots.push_back(columns + "lines " + gnuplot_line(curve.tone, curve.line, curve.width));
    if (curve.mark != Mark::none) plots.push_back(columns + "points " + mark_style(curve.tone, curve.mark));
  }

  void events(const PlacedPanel& placed, std::vector<std::string>& plots) {
    Events kept = placed.panel->events;
    std::erase_if(kept.x, [&](double at) { return at < placed.x.from || at > placed.x.to; });
    if (kept.x.empty()) return;
    const double height = placed.y.to - 0.03 * (placed.y.to - placed.y.from);
    plots.push_back(fmt::format("data index {} using 1:({}) title {} with points {}", block(kept.label, {kept.x}),
                                height, gnuplot_string(kept.label), event_style));
  }

  std::string map(const PlacedPanel& placed) {
    const HeatMap map = merged(*placed.panel->map);
    const std::size_t nx = map.x_edges.size() - 1;
    std::vector<double> columns[7];
    for (std::size_t i = 0; i < map.values.size(); ++i) {
      if (!std::isfinite(map.values[i]) || (map.ratio && map.values[i] <= 0)) continue;
      const double *x = &map.x_edges[i % nx], *y = &map.y_edges[i / nx];
      const double row[] = {(x[0] + x[1]) / 2, (y[0] + y[1]) / 2, x[0], x[1], y[0], y[1], map.values[i]};
      for (std::size_t c = 0; c < 7; ++c) columns[c].push_back(row[c]);
    }
    Ticks scale = placed.scale;
    if (map.ratio) {  // 1 in the middle of the colours
      scale.to = std::max(scale.to, 1 / scale.from);
      scale.from = 1 / scale.to;
    }
    constexpr const char* one_way =
        "0 '#ffffe0', 1 '#c7e9b4', 2 '#7fcdbb', 3 '#41b6c4', 4 '#1d91c0', 5 '#225ea8', 6 '#081d58'";
    constexpr const char* both_ways = "0 '#1f4f8a', 1 '#6f9ccb', 2 '#f5f5f5', 3 '#dd9558', 4 '#94430a'";
    script_ += fmt::format("set style line 100 lc rgb '#000000' lw 0.7\nset palette defined ({})\n",
                           map.ratio ? both_ways : one_way);
    axis("cb", scale);
    script_ += fmt::format("set colorbox user vertical origin {} size screen {}, screen {} border 100\n",
                           screen(placed.right + 0.2, placed.bottom), x(0.25), y(placed.top - placed.bottom));
    label(scaled(map.label, scale), placed.scale_label_x, (placed.bottom + placed.top) / 2, "center rotate");
    return fmt::format("data index {} using 1:2:3:4:5:6:7 title {} with boxxyerror fc palette fs solid noborder",
                       block(map.label + " in cells; columns: x, y, and lower and upper end of both, value",
                             {std::begin(columns), std::end(columns)}),
                       gnuplot_string(map.label));
  }

  const Figure& figure_;
  const std::string& name_;
  Layout layout_;
  std::string data_, script_;
  std::size_t blocks_ = 0;
};

}  // namespace

FigureText figure_text(const Figure& figure, const std::string& name) { return Writer(figure, name).write(); }

}  // namespace bentur
