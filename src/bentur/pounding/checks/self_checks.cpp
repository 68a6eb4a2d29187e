#include "bentur/pounding/checks/self_checks.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

namespace bentur {
namespace {

using Eigen::VectorXd;

constexpr double round_off = 1e-9;      // of the largest: what is further apart is told
constexpr double exact_bound = 1e-7;    // likewise: what is further apart contradicts itself
constexpr double over_tolerance = 100;  // of a solver with a tolerance, what all its steps may add up to
constexpr double of_impulse = 1000;     // times as much: between its ends a step of `adaptive` is known less well
constexpr double of_integrated = 10;    // the same, of a contact whose force is integrated
constexpr double infinite = std::numeric_limits<double>::infinity();

double bound_of(const Solver& solver) {
  if (const auto* adaptive = std::get_if<AdaptiveSolver>(&solver))
    return std::max(exact_bound, over_tolerance * adaptive->tolerance);
  if (std::holds_alternative<ExactSolver>(solver)) return exact_bound;
  return infinite;
}

bool is_any_integrated(const Problem& problem) {
  return std::any_of(problem.points.begin(), problem.points.end(),
                     [](const ContactPoint& point) { return is_integrated(*point.law); });
}

/// How much wider the bound of momentum is.
double slack_of_impulse(bool integrated, const Solver& solver) {
  if (std::holds_alternative<AdaptiveSolver>(solver)) return of_impulse;
  return integrated ? of_integrated : 1.0;
}

/// Says what is wrong, as far as a solver is bound to be right.
class Judge {
 public:
  Judge(const Solver& solver, const Verdict& verdict) : bound_(bound_of(solver)), verdict_(verdict) {}

  /// A number that is two, `apart` by this part of the largest.
  template <class Told>
  void compare(const char* key, double apart, const Told& told, double slack = 1.0) {
    if (bound_ == infinite || apart <= round_off) return;
    if (!(apart <= slack * bound_)) return fail(told());
    verdict_.discrepancies.push_back({key, apart});
  }

  void fail(const std::string& what) {
    verdict_.status = Status::failed;
    if (verdict_.message.empty()) verdict_.message = "the run contradicts itself: " + what;
  }

 private:
  double bound_;
  Verdict verdict_;
};

class Checks : private Judge {
 public:
  Checks(const Problem& problem, const Solver& solver, Response& response)
      : Judge(solver, {response.status, response.message, response.discrepancies}),
        problem_(problem),
        response_(response) {}

  void numbers();
  void impacts();
  void first_contact();
  void without_impact();

 private:
  /// `null`: entries that are no number by intent.
  template <class Null>
  void finite(const VectorXd& values, const char* what, std::size_t building, const Null& null) {
    for (Eigen::Index i = 0; i < values.size(); ++i) {
      if (std::isfinite(values(i)) || (std::isnan(values(i)) && null(i))) continue;
      fail(fmt::format("{} {} of {} is {}", what, i + 1, problem_.buildings[building].name, values(i)));
    }
  }
  /// `owner` names whose the values are; it is asked only where one is no number.
  template <class Owner>
  void finite(std::initializer_list<double> values, const Owner& owner) {
    for (const double value : values) {
      if (!std::isfinite(value)) fail(fmt::format("a number of {} is {}", owner(), value));
    }
  }
  [[nodiscard]] std::string place(std::size_t point) const {
    return fmt::format("level {:.6g} of {}", problem_.points[point].elevation,
                       gap_name(problem_, problem_.points[point].left));
  }

