#pragma once

#include <memory>
#include <vector>

#include "bentur/elements/law.h"
#include "bentur/solve/system.h"

namespace bentur::engine {

/// Which contacts of meetings (system.h) are passed: closed without a force, since another family of their meeting was
/// open when they closed, or bodies have slipped off there.
class Meetings {
 public:
  /// @param places of all points
  explicit Meetings(const std::vector<MeetingPlace>& places);

  /// Whether bodies touch at a point as it closes, or push on as it does, only as other points let them.
  [[nodiscard]] bool has(Eigen::Index point) const {
    return point < std::ssize(places_) && places_[point].meeting >= 0;
  }
  [[nodiscard]] bool is_seam(Eigen::Index point) const { return places_[point].seam; }
  [[nodiscard]] bool passed(Eigen::Index point) const { return has(point) && passed_[point] != 0; }
  void pass(Eigen::Index point) { passed_[point] = 1; }
  void come_back(Eigen::Index point) { passed_[point] = 0; }
  /// All points of the meeting of a point, itself among them.
  [[nodiscard]] const std::vector<Eigen::Index>& points_with(Eigen::Index point) const {
    return points_[places_[point].meeting];
  }
  [[nodiscard]] bool are_of_one_family(Eigen::Index one, Eigen::Index other) const {
    return places_[one].family == places_[other].family;
  }
  /// How many families share what acts in the meeting of a point: those that closed last at one instant.
  [[nodiscard]] int& sharing(Eigen::Index point) { return sharing_[places_[point].meeting]; }
  [[nodiscard]] bool shares(Eigen::Index point) const { return has(point) && sharing_[places_[point].meeting] > 1; }

  /// What a change does beside the law of its contact: that one is closed or opens without a force, its law as it was;
  /// contacts whose force ends with it.
  void begin_change() {
    settles_ = false;
    slipped_.clear();
  }
  void settle() { settles_ = true; }
  void slip_off(Eigen::Index point) { slipped_.push_back(point); }
  [[nodiscard]] bool settles() const { return settles_; }
  [[nodiscard]] const std::vector<Eigen::Index>& slipped() const { return slipped_; }

 private:
  std::vector<MeetingPlace> places_;
  std::vector<char> passed_;                       ///< per point
  std::vector<std::vector<Eigen::Index>> points_;  ///< per meeting
  std::vector<int> sharing_;                       ///< per meeting
  std::vector<Eigen::Index> slipped_;
  bool settles_ = false;
};

/// While it is passed: no force, until δ is back where bodies that are apart touch. @param apart their branch
[[nodiscard]] Branch passed_branch(const Branch& apart);

/// A part of a law's force, as of one of several like it that act together.
class PartOfLaw final : public Law {
 public:
  PartOfLaw(std::shared_ptr<const Law> whole, double part) : whole_(std::move(whole)), part_(part) {}

  [[nodiscard]] const std::shared_ptr<const Law>& whole() const { return whole_; }
  [[nodiscard]] std::string_view name() const noexcept override { return whole_->name(); }
  [[nodiscard]] LawParameters parameters() const override { return whole_->parameters(); }
  [[nodiscard]] Branch branch(const LawState& state) const noexcept override;
  [[nodiscard]] LawState next(const LawState& state, std::size_t guard, double time, double deformation,
                              double speed) const noexcept override {
    return whole_->next(state, guard, time, deformation, speed);
  }
  [[nodiscard]] double force(const LawState& state, double deformation, double speed) const noexcept override {
    return part_ * whole_->force(state, deformation, speed);
  }
  [[nodiscard]] double stored_energy(const LawState& state, double deformation) const noexcept override {
    return part_ * whole_->stored_energy(state, deformation);
  }
  [[nodiscard]] bool needs_closing_speed() const noexcept override { return whole_->needs_closing_speed(); }

 private:
  std::shared_ptr<const Law> whole_;
  double part_;  // [-]
};

}  // namespace bentur::engine
