#pragma once

#include <optional>

#include "bentur/io/toml/toml_view.h"
#include "bentur/study/plan/study.h"

namespace bentur {

/// [ida] of a study; nothing where it has none. Its axis is for read_study() to set.
[[nodiscard]] std::optional<IdaSpec> read_ida(const TomlView& root);

}  // namespace bentur
