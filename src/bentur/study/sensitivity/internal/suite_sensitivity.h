#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <vector>

#include "bentur/io/toml/parameter_path.h"
#include "bentur/study/sensitivity/sensitivity.h"

namespace bentur {

struct SuiteSpec;

/// Marks the largest of each kind in its gap or building.
void mark_largest(std::vector<SensitivePeak>& peaks);

/// The numbers of a case that may be parameters, by their paths.
[[nodiscard]] std::vector<ParameterPath> numbers_in(const TomlValue& root);

/// sensitivity_of() of a case with a suite, one record after the other.
[[nodiscard]] std::optional<Sensitivity> sensitivity_of_suite(const TomlValue& root, const std::filesystem::path& file,
                                                              std::shared_ptr<const SuiteSpec> suite,
                                                              const SensitivityOptions& options,
                                                              Diagnostics& diagnostics);

}  // namespace bentur
