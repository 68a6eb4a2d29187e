// What happens does not depend on how it is described: seen from behind, later, or in other units it is the same.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "bentur/solve/solver.h"
#include "tests/invariance/case_text.h"
#include "tests/invariance/random_case.h"
#include "tests/invariance/transforms.h"

namespace bentur {
namespace {

using namespace bentur::test;

constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr double weak = 1e-3;  // of the hardest impact: weaker ones are known to its errors
constexpr double same = 1e-6;  // relative: what two descriptions of one case may differ by

/// How far two responses are apart, and in what.
struct Difference {
  double size = 0;  ///< relative; infinite where the impacts are not the same ones
  std::string what;
  void note(double a, double b, double scale, const std::string& of) {
    const double apart = std::abs(a - b) / scale;
    if (apart > size || (std::isnan(apart) && size < infinite)) {
      size = std::isnan(apart) ? infinite : apart;
      what = fmt::format("{}: {:.17g} and {:.17g}", of, a, b);
    }
  }
};

std::vector<Impact> impacts_at(const Response& response, int point) {
  std::vector<Impact> list;
  for (const Impact& impact : response.impacts) {
    if (impact.point == point) list.push_back(impact);
  }
  return list;
}

double largest(const Response& response, double Impact::*member) {
  double most = 0;
  for (const Impact& impact : response.impacts) most = std::max(most, impact.*member);
  return most;
}

double largest(const Response& response, Eigen::VectorXd BuildingPeaks::*member) {
  double most = 0;
  for (const BuildingPeaks& peaks : response.buildings) most = std::max(most, (peaks.*member).maxCoeff());
  return most;
}

double farthest_displacement(const Response& response) {
  const double farthest = std::max({std::numeric_limits<double>::min(), largest(response, &BuildingPeaks::displacement),
                                    largest(response, &BuildingPeaks::displacement_no_contact)});
  return farthest;
}

Difference difference(const Response& one, const Response& other, double duration) {
  Difference result;
  if (one.status != Status::done || other.status != Status::done) {
    return {infinite, fmt::format("status {} and {}: {}{}", static_cast<int>(one.status),
                                  static_cast<int>(other.status), one.message, other.message)};
  }
  const double hardest = largest(one, &Impact::impulse);
  const double farthest = farthest_displacement(one);  // gaps needed are differences of such ways
  for (int point = 0; point < static_cast<int>(one.points.size()); ++point) {
    const std::vector<Impact> a = impacts_at(one, point), b = impacts_at(other, point);
    if (a.size() != b.size()) {
      std::size_t i = 0;
      while (i < std::min(a.size(), b.size()) && std::abs(a[i].start - b[i].start) <= same * duration) ++i;
      return {infinite,
              fmt::format("point {}: {} impacts and {}, the first other one at {:.9g} and {:.9g}", point, a.size(),
                          b.size(), i < a.size() ? a[i].start : -1, i < b.size() ? b[i].start : -1)};
    }
    const PointSummary &p = one.points[static_cast<std::size_t>(point)],
                       &q = other.points[static_cast<std::size_t>(point)];
    result.note(p.gap_needed, q.gap_needed, farthest, "gap needed");
    for (std::size_t i = 0; i < a.size(); ++i) {
      const auto of = [&](const char* what) { return fmt::format("point {}, impact {}, {}", point, i, what); };
      result.note(a[i].start, b[i].start, duration, of("start"));
      result.note(a[i].end, b[i].end, duration, of("end"));
      const double length = a[i].end - a[i].start;
      const double weakness = a[i].impulse > 0 ? std::max(1.0, weak * hardest / a[i].impulse) : 1.0;
      if (length > 0) result.note(length, b[i].end - b[i].start, length * weakness, of("duration"));
      const auto of_impact = [&](double Impact::*member, const char* what) {
        const double scale = std::max(a[i].*member, weak * largest(one, member));
        if (scale > 0) result.note(a[i].*member, b[i].*member, scale, of(what));
      };
      of_impact(&Impact::peak_force, "peak force");
      of_impact(&Impact::impulse, "impulse");
    }
  }
  for (std::size_t b = 0; b < one.buildings.size(); ++b) {
    const auto note = [&](Eigen::VectorXd BuildingPeaks::*member, const char* what) {
      const double scale = largest(one, member);
      for (Eigen::Index f = 0; f < (one.buildings[b].*member).size() && scale > 0; ++f) {
        result.note((one.buildings[b].*member)(f), (other.buildings[b].*member)(f), scale,
                    fmt::format("building {}, floor {}, {}", b, f, what));
      }
    };
    note(&BuildingPeaks::displacement, "peak displacement");
    note(&BuildingPeaks::acceleration, "peak acceleration");
    note(&BuildingPeaks::storey_shear, "peak shear");
  }
  for (std::size_t i = 0; i < one.watched.size(); ++i) {
    const WatchedSummary &a = one.watched[i], &b = other.watched[i];
    const double scale = std::max(farthest, std::abs(a.least_opening));
    result.note(a.gap_needed, b.gap_needed, scale, fmt::format("gap needed by watched floor {}", i));
    result.note(a.least_opening, b.least_opening, scale, fmt::format("least opening {}", i));
  }
  return result;
}

/// How far perturbations move a case.
class Movement {
 public:
  Movement(const RandomCase& random_case, const Response& base) : case_(&random_case), base_(&base) {}

