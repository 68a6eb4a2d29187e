#pragma once

#include <filesystem>

#include "bentur/io/toml/toml_view.h"
#include "bentur/study/plan/study.h"

namespace bentur {

/// What the readers of [[vary]] need to know of the rest.
struct VaryContext {
  std::filesystem::path folder;       ///< of the study: files are relative to it
  std::filesystem::path case_folder;  ///< that the case takes them relative to
  bool samples = false;  ///< with [sampling] ranges and distributions are drawn from, else they are stepped through
};

/// One [[vary]] but for its place in the case and its axis. `together` receives the name it moves with, if any.
[[nodiscard]] Vary read_vary(const TomlView& view, const VaryContext& context, std::string& together);

/// `count` numbers from `from` to `to`, spaced as `spacing` says; empty where there was an error.
[[nodiscard]] std::vector<double> read_steps(const TomlView& view, Rule rule);

}  // namespace bentur
