#include "bentur/study/remedy/least_gap.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "bentur/core/errors.h"
#include "bentur/io/results/story_json.h"
#include "bentur/study/gap/gap_study_story.h"

namespace bentur {
namespace {

using Json = nlohmann::ordered_json;

constexpr int figures = 3;

/// A problem's gaps from what each level needs. @param scale of a gap [length], for round-off
template <class Scale>
void add_gaps(LeastGaps& found, const std::vector<LevelSeparation>& all, const Scale& scale) {
  for (Eigen::Index gap = 0; gap + 1 < std::ssize(found.problem.buildings); ++gap) {
    const std::vector<LevelSeparation> levels = of_gap(all, gap);
    LeastGap least;
    for (const LevelSeparation& one : levels) {
      const double needed = std::max(one.gap_needed, one.gap_needed_reversed.value_or(0));
      least.needed = std::max(least.needed, needed);
      least.given = &one == levels.data() ? one.level.width : std::min(least.given, one.level.width);
      least.is_short = least.is_short || falls_short(one.level.width, needed, scale(gap));
      found.both_ways = found.both_ways && one.gap_needed_reversed.has_value();
    }
    if (!falls_short(0, least.needed, scale(gap))) least.needed = 0;  // round-off
    least.width = rounded_up(least.needed);
    found.gaps.push_back(least);
    found.is_facing.push_back(levels.empty() ? 0 : 1);
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
  Statement statement{.kind = "no_level", .gap = gap, .buildings = {gap, gap + 1}};
  if (found.is_facing[gap] == 0) return statement;
  const LeastGap& one = found.gaps[gap];
  const std::string& length = found.units.length;
  statement.values = {{"left", found.problem.buildings[gap].name},
                      {"right", found.problem.buildings[gap + 1].name},
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
  LeastGaps found{.title = run.c.title, .units = run.c.units, .problem = run.problem, .both_ways = true};
  found.collapses = run.response.collapse_no_contact.has_value();
  add_gaps(found, separations(run.problem, run.response),
           [&](Eigen::Index gap) { return displacement_scale(run.problem, run.response, gap); });
  return found;
}

LeastGaps least_gaps(const Case& c, const Problem& problem, const SpectralGaps& spectral) {
  LeastGaps found{.title = c.title, .units = c.units, .problem = problem, .basis = LeastGaps::Basis::spectrum};
  add_gaps(found, spectral.levels, [](Eigen::Index) { return 0.0; });
  return found;
}

LeastGaps least_gaps(const Case& c, const GapStudy& study) {
  if (!study.is_whole()) throw InvalidParameter("study", "stopped", "must have all its records");
  const RecordNeeds& needs = study.needs.front();
  LeastGaps found{.title = study.title,
                  .units = study.units,
                  .problem = study.problem,
                  .basis = LeastGaps::Basis::records,
                  .records = std::ssize(needs.records),
                  .both_ways = c.analysis.both_ways};
  for (const RecordNeed& one : needs.records) found.collapses = found.collapses || one.collapsed;
  for (const GapOverRecords& one : needs.gaps) {
    const GivenGap& given = one.given.front();
    const double needed = one.largest.gap_needed;
    const auto narrowest = std::min_element(given.widths.begin(), given.widths.end());
    found.is_facing.push_back(given.widths.empty() ? 0 : 1);
    found.gaps.push_back({.needed = needed,
                          .width = rounded_up(needed),
                          .given = given.widths.empty() ? 0 : *narrowest,
                          .is_short = given.beyond > 0});
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
  for (std::size_t gap = 0; gap < found.gaps.size(); ++gap) {
    const LeastGap& one = found.gaps[gap];
    const bool is_known = found.is_facing[gap] != 0 && !found.collapses;
    const auto number = [&](double value) { return is_known ? Json(value) : Json(nullptr); };
    gaps.push_back({{"between", {found.problem.buildings[gap].name, found.problem.buildings[gap + 1].name}},
                    {"least_gap", number(one.width)},
                    {"gap_needed", number(one.needed)},
                    {"given", found.is_facing[gap] != 0 ? Json(one.given) : Json(nullptr)},
                    {"too_narrow", is_known ? Json(one.is_short) : Json(nullptr)}});
  }
  const Json json = {{"title", found.title},
                     {"version", version},
                     {"unit", found.units.length},
                     {"basis", bases[static_cast<int>(found.basis)]},
                     {"records", found.basis == LeastGaps::Basis::records ? Json(found.records) : Json(nullptr)},
                     {"both_ways", found.both_ways},
                     {"statements", Json::parse(statements_json(found.problem, least_gap_story(found).statements))},
                     {"gaps", gaps}};
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace bentur
