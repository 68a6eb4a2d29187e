#include "bentur/report/figures/internal/text.h"

#include <gtest/gtest.h>

#include "bentur/model/quantities.h"
#include "bentur/report/figures/internal/text_width.h"

namespace bentur {
namespace {

TEST(Text, OneLineThatXmlAllows) {
  EXPECT_EQ(plain_text("a\nb\tc\x01\x7F"), "a b c  ");
  EXPECT_EQ(plain_text("Gedung ½ · γ"), "Gedung ½ · γ");
  EXPECT_EQ(plain_text("a]]>b"), "a]] >b");
  EXPECT_EQ(plain_text("]]]]>>"), "]]]] >>");
  EXPECT_EQ(plain_text("a\xC2\x85"
                       "b\xE2\x80\xA8"
                       "c\xEF\xBF\xBF"
                       "d"),
            "a b c d");
}

TEST(Text, CutKeepsWhatFits) {
  EXPECT_EQ(cut_to("δ₁ a", text_width("δ₁ a")), "δ₁ a");
  EXPECT_EQ(cut_to("δ₁ abcd", text_width("δ₁ …")), "δ₁ …");
  EXPECT_EQ(cut_to("δδδδδδδδ", text_width("δδ…")), "δδ…");
  EXPECT_EQ(cut_to("建物建物", text_width("建物…")), "建物…");
}

TEST(Text, UnitsAsOneReadsThem) {
  EXPECT_EQ(unit_text("cm s-2"), "cm/s²");
  EXPECT_EQ(unit_text("m s-1"), "m/s");
  EXPECT_EQ(unit_text("1000 kgf cm"), "tf·cm");
  EXPECT_EQ(unit_text("1000 lbf"), "1000 lbf");
  EXPECT_EQ(unit_text("kgf s"), "kgf·s");
  EXPECT_EQ(unit_text("1"), "–");
  EXPECT_EQ(unit_text("gravity"), "g");
  EXPECT_EQ(unit_text("s-1"), "1/s");
  EXPECT_EQ(unit_text("1000 kgf s2 cm-4"), "tf·s²/cm⁴");
  EXPECT_EQ(unit_text("m2"), "m²");
  EXPECT_EQ(unit_text(""), "");
}

TEST(Text, NumbersInPicturesHaveThreeDigits) {
  EXPECT_EQ(short_number(0.0886), "0.0886");
  EXPECT_EQ(short_number(0.21), "0.210");
  EXPECT_EQ(short_number(-26.996), "-27.0");
  EXPECT_EQ(short_number(9.996), "10.0");
  EXPECT_EQ(short_number(445), "445");
  EXPECT_EQ(short_number(12707), "12700");
  EXPECT_EQ(short_number(0), "0");
}

}  // namespace
}  // namespace bentur
