#pragma once

#include <memory>
#include <vector>

#include "bentur/elements/law.h"
#include "bentur/solve/engine/motion/modal_system.h"
#include "bentur/solve/problem.h"

namespace bentur::engine {

/// Laws and offsets of a problem's elements, in the order of those of its system.
[[nodiscard]] std::vector<std::shared_ptr<const Law>> laws_of(const Problem& problem, const ModalSystem& system);
[[nodiscard]] std::vector<double> offsets_of(const Problem& problem, const ModalSystem& system);

}  // namespace bentur::engine
