#include "bentur/model/gap/minimum_gap.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <numbers>
#include <numeric>
#include <string>

#include "bentur/core/errors.h"
#include "bentur/model/gap/gap_outcome.h"

namespace bentur {
namespace {

SeparationInput separation_input(const Building& building, double displacement) {
  if (building.given) return {displacement, building.given->period.value_or(1), building.given->damping_ratio};
  if (building.is_rigid()) return {.displacement = 0, .period = 1, .damping_ratio = 0};  // whatever its period
  const double omega = building.first_omega();
  return {.displacement = displacement,
          .period = 2 * std::numbers::pi / omega,
          .damping_ratio = building.modal_damping(0, 0) / (2 * omega)};
}

double height_of(const StructuralModel& model) {
  return std::accumulate(model.storey_heights.begin(), model.storey_heights.end(), 0.0);
}

/// Of buildings read back from results, or known by their peaks alone, it is not.
bool first_mode_known(const Building& building) {
  if (building.given) return building.given->period.has_value();
  return building.is_rigid() || building.modal_damping.size() > 0;
}

}  // namespace

bool is_linked(const Problem& problem, Eigen::Index gap) {
  const GapPair sides = sides_of(problem, gap);
  const auto ties = [&](const Link& link) {
    const auto of_gap = [&](Eigen::Index b) { return b == sides.left || b == sides.right; };
    return of_gap(link.left) || of_gap(link.right);
  };
  return std::any_of(problem.links.begin(), problem.links.end(), ties);
}

bool is_known_by_peaks(const Problem& problem, Eigen::Index gap) {
  const GapPair sides = sides_of(problem, gap);
  return problem.buildings[sides.left].given || problem.buildings[sides.right].given;
}

CodePair code_pair(const Problem& problem, const FacingLevel& level, const CodeSpec& code, const Units& units) {
  const GapPair sides = sides_of(problem, level.gap);
  const Building &left = problem.buildings[sides.left], &right = problem.buildings[sides.right];
  const auto side = [&](int of, const Building& building) {
    return CodeSide{
        .level = face_height(problem, level, of),
        .height = height_of(building.model),
        .storeys = static_cast<int>(std::ssize(building.model.storey_heights) - building.model.first_storey()),
        .is_isolated = building.model.slab.has_value()};
  };
  return {.left = side(0, left),
          .right = side(1, right),
          .left_building = static_cast<std::size_t>(sides.left),
          .right_building = static_cast<std::size_t>(sides.right),
          .floors_aligned = code.is_aligned(static_cast<std::size_t>(level.gap)),
          .boundary = code.boundary_at(static_cast<std::size_t>(level.gap)),
          .metre = 1 / metres(units.length)};
}

std::vector<LevelSeparation> separations(const Problem& problem,
                                         const std::function<LevelPeaks(const FacingLevel&)>& peaks_at,
                                         const CodeSpec& code, const Units& units) {
  std::vector<LevelSeparation> result;
  for (const FacingLevel& level : facing_levels(problem)) {
    const GapPair sides = sides_of(problem, level.gap);
    const Building &left = problem.buildings[sides.left], &right = problem.buildings[sides.right];
    const LevelPeaks peaks = peaks_at(level);
    const auto ddc = [&] {
      if (!first_mode_known(left) || !first_mode_known(right) || is_linked(problem, level.gap)) return not_known;
      return separation_ddc(separation_input(left, peaks.left), separation_input(right, peaks.right));
    };
    LevelSeparation found{.level = level,
                          .gap_needed = peaks.gap_needed,
                          .gap_needed_reversed = peaks.gap_needed_reversed,
                          .abs = separation_abs({peaks.left}, {peaks.right}),
                          .srss = separation_srss({peaks.left}, {peaks.right}),
                          .ddc = ddc()};
    const bool peaks_known = std::isfinite(peaks.left_of_codes) && std::isfinite(peaks.right_of_codes) &&
                             std::isfinite(peaks.left) && std::isfinite(peaks.right);
    for (const CodeRuleSpec& rule : code.rules) {
      if (!peaks_known) {
        found.codes.push_back({rule.rule, not_known, {}, {}});
        continue;
      }
      const CodeRule* const known = find_code_rule(rule.rule);
      const bool reduced = known != nullptr && known->takes == CodeRule::Takes::reduced;
      CodePair pair = code_pair(problem, level, code, units);
      pair.left.displacement = reduced ? peaks.left_of_codes : peaks.left;
      pair.right.displacement = reduced ? peaks.right_of_codes : peaks.right;
      found.codes.push_back(code_separation(pair, rule));
    }
    result.push_back(std::move(found));
  }
  return result;
}

std::vector<LevelSeparation> separations(const Problem& problem, const Response& response, const CodeSpec& code,
                                         const Units& units) {
  if (response.buildings.size() != problem.buildings.size() || response.points.size() != problem.points.size() ||
      response.watched.size() != problem.watched.size()) {
    throw InvalidParameter("response", std::to_string(response.points.size()) + " points",
                           "must be the response of this problem");
  }
  const auto peaks_of = [&](const FacingLevel& level, const auto& summary) {
    // A floor's is known without having been asked for.
    const GapPair sides = sides_of(problem, level.gap);
    const auto peak = [&](int side, double asked) {
      const auto floor = face_floor(problem, level, side);
      const Eigen::Index building = side == 0 ? sides.left : sides.right;
      const Eigen::VectorXd& floors = response.buildings[building].displacement_no_contact;
      return std::isnan(asked) && floor && *floor < floors.size() ? floors(*floor) : asked;
    };
    const double left = peak(0, summary.peak_left), right = peak(1, summary.peak_right);
    return LevelPeaks{left, right, left, right, summary.gap_needed, summary.gap_needed_reversed};
  };
  const auto peaks_at = [&](const FacingLevel& level) {
    return level.is_point ? peaks_of(level, response.points[level.index])
                          : peaks_of(level, response.watched[level.index]);
  };
  return separations(problem, peaks_at, code, units);
}

std::vector<LevelSeparation> of_gap(const std::vector<LevelSeparation>& all, Eigen::Index gap) {
  std::vector<LevelSeparation> result;
  std::copy_if(all.begin(), all.end(), std::back_inserter(result),
               [&](const LevelSeparation& one) { return one.level.gap == gap; });
  return result;
}

LevelSeparation largest_of(const std::vector<LevelSeparation>& levels) {
  LevelSeparation largest;
  const auto raise = [](double& to, double by) {
    if (by > to || std::isnan(by)) to = by;  // NaN stays
  };
  for (const LevelSeparation& one : levels) {
    const FacingLevel& level = one.level;
    raise(largest.gap_needed, level.of_gap(one.gap_needed));
    if (one.gap_needed_reversed) {
      double reversed = largest.gap_needed_reversed.value_or(0.0);
      raise(reversed, level.of_gap(*one.gap_needed_reversed));
      largest.gap_needed_reversed = reversed;
    }
    raise(largest.abs, level.of_gap(one.abs));
    raise(largest.srss, level.of_gap(one.srss));
    raise(largest.ddc, level.of_gap(one.ddc));
    if (largest.codes.empty()) largest.codes = one.codes;
    for (std::size_t k = 0; k < one.codes.size(); ++k) {
      CodeSeparation& code = largest.codes[k];
      raise(code.gap, level.of_gap(one.codes[k].gap));
      code.to_left = std::max(code.to_left, one.codes[k].to_left);
      code.to_right = std::max(code.to_right, one.codes[k].to_right);
    }
  }
  return largest;
}

std::vector<RuleFinding> rule_findings(const Problem& problem, const std::vector<LevelSeparation>& levels,
                                       const CodeSpec& code, double scale, bool falls, bool in_plan) {
  using Silence = RuleFinding::Silence;
  std::vector<RuleFinding> findings;
  const auto add = [&](std::string_view rule, std::string_view title, const auto& asked) {
    RuleFinding found{.rule = std::string(rule), .title = std::string(title)};
    bool known = true, is_unsaid = false;  // a code's clause does not say what is not known
    const bool at_way =
        !levels.empty() && code.boundary_at(static_cast<std::size_t>(levels.front().level.gap)) == Boundary::public_way;
    double most = -std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < levels.size(); ++i) {
      const LevelSeparation& one = levels[i];
      const double gap = asked(one);
      known = known && std::isfinite(gap);
      is_unsaid = is_unsaid || (!std::isfinite(gap) && std::isfinite(one.abs));
      if (!(gap - one.level.width >= most)) continue;  // of levels that are alike the highest
      most = gap - one.level.width;
      found.at = i;
      found.gap = gap;
    }
    double needed = 0;
    for (const LevelSeparation& one : levels) {
      const double simulated = std::max(one.gap_needed, one.gap_needed_reversed.value_or(0));
      if (!is_known_by_peaks(problem, one.level.gap)) needed = std::max(needed, one.level.of_gap(simulated));
      found.most = std::max(found.most, one.level.of_gap(asked(one)));
    }
    if (known && !falls && is_below_target(found.most, needed, scale)) found.lacks = needed - found.most;
    const bool is_by_peaks = find_code_rule(rule) == nullptr;  // of which those up to a fall are not all
    found.is_short =
        found.at && !(falls && is_by_peaks) && is_below_target(levels[*found.at].level.width, found.gap, scale);
    if (!found.is_short) {
      const bool linked = rule == "ddc" && !levels.empty() && is_linked(problem, levels.front().level.gap);
      const bool turning = rule == "ddc" && in_plan && !known;
      const bool no_period =
          rule == "ddc" && !known && !levels.empty() && is_known_by_peaks(problem, levels.front().level.gap);
      found.silence = levels.empty() ? Silence::no_level
                      : linked       ? Silence::linked
                      : turning      ? Silence::turning
                      : no_period    ? Silence::periods
                      : !known       ? (!is_unsaid ? Silence::unknown
                                        : at_way   ? Silence::public_way
                                                   : Silence::property_line)
                      : falls        ? Silence::collapsed
                                     : Silence::none;
    }
    if (found.silence != Silence::none) found.at.reset();
    findings.push_back(std::move(found));
  };
  add("abs", "ABS", [](const LevelSeparation& s) { return s.abs; });
  add("srss", "SRSS", [](const LevelSeparation& s) { return s.srss; });
  add("ddc", "DDC", [](const LevelSeparation& s) { return s.ddc; });
  for (std::size_t k = 0; k < code.rules.size(); ++k) {
    const CodeRule& rule = *find_code_rule(code.rules[k].rule);
    add(rule.name, rule.title, [k](const LevelSeparation& s) { return s.codes[k].gap; });
    if (!findings.back().at) continue;
    findings.back().to_left = levels[*findings.back().at].codes[k].to_left;
    findings.back().to_right = levels[*findings.back().at].codes[k].to_right;
  }
  return findings;
}

}  // namespace bentur
