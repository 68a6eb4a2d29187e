#include <gtest/gtest.h>

#include <string>

#include "bentur/core/diagnostics.h"
#include "bentur/io/toml/toml_value.h"

namespace bentur {
namespace {

std::string error_of(const std::string& text) {
  Diagnostics diagnostics;
  EXPECT_FALSE(parse_toml(text, "a.toml", diagnostics));
  EXPECT_EQ(diagnostics.errors().size(), 1U);
  return diagnostics.errors().empty() ? "" : diagnostics.errors().front().text();
}

/// What is meant where the parser's words leave it to be guessed.
TEST(TomlParse, SaysHowSeveralTablesBeginAndWhatDecimalsHave) {
  const std::string two = "[building]\nname = \"A\"\n[building]\nname = \"B\"\n";
  EXPECT_TRUE(error_of(two).ends_with("; each building begins with [[building]]")) << error_of(two);
  EXPECT_TRUE(error_of("damping = 0,05\n").ends_with("; decimals have a point, not a comma"));
  for (const std::string other : {"[units]\n[units]\n", "a = 1 ,5\n", "a = ,\n", "a = 1,\n", "a = 1,"}) {
    EXPECT_EQ(error_of(other).find(';'), std::string::npos) << other;
  }
}

}  // namespace
}  // namespace bentur
