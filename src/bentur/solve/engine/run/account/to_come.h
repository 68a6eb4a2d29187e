#pragma once

#include <vector>

#include "bentur/solve/engine/run/elements.h"
#include "bentur/solve/solution.h"

namespace bentur::engine {

/// How far every contact's δ (those that rub last) and then every watched one can still go after `state`, in which no
/// bodies touch, while the ground rests or swings on in harmony. (T-9)
[[nodiscard]] std::vector<ToCome> to_come(const System& given, const ModalSystem& system, const State& state,
                                          const Elements& elements);

}  // namespace bentur::engine
