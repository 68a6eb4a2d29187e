#pragma once

#include <optional>
#include <string>

#include "bentur/core/diagnostics.h"
#include "bentur/report/figures/figure.h"

namespace bentur {

/// A figure from its description in JSON: the members of Figure by name, those that are absent as they are by default;
/// tones, lines and marks by name, `pale-blue`, `dash-dot`; null among numbers: nothing there (docs/figures.md).
/// @param file its name, for messages.
/// @return the figure, or none where `diagnostics` has errors: of the syntax, of keys, of values.
[[nodiscard]] std::optional<Figure> figure_from_json(const std::string& text, const std::string& file,
                                                     Diagnostics& diagnostics);

}  // namespace bentur
