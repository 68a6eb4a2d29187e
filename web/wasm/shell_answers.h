#pragma once

#include <exception>
#include <new>
#include <nlohmann/json.hpp>
#include <string>

#include "bentur/core/errors.h"
#include "bentur/solve/response.h"

namespace bentur::web {

using Json = nlohmann::ordered_json;

inline std::string text_of(const Json& json) { return json.dump(-1, ' ', false, Json::error_handler_t::replace); }

/// Why there is no answer, in the library's words.
inline Json failure(const std::string& message, const std::string& key = "") {
  return {{"ok", false}, {"errors", {{{"file", ""}, {"line", 0}, {"column", 0}, {"key", key}, {"message", message}}}}};
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
