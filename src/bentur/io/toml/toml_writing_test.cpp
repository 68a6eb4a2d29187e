#include "bentur/io/toml/toml_writing.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <random>

#include "bentur/contact/own_law.h"

namespace bentur {
namespace {

TomlValue parsed(const std::string& text) {
  Diagnostics found;
  const auto value = parse_toml(text, "written", found);
  EXPECT_TRUE(value) << found.errors().front().text() << "\n" << text;
  return value.value_or(TomlValue());
}

class RandomValues {
 public:
  explicit RandomValues(unsigned seed) : random_(seed) {}

  TomlValue table(int depth) {
    TomlValue made;
    for (int i = below(5); i > 0; --i) {
      const std::string key = text();
      if (made.find(key) == nullptr) made.members.push_back({key, 0, 0, value(depth - 1)});
    }
    return made;
  }

 private:
  int below(int n) { return static_cast<int>(random_() % static_cast<unsigned>(n)); }

  std::string text() {
    const std::vector<std::string> parts = {"a",  "Z",  "9",  "_",    "-",    " ", ".", "\"",
                                            "\\", "\n", "\t", "\x7f", "\x01", "ω", "#", "'"};
    std::string made;
    for (int i = below(6); i > 0; --i) made += parts[random_() % parts.size()];
    return made;
  }

  TomlValue value(int depth) {
    TomlValue made;
    switch (below(depth > 0 ? 8 : 5)) {
      case 0:
        return toml_text(text());
      case 1:
        return toml_number(std::ldexp(static_cast<double>(random_()) - 2e9, below(200) - 100));
      case 2:
        made.kind = TomlValue::Kind::integer;
        made.integer = static_cast<std::int64_t>(random_()) - 2000000000;
        made.real = static_cast<double>(made.integer);
        return made;
      case 3:
        made.kind = TomlValue::Kind::boolean;
        made.boolean = below(2) == 1;
        return made;
      case 4:
        return toml_numbers(std::vector<double>(static_cast<std::size_t>(below(40)), 1.0 / 3));
      case 5:
        return table(depth);
      default: {
        made.kind = TomlValue::Kind::list;
        const bool tables = below(2) == 1;
        for (int i = below(4); i > 0; --i) made.items.push_back(tables ? table(depth) : value(depth - 1));
        return made;
      }
    }
  }

  std::mt19937 random_;
};

TEST(TomlWriting, EveryExampleReadsBack) {
  int files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(std::filesystem::path(BENTUR_SOURCE_DIR) / "examples")) {
    if (entry.path().extension() != ".toml") continue;
    std::ifstream in(entry.path());
    const TomlValue given = parsed({std::istreambuf_iterator<char>(in), {}});
    EXPECT_TRUE(same_content(given, parsed(toml_file(given)))) << entry.path();
    ++files;
  }
  EXPECT_GT(files, 10);
}

TEST(TomlWriting, RandomTablesReadBack) {
  for (unsigned seed = 0; seed < 2000; ++seed) {
    const TomlValue given = RandomValues(seed).table(4);
    const std::string text = toml_file(given);
    EXPECT_TRUE(same_content(given, parsed(text))) << seed << "\n" << text;
  }
}

TEST(TomlWriting, NumbersKeepTheirKindAndLongListsAreBroken) {
  TomlValue table;
  table.members = {{"whole", 0, 0, parsed("a = 3").members[0].value},
                   {"real", 0, 0, toml_number(3)},
                   {"large", 0, 0, toml_number(1e22)},
                   {"much", 0, 0, toml_number(std::numeric_limits<double>::infinity())}};
  EXPECT_EQ(toml_file(table), "whole = 3\nreal = 3.0\nlarge = 1e+22\nmuch = inf\n");
  table.members = {{"a key", 0, 0, toml_numbers(std::vector<double>(100, 0.125))}};
  const std::string text = toml_file(table);
  std::size_t line = 0;
  for (const char c : text) {
    line = c == '\n' ? 0 : line + 1;
    EXPECT_LE(line, 100U);
  }
}

TEST(TomlWriting, WhatSaysTheSame) {
  EXPECT_TRUE(same_content(parsed("a = 1\nb = [2, 3.0]"), parsed("b = [2.0, 3]\na = 1.0")));
  for (const char* const other : {"a = 2", "a = [1]", "a = true", "a = 1\nb = 1", "b = 1", "a = \"1\"", "[a]", ""}) {
    EXPECT_FALSE(same_content(parsed("a = 1"), parsed(other))) << other;
  }
  TomlValue law = toml_text("mine");
  law.law = std::make_shared<OwnLaw>("mine");
  EXPECT_FALSE(same_content(law, toml_text("mine")));
  TomlValue again = law;
  EXPECT_TRUE(same_content(law, again));
  again.law = std::make_shared<OwnLaw>("mine");
  EXPECT_FALSE(same_content(law, again));
  EXPECT_TRUE(same_content(law, again, [](const OwnLaw&, const OwnLaw&) { return true; }));
}

}  // namespace
}  // namespace bentur