  const Problem& problem_;
  Response& response_;
};

/// Nothing but what the documents call null is no finite number.
void Checks::numbers() {
  const auto never = [](Eigen::Index) { return false; };
  for (std::size_t b = 0; b < response_.buildings.size(); ++b) {
    const BuildingPeaks& peaks = response_.buildings[b];
    const Building& building = problem_.buildings[b];
    const std::optional<Eigen::Index> slab = building.model.slab;
    const bool rigid = building.is_rigid();
    const auto of_rigid = [rigid](Eigen::Index) { return rigid; };
    finite(peaks.displacement, "displacement", b, never);
    finite(peaks.displacement_no_contact, "displacement without contact", b, never);
    finite(peaks.acceleration, "acceleration", b, never);
    finite(peaks.acceleration_no_contact, "acceleration without contact", b, never);
    finite(peaks.drift_ratio, "drift ratio", b, [&](Eigen::Index i) { return rigid || slab == i; });
    finite(peaks.storey_shear, "storey shear", b, of_rigid);
    finite(peaks.storey_shear_no_contact, "storey shear without contact", b, of_rigid);
    finite(peaks.column_forces, "column force", b, never);
    finite(peaks.column_forces_no_contact, "column force without contact", b, never);
    finite(peaks.foundation, "movement of the foundation", b, never);
    for (const BuildingPeaks::Breaking& one : peaks.columns) {
      finite({one.peak_shear, one.break_time.value_or(0), one.released_energy, one.residual_slip},
             [&] { return "a column of " + building.name; });
    }
    const auto open = [&](Eigen::Index i) {
      return std::none_of(building.model.infills.begin(), building.model.infills.end(),
                          [&](const InfillPanel& one) { return building.model.first_storey() + one.storey == i; });
    };
    finite(peaks.infill.force, "force of the infill", b, open);
    finite(peaks.infill.energy, "energy of the infill", b, open);
    const Hinges& hinges = building.model.hinges;
    for (const auto* yielding : {&peaks.yielding, &peaks.yielding_no_contact}) {
      finite(yielding->ductility, "ductility", b, [&](Eigen::Index i) { return building.storey_law(i) == nullptr; });
      finite(yielding->residual_drift_ratio, "residual drift", b,
             [&](Eigen::Index i) { return slab == i || !hinges.columns.empty() || !hinges.backbones.empty(); });
      finite(yielding->hysteretic_energy, "hysteretic energy", b, never);
    }
  }
  for (std::size_t i = 0; i < response_.points.size(); ++i) {
    const PointSummary& p = response_.points[i];
    finite({p.gap_needed, p.contact_duration, p.peak_force, p.peak_force_time.value_or(0), p.peak_tension,
            p.peak_penetration, p.peak_closing_speed, p.impulse, p.energy_lost},
           [&] { return place(i); });
  }
  for (const Impact& one : response_.impacts) {
    finite({one.start, one.end, one.closing_speed, one.separation_speed, one.peak_force, one.peak_force_time,
            one.peak_penetration, one.impulse, one.peak_tension, one.energy_lost},
           [&] { return fmt::format("the impact at t = {:.6g} s", one.start); });
  }
  for (const WatchedSummary& one : response_.watched) {
    finite({one.gap_needed, one.least_opening, one.least_time}, [] { return "a watched floor"; });
  }
  for (const LinkSummary& one : response_.links) {
    finite({one.peak_compression, one.peak_tension, one.peak_closing, one.peak_opening, one.energy_dissipated},
           [] { return "a link"; });
  }
  if (response_.energy)
    finite({response_.energy->peak_input, response_.energy->residual}, [] { return "the energies"; });
  for (const Histories* of : {&response_.histories, &response_.course}) {
    bool all = of->opening.allFinite() && of->force.allFinite() && of->link_deformation.allFinite() &&
               of->link_force.allFinite();
    for (const auto* list : {&of->displacement, &of->velocity, &of->acceleration, &of->foundation}) {
      for (const Eigen::MatrixXd& one : *list) all = all && one.allFinite();
    }
    if (!all) fail("a number of the histories is not finite");
  }
}

/// A point's totals are those of its impacts, which follow one another.
void Checks::impacts() {
  std::vector<PointSummary> found(response_.points.size());
  std::vector<double> ended(response_.points.size(), 0.0);
  const double slack = exact_bound * response_.duration;
  for (const Impact& one : response_.impacts) {
    PointSummary& point = found.at(one.point);
    ++(one.settling ? point.settling : point.impacts);
    point.impulse += one.impulse;
    point.peak_force = std::max(point.peak_force, one.peak_force);
    double& last = ended[one.point];
    if (one.start < last - slack || one.end < one.start - slack || one.end > response_.duration + slack) {
      fail(fmt::format("an impact at {} lasts from {:.9g} to {:.9g} s, after one that ended at {:.9g} s",
                       place(one.point), one.start, one.end, last));
    }
    last = std::max(last, one.end);
  }
  for (std::size_t i = 0; i < found.size(); ++i) {
    const PointSummary& told = response_.points[i];
    if (told.impacts == found[i].impacts && told.settling == found[i].settling &&
        told.peak_force == found[i].peak_force &&
        std::abs(told.impulse - found[i].impulse) <= round_off * std::abs(found[i].impulse)) {
      continue;
    }
    fail(fmt::format("{} has {} impacts of {:.9g} at most, the list {} of {:.9g}", place(i), told.impacts,
                     told.peak_force, found[i].impacts, found[i].peak_force));
  }
}

/// Until two buildings meet, the response is that without contact: somewhere they meet exactly where some point needs
/// more without contact than it is given.
void Checks::first_contact() {
  double most = -infinite;
  std::size_t nearest = 0;
  for (std::size_t i = 0; i < response_.points.size(); ++i) {
    const ContactPoint& point = problem_.points[i];
    const auto moves = [&](Eigen::Index b) { return response_.buildings[b].displacement_no_contact.maxCoeff(); };
    const double needed = response_.points[i].gap_needed;
    const double scale = needed + point.width + moves(point.left) + moves(point.right);
    const double beyond = scale > 0.0 ? (needed - point.width) / scale : 0.0;
    if (i > 0 && beyond <= most) continue;
    most = beyond;
    nearest = i;
  }
  if (response_.points.empty()) return;
  const auto told = [&] {
    return fmt::format("{} impacts, but without contact {} needs {:.9g} and is given {:.9g}", response_.impacts.size(),
                       place(nearest), response_.points[nearest].gap_needed, problem_.points[nearest].width);
  };
  compare("check_first_contact", response_.impacts.empty() ? most : -most, told);
}

/// Where nothing has touched, contact has changed nothing.
void Checks::without_impact() {
  if (!response_.impacts.empty()) return;
  double apart = 0.0;
  std::string where;
  const auto largest = [&](VectorXd BuildingPeaks::*list) {
    double most = 0.0;
    for (const BuildingPeaks& peaks : response_.buildings) most = std::max(most, (peaks.*list).maxCoeff());
    return most;
  };
  const double scale = largest(&BuildingPeaks::displacement_no_contact);
  for (std::size_t b = 0; b < response_.buildings.size() && scale > 0.0; ++b) {
    const BuildingPeaks& peaks = response_.buildings[b];
    const double by = (peaks.displacement - peaks.displacement_no_contact).cwiseAbs().maxCoeff() / scale;
    if (by <= apart) continue;
    apart = by;
    where = problem_.buildings[b].name;
  }
  compare("check_without_impact", apart, [&] {
    return fmt::format(
        "no impacts, but the largest displacements of {} differ from those without contact by {:.3g} "
        "of the largest",
        where, apart);
  });
}

}  // namespace

bool is_integrated(const Law& law) {
  const LawState closed = law.next({}, 0, 0.0, 0.0, 1.0);
  return !law.restitution() && !law.branch(closed).linear;
}

double beyond_peak_rotations(const std::vector<BuildingPeaks::Hinge>& hinges,
                             const Eigen::Ref<const Eigen::MatrixXd>& rotation) {
  double largest = 0.0, beyond = 0.0;
  for (std::size_t h = 0; h < hinges.size(); ++h) {
    const BuildingPeaks::Hinge& hinge = hinges[h];
    double most = std::abs(hinge.residual_rotation);
    if (rotation.cols() > 0) most = std::max(most, rotation.row(static_cast<Eigen::Index>(h)).cwiseAbs().maxCoeff());
    largest = std::max(largest, hinge.peak_rotation);
    beyond = std::max(beyond, most - hinge.peak_rotation);
  }
  return largest > 0.0 ? beyond / largest : 0.0;
}

void check_measures(const SelfMeasures& measures, const std::optional<EnergyAudit>& energy, const Solver& solver,
                    bool integrated, const Verdict& verdict) {
  Judge judge(solver, verdict);
  const auto apart = [](const char* what, double by) {
    return [what, by] { return fmt::format("{} by {:.3g} of the largest", what, by); };
  };
  judge.compare("check_momentum", measures.momentum,
                apart("momentum before and after a contact differs from its impulses", measures.momentum),
                slack_of_impulse(integrated, solver));
  // The first step of an integrated contact goes on past a touch that its own force brings about at once.
  judge.compare("check_opening", measures.opening,
                apart("bodies begin or cease to touch where their opening is not zero", measures.opening),
                integrated ? of_integrated : 1.0);
  judge.compare("check_peaks", measures.peaks,
                apart("a history goes beyond the peak that is found of it", measures.peaks));
  judge.compare("check_forces", measures.forces,
                apart("the forces on a building at the end are out of balance", measures.forces));
  if (energy) {
    const double missing = energy->relative_residual();
    judge.compare("check_energy", missing,
                  [missing] { return fmt::format("{:.3g} of the energy that went in is not accounted for", missing); });
  }
}

void check_itself(const Problem& problem, const Solver& solver, const SelfMeasures& measures, Response& response) {
  if (response.status != Status::done && response.status != Status::collapsed) return;
  Checks checks(problem, solver, response);
  checks.numbers();
  if (response.status == Status::failed) return;
  checks.impacts();
  checks.first_contact();
  checks.without_impact();
  SelfMeasures all = measures;
  for (std::size_t b = 0; b < response.buildings.size(); ++b) {
    const auto& rotations = response.histories.hinge_rotation;
    all.peaks = std::max(all.peaks, beyond_peak_rotations(response.buildings[b].hinges,
                                                          rotations.empty() ? Eigen::MatrixXd() : rotations[b]));
  }
  check_measures(all, response.energy, solver, is_any_integrated(problem),
                 {response.status, response.message, response.discrepancies});
}

}  // namespace bentur
