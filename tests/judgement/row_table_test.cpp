#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "bentur/core/number_text.h"
#include "bentur/model/story/story.h"
#include "tests/support/drawn_run.h"

namespace bentur {
namespace {

const char* const three_houses = R"(
units = { length = "m", force = "kN" }
excitation = { kind = "harmonic", period = 0.5, displacement_amplitude = 0.01 }
analysis = { duration = 2.0 }
building = [
  { name = "A", damping = 0.05, generic = { storeys = 1, storey_height = 3.0, floor_mass = 100.0, period = 0.3, stiffness_ratio = 30.0 } },
  { name = "B", damping = 0.05, generic = { storeys = 1, storey_height = 3.0, floor_mass = 100.0, period = 0.4, stiffness_ratio = 30.0 } },
  { name = "C", damping = 0.05, generic = { storeys = 1, storey_height = 3.0, floor_mass = 100.0, period = 0.6, stiffness_ratio = 30.0 } },
]
gap = [
  { between = ["A", "B"], width = 0.02, contact = { law = "linear", stiffness = 1e5 } },
  { between = ["B", "C"], width = 0.02, contact = { law = "linear", stiffness = 1e5 } },
]
)";

/// What a gap lacks by less than the digits of its column is not lost.
TEST(RowTable, ANeedThatIsALittleMoreThanGivenReadsAsMore) {
  RunResults run = test::drawn_run(three_houses);
  const double width = run.problem.points.front().width;
  for (PointSummary& point : run.response.points) point.gap_needed_reversed = point.gap_needed = 0.5 * width;
  run.response.points.front().gap_needed = 1.0002 * width;
  const Story story = run_story(run);
  const auto table =
      std::find_if(story.tables.begin(), story.tables.end(), [](const StoryTable& one) { return one.kind == "row"; });
  ASSERT_NE(table, story.tables.end());
  const auto cell = [&](const char* label) {
    const auto column = std::find_if(table->columns.begin(), table->columns.end(),
                                     [&](const StoryColumn& one) { return one.label == label; });
    const auto read = parse_number(column->texts.at(0));
    EXPECT_TRUE(read) << label << ": " << column->texts.at(0);
    return read.value_or(0);
  };
  EXPECT_EQ(cell("column.given"), width);
  EXPECT_GT(cell("column.recorded"), width);
  EXPECT_NEAR(cell("column.recorded"), 1.0002 * width, 1e-4 * width);
  EXPECT_NEAR(cell("column.short_by"), 2e-4 * width, 1e-5 * width);
  // What it lacks may be as much as is given, and has the digits of the others.
  run.response.points.front().gap_needed = 1.9996 * width;
  const Story twice = run_story(run);
  const auto again =
      std::find_if(twice.tables.begin(), twice.tables.end(), [](const StoryTable& one) { return one.kind == "row"; });
  const auto text = [&](const char* label) {
    return std::find_if(again->columns.begin(), again->columns.end(),
                        [&](const StoryColumn& one) { return one.label == label; })
        ->texts.at(0);
  };
  EXPECT_EQ(text("column.short_by").size(), text("column.recorded").size()) << text("column.short_by");
}

}  // namespace
}  // namespace bentur
