#include "bentur/core/diagnostics.h"

#include <gtest/gtest.h>

namespace bentur {
namespace {

std::string text(const SourcePosition& position) {
  Diagnostic diagnostic;
  diagnostic.position = position;
  diagnostic.key = "width";
  diagnostic.value = "-1";
  diagnostic.rule = "must be >= 0";
  return diagnostic.text();
}

TEST(Diagnostic, Text) {
  EXPECT_EQ(text({"case.toml", 14, 9}), "case.toml:14:9: error: width = -1, must be >= 0");
  EXPECT_EQ(text({"case.toml", 14, 0}), "case.toml:14: error: width = -1, must be >= 0");
  EXPECT_EQ(text({"case.toml", 0, 0}), "case.toml: error: width = -1, must be >= 0");
  EXPECT_EQ(text({"case.toml", 0, 9}), "case.toml: error: width = -1, must be >= 0");
  EXPECT_EQ(text({}), "error: width = -1, must be >= 0");
}

TEST(Diagnostic, MessageIsMadeOfItsParts) {
  const auto message = [](const Diagnostic& one) { return one.message(); };
  EXPECT_EQ(message({.rule = "holds no numbers"}), "holds no numbers");
  EXPECT_EQ(message({.key = "gap", .rule = "is missing"}), "gap is missing");
  EXPECT_EQ(message({.key = "width", .value = "-1", .rule = "must be >= 0"}), "width = -1, must be >= 0");
  EXPECT_EQ(message({.key = "width", .value = "a list", .rule = "must be a number"}),
            "width is a list, must be a number");
  EXPECT_EQ(message({.key = "law", .value = "\"herz\"", .rule = "must be one of a, b", .suggestion = "hertz"}),
            "law = \"herz\", did you mean \"hertz\"?");
  EXPECT_EQ(message({.key = "widht", .rule = "is not a known key", .suggestion = "width", .unknown_key = true}),
            "widht is not a known key, did you mean \"width\"?");
}

TEST(Diagnostics, SortedByPlaceAndStable) {
  Diagnostics found;
  EXPECT_TRUE(found.ok());
  EXPECT_TRUE(found.errors().empty());
  found.error({"b.toml", 1, 1}, "b");
  found.error({"a.toml", 10, 1}, "tenth line");
  found.error({"a.toml", 2, 7}, "first found here");
  found.error({"a.toml", 2, 7}, "and then this");
  found.error({"a.toml", 2, 3}, "third column");
  found.error({"a.toml", 0, 0}, "the file as a whole");
  EXPECT_FALSE(found.ok());
  std::vector<std::string> messages;
  for (const Diagnostic& each : found.errors()) messages.push_back(each.message());
  EXPECT_EQ(messages, (std::vector<std::string>{"the file as a whole", "third column", "first found here",
                                                "and then this", "tenth line", "b"}));
}

TEST(Diagnostics, OrderIsKeptAtOnePlace) {
  // Enough of them that a sort which is not stable would mix them.
  Diagnostics found;
  for (int i = 0; i < 100; ++i) found.error({"case.toml", i % 2, 1}, std::to_string(i));
  const std::vector<Diagnostic> sorted = found.errors();
  ASSERT_EQ(sorted.size(), 100U);
  for (int i = 0; i < 50; ++i) {
    EXPECT_EQ(sorted[static_cast<std::size_t>(i)].message(), std::to_string(2 * i));
    EXPECT_EQ(sorted[static_cast<std::size_t>(50 + i)].message(), std::to_string(2 * i + 1));
  }
}

TEST(Nearest, FindsWhatWasMeant) {
  const std::vector<std::string> known = {"width", "elevations", "storey_heights", "law", "restitution"};
  EXPECT_EQ(nearest("widht", known), "width");  // a swap of neighbours is one edit
  EXPECT_EQ(nearest("width", known), "width");
  EXPECT_EQ(nearest("elevation", known), "elevations");
  EXPECT_EQ(nearest("story_height", known), "storey_heights");
  EXPECT_EQ(nearest("resitution", known), "restitution");
  EXPECT_EQ(nearest("lav", known), "law");  // one letter of three: a third, still near enough
}

TEST(Nearest, StaysSilentWhenNothingIsNear) {
  const std::vector<std::string> known = {"width", "law"};
  EXPECT_EQ(nearest("colour", known), "");
  EXPECT_EQ(nearest("lxv", known), "");    // two of three
  EXPECT_EQ(nearest("wixxh", known), "");  // two of five are more than a third
  EXPECT_EQ(nearest("x", known), "");
  EXPECT_EQ(nearest("", known), "");
  EXPECT_EQ(nearest("width", {}), "");
}

TEST(Nearest, TakesTheNearestThenTheFirst) {
  EXPECT_EQ(nearest("damping", {"dampings", "damping", "clamping"}), "damping");
  EXPECT_EQ(nearest("masa", {"masb", "mass"}), "masb");
  EXPECT_EQ(nearest("abcdef", {"abcdxy", "abcdex"}), "abcdex");
}

}  // namespace
}  // namespace bentur
