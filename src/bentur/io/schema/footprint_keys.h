#pragma once

#include "bentur/core/key.h"

namespace bentur {

/// Of a part of a footprint that stands beside its polygon.
[[nodiscard]] const KeyTable& part_keys();

}  // namespace bentur
