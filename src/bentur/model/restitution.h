#pragma once

#include <optional>
#include <vector>

#include "bentur/pounding/problem.h"
#include "bentur/pounding/response.h"

namespace bentur {

/// The coefficient of restitution of one contact point: asked for, and obtained in its impacts. An impact of a building
/// that moves on is no free impact: its floors are pulled back and pushed on by their columns while they touch, so that
/// what is obtained scatters about what is asked, the more the softer the contact is.
struct PointRestitution {
  std::optional<double> asked;              ///< e [-] of the law; nothing for a law that was given otherwise
  std::optional<double> smallest, largest;  ///< [-] of the impacts that have ended; nothing without one
};

/// One entry per contact point of the problem.
[[nodiscard]] std::vector<PointRestitution> restitutions(const Problem& problem, const Response& response);

}  // namespace bentur
