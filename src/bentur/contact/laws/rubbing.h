#pragma once

#include "bentur/contact/law.h"
#include "bentur/elements/coupled_law.h"

namespace bentur {

/// Bodies that push by a contact law and rub along one another meanwhile: δ penetration, s slip [length].
///
///   sticks: F_t = k_t (s − s₀), |F_t| ≤ μ F_n;   slides in direction κ = ±1: F_t = κ μ F_n(δ, δ̇).               (P-11)
///
/// F_n [force] ≥ 0 is that of the law, μ [-] ≥ 0 the friction, k_t [force/length] > 0 the tangential stiffness. It is
/// plasticity with a moving limit: with s_p = s − F_t/k_t, sliding goes on while κ ṡ_p ≥ 0, which never makes energy.
///   sticks while μ F_n − F_t ≥ 0 and μ F_n + F_t ≥ 0;   slides while κ ṡ − (μ/k_t) dF_n/dt ≥ 0.                 (P-12)
/// A push begins sticking, s₀ = s. Where F_n grows from zero both guards start at zero, and it slides at once in the
/// direction of ṡ if k_t |ṡ| > μ dF_n/dt (P-13). Where sliding ends s₀ = s − κ μ F_n/k_t, and the guard of that
/// direction starts with a second-order zero (P-14). When the push ends nothing is left to be remembered.
/// Lost is ∫ μ F_n |ṡ_p| dt, in the spring F_t²/(2 k_t) (P-15). docs/theory/contact.md
class Rubbing final : public CoupledLaw {
 public:
  /// @throws InvalidParameter unless friction ≥ 0 and tangential_stiffness > 0, both finite, and the law is one that
  ///   takes friction.
  Rubbing(std::shared_ptr<const ContactLaw> normal, double friction, double tangential_stiffness);

  /// Whether a law takes friction: its force has straight branches, never pulls, and surfaces do not creep.
  [[nodiscard]] static bool takes_friction(const ContactLaw& normal);

  [[nodiscard]] std::string_view name() const noexcept override { return "rubbing"; }
  [[nodiscard]] Eigen::Index size() const noexcept override { return 2; }
  [[nodiscard]] bool same_as(const CoupledLaw& other) const override;
  [[nodiscard]] CoupledState begin(const Eigen::VectorXd& deformation) const override;
  [[nodiscard]] CoupledBranch branch(const CoupledState& state) const override;
  [[nodiscard]] CoupledState next(const CoupledState& state, const CoupledBranch& branch, std::size_t guard,
                                  double time, const CoupledMotion& motion) const override;
  [[nodiscard]] CoupledState settle(const CoupledState& state, double time, const CoupledMotion& motion) const override;
  [[nodiscard]] CoupledState at(const CoupledState& state, const Eigen::VectorXd& deformation) const override;
  /// Of the law of F_n alone; what the spring along it holds depends on speeds: stored_along().
  [[nodiscard]] double stored_energy(const CoupledState& state, const Eigen::VectorXd& deformation) const override;
  [[nodiscard]] double lost_energy(const CoupledState& state, const Eigen::VectorXd& deformation) const override;
  [[nodiscard]] bool is_odd() const noexcept override { return false; }

  [[nodiscard]] const ContactLaw& normal() const { return *normal_; }
  [[nodiscard]] double friction() const { return friction_; }
  [[nodiscard]] double tangential_stiffness() const { return tangential_stiffness_; }
  /// Where the law of F_n stands.
  [[nodiscard]] LawState normal_state(const CoupledState& state) const;
  /// The state of bodies that are closed but do not push, until δ is back at zero; what is dented is so no more where
  /// they did. And back in that of bodies that are apart.
  [[nodiscard]] CoupledState passed(const CoupledState& state, double time) const;
  [[nodiscard]] CoupledState returned(const CoupledState& state) const;
  /// κ of what slides; 0: it does not.
  [[nodiscard]] int slides(const CoupledState& state) const;
  /// F_t²/(2 k_t) [force·length], of a force along.
  [[nodiscard]] double stored_along(double force) const { return 0.5 * force * force / tangential_stiffness_; }

 private:
  enum class Friction { none, sticks, slides_up, slides_down, passed };
  struct Phase {
    Friction friction = Friction::none;
    double origin = 0;  ///< s₀ [length]
    // How the guards of what sticks start, at the beginning of the branch alone:
    bool grows = false;  ///< F_n from zero
    int slid = 0;        ///< κ of what ended
    int zeros = 0;       ///< of the guard of that direction
    LawState normal;
  };
  [[nodiscard]] static int sense_of(Friction friction);
  [[nodiscard]] static Friction sliding(double sense);
  [[nodiscard]] static CoupledState state_of(const Phase& phase);
  [[nodiscard]] static Phase phase_of(const CoupledState& state);
  void change_normal(Phase& phase, const Branch& before, std::size_t guard, double time,
                     const CoupledMotion& motion) const;
  void stick(Phase& phase, const Branch& normal, const CoupledMotion& motion) const;

  std::shared_ptr<const ContactLaw> normal_;
  double friction_{};              // μ [-]
  double tangential_stiffness_{};  // k_t [force/length]
};

}  // namespace bentur
