#pragma once

#include <string>
#include <vector>

#include "bentur/report/html/internal/sections.h"

namespace bentur::html {

/// What motion.js plays and row.js draws, as JSON: units, buildings with the displacements of their floors,
/// contact points and the `listed` impacts.
[[nodiscard]] std::string animation_json(const Report& report, const std::vector<Eigen::Index>& listed);

}  // namespace bentur::html
