#pragma once

#include <Eigen/Core>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "bentur/solve/engine/motion/modal_system.h"
#include "bentur/solve/engine/motion/time_grid.h"
#include "bentur/solve/tangent/tangent.h"

namespace bentur::engine {

/// What (T-1) has of every number that varies, by central differences of the assembled systems, in the modes of the
/// system between them:
///   q̈ = −Ω² q − D q̇ + γ a_g + Σ push F,   Φᵀ M_p Φ q̈ + Φᵀ C_p Φ q̇ + Φᵀ K_p Φ q + Φᵀ load_p a_g  on its left side.
class Dependence {
 public:
  /// Of no number.
  Dependence(const System& system, const ModalSystem& modal);
  /// @param variations of which trouble_of() knows none
  Dependence(const System& system, const ModalSystem& modal, const std::vector<Variation>& variations);

  struct OfBody {
    std::vector<Eigen::Index> parameters;  ///< whose matrices or load these are
    Eigen::MatrixXd matrices;              ///< −[M_p K_p C_p load_p] of each, one above the other
  };
  /// How a row over all coordinates, and what its force pushes, change with a number: of contacts that it moves.
  struct OfRow {
    Eigen::Index parameter = 0;
    Eigen::VectorXd row, push;
  };
  [[nodiscard]] Eigen::Index count() const { return count_; }
  [[nodiscard]] const OfBody& body(std::size_t body) const { return bodies_[body]; }
  [[nodiscard]] const Eigen::MatrixXd& initial_q() const { return initial_q_; }
  [[nodiscard]] const Eigen::MatrixXd& initial_v() const { return initial_v_; }
  [[nodiscard]] const Eigen::MatrixXd& offsets() const { return offsets_; }  ///< of δ, elements × parameters
  /// Of an element: only of the numbers that move it.
  [[nodiscard]] const std::vector<OfRow>& rows(Eigen::Index element) const { return rows_[element]; }
  [[nodiscard]] const Eigen::MatrixXd& nu() const { return nu_; }  ///< components × parameters
  [[nodiscard]] bool moves_nu() const { return moves_nu_; }

  /// Laws of an element with a little less and a little more of a number, and how much that is.
  struct Laws {
    const Law *below, *above;
    double step;
  };
  [[nodiscard]] Laws laws(Eigen::Index element, Eigen::Index parameter) const;

  /// Of the inputs at the start of a segment, which begins at a time [s]: values and slopes, a row per body and
  /// component.
  /// @return whether some are not zero
  bool inputs(long segment, double time, const std::vector<GroundInput>& inputs, Eigen::MatrixXd& values,
              Eigen::MatrixXd& slopes) const;
  /// How much later the motion reaches a body, per parameter; empty: none does.
  [[nodiscard]] const Eigen::MatrixXd& delays() const { return delays_; }  ///< bodies × parameters
  [[nodiscard]] bool moves_delays() const { return moves_delays_; }

 private:
  void take_bodies(const System& system, const ModalSystem& modal, const Variation& by, Eigen::Index parameter);
  void take_motion(const System& system, const Variation& by, Eigen::Index parameter);
  void take_rows(const System& system, const ModalSystem& modal, const Variation& by, Eigen::Index parameter);

  Eigen::Index count_ = 0;
  const std::vector<Variation>* variations_ = nullptr;
  const System* system_;
  std::vector<OfBody> bodies_;
  std::vector<std::vector<OfRow>> rows_;
  Eigen::MatrixXd initial_q_, initial_v_, offsets_, nu_, delays_;
  /// Of what changes samples or amplitudes.
  struct Moved {
    Eigen::Index parameter = 0;
    double step = 0;
    std::unique_ptr<TimeGrid> below, above;  // null: harmonic
  };
  std::vector<Moved> moved_;
  bool moves_delays_ = false, moves_nu_ = false;
};

/// Why a number's systems cannot be followed; nothing: they can.
[[nodiscard]] std::optional<std::string> trouble_of(const System& system, const Variation& by);

}  // namespace bentur::engine