  /// As many are tried, those before included, as it takes to move it by `enough`, up to twenty.
  double reach(double enough) {
    for (; tried_ < 20 && most_ < enough; ++tried_) {
      const Response moved = solve(make_problem(perturbed(*case_, tried_, farthest_displacement(*base_))));
      most_ = std::max(most_, difference(*base_, moved, case_->c.analysis.duration).size);
    }
    return most_;
  }

 private:
  const RandomCase* case_;
  const Response* base_;
  unsigned tried_ = 0;
  double most_ = 0;
};

struct Transform {
  std::string name;
  Case c;
  std::function<Response(Response)> back;
};

std::vector<Transform> transforms(const RandomCase& random_case, const Problem& problem, unsigned seed) {
  const Case& c = random_case.c;
  std::vector<Transform> list;
  list.push_back({"mirrored", mirrored(c), [&problem](Response r) { return mirrored_back(std::move(r), problem); }});
  if (random_case.from_rest) {
    if (const auto* sampled = std::get_if<SampledMotion>(&c.excitation.motion); sampled != nullptr && seed % 2 == 0) {
      const int zeros = 1 + static_cast<int>(seed / 2 % 40);
      list.push_back({fmt::format("{} zeros in front", zeros), padded(c, zeros),
                      [by = zeros * sampled->time_step](Response r) { return earlier(std::move(r), by); }});
    } else {
      const double by = seed % 4 == 0 ? 0.5 : 0.013 * (seed % 17 + 1);
      list.push_back(
          {fmt::format("{:.4g} s later", by), delayed(c, by), [by](Response r) { return earlier(std::move(r), by); }});
    }
  }
  const std::array<std::pair<const char*, UnitChange>, 6> units = {{{"cm, kgf", {100, 1 / 9.80665}},
                                                                    {"mm, kN", {1000, 1e-3}},
                                                                    {"in, lbf", {1 / 0.0254, 1 / 4.4482216152605}},
                                                                    {"km, GN", {1e-3, 1e-9}},
                                                                    {"length 2^40, force 2^-30", {0x1p40, 0x1p-30}},
                                                                    {"length 1e-9, force 1e12", {1e-9, 1e12}}}};
  const auto& [name, unit] = units[seed % units.size()];
  list.push_back({name, in_units(c, unit), [u = unit](Response r) { return in_units_back(std::move(r), u); }});
  return list;
}

/// BENTUR_RANDOM_CASES=COUNT or FIRST:COUNT runs others than those that the test always runs.
std::pair<unsigned, unsigned> chosen_cases() {
#ifdef __SANITIZE_ADDRESS__
  std::pair<unsigned, unsigned> range = {1, 60};  // the sanitizers look for other faults, much more slowly
#else
  std::pair<unsigned, unsigned> range = {1, 2000};
#endif
  if (const char* text = std::getenv("BENTUR_RANDOM_CASES")) {
    unsigned first = 1, count = 0;
    if (std::sscanf(text, "%u:%u", &first, &count) == 2) {
      range = {first, count};
    } else {
      range.second = first;
    }
  }
  return range;
}

constexpr unsigned parts = 4;  // run at the same time

class Invariance : public testing::TestWithParam<unsigned> {};

TEST_P(Invariance, OfRandomCasesHoweverTheyAreDescribed) {
  const auto [all_first, all] = chosen_cases();
  const unsigned first = all_first + all * GetParam() / parts;
  const unsigned count = all_first + all * (GetParam() + 1) / parts - first;
  if (count == 0) GTEST_SKIP() << "fewer cases than parts";
  const std::filesystem::path folder = std::filesystem::path(BENTUR_BINARY_DIR) / fmt::format("invariance-{}", first);
  std::filesystem::remove_all(folder);
  long impacts = 0, compared = 0, sensitive = 0, unexplained = 0;
  for (unsigned seed = first; seed < first + count; ++seed) {
    const RandomCase random_case = CaseGenerator(seed).make();
    const double duration = random_case.c.analysis.duration;
    const Problem problem = make_problem(random_case.c);
    const Response base = solve(problem);
    impacts += static_cast<long>(base.impacts.size());
    Movement movement(random_case, base);
    bool is_sensitive = false, is_unexplained = false;
    for (const Transform& transform : transforms(random_case, problem, seed)) {
      const Response other = transform.back(solve(make_problem(transform.c)));
      ++compared;
      const Difference apart = difference(base, other, duration);
      if (base.status == Status::done && apart.size <= same) continue;
      const double moved = base.status == Status::done ? movement.reach(apart.size) : 0;
      if (10 * moved >= apart.size && base.status == Status::done) {
        is_sensitive = true;
        continue;
      }
      is_unexplained = true;
      const std::string name = fmt::format("case-{}", seed);
      write_case(random_case.c, folder, name);
      ADD_FAILURE() << (folder / (name + ".toml")).string() << ", " << transform.name << ": " << apart.what
                    << ", apart by " << apart.size << "; by perturbations " << moved;
    }
    sensitive += is_sensitive && !is_unexplained ? 1 : 0;
    unexplained += is_unexplained ? 1 : 0;
  }
  fmt::print("{} cases, {} impacts, {} comparisons: {} cases sensitive to 1e-12, {} not explained\n", count, impacts,
             compared, sensitive, unexplained);
  EXPECT_GT(impacts, 3 * count);
  EXPECT_LT(sensitive, 0.15 * count + 1);  // of rows that touch, many are
}

INSTANTIATE_TEST_SUITE_P(Parts, Invariance, testing::Range(0U, parts));

}  // namespace
}  // namespace bentur
