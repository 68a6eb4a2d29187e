#pragma once

#include <stdexcept>
#include <string>

namespace bentur {

/// A caller's mistake: a parameter outside its range. The message names parameter, value and allowed range.
/// (Input of a user is never reported this way: see diagnostics.h. Failing numerics are a status in the response.)
class InvalidParameter : public std::invalid_argument {
 public:
  InvalidParameter(const std::string& parameter, const std::string& value, const std::string& rule)
      : std::invalid_argument(parameter + " = " + value + ", " + rule) {}
};

}  // namespace bentur
