#pragma once

#include <string>

#include "bentur/report/html/internal/markup.h"
#include "bentur/report/words.h"

namespace bentur::html {

/// From the side, or from above.
enum class MotionView { row, plan };

/// The elements that report.js gives to motion.js, which draws the buildings in motion. @param length unit
[[nodiscard]] PageSection motion_section(const Words& say, const std::string& length, MotionView view);

}  // namespace bentur::html
