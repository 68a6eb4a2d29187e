#include "bentur/report/figures/internal/curve_names.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "bentur/report/figures/box.h"
#include "bentur/report/figures/internal/text.h"
#include "bentur/report/figures/internal/text_width.h"

namespace bentur {
namespace {

constexpr double clear = 0.13;     // between an end and its name [cm]
constexpr double high = 0.32;      // of a name [cm]
constexpr double widest = 3;       // of a name beside a frame [cm]
constexpr double half_mark = 0.1;  // [cm]
constexpr double between = 0.2;    // names on one line [cm]

bool has_name(const Curve& curve) {
  return !curve.label.empty() && curve.in_legend && !curve.of_several && curve.top.empty() && curve.line != Line::none;
}

/// The last point of a curve that is one.
std::optional<std::pair<double, double>> end_of(const Curve& curve) {
  for (std::size_t i = curve.x.size(); i-- > 0;) {
    if (std::isfinite(curve.x[i]) && std::isfinite(curve.y[i])) return std::pair{curve.x[i], curve.y[i]};
  }
  return std::nullopt;
}

bool ends_at_edge(const Panel& panel, const Curve& curve) {
  const auto end = end_of(curve);
  if (!end || !panel.x.to) return false;
  constexpr double near = 0.01;  // of the axis
  return end->first >= *panel.x.to - near * (*panel.x.to - panel.x.from.value_or(0));
}

/// Whether it ends where another named one does, so that a name there would not tell them apart.
bool meets_another(const Panel& panel, const Curve& curve) {
  const auto level = [&](double y) { return panel.y.logarithmic ? std::log(y) : y; };
  double low = INFINITY, high_ = -INFINITY;
  for (const Curve& one : panel.curves) {
    for (const double y : one.y) {
      if (!std::isfinite(level(y))) continue;
      low = std::min(low, level(y));
      high_ = std::max(high_, level(y));
    }
  }
  constexpr double near = 0.01;  // of what the curves span
  return std::any_of(panel.curves.begin(), panel.curves.end(), [&](const Curve& other) {
    return &other != &curve && has_name(other) && ends_at_edge(panel, other) &&
           std::abs(level(end_of(other)->second) - level(end_of(curve)->second)) < near * (high_ - low);
  });
}

/// Whether its name stands beside the frame, if there is room.
bool is_named_beside(const Panel& panel, const Curve& curve) {
  return has_name(curve) && ends_at_edge(panel, curve) && !meets_another(panel, curve);
}

/// Of names beside a frame: no two on one another and none beyond the frame, those that would meet around the middle of
/// their ends.
void spread(std::vector<CurveName*>& names, const Ticks& y, double height) {
  std::sort(names.begin(), names.end(), [](const CurveName* a, const CurveName* b) { return a->y > b->y; });
  struct Block {
    double sum = 0, count = 0;  // of where the first of all would stand for each name to be at its own end
    [[nodiscard]] double mean() const { return sum / count; }
  };
  std::vector<Block> blocks;
  for (std::size_t i = 0; i < names.size(); ++i) {
    Block last{along(y, names[i]->y) * height + static_cast<double>(i) * high, 1};
    for (; !blocks.empty() && blocks.back().mean() < last.mean(); blocks.pop_back()) {
      last = {last.sum + blocks.back().sum, last.count + blocks.back().count};
    }
    blocks.push_back(last);
  }
  std::vector<double> at;
  for (const Block& block : blocks) {
    for (double k = 0; k < block.count; ++k) {
      at.push_back(std::min(block.mean(), height - high / 2) - static_cast<double>(at.size()) * high);
    }
  }
  double lowest = high / 2;
  for (std::size_t i = names.size(); i-- > 0; lowest += high) {
    at[i] = std::max(at[i], lowest);
    lowest = at[i];
    names[i]->up = at[i] - along(y, names[i]->y) * height;
  }
}

/// A panel whose frame is known, and what lies in it.
class Frame {
 public:
  Frame(const Panel& panel, const Ticks& x, const Ticks& y, double width, double height)
      : panel_(panel), x_(x), y_(y), width_(width), height_(height) {}

