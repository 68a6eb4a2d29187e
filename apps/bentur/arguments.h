#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>

namespace bentur::cli {

// Rules for the values of options, whose messages say what is allowed.

[[nodiscard]] CLI::Validator not_empty();
/// A number above 0.
[[nodiscard]] CLI::Validator positive();
/// Any number: what is none, and what is too large to be one, passes a range.
[[nodiscard]] CLI::Validator finite();
/// One from 0 to 2⁶⁴ − 1: the library takes what is outside as what is left of it.
[[nodiscard]] CLI::Validator whole_number();

/// Adds --force to a command that writes.
void add_force(CLI::App& command, bool& force);

/// Adds --record to a command that runs a case: of a suite the one record that it is for.
void add_record(CLI::App& command, std::optional<int>& record);

/// Adds --lang to a command that tells what came out.
void add_language(CLI::App& command, std::string& language);

[[nodiscard]] bool is_command(const CLI::App& app, const std::string& word);

/// The command, or the option of a command, that a user may have meant by one there is none of: ` (did you mean
/// "run"?)`, or nothing.
[[nodiscard]] std::string meant_command(const CLI::App& app, const std::string& word);
[[nodiscard]] std::string meant_option(const CLI::App& app);

}  // namespace bentur::cli
