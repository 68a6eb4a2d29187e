#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "bentur/core/diagnostics.h"

namespace bentur {

/// The sentences of errors.toml, by language: each English pattern and its translation.
[[nodiscard]] const std::map<std::string, std::map<std::string, std::string>>& error_sentences();

/// What an English sentence about input, or about a run that failed, is in that language; nothing where no pattern of
/// errors.toml fits it.
[[nodiscard]] std::optional<std::string> error_sentence(const std::string& english, const std::string& language);

/// The same, or the English where that is all there is.
[[nodiscard]] std::string error_words(const std::string& english, const std::string& language);

/// Diagnostic::message() in that language; nothing where one of its sentences is known in English alone.
[[nodiscard]] std::optional<std::string> error_message(const Diagnostic& error, const std::string& language);

/// Diagnostic::text() in that language, or in English where that is all there is.
[[nodiscard]] std::string error_text(const Diagnostic& error, const std::string& language);

}  // namespace bentur