  /// The name of a curve within the frame, at its end or, where that is at the edge, where it is furthest from others;
  /// nothing where it has no room.
  std::optional<CurveName> name(std::size_t c) {
    const Curve& curve = panel_.curves[c];
    const auto end = end_of(curve);
    if (!end) return std::nullopt;
    if (!ends_at_edge(panel_, curve)) return name_at(c, *end);
    constexpr std::size_t most = 60;
    std::vector<std::pair<double, std::size_t>> places;  // by how far it is from others [cm]
    for (std::size_t i = 0; i < curve.x.size(); i += 1 + curve.x.size() / most) places.emplace_back(-apart(c, i), i);
    std::sort(places.begin(), places.end());
    for (const auto& [unused, i] : places) {
      if (auto found = name_at(c, {curve.x[i], curve.y[i]})) return found;
    }
    return name_at(c, arrival_at(*end, curve));
  }

 private:
  /// From a point of a curve to the nearest of any other [cm].
  [[nodiscard]] double apart(std::size_t c, std::size_t i) const {
    const double x = across(panel_.curves[c].x[i]), y = upwards(panel_.curves[c].y[i]);
    double nearest = width_ + height_;
    for (std::size_t other = 0; other < panel_.curves.size(); ++other) {
      const Curve& curve = panel_.curves[other];
      for (std::size_t k = 0; other != c && k < curve.x.size(); ++k) {
        nearest = std::min(nearest, std::hypot(across(curve.x[k]) - x, upwards(curve.y[k]) - y));
      }
    }
    return std::isfinite(x) && std::isfinite(y) ? nearest : 0;
  }

  /// From where on a curve is as high as its end.
  [[nodiscard]] std::pair<double, double> arrival_at(const std::pair<double, double>& end, const Curve& curve) const {
    constexpr double near = 0.02;  // of the frame
    std::size_t first = curve.x.size();
    while (first > 0 && std::abs(upwards(curve.y[first - 1]) - upwards(end.second)) < near * height_) --first;
    return first < curve.x.size() ? std::pair{curve.x[first], end.second} : end;
  }

  std::optional<CurveName> name_at(std::size_t c, const std::pair<double, double>& point) {
    CurveName name{.curve = c, .label = plain_text(panel_.curves[c].label), .x = point.first, .y = point.second};
    const double half = text_width(name.label) / 2;
    const double at = across(name.x), up = upwards(name.y);
    using Side = PlaceText::Side;
    const auto above = [&](double moved) {
      return Box{at + moved - half, at + moved + half, up + clear, up + clear + high};
    };
    struct Place {
      Side side;
      Box box;
      double moved = 0;  // along x from the middle [cm]
    };
    const Place places[] = {{Side::above, above(0)},
                            {Side::right, {at + clear, at + clear + 2 * half, up - high / 2, up + high / 2}},
                            {Side::left, {at - clear - 2 * half, at - clear, up - high / 2, up + high / 2}},
                            {Side::below, {at - half, at + half, up - clear - high, up - clear}},
                            {Side::above, above(0.8 * half), 0.8 * half},
                            {Side::above, above(-0.8 * half), -0.8 * half}};
    for (const bool on_rules : {false, true}) {  // a thin line behind a name, where there is no other place
      for (const auto& [side, box, moved] : places) {
        if (!is_free(box) || (!on_rules && is_on_rule(box))) continue;
        name.side = side;
        if (moved != 0) name.x = value_at(x_, (at + moved) / width_);
        taken_.push_back({box.left - between, box.right + between, box.bottom, box.top});
        return name;
      }
    }
    return std::nullopt;
  }

