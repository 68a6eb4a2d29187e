#pragma once

#include <stdexcept>
#include <string>

namespace bentur {

/// A caller's mistake: a parameter outside its range. The message names parameter, value and allowed range.
/// (Input of a user is never reported this way: see diagnostics.h. Failing numerics are a status in the response.)
class InvalidParameter : public std::invalid_argument {
 public:
  InvalidParameter(const std::string& parameter, const std::string& value, const std::string& rule)
      : std::invalid_argument(parameter + " = " + value + ", " + rule), parameter_(parameter), rule_(rule) {}

  [[nodiscard]] const std::string& parameter() const noexcept { return parameter_; }
  [[nodiscard]] const std::string& rule() const noexcept { return rule_; }

 private:
  std::string parameter_, rule_;
};

}  // namespace bentur
