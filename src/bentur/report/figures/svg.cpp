#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <vector>

#include "bentur/report/figures/figure.h"
#include "bentur/report/figures/internal/colours.h"
#include "bentur/report/figures/internal/layout.h"
#include "bentur/report/figures/internal/pixels.h"
#include "bentur/report/figures/internal/text.h"
#include "bentur/report/figures/internal/text_width.h"
#include "bentur/report/figures/internal/visible.h"
#include "bentur/report/utf8.h"

namespace bentur {
namespace {

constexpr double pixel = 2.54 / 96;                             // [cm]
constexpr double letters = 8.0 / 72 * 2.54 / pixel;             // 8 pt [px]
constexpr double baseline = 0.36 * letters;                     // below the middle of a line of text
constexpr double rise = 0.33 * letters, fall = 0.16 * letters;  // of small letters
constexpr double large_mark = 1.5;                              // from this size on a disc has an edge
constexpr double frame_line = 0.7;                              // [px]
constexpr double major_tick = 3.6, minor_tick = 2;              // [px]
constexpr double number_gap = 0.12, number_depth = 0.33;        // of numbers from the frame: to its left, below it [cm]
constexpr int shades = 64;                                      // that a map's colours have

// In the order of Line, of a width of 1.
constexpr const char* dashes[] = {"", "", "4.6 2.3", "1.5 1.7", "5 1.9 1.5 1.9", "9 2.3", "5 1.9 1.5 1.9 1.5 1.9"};

std::string escaped(std::string_view text) { return markup_text(plain_text(text)); }

/// The letters of a text, raised and lowered ones as common letters, smaller.
std::string lettered(std::string_view words) {
  const std::string plain = plain_text(words);
  std::string all, run;
  double down = 0, was_down = 0;  // of this run of letters and of the one before [px]
  const auto end_run = [&] {
    if (run.empty()) return;
    const std::string size = down == 0 ? "" : fmt::format(" font-size=\"{}\"", length(small_size * letters));
    const std::size_t first = std::min(run.find_first_not_of(' '), run.size());
    const std::size_t end = std::max(run.find_last_not_of(' ') + 1, first);  // npos + 1 is 0
    // Spaces at the ends of a <tspan> are lost.
    const auto part = [&](std::size_t from, std::size_t to) { return markup_text(run.substr(from, to - from)); };
    all += down == was_down ? part(0, run.size())
                            : fmt::format("{}<tspan dy=\"{}\"{}>{}</tspan>{}", part(0, first), length(down - was_down),
                                          size, part(first, end), part(end, run.size()));
    was_down = down;
    run.clear();
  };
  for (const auto& [bytes, code] : characters(plain)) {
    const auto small = small_letter(code);
    const double at = !small ? 0 : small->is_raised ? -rise : fall;
    if (at != down) end_run();
    down = at;
    run += small ? small->common : bytes;
  }
  end_run();
  return all;
}

std::string drawn_in(const char* what, const Colour& of) {
  return fmt::format("class=\"{}-{}\" {}=\"{}\"", what, of.name, what, of.paper);
}

/// A shape with an edge of another colour.
std::string edged(const Colour& fill, const Colour& stroke) {
  return fmt::format("class=\"fill-{0} stroke-{1}\" fill=\"{2}\" stroke=\"{3}\"", fill.name, stroke.name, fill.paper,
                     stroke.paper);
}

std::string line_style(Tone tone, Line line, double width) {
  std::string style = drawn_in("stroke", colour(tone)) + fmt::format(" stroke-width=\"{}\"", length(width));
  const char* dash = dashes[static_cast<std::size_t>(line)];
  if (*dash != '\0') style += fmt::format(" stroke-dasharray=\"{}\"", dash);
  return style;
}

/// Lower left corner of the figure at the origin in `layout`, upper left one here.
class Drawing {
 public:
  explicit Drawing(const Figure& figure) : figure_(figure), layout_(layout(figure)) {}

