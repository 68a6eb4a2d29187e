#include <algorithm>
#include <limits>
#include <utility>

#include "bentur/report/figures/internal/text_width.h"
#include "bentur/report/kinds/internal/plan_figures.h"
#include "bentur/report/scene/names.h"

namespace bentur {
namespace {

using Span = std::pair<double, double>;

/// Where a line at this height is within rings and none above covers it, ascending.
std::vector<Span> free_spans(double y, const PlanRings& rings, const std::vector<PlanRings>& above) {
  std::vector<double> crossings;
  const auto cross = [&](const PlanRings& all) {
    for (const std::vector<PlanPoint>& ring : all) {
      for (std::size_t i = 0; i + 1 < ring.size(); ++i) {
        const PlanPoint &from = ring[i], &to = ring[i + 1];
        if ((from.y() > y) == (to.y() > y)) continue;
        crossings.push_back(from.x() + (y - from.y()) / (to.y() - from.y()) * (to.x() - from.x()));
      }
    }
  };
  cross(rings);
  std::for_each(above.begin(), above.end(), cross);
  std::sort(crossings.begin(), crossings.end());
  std::vector<Span> spans;
  for (std::size_t i = 0; i + 1 < crossings.size(); ++i) {
    const PlanPoint middle((crossings[i] + crossings[i + 1]) / 2, y);
    const auto covers = [&](const PlanRings& one) { return lies_in(middle, one); };
    if (lies_in(middle, rings) && std::none_of(above.begin(), above.end(), covers)) {
      spans.emplace_back(crossings[i], crossings[i + 1]);
    }
  }
  return spans;
}

std::vector<Span> in_both(const std::vector<Span>& a, const std::vector<Span>& b) {
  std::vector<Span> both;
  for (const Span& one : a) {
    for (const Span& other : b) {
      const Span shared(std::max(one.first, other.first), std::min(one.second, other.second));
      if (shared.first < shared.second) both.push_back(shared);
    }
  }
  return both;
}

/// What a mark leaves of them.
std::vector<Span> beside(const std::vector<Span>& spans, const Box& mark) {
  std::vector<Span> left;
  for (const auto& [from, to] : spans) {
    if (mark.right <= from || mark.left >= to) {
      left.emplace_back(from, to);
      continue;
    }
    if (mark.left > from) left.emplace_back(from, mark.left);
    if (mark.right < to) left.emplace_back(mark.right, to);
  }
  return left;
}

}  // namespace

PlaceText place_of_name(const std::string& name, const PlanRings& rings, const NameRows& rows,
                        const std::vector<PlanRings>& above) {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (const std::vector<PlanPoint>& ring : rings) {
    for (const PlanPoint& at : ring) low = std::min(low, at.y()), high = std::max(high, at.y());
  }
  PlaceText placed{.text = name, .side = PlaceText::Side::middle};
  for (const double part : rows.parts) {
    const double y = low + part * (high - low);
    std::vector<Span> spans = free_spans(y, rings, above);
    for (const double edge : {y - rows.half_height, y + rows.half_height}) {
      spans = in_both(spans, free_spans(edge, rings, above));
    }
    for (const Box& mark : rows.marks) {
      if (mark.bottom < y + rows.half_height && mark.top > y - rows.half_height) spans = beside(spans, mark);
    }
    for (const auto& [from, to] : spans) {
      const double room = 0.94 * (to - from);
      if (room < 1.05 * placed.room) continue;
      placed.x = (from + to) / 2;
      placed.y = y;
      placed.room = room;
    }
  }
  return placed;
}

std::vector<PlaceText> places_of_names(const PlanProblem& problem, const std::vector<PlanRings>& rings,
                                       const NameRows& rows, double one_cm,
                                       const std::vector<std::vector<PlanRings>>& above) {
  const std::vector<std::string> names = building_names(problem);
  std::vector<PlaceText> places;
  for (const std::vector<std::string>& texts : {names, short_names(names)}) {
    places.clear();
    bool have_room = true;
    for (std::size_t b = 0; b < texts.size(); ++b) {
      places.push_back(place_of_name(texts[b], rings[b], rows, above.empty() ? std::vector<PlanRings>() : above[b]));
      constexpr double clear = 0.1;  // beside a name [cm]
      have_room = have_room && (text_width(texts[b]) + 2 * clear) * one_cm < places.back().room;
    }
    if (have_room) break;
  }
  return places;
}

}  // namespace bentur
