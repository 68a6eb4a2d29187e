#pragma once

#include <memory>
#include <vector>

#include "bentur/elements/law.h"
#include "bentur/solve/problem.h"

namespace bentur::engine {

/// Laws and offsets of a problem's elements, in the order of ModalSystem::elements.
[[nodiscard]] std::vector<std::shared_ptr<const Law>> laws_of(const Problem& problem);
[[nodiscard]] std::vector<double> offsets_of(const Problem& problem);

}  // namespace bentur::engine
