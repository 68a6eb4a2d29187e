#pragma once

#include <pybind11/pybind11.h>

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "bentur/contact/law.h"

namespace bentur::python {

/// A contact law whose force is a Python function F(δ, δ̇), called while the floors touch; what it gives below zero
/// counts as zero. It is solved as any force that is not linear is. An exception ends the run: the force is then NaN,
/// and error() tells what it was.
class ForceLaw final : public ContactLaw {
 public:
  /// @param energy a function of δ: what the contact would give back; None: the work of F(δ, 0)
  ForceLaw(std::string name, pybind11::function force, pybind11::object energy)
      : name_(std::move(name)), force_(std::move(force)), energy_(std::move(energy)) {}
  ~ForceLaw() override;

  [[nodiscard]] std::string_view name() const noexcept override { return name_; }
  [[nodiscard]] LawParameters parameters() const override { return {}; }
  [[nodiscard]] Branch branch(const LawState& state) const noexcept override;
  [[nodiscard]] double force(const LawState& state, double penetration, double closing_speed) const noexcept override;
  [[nodiscard]] double stored_energy(const LawState& state, double penetration) const noexcept override;

  /// Raises what the function has raised, if anything. The lock must be held.
  void rethrow() const;

 private:
  [[nodiscard]] double called(const pybind11::object& function, double penetration, double speed,
                              bool with_speed) const noexcept;

  std::string name_;
  pybind11::function force_;
  pybind11::object energy_;
  mutable pybind11::object error_;
};

/// One branch of a BranchLaw: F = base + stiffness δ + damping δ̇ while every guard is ≥ 0.
struct BranchData {
  bool touching = true;
  double base = 0, stiffness = 0, damping = 0;
  std::vector<Guard> guards;
  std::vector<int> then;           ///< the branch that follows when guard i has failed
  double unloading_stiffness = 0;  ///< [force/length] that energy is given back by; 0: `stiffness`
};

/// A contact law that is branches with guards and nothing else, so that `exact` solves it as its own. Branch 0 is the
/// floors apart; a contact begins in branch 1.
class BranchLaw final : public ContactLaw {
 public:
  /// @throws InvalidParameter unless there are a branch, guards to end it, at most most_guards of them, and branches
  /// that they lead to.
  BranchLaw(std::string name, std::vector<BranchData> branches);

  [[nodiscard]] std::string_view name() const noexcept override { return name_; }
  [[nodiscard]] LawParameters parameters() const override { return {}; }
  [[nodiscard]] Branch branch(const LawState& state) const noexcept override;
  [[nodiscard]] LawState next(const LawState& state, std::size_t guard, double time, double penetration,
                              double closing_speed) const noexcept override;
  [[nodiscard]] double stored_energy(const LawState& state, double penetration) const noexcept override;

 private:
  std::string name_;
  std::vector<BranchData> data_;
  std::vector<Branch> branches_;
};

}  // namespace bentur::python
