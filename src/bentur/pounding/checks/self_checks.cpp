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
  Judge(const Solver& solver, RunOutcome& outcome) : outcome_(outcome), bound_(bound_of(solver)) {}

  /// A number that is two, `apart` by this part of the largest.
  template <class Told>
  void compare(const char* key, double apart, const Told& told, double slack = 1.0) {
    if (bound_ == infinite || apart <= round_off) return;
    if (!(apart <= slack * bound_)) return fail(told());
    outcome_.discrepancies.push_back({key, apart});
  }

  void fail(const std::string& what) {
    outcome_.status = Status::failed;
    if (outcome_.message.empty()) outcome_.message = "the run contradicts itself: " + what;
  }

 protected:
  RunOutcome& outcome_;

 private:
  double bound_;
};

class Checks : private Judge {
 public:
  Checks(const CheckedRun& run, const Solver& solver, RunOutcome& outcome) : Judge(solver, outcome), run_(run) {}

  using Judge::fail;
  void numbers();
  void impacts();
  void first_contact();
  void without_impact();

 private:
  /// `owner` names whose the values are; it is asked only where one is no number.
  template <class Owner>
  void finite(std::initializer_list<double> values, const Owner& owner) {
    for (const double value : values) {
      if (!std::isfinite(value)) fail(fmt::format("a number of {} is {}", owner(), value));
    }
  }

  const CheckedRun& run_;
};

/// Nothing but what the documents call null is no finite number.
void Checks::numbers() {
  for (const CheckedPeaks& list : run_.peaks) {
    for (Eigen::Index i = 0; i < list.values.size(); ++i) {
      const double value = list.values(i);
      if (std::isfinite(value) || (std::isnan(value) && list.is_null && list.is_null(i))) continue;
      fail(fmt::format("{} {} of {} is {}", list.what, i + 1, list.building, value));
    }
  }
  for (std::size_t i = 0; i < outcome_.points.size(); ++i) {
    const PointSummary& p = outcome_.points[i];
    finite({p.gap_needed, p.contact_duration, p.peak_force, p.peak_force_time.value_or(0), p.peak_tension,
            p.peak_penetration, p.peak_closing_speed, p.impulse, p.energy_lost},
           [&] { return run_.place(i); });
  }
  for (const Impact& one : outcome_.impacts) {
    finite({one.start, one.end, one.closing_speed, one.separation_speed, one.peak_force, one.peak_force_time,
            one.peak_penetration, one.impulse, one.peak_tension, one.energy_lost, one.tangential_impulse},
           [&] { return fmt::format("the impact at t = {:.6g} s", one.start); });
  }
  for (const WatchedSummary& one : outcome_.watched) {
    finite({one.gap_needed, one.least_opening, one.least_time}, [] { return "a watched floor"; });
  }
  for (const LinkSummary& one : outcome_.links) {
    finite({one.peak_compression, one.peak_tension, one.peak_closing, one.peak_opening, one.energy_dissipated},
           [] { return "a link"; });
  }
  if (outcome_.energy) finite({outcome_.energy->peak_input, outcome_.energy->residual}, [] { return "the energies"; });
}

/// A point's totals are those of its impacts, which follow one another.
void Checks::impacts() {
  std::vector<PointSummary> found(outcome_.points.size());
  std::vector<double> ended(outcome_.points.size(), 0.0);
  const double slack = exact_bound * outcome_.duration;
  for (const Impact& one : outcome_.impacts) {
    PointSummary& point = found.at(one.point);
    ++(one.settling ? point.settling : point.impacts);
    point.impulse += one.impulse;
    point.peak_force = std::max(point.peak_force, one.peak_force);
    double& last = ended[one.point];
    if (one.start < last - slack || one.end < one.start - slack || one.end > outcome_.duration + slack) {
      fail(fmt::format("an impact at {} lasts from {:.9g} to {:.9g} s, after one that ended at {:.9g} s",
                       run_.place(one.point), one.start, one.end, last));
    }
    last = std::max(last, one.end);
  }
  for (std::size_t i = 0; i < found.size(); ++i) {
    const PointSummary& told = outcome_.points[i];
    if (told.impacts == found[i].impacts && told.settling == found[i].settling &&
        told.peak_force == found[i].peak_force &&
        std::abs(told.impulse - found[i].impulse) <= round_off * std::abs(found[i].impulse)) {
      continue;
    }
    fail(fmt::format("{} has {} impacts of {:.9g} at most, the list {} of {:.9g}", run_.place(i), told.impacts,
                     told.peak_force, found[i].impacts, found[i].peak_force));
  }
}

