#pragma once

#include <optional>
#include <vector>

#include "bentur/solve/engine/run/contacts.h"
#include "bentur/solve/engine/run/energy_account.h"
#include "bentur/solve/engine/run/gap_monitor.h"
#include "bentur/solve/engine/run/run.h"
#include "bentur/solve/engine/run/sampler.h"

namespace bentur::engine {

/// The response with contact.
class PoundingRun final : public Run {
 public:
  /// No gap closes before the segment `first_contact`.
  PoundingRun(const Setup& setup, const Contacts::Scales& scales, long first_contact, const SolveOptions& options);

  Contacts& contacts() { return contacts_; }
  Sampler& sampler() { return sampler_; }
  std::optional<EnergyAccount>& energy() { return energy_; }

 private:
  [[nodiscard]] const ContactForces& forces() const override { return contacts_.forces(); }
  [[nodiscard]] const ForceFunction& force_at() const override { return force_at_; }
  [[nodiscard]] bool may_fly() const override { return contacts_.all_apart(); }
  [[nodiscard]] Eigen::Index quiet(Eigen::Index count) override;
  double look(double time) override;
  void find_event(double time);
  void retake(double length);
  void arrived(double time) override;
  [[nodiscard]] bool settle_before(long segment) override { return segment <= first_contact_; }
  [[nodiscard]] bool notes_flights() const override;
  void pass(double start, const Flights& flights, std::size_t halvings) override;

  long first_contact_;
  GapMonitor monitor_;
  Contacts contacts_;
  const ForceFunction force_at_;
  Sampler sampler_;
  std::optional<EnergyAccount> energy_;
  std::optional<Contacts::Event> event_;
  double time_ = 0;  ///< start of the expanded step [s]
};

}  // namespace bentur::engine
