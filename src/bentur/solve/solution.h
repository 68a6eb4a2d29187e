#pragma once

#include <Eigen/Core>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "bentur/elements/coupled_law.h"

namespace bentur {

/// One contact from touching to parting.
struct Impact {
  Eigen::Index point = 0;    ///< index into System::contacts, and beyond these into System::rubbing
  double start = 0;          ///< [s]
  double end = 0;            ///< [s]; the end of the analysis where `open_ended`
  bool open_ended = false;   ///< still closed when the analysis ended
  bool from_rest = false;    ///< began below 10⁻⁶ of the speeds at the point: its closing speed is round-off
  bool slow_start = false;   ///< and its law divides by that speed, which is then 10⁻⁹ of those at least
  bool slipped = false;      ///< ended where another family of its meeting opened: what its spring held is lost
  bool settling = false;     ///< without time, slower than 2⁻¹³ of the speeds so far: a bounce on the way to rest
  double closing_speed = 0;  ///< −ġ at the start [length/s]; 0 where it is below 10⁻⁹ of the speeds at the point
  double separation_speed = 0;  ///< ġ at the end [length/s]
  double peak_force = 0;        ///< [force]
  double peak_force_time = 0;   ///< [s]
  double peak_penetration = 0;  ///< [length]
  double impulse = 0;           ///< ∫F dt [force·s]
  double peak_tension = 0;      ///< largest pull, of laws that can [force] ≥ 0
  double energy_lost = 0;       ///< work on the contact that it does not give back [force·length]; what a
                                ///< later one finds stored in a surface still dented counts as given back
  // Of contacts that rub, for which energy_lost is that of the force across alone:
  double peak_tangential_force = 0;  ///< max |F_t| [force]
  double tangential_impulse = 0;     ///< ∫F_t dt [force·s]
  double sliding = 0;                ///< path slid [length] ≥ 0
  double friction_loss = 0;          ///< work of F_t that it does not give back [force·length]
  /// Separation speed over closing speed [-]; nothing where that is not known or means nothing.
  [[nodiscard]] std::optional<double> restitution() const {
    if (open_ended || slipped || from_rest || !(closing_speed > 0)) return std::nullopt;
    return separation_speed / closing_speed;
  }
};

/// The outputs of one kind of one body.
struct OutputsFound {
  Eigen::VectorXd peak = {};     ///< the largest size of each; empty where none is looked for
  Eigen::MatrixXd history = {};  ///< outputs × samples
  /// Of each output that is sampled, what it is a sum of over the modes in the samples: |row| · |q| at most, in
  /// Euclidean norms. Round-off is a part of that.
  Eigen::VectorXd size = {};
  Eigen::MatrixXd course = {};  ///< outputs × instants of the exact course; empty where it does not keep them
};

/// What ended the branch of an element, and where all were just after that.
struct Change {
  Eigen::Index element = 0;  ///< contacts, joints and limits as System has them
  std::size_t guard = 0;     ///< of its branch
  double time = 0;           ///< [s]
  LawState before, after;
  /// Of a contact of a meeting: it is closed or opens without a force, and its law goes on as it was.
  bool passes = false;
  bool shares = false;  ///< several families of its meeting share what acts
  std::vector<std::pair<Eigen::Index, LawState>>
      slipped;  ///< contacts whose force has ended with it, and where they are
  std::vector<std::pair<Eigen::Index, double>> impulses;  ///< of impacts without time: element, and [force·s]
  Eigen::VectorXd q, v;                                   ///< every coordinate of the solver
};

/// How far a δ went.
struct Reach {
  double reach = 0;  ///< max(0, δ) [length]
  double time = 0;   ///< when [s]
};

/// How far a δ can still go after a run has ended, while the ground rests or swings on in harmony and nothing touches:
/// in t [s] from then on
///   rest − Σ size e^(−rate t) ≤ δ ≤ rest + Σ size e^(−rate t).                                          (T-9)
/// Of bodies that yield as long as they yield no more.
struct ToCome {
  struct Fading {
    double size = 0;  ///< [length]; infinite of what nothing holds
    double rate = 0;  ///< [1/s] ≥ 0
  };
  bool known = false;  ///< the displacement of the ground is no part of δ
  double rest = 0;     ///< [length]
  std::vector<Fading> fading = {};

