#include "bentur/contact/restitution_relations.h"

#include <gtest/gtest.h>

#include <boost/math/quadrature/tanh_sinh.hpp>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <string_view>
#include <vector>

#include "bentur/core/errors.h"

namespace bentur {
namespace {

using Function = std::function<double(double)>;

struct Relation {
  const char* name = "";
  Function restitution, inverse;
};

const std::vector<Relation>& relations() {
  static const std::vector<Relation> list = {
      {"damping factor", damping_factor_restitution, exact_damping_factor},
      {"approach, force ~ depth", [](double x) { return approach_restitution(x, 1); },
       [](double e) { return exact_approach_damping_ratio(e, 1); }},
      {"approach, force ~ depth^1.5", [](double x) { return approach_restitution(x, 1.5); },
       [](double e) { return exact_approach_damping_ratio(e, 1.5); }},
      {"zero force", zero_force_restitution, exact_zero_force_damping_ratio},
      {"separation", separation_restitution, exact_separation_damping_ratio},
  };
  return list;
}

TEST(RestitutionRelations, InvertEachOtherToRoundOff) {
  for (const Relation& relation : relations()) {
    for (const double e : {1e-100, 1e-12, 1e-3, 0.1, 0.2, 0.3, 1 / std::numbers::e, 0.4, 0.5, 0.65, 0.8, 0.9, 0.99,
                           1 - 1e-6, 1 - 1e-10, 1 - 1e-15, 1.0}) {
      // A separation at e < 1e-8 or so has ξ so near 1 that neighbouring doubles differ in e.
      if (relation.name == std::string_view("separation") && e < 0.01) continue;
      const double again = relation.restitution(relation.inverse(e));
      // e = exp(−x): an error of some 2⁻⁵² in x, whose size is |ln e|, is one of 2⁻⁵² |ln e| in e.
      const double room = 8 * std::numeric_limits<double>::epsilon() * (1 - std::log(e));
      EXPECT_NEAR(again / e, 1, room) << relation.name << ", e = " << e;
    }
  }
}

TEST(RestitutionRelations, NoDampingReturnsAllAndMoreDampingLess) {
  for (const Relation& relation : relations()) {
    EXPECT_EQ(relation.restitution(0), 1) << relation.name;
    EXPECT_EQ(relation.inverse(1), 0) << relation.name;
    EXPECT_FALSE(std::signbit(relation.inverse(1))) << relation.name;
    double before = 1;
    for (double x = 1e-3; x < 0.999; x *= 1.05) {
      const double e = relation.restitution(x);
      EXPECT_LT(e, before) << relation.name << " at " << x;
      before = e;
    }
  }
}

TEST(RestitutionRelations, GoOnBeyondCriticalDamping) {
  // (C-10) has one value and one slope on either side of z = 1: A(1 ± h) = 1 ∓ h/3, so ln e = −(1 ± 2h/3) to O(h²).
  for (const double h : {1e-4, 1e-6, 1e-12, 0.0}) {
    EXPECT_NEAR(std::log(approach_restitution(1 + h, 1)), -(1 + 2 * h / 3), h * h + 4e-16);
    EXPECT_NEAR(std::log(approach_restitution(1 - h, 1)), -(1 - 2 * h / 3), h * h + 4e-16);
  }
  EXPECT_DOUBLE_EQ(zero_force_restitution(1), std::exp(-2));
  // For ξ → ∞ arcosh ξ → ln 2ξ: e → 1/(2z) and 1/(4ξ²).
  EXPECT_NEAR(approach_restitution(1e9, 1) * 2e9, 1, 1e-14);
  EXPECT_NEAR(zero_force_restitution(1e6) * 4e12, 1, 2e-11);  // next term: ln(2ξ)/ξ²
}

TEST(RestitutionRelations, DampingFactorIsTheRootOfItsEquation) {
  for (const double e : {0.2, 0.5, 0.65, 0.9}) {
    const double d = exact_damping_factor(e);
    EXPECT_NEAR(d * (1 + e), std::log((1 + d) / (1 - d * e)), 1e-14);
  }
  // Near e = 1: d = 3/2 (1 − e²)/(1 + e³) + O((1 − e)²), which is 3/2 (1 − e) there.
  EXPECT_NEAR(exact_damping_factor(1 - 1e-7) / 1.5e-7, 1, 1e-6);
  // And for e → 0 d e → 1: a damper so strong that the bodies part at the speed where it takes all the push.
  EXPECT_DOUBLE_EQ(exact_damping_factor(1e-3), 1e3);
}

TEST(RestitutionRelations, DampingFactorByEnergy) {
  // Straight from the phase plane (C-5): ∫ w dw/(1 + d w) from 0 to 1 equals that from 0 to −e.
  boost::math::quadrature::tanh_sinh<double> integral;
  for (const double e : {0.2, 0.65, 0.9}) {
    const double d = exact_damping_factor(e);
    const auto phase = [&](double w) { return w / (1 + d * w); };
    EXPECT_NEAR(integral.integrate(phase, 0.0, 1.0), -integral.integrate(phase, -e, 0.0), 1e-13);
  }
}

TEST(RestitutionRelations, TheMonographs) {
  // (3.11): ψ = π − arccos(1 − 2ξ²) is 2 arccos ξ.
  for (const double x : {0.01, 0.1, 0.3, 0.7, 0.99}) {
    const double psi = std::numbers::pi - std::acos(1 - 2 * x * x);
    EXPECT_NEAR(zero_force_restitution(x), std::exp(-x * psi / std::sqrt(1 - x * x)), 1e-14);
  }
}

// The table of theory/contact.md: what the published formulas give, asked for 0.65.
TEST(RestitutionRelations, PublishedFormulasMiss) {
  const double e = 0.65;
  namespace p = published;
  const double digit = 5e-4;  // the table has three
  EXPECT_NEAR(damping_factor_restitution(p::muthukumar_desroches_damping_factor(e)), 0.775, digit);
  EXPECT_NEAR(damping_factor_restitution(1.5 * (1 - e)), 0.739, digit);  // (C-21), which no law offers
  EXPECT_NEAR(damping_factor_restitution(p::ye_damping_factor(e)), 0.630, digit);
  EXPECT_NEAR(approach_restitution(p::jankowski_damping_ratio(e), 1.5), 0.647, digit);
  EXPECT_NEAR(zero_force_restitution(p::anagnostopoulos_damping_ratio(e)), 0.675, digit);
  EXPECT_EQ(p::anagnostopoulos_damping_ratio(e), exact_separation_damping_ratio(e));
  EXPECT_NEAR(approach_restitution(p::mahmoud_jankowski_damping_ratio(e), 1), 0.654, digit);
  // No damping is no damping in each.
  for (const Function& formula : {Function(p::anagnostopoulos_damping_ratio),
                                  Function(p::mahmoud_jankowski_damping_ratio), Function(p::jankowski_damping_ratio),
                                  Function(p::muthukumar_desroches_damping_factor), Function(p::ye_damping_factor)}) {
    EXPECT_EQ(formula(1), 0);
    EXPECT_THROW(formula(0), InvalidParameter);
  }
}

TEST(RestitutionRelations, RefuseWhatMakesNoSense) {
  const double nan = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();
  for (const Relation& relation : relations()) {
    for (const double bad : {0.0, -0.5, 1.0000001, nan, infinity, 1e-151}) {
      EXPECT_THROW(relation.inverse(bad), InvalidParameter) << relation.name << " " << bad;
    }
    for (const double bad : {-1e-9, nan, infinity}) {
      EXPECT_THROW(relation.restitution(bad), InvalidParameter) << relation.name << " " << bad;
    }
  }
  EXPECT_THROW(static_cast<void>(separation_restitution(1)), InvalidParameter);
  try {
    static_cast<void>(exact_damping_factor(1.4));
    FAIL() << "1.4 was taken";
  } catch (const InvalidParameter& error) {
    EXPECT_STREQ(error.what(), "restitution = 1.4, must be in (0, 1]");
    EXPECT_EQ(error.parameter(), "restitution");
  }
}

}  // namespace
}  // namespace bentur
