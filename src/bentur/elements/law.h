#pragma once

#include <array>
#include <cstddef>
#include <initializer_list>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

namespace bentur {

/// Where one element stands in its law. A law reads and writes it, a solver carries it, one per element.
struct LawState {
  int branch = 0;                   ///< number of the law's branch; 0: nothing has happened yet, or is remembered
  double since = 0;                 ///< when the branch began [s]
  double closing_speed = 0;         ///< of a contact, v₀: δ̇ at its start, kept until it ends [length/s]
  std::array<double, 25> memory{};  ///< the law's own, each in a unit of its own
};

/// A branch lasts while  constant + deformation δ + speed δ̇ + decaying exp(−rate (t − since)) ≥ 0.
///
/// Zero belongs to the branch: it ends where the sum becomes negative, and a sum that only touches zero ends nothing.
/// A solver lets it go below zero by round-off: 2⁻⁴⁶ of the displacements and speeds that δ and δ̇ are differences of,
/// each times its factor, and of `constant`. The guard δ ≥ 0 alone of a touching branch has no such tolerance.
/// All terms have one dimension [X], which the law chooses, but it is [length] where a term decays.
struct Guard {
  double constant = 0;     ///< [X]
  double deformation = 0;  ///< factor of δ [X/length]
  double speed = 0;        ///< factor of δ̇ [X·s/length]
  double decaying = 0;     ///< amplitude [length] of a term that dies away …
  double rate = 0;         ///< … at this rate [1/s] ≥ 0
};

/// Whether an element stands for two bodies that may touch: impacts are noted of those alone.
enum class Bodies { none, apart, touching };

/// Between two events an element is in one branch of its law.
struct Branch {
  /// Touching bodies push (or pull): an impact is under way and its time counts.
  Bodies bodies = Bodies::none;
  /// F = base + stiffness δ + damping δ̇. Otherwise the force is a smooth function that only force() knows.
  bool linear = true;
  double base = 0;       ///< [force]
  double stiffness = 0;  ///< [force/length]
  double damping = 0;    ///< [force·s/length]
  static constexpr std::size_t most_guards = 3;
  std::size_t guard_count = 0;
  Guard guards[most_guards] = {};  ///< what ends the branch: the first to fail; if several at once, the first listed

  /// Bodies that do not touch, branch 0 of every contact law: F = 0 while −δ ≥ 0.
  [[nodiscard]] static Branch apart() { return Branch{.bodies = Bodies::apart}.guarded_by({{.deformation = -1}}); }
  [[nodiscard]] bool touching() const { return bodies == Bodies::touching; }

  [[nodiscard]] Branch guarded_by(std::initializer_list<Guard> list) const {
    Branch branch = *this;
    for (const Guard& guard : list) branch.guards[branch.guard_count++] = guard;
    return branch;
  }
};

/// A quantity a law works with, for the reader of a summary: what was given and what followed from it.
using LawParameters = std::vector<std::pair<std::string_view, double>>;

/// The force of one element as a function of its deformation: δ [length], δ̇ [length/s] its speed, F [force] positive
/// where it works against δ > 0. A law is a machine of branches: in each the force is one smooth function of (δ, δ̇),
/// and guards, linear in (δ, δ̇), say when the next one begins. No law sees a time step. Laws are immutable; one may
/// serve many elements, each with its own LawState. (docs/theory/elements.md)
class Law {
 public:
  virtual ~Law() = default;

  /// The name a case gives it by, e.g. "linear".
  [[nodiscard]] virtual std::string_view name() const noexcept = 0;

  /// What it works with, e.g. {"stiffness", k}, {"yield_force", F_y}.
  [[nodiscard]] virtual LawParameters parameters() const = 0;

  /// The branch an element is in.
  [[nodiscard]] virtual Branch branch(const LawState& state) const noexcept = 0;

  /// The state after guard number `guard` of its branch has come down to zero at `time` [s], at the given δ and δ̇.
  /// A law sets `branch`, `since`, and what it wants to remember; `closing_speed` where a contact begins.
  [[nodiscard]] virtual LawState next(const LawState& state, std::size_t guard, double time, double deformation,
                                      double speed) const noexcept = 0;

  /// F [force] at deformation δ [length] and speed δ̇ [length/s] in the branch of `state`. Pure; NaN in gives NaN out.
  /// A linear branch needs no formula of its own.
  [[nodiscard]] virtual double force(const LawState& state, double deformation, double speed) const noexcept;

  /// Energy [force·length] that the element would give back if it were unloaded slowly from here.
  [[nodiscard]] virtual double stored_energy(const LawState& state, double deformation) const noexcept = 0;

  /// Whether the force depends on the closing speed at the start of a contact. Such a law gets no speed below
  /// 10⁻⁹ of those at the point: from rest it would have nothing to go by.
  [[nodiscard]] virtual bool needs_closing_speed() const noexcept { return false; }

  /// e, for the law of an impact that takes no time (δ̇⁺ = −e δ̇⁻, momentum kept); nothing for laws with a force.
  /// A solver then changes the velocities itself; branch 1 of such a law is resting contact: δ stays zero and the
  /// force is what it takes, until it would have to pull.
  [[nodiscard]] virtual std::optional<double> restitution() const noexcept { return std::nullopt; }

  /// Whether the opposite course of δ from rest gives the opposite force: F of −δ(t) is −F of δ(t).
  [[nodiscard]] virtual bool is_odd() const noexcept { return false; }

  /// Whether s times the course of δ gives s times the force, for any s > 0: no length or force is its own.
  [[nodiscard]] virtual bool is_homogeneous() const noexcept { return false; }

  /// Whether nothing can go on once branch 0 has ended.
  [[nodiscard]] virtual bool is_limit() const noexcept { return false; }
};

/// What has become of the strength of a law that can lose it.
struct StrengthLoss {
  std::optional<double> capped;    ///< when its force first fell while the deformation grew [s]
  std::optional<double> residual;  ///< when it first was down to its residual strength [s]
  std::optional<double> failed;    ///< when it was gone [s]
  double left = 1;                 ///< of the largest force, what the weaker side can still reach [-], 0 … 1
};

/// A law that yields: of a storey, a bearing or a link. It begins on a line of its initial stiffness.
class HystereticLaw : public Law {
 public:
  /// k of the line it begins on [force/length] > 0.
  [[nodiscard]] virtual double initial_stiffness() const noexcept = 0;
  /// Δ_y, where that line ends on the side Δ > 0 [length] > 0.
  [[nodiscard]] virtual double yield_deformation() const noexcept = 0;
  /// The same on the side Δ < 0 [length] > 0.
  [[nodiscard]] virtual double yield_deformation_below() const noexcept { return yield_deformation(); }
  /// Both are not the same, so that a ductility demand needs the extrema of both sides.
  [[nodiscard]] bool yields_unevenly() const noexcept { return yield_deformation() != yield_deformation_below(); }
  /// Where it would come to rest if it were unloaded slowly from here, Δ − V/k_u [length].
  [[nodiscard]] virtual double residual(const LawState& state, double deformation) const noexcept = 0;
  /// Nothing of a law that keeps its strength.
  [[nodiscard]] virtual std::optional<StrengthLoss> loss(const LawState& /*state*/,
                                                         double /*deformation*/) const noexcept {
    return std::nullopt;
  }
};

}  // namespace bentur
