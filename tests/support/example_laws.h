#pragma once

#include <map>
#include <memory>
#include <ostream>
#include <string>
#include <vector>

#include "bentur/contact/laws.h"

namespace bentur::test {

/// A law of the registry with parameters to try it with.
struct LawExample {
  std::string label;
  std::string law;
  std::map<std::string, double, std::less<>> numbers;  ///< [N, m, s]
  std::map<std::string, std::string, std::less<>> words;
  bool straight = true;  ///< every branch has a linear force, or takes no time
  /// Order that a scheme of order 4 keeps in contact: where the force sets in like time^n, n not whole, it is n + 1.
  double order = 4;

  [[nodiscard]] std::shared_ptr<const ContactLaw> make(double effective_mass) const {
    return find_law(law)->make({numbers, words, effective_mass});
  }
};

inline void PrintTo(const LawExample& example, std::ostream* out) { *out << example.label; }

/// Every law, in every way that it can be told to let go; for floors of 1e5 to 1e6 kg.
inline std::vector<LawExample> example_laws() {
  const double k = 1e8, beta = 2e9;  // N/m, N/m^1.5
  return {
      {"linear", "linear", {{"stiffness", k}}, {}},
      {"kelvin_voigt_zero_force", "kelvin-voigt", {{"stiffness", k}, {"restitution", 0.65}}, {}},
      {"kelvin_voigt_overdamped", "kelvin-voigt", {{"stiffness", k}, {"damping_ratio", 1.4}}, {}},
      {"kelvin_voigt_separation",
       "kelvin-voigt",
       {{"stiffness", k}, {"restitution", 0.65}},
       {{"release", "separation"}}},
      {"kelvin_voigt_creep", "kelvin-voigt", {{"stiffness", k}, {"restitution", 0.4}}, {{"release", "creep"}}},
      {"kelvin_voigt_approach", "kelvin-voigt-approach", {{"stiffness", k}, {"restitution", 0.65}}, {}},
      {"darmawan", "darmawan", {{"stiffness", k}, {"alpha", 1.5}}, {}, false},
      {"hertz", "hertz", {{"stiffness", beta}}, {}, false, 2.5},
      {"hertz_damp", "hertz-damp", {{"stiffness", beta}, {"restitution", 0.65}}, {}, false, 2.5},
      {"jankowski", "jankowski", {{"stiffness", beta}, {"restitution", 0.65}}, {}, false, 1.25},
      {"bilinear", "bilinear", {{"stiffness", k}, {"second_stiffness", 0.3 * k}, {"yield_penetration", 2e-3}}, {}},
      {"filler",
       "filler",
       {{"crushing_force", 0.01 * k * 0.03},
        {"thickness", 0.03},
        {"crushing_strain", 0.02},
        {"locking_strain", 0.3},
        {"locked_stiffness", k}},
       {}},
      {"restitution", "restitution", {{"restitution", 0.65}}, {}},
  };
}

}  // namespace bentur::test
