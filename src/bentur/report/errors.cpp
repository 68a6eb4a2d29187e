#include "bentur/report/errors.h"

#include <fmt/args.h>
#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <string_view>

#include "bentur/io/toml/toml_value.h"
#include "bentur/report/html/internal/assets.h"

namespace bentur {
namespace {

/// A sentence whose gaps are filled in: `parts` are the words between them, one more than there are gaps.
struct Pattern {
  std::vector<std::string> parts;
  std::vector<bool> is_sentence;  ///< what fills each gap: another sentence, or what stays as it is
  std::string translation;
  std::size_t letters = 0;
};

Pattern pattern_of(std::string_view english, const std::string& translation) {
  Pattern made{{}, {}, translation, 0};
  for (std::size_t open = english.find('{'); open != std::string_view::npos; open = english.find('{')) {
    const std::size_t close = english.find('}', open);
    made.parts.emplace_back(english.substr(0, open));
    made.is_sentence.push_back(close > open + 1);
    english.remove_prefix(close + 1);
  }
  made.parts.emplace_back(english);
  for (const std::string& part : made.parts) made.letters += part.size();
  return made;
}

using Patterns = std::vector<Pattern>;

const Patterns& patterns_of(const std::string& language) {
  static const std::map<std::string, Patterns> all = [] {
    std::map<std::string, Patterns> made;
    for (const auto& [tag, sentences] : error_sentences()) {
      Patterns& patterns = made[tag];
      for (const auto& [english, translation] : sentences) patterns.push_back(pattern_of(english, translation));
      std::stable_sort(patterns.begin(), patterns.end(),
                       [](const Pattern& a, const Pattern& b) { return a.letters > b.letters; });
    }
    return made;
  }();
  static const Patterns none;
  const auto found = all.find(language);
  return found == all.end() ? none : found->second;
}

using Filled = std::vector<std::string>;

std::optional<std::string> translated(std::string_view english, const Patterns& patterns);

/// A sentence, or one behind the key that it is about.
std::optional<std::string> filled_in(std::string_view english, const Patterns& patterns) {
  if (auto sentence = translated(english, patterns)) return sentence;
  bool quoted = false;
  const auto* const end = std::find_if(english.begin(), english.end(), [&](char c) {
    if (c == '"') quoted = !quoted;
    return c == ' ' && !quoted;
  });
  if (end == english.end()) return std::nullopt;
  const auto key = static_cast<std::size_t>(end - english.begin()) + 1;
  const auto rest = translated(english.substr(key), patterns);
  return rest ? std::optional(std::string(english.substr(0, key)) + *rest) : std::nullopt;
}

/// Fills the gaps from `gap` on with what stands in `english` behind the words before that gap.
bool fits(const Pattern& pattern, std::size_t gap, std::string_view english, const Patterns& patterns, Filled& filled) {
  if (!english.starts_with(pattern.parts[gap])) return false;
  english.remove_prefix(pattern.parts[gap].size());
  if (gap == pattern.is_sentence.size()) return english.empty();
  const std::string& next = pattern.parts[gap + 1];
  const bool last = gap + 1 == pattern.is_sentence.size();
  if (last && !english.ends_with(next)) return false;
  const bool longest = last || pattern.is_sentence[gap];  // a sentence may hold the words behind it
  const auto before = [&](std::size_t at) { return at == 0 ? std::string_view::npos : english.rfind(next, at - 1); };
  for (std::size_t at = longest ? english.rfind(next) : english.find(next); at != std::string_view::npos;
       at = longest ? before(at) : english.find(next, at + 1)) {
    const std::string_view part = english.substr(0, at);
    const auto sentence = pattern.is_sentence[gap] ? filled_in(part, patterns) : std::string(part);
    filled.resize(gap);
    if (sentence) filled.push_back(*sentence);
    if (sentence && fits(pattern, gap + 1, english.substr(at), patterns, filled)) return true;
  }
  return false;
}

std::optional<std::string> translated(std::string_view english, const Patterns& patterns) {
  for (const Pattern& pattern : patterns) {
    Filled filled;
    if (!fits(pattern, 0, english, patterns, filled)) continue;
    fmt::dynamic_format_arg_store<fmt::format_context> values;
    for (const std::string& one : filled) values.push_back(one);
    return fmt::vformat(pattern.translation, values);
  }
  return std::nullopt;
}

/// What an error says in that language; nothing where one of its sentences is known in English alone.
std::optional<std::string> told(const Diagnostic& error, std::string (Diagnostic::*says)(const Wording&) const,
                                const std::string& language) {
  bool known = true;
  const std::string text = (error.*says)([&](const std::string& english) {
    const auto sentence = error_sentence(english, language);
    known = known && sentence;
    return sentence.value_or(english);
  });
  return known ? std::optional(text) : std::nullopt;
}

}  // namespace

const std::map<std::string, std::map<std::string, std::string>>& error_sentences() {
  static const std::map<std::string, std::map<std::string, std::string>> all = [] {
    Diagnostics diagnostics;
    const TomlValue file = parse_toml(std::string(html::asset("errors.toml")), "errors.toml", diagnostics).value();
    std::map<std::string, std::map<std::string, std::string>> read;
    for (const TomlMember& language : file.members) {
      for (const TomlMember& one : language.value.members) read[language.key][one.key] = one.value.text;
    }
    return read;
  }();
  return all;
}

std::optional<std::string> error_sentence(const std::string& english, const std::string& language) {
  return translated(english, patterns_of(language));
}

std::string error_words(const std::string& english, const std::string& language) {
  return error_sentence(english, language).value_or(english);
}

std::optional<std::string> error_message(const Diagnostic& error, const std::string& language) {
  return told(error, &Diagnostic::message, language);
}

std::string error_text(const Diagnostic& error, const std::string& language) {
  return told(error, &Diagnostic::text, language).value_or(error.text());
}

}  // namespace bentur
