#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <random>
#include <variant>
#include <vector>

#include "bentur/model/case.h"

namespace bentur::test {

/// Numbers by chance.
class Chance {
 public:
  explicit Chance(std::uint64_t seed) : random_(seed) {}

 protected:
  double uniform(double low, double high) { return std::uniform_real_distribution<double>(low, high)(random_); }
  double logarithmic(double low, double high) { return std::exp(uniform(std::log(low), std::log(high))); }
  bool chance(double p) { return uniform(0, 1) < p; }
  int among(int low, int high) { return std::uniform_int_distribution<int>(low, high)(random_); }

 private:
  std::mt19937_64 random_;
};

/// Draws buildings of one to three floors, at heights that all of them have: sticks, matrices and frames with every
/// kind of damping [m, N, s].
class BuildingGenerator : protected Chance {
 public:
  explicit BuildingGenerator(std::uint64_t seed) : Chance(seed) {
    for (double& height : heights_) height = uniform(2.8, 3.8);
  }

 protected:
  static std::size_t floors(const BuildingSpec& building) {
    if (const auto* frame = std::get_if<PlaneFrame>(&building.structure)) return frame->storey_heights.size();
    if (const auto* stick = std::get_if<Stick>(&building.structure)) return stick->masses.size();
    return std::get<MatricesSpec>(building.structure).elevations.size();
  }

  BuildingSpec building() {
    const int storeys = among(1, 3);
    const std::vector<double> heights(heights_.begin(), heights_.begin() + storeys);
    BuildingSpec spec;
    const double kind = uniform(0, 1);
    if (kind < 0.5) {
      spec.structure = stick(heights);
      spec.damping = proportional(storeys);
    } else if (kind < 0.75) {
      const MatricesSpec matrices = matrices_of(stick(heights));
      spec.damping = chance(0.5) ? Damping(dashpots(matrices.stiffness)) : proportional(storeys);
      spec.structure = matrices;
    } else {
      const PlaneFrame plane = frame(heights);
      spec.damping = proportional(plane.condensation == Condensation::none ? 1 : storeys);
      spec.structure = plane;
    }
    return spec;
  }

  Stick stick(const std::vector<double>& heights) {
    Stick result{heights, {}, {}};
    const double mass = logarithmic(1e4, 1e5);
    const double omega = 2 * std::numbers::pi / logarithmic(0.08, 1.2);
    const double factor = 1.6 * static_cast<double>(heights.size() * heights.size());  // storeys in series
    for (std::size_t f = 0; f < heights.size(); ++f) {
      result.masses.push_back(mass * uniform(0.6, 1.2));
      result.stiffnesses.push_back(mass * omega * omega * std::max(1.0, factor / 2) * uniform(0.6, 1.2));
    }
    return result;
  }

  MatricesSpec matrices_of(const Stick& stick) {
    const auto n = static_cast<Eigen::Index>(stick.masses.size());
    MatricesSpec result{{}, Eigen::MatrixXd::Zero(n, n), Eigen::MatrixXd::Zero(n, n)};
    double elevation = 0;
    for (Eigen::Index f = 0; f < n; ++f) {
      const auto storey = static_cast<std::size_t>(f);
      elevation += stick.storey_heights[storey];
      result.elevations.push_back(elevation);
      result.mass(f, f) = stick.masses[storey];
      result.stiffness(f, f) += stick.stiffnesses[storey];
      if (f == 0) continue;
      result.stiffness(f - 1, f - 1) += stick.stiffnesses[storey];
      result.stiffness(f - 1, f) = result.stiffness(f, f - 1) = -stick.stiffnesses[storey];
      result.mass(f - 1, f) = result.mass(f, f - 1) = 0.08 * stick.masses[storey];
    }
    return result;
  }

  PlaneFrame frame(const std::vector<double>& heights) {
    PlaneFrame result;
    result.elastic_modulus = 3e10;
    result.storey_heights = heights;
    for (int bay = among(1, 2); bay > 0; --bay) result.bay_widths.push_back(uniform(3.5, 6));
    const double side = uniform(0.25, 0.5), beam = uniform(0.3, 0.6);
    result.columns = {section(side, side, heights[0])};
    result.columns.resize(heights.size(), result.columns[0]);
    result.beams = {section(0.6 * beam, beam, result.bay_widths[0])};
    result.beams.resize(heights.size(), result.beams[0]);
    const double mass = logarithmic(1e4, 8e4);
    for (std::size_t f = 0; f < heights.size(); ++f) result.floor_masses.push_back(mass * uniform(0.8, 1.2));
    result.mass_matrix = chance(0.5) ? MassMatrix::lumped : MassMatrix::consistent;
    const double reduced = uniform(0, 1);
    result.condensation = reduced < 0.6   ? Condensation::static_
                          : reduced < 0.8 ? Condensation::dynamic
                                          : Condensation::none;
    return result;
  }

  static Section section(double width, double depth, double length) {
    return {width * depth, width * depth * depth * depth / 12, 2400 * width * depth * length};
  }

  Damping proportional(int modes) {
    const double ratio = chance(0.1) ? 0 : uniform(0.01, 0.12);
    switch (among(0, 3)) {
      case 0:
        return ModalDamping{{ratio}};
      case 1: {
        ModalDamping damping;
        for (int mode = 0; mode < modes; ++mode) damping.ratios.push_back(ratio * uniform(0.5, 1));
        return damping;
      }
      case 2:
        return RayleighDamping{{ratio, ratio}, {uniform(0.3, 1), uniform(0.02, 0.2)}};
      default:
        return MassProportionalDamping{ratio};
    }
  }

  /// Of all storeys, and one more at the lowest floor: modes do not make such a matrix diagonal.
  MatrixDamping dashpots(const Eigen::MatrixXd& stiffness) {
    Eigen::MatrixXd c = uniform(0.0005, 0.004) * stiffness;
    c(0, 0) *= uniform(1, 3);
    return {c};
  }

  std::array<double, 3> heights_{};
};

}  // namespace bentur::test
