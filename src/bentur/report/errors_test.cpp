#include "bentur/report/errors.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <regex>
#include <string>
#include <vector>

#include "bentur/io/case/case_toml.h"

namespace bentur {
namespace {

namespace fs = std::filesystem;

std::size_t gaps(const std::string& pattern) {
  return static_cast<std::size_t>(std::count(pattern.begin(), pattern.end(), '{'));
}

std::vector<std::string> found_in(const std::string& text, const std::regex& what) {
  std::vector<std::string> found;
  for (std::sregex_iterator one(text.begin(), text.end(), what), end; one != end; ++one) found.push_back(one->str());
  std::sort(found.begin(), found.end());
  return found;
}

TEST(Errors, EachTranslationTakesWhatItsSentenceHas) {
  ASSERT_EQ(error_sentences().size(), 1U);
  EXPECT_GT(error_sentences().at("id").size(), 200U);
  for (const auto& [english, translation] : error_sentences().at("id")) {
    EXPECT_EQ(gaps(english), gaps(translation)) << english;
    EXPECT_FALSE(translation.empty()) << english;
  }
}

/// Names, words of a case, keys and numbers are told as they are; of English nothing is left but what the parser says.
TEST(Errors, EachOfBadInputIsToldInIndonesian) {
  const std::regex same(R"("(?:[^"\\]|\\.)*"|[a-z0-9]+(?:_[a-z0-9]+)+|\d+(?:\.\d+)?(?:e[-+]?\d+)?)");
  const std::regex english(
      R"((^|[ (])(an|and|are|as|be|by|expected|has|is|must|not|of|or|the|there|to|with)(?=[ ,;:.)]|$))");
  const std::regex quoted(R"("(?:[^"\\]|\\.)*")");
  int errors = 0;
  for (const auto& entry : fs::directory_iterator(fs::path(BENTUR_BINARY_DIR) / "tests" / "bad_input")) {
    if (entry.path().extension() != ".toml") continue;
    Diagnostics diagnostics;
    EXPECT_FALSE(read_case(entry.path(), diagnostics)) << entry.path();
    for (const Diagnostic& one : diagnostics.errors()) {
      ++errors;
      const auto told = error_message(one, "id");
      ASSERT_TRUE(told) << one.text();
      EXPECT_NE(*told, one.message());
      EXPECT_TRUE(told->starts_with(one.key)) << *told;
      EXPECT_EQ(found_in(*told, same), found_in(one.message(), same)) << *told;
      if (one.rule.starts_with("not valid TOML")) continue;
      EXPECT_EQ(found_in(std::regex_replace(*told, quoted, ""), english), std::vector<std::string>()) << *told;
    }
  }
  EXPECT_GT(errors, 400);
}

TEST(Errors, ASentenceThatIsInNoTableStaysEnglish) {
  const Diagnostic unknown{.position = {"case.toml", 3, 1}, .key = "gap[0].width", .value = "2", .rule = "is odd"};
  EXPECT_EQ(error_message(unknown, "id"), std::nullopt);
  EXPECT_EQ(error_text(unknown, "id"), unknown.text());
  EXPECT_EQ(error_sentence("cannot be computed with: it is odd", "id"), std::nullopt);
  EXPECT_EQ(error_sentence("must be finite", "en"), std::nullopt);
}

TEST(Errors, PlaceKeyAndValueStandAroundTheSentence) {
  Diagnostic one{.position = {"case.toml", 3, 7}, .key = "gap[0].width", .value = "-1", .rule = "must be >= 0"};
  EXPECT_EQ(error_text(one, "id"), "case.toml:3:7: kesalahan: gap[0].width = -1, harus >= 0");
  EXPECT_EQ(error_text(one, "en"), "case.toml:3:7: error: gap[0].width = -1, must be >= 0");
  one.value = "a list";
  EXPECT_EQ(error_message(one, "id"), "gap[0].width adalah daftar, harus >= 0");
  one.value = "\"hertzz\"";
  one.suggestion = "hertz";
  EXPECT_EQ(error_message(one, "id"), "gap[0].width = \"hertzz\", apakah maksudnya \"hertz\"?");
}

TEST(Errors, WhatARunThatFailsSaysIsToldToo) {
  EXPECT_EQ(error_words("the numbers failed: the limit of 100 steps is reached at t = 0.123 s", "id"),
            "hitungannya gagal: batas 100 langkah tercapai pada t = 0.123 s");
  EXPECT_EQ(error_words("the numbers failed: it is odd", "id"), "the numbers failed: it is odd");
}

TEST(Errors, ASentenceMayHoldAnother) {
  EXPECT_EQ(
      error_sentence("with gap[0].width = -1: building[\"A b\"] is missing (one per floor) (case.toml:3:1)", "id"),
      "dengan gap[0].width = -1: building[\"A b\"] tidak ada (satu per lantai) (case.toml:3:1)");
}

}  // namespace
}  // namespace bentur