  [[nodiscard]] double across(double value) const { return along(x_, value) * width_; }
  [[nodiscard]] double upwards(double value) const { return along(y_, value) * height_; }

  [[nodiscard]] bool is_free(const Box& box) const {
    constexpr double events = 0.09;  // of the frame, for marks along its upper edge
    const double top = panel_.events.x.empty() ? height_ : (1 - events) * height_;
    if (box.left < 0 || box.right > width_ || box.bottom < 0 || box.top > top) return false;
    if (std::any_of(taken_.begin(), taken_.end(), [&](const Box& other) { return box.meets(other); })) return false;
    return std::none_of(panel_.curves.begin(), panel_.curves.end(),
                        [&](const Curve& curve) { return lies_on(box, curve); });
  }

  [[nodiscard]] bool is_on_rule(const Box& box) const {
    return std::any_of(panel_.rules.begin(), panel_.rules.end(), [&](const RuleLine& rule) {
      const double at = rule.vertical ? across(rule.at) : upwards(rule.at);
      return rule.vertical ? at > box.left && at < box.right : at > box.bottom && at < box.top;
    });
  }

  [[nodiscard]] bool lies_on(const Box& box, const Curve& curve) const {
    const Box around{box.left - half_mark, box.right + half_mark, box.bottom - half_mark, box.top + half_mark};
    for (std::size_t i = 0; i < curve.x.size(); ++i) {
      const double x1 = across(curve.x[i]), y1 = upwards(curve.y[i]);
      if (curve.mark != Mark::none && around.meets({x1, x1, y1, y1})) return true;
      if (i == 0) continue;
      if (box.meets(across(curve.x[i - 1]), upwards(curve.y[i - 1]), x1, y1)) return true;
    }
    return false;
  }

  const Panel& panel_;
  const Ticks &x_, &y_;
  double width_, height_;
  std::vector<Box> taken_;
};

/// Whether all names that end at the edge of a frame have room beside it, one below the other.
bool has_room_beside(const Panel& panel, double height) {
  double needed = 0;
  for (const Curve& curve : panel.curves) {
    if (!is_named_beside(panel, curve)) continue;
    needed += high;
    if (text_width(plain_text(curve.label)) > widest) return false;
  }
  return needed <= height;
}

}  // namespace

double room_of_names(const Panel& panel) {
  double room = 0;
  if (!panel.names_at_ends || !has_room_beside(panel, panel.height)) return room;
  for (const Curve& curve : panel.curves) {
    if (!is_named_beside(panel, curve)) continue;
    room = std::max(room, clear + text_width(plain_text(curve.label)) + clear);
  }
  return room;
}

bool lacks_names(const Panel& panel, const std::vector<CurveName>& names) {
  if (!panel.names_at_ends) return false;
  const auto named = std::count_if(panel.curves.begin(), panel.curves.end(), has_name);
  return std::ssize(names) < named;
}

std::vector<CurveName> names_at_ends(const Panel& panel, const Ticks& x, const Ticks& y, double width, double height) {
  std::vector<CurveName> names;
  if (!panel.names_at_ends) return names;
  const bool beside = has_room_beside(panel, panel.height);
  Frame frame(panel, x, y, width, height);
  for (std::size_t c = 0; c < panel.curves.size(); ++c) {
    const Curve& curve = panel.curves[c];
    if (!has_name(curve)) continue;
    if (!is_named_beside(panel, curve)) {
      if (auto name = frame.name(c)) names.push_back(*std::move(name));
    } else if (beside) {
      const auto end = *end_of(curve);
      names.push_back({.curve = c, .label = plain_text(curve.label), .x = *panel.x.to, .y = end.second});
    }
  }
  std::vector<CurveName*> at_edge;
  for (CurveName& name : names) {
    if (is_named_beside(panel, panel.curves[name.curve])) at_edge.push_back(&name);
  }
  spread(at_edge, y, height);
  return names;
}

}  // namespace bentur
