#pragma once

#include <string>
#include <vector>

#include "bentur/report/html/internal/sections.h"

namespace bentur::html {

/// What motion.js draws, as JSON: units, buildings with their floors' displacements, contact points and the `listed`
/// impacts (by start). A displacement x [length] is kept as the whole number nearest to
/// x/scale, scale = max|x|/32767, 16 bits little endian in base64: off by 1.5e-5 of the building's peak at most.
[[nodiscard]] std::string animation_json(const Report& report, const std::vector<Eigen::Index>& listed);

/// Standard base64 with padding (RFC 4648).
[[nodiscard]] std::string base64(const std::string& bytes);

}  // namespace bentur::html
