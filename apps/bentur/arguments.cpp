#include "arguments.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <optional>
#include <vector>

#include "bentur/core/diagnostics.h"
#include "bentur/report/words.h"

namespace bentur::cli {
namespace {

/// A number that is all of the text.
template <class Number>
std::optional<Number> read_whole(const std::string& text) {
  Number value{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc() && end == text.data() + text.size() ? std::optional(value) : std::nullopt;
}

/// Whether a word is another one without one of its letters.
bool lacks_one(const std::string& word, const std::string& whole) {
  for (std::size_t i = 0; word.size() + 1 == whole.size() && i < whole.size(); ++i) {
    if (whole.substr(0, i) + whole.substr(i + 1) == word) return true;
  }
  return false;
}

std::string did_you_mean(const std::string& word, const std::vector<std::string>& known) {
  std::string near = nearest(word, known);
  for (std::size_t i = 0; near.empty() && word.size() > 1 && i < known.size(); ++i) {  // "rn" of "run"
    if (lacks_one(word, known[i])) near = known[i];
  }
  return near.empty() ? "" : fmt::format(" (did you mean \"{}\"?)", near);
}

std::vector<std::string> commands(const CLI::App& app) {
  std::vector<std::string> known;
  for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; })) {
    known.push_back(command->get_name());
  }
  return known;
}

}  // namespace

CLI::Validator not_empty() {
  return {[](const std::string& text) { return std::string(text.empty() ? "must not be empty" : ""); }, ""};
}

CLI::Validator positive() {
  return {[](const std::string& text) {
            const std::optional<double> value = read_whole<double>(text);
            const bool right = value && *value > 0 && std::isfinite(*value);
            return right ? std::string() : fmt::format("{}: must be a number above 0", text);
          },
          ""};
}

CLI::Validator finite() {
  return {[](const std::string& text) {
            const std::optional<double> value = read_whole<double>(text);
            return value && std::isfinite(*value) ? std::string() : fmt::format("{}: must be a number", text);
          },
          ""};
}

CLI::Validator whole_number() {
  return {[](const std::string& text) {
            return read_whole<std::uint64_t>(text)
                       ? std::string()
                       : fmt::format("{}: must be a whole number from 0 to {}", text, UINT64_MAX);
          },
          ""};
}

void add_force(CLI::App& command, bool& force) {
  command.add_flag("--force", force, "replace files even where they are not results of the same kind");
}

void add_record(CLI::App& command, std::optional<int>& record) {
  command.add_option("--record", record, "of a suite of records: this one in full, counted from 1")
      ->check(CLI::Range(1, 1000000));
}

void add_language(CLI::App& command, std::string& language) {
  command.add_option("--lang", language, "language of the results and of errors in the input: en or id")
      ->check(CLI::IsMember(report_languages()))
      ->type_name("LANG");
}

bool is_command(const CLI::App& app, const std::string& word) {
  const std::vector<std::string> known = commands(app);
  return std::find(known.begin(), known.end(), word) != known.end();
}

std::string meant_command(const CLI::App& app, const std::string& word) { return did_you_mean(word, commands(app)); }

std::string meant_option(const CLI::App& app) {
  for (const CLI::App* command : app.get_subcommands()) {
    std::vector<std::string> known;
    for (const CLI::Option* option : command->get_options()) {
      for (const std::string& name : option->get_lnames()) known.push_back("--" + name);
    }
    for (const std::string& extra : command->remaining()) {
      if (extra.starts_with("--")) return did_you_mean(extra.substr(0, extra.find('=')), known);
    }
  }
  return "";
}

}  // namespace bentur::cli