/// Until two buildings meet, the response is that without contact: somewhere they meet exactly where some point needs
/// more without contact than it is given.
void Checks::first_contact() {
  if (outcome_.impacts.empty() && !run_.touches_where_closed) return;
  double most = -infinite;
  std::size_t nearest = 0;
  for (std::size_t i = 0; i < outcome_.points.size(); ++i) {
    const double needed = outcome_.points[i].gap_needed;
    const double scale = needed + run_.widths[i] + run_.moves[i];
    const double beyond = scale > 0.0 ? (needed - run_.widths[i]) / scale : 0.0;
    if (i > 0 && beyond <= most) continue;
    most = beyond;
    nearest = i;
  }
  if (outcome_.points.empty()) return;
  compare("check_first_contact", outcome_.impacts.empty() ? most : -most, [&] {
    return fmt::format("{} impacts, but without contact {} needs {:.9g} and is given {:.9g}", outcome_.impacts.size(),
                       run_.place(nearest), outcome_.points[nearest].gap_needed, run_.widths[nearest]);
  });
}

/// Where nothing has touched, contact has changed nothing.
void Checks::without_impact() {
  if (!outcome_.impacts.empty()) return;
  double apart = 0.0, scale = 0.0;
  const std::string* where = nullptr;
  for (const ComparedPeaks& one : run_.compared) {
    if (one.without.size() > 0) scale = std::max(scale, one.without.maxCoeff());
  }
  for (const ComparedPeaks& one : run_.compared) {
    if (!(scale > 0.0) || one.with.size() == 0) continue;
    const double by = (one.with - one.without).cwiseAbs().maxCoeff() / scale;
    if (by <= apart) continue;
    apart = by;
    where = &one.building;
  }
  compare("check_without_impact", apart, [&] {
    return fmt::format(
        "no impacts, but the largest displacements of {} differ from those without contact by {:.3g} "
        "of the largest",
        *where, apart);
  });
}

/// What every solution has twice, whatever it is of.
void check_measures(const SelfMeasures& measures, const CheckedRun& run, const Solver& solver, RunOutcome& outcome) {
  Judge judge(solver, outcome);
  const auto apart = [](const char* what, double by) {
    return [what, by] { return fmt::format("{} by {:.3g} of the largest", what, by); };
  };
  judge.compare("check_momentum", measures.momentum,
                apart("momentum before and after a contact differs from its impulses", measures.momentum),
                slack_of_impulse(run.is_integrated, solver));
  // The first step of an integrated contact goes on past a touch that its own force brings about at once.
  judge.compare("check_opening", measures.opening,
                apart("bodies begin or cease to touch where their opening is not zero", measures.opening),
                run.is_integrated ? of_integrated : 1.0);
  judge.compare("check_peaks", measures.peaks,
                apart("a history goes beyond the peak that is found of it", measures.peaks));
  judge.compare("check_forces", measures.forces,
                apart("the forces on a building at the end are out of balance", measures.forces));
  if (outcome.energy) {
    const double missing = outcome.energy->relative_residual();
    judge.compare("check_energy", missing,
                  [missing] { return fmt::format("{:.3g} of the energy that went in is not accounted for", missing); });
  }
}