  /// With what of many things it shows below it, which a page says in its caption.
  std::string file() {
    const std::vector<std::string> part = part_lines(figure_, layout_);
    lines(part, layout_.width / 2, -line_height / 2);
    below_ = room_of_part(part);
    return "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n" +
           svg("xmlns=\"http://www.w3.org/2000/svg\" role=\"img\" ",
               tagged("title", figure_.title) + tagged("desc", figure_.finding),
               "<style>" + figure_style() + "</style>\n") +
           "\n";
  }
  std::string element(std::string_view label) {
    const std::string said =
        figure_.finding.empty() ? std::string(label) : fmt::format("{}: {}", label, figure_.finding);
    return svg(fmt::format("role=\"img\" aria-label=\"{}\" ", escaped(said)), "", "");
  }
  [[nodiscard]] std::vector<PanelPlace> places() const {
    std::vector<PanelPlace> all;
    for (const PlacedPanel& placed : layout_.panels) {
      all.push_back({.left = x(placed.left),
                     .top = y(placed.top),
                     .width = x(placed.right - placed.left),
                     .height = x(placed.top - placed.bottom),
                     .x = {placed.x.from, placed.x.to},
                     .y = {placed.y.from, placed.y.to},
                     .x_logarithmic = placed.x.logarithmic,
                     .y_logarithmic = placed.y.logarithmic});
    }
    return all;
  }

 private:
  static std::string tagged(const char* tag, const std::string& text) {
    return text.empty() ? "" : fmt::format("<{0}>{1}</{0}>\n", tag, escaped(text));
  }
  std::string svg(const std::string& attributes, const std::string& texts, const std::string& style) {
    for (const PlacedPanel& placed : layout_.panels) panel(placed);
    const std::string width = length(layout_.width / pixel), height = length((layout_.height + below_) / pixel);
    return fmt::format(
        "<svg {}class=\"bentur\" width=\"{}\" height=\"{}\" viewBox=\"0 0 {} {}\" font-family=\"'DejaVu Sans', "
        "'Liberation Sans', Arial, sans-serif\" font-size=\"{}\">\n{}{}<rect {} width=\"{}\" height=\"{}\"/>\n{}</svg>",
        attributes, width, height, width, height, length(letters), texts, style, drawn_in("fill", paper), width, height,
        out_);
  }

  [[nodiscard]] static double x(double cm) { return cm / pixel; }
  [[nodiscard]] double y(double cm) const { return (layout_.height - cm) / pixel; }

  void path(const std::string& data, const std::string& style) {
    if (!data.empty()) out_ += fmt::format("<path d=\"{}\" fill=\"none\" {}/>\n", data, style);
  }

  void text(const std::string& words, double x_px, double y_px, const char* anchor, bool upright = false,
            Tone tone = Tone::black, bool on_curves = false) {
    if (words.empty()) return;
    const std::string turned =
        upright ? fmt::format(" transform=\"rotate(-90 {} {})\"", length(x_px), length(y_px)) : "";
    // What stands among curves has an edge of paper, so that none strikes it through.
    const std::string style = on_curves ? "paint-order=\"stroke\" stroke-width=\"2.4\" stroke-linejoin=\"round\" " +
                                              edged(colour(tone), paper)
                                        : drawn_in("fill", colour(tone));
    out_ += fmt::format("<text x=\"{}\" y=\"{}\" dy=\"{}\" text-anchor=\"{}\"{} {}>{}</text>\n", length(x_px),
                        length(y_px), length(baseline), anchor, turned, style, lettered(words));
  }

  void lines(const std::vector<std::string>& texts, double x_cm, double y_cm) {
    for (const std::string& one : texts) {
      text(one, x(x_cm), y(y_cm), "middle");
      y_cm -= line_height;
    }
  }

