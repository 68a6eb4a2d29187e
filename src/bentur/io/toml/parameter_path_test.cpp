#include "bentur/io/toml/parameter_path.h"

#include <gtest/gtest.h>

namespace bentur {
namespace {

const char* const text = R"(
[[building]]
name = "Model 1"
damping = 0.05
frame = { beams = [{ mass = 0.2 }, { mass = 0.3 }] }
[[building]]
name = "Model 2"
[[gap]]
width = 0.2
contact = { law = "linear", stiffness = [1, 2] }
[initial]
displacements = { "Model 1" = [1, 2] }
)";

TomlValue tree() {
  Diagnostics diagnostics;
  return parse_toml(text, "case.toml", diagnostics).value();
}

/// The resolved path as a user writes it, or the error.
std::string resolution(const std::string& path) {
  std::string error;
  const auto parsed = parse_path(path, error);
  if (!parsed) return error;
  const auto found = resolved(tree(), *parsed, error);
  return found ? path_text(*found) : error;
}

TEST(ParameterPath, LeadsToWhatIsInTheCase) {
  EXPECT_EQ(resolution("gap[0].width"), "gap[0].width");
  EXPECT_EQ(resolution("building[\"Model 2\"].damping"), "building[1].damping");
  EXPECT_EQ(resolution("building['Model 1'].frame.beams[1].mass"), "building[0].frame.beams[1].mass");
  EXPECT_EQ(resolution("initial.displacements[\"Model 1\"][1]"), "initial.displacements[\"Model 1\"][1]");
  EXPECT_EQ(resolution("analysis.duration"), "analysis.duration");  // absent, and for the case reader to judge
}

TEST(ParameterPath, SaysWhatIsWrong) {
  EXPECT_EQ(resolution("building[2].damping"), "does not exist: building has 2 entries, counted from 0");
  EXPECT_EQ(resolution("building[\"Model 3\"].damping"), "is not in the case, did you mean \"Model 1\"?");
  EXPECT_EQ(resolution("gap[\"a\"].width"), "needs a place, as in [0]: the entries of this list have no names");
  EXPECT_EQ(resolution("building[0].frame.beam[0].mass"),
            "does not exist: building[0].frame has no beam, did you mean \"beams\"?");
  EXPECT_EQ(resolution("gap[0].width.x"), "does not exist: gap[0].width has no keys");
  for (const char* const wrong :
       {"", ".gap", "gap.", "gap[", "gap[]", "gap[-1]", "gap[0]width", "gap[\"a]", "[0]", "gap[0", "gäp"}) {
    std::string error;
    EXPECT_FALSE(parse_path(wrong, error)) << wrong;
    EXPECT_FALSE(error.empty()) << wrong;
  }
}

TEST(ParameterPath, PutsValuesWithTheirOrigin) {
  TomlValue root = tree();
  TomlValue value;
  value.kind = TomlValue::Kind::real;
  value.real = 7;
  std::string error;
  for (const char* const name : {"gap[0].contact.stiffness[1]", "analysis.duration", "building[0].damping"}) {
    const auto path = resolved(root, *parse_path(name, error), error).value();
    put_value(root, path, value, 3);
    const TomlValue* const found = find_value(root, path);
    ASSERT_NE(found, nullptr);
    EXPECT_EQ(found->real, 7);
    EXPECT_EQ(found->origin, 3);
    EXPECT_EQ(found->line, 0);
  }
  const TomlValue* const other = find_value(root, *parse_path("gap[0].contact.stiffness[0]", error));
  EXPECT_EQ(other->real, 1);
  EXPECT_GT(other->line, 0);
  EXPECT_EQ(other->origin, 0);
  EXPECT_EQ(find_value(root, *parse_path("analysis", error))->origin, 3);  // made on the way
}

TEST(ParameterPath, OverlapsWithWhatItLeadsThrough) {
  std::string error;
  const auto path = [&](const char* name) { return *parse_path(name, error); };
  EXPECT_TRUE(overlap(path("gap[0].width"), path("gap[0].width[1]")));
  EXPECT_TRUE(overlap(path("gap"), path("gap[0].width")));
  EXPECT_FALSE(overlap(path("gap[0].width"), path("gap[1].width")));
}

}  // namespace
}  // namespace bentur
