#pragma once

#include <vector>

#include "bentur/model/story/story.h"
#include "bentur/model/suite/suite.h"

namespace bentur {

/// Of the records of a suite as they are scaled: how many of how many, their factors, how the mean of their spectra
/// stands to the target and to the clause; tables of the records and of the buildings' periods that give the band.
[[nodiscard]] Story suite_story(const SuiteSpec& suite, const Units& units);

}  // namespace bentur
