#pragma once

#include <limits>

namespace bentur {

/// A number that is not known, that was not asked for or that does not exist. As JSON it is null, in tables a dash.
inline constexpr double not_known = std::numeric_limits<double>::quiet_NaN();

}  // namespace bentur
