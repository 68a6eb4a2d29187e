#pragma once

#include <Eigen/Core>
#include <string>
#include <utility>
#include <vector>

#include "bentur/model/closer/frame_forces.h"
#include "bentur/report/figures/figure.h"

namespace bentur {

/// One of the three that members carry, along each member: at MemberForces::stations, or the same from end to end.
struct Carried {
  const char *form = "", *symbol = "";  ///< of its unit; what it is called in short
  const char* signs = "";               ///< which way is drawn what, and what it is not of
  bool is_moment = false, is_axial = false;
  const char* largest = "";  ///< "largest moment {}, {}"

  [[nodiscard]] std::vector<double> of(const FrameForces::Forces& forces, Eigen::Index member) const;
  [[nodiscard]] std::vector<double> stations() const;
};

/// What is drawn of the members: from `low` to `high`, or from the members themselves.
struct Band {
  const FrameForces::Forces *low = nullptr, *high = nullptr;
};

/// Places of a diagram on its frame: columns to the right, beams downwards, by `scale` [length per unit].
class Diagram {
 public:
  Diagram(const Carried& carried, const FrameForces& frame, double scale)
      : carried_(&carried), frame_(&frame), scale_(scale) {}

  [[nodiscard]] std::pair<double, double> at(Eigen::Index member, double station, double value) const;
  /// The lines of the members themselves.
  [[nodiscard]] Curve members(Tone tone, const std::string& label) const;
  /// The area of a band of all beams, or of all columns, in the style that is given.
  [[nodiscard]] Curve area(const Band& band, bool of_beams, Curve style) const;
  /// Around it; of beams between two bounds their edges alone, as columns stand at their ends.
  [[nodiscard]] Curve outline(const Band& band, bool of_beams, Curve style) const;

 private:
  struct Station {
    double along = 0, low = 0, high = 0;
  };
  /// Of a member, between which both bounds are straight.
  [[nodiscard]] std::vector<Station> stations_of(const Band& band, Eigen::Index member) const;

  const Carried* carried_;
  const FrameForces* frame_;
  double scale_;
};

}  // namespace bentur
