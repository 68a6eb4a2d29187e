#pragma once

#include <fmt/format.h>

#include <string>

namespace bentur::test {

/// The text of a frame of one bay whose members all yield, without its closing brace. @param heights "storey_heights =
/// […], " of a row's frame, whose members have no mass here; empty: a plane's
inline std::string portal(const char* modulus, double columns, double beams, const std::string& heights) {
  const char* mass = heights.empty() ? "" : ", mass = 0";
  return fmt::format(
      "{{ elastic_modulus = {}, {}bay_widths = [5], columns = [{{ area = 0.16, inertia = 2.1e-3, hardening = 0.02, "
      "moment_capacity = {}{} }}], beams = [{{ area = 0.15, inertia = 3.1e-3, hardening = 0.02, moment_capacity = {}{} "
      "}}]",
      modulus, heights, columns, mass, beams, mass);
}

}  // namespace bentur::test
