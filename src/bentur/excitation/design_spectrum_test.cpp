#include "bentur/excitation/design_spectrum.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "bentur/core/errors.h"

namespace bentur {
namespace {

constexpr double g = 9.80665;

TEST(DesignSpectrum, TwoPeriodsHaveTheirFourBranches) {
  const DesignSpectrum spectrum{TwoPeriodSpectrum{1.0 * g, 0.6 * g, 8.0}};
  const auto at = [&](double period) { return spectral_acceleration(spectrum, period, 0.05) / g; };
  EXPECT_NEAR(at(0.06), 0.7, 1e-12);  // half of T_0 = 0.12 s: 0.4 + 0.3
  EXPECT_NEAR(at(0.3), 1.0, 1e-12);
  EXPECT_NEAR(at(1.0), 0.6, 1e-12);  // S_D1 is the ordinate of one second
  EXPECT_NEAR(at(16.0), 0.6 * 8 / 256, 1e-12);
  for (const double corner : {0.12, 0.6, 8.0}) EXPECT_NEAR(at(corner * (1 - 1e-9)), at(corner * (1 + 1e-9)), 1e-8);
}

TEST(DesignSpectrum, EurocodeHasItsBranchesAndDampingCorrection) {
  const EurocodeSpectrum shape = eurocode_spectrum(1, 'C', 0.25 * g);  // S = 1.15, 0.2, 0.6, 2.0 s
  const DesignSpectrum spectrum{shape};
  const auto at = [&](double period, double ratio = 0.05) {
    return spectral_acceleration(spectrum, period, ratio) / g;
  };
  EXPECT_NEAR(at(1e-9), 0.25 * 1.15, 1e-8);
  EXPECT_NEAR(at(0.1), 0.25 * 1.15 * 1.75, 1e-12);
  EXPECT_NEAR(at(0.4), 0.25 * 1.15 * 2.5, 1e-12);
  EXPECT_NEAR(at(1.2), 0.25 * 1.15 * 2.5 / 2, 1e-12);
  EXPECT_NEAR(at(4.0), 0.25 * 1.15 * 2.5 * 0.6 * 2.0 / 16, 1e-12);
  for (const double corner : {0.2, 0.6, 2.0}) EXPECT_NEAR(at(corner * (1 - 1e-9)), at(corner * (1 + 1e-9)), 1e-8);
  EXPECT_NEAR(damping_correction(0.05), 1, 1e-15);
  EXPECT_NEAR(damping_correction(0.35), 0.55, 1e-15);  // √(10/40) = 0.5 is below the least
  EXPECT_NEAR(at(0.4, 0.1), 0.25 * 1.15 * 2.5 * std::sqrt(10.0 / 15), 1e-12);
  // At T → 0 the ground itself, whatever the damping.
  EXPECT_NEAR(at(1e-9, 0.2), 0.25 * 1.15, 1e-8);
}

TEST(DesignSpectrum, ATableIsMetAtItsEntriesAndStraightBetween) {
  const DesignSpectrum spectrum{TableSpectrum{{0.1, 0.5, 2.0}, {4.0, 8.0, 2.0}}};
  EXPECT_EQ(spectral_acceleration(spectrum, 0.5, 0.05), 8.0);
  EXPECT_NEAR(spectral_acceleration(spectrum, 0.3, 0.05), 6.0, 1e-14);
  EXPECT_NEAR(spectral_acceleration(spectrum, 1.25, 0.05), 5.0, 1e-14);
  EXPECT_EQ(spectral_acceleration(spectrum, 0.01, 0.05), 4.0);
  EXPECT_THROW((void)spectral_acceleration(spectrum, 2.01, 0.05), InvalidParameter);
  const double omega = 2 * std::numbers::pi / 0.5;
  EXPECT_NEAR(spectral_displacement(spectrum, 0.5, 0.05), 8.0 / (omega * omega), 1e-15);
}

TEST(DesignSpectrum, DampingOfItsOwnIsNotCorrected) {
  DesignSpectrum spectrum{TableSpectrum{{0.1, 2.0}, {4.0, 4.0}}, 0.02};
  EXPECT_NEAR(spectral_acceleration(spectrum, 1.0, 0.02), 4.0, 1e-14);
  EXPECT_NEAR(spectral_acceleration(spectrum, 1.0, 0.05), 4.0 / std::sqrt(10.0 / 7), 1e-14);
  spectrum.corrects_damping = false;
  EXPECT_EQ(spectral_acceleration(spectrum, 1.0, 0.3), 4.0);
}

TEST(DesignSpectrum, WhatIsOutOfRangeIsNamed) {
  EXPECT_THROW((void)eurocode_spectrum(3, 'A', 1), InvalidParameter);
  EXPECT_THROW((void)eurocode_spectrum(1, 'F', 1), InvalidParameter);
  EXPECT_THROW(validate({TwoPeriodSpectrum{1, 0.6, 0.5}}), InvalidParameter);
  EXPECT_THROW(validate({EurocodeSpectrum{1, 1, 0.2, 0.1, 2}}), InvalidParameter);
  EXPECT_THROW(validate({TableSpectrum{{0.1, 0.1}, {1, 1}}}), InvalidParameter);
  EXPECT_THROW(validate({TableSpectrum{{}, {}}}), InvalidParameter);
  EXPECT_THROW(validate({TableSpectrum{{1.0}, {1}}, 1.5}), InvalidParameter);
  EXPECT_NO_THROW(validate({TwoPeriodSpectrum{1, 0.6, 8}}));
}

}  // namespace
}  // namespace bentur
