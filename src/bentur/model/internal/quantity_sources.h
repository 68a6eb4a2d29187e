#pragma once

#include <cmath>
#include <type_traits>
#include <vector>

#include "bentur/core/not_known.h"
#include "bentur/model/plan/plan_run.h"
#include "bentur/model/quantities.h"

// How quantities are read from responses of rows and plans, and put back.
namespace bentur::sources {

template <class Value>
[[nodiscard]] double number_of(const Value& value) {
  return static_cast<double>(value);
}
[[nodiscard]] inline double number_of(const std::optional<double>& value) { return value.value_or(not_known); }

template <class Value>
void keep_number(Value& kept, double value) {
  if constexpr (std::is_same_v<Value, bool>) {
    kept = value != 0;
  } else if constexpr (std::is_same_v<Value, std::optional<double>>) {
    kept = std::isnan(value) ? std::nullopt : std::optional(value);
  } else {
    kept = static_cast<Value>(value);
  }
}

template <class Value>
constexpr QuantitySource::Number number_kind = std::is_same_v<Value, bool>  ? QuantitySource::Number::yes_or_no
                                               : std::is_same_v<Value, int> ? QuantitySource::Number::count
                                                                            : QuantitySource::Number::real;

/// Of a peak and the same without contact; none where contact makes something of nothing, round-off included.
[[nodiscard]] inline double ratio_of_peaks(double with, double without) {
  constexpr double round_off = 1e-9;
  return without > round_off * with ? with / without : not_known;
}

/// Of floors' masses [force].
[[nodiscard]] inline double weight_of(const std::vector<double>& masses, const Units& units) {
  double weight = 0;
  for (const double mass : masses) weight += mass * units.gravity;
  return weight;
}

[[nodiscard]] inline QuantitySource when(When when, QuantitySource source) {
  source.when = when;
  return source;
}
[[nodiscard]] inline QuantitySource count(QuantitySource source) {
  source.number = QuantitySource::Number::count;
  return source;
}
[[nodiscard]] inline QuantitySource forces(QuantitySource source) {
  source.table = QuantityTable::forces;
  return source;
}

[[nodiscard]] inline QuantitySource in_plan_alone(QuantitySource source) {
  source.row = {};
  return source;
}

/// What is computed of a row.
[[nodiscard]] inline QuantitySource computed(double (*value)(const RunView&, const QuantityPlace&)) {
  QuantitySource source;
  source.row.value = value;
  return source;
}

/// What is computed of rows and plans alike.
template <class Compute>
[[nodiscard]] QuantitySource of_any(Compute value) {
  QuantitySource source;
  source.row.value = value;
  source.plan.value = value;
  return source;
}

/// Of a gap: of one in plan as of the row of its two buildings. @param both_ways the reversed motion has to be asked
/// for
[[nodiscard]] QuantitySource of_gaps(double (*value)(const Problem&, const Response&, Eigen::Index),
                                     bool both_ways = false);

/// Of what every run came to: `value` reads it of a RunOutcome, `keep` puts it there.
template <class Value, class Keep>
[[nodiscard]] QuantitySource of_outcome(Value value, Keep keep) {
  QuantitySource source;
  const auto read = [value](const auto& run, const QuantityPlace& at) { return value(run.response, at); };
  source.row.value = read;
  source.plan.value = read;
  source.row.keep = [keep](Response& response, const QuantityPlace& at, double number) { keep(response, at, number); };
  source.plan.keep = [keep](PlanRun& run, const QuantityPlace& at, double number) { keep(run.response, at, number); };
  return source;
}
/// A member of each point, impact or link.
template <class Item, class Member>
[[nodiscard]] QuantitySource of_items(std::vector<Item> RunOutcome::*list, Member Item::*member) {
  QuantitySource source = of_outcome(
      [=](const RunOutcome& run, const QuantityPlace& at) {
        return at.item < std::ssize(run.*list) ? number_of((run.*list)[at.item].*member) : not_known;
      },
      [=](RunOutcome& run, const QuantityPlace& at, double number) {
        keep_number((run.*list).at(at.item).*member, number);
      });
  source.number = number_kind<Member>;
  return source;
}
template <class Member>
[[nodiscard]] QuantitySource of_points(Member PointSummary::*member) {
  return of_items(&RunOutcome::points, member);
}
template <class Member>
[[nodiscard]] QuantitySource of_impacts(Member Impact::*member) {
  return of_items(&RunOutcome::impacts, member);
}
[[nodiscard]] inline QuantitySource of_links(double LinkSummary::*member) {
  return of_items(&RunOutcome::links, member);
}
/// Of points that was asked for in plan with `both_ways` alone.
[[nodiscard]] QuantitySource needed_reversed();
/// w of points.
[[nodiscard]] QuantitySource widths();

/// Lists of buildings of a row, over floors or storeys, that `find` finds.
template <class Find>
[[nodiscard]] QuantitySource of_lists(Find find) {
  QuantitySource source;
  source.row.value = [find](const RunView& run, const QuantityPlace& at) {
    const Eigen::VectorXd& values = find(run.response.buildings[at.item]);
    return at.floor < values.size() ? values(at.floor) : not_known;
  };
  source.row.keep = [find](Response& response, const QuantityPlace& at, double number) {
    Eigen::VectorXd& values = find(response.buildings.at(at.item));
    if (values.size() <= at.floor) values.conservativeResize(at.floor + 1);
    values(at.floor) = number;
  };
  return source;
}
/// The same that are empty where the building has none.
template <class Find>
[[nodiscard]] QuantitySource of_some_lists(When when, Find find) {
  QuantitySource source = of_lists(find);
  source.row.is_told = [find](const RunView& run, Eigen::Index b) {
    return find(run.response.buildings[b]).size() > 0;
  };
  source.when = when;
  source.table = QuantityTable::yielding;
  return source;
}
[[nodiscard]] inline QuantitySource of_floors(Eigen::VectorXd BuildingPeaks::*list) {
  return of_lists([list](auto& peaks) -> auto& { return peaks.*list; });
}
[[nodiscard]] QuantitySource of_yielding(Eigen::VectorXd BuildingPeaks::Yielding::*list,
                                         BuildingPeaks::Yielding BuildingPeaks::*of = &BuildingPeaks::yielding);
[[nodiscard]] QuantitySource of_infill(Eigen::VectorXd BuildingPeaks::Infill::*list);
/// Sway (0) or rocking (1) of the foundation of a building of a row.
[[nodiscard]] QuantitySource of_foundation(Eigen::Index entry);

/// A member of each hinge of a frame, or of each column that can break.
template <class Item, class Member>
[[nodiscard]] QuantitySource of_frames(When when, std::vector<Item> BuildingPeaks::*list, Member Item::*member) {
  const auto value = [=](const BuildingPeaks& peaks, Eigen::Index i) {
    const std::vector<Item>& items = peaks.*list;
    return i < std::ssize(items) ? number_of(items[i].*member) : not_known;
  };
  const auto keep = [=](BuildingPeaks& peaks, Eigen::Index i, double number) {
    std::vector<Item>& items = peaks.*list;
    if (std::ssize(items) <= i) items.resize(static_cast<std::size_t>(i) + 1);
    keep_number(items[i].*member, number);
  };
  QuantitySource source;
  source.row.value = [=](const RunView& run, const QuantityPlace& at) {
    return value(run.response.buildings[at.item], at.floor);
  };
  source.row.keep = [=](Response& response, const QuantityPlace& at, double number) {
    keep(response.buildings.at(at.item), at.floor, number);
  };
  source.row.is_told = [list](const RunView& run, Eigen::Index b) {
    return !(run.response.buildings[b].*list).empty();
  };
  source.plan.value = [=](const PlanRun& run, const QuantityPlace& at) {
    return value(run.response.buildings[at.item].planes[at.plane].frame, at.floor);
  };
  source.plan.keep = [=](PlanRun& run, const QuantityPlace& at, double number) {
    keep(run.response.buildings.at(at.item).planes.at(at.plane).frame, at.floor, number);
  };
  source.when = when;
  source.number = number_kind<Member>;
  return source;
}
template <class Member>
[[nodiscard]] QuantitySource of_hinges(Member BuildingPeaks::Hinge::*member) {
  return of_frames(When::hinges, &BuildingPeaks::hinges, member);
}
/// Of those that lose strength.
[[nodiscard]] QuantitySource of_weakening(std::optional<double> BuildingPeaks::Hinge::*member);
/// Of all hinges of a building.
[[nodiscard]] QuantitySource hinge_energy();
template <class Member>
[[nodiscard]] QuantitySource of_columns(Member BuildingPeaks::Breaking::*member) {
  return of_frames(When::breaking_columns, &BuildingPeaks::columns, member);
}

/// What a column carries that a floor strikes: as it stands in a response, or computed of it and of what the case says
/// of the contact point.
[[nodiscard]] QuantitySource of_struck(double ColumnPeaks::*member);
[[nodiscard]] QuantitySource of_struck(double (*value)(const ColumnPeaks&, const ContactPoint&), When when);

}  // namespace bentur::sources
