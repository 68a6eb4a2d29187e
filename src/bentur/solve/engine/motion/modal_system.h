#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "bentur/solve/engine/motion/kernels/rows.h"
#include "bentur/solve/engine/motion/time_grid.h"
#include "bentur/solve/problem.h"

namespace bentur::engine {

/// Position and speed of every coordinate.
struct State {
  Eigen::VectorXd q, v;
};

/// What contact points do over a step.
struct ContactForces {
  /// F = base + stiffness δ + damping δ̇; all zero where a point does not press.
  struct Linear {
    double base = 0, stiffness = 0, damping = 0;
  };
  std::vector<Linear> linear;           ///< per point
  std::vector<Eigen::Index> pressing;   ///< points with a linear force
  std::vector<Eigen::Index> resting;    ///< points whose opening stays zero, whatever force it takes
  std::vector<Eigen::Index> nonlinear;  ///< points with a force that no Linear describes
  double fading = 0;                    ///< fastest rate at which a surface comes back [1/s]

  [[nodiscard]] bool none() const { return pressing.empty() && resting.empty() && nonlinear.empty(); }
};

/// All buildings side by side in modal coordinates. The coordinates of one building are its modes followed by its
/// ground displacement u_g(t − τ_b), itself an oscillator of frequency zero driven by +a_g:
///   q̈ = −Ω² q − D q̇ + γ a_g + Σ push_i F_i,   F_i = F(δ_i, δ̇_i),   δ_i = −g_i,   g_i = w_i + sense_i q.   (T-1)
/// Gap widths w are no part of it.
/// Every reported quantity is linear in q (displacement, drift, storey shear) or in q̈ (absolute acceleration).
struct ModalSystem {
  struct Block {
    Eigen::Index begin = 0;        ///< first coordinate of the building
    Eigen::Index size = 0;         ///< modes + 1
    Eigen::Index padded_size = 0;  ///< size as a multiple of four; entries after the last coordinate stay zero
    Eigen::Index floors = 0;
    Eigen::MatrixXd outputs;                 ///< 3 floors × size: displacement, drift ratio, storey shear
    Eigen::MatrixXd outputs_abs;             ///< entry by entry |outputs|
    Eigen::MatrixXd acceleration;            ///< floors × size, applied to q̈
    std::optional<Eigen::MatrixXd> damping;  ///< full D where it is not diagonal
    double half_damping = 0;                 ///< ½ ‖D‖ [1/s]
    double omega_max = 0;                    ///< largest Ω [1/s]
    [[nodiscard]] double rate() const;       ///< growth bound of the building on its own [1/s]
  };
  struct Point {
    Eigen::Index left_begin = 0, left_size = 0, right_begin = 0, right_size = 0;  ///< padded_size of the blocks
    Eigen::VectorXd sense_left, sense_right;  ///< row of (T-1) on each building's coordinates
    Eigen::VectorXd push_left, push_right;    ///< column of (T-1); zero on ground coordinates; empty where watched

    /// sense · x for all coordinates x. Left and right are summed alike, so that two identical buildings that move
    /// alike give exactly zero.
    [[nodiscard]] double sense(const double* x) const {
      return kernels::dot(right_size, sense_right.data(), x + right_begin) +
             kernels::dot(left_size, sense_left.data(), x + left_begin);
    }
    [[nodiscard]] double sense(const Eigen::VectorXd& x) const { return sense(x.data()); }
    /// |sense| · |x|.
    [[nodiscard]] double sense_abs(const double* x) const {
      return kernels::dot_abs(right_size, sense_right.data(), x + right_begin) +
             kernels::dot_abs(left_size, sense_left.data(), x + left_begin);
    }
    [[nodiscard]] double sense_abs(const Eigen::VectorXd& x) const { return sense_abs(x.data()); }
  };

  explicit ModalSystem(const Problem& problem);

  Eigen::Index size = 0;
  Eigen::VectorXd omega_squared;  ///< Ω² [1/s²]
  Eigen::VectorXd two_sigma;      ///< diagonal of D [1/s]
  Eigen::VectorXd gamma;          ///< −φᵀ load for modes, 1 for ground coordinates
  /// 1 for modes, 0 for ground coordinates: these have no mass, so that a sum of squares over both has no dimension.
  Eigen::VectorXd of_mode;
  std::vector<Block> blocks;
  std::vector<Point> points;
  std::vector<Point> watched;  ///< floors that face a neighbour where nothing acts
  Eigen::MatrixXd coupling;    ///< push_i · sense_j [1/mass], points × points
  double nu = 0;               ///< ν of the ground motion [rad/s]
  bool classical = true;       ///< every D is diagonal

  Eigen::VectorXd initial_q, initial_v;

  /// √(v²) over the modes, [length/s] √[mass]; v² is twice the kinetic energy of the buildings' relative motion.
  [[nodiscard]] double speed(const Eigen::VectorXd& v) const { return v.cwiseProduct(of_mode).norm(); }

  /// Growth bound of the power series under the linear and resting forces, r = ½B + √(¼B² + A), A = Ω² + ‖contact
  /// stiffness‖, B = ‖D‖ + ‖contact damping‖: as r² ≥ A + B r, no coefficient exceeds that of e^{rt}. At least ν.
  /// Stiffness and damping of a point may be negative: with S its rows of sense, ‖SᵀDS‖ ≤ ‖ |D|^½ S Sᵀ |D|^½ ‖.
  [[nodiscard]] double rate(const ContactForces& forces) const;

  /// q̈ by (T-1) at the given state, ground input and force of each point [force] (empty: none).
  void acceleration(const State& state, const std::vector<GroundInput>& inputs, const Eigen::VectorXd& forces,
                    Eigen::VectorXd& result) const;

  /// result += push_i F for one point.
  void push(Eigen::Index point, double force, Eigen::VectorXd& result) const;

  /// The forces λ at the given points that change the opening's acceleration there by `missing` [length/s²].
  [[nodiscard]] Eigen::VectorXd forces_for(const std::vector<Eigen::Index>& at, const Eigen::VectorXd& missing) const;

  /// The inputs `dt` later.
  void advance(std::vector<GroundInput>& inputs, double dt) const;
  void advance(GroundInput& input, double dt) const;
};

}  // namespace bentur::engine
