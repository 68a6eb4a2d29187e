#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <memory>
#include <optional>
#include <vector>

#include "bentur/solve/engine/motion/couplings.h"
#include "bentur/solve/engine/motion/kernels/rows.h"
#include "bentur/solve/engine/motion/time_grid.h"
#include "bentur/solve/system.h"

namespace bentur::engine {

/// Position and speed of every coordinate.
struct State {
  Eigen::VectorXd q, v;
};

/// What elements do over a step, beyond what the modes hold of them.
struct ElementForces {
  /// F = base + stiffness δ + damping δ̇; all zero where an element does nothing.
  struct Linear {
    double base = 0, stiffness = 0, damping = 0;
  };
  std::vector<Linear> linear;           ///< per element
  std::vector<Eigen::Index> pressing;   ///< elements with a linear force that is not constant
  std::vector<Eigen::Index> constant;   ///< elements with a constant force, which is in their force coordinate
  std::vector<Eigen::Index> resting;    ///< elements whose δ stays zero, whatever force it takes
  std::vector<Eigen::Index> nonlinear;  ///< elements with a force that no Linear describes
  /// F = base + stiffness δ + damping δ̇ of several elements, whose deformations act on one another.
  struct Coupled {
    Eigen::VectorXd base;                   ///< offsets of δ included: F where all q are zero
    std::shared_ptr<const CoupledSet> set;  ///< whose stiffness and damping these are
    /// The same over what moves of their bodies.
    struct Modal {
      std::vector<Eigen::Index> at;     ///< of ModalSystem::elements, those that move
      Eigen::Index begin = 0;           ///< first coordinate
      Eigen::MatrixXd push;             ///< a column each, over both bodies and what lies between
      Eigen::MatrixXd pull;             ///< forces beyond `base`, a column each: F − base = pullᵀ q
      kernels::PackedRows packed_pull;  ///< the same, a row each
      Eigen::MatrixXd tied;             ///< push · pullᵀ where that is less than both; else empty
      // Norms of what they add and take away, of stiffness and damping [1/s²], [1/s]:
      double stiffer = 0, softer = 0, damped = 0, driven = 0;
    };
    std::shared_ptr<const Modal> modal;
    Eigen::VectorXd steady;  ///< what `base` does to those coordinates

    [[nodiscard]] const std::vector<Eigen::Index>& at() const { return modal->at; }
    [[nodiscard]] const Eigen::MatrixXd& stiffness() const { return set->stiffness; }
    [[nodiscard]] const Eigen::MatrixXd& damping() const { return set->damping; }  ///< empty: none
  };
  std::vector<Coupled> coupled;
  Eigen::VectorXd load;  ///< what the constant ones do to every coordinate …
  bool loaded = false;   ///< … where they do anything
  double fading = 0;     ///< fastest rate at which a surface comes back [1/s]
  double rate = 0;       ///< growth bound of a power series under all of it [1/s], ModalSystem::rate()

  [[nodiscard]] bool none() const {
    return pressing.empty() && constant.empty() && resting.empty() && nonlinear.empty() && coupled.empty();
  }
  [[nodiscard]] const double* load_or_null() const { return loaded ? load.data() : nullptr; }
};

/// All bodies side by side in modal coordinates. The coordinates of one body are its modes, then its ground
/// displacement u_g(t − τ_b) in each component of the motion, an oscillator of frequency zero driven by that of +a_g:
///   q̈ = −Ω² q − D q̇ + γ a_g + Σ push_i F_i,   F_i = F(δ_i, δ̇_i),   δ_i = offset_i + row_i q,             (T-1)
/// and then, for each element of its own that can yield, its force F_i beyond that of K: a coordinate that nothing
/// moves while the force is constant, and that is what the force is otherwise. Offsets (−w of a gap) are no part of the
/// system. So every output is linear in q, q̇ or q̈ (absolute acceleration).
struct ModalSystem {
  struct Block {
    Eigen::Index begin = 0;        ///< first coordinate of the body
    Eigen::Index modes = 0;        ///< the ground coordinates come after them, one per component
    Eigen::Index size = 0;         ///< modes, ground and force coordinates
    Eigen::Index padded_size = 0;  ///< size as a multiple of four; entries after the last coordinate stay zero
    Eigen::Index moving_size = 0;  ///< modes and ground likewise: all that (T-1) moves by itself
    /// Outputs over these coordinates q, their speeds and their accelerations; what is not needed is empty.
    struct Group {
      Eigen::MatrixXd of_position, of_speed, of_acceleration;  ///< outputs × size
      Eigen::VectorXd at_rest;
      bool has_peak = false;
      Outputs::Course course = Outputs::Course::none;
      [[nodiscard]] Eigen::Index count() const { return at_rest.size(); }
      using Coordinates = Eigen::Ref<const Eigen::MatrixXd>;
      /// The outputs at instants, a column each; `a` is not looked at where they have no part of it.
      void evaluate(const Coordinates& q, const Coordinates& v, const Coordinates& a,
                    Eigen::Ref<Eigen::MatrixXd> result) const;
    };
    std::vector<Group> outputs;              ///< as Body::outputs
    std::optional<Eigen::MatrixXd> damping;  ///< full D where it is not diagonal
    double half_damping = 0;                 ///< ½ ‖D‖ [1/s]
    double omega_max = 0;                    ///< largest Ω [1/s]
    [[nodiscard]] double rate() const;       ///< growth bound of the body on its own [1/s]
  };
  /// δ as a row over the coordinates of one body or of two, and what a unit force does to them.
  struct Relation {
    Eigen::Index left = 0, right = 0;  ///< bodies; the same one where there is one alone
    Eigen::Index left_begin = 0, left_size = 0, right_begin = 0, right_size = 0;  ///< moving_size of the blocks, or 0
    Eigen::VectorXd left_row, right_row;
    Eigen::VectorXd left_push, right_push;  ///< columns of (T-1), zero on ground coordinates; empty where watched

