#include <algorithm>
#include <cmath>
#include <vector>

#include "bentur/study/remedy/internal/linear_program.h"
#include "bentur/study/remedy/optimiser.h"

namespace bentur {
namespace {

using Places = std::vector<double>;

constexpr double first_box = 0.1, least_box = 1e-4;  // half a side, of u
constexpr double most_box = 0.5;
constexpr double least_gain = 1e-5;     // of what is to become small, that another step must promise
constexpr double price_of_excess = 10;  // of a limit, for each part of it: more than a whole range
constexpr double below_limit = 1e-5;    // where a limit is aimed at, as part of it

/// A part of the function, as it was seen.
struct Seen {
  Places at;
  FunctionPart part;

  [[nodiscard]] double foretold(const Places& u) const {
    double value = part.value;
    for (std::size_t i = 0; i < u.size(); ++i) value += part.slope[i] * (u[i] - at[i]);
    return value;
  }
};

class Bundle {
 public:
  explicit Bundle(const Descent& what) : what_(what), is_limited_(what.nearest.has_value()) {}

  bool run() {
    at_ = what_.start;
    if (!look(at_)) return false;
    value_ = what_.function(at_);
    scale_ = is_limited_ ? what_.nearest->limit : value_;
    if (!(scale_ > 0) || !std::isfinite(scale_)) return false;
    for (std::size_t tries = 0; tries < what_.evaluations && box_ >= least_box; ++tries) {
      const Places next = proposed();
      const double promised = merit(at_, value_) - foretold_merit(next);
      if (!(promised > least_gain)) {
        box_ /= 4;  // what was seen further off goes out of the bundle
        continue;
      }
      const double value = what_.function(next);
      const double gained = merit(at_, value_) - merit(next, value);
      const bool is_known = look(next);
      if (gained > 0.1 * promised) {
        if (gained > 0.5 * promised && farthest(next, at_) > 0.9 * box_) box_ = std::min(2 * box_, most_box);
        at_ = next;
        value_ = value;
      } else {
        box_ = std::min(box_, farthest(next, at_)) / (is_known ? 2 : 4);
      }
    }
    return true;
  }

 private:
  bool look(const Places& u) {
    const std::vector<FunctionPart> parts = what_.parts(u);
    for (const FunctionPart& part : parts) seen_.push_back({u, part});
    return !parts.empty();
  }
  [[nodiscard]] double excess(double value) const { return std::max(0.0, value / scale_ - (1 - below_limit)); }
  [[nodiscard]] double way_home(const Places& u) const {
    double sum = 0;
    for (std::size_t i = 0; i < u.size(); ++i) sum += std::abs(u[i] - what_.nearest->home[i]);
    return sum / static_cast<double>(u.size());
  }
  /// What is to become small.
  [[nodiscard]] double merit(const Places& u, double value) const {
    return is_limited_ ? way_home(u) + price_of_excess * excess(value) : value / scale_;
  }
  /// How much lower a part seen elsewhere is taken than it foretells: one that is above the function here is no part of
  /// it any more.
  [[nodiscard]] double lowered(const Seen& one) const {
    const double here = one.foretold(at_);
    return here > value_ ? 2 * (here - value_) : 0;
  }
  [[nodiscard]] bool counts(const Seen& one) const { return farthest(one.at, at_) <= 2 * box_; }
  [[nodiscard]] double foretold_merit(const Places& u) const {
    double value = 0;
    for (const Seen& one : seen_) {
      if (counts(one)) value = std::max(value, one.foretold(u) - lowered(one));
    }
    return merit(u, value);
  }

  /// Where the bundle is least within the box: of the numbers u₁ … uₙ, t and with a limit the ways home s₁ … sₙ.
  [[nodiscard]] Places proposed() const {
    const std::size_t n = at_.size(), size = is_limited_ ? 2 * n + 1 : n + 1;
    LinearProgram program{std::vector<double>(size, 0.0),
                          std::vector<double>(size, 0.0),
                          std::vector<double>(size, 2.0),
                          std::vector<double>(size, 0.0),
                          {}};
    for (std::size_t i = 0; i < n; ++i) {
      program.low[i] = std::max(0.0, at_[i] - box_);
      program.high[i] = std::min(1.0, at_[i] + box_);
      program.start[i] = at_[i];
    }
    program.cost[n] = is_limited_ ? price_of_excess : 1;
    program.high[n] = 1e3;
    program.start[n] = is_limited_ ? excess(value_) : value_ / scale_;
    for (const Seen& one : seen_) {
      if (!counts(one)) continue;
      LinearProgram::Row row{std::vector<double>(size, 0.0), 0};
      row.bound = (lowered(one) - one.foretold(Places(n, 0.0))) / scale_ + (is_limited_ ? 1 - below_limit : 0);
      for (std::size_t i = 0; i < n; ++i) row.of[i] = one.part.slope[i] / scale_;
      row.of[n] = -1;
      program.rows.push_back(std::move(row));
    }
    for (std::size_t i = 0; is_limited_ && i < n; ++i) {
      program.cost[n + 1 + i] = 1 / static_cast<double>(n);
      program.start[n + 1 + i] = std::abs(at_[i] - what_.nearest->home[i]);
      for (const double sign : {1.0, -1.0}) {
        LinearProgram::Row row{std::vector<double>(size, 0.0), sign * what_.nearest->home[i]};
        row.of[i] = sign;
        row.of[n + 1 + i] = -1;
        program.rows.push_back(std::move(row));
      }
    }
    const std::vector<double> least = minimum(program);
    return {least.begin(), least.begin() + static_cast<std::ptrdiff_t>(n)};
  }

  const Descent& what_;
  double scale_ = 1;  // of the function
  bool is_limited_;
  Places at_;
  double value_ = 0;
  double box_ = first_box;
  std::vector<Seen> seen_;
};

}  // namespace

double farthest(const Places& a, const Places& b) {
  double most = 0;
  for (std::size_t i = 0; i < a.size(); ++i) most = std::max(most, std::abs(a[i] - b[i]));
  return most;
}

bool search_by_slopes(const Descent& what) { return Bundle(what).run(); }

}  // namespace bentur
