#include "bentur/model/gap/spectral_gap.h"

#include <fmt/format.h>

#include <cmath>
#include <cstddef>
#include <numbers>

#include "bentur/core/number_text.h"
#include "bentur/core/require.h"

namespace bentur {
namespace {

/// The peak of x_left − x_right, rows over the dofs of two buildings [length].
double spectral_difference(const SpectralModes& left, const Eigen::VectorXd& left_row, const SpectralModes& right,
                           const Eigen::VectorXd& right_row, ModalCombination combination) {
  const Eigen::Index of_left = left.omega.size(), of_right = right.omega.size();
  Eigen::VectorXd peaks(of_left + of_right), omega(of_left + of_right), damping(of_left + of_right);
  if (of_left > 0) peaks.head(of_left) = left.motion.transpose() * left_row;
  if (of_right > 0) peaks.tail(of_right) = -(right.motion.transpose() * right_row);
  omega << left.omega, right.omega;
  damping << left.damping, right.damping;
  return combined_peak(peaks, omega, damping, combination);
}

/// The row of one degree of freedom.
Eigen::VectorXd unit_row(const Building& building, Eigen::Index dof) {
  return Eigen::VectorXd::Unit(building.model.dofs(), dof);
}

}  // namespace

SpectralModes spectral_modes(const Building& building, const DesignSpectrum& spectrum) {
  SpectralModes result;
  if (building.is_rigid()) {
    result.motion = Eigen::MatrixXd::Zero(building.model.dofs(), 0);
    return result;
  }
  const Modes& modes = building.modes;
  result.omega = modes.omega;
  result.damping = building.modal_damping.diagonal().cwiseQuotient(2 * modes.omega).cwiseMax(0.0);  // round-off
  result.displacement.resize(modes.omega.size());
  for (Eigen::Index n = 0; n < modes.omega.size(); ++n) {
    result.displacement(n) = spectral_displacement(spectrum, 2 * std::numbers::pi / modes.omega(n), result.damping(n));
  }
  const Eigen::VectorXd participation = modes.shapes.transpose() * building.model.load;
  result.motion = modes.shapes * participation.cwiseProduct(result.displacement).asDiagonal();
  return result;
}

SpectralPeaks spectral_peaks(const Building& building, const SpectralModes& modes) {
  const Eigen::Index floors = building.model.floors();
  SpectralPeaks peaks{Eigen::VectorXd::Zero(floors), Eigen::VectorXd::Zero(floors)};
  for (Eigen::Index floor = 0; floor < floors && modes.omega.size() > 0; ++floor) {
    const Eigen::VectorXd each = modes.motion.row(floor).transpose();
    peaks.srss(floor) = combined_peak(each, modes.omega, modes.damping, ModalCombination::srss);
    peaks.cqc(floor) = combined_peak(each, modes.omega, modes.damping, ModalCombination::cqc);
  }
  return peaks;
}

SpectralGaps spectral_gaps(const Problem& problem, const SpectrumSpec& spectrum, const CodeSpec& code,
                           const Units& units) {
  validate(spectrum.spectrum);
  SpectralGaps gaps;
  std::vector<Eigen::VectorXd> peaks, of_codes;
  if (!spectrum.reduction.empty()) require_size("reduction", spectrum.reduction.size(), problem.buildings.size());
  for (std::size_t b = 0; b < problem.buildings.size(); ++b) {
    const Building& building = problem.buildings[b];
    gaps.modes.push_back(spectral_modes(building, spectrum.spectrum));
    gaps.peaks.push_back(spectral_peaks(building, gaps.modes.back()));
    peaks.push_back(gaps.peaks.back().by(spectrum.combination));
    of_codes.emplace_back(spectrum.reduction.empty() ? peaks.back() : peaks.back() / spectrum.reduction[b]);
  }
  const auto difference = [&](Eigen::Index left, const Eigen::VectorXd& left_row, const Eigen::VectorXd& right_row) {
    return spectral_difference(gaps.modes[left], left_row, gaps.modes[left + 1], right_row, spectrum.combination);
  };
  std::vector<double> differences;
  for (const ContactPoint& point : problem.points) {
    differences.push_back(difference(point.left, unit_row(problem.buildings[point.left], point.left_floor),
                                     unit_row(problem.buildings[point.left + 1], point.right_floor)));
  }
  gaps.points = separations(problem, {.peaks = peaks, .of_codes = of_codes, .needed = differences}, code, units);
  for (const WatchedFloor& floor : problem.watched) {
    gaps.watched.push_back(difference(floor.left, floor.left_row, floor.right_row));
  }
  return gaps;
}

std::optional<GoverningLevel> governing_level(const Problem& problem, const SpectralGaps& spectral, const Gap& gap) {
  return governing_level(
      problem, gap, 0, [&](Eigen::Index i) { return spectral.points.at(i).simulated; },
      [&](Eigen::Index i) { return spectral.watched.at(i); });
}

std::string spectrum_parameters(const SpectrumSpec& spectrum, const Units& units) {
  struct Shape {
    double g;
    std::string operator()(const TwoPeriodSpectrum& shape) const {
      return fmt::format("S_DS {} g, S_D1 {} g, T_L {} s", number(shape.short_period / g), number(shape.one_second / g),
                         number(shape.long_period));
    }
    std::string operator()(const EurocodeSpectrum& shape) const {
      return fmt::format("a_g {} g, S {}, T_B {} s, T_C {} s, T_D {} s", number(shape.ground_acceleration / g),
                         number(shape.soil_factor), number(shape.corner_b), number(shape.corner_c),
                         number(shape.corner_d));
    }
    std::string operator()(const TableSpectrum& shape) const {
      return fmt::format("{} × S_a, T {} … {} s", shape.periods.size(), number(shape.periods.front()),
                         number(shape.periods.back()));
    }
  };
  return std::visit(Shape{units.gravity}, spectrum.spectrum.shape);
}

std::optional<SpectralObstacle> spectral_obstacle(const Case& c) {
  if (!c.links.empty()) {
    return SpectralObstacle{std::nullopt,
                            "ties buildings together, and a spectrum takes each by its own modes: give a record, or "
                            "leave links out"};
  }
  for (std::size_t b = 0; b < c.buildings.size(); ++b) {
    const auto& isolation = c.buildings[b].isolation;
    if (!isolation || (!isolation->pendulum && isolation->bearings.characteristic_strength == 0)) continue;
    return SpectralObstacle{b,
                            "has bearings that yield, whose initial stiffness tells no displacement: for a spectrum "
                            "give stiffness and damping of an equivalent linear bearing, or give a record"};
  }
  return std::nullopt;
}

}  // namespace bentur