  /// Around a place [px].
  void mark(Mark mark, Tone tone, double x_px, double y_px, double size = 1) {
    const std::string at = fmt::format("cx=\"{}\" cy=\"{}\"", length(x_px), length(y_px));
    const bool is_large = size >= large_mark;
    const std::string stroke = is_large ? "stroke-width=\"1\" " + edged(paper, colour(tone))
                                        : "fill=\"none\" stroke-width=\"1\" " + drawn_in("stroke", colour(tone));
    const std::string scale = size == 1 ? "" : fmt::format(" scale({})", length(size));
    const auto shape = [&](const std::string& data) {
      out_ += fmt::format("<path transform=\"translate({} {}){}\" d=\"{}\" {}/>\n", length(x_px), length(y_px), scale,
                          data, stroke);
    };
    switch (mark) {
      case Mark::none:
        return;
      case Mark::disc:
        out_ += fmt::format(
            "<circle {} r=\"{}\" {}/>\n", at, length(1.6 * size),
            is_large ? edged(colour(tone), paper) + " stroke-width=\"0.8\"" : drawn_in("fill", colour(tone)));
        return;
      case Mark::circle:
        out_ += fmt::format("<circle {} r=\"{}\" {}/>\n", at, length(1.8 * size), stroke);
        return;
      case Mark::square:
        return shape("M-1.7 -1.7H1.7V1.7H-1.7Z");
      case Mark::triangle:
        return shape("M0 -2.2L2 1.4H-2Z");
      case Mark::diamond:
        return shape("M0 -2.3L2.3 0L0 2.3L-2.3 0Z");
      case Mark::cross:
        return shape("M-1.8 -1.8L1.8 1.8M-1.8 1.8L1.8 -1.8");
    }
  }

  void event(double x_px, double y_px) {
    out_ += fmt::format("<path transform=\"translate({} {})\" d=\"M-1.8 -1.3H1.8L0 1.8Z\" {}/>\n", length(x_px),
                        length(y_px), drawn_in("fill", colour(Tone::grey)));
  }

  void legend(const PlacedPanel& placed) {
    for (const LegendEntry& entry : placed.legend) {
      const double begin = x(entry.x), end = x(entry.x + sample_width), middle = y(entry.y);
      if (entry.area || entry.outline) {
        const double tall = sample_height / pixel;
        const std::string style = entry.area ? drawn_in("fill", colour(entry.tone))
                                             : "fill=\"none\" " + line_style(entry.tone, entry.line, entry.width);
        out_ += fmt::format("<path d=\"M{} {}H{}v{}H{}Z\" {}/>\n", length(begin), length(middle - tall / 2),
                            length(end), length(tall), length(begin), style);
      } else if (entry.line != Line::none) {
        path(fmt::format("M{} {}H{}", length(begin), length(middle), length(end)),
             line_style(entry.tone, entry.line, entry.width));
      }
      if (entry.event) event((begin + end) / 2, middle);
      mark(entry.mark, entry.tone, (begin + end) / 2, middle, entry.mark_size);
      text(entry.label, x(entry.x + sample_width + beside_sample), middle, "start");
    }
  }

  /// The frame of a panel [px], and where values stand in it.
  struct Frame {
    double left, top, width, height;
    const Ticks *across, *up;
    [[nodiscard]] double x(double value) const { return along(*across, value) * width; }
    [[nodiscard]] double y(double value) const { return (1 - along(*up, value)) * height; }
    [[nodiscard]] bool holds(double px, double py) const {
      return px >= -1e-6 && px <= width + 1e-6 && py >= -1e-6 && py <= height + 1e-6;
    }
  };

