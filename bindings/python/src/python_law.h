#pragma once

#include <pybind11/pybind11.h>

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "bentur/contact/own_law.h"

namespace bentur::python {

/// A law of Python's own, in the place of a law's name in a case, with what Python gave it as.
struct PyLaw final : OwnLaw {
  PyLaw(const std::string& of, pybind11::object as) : OwnLaw(of), given(std::move(as)) {}
  ~PyLaw() override;

  pybind11::object given;
};

/// A bentur.ForceLaw or bentur.BranchLaw, as a case takes it. @throws InvalidParameter where a listed law has its name.
[[nodiscard]] std::shared_ptr<const OwnLaw> own_law(const pybind11::object& given);

/// What a function of a law has raised in this thread, if anything, is raised again. The lock must be held.
void rethrow_of_laws();
[[nodiscard]] bool law_has_raised() noexcept;

/// A function of one or two numbers that Python gave: one of its own, or compiled.
struct Callable {
  pybind11::object given;
  const void* code = nullptr;  ///< double (double) or double (double, double); null: it is Python's
};

/// A contact law whose force is a function F(δ, δ̇), called while the floors touch; what it gives below zero
/// counts as zero. It is solved as any force that is not linear is. An exception ends the run: from then on the force
/// is NaN in this thread, and rethrow_of_laws() tells why.
class ForceLaw final : public ContactLaw {
 public:
  /// @param energy a function of δ: what the contact would give back; None: the work of F(δ, 0)
  ForceLaw(std::string name, Callable force, Callable energy)
      : name_(std::move(name)), force_(std::move(force)), energy_(std::move(energy)) {}
  ~ForceLaw() override;

  [[nodiscard]] std::string_view name() const noexcept override { return name_; }
  [[nodiscard]] LawParameters parameters() const override { return {}; }
  [[nodiscard]] Branch branch(const LawState& state) const noexcept override;
  [[nodiscard]] double force(const LawState& state, double penetration, double closing_speed) const noexcept override;
  [[nodiscard]] double stored_energy(const LawState& state, double penetration) const noexcept override;

 private:
  [[nodiscard]] double called(const pybind11::object& function, double penetration, double speed,
                              bool with_speed) const noexcept;

  std::string name_;
  Callable force_, energy_;
};

/// One branch of a BranchLaw: F = base + stiffness δ + damping δ̇ while every guard is ≥ 0.
struct BranchData {
  /// A guard ≥ 0 whose sum has a term force·F besides, and the branch that follows once it has failed.
  struct End {
    Guard guard;
    double force = 0;  ///< [X/force]
    int then = 0;
  };

  bool touching = true;        ///< of a contact
  std::optional<double> base;  ///< [force]; nothing: F goes on from where the branch before has ended
  double stiffness = 0, damping = 0;
  double unloading_stiffness = 0;  ///< [force/length] that energy is given back by; 0: `stiffness`
  std::vector<End> ends = {};
};

/// A law that is branches and nothing else, so that `exact` solves it as its own. Branches count from 1. A contact
/// begins in branch 1, and 0 is the floors apart; a link or storey is in branch 1 from the start. Memory: 0 the base of
/// a branch that goes on from another. Base: ContactLaw, Law or HystereticLaw.
template <class Base>
class BranchLaw : public Base {
 public:
  /// @throws InvalidParameter unless there is a branch, with guards to end it where it is a contact's, at most
  /// most_guards of them, and branches that they lead to.
  BranchLaw(std::string name, std::vector<BranchData> branches);

  [[nodiscard]] std::string_view name() const noexcept override { return name_; }
  [[nodiscard]] LawParameters parameters() const override { return {}; }
  [[nodiscard]] Branch branch(const LawState& state) const noexcept override;
  [[nodiscard]] LawState next(const LawState& state, std::size_t guard, double time, double deformation,
                              double speed) const noexcept override;
  [[nodiscard]] double stored_energy(const LawState& state, double deformation) const noexcept override;

 protected:
  [[nodiscard]] const BranchData* data(const LawState& state) const noexcept;
  [[nodiscard]] static double unloading_stiffness(const BranchData& now) noexcept;

 private:
  std::string name_;
  std::vector<BranchData> data_;
};

/// The law of a storey, whose branches are in units of its yield force and yield deformation.
class StoreyLaw final : public BranchLaw<HystereticLaw> {
 public:
  /// @throws InvalidParameter as BranchLaw, and unless branch 1 has base 0, stiffness 1 and no damping.
  StoreyLaw(std::string name, std::vector<BranchData> branches, double stiffness, double yield_force);

  [[nodiscard]] double initial_stiffness() const noexcept override { return stiffness_; }
  [[nodiscard]] double yield_deformation() const noexcept override { return yield_deformation_; }
  [[nodiscard]] double residual(const LawState& state, double deformation) const noexcept override;

 private:
  double stiffness_, yield_deformation_;
};

}  // namespace bentur::python
