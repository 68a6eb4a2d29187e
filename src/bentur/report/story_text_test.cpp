#include "bentur/report/story_text.h"

#include <gtest/gtest.h>

#include <string>

namespace bentur {
namespace {

/// What is in bold of a building's collapse, the building's name as given.
std::string bold(const std::string& building) {
  Statement statement{.kind = "collapse", .severity = Severity::danger};
  for (const char* name : {"building", "time", "storey", "limit"}) {
    statement.values.push_back({name, std::string(name) == "building" ? building : "1"});
  }
  const SaidStatement one = said({statement}, Words("en")).front();
  return one.text.substr(0, one.lead);
}

TEST(Bold, IsTheFirstSentence) {
  EXPECT_EQ(bold("A"), "A collapses at 1: the drift of storey 1 exceeds 1 of its height.");
}

TEST(Bold, OfALongSentenceIsItsFirstClausesNotWithinBrackets) {
  EXPECT_EQ(bold(std::string(120, 'x')), std::string(120, 'x') + " collapses at 1:");
  EXPECT_EQ(bold(std::string(80, 'x') + ", y (" + std::string(20, 'z') + ", z)" + std::string(80, 'x')),
            std::string(80, 'x') + ",");
  EXPECT_EQ(bold("A (" + std::string(200, 'x')), "A (" + std::string(200, 'x') +
                                                     " collapses at 1: the drift of "
                                                     "storey 1 exceeds 1 of its height.");
}

/// Quadratic work over such a name would last for hours.
TEST(Bold, OfTwoMillionLettersIsFoundAtOnce) {
  const std::string name(2'000'000, 'x');
  EXPECT_EQ(bold(name), name + " collapses at 1: the drift of storey 1 exceeds 1 of its height.");
}

}  // namespace
}  // namespace bentur
