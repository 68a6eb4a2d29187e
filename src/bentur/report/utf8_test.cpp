#include "bentur/report/utf8.h"

#include <gtest/gtest.h>

namespace bentur {
namespace {

TEST(Utf8, CharactersAndTheirCodes) {
  const auto list = characters("aδ建");
  ASSERT_EQ(list.size(), 3U);
  EXPECT_EQ(list[1].bytes, "δ");
  EXPECT_EQ(list[1].code, 0x3B4);
  EXPECT_EQ(list[2].bytes.size(), 3U);
  EXPECT_TRUE(characters("").empty());
}

TEST(Utf8, BytesThatAreNoneStandAlone) {
  const auto list = characters("\xC3<\xFF\xE2\x80");  // half a character, no character, two thirds of one
  ASSERT_EQ(list.size(), 5U);
  for (const std::size_t i : {0U, 2U, 3U, 4U}) EXPECT_EQ(list[i].code, -1) << i;
  EXPECT_EQ(list[1].bytes, "<");
  EXPECT_EQ(characters("\xED\xA0\x80").front().code, -1) << "half of a UTF-16 pair";
}

TEST(Utf8, AnyTextBecomesMarkupThatShowsIt) {
  EXPECT_EQ(markup_text("<a href='x'>\"&`"), "&lt;a href=&#39;x&#39;&gt;&quot;&amp;&#96;");
  EXPECT_EQ(markup_text("δ\n\x01"), "δ\n\xEF\xBF\xBD");
}

}  // namespace
}  // namespace bentur