  /// The largest δ, or with sign −1 the largest −δ, from t on [length].
  [[nodiscard]] double most(double t, double sign = 1) const;
};

/// What an element did that is no contact.
struct ElementFound {
  double peak_force = 0, peak_tension = 0;  ///< max F and max −F of joints, dashpots included [force] ≥ 0
  Reach closing = {}, opening = {};         ///< how far δ and −δ went, of joints and of members that yield unevenly
  double energy_lost = 0;                   ///< [force·length]
  double residual = 0;                      ///< δ that would be left without force, of members [length]
  std::optional<StrengthLoss> loss = {};    ///< of members that can lose strength
};

/// Times, and at each the openings w − δ and forces of contacts (those that rub last), slips and forces along of those
/// that rub, δ and F of joints; a column each.
struct Sampled {
  std::vector<double> time = {};                ///< [s]
  Eigen::MatrixXd ground_acceleration = {};     ///< per component, without delay [length/s²]; of samples alone
  Eigen::MatrixXd opening = {}, force = {};     ///< [length], [force]
  Eigen::MatrixXd slip = {}, force_along = {};  ///< of samples alone
  Eigen::MatrixXd joint_deformation = {}, joint_force = {};
};

/// Where all energy is [force·length], at instants of its own. Motion is relative to each body's base:
///   input = kinetic + strain + damping + hysteretic + contact stored + contact lost + residual.
struct EnergyHistories {
  std::vector<double> time;  ///< [s]
  /// Initial energy and the work of the ground motion, where that moves what touches also through contact.
  Eigen::VectorXd input;
  Eigen::VectorXd kinetic;          ///< of all bodies
  Eigen::VectorXd strain;           ///< of bodies and joints: what they would give back
  Eigen::VectorXd damping;          ///< lost so far in the bodies' damping and in the dashpots of joints
  Eigen::VectorXd hysteretic = {};  ///< lost so far by yielding, of bodies and joints
  Eigen::VectorXd contact_stored;   ///< in contacts, to be given back
  Eigen::VectorXd contact_lost;     ///< lost in contacts so far
};

/// The account of a whole run; looked at after every step, not at samples.
struct EnergyAudit {
  double peak_input = 0;  ///< largest |input| [force·length]
  double residual = 0;    ///< largest |residual| [force·length]
  [[nodiscard]] double relative_residual() const { return peak_input > 0 ? residual / peak_input : 0; }
  EnergyHistories histories;  ///< empty unless histories are kept
};

enum class Status { done, stopped, failed, collapsed };

/// How far numbers of a run are apart that are one, each as a part of the largest of them [-]; 0 where there was
/// nothing to compare.
struct SelfMeasures {
  double momentum = 0;  ///< over contacts: of the states before and after, and the impulses that are reported
  double opening = 0;   ///< of the bodies at instants at which they begin or cease to touch: from zero
  double forces = 0;    ///< at the end: inertia, damping, stiffness and elements by the bodies' own matrices
  double peaks = 0;     ///< of any sample beyond the peak of the continuous response
};

/// What a solver found.
struct Solution {
  Status status = Status::done;
  std::string message = {};  ///< why and when, unless done
  long steps = 0;            ///< intervals over which the solution was advanced
  long events = 0;           ///< contacts closed or opened
  /// The limit that was passed, index into System::limits, and when [s]; nothing where the run went to its end.
  struct Passed {
    Eigen::Index limit = 0;
    double time = 0;
  };
  std::optional<Passed> passed = {};
  std::vector<std::vector<OutputsFound>> outputs = {};  ///< per body, as Body::outputs
  std::vector<Impact> impacts = {};                     ///< in the order in which they ended
  std::vector<Change> changes = {};                     ///< in their order, where they are kept
  std::vector<double> needed = {};  ///< per contact in the free response (those that rub last), max(0, δ) [length]
  std::vector<ElementFound> joints = {};
  std::vector<std::vector<ElementFound>> members = {};  ///< per body, as Body::elements
  std::vector<CoupledState> coupled = {};               ///< of all bodies' Body::coupled, at the end
  std::vector<Reach> watched = {}, watched_free = {};   ///< as in the system
  std::vector<ToCome> to_come = {};                     ///< per contact (those that rub last), then as watched
  std::vector<double> scales = {};  ///< per watched interface, the lengths whose difference δ is [length]
  Sampled samples = {}, course = {};
  std::optional<EnergyAudit> energy = {};
  SelfMeasures checks = {};
};

/// What a solution becomes where the ground motion and all widths are `factor` > 0 times those it was found with, in a
/// system that starts from rest and in which nothing has a size of its own: no element yields, no limit ends a run,
/// and laws of contacts and joints are homogeneous (Law::is_homogeneous).
[[nodiscard]] Solution scaled(Solution solution, double factor);

}  // namespace bentur