  void panel(const PlacedPanel& placed) {
    const Panel& panel = *placed.panel;
    const Frame frame{.left = x(placed.left),
                      .top = y(placed.top),
                      .width = x(placed.right - placed.left),
                      .height = x(placed.top - placed.bottom),
                      .across = &placed.x,
                      .up = &placed.y};
    // What is outside of the frame is cut off; marks within are whole.
    out_ += fmt::format("<svg x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\">\n", length(frame.left), length(frame.top),
                        length(frame.width), length(frame.height));
    if (panel.map) map(placed, frame);
    for (const RuleLine& rule : panel.rules) {
      const std::string place = length(rule.vertical ? frame.x(rule.at) : frame.y(rule.at));
      path(rule.vertical ? fmt::format("M{} 0V{}", place, length(frame.height))
                         : fmt::format("M0 {}H{}", place, length(frame.width)),
           line_style(rule.tone, rule.line, 0.7));
    }
    std::vector<Points> points;
    for (const Curve& curve : panel.curves) {
      points.push_back(visible(curve, placed.right - placed.left));
      line(curve, points.back(), frame);
    }
    out_ += "</svg>\n";
    if (panel.map) scale(placed, frame);
    for (std::size_t c = 0; c < points.size(); ++c) marks(panel.curves[c], points[c], frame);
    for (const PlaceText& one : panel.texts) beside(one, text_lines(one, placed), frame, one.tone);
    for (const CurveName& name : placed.names) named(name, panel.curves[name.curve].tone, frame);
    for (const double at : panel.events.x) {
      if (at < placed.x.from || at > placed.x.to) continue;
      event(frame.left + frame.x(at), frame.top + 0.03 * frame.height);
    }
    panel.to_scale ? names(placed, frame) : axes(placed, frame);
    const double middle = (placed.left + placed.right) / 2;
    lines(placed.title, middle, placed.title_y);
    lines(placed.x_label, placed.x_label_x, placed.x_label_y);
    text(panel.note, x(middle), y((placed.bottom + placed.top) / 2), "middle");
    text(scaled(panel.y.label, placed.y, panel.y.number), x(placed.y_label_x), y((placed.bottom + placed.top) / 2),
         "middle", true);
    legend(placed);
  }

  /// A line through points, begun anew behind places where there is none; or an area between two of them, that of the
  /// envelope of a line with its edges.
  void line(const Curve& curve, const Points& points, const Frame& frame) {
    std::string data, back;
    const auto close = [&] {
      if (!back.empty()) data += back + "Z";
      back.clear();
    };
    const bool is_area = !points.top.empty(), is_band = is_area && curve.top.empty();
    bool is_begun = false;
    for (std::size_t i = 0; i < points.x.size(); ++i) {
      const double px = frame.x(points.x[i]), py = frame.y(points.y[i]);
      const double upper = is_area ? frame.y(points.top[i]) : 0;
      if (!std::isfinite(px) || !std::isfinite(py) || !std::isfinite(upper)) {
        close();
        is_begun = false;
        continue;
      }
      data += is_begun ? 'L' : 'M';
      add_length(data, px);
      data += ' ';
      add_length(data, py);
      if (is_area) back.insert(0, fmt::format("L{} {}", length(px), length(upper)));
      is_begun = true;
    }
    close();
    if (is_band) {
      const std::string look = edged(colour(curve.tone), colour(curve.tone));
      out_ += fmt::format("<path d=\"{}\" {} fill-opacity=\"{}\" stroke-width=\"{}\"/>\n", data, look, band_opacity,
                          frame_line);
    } else if (is_area) {
      if (!data.empty()) out_ += fmt::format("<path d=\"{}\" {}/>\n", data, drawn_in("fill", colour(curve.tone)));
    } else if (curve.line != Line::none) {
      path(data, line_style(curve.tone, curve.line, curve.width) + " stroke-linejoin=\"round\"");
    }
  }

  void marks(const Curve& curve, const Points& points, const Frame& frame) {
    if (curve.mark == Mark::none) return;
    for (std::size_t i = 0; i < points.x.size(); ++i) {
      const double px = frame.x(points.x[i]), py = frame.y(points.y[i]);
      if (frame.holds(px, py)) mark(curve.mark, curve.tone, frame.left + px, frame.top + py, curve.mark_size);
    }
  }

  /// The name of a curve in its tone, joined to the end where it stands away from it.
  void named(const CurveName& name, Tone tone, const Frame& frame) {
    const double up = x(name.up);
    if (std::abs(up) > 1) {
      path(fmt::format("M{} {}L{} {}", length(frame.left + frame.x(name.x)), length(frame.top + frame.y(name.y)),
                       length(frame.left + frame.x(name.x) + clear - 1), length(frame.top + frame.y(name.y) - up)),
           line_style(tone, Line::solid, frame_line));
    }
    Frame moved = frame;
    moved.top -= up;
    beside({.x = name.x, .y = name.y, .side = name.side}, {name.label}, moved, tone);
  }