    /// row · x for all coordinates x. Left and right are summed alike, so that two identical bodies that move alike
    /// give exactly zero.
    [[nodiscard]] double along(const double* x) const {
      return kernels::dot(right_size, right_row.data(), x + right_begin) +
             kernels::dot(left_size, left_row.data(), x + left_begin);
    }
    [[nodiscard]] double along(const Eigen::VectorXd& x) const { return along(x.data()); }
    /// δ so many times, as what is watched.
    [[nodiscard]] Relation times(double factor) const;
    // As one list, over the coordinates of both bodies and of what lies between them:
    [[nodiscard]] Eigen::Index size() const {
      return right_size > 0 ? right_begin + right_size - left_begin : left_size;
    }
    static void spread(const Eigen::VectorXd& left, const Eigen::VectorXd& right, Eigen::Ref<Eigen::VectorXd> to) {
      to.tail(to.size() - left.size()).setZero();
      to.head(left.size()) = left;
      if (right.size() > 0) to.tail(right.size()) += right;
    }
    /// |row| · |x|.
    [[nodiscard]] double along_abs(const double* x) const {
      return kernels::dot_abs(right_size, right_row.data(), x + right_begin) +
             kernels::dot_abs(left_size, left_row.data(), x + left_begin);
    }
    [[nodiscard]] double along_abs(const Eigen::VectorXd& x) const { return along_abs(x.data()); }
  };
  /// An element without its law.
  struct Element {
    Relation relation;
    double stiffness = 0;        ///< that the modes hold of it [force/length]
    double tangent_damping = 0;  ///< its dashpot in D is this times its stiffness [s], and follows it
    Eigen::Index force = -1;     ///< its force coordinate; −1: it has none
  };

  /// Those of `elements` that are the deformations of one element of several.
  struct Coupled {
    Eigen::Index first = 0, count = 0;
  };

  explicit ModalSystem(const System& of);

  Eigen::Index size = 0;
  Eigen::VectorXd omega_squared;  ///< Ω² [1/s²]
  Eigen::VectorXd two_sigma;      ///< diagonal of D [1/s]
  Eigen::MatrixXd gamma;  ///< per component, a column each: −φᵀ load for modes, 1 for its ground coordinates
  /// 1 for modes, 0 for ground coordinates: these have no mass, so that a sum of squares over both has no dimension.
  Eigen::VectorXd of_mode;
  std::vector<Block> blocks;
  /// Contacts, joints and limits as System has them, the bodies' own elements; then those that are coupled: the bodies'
  /// own ones and, of two deformations each, what rubs.
  std::vector<Element> elements;
  std::vector<Coupled> coupled;  ///< in the order of the bodies, then what rubs
  Eigen::Index switched = 0;     ///< contacts: the first ones, which the free response leaves out
  Eigen::Index rubbing = 0;      ///< how many rub, which it leaves out too
  Eigen::Index rubs = 0;         ///< where they begin
  Eigen::Index joints = 0;       ///< how many come after them
  Eigen::Index members = 0;      ///< where the bodies' own elements begin
  Eigen::Index alone = 0;        ///< how many elements are not coupled: the first ones
  std::vector<Relation> watched, watched_free;
  /// δ of joints, and then −δ: how far they close and open. After them δ and −δ of each member that yields unevenly.
  std::vector<Relation> spans;
  /// Contacts are points: those of one deformation, then those that rub.
  [[nodiscard]] Eigen::Index points() const { return switched + rubbing; }
  /// The element that opens and closes at a point.
  [[nodiscard]] Eigen::Index opening(Eigen::Index point) const {
    return point < switched ? point : rubs + 2 * (point - switched);
  }
  /// The joint that System::joints has at this place, as an element.
  [[nodiscard]] Eigen::Index joint(Eigen::Index number) const { return switched + number; }
  Couplings coupling;          ///< −push_i · row_j [1/mass]
  std::vector<double> nu;      ///< ν of the ground motion, per component [rad/s]
  bool classical = true;       ///< every D is diagonal
  bool ground_counts = false;  ///< some δ has a part of the ground's displacement

