#pragma once

#include <cstddef>
#include <initializer_list>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

namespace bentur {

/// Where one contact stands. A law reads and writes it, a solver carries it, one per contact point.
struct ContactState {
  int branch = 0;            ///< number of the law's branch; 0: apart, with nothing remembered
  double since = 0;          ///< when the branch began [s]
  double closing_speed = 0;  ///< v₀, δ̇ at the start of this contact, kept until it ends [length/s]
  double memory = 0;         ///< the law's own, in a unit of its own
};

/// A branch lasts while  constant + penetration δ + speed δ̇ + decaying exp(−rate (t − since)) ≥ 0.
///
/// Zero belongs to the branch: it ends where the sum becomes negative, and a sum that only touches zero ends nothing.
/// A solver lets it go below zero by round-off: 2⁻⁴⁶ of the displacements and speeds that δ and δ̇ are differences of,
/// each times its factor, and of `constant`. The guard δ ≥ 0 alone of a touching branch has no such tolerance.
/// All terms have one dimension [X], which the law chooses, but it is [length] where a term decays.
struct Guard {
  double constant = 0;     ///< [X]
  double penetration = 0;  ///< factor of δ [X/length]
  double speed = 0;        ///< factor of δ̇ [X·s/length]
  double decaying = 0;     ///< amplitude [length] of a term that dies away …
  double rate = 0;         ///< … at this rate [1/s] ≥ 0
};

/// Between two events a contact is in one branch of its law.
struct Branch {
  /// The bodies push (or pull): an impact is under way and its time counts. While not touching F = 0.
  bool touching = false;
  /// F = base + stiffness δ + damping δ̇. Otherwise the force is a smooth function that only force() knows.
  bool linear = true;
  double base = 0;       ///< [force]
  double stiffness = 0;  ///< [force/length]
  double damping = 0;    ///< [force·s/length]
  static constexpr std::size_t most_guards = 3;
  std::size_t guard_count = 0;
  Guard guards[most_guards] = {};  ///< what ends the branch: the first to fail; if several at once, the first listed

  /// Branch 0 of every law.
  [[nodiscard]] static Branch apart() { return Branch{}.guarded_by({{.penetration = -1}}); }

  [[nodiscard]] Branch guarded_by(std::initializer_list<Guard> list) const {
    Branch branch = *this;
    for (const Guard& guard : list) branch.guards[branch.guard_count++] = guard;
    return branch;
  }
};

/// A quantity a law works with, for the reader of a summary: what was given and what followed from it.
using LawParameters = std::vector<std::pair<std::string_view, double>>;

/// Rules of the family of contact laws (docs/theory/contact.md):
///   δ [length] penetration = −opening.   δ̇ [length/s] closing speed, > 0 while closing.
///   F [force] pushes the left building to the left and the right one to the right (3-2).
///   F = 0 while not touching; F ≥ 0, but for a law that says that it can pull. δ is measured from the gap surface.
///   An isolated impact never gains energy. No law sees a time step.
/// A law is a machine of branches: in each the force is one smooth function of (δ, δ̇), and guards, linear in (δ, δ̇),
/// say when the next one begins. Branch 0 is apart: F = 0, guarded by −δ ≥ 0. Laws are immutable; one may serve many
/// points, each with its own ContactState.
class ContactLaw {
 public:
  virtual ~ContactLaw() = default;

  /// The name a case gives it by, e.g. "linear".
  [[nodiscard]] virtual std::string_view name() const noexcept = 0;

  /// What it works with, e.g. {"stiffness", k}, {"damping_ratio", ξ}, {"damping", c}.
  [[nodiscard]] virtual LawParameters parameters() const = 0;

  /// The branch a contact is in.
  [[nodiscard]] virtual Branch branch(const ContactState& state) const noexcept = 0;

  /// The state after guard number `guard` of its branch has come down to zero at `time` [s], at the given δ and δ̇.
  /// A law sets `branch`, `since`, and what it wants to remember; `closing_speed` where a contact begins.
  [[nodiscard]] virtual ContactState next(const ContactState& state, std::size_t guard, double time, double penetration,
                                          double closing_speed) const noexcept = 0;

  /// F [force] at penetration δ [length] and closing speed δ̇ [length/s] in the branch of `state`. Pure; NaN in gives
  /// NaN out. A linear branch needs no formula of its own.
  [[nodiscard]] virtual double force(const ContactState& state, double penetration,
                                     double closing_speed) const noexcept;

  /// Energy [force·length] that the contact would give back if it were unloaded slowly from here; 0 in branch 0.
  [[nodiscard]] virtual double stored_energy(const ContactState& state, double penetration) const noexcept = 0;

  /// Whether the force depends on the closing speed at the start of the contact. Such a law is told of no speed below
  /// 10⁻⁹ of those at the point: from rest it would have nothing to go by.
  [[nodiscard]] virtual bool needs_closing_speed() const noexcept { return false; }

  /// e, for the law of an impact that takes no time (δ̇⁺ = −e δ̇⁻, momentum kept); nothing for laws with a force.
  /// A solver then changes the velocities itself; branch 1 of such a law is resting contact: the opening stays zero
  /// and the force is what it takes, until it would have to pull.
  [[nodiscard]] virtual std::optional<double> restitution() const noexcept { return std::nullopt; }
};

}  // namespace bentur
