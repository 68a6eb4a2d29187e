#pragma once

#include <exception>
#include <new>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>

#include "bentur/core/diagnostics.h"
#include "bentur/core/errors.h"
#include "bentur/pounding/response.h"
#include "bentur/report/errors.h"
#include "bentur/report/words.h"

namespace bentur::web {

using Json = nlohmann::ordered_json;

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

/// The largest displacement over that without contact, of floors that move; 0 where none does.
[[nodiscard]] double largest_amplification(const Response& response);
[[nodiscard]] double largest_force(const Response& response);

}  // namespace bentur::web
