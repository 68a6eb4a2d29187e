#include "bentur/model/gap/spectral_gap.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <utility>

#include "bentur/core/number_text.h"
#include "bentur/core/require.h"
#include "bentur/model/plan/plan_places.h"
#include "bentur/model/plan/plan_row.h"
#include "bentur/structure/plan/plan_body.h"

namespace bentur {
namespace {

/// The peak of row · x, of two directions the root of the sum of squares.
double peak_of(const SpectralModes& modes, const Eigen::VectorXd& row, ModalCombination combination) {
  double square = 0;
  for (const Eigen::MatrixXd& motion : modes.motions) {
    if (modes.omega.size() == 0) break;
    const double peak = combined_peak(motion.transpose() * row, modes.omega, modes.damping, combination);
    if (modes.motions.size() == 1) return peak;
    square += peak * peak;
  }
  return std::sqrt(square);
}

/// The peak of x_left − x_right, rows over the dofs of two buildings [length].
double spectral_difference(const SpectralModes& left, const Eigen::VectorXd& left_row, const SpectralModes& right,
                           const Eigen::VectorXd& right_row, ModalCombination combination) {
  const Eigen::Index of_left = left.omega.size(), of_right = right.omega.size();
  SpectralModes both;
  both.omega.resize(of_left + of_right);
  both.damping.resize(of_left + of_right);
  both.omega << left.omega, right.omega;
  both.damping << left.damping, right.damping;
  for (std::size_t i = 0; i < left.motions.size(); ++i) {
    // As one degree of freedom, which the difference is.
    Eigen::MatrixXd& peaks = both.motions.emplace_back(1, of_left + of_right);
    if (of_left > 0) peaks.leftCols(of_left) = left_row.transpose() * left.motions[i];
    if (of_right > 0) peaks.rightCols(of_right) = -(right_row.transpose() * right.motions[i]);
  }
  return peak_of(both, Eigen::VectorXd::Ones(1), combination);
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

/// Of the faces of every contact that a row has and of all that is watched, in the order of row_of().
struct PlanFaces {
  std::vector<std::pair<Eigen::VectorXd, Eigen::VectorXd>> points, watched;

  explicit PlanFaces(const PlanProblem& problem) {
    const System system = system_of(problem);
    const auto rows = [](const Interface& at, const PlanGap& gap) {
      const bool in_order = at.left.body == gap.left;
      const BodyRow &left = in_order ? at.left : at.right, &right = in_order ? at.right : at.left;
      return std::pair<Eigen::VectorXd, Eigen::VectorXd>(left.row, -right.row);
    };
    const std::vector<const Interface*> contacts = contact_interfaces(problem, system);
    std::size_t contact = 0, watches = 0;
    for (const PlanGap& gap : problem.gaps) {
      for (const Eigen::Index n : contacts_in_row(gap)) {
        points.push_back(rows(*contacts[contact + static_cast<std::size_t>(n)], gap));
      }
      contact += gap.contacts.size();
      for (std::size_t i = 0; i < gap.watched.size(); ++i) watched.push_back(rows(system.watched[watches++], gap));
    }
  }
};

/// @param load p = −load · a_g, a column for each direction [mass]
SpectralModes modes_of(const Modes& modes, const Eigen::MatrixXd& modal_damping, const Eigen::MatrixXd& load,
                       const DesignSpectrum& spectrum) {
  SpectralModes result;
  result.omega = modes.omega;
  result.damping = modal_damping.diagonal().cwiseQuotient(2 * modes.omega).cwiseMax(0.0);  // round-off
  result.displacement.resize(modes.omega.size());
  for (Eigen::Index n = 0; n < modes.omega.size(); ++n) {
    result.displacement(n) = spectral_displacement(spectrum, 2 * std::numbers::pi / modes.omega(n), result.damping(n));
  }
  for (Eigen::Index i = 0; i < load.cols(); ++i) {
    const Eigen::VectorXd participation = modes.shapes.transpose() * load.col(i);
    result.motions.push_back(modes.shapes * participation.cwiseProduct(result.displacement).asDiagonal());
  }
  return result;
}

/// Raises the worst demand of hinges and columns that break. @param peak of a row over the dofs
template <class Peak>
void take_hinges(const Hinges& hinges, Eigen::Index first_storey, const Peak& peak, CapacityDemand& worst) {
  for (Eigen::Index h = 0; h < hinges.size(); ++h) {
    const double moment = peak(hinges.rows.row(h)), rest = h < hinges.at_rest.size() ? hinges.at_rest(h) : 0;
    const double ratio = std::max((moment + rest) / hinges.clockwise(h), (moment - rest) / hinges.anticlockwise(h));
    const auto place = static_cast<std::size_t>(h);
    const bool is_hinge = place < hinges.places.size();
    const Eigen::Index number =
        is_hinge ? hinges.places[place].level : hinges.columns.at(place - hinges.places.size()).storey;
    if (ratio > worst.ratio) worst = {ratio, first_storey + std::max<Eigen::Index>(number, 1) - 1};
  }
}

void raise(double drift_ratio, Eigen::Index storey, LargestDrift& largest) {
  if (drift_ratio > largest.ratio) largest = {drift_ratio, storey};
}

double least_yield(const HystereticLaw& law) {
  return std::min(law.yield_deformation(), law.yield_deformation_below());
}

/// Levels of gaps. @param face_rows of the left and the right face over the dofs of their buildings
template <class FaceRows>
std::vector<LevelSeparation> levels_of(const Problem& problem, const std::vector<SpectralModes>& modes,
                                       const FaceRows& face_rows, const SpectrumSpec& spectrum, const CodeSpec& code,
                                       const Units& units) {
  const auto peaks_at = [&](const FacingLevel& level) {
    const auto [left, right] = sides_of(problem, level.gap);
    const std::pair<Eigen::VectorXd, Eigen::VectorXd> rows = face_rows(level);
    const auto peak = [&](Eigen::Index b, const Eigen::VectorXd& row) {
      if (const auto& given = problem.buildings[b].given) return given->amplification * row.dot(given->displacement);
      return peak_of(modes[b], row, spectrum.combination);
    };
    const auto reduction = [&](Eigen::Index b) {
      if (const auto& given = problem.buildings[b].given) return given->amplification;
      return spectrum.reduction.empty() ? 1.0 : spectrum.reduction[b];
    };
    const double left_peak = peak(left, rows.first), right_peak = peak(right, rows.second);
    return LevelPeaks{.left = left_peak,
                      .right = right_peak,
                      .left_of_codes = left_peak / reduction(left),
                      .right_of_codes = right_peak / reduction(right),
                      .gap_needed = is_known_by_peaks(problem, level.gap)
                                        ? left_peak + right_peak
                                        : spectral_difference(modes[left], rows.first, modes[right], rows.second,
                                                              spectrum.combination)};
  };
  return separations(problem, peaks_at, code, units);
}

/// What is found of each building by itself, of a row as in plan.
template <class Buildings>
SpectralGaps gaps_of(const Buildings& buildings, const SpectrumSpec& spectrum) {
  if (!spectrum.of_displacements) validate(spectrum.spectrum);
  if (!spectrum.reduction.empty()) require_size("reduction", spectrum.reduction.size(), buildings.size());
  SpectralGaps gaps;
  for (const auto& building : buildings) {
    gaps.modes.push_back(spectral_modes(building, spectrum.spectrum));
    gaps.peaks.push_back(spectral_peaks(building, gaps.modes.back()));
    gaps.demands.push_back(capacity_demand(building, gaps.modes.back(), spectrum.combination));
    gaps.drifts.push_back(spectral_drift(building, gaps.modes.back(), spectrum.combination));
  }
  return gaps;
}

}  // namespace

SpectralModes spectral_modes(const Building& building, const DesignSpectrum& spectrum) {
  if (!building.is_rigid()) return modes_of(building.modes, building.modal_damping, building.model.load, spectrum);
  SpectralModes still;
  still.motions = {Eigen::MatrixXd::Zero(building.model.dofs(), 0)};
  return still;
}

SpectralModes spectral_modes(const PlanBuilding& building, const DesignSpectrum& spectrum) {
  if (!building.is_rigid()) return modes_of(building.modes, building.modal_damping, building.model.load, spectrum);
  SpectralModes still;
  still.motions.assign(2, Eigen::MatrixXd::Zero(building.model.dofs(), 0));
  return still;
}

SpectralPeaks spectral_peaks(const Building& building, const SpectralModes& modes) {
  const Eigen::Index floors = building.model.floors();
  SpectralPeaks peaks{Eigen::VectorXd::Zero(floors), Eigen::VectorXd::Zero(floors)};
  if (building.given) {
    peaks.srss = peaks.cqc = building.given->amplification * building.given->displacement;
    return peaks;
  }
  for (Eigen::Index floor = 0; floor < floors && modes.omega.size() > 0; ++floor) {
    const Eigen::VectorXd row = Eigen::VectorXd::Unit(building.model.dofs(), floor);
    peaks.srss(floor) = peak_of(modes, row, ModalCombination::srss);
    peaks.cqc(floor) = peak_of(modes, row, ModalCombination::cqc);
  }
  return peaks;
}

SpectralPeaks spectral_peaks(const PlanBuilding& building, const SpectralModes& modes) {
  const Eigen::VectorXd none = Eigen::VectorXd::Zero(building.model.floors());
  SpectralPeaks peaks{none, none, none, none};
  for (Eigen::Index floor = 0; floor < none.size() && modes.omega.size() > 0; ++floor) {
    const auto row = [&](Eigen::Index axis) -> Eigen::VectorXd {
      return Eigen::VectorXd::Unit(building.model.dofs(), 3 * floor + axis);
    };
    peaks.srss(floor) = peak_of(modes, row(0), ModalCombination::srss);
    peaks.cqc(floor) = peak_of(modes, row(0), ModalCombination::cqc);
    peaks.srss_y(floor) = peak_of(modes, row(1), ModalCombination::srss);
    peaks.cqc_y(floor) = peak_of(modes, row(1), ModalCombination::cqc);
  }
  return peaks;
}

CapacityDemand capacity_demand(const Building& building, const SpectralModes& modes, ModalCombination combination) {
  CapacityDemand worst;
  if (modes.omega.size() == 0) return worst;
  const StructuralModel& model = building.model;
  const auto peak = [&](const Eigen::VectorXd& row) { return peak_of(modes, row, combination); };
  const Eigen::MatrixXd drifts = drift_rows(model);
  for (const BuildingElement& element : building.elements) {
    const double ratio = peak(drifts.row(element.storey)) / least_yield(*element.law);
    if (ratio > worst.ratio) worst = {ratio, element.storey};
  }
  take_hinges(model.hinges, model.first_storey(), peak, worst);
  return worst;
}

CapacityDemand capacity_demand(const PlanBuilding& building, const SpectralModes& modes, ModalCombination combination) {
  CapacityDemand worst;
  if (modes.omega.size() == 0) return worst;
  const auto peak = [&](const Eigen::VectorXd& row) { return peak_of(modes, row, combination); };
  for (const PlanModel::Plane& plane : building.model.planes) {
    for (std::size_t storey = 0; storey < plane.laws.size(); ++storey) {
      if (plane.laws[storey] == nullptr) continue;
      const auto place = static_cast<Eigen::Index>(storey);
      const double ratio = peak(plane.drifts.row(place)) / least_yield(*plane.laws[storey]);
      if (ratio > worst.ratio) worst = {ratio, place};
    }
    take_hinges(plane.hinges, building.model.first_storey(), peak, worst);
  }
  return worst;
}

LargestDrift spectral_drift(const Building& building, const SpectralModes& modes, ModalCombination combination) {
  LargestDrift largest;
  if (modes.omega.size() == 0) return largest;
  const Eigen::MatrixXd drifts = drift_rows(building.model);
  for (Eigen::Index storey = building.model.first_storey(); storey < drifts.rows(); ++storey) {
    const double height = building.model.storey_heights[storey];
    if (height > 0) raise(peak_of(modes, drifts.row(storey), combination) / height, storey, largest);
  }
  return largest;
}

LargestDrift spectral_drift(const PlanBuilding& building, const SpectralModes& modes, ModalCombination combination) {
  LargestDrift largest;
  if (modes.omega.size() == 0) return largest;
  const PlanModel& model = building.model;
  const Eigen::MatrixXd edges = model.planes.empty() ? edge_drift_rows(model) : Eigen::MatrixXd();
  for (Eigen::Index row = 0; row < edges.rows(); ++row) {
    raise(peak_of(modes, edges.row(row), combination), row % model.floors(), largest);
  }
  for (const PlanModel::Plane& plane : model.planes) {
    for (Eigen::Index j = model.first_storey(); j < plane.drifts.rows(); ++j) {
      raise(peak_of(modes, plane.drifts.row(j), combination) / model.storey_heights[j], j, largest);
    }
  }
  return largest;
}

SpectralGaps spectral_gaps(const Problem& problem, const SpectrumSpec& spectrum, const CodeSpec& code,
                           const Units& units) {
  SpectralGaps gaps = gaps_of(problem.buildings, spectrum);
  const auto rows = [&](const FacingLevel& level) { return face_rows(problem, level); };
  gaps.levels = levels_of(problem, gaps.modes, rows, spectrum, code, units);
  return gaps;
}

SpectralGaps spectral_gaps(const PlanProblem& problem, const SpectrumSpec& spectrum, const CodeSpec& code,
                           const Units& units) {
  SpectralGaps gaps = gaps_of(problem.buildings, spectrum);
  const PlanFaces faces(problem);
  const auto rows = [&](const FacingLevel& level) {
    return (level.is_point ? faces.points : faces.watched).at(static_cast<std::size_t>(level.index));
  };
  gaps.levels = levels_of(row_of(problem), gaps.modes, rows, spectrum, code, units);
  gaps.plan = std::make_shared<const PlanProblem>(problem);
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
  const auto bearings_yield = [](const BuildingSpec& spec) {
    if (spec.isolation && bearings_of(*spec.isolation, 1).law != nullptr) return true;
    const auto* const plan = std::get_if<Plan>(&spec.structure);
    return plan != nullptr && plan->isolation &&
           std::any_of(plan->isolation->bearings.begin(), plan->isolation->bearings.end(),
                       [](const PlanBearing& one) { return one.bearing.law != nullptr; });
  };
  for (std::size_t b = 0; b < c.buildings.size(); ++b) {
    if (!bearings_yield(c.buildings[b])) continue;
    return SpectralObstacle{b,
                            "has bearings that yield, whose initial stiffness tells no displacement: for a spectrum "
                            "give stiffness and damping of an equivalent linear bearing, or give a record"};
  }
  return std::nullopt;
}

}  // namespace bentur
