#include "bentur/study/remedy/least_gap.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "bentur/core/errors.h"
#include "bentur/io/results/story_json.h"
#include "bentur/model/plan/plan_pair.h"
#include "bentur/study/gap/gap_study_story.h"

namespace bentur {
namespace {

using Json = nlohmann::ordered_json;

constexpr int figures = 3;

/// Of a case, with nothing known of its gaps yet.
LeastGaps begun(const std::string& title, const Units& units, LeastGaps::Basis basis = LeastGaps::Basis::motion) {
  return {.title = title, .units = units, .buildings = {}, .basis = basis, .both_ways = true};
}

/// A gap by what each of its levels needs. @param scale [length], for round-off
void add_gap(LeastGaps& found, LeastGap gap, const std::vector<LevelSeparation>& levels, double scale) {
  gap.is_facing = !levels.empty();
  for (const LevelSeparation& one : levels) {
    const double needed = std::max(one.gap_needed, one.gap_needed_reversed.value_or(0));
    gap.needed = std::max(gap.needed, one.level.of_gap(needed));
    gap.given = &one == levels.data() ? one.level.width : std::min(gap.given, one.level.width);
    gap.is_short = gap.is_short || falls_short(one.level.width, needed, scale);
    found.both_ways = found.both_ways && one.gap_needed_reversed.has_value();
  }
  if (!falls_short(0, gap.needed, scale)) gap.needed = 0;  // round-off
  gap.width = rounded_up(gap.needed);
  found.gaps.push_back(std::move(gap));
}

/// All gaps of a row. @param scale of each gap [length], for round-off
template <class Scale>
void add_gaps(LeastGaps& found, const Problem& problem, const std::vector<LevelSeparation>& all, const Scale& scale) {
  for (const Building& building : problem.buildings) found.buildings.push_back(building.name);
  for (Eigen::Index gap = 0; gap + 1 < std::ssize(problem.buildings); ++gap) {
    add_gap(found, {gap_name(problem, gap), gap, gap + 1}, of_gap(all, gap), scale(gap));
  }
}

/// What the gap is needed for, as a word of the catalogue.
std::string motions_of(const LeastGaps& found) {
  switch (found.basis) {
    case LeastGaps::Basis::spectrum:
      return "story.least_gap.spectrum";
    case LeastGaps::Basis::records:
      return found.both_ways ? "story.least_gap.records_both" : "story.least_gap.records";
    case LeastGaps::Basis::motion:
      break;
  }
  return found.both_ways ? "story.least_gap.motion_both" : "story.least_gap.motion";
}

Statement statement_of(const LeastGaps& found, Eigen::Index gap) {
  const LeastGap& one = found.gaps[gap];
  const auto [first, second] = std::minmax(one.left, one.right);
  Statement statement{.kind = "no_level", .gap = gap, .buildings = {first, second}};
  if (!one.is_facing) return statement;
  const std::string& length = found.units.length;
  statement.values = {{"left", found.buildings[one.left]},
                      {"right", found.buildings[one.right]},
                      {"motions", motions_of(found), {}, true}};
  if (found.basis == LeastGaps::Basis::records) statement.values.push_back({"records", found.records});
  if (found.collapses) {
    statement.kind = "least_gap_unknown";
    statement.severity = Severity::danger;
    return statement;
  }
  statement.kind = one.is_short ? "least_gap_short" : "least_gap_enough";
  if (one.is_short) statement.severity = Severity::warning;
  statement.values.push_back({"least", one.width, length});
  statement.values.push_back({"given", one.given, length});
  return statement;
}

}  // namespace

double rounded_up(double x) {
  if (!(x > 0) || !std::isfinite(x)) return x;
  const double unit = std::pow(10.0, std::floor(std::log10(x)) - (figures - 1));
  double count = std::ceil(x / unit);
  // Divided by a power of ten it is the nearest number to its decimals.
  const auto value = [&] { return unit < 1 ? count / std::round(1 / unit) : count * unit; };
  while (value() < x) count += 1;
  return value();
}

LeastGaps least_gaps(const RunResults& run) {
  LeastGaps found = begun(run.c.title, run.c.units);
  found.collapses = run.response.collapse_no_contact.has_value();
  add_gaps(found, run.problem, separations(run.problem, run.response),
           [&](Eigen::Index gap) { return displacement_scale(run.problem, run.response, gap); });
  return found;
}

LeastGaps least_gaps(const PlanRun& run) {
  LeastGaps found = begun(run.c.title, run.c.units);
  found.collapses = run.response.collapse_no_contact.has_value();
  for (const PlanBuilding& building : run.problem.buildings) found.buildings.push_back(building.name);
  for (std::size_t g = 0; g < run.problem.gaps.size(); ++g) {
    const PlanGap& gap = run.problem.gaps[g];
    const RunResults pair = pair_of(run, g);
    add_gap(found,
            {gap_name(run.problem, gap), static_cast<Eigen::Index>(gap.left), static_cast<Eigen::Index>(gap.right)},
            separations(pair.problem, pair.response), displacement_scale(pair.problem, pair.response, 0));
  }
  return found;
}

LeastGaps least_gaps(const Case& c, const Problem& problem, const SpectralGaps& spectral) {
  LeastGaps found = begun(c.title, c.units, LeastGaps::Basis::spectrum);
  add_gaps(found, problem, spectral.levels, [](Eigen::Index) { return 0.0; });
  return found;
}

LeastGaps least_gaps(const Case& c, const GapStudy& study) {
  if (!study.is_whole()) throw InvalidParameter("study", "stopped", "must have all its records");
  const RecordNeeds& needs = study.needs.front();
  LeastGaps found = begun(study.title, study.units, LeastGaps::Basis::records);
  found.buildings = study.buildings;
  found.records = std::ssize(needs.records);
  found.both_ways = c.analysis.both_ways;
  for (const RecordNeed& one : needs.records) found.collapses = found.collapses || one.collapsed;
  for (std::size_t g = 0; g < needs.gaps.size(); ++g) {
    const GivenGap& given = needs.gaps[g].given.front();
    const GapStudy::Between& between = study.gaps[g];
    LeastGap one{between.name, between.left, between.right, !given.widths.empty()};
    one.needed = needs.gaps[g].largest.gap_needed;
    one.width = rounded_up(one.needed);
    one.given = given.narrowest().value_or(0);
    one.is_short = given.beyond > 0;
    found.gaps.push_back(std::move(one));
  }
  for (Statement& one : gap_study_story(study).statements) {
    if (one.gap && one.kind.starts_with("suite_")) found.of_codes.push_back(std::move(one));
  }
  return found;
}

Story least_gap_story(const LeastGaps& found) {
  Story story;
  for (Eigen::Index gap = 0; gap < std::ssize(found.gaps); ++gap) story.statements.push_back(statement_of(found, gap));
  story.statements.insert(story.statements.end(), found.of_codes.begin(), found.of_codes.end());
  sort_by_severity(story.statements);
  story.statements.push_back({.kind = "remedy_ways"});
  return story;
}

std::string least_gap_json(const LeastGaps& found, std::string_view version) {
  static constexpr const char* bases[] = {"motion", "records", "spectrum"};
  Json gaps = Json::array();
  for (const LeastGap& one : found.gaps) {
    const bool is_known = one.is_facing && !found.collapses;
    const auto number = [&](double value) { return is_known ? Json(value) : Json(nullptr); };
    gaps.push_back({{"between", {found.buildings[one.left], found.buildings[one.right]}},
                    {"least_gap", number(one.width)},
                    {"gap_needed", number(one.needed)},
                    {"given", one.is_facing ? Json(one.given) : Json(nullptr)},
                    {"too_narrow", is_known ? Json(one.is_short) : Json(nullptr)}});
  }
  const Json json = {{"title", found.title},
                     {"version", version},
                     {"unit", found.units.length},
                     {"basis", bases[static_cast<int>(found.basis)]},
                     {"records", found.basis == LeastGaps::Basis::records ? Json(found.records) : Json(nullptr)},
                     {"both_ways", found.both_ways},
                     {"statements", Json::parse(statements_json(found.buildings, least_gap_story(found).statements))},
                     {"gaps", gaps}};
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace bentur