/// Peaks of a building of a row, and where they are none by intent.
void add_peaks(const Building& building, const BuildingPeaks& peaks, std::vector<CheckedPeaks>& all) {
  const std::optional<Eigen::Index> slab = building.model.slab;
  const bool rigid = building.is_rigid();
  const auto add = [&](const char* what, const VectorXd& values, std::function<bool(Eigen::Index)> is_null = {}) {
    all.push_back({what, building.name, values, std::move(is_null)});
  };
  const auto of_rigid = [rigid](Eigen::Index) { return rigid; };
  const auto open = [&building](Eigen::Index i) {
    return std::none_of(building.model.infills.begin(), building.model.infills.end(),
                        [&](const InfillPanel& one) { return building.model.first_storey() + one.storey == i; });
  };
  add("displacement", peaks.displacement);
  add("displacement without contact", peaks.displacement_no_contact);
  add("acceleration", peaks.acceleration);
  add("acceleration without contact", peaks.acceleration_no_contact);
  add("drift ratio", peaks.drift_ratio, [rigid, slab](Eigen::Index i) { return rigid || slab == i; });
  add("storey shear", peaks.storey_shear, of_rigid);
  add("storey shear without contact", peaks.storey_shear_no_contact, of_rigid);
  add("column force", peaks.column_forces);
  add("column force without contact", peaks.column_forces_no_contact);
  add("movement of the foundation", peaks.foundation);
  add("force of the infill", peaks.infill.force, open);
  add("energy of the infill", peaks.infill.energy, open);
  for (const auto* yielding : {&peaks.yielding, &peaks.yielding_no_contact}) {
    add("ductility", yielding->ductility, [&building](Eigen::Index i) { return building.storey_law(i) == nullptr; });
    add("residual drift", yielding->residual_drift_ratio, [&building](Eigen::Index i) {
      const Hinges& hinges = building.model.hinges;
      return building.model.slab == i || !hinges.columns.empty() || !hinges.backbones.empty();
    });
    add("hysteretic energy", yielding->hysteretic_energy);
  }
}

bool is_finite(const std::vector<BuildingPeaks::Breaking>& columns) {
  return std::all_of(columns.begin(), columns.end(), [](const BuildingPeaks::Breaking& one) {
    return std::isfinite(one.peak_shear + one.break_time.value_or(0) + one.released_energy + one.residual_slip);
  });
}

bool is_finite(const Histories& histories) {
  bool all = histories.opening.allFinite() && histories.force.allFinite() && histories.link_deformation.allFinite() &&
             histories.link_force.allFinite();
  for (const auto* list :
       {&histories.displacement, &histories.velocity, &histories.acceleration, &histories.foundation}) {
    for (const Eigen::MatrixXd& one : *list) all = all && one.allFinite();
  }
  return all;
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

void check_run(const CheckedRun& run, const SelfMeasures& measures, const Solver& solver, RunOutcome& outcome) {
  Checks checks(run, solver, outcome);
  if (!run.fault.empty()) checks.fail(run.fault);
  checks.numbers();
  if (outcome.status == Status::failed) return;
  checks.impacts();
  checks.first_contact();
  checks.without_impact();
  check_measures(measures, run, solver, outcome);
}

void check_itself(const Problem& problem, const Solver& solver, const SelfMeasures& measures, Response& response) {
  if (response.status != Status::done && response.status != Status::collapsed) return;
  CheckedRun run{.place =
                     [&](std::size_t i) {
                       return fmt::format("level {:.6g} of {}", problem.points[i].elevation,
                                          gap_name(problem, problem.points[i].left));
                     },
                 .is_integrated = is_any_integrated(problem)};
  SelfMeasures all = measures;
  std::vector<double> moves;  // per building
  for (std::size_t b = 0; b < response.buildings.size(); ++b) {
    const BuildingPeaks& peaks = response.buildings[b];
    const std::string& name = problem.buildings[b].name;
    add_peaks(problem.buildings[b], peaks, run.peaks);
    run.compared.push_back({name, peaks.displacement, peaks.displacement_no_contact});
    moves.push_back(peaks.displacement_no_contact.maxCoeff());
    if (!is_finite(peaks.columns)) run.fault = "a number of a column of " + name + " is not finite";
    const auto& rotations = response.histories.hinge_rotation;
    all.peaks =
        std::max(all.peaks, beyond_peak_rotations(peaks.hinges, rotations.empty() ? Eigen::MatrixXd() : rotations[b]));
  }
  for (const ContactPoint& point : problem.points) {
    run.widths.push_back(point.width);
    run.moves.push_back(moves[point.left] + moves[point.right]);
  }
  if (!is_finite(response.histories) || !is_finite(response.course)) {
    run.fault = "a number of the histories is not finite";
  }
  check_run(run, all, solver, response);
}

}  // namespace bentur