  static constexpr double clear = 5;  // between a place and the text beside it [px]

  /// Clear of a mark there.
  void beside(const PlaceText& one, const std::vector<std::string>& lines, const Frame& frame, Tone tone) {
    const double py = frame.y(one.y);
    if (!frame.holds(frame.x(one.x), py)) return;
    using Side = PlaceText::Side;
    const double px = x(text_x(one, lines, *frame.across, frame.width * pixel));
    const double right = one.side == Side::right ? clear : one.side == Side::left ? -clear : 0;
    const double down = one.side == Side::below ? clear + baseline : one.side == Side::above ? -clear - baseline : 0;
    const char* const anchor = one.side == Side::right ? "start" : one.side == Side::left ? "end" : "middle";
    const double step = x(line_height), first = -step * (static_cast<double>(lines.size()) - 1) / 2;
    for (std::size_t i = 0; i < lines.size(); ++i) {
      text(lines[i], frame.left + px + right, frame.top + py + down + first + step * static_cast<double>(i), anchor,
           false, tone, true);
    }
  }

  /// What stands in a picture of things, each name below its own and within the figure.
  void names(const PlacedPanel& placed, const Frame& f) {
    for (std::size_t i = 0; i < placed.x.labels.size(); ++i) {
      const auto& [value, label] = placed.x.labels[i];
      const double at = f.left + f.x(value), bottom = f.top + f.height;
      if (placed.x.upright) {
        text(label, at, bottom + x(number_gap), "end", true);
        continue;
      }
      const double half = x(text_width(label) / 2 + 0.05);
      const auto line = static_cast<double>(i % static_cast<std::size_t>(placed.x.lines));
      text(label, std::clamp(at, half, std::max(half, x(layout_.width) - half)),
           bottom + x(number_depth + line * line_height), "middle");
    }
  }

  /// The frame, with ticks inwards on opposite sides, and the numbers.
  void axes(const PlacedPanel& placed, const Frame& f) {
    std::string ticks = fmt::format("M{} {}h{}v{}h-{}Z", length(f.left), length(f.top), length(f.width),
                                    length(f.height), length(f.width));
    const double bottom = f.top + f.height, right = f.left + f.width;
    const auto across = [&](double value, double size) {
      const std::string at = length(f.left + f.x(value));
      ticks += fmt::format("M{} {}v-{}M{} {}v{}", at, length(bottom), size, at, length(f.top), size);
    };
    const auto up = [&](double value, double size) {
      const std::string at = length(f.top + f.y(value));
      ticks += fmt::format("M{} {}h{}M{} {}h-{}", length(f.left), at, size, length(right), at, size);
    };
    for (const double value : placed.x.minor) across(value, minor_tick);
    for (const double value : placed.y.minor) up(value, minor_tick);
    for (const auto& [value, label] : placed.x.labels) across(value, major_tick);
    for (const auto& [value, label] : placed.y.labels) up(value, major_tick);
    path(ticks, line_style(Tone::black, Line::solid, frame_line));
    for (const auto& [value, label] : placed.x.labels) {
      if (!placed.panel->x.numbers) break;
      const double px = f.left + f.x(value);
      if (placed.x.upright) {
        text(label, px, bottom + x(number_gap), "end", true);
      } else {
        text(label, px, bottom + x(number_depth), "middle");
      }
    }
    for (const auto& [value, label] : placed.y.labels) {
      if (placed.panel->y.numbers) text(label, f.left - x(number_gap), f.top + f.y(value), "end");
    }
  }