  Eigen::VectorXd initial_q, initial_v;

  /// √(v²) over the modes, [length/s] √[mass]; v² is twice the kinetic energy of the bodies' relative motion.
  [[nodiscard]] double speed(const Eigen::VectorXd& v) const { return v.cwiseProduct(of_mode).norm(); }

  /// Growth bound of the power series under the linear and resting forces, r = ½B + √(¼B² + A), A ≥ ‖Ω² + stiffness of
  /// elements‖, B ≥ ‖D + their damping‖: as r² ≥ A + B r, no coefficient exceeds that of e^{rt}. At least ν. Nothing
  /// more is assumed: no matrix has to be symmetric or positive. What makes softer makes none larger than it was: with
  /// X ≥ 0 and Y ≤ 0, symmetric, and any Z added, the norm is max(‖Ω²‖ + ‖X‖, ‖Y‖) + ‖Z‖ at most.              (T-7)
  [[nodiscard]] double rate(const ElementForces& forces) const;
  /// The same of some bodies under the linear forces of some elements between them, in ascending order.
  [[nodiscard]] double rate(const std::vector<Eigen::Index>& bodies, const std::vector<Eigen::Index>& pressing,
                            const std::vector<ElementForces::Linear>& linear) const;

  /// What some coupled elements of the same bodies do to them, by their stiffness and damping (empty: none).
  [[nodiscard]] ElementForces::Coupled::Modal modal_of(const std::vector<Eigen::Index>& at,
                                                       const Eigen::MatrixXd& stiffness,
                                                       const Eigen::MatrixXd& damping) const;

  [[nodiscard]] Eigen::Index components() const { return gamma.cols(); }
  /// The largest ν [rad/s].
  [[nodiscard]] double fastest_input() const { return *std::max_element(nu.begin(), nu.end()); }
  /// The ground coordinates of a body among all.
  [[nodiscard]] Eigen::Index ground_of(std::size_t block) const { return blocks[block].begin + blocks[block].modes; }

  /// Those of one body among the inputs of all, one per component.
  [[nodiscard]] const GroundInput* of_body(const std::vector<GroundInput>& inputs, std::size_t block) const {
    return inputs.data() + static_cast<Eigen::Index>(block) * components();
  }

  /// q̈ by (T-1) at the given state, ground input and force of each element [force] (empty: none).
  void acceleration(const State& state, const std::vector<GroundInput>& inputs, const Eigen::VectorXd& forces,
                    Eigen::VectorXd& result) const;

  /// δ (from `offsets`) and δ̇ of some elements.
  [[nodiscard]] Eigen::VectorXd deformations(const std::vector<Eigen::Index>& at, const std::vector<double>& offsets,
                                             const Eigen::VectorXd& q) const;
  [[nodiscard]] Eigen::VectorXd speeds(const std::vector<Eigen::Index>& at, const Eigen::VectorXd& v) const;
  /// Makes the force coordinates of coupled elements what their springs' forces are.
  void fill_forces(const ElementForces::Coupled& of, State& state) const;

  /// result += push_i F for one element.
  void push(Eigen::Index element, double force, Eigen::VectorXd& result) const;
  /// The same for coupled ones at a state.
  void push(const ElementForces::Coupled& of, const State& state, Eigen::VectorXd& result) const;

  /// What the force coordinates of a state do to the coordinates of one body, or of all: `load` is written there.
  /// Null where they do nothing.
  const double* load_of(std::size_t block, const double* q, Eigen::VectorXd& load) const;
  const double* load_of(const double* q, Eigen::VectorXd& load) const;

  /// The forces λ of the given elements that change δ̈ there by −`missing` [length/s²].
  [[nodiscard]] Eigen::VectorXd forces_for(const std::vector<Eigen::Index>& at, const Eigen::VectorXd& missing) const;

  /// The inputs `dt` later: of all bodies, or of one.
  void advance(std::vector<GroundInput>& inputs, double dt) const;
  void advance(GroundInput* input, double dt) const;
};

}  // namespace bentur::engine
