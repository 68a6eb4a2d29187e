#pragma once

#include <cmath>
#include <exception>
#include <new>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "bentur/core/diagnostics.h"
#include "bentur/core/errors.h"
#include "bentur/core/units.h"
#include "bentur/model/story/story.h"
#include "bentur/model/suite/suite.h"
#include "bentur/pounding/response.h"
#include "bentur/report/errors.h"
#include "bentur/report/words.h"
#include "bentur/solve/effort.h"

namespace bentur::web {

using Json = nlohmann::ordered_json;

/// In it is the folder "cases", which case files are in.
inline constexpr const char* case_folder = "/case";

// A page must not stand still: what a run may take here, where the case itself allows more.
inline constexpr double most_steps = 5e6;     // some ten seconds of a case of some floors
inline constexpr double most_memory = 300e6;  // [byte]

inline std::string text_of(const Json& json) { return json.dump(-1, ' ', false, Json::error_handler_t::replace); }

/// An error in the library's words, and `told`, what it is in other languages, for the page to choose.
inline Json error_of(const Diagnostic& one, const std::string& file = "") {
  Json told = Json::object();
  for (const std::string& language : report_languages()) {
    if (const auto message = error_message(one, language)) told[language] = *message;
  }
  return {{"file", file},   {"line", one.position.line}, {"column", one.position.column},
          {"key", one.key}, {"message", one.message()},  {"told", std::move(told)}};
}

/// Why there is no answer.
inline Json failure(const std::string& message, const std::string& key = "") {
  Json error = error_of({.rule = message});
  error["key"] = key;
  return {{"ok", false}, {"errors", Json::array({std::move(error)})}};
}

/// What is more than a page takes: the page has a text "error." + `word` in each of its languages, filled with
/// `values`.
inline Json too_much(const std::string& word, const Json& values = Json::object(), int line = 0, int column = 0) {
  Json answer = failure(word);
  answer["errors"][0].update({{"line", line}, {"column", column}, {"values", values}});
  return answer;
}

/// Where a run is more than a page takes, what is.
inline std::optional<Json> beyond_page(const Effort& needed) {
  if (needed.certain_steps > most_steps) {
    return too_much("steps", {{"n", needed.certain_steps}, {"most", most_steps}});
  }
  if (needed.memory > most_memory) return too_much("memory.run", {{"n", std::ceil(needed.memory / 1e6)}});
  return std::nullopt;
}

/// What may go wrong becomes an answer.
template <typename Work>
std::string guarded(const Work& work) {
  try {
    return text_of(work());
  } catch (const std::bad_alloc&) {
    return text_of(too_much("memory"));
  } catch (const InvalidParameter& error) {
    return text_of(failure(error.what(), error.parameter()));
  } catch (const std::exception& error) {
    return text_of(failure(error.what()));
  }
}

/// What there is of any case that is right. @param gaps by name
[[nodiscard]] Json overview_of(const std::string& title, const Units& units, double duration, const Json& told,
                               const std::vector<std::string>& gaps, const Story& story, const Words& say);
[[nodiscard]] Json number_or_null(double value);
/// The records that there are to choose from, and which one is chosen, from 1; 0: all of them.
[[nodiscard]] Json suite_choice(const SuiteSpec& suite, std::size_t record);

/// The largest displacement over that without contact, of floors that move; 0 where none does.
[[nodiscard]] double largest_amplification(const Response& response);
[[nodiscard]] double largest_force(const Response& response);

}  // namespace bentur::web
