#pragma once

#include <optional>
#include <vector>

#include "bentur/solve/engine/run/account/balance.h"
#include "bentur/solve/engine/run/account/energy_account.h"
#include "bentur/solve/engine/run/run.h"
#include "bentur/solve/engine/run/sampler.h"
#include "bentur/solve/engine/run/tracer.h"

namespace bentur::engine {

/// The response with contact.
class PoundingRun final : public Run {
 public:
  /// No gap closes before the segment `first_contact`.
  PoundingRun(const Setup& setup, const Elements::Scales& scales, long first_contact, const RunOptions& options);

  /// Keeps the course as well, unless its motion is so fast that to follow it would take too many steps.
  void trace(Tracer tracer) { tracer_.emplace(std::move(tracer)); }

  std::optional<Tracer>& tracer() { return tracer_; }
  Sampler& sampler() { return sampler_; }
  std::optional<EnergyAccount>& energy() { return energy_; }
  [[nodiscard]] const MomentumBalance& momentum() const { return momentum_; }
  std::vector<Change>& changes() { return changes_; }

 private:
  [[nodiscard]] Eigen::Index quiet(Eigen::Index count) override;
  void take_step(double time, double cut) override;
  void changed(double time) override;
  void before_change(double time, Islands& islands) override;
  [[nodiscard]] bool settle_before(long segment) override { return segment <= first_contact_; }
  [[nodiscard]] bool notes_flights() const override;
  void pass(double start, const Flights& flights, std::size_t halvings) override;
  void follow(double time, double cut, const std::vector<GroundInput>& inputs);

  long first_contact_;
  Sampler sampler_;
  std::optional<Tracer> tracer_;
  long followed_ = 0;  ///< steps of the course
  State sampled_;      ///< scratch
  std::optional<EnergyAccount> energy_;
  MomentumBalance momentum_;
  bool keeps_changes_;
  std::vector<Change> changes_;
};

}  // namespace bentur::engine
