#pragma once

#include <string>

#include "bentur/model/suite/suite.h"

namespace bentur {

/// The records of a suite as they are scaled, with the mean of their spectra and the target (docs/suites.md): an object
/// in JSON. Accelerations in the case's length/s², at 5 % damping.
[[nodiscard]] std::string suite_json(const SuiteSpec& suite);

}  // namespace bentur
