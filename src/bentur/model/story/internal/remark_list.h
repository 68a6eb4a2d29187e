#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "bentur/model/story/remarks.h"

// What is usual, and the list of what is not, of rows and plans alike.
namespace bentur::remarking {

/// How far beyond the usual a value is no longer believed: an order of magnitude is how units are mistaken.
inline constexpr double far = 10;

/// Usual, and from where on it is remarked on: a factor apart, so that the unusual is not nagged at.
struct Range {
  double usual_from, usual_to, least, most;
  double doubted = 0;  ///< so many times beyond the usual it is in doubt; 0: it never is

  [[nodiscard]] bool doubts(double value) const {
    return doubted > 0 && (value < usual_from / doubted || value > usual_to * doubted);
  }
};

inline constexpr Range period_range = {0.05, 0.2, 0.02, 0.6, far};      // [s] per storey
inline constexpr Range modulus_range = {1e10, 2.1e11, 5e8, 3e11, far};  // [N/m²]: timber, concrete, steel
inline constexpr Range section_range = {0.2, 2.0, 0.04, 4.0};           // [m]
inline constexpr Range height_range = {2.5, 6.0, 0.5, 15.0, far};       // [m]
inline constexpr Range stiffness_range = {1e7, 1e10, 1e5, 1e11,
                                          far};  // [N/m] of contact: by beams over half a bay, or tests
inline constexpr Range density_range = {500.0, 8000.0, 300.0, 12000.0, 1.5};  // [kg/m³]: timber, concrete, steel
inline constexpr Range damping_range = {0.01, 0.07, 0.0, 0.2};                // [-]
inline constexpr Range pga_range = {0.05, 1.0, 0.05, 2.5, far};               // [g]
inline constexpr Range length_range = {5.0, 600.0, 5.0, 600.0, far};          // [s] of a record
inline constexpr double most_step = 0.1;                                      // [s] of a record
inline constexpr double usual_step = 0.05;                                    // [s]
inline constexpr Range factor_range = {0.3, 3.0, 0.3, 3.0};                   // [-] of stiffness, to reach a period
inline constexpr Range weight_range = {5e3, 1e7, 500.0, 2e8, far};            // [N] of a floor
inline constexpr double most_gap = 2.0;                                       // [m]
inline constexpr double usual_gap = 0.5;                                      // [m]
inline constexpr double most_drift = 1.0;                                     // [%]
inline constexpr double most_base_shear = 0.4;                                // [-]
inline constexpr double most_penetration = 0.05;                              // [m]
inline constexpr double usual_penetration = 0.02;                             // [m]
inline constexpr double least_share = 0.9;             // [-] of a floor's mass that known modes move
inline constexpr double most_weight_per_width = 1e7;   // [N/m] of a floor
inline constexpr double usual_weight_per_width = 1e6;  // [N/m]
inline constexpr double usual_beam_depth = 0.6;        // [m] where it is not known
inline constexpr double share_of_blow = 0.1;           // [-] of its energy, that makes a mode matter
inline constexpr double most_push = 0.1;               // [-] of a first period: longer is no blow
inline constexpr double usual_push = 0.05;             // [-]
inline constexpr double samples_per_period = 4.0;      // fewer draw no curve
inline constexpr double usual_samples = 20.0;

inline double two_digits(double x) {
  if (!(x > 0) || !std::isfinite(x)) return x;
  const double unit = std::pow(10.0, std::floor(std::log10(x)) - 1);
  return std::round(x / unit) * unit;
}

/// Remarks with their usual ranges in the units of a case.
class List {
 public:
  explicit List(const Units& units) : length_(units.length), metre_(1 / metres(units.length)) {}

  /// A value outside a range in `factor` units of the case.
  void check(const char* key, const std::string& subject, double value, const std::string& unit, const Range& range,
             double factor = 1) {
    if (value >= range.least * factor && value <= range.most * factor) return;
    add({key, subject, value, unit, two_digits(range.usual_from * factor), two_digits(range.usual_to * factor),
         range.doubts(value / factor)});
  }
  /// @param doubted beyond that it is in doubt
  void most(const char* key, const std::string& subject, double value, const std::string& unit, double limit,
            double usual, double doubted = std::numeric_limits<double>::infinity()) {
    if (value > limit) add({key, subject, value, unit, std::nullopt, two_digits(usual), value > doubted});
  }
  void add(Remark remark) {
    // One of a kind and subject: the farther out.
    const auto same = std::find_if(all_.begin(), all_.end(), [&](const Remark& other) {
      return other.key == remark.key && other.subject == remark.subject;
    });
    if (same == all_.end()) {
      all_.push_back(std::move(remark));
    } else if (distance(remark) > distance(*same)) {
      *same = std::move(remark);
    }
  }
  [[nodiscard]] double metre() const { return metre_; }  ///< in the case's length
  [[nodiscard]] const std::string& length() const { return length_; }
  [[nodiscard]] std::vector<Remark> take() { return std::move(all_); }

 private:
  static double distance(const Remark& remark) {
    // Where nothing at all is usual, by its size.
    const double over = !remark.usual_to ? 0 : *remark.usual_to > 0 ? remark.value / *remark.usual_to : remark.value;
    const double under = remark.usual_from && remark.value > 0 ? *remark.usual_from / remark.value : 0;
    return std::max(over, under);
  }

  std::string length_;
  double metre_;
  std::vector<Remark> all_;
};

}  // namespace bentur::remarking
