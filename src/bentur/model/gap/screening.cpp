#include "bentur/model/gap/screening.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>

#include "bentur/model/gap/levels.h"
#include "bentur/pounding/problem.h"

namespace bentur {
namespace {

using Verdict = ScreeningFinding::Verdict;

constexpr double inch = 0.0254;                                                  // [m]
constexpr std::array<double, 5> inches_per_storey = {0.5, 0.5, 1, 1.5, 2};       // (4), from low to very high
constexpr std::array<double, 5> percent_of_height = {0.25, 0.5, 1.5, 1.5, 1.5};  // (6)
constexpr double most_apart = 24 * inch;                                         // (1) [m]
constexpr double storeys_apart = 2;                                              // (2)
constexpr double most_mass_ratio = 2;                                            // (7)
constexpr double most_eccentricity = 20;                                         // (8) [%]

StandingBuilding standing(const StructuralModel& model, bool is_backed) {
  StandingBuilding result;
  result.floors.assign(model.elevations.begin() + model.first_storey(), model.elevations.end());
  result.height = std::accumulate(model.storey_heights.begin(), model.storey_heights.end(), 0.0);
  result.mass = std::accumulate(model.floor_masses.begin(), model.floor_masses.end(), 0.0);
  result.is_backed = is_backed;
  return result;
}

double to_nearest(double elevation, const std::vector<double>& floors) {
  double nearest = std::numeric_limits<double>::infinity();
  for (const double floor : floors) nearest = std::min(nearest, std::abs(floor - elevation));
  return nearest;
}

/// The largest distance from a floor up to the lower roof to the nearest floor of the neighbour [length].
double floors_apart(const StandingBuilding& a, const StandingBuilding& b) {
  const double roof = std::min(a.floors.back(), b.floors.back());
  double most = 0;
  for (const auto& [own, other] : {std::pair(&a, &b), std::pair(&b, &a)}) {
    for (const double floor : own->floors) {
      if (floor <= roof * (1 + 1e-9)) most = std::max(most, to_nearest(floor, other->floors));
    }
  }
  return most;
}

double narrowest(const Problem& problem, Eigen::Index gap) {
  double width = std::numeric_limits<double>::infinity();
  const Gap between = gap_at(problem, gap);
  for (const Eigen::Index i : between.points) width = std::min(width, problem.points[i].width);
  for (const Eigen::Index i : between.watched) width = std::min(width, problem.watched[i].width);
  return width;
}

}  // namespace

const std::vector<std::string>& seismicity_words() {
  static const std::vector<std::string> words = {"low", "moderate", "moderately-high", "high", "very-high"};
  return words;
}

const std::vector<ScreeningRule>& screening_rules() {
  constexpr std::string_view p154 = "FEMA P-154 (2015), adjacency";
  constexpr std::string_view memory = "by memory, check the text";
  static const std::vector<ScreeningRule> rules = {
      {"floors-meet", "floors apart in height", p154, memory, "length"},
      {"storeys-apart", "difference in storeys", p154, memory, ""},
      {"end-of-row", "at the end of a row", p154, memory, "", true},
      {"gap-per-storey", "gap for the storeys", p154, memory, "length"},
      {"pounding", "pounding to be scored", p154, memory, "", true},
      {"gap-per-height", "gap over height", "ASCE 41-17, Tier 1, adjacent buildings", memory, "%"},
      {"mass-ratio", "mass ratio", "no code's", "ours", ""},
      {"eccentricity", "eccentricity over the side", "ASCE 41-17, Tier 1, torsion", memory, "%"},
  };
  return rules;
}

std::string_view verdict_text(Verdict verdict) {
  switch (verdict) {
    case Verdict::fine:
      return "no concern";
    case Verdict::attention:
      return "attention";
    case Verdict::needs_seismicity:
      return "needs screening.seismicity";
    case Verdict::not_applicable:
      break;
  }
  return "does not apply";
}

std::vector<ScreeningFinding> screening(const StandingBuilding& a, const StandingBuilding& b, double width,
                                        const ScreeningSpec& spec, const Units& units) {
  if (a.floors.empty() || b.floors.empty()) return {};
  const double metre = 1 / metres(units.length);  // [length]
  const auto storeys_of = [](const StandingBuilding& one) { return static_cast<double>(one.floors.size()); };
  const StandingBuilding& shorter = a.height <= b.height ? a : b;
  std::vector<ScreeningFinding> findings;
  const auto add = [&](double value, std::optional<double> limit, Verdict verdict) {
    findings.push_back({&screening_rules()[findings.size()], value, limit, verdict});
    return verdict == Verdict::attention;
  };
  const auto attention_if = [](bool is) { return is ? Verdict::attention : Verdict::fine; };

  bool stands_badly = false;
  const double apart = floors_apart(a, b);
  stands_badly |= add(apart, most_apart * metre, attention_if(apart > most_apart * metre));  // (1)
  const double more = std::abs(storeys_of(a) - storeys_of(b));
  stands_badly |= add(more, storeys_apart, attention_if(more >= storeys_apart));  // (2)
  const bool row = a.is_backed || b.is_backed, end = row && !(a.is_backed && b.is_backed);
  stands_badly |= add(end ? 1 : 0, {}, row ? attention_if(end) : Verdict::not_applicable);  // (3)

  if (!std::isfinite(width)) {  // no floors face one another
    for (int i = 0; i < 3; ++i) add(0, {}, Verdict::not_applicable);
  } else if (!spec.seismicity) {
    add(width, {}, Verdict::needs_seismicity);
    add(0, {}, Verdict::needs_seismicity);
    add(100 * width / shorter.height, {}, Verdict::needs_seismicity);
  } else {
    const auto level = static_cast<std::size_t>(*spec.seismicity);
    const double storeys = std::min(storeys_of(a), storeys_of(b));
    const double least = inches_per_storey[level] * inch * metre * storeys;
    const bool narrow = add(width, least, attention_if(width < least));             // (4)
    add(narrow && stands_badly ? 1 : 0, {}, attention_if(narrow && stands_badly));  // (5)
    const double percent = 100 * width / shorter.height;
    add(percent, percent_of_height[level], attention_if(percent < percent_of_height[level]));  // (6)
  }
  const double ratio = std::max(a.mass, b.mass) / std::min(a.mass, b.mass);
  add(ratio, most_mass_ratio, attention_if(ratio >= most_mass_ratio));  // (7)
  // Of one alone that is known only too much can be said.
  const double most = std::max(a.eccentricity.value_or(0), b.eccentricity.value_or(0));
  if (most >= most_eccentricity || (a.eccentricity && b.eccentricity)) {
    add(most, most_eccentricity, attention_if(most >= most_eccentricity));  // (8)
  }
  return findings;
}

std::vector<ScreeningFinding> screening(const Problem& problem, Eigen::Index gap, const ScreeningSpec& spec,
                                        const Units& units) {
  const Building& left = problem.buildings.at(static_cast<std::size_t>(gap));
  const Building& right = problem.buildings.at(static_cast<std::size_t>(gap) + 1);
  if (left.is_rigid() || right.is_rigid()) return {};
  const auto moves = [&](Eigen::Index b) {
    return b >= 0 && b < std::ssize(problem.buildings) && !problem.buildings[b].is_rigid();
  };
  return screening(standing(left.model, moves(gap - 1)), standing(right.model, moves(gap + 2)), narrowest(problem, gap),
                   spec, units);
}

}  // namespace bentur
