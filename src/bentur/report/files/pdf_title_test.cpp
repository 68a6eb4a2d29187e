#include "bentur/report/files/pdf_title.h"

#include <gtest/gtest.h>

#include <string>

#include "bentur/report/files/picture.h"

namespace bentur {
namespace {

/// What a reader does: from the end to the table, by it to the information, there to the title.
std::string title_of(const std::string& pdf) {
  const std::size_t table = std::stoul(pdf.substr(pdf.rfind("startxref") + 10));
  EXPECT_EQ(pdf.substr(table, 5), "xref\n");
  const std::size_t info = std::stoul(pdf.substr(pdf.find("/Info ", table) + 6));
  const std::size_t first = std::stoul(pdf.substr(table + 5));
  EXPECT_EQ(first, info);  // the only object that is new
  const std::size_t entry = pdf.find('\n', table + 5) + 1;
  EXPECT_EQ(pdf.find('\n', entry) - entry, 19U);  // 20 bytes with its end
  const std::size_t object = std::stoul(pdf.substr(entry, 10));
  EXPECT_EQ(pdf.substr(object, 10), std::to_string(info) + " 0 obj\n<");
  const std::size_t begin = pdf.find("/Title <", object) + 8;
  return pdf.substr(begin, pdf.find('>', begin) - begin);
}

constexpr const char* small =
    "%PDF-1.5\n12 0 obj\n<< /Producer (cairo)\n>>\nendobj\n13 0 obj\n<< /Type /Catalog\n>>\nendobj\nxref\n0 14\n"
    "trailer\n<< /Size 14\n   /Root 13 0 R\n   /Info 12 0 R\n>>\nstartxref\n88\n%%EOF\n";

TEST(PdfTitle, IsAnUpdateBehindTheEnd) {
  const std::string titled = with_title(small, "A–B 𝛿)");
  EXPECT_TRUE(titled.starts_with(small));
  EXPECT_EQ(title_of(titled),
            "FEFF00412013004200"
            "20D835DEFF0029");
  EXPECT_NE(titled.rfind("/Producer (cairo)"), titled.find("/Producer (cairo)"));
  EXPECT_NE(titled.rfind("/Prev 88\n"), std::string::npos);
  EXPECT_NE(titled.rfind("/Size 14\n"), titled.find("/Size 14\n"));
}

TEST(PdfTitle, WithoutATableNothingChanges) {
  EXPECT_EQ(with_title("%PDF-1.7\n", "A"), "%PDF-1.7\n");
  EXPECT_EQ(with_title(small, ""), small);
}

TEST(PdfTitle, OfAFigureIsItsTitle) {
  if (!can_draw("pdf")) GTEST_SKIP() << "needs rsvg-convert";
  const Figure figure{.title = "Force, A | B", .panels = {{.curves = {{.x = {0, 1}, .y = {0, 1}}}}}};
  EXPECT_EQ(title_of(draw(figure, "pdf")), "FEFF0046006F007200630065002C002000410020007C00200042");
}

}  // namespace
}  // namespace bentur