  /// Cells of one shade are one path.
  void map(const PlacedPanel& placed, const Frame& frame) {
    const HeatMap cells = merged(*placed.panel->map);
    const std::size_t nx = cells.x_edges.size() - 1;
    std::array<std::string, shades + 1> of_shade;
    for (std::size_t i = 0; i < cells.values.size(); ++i) {
      if (!std::isfinite(cells.values[i]) || (cells.ratio && cells.values[i] <= 0)) continue;
      const double part = colour_at(cells, placed.scale, std::clamp(along(placed.scale, cells.values[i]), 0.0, 1.0));
      const double *across = &cells.x_edges[i % nx], *up = &cells.y_edges[i / nx];
      of_shade[static_cast<std::size_t>(std::lround(part * shades))] +=
          fmt::format("M{} {}H{}V{}H{}Z", length(frame.x(across[0])), length(frame.y(up[0])),
                      length(frame.x(across[1])), length(frame.y(up[1])), length(frame.x(across[0])));
    }
    for (std::size_t s = 0; s < of_shade.size(); ++s) {
      if (of_shade[s].empty()) continue;
      out_ += fmt::format("<path d=\"{}\" fill=\"{}\" shape-rendering=\"crispEdges\"/>\n", of_shade[s],
                          shade(static_cast<double>(s) / shades, cells.ratio));
    }
  }

  /// The colours of a map, beside its frame.
  void scale(const PlacedPanel& placed, const Frame& frame) {
    const HeatMap& cells = *placed.panel->map;
    const double left = x(placed.right + scale_gap), width = x(scale_thickness), right = left + width;
    const double step = frame.height / (shades + 1);
    for (int s = 0; s <= shades; ++s) {
      out_ += fmt::format("<path d=\"M{} {}h{}V{}h-{}Z\" fill=\"{}\" shape-rendering=\"crispEdges\"/>\n", length(left),
                          length(frame.top + frame.height - s * step), length(width),
                          length(frame.top + frame.height - (s + 1) * step), length(width),
                          shade(colour_at(cells, placed.scale, static_cast<double>(s) / shades), cells.ratio));
    }
    std::string ticks = fmt::format("M{} {}h{}v{}h-{}Z", length(left), length(frame.top), length(width),
                                    length(frame.height), length(width));
    for (const auto& [value, label] : placed.scale.labels) {
      const double at = frame.top + (1 - along(placed.scale, value)) * frame.height;
      ticks += fmt::format("M{} {}h-3", length(right), length(at));
      text(label, right + x(0.1), at, "start");
    }
    path(ticks, line_style(Tone::black, Line::solid, frame_line));
    text(scaled(cells.label, placed.scale), x(placed.scale_label_x), y((placed.bottom + placed.top) / 2), "middle",
         true);
  }

  const Figure& figure_;
  Layout layout_;
  double below_ = 0;  // of lines below all panels [cm]
  std::string out_;
};

}  // namespace

std::string figure_svg(const Figure& figure) { return Drawing(figure).file(); }

std::string figure_element(const Figure& figure, std::string_view label) { return Drawing(figure).element(label); }

PlacedFigure placed_figure(const Figure& figure, std::string_view label) {
  Drawing drawing(figure);
  return {.svg = drawing.element(label), .panels = drawing.places()};
}

std::string letters_beyond_font(const Figure& figure) {
  std::string all;
  const auto add = [&](const std::string& text) {
    const std::string plain = plain_text(text);
    for (const auto& [bytes, code] : characters(plain)) {
      if (!is_in_font(code) && all.find(bytes) == std::string::npos) all += bytes;
    }
  };
  for (const Panel& panel : figure.panels) {
    for (const std::string& text : {panel.title, panel.note, panel.events.label}) add(text);
    for (const Axis* axis : {&panel.x, &panel.y}) {
      add(axis->label);
      for (const std::string& name : axis->names) add(name);
    }
    for (const Curve& curve : panel.curves) add(curve.label);
    for (const RuleLine& rule : panel.rules) add(rule.label);
    for (const PlaceText& one : panel.texts) add(one.text);
    if (panel.map) add(panel.map->label);
  }
  return all;
}

}  // namespace bentur
