#include "bentur/study/remedy/least_gap.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "bentur/core/errors.h"
#include "bentur/io/results/story_json.h"
#include "bentur/model/gap/gap_outcome.h"
#include "bentur/model/judgement/compare.h"
#include "bentur/model/judgement/judged_gaps.h"
#include "bentur/model/plan/plan_row.h"

namespace bentur {
namespace {

using Json = nlohmann::ordered_json;

constexpr int figures = 3;

/// Of a case, with nothing known of its gaps yet.
LeastGaps begun(const std::string& title, const Units& units, LeastGaps::Basis basis = LeastGaps::Basis::motion) {
  return {.title = title, .units = units, .buildings = {}, .basis = basis, .both_ways = true};
}

void take_reason(const Reason& reason, LeastGap& gap) {
  gap.is_short = gap.is_short || is_by_motion(reason.kind);
  gap.is_doubted = gap.is_doubted || !says_too_small(reason.kind);
}

/// A gap from all that is known of it.
void add_gap(LeastGaps& found, LeastGap gap, const JudgedGap& judged) {
  const GapFacts& facts = judged.facts;
  gap.is_facing = !facts.levels.empty();
  gap.judged = judged.judgement.value;
  gap.others_close = judged.judgement.alone;
  for (const LevelFacts& level : facts.levels) {
    gap.is_known = gap.is_known && (level.given.need || level.given.at_most);
    for (const Way way : ways_of_motion) {
      const std::optional<double>& need = level.in(way).need;
      if (need) gap.needed = std::max(gap.needed, level.at.to_have(*need));
      const std::optional<double>& sum = level.in(way).at_most;
      if (sum) gap.needed = std::max(gap.needed, level.at.to_have(*sum));
      gap.by_peaks = gap.by_peaks || sum;
    }
    gap.given = &level == facts.levels.data() ? level.at.width : std::min(gap.given, level.at.width);
  }
  gap.is_beside = gap.is_known && !std::isfinite(gap.needed);
  gap.is_known = gap.is_known && !gap.is_beside;
  const WayFacts& other = facts.reversed;
  if (facts.has_other_way && other.looked_at && (other.fall || !other.drifts.empty())) gap.is_known = false;
  found.both_ways = found.both_ways && (!facts.has_other_way || other.looked_at);
  for (const Reason& reason : judged.judgement.reasons) take_reason(reason, gap);
  for (const RuleFinding& rule : facts.rules) {
    if (rule.at && find_code_rule(rule.rule) != nullptr) gap.asked = std::max(gap.asked.value_or(0), rule.most);
  }
  gap.needed = without_round_off(gap.needed, facts.scale);
  gap.width = rounded_up(gap.needed);
  found.gaps.push_back(std::move(gap));
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
  statement.values.push_back({"given", one.given, length});
  const bool is_small = one.judged == Sufficiency::too_small;
  statement.values.push_back({"small", is_small ? "story.least_gap_small" : "", {}, is_small});
  if (!one.is_known) {
    statement.kind = one.is_beside ? "least_gap_beside" : "least_gap_unknown";
    statement.severity = Severity::danger;
    return statement;
  }
  const bool is_mean = found.basis == LeastGaps::Basis::spectrum && !one.is_doubted;  // of its motions
  statement.kind = one.by_peaks                   ? "least_gap_peaks"
                   : is_mean                      ? (one.is_short ? "least_gap_spectrum_short" : "least_gap_spectrum")
                   : one.others_close && is_small ? "least_gap_alone_small"
                   : one.others_close             ? "least_gap_alone"
                   : one.is_short                 ? "least_gap_short"
                   : one.is_doubted               ? "least_gap_doubt"
                   : one.judged == Sufficiency::too_small ? "least_gap_rules"
                                                          : "least_gap_enough";
  if (one.judged != Sufficiency::enough) statement.severity = Severity::warning;
  statement.values.push_back({"least", one.width, length});
  const auto add = [&](const char* name, bool is_said, const char* text) {
    statement.values.push_back({name, is_said ? text : "", {}, is_said});
  };
  const bool asks_more = one.asked.value_or(0) - one.width > 0;
  add("doubt", one.is_doubted, "story.least_gap_more");
  add("rules", asks_more, "story.least_gap_asked");
  if (asks_more) statement.values.push_back({"asked", *one.asked, length});
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

namespace {

/// @param problem a row, or row_of() buildings in plan
LeastGaps least_of(const Problem& problem, const std::vector<JudgedGap>& judged, LeastGaps found) {
  for (const Building& building : problem.buildings) found.buildings.push_back(building.name);
  for (std::size_t g = 0; g < judged.size(); ++g) {
    const auto gap = static_cast<Eigen::Index>(g);
    const GapPair sides = sides_of(problem, gap);
    add_gap(found, {gap_name(problem, gap), sides.left, sides.right}, judged[g]);
  }
  return found;
}

}  // namespace

LeastGaps least_gaps(const RunResults& run) {
  return least_of(run.problem, judged_gaps(run), begun(run.c.title, run.c.units));
}

LeastGaps least_gaps(const PlanRun& run) {
  return least_of(row_of(run)->problem, judged_gaps(run), begun(run.c.title, run.c.units));
}

LeastGaps least_gaps(const Case& c, const Problem& problem, const SpectralGaps& spectral) {
  LeastGaps found =
      least_of(problem, judged_gaps(c, problem, spectral), begun(c.title, c.units, LeastGaps::Basis::spectrum));
  found.both_ways = false;
  return found;
}

LeastGaps least_gaps(const SuiteRun& run, const GapStudy& study) {
  if (!run.is_whole() || !study.is_whole()) throw InvalidParameter("study", "stopped", "must have all its records");
  const RecordNeeds& needs = study.needs.front();
  LeastGaps found = begun(study.title, study.units, LeastGaps::Basis::records);
  found.buildings = study.buildings;
  found.records = std::ssize(needs.records);
  found.both_ways = run.c.analysis.both_ways;
  const std::vector<SuiteJudgement> judged = judged_gaps(run, study);
  for (std::size_t g = 0; g < needs.gaps.size(); ++g) {
    const GivenGap& given = needs.gaps[g].given.front();
    const GapStudy::Between& between = study.gaps[g];
    const JudgementOfMany& many = judged.at(g).many;
    LeastGap one{between.name, between.left, between.right, !given.widths.empty()};
    one.needed = needs.gaps[g].largest.gap_needed;
    one.is_known = std::isfinite(one.needed) &&
                   std::none_of(many.reasons.begin(), many.reasons.end(), [](const JudgementOfMany::Found& of) {
                     return of.worst.kind == Reason::Kind::collapse || of.worst.kind == Reason::Kind::drift;
                   });
    one.width = rounded_up(one.needed);
    one.given = given.narrowest().value_or(0);
    one.judged = many.value;
    for (const JudgementOfMany::Found& of : many.reasons) take_reason(of.worst, one);
    for (const RuleOverRecords& rule : needs.gaps[g].rules) {
      if (!std::isnan(rule.asked)) one.asked = std::max(one.asked.value_or(0), rule.asked);
    }
    for (const SuiteRecordRun& record : run.records) {
      one.others_close = one.others_close || (!record.judged.empty() && record.judged.at(g).judgement.alone);
    }
    found.gaps.push_back(std::move(one));
  }
  for (Statement& one : suite_story(run, study).statements) {
    const bool is_of_code = one.kind.starts_with("suite_takes") || one.kind.starts_with("suite_too_few") ||
                            one.kind.starts_with("suite_gap") || one.kind.starts_with("records_rules");
    if (one.gap && is_of_code) found.of_codes.push_back(std::move(one));
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
    const bool is_known = one.is_facing && one.is_known;
    const auto number = [&](double value) { return is_known ? Json(value) : Json(nullptr); };
    gaps.push_back({{"between", {found.buildings[one.left], found.buildings[one.right]}},
                    {"least_gap", number(one.width)},
                    {"gap_needed", number(one.needed)},
                    {"given", one.is_facing ? Json(one.given) : Json(nullptr)},
                    {"too_narrow", one.is_short ? Json(true)
                                   : is_known   ? Json(false)
                                                : Json(nullptr)},
                    {"others_close", one.others_close},
                    {"judgement", one.is_facing ? Json(word_of(one.judged)) : Json(nullptr)}});
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
