#include "bentur/model/gap/spectral_gap.h"

#include <fmt/format.h>

#include <cmath>
#include <cstddef>
#include <numbers>
#include <utility>

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

/// Rows of the left and the right face over the dofs of their buildings.
std::pair<Eigen::VectorXd, Eigen::VectorXd> face_rows(const Problem& problem, const FacingLevel& level) {
  if (!level.is_point) {
    const WatchedFloor& floor = problem.watched[level.index];
    return {floor.left_row, floor.right_row};
  }
  const ContactPoint& point = problem.points[level.index];
  const auto unit = [&](Eigen::Index b, Eigen::Index dof) -> Eigen::VectorXd {
    return Eigen::VectorXd::Unit(problem.buildings[b].model.dofs(), dof);
  };
  return {unit(point.left, point.left_floor), unit(point.right, point.right_floor)};
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
  if (building.given) {
    peaks.srss = peaks.cqc = building.given->amplification * building.given->displacement;
    return peaks;
  }
  for (Eigen::Index floor = 0; floor < floors && modes.omega.size() > 0; ++floor) {
    const Eigen::VectorXd each = modes.motion.row(floor).transpose();
    peaks.srss(floor) = combined_peak(each, modes.omega, modes.damping, ModalCombination::srss);
    peaks.cqc(floor) = combined_peak(each, modes.omega, modes.damping, ModalCombination::cqc);
  }
  return peaks;
}

CapacityDemand capacity_demand(const Building& building, const SpectralModes& modes, ModalCombination combination) {
  CapacityDemand worst;
  if (modes.omega.size() == 0) return worst;
  const StructuralModel& model = building.model;
  const auto peak = [&](const Eigen::VectorXd& row) {
    return combined_peak(modes.motion.transpose() * row, modes.omega, modes.damping, combination);
  };
  const auto take = [&](double ratio, Eigen::Index storey) {
    if (ratio > worst.ratio) worst = {ratio, storey};
  };
  const Eigen::MatrixXd drifts = drift_rows(model);
  for (const BuildingElement& element : building.elements) {
    const double height = model.storey_heights[element.storey] > 0 ? model.storey_heights[element.storey] : 1;
    const double yields = std::min(element.law->yield_deformation(), element.law->yield_deformation_below());
    take(peak(drifts.row(element.storey)) * height / yields, element.storey);
  }
  const Hinges& hinges = model.hinges;
  for (Eigen::Index h = 0; h < hinges.size(); ++h) {
    const double moment = peak(hinges.rows.row(h)), rest = h < hinges.at_rest.size() ? hinges.at_rest(h) : 0;
    const double ratio = std::max((moment + rest) / hinges.clockwise(h), (moment - rest) / hinges.anticlockwise(h));
    const auto place = static_cast<std::size_t>(h);
    const bool is_hinge = place < hinges.places.size();
    const Eigen::Index number =
        is_hinge ? hinges.places[place].level : hinges.columns.at(place - hinges.places.size()).storey;
    take(ratio, model.first_storey() + std::max<Eigen::Index>(number, 1) - 1);
  }
  return worst;
}

SpectralGaps spectral_gaps(const Problem& problem, const SpectrumSpec& spectrum, const CodeSpec& code,
                           const Units& units) {
  if (!spectrum.of_displacements) validate(spectrum.spectrum);
  SpectralGaps gaps;
  if (!spectrum.reduction.empty()) require_size("reduction", spectrum.reduction.size(), problem.buildings.size());
  for (const Building& building : problem.buildings) {
    gaps.modes.push_back(spectral_modes(building, spectrum.spectrum));
    gaps.peaks.push_back(spectral_peaks(building, gaps.modes.back()));
    gaps.demands.push_back(capacity_demand(building, gaps.modes.back(), spectrum.combination));
  }
  const auto peaks_at = [&](const FacingLevel& level) {
    const auto [left, right] = sides_of(problem, level.gap);
    const auto [left_row, right_row] = face_rows(problem, level);
    const auto peak = [&](Eigen::Index b, const Eigen::VectorXd& row) {
      if (const auto& given = problem.buildings[b].given) return given->amplification * row.dot(given->displacement);
      const SpectralModes& modes = gaps.modes[b];
      return modes.omega.size() == 0
                 ? 0.0
                 : combined_peak(modes.motion.transpose() * row, modes.omega, modes.damping, spectrum.combination);
    };
    const auto reduction = [&](Eigen::Index b) {
      if (const auto& given = problem.buildings[b].given) return given->amplification;
      return spectrum.reduction.empty() ? 1.0 : spectrum.reduction[b];
    };
    const double left_peak = peak(left, left_row), right_peak = peak(right, right_row);
    return LevelPeaks{.left = left_peak,
                      .right = right_peak,
                      .left_of_codes = left_peak / reduction(left),
                      .right_of_codes = right_peak / reduction(right),
                      .gap_needed = is_known_by_peaks(problem, left)
                                        ? left_peak + right_peak
                                        : spectral_difference(gaps.modes[left], left_row, gaps.modes[right], right_row,
                                                              spectrum.combination)};
  };
  gaps.levels = separations(problem, peaks_at, code, units);
  return gaps;
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
    if (!isolation || bearings_of(*isolation, 1).law == nullptr) continue;
    return SpectralObstacle{b,
                            "has bearings that yield, whose initial stiffness tells no displacement: for a spectrum "
                            "give stiffness and damping of an equivalent linear bearing, or give a record"};
  }
  return std::nullopt;
}

}  // namespace bentur
