#include "bentur/io/results/internal/asked_json.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <random>
#include <string>

namespace bentur {
namespace {

/// By chance: objects and lists within one another, empty ones too, and texts with what JSON writes otherwise.
Json any_json(std::mt19937& random, int depth) {
  const auto among = [&](int count) { return std::uniform_int_distribution<int>(0, count - 1)(random); };
  const std::string texts[] = {"", "level", "two\nlines", "a \"quote\"", "\\", "größer als 1", "no UTF-8: \xff", "\t"};
  const int kind = among(depth > 0 ? 7 : 4);
  if (kind == 0) return nullptr;
  if (kind == 1) return among(2) == 0;
  if (kind == 2) return std::uniform_real_distribution<double>(-1e9, 1e9)(random);
  if (kind == 3) return texts[among(8)];
  Json made = kind < 5 ? Json::array() : Json::object();
  for (int i = among(5); i > 0; --i) {
    Json part = any_json(random, depth - 1);
    made.is_array() ? made.push_back(std::move(part))
                    : void(made[texts[among(8)] + std::to_string(i)] = std::move(part));
  }
  return made;
}

/// Item by item, so that no text is there twice, as the library writes it at once.
TEST(AskedJson, IsWrittenAsTheLibraryWritesIt) {
  std::mt19937 random(1);
  for (int n = 0; n < 2000; ++n) {
    const Json json = any_json(random, 6);
    ASSERT_EQ(text_of(json), json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n") << n;
  }
}

}  // namespace
}  // namespace bentur
