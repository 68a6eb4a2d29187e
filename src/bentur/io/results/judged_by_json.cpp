#include "bentur/io/results/judged_by_json.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace bentur {
namespace {

using Json = nlohmann::json;
using OrderedJson = nlohmann::ordered_json;

/// Whether something needs the most with masses elsewhere than they are expected.
bool has_masses_elsewhere(const RunOutcome& outcome) {
  const auto is_moved = [](const auto& one) { return one.masses > 0 || one.masses_reversed > 0; };
  return std::any_of(outcome.points.begin(), outcome.points.end(), is_moved) ||
         std::any_of(outcome.watched.begin(), outcome.watched.end(), is_moved);
}

}  // namespace

OrderedJson judged_by_json(const RunOutcome& outcome, const std::vector<LargestDrift>& drifts) {
  const auto or_null_of = [](const std::optional<double>& value) {
    if (value && std::isinf(*value)) return OrderedJson("record left");  // nobody knows
    return value ? OrderedJson(*value) : OrderedJson(nullptr);
  };
  const auto drifts_json = [](const std::vector<LargestDrift>& all) {
    OrderedJson list = OrderedJson::array();
    for (const LargestDrift& one : all) list.push_back({{"storey", one.storey}, {"ratio", one.ratio}});
    return list;
  };
  const auto to_come = [&](const auto& all) {
    OrderedJson list = OrderedJson::array();
    for (const auto& one : all) {
      list.push_back({or_null_of(one.to_come), or_null_of(one.to_come_reversed), or_null_of(one.to_come_struck)});
    }
    return list;
  };
  const auto collapse = [](const std::optional<Collapse>& one) {
    if (!one) return OrderedJson(nullptr);
    return OrderedJson{{"building", one->building}, {"storey", one->storey}, {"time", one->time}};
  };
  OrderedJson json = {{"drifts_no_contact", drifts_json(drifts)},
                      {"points_to_come", to_come(outcome.points)},
                      {"watched_to_come", to_come(outcome.watched)},
                      {"reversed", nullptr}};
  const auto masses = [](const auto& all) {
    OrderedJson list = OrderedJson::array();
    for (const auto& one : all) list.push_back({one.masses, one.masses_reversed});
    return list;
  };
  if (has_masses_elsewhere(outcome)) {
    json["points_masses"] = masses(outcome.points);
    json["watched_masses"] = masses(outcome.watched);
  }
  if (!outcome.reversed) return json;
  const ReversedRun& other = *outcome.reversed;
  OrderedJson points = OrderedJson::array(), watched = OrderedJson::array();
  for (const PointSummary& one : other.points) {
    points.push_back({{"impacts", one.impacts},
                      {"settling", one.settling},
                      {"peak_force", one.peak_force},
                      {"to_come", or_null_of(one.to_come_struck)}});
  }
  for (const WatchedSummary& one : other.watched) {
    watched.push_back(
        {{"closes", one.closes}, {"least_opening", one.least_opening}, {"to_come", or_null_of(one.to_come_struck)}});
  }
  json["reversed"] = {{"collapse", collapse(other.collapse)},
                      {"collapse_no_contact", collapse(other.collapse_no_contact)},
                      {"drifts_no_contact", drifts_json(other.drifts)},
                      {"has_contact", other.has_contact},
                      {"points", points},
                      {"watched_floors", watched}};
  return json;
}

std::vector<LargestDrift> take_judged_by(const Json& json, RunOutcome& outcome) {
  const auto number = [](const Json& value) {
    if (value.is_string()) return std::optional(std::numeric_limits<double>::infinity());
    return value.is_null() ? std::nullopt : std::optional(value.get<double>());
  };
  const auto drifts = [](const Json& list) {
    std::vector<LargestDrift> all;
    for (const Json& one : list) all.push_back({one.at("ratio"), one.at("storey")});
    return all;
  };
  const auto to_come = [&](const Json& list, auto& all) {
    for (std::size_t i = 0; i < all.size(); ++i) {
      all[i].to_come = number(list.at(i).at(0));
      all[i].to_come_reversed = number(list.at(i).at(1));
      all[i].to_come_struck = number(list.at(i).at(2));
    }
  };
  const auto collapse = [](const Json& one) -> std::optional<Collapse> {
    if (one.is_null()) return std::nullopt;
    return Collapse{one.at("building"), one.at("storey"), one.at("time")};
  };
  to_come(json.at("points_to_come"), outcome.points);
  to_come(json.at("watched_to_come"), outcome.watched);
  const auto masses = [](const Json& list, auto& all) {
    for (std::size_t i = 0; i < all.size(); ++i) {
      all[i].masses = list.at(i).at(0);
      all[i].masses_reversed = list.at(i).at(1);
    }
  };
  if (json.contains("points_masses")) {
    masses(json.at("points_masses"), outcome.points);
    masses(json.at("watched_masses"), outcome.watched);
  }
  const Json& told = json.at("reversed");
  if (!told.is_null()) {
    ReversedRun other;
    other.collapse = collapse(told.at("collapse"));
    other.collapse_no_contact = collapse(told.at("collapse_no_contact"));
    other.drifts = drifts(told.at("drifts_no_contact"));
    other.has_contact = told.at("has_contact");
    for (const Json& one : told.at("points")) {
      PointSummary& point = other.points.emplace_back();
      point.impacts = one.at("impacts");
      point.settling = one.at("settling");
      point.peak_force = one.at("peak_force");
      point.to_come_struck = number(one.at("to_come"));
    }
    for (const Json& one : told.at("watched_floors")) {
      WatchedSummary& floor = other.watched.emplace_back();
      floor.closes = one.at("closes");
      floor.least_opening = one.at("least_opening");
      floor.to_come_struck = number(one.at("to_come"));
    }
    outcome.reversed = std::move(other);
  }
  return drifts(json.at("drifts_no_contact"));
}

}  // namespace bentur
