// Figures are as wide as is asked for, and no letter of them is smaller for it.
#include "bentur/report/kinds/figure_width.h"

#include <gtest/gtest.h>

#include <string>

#include "bentur/report/figures/internal/layout.h"
#include "tests/support/drawn_run.h"
#include "tests/support/hinged_case.h"
#include "tests/support/plan_run.h"

namespace bentur {
namespace {

template <class Run>
void expect_widths(const Run& run, int least_broad) {
  int broad = 0;
  for (const FigureKind& kind : figure_kinds(run)) {
    const auto make = [&](const FigureOptions& options) { return make_figure(run, kind.name, options); };
    const Figure usual = make({});
    broad += usual.width > column_width ? 1 : 0;
    for (const double width : {6.0, column_width, 14.0, page_width}) {
      const Figure figure = figure_of_width(make, {}, width);
      EXPECT_DOUBLE_EQ(figure.width, width) << kind.name;
      EXPECT_EQ(figure.finding, usual.finding) << kind.name;
      if (width >= column_width) {
        EXPECT_LE(layout(figure).height, page_height + 0.01) << kind.name << ", " << width;
      }
      EXPECT_FALSE(figure_svg(figure).empty()) << kind.name;
      if (width <= column_width && !figure.panels.front().to_scale) {
        EXPECT_FALSE(figure.panels.back().x.label.empty()) << kind.name << ": no neighbour has it";
      }
    }
  }
  EXPECT_GE(broad, least_broad) << "a page's width, where nothing else is asked for";
}

TEST(FigureWidth, IsWhatIsAskedForOfARow) { expect_widths(test::drawn_run(test::hinged), 1); }

TEST(FigureWidth, IsWhatIsAskedForOfAPlan) { expect_widths(test::plan_run(test::twisting_pair()), 2); }

/// What is made lower is what can be: frames whose names stand beside them keep their height, and so the names.
TEST(FigureWidth, FramesWithNamesAreNoLower) {
  Panel named{.y = {.names = {"a", "b", "c", "d", "e"}}, .height = 2, .curves = {{.x = {0, 1}, .y = {0, 4}}}};
  Panel other{.height = 5, .curves = {{.x = {0, 1}, .y = {0, 1}}}};
  Figure figure{.panels = {other, named}};
  const double before = layout(figure).height;
  bound_height(figure, before - 2);
  EXPECT_NEAR(layout(figure).height, before - 2, 0.05);
  EXPECT_EQ(figure.panels.back().height, 2);
  EXPECT_EQ(layout(figure).panels.back().y.labels.front().second, "a");
}

}  // namespace
}  // namespace bentur
