#include "bentur/files/netcdf.h"

#include <gtest/gtest.h>

#include <fstream>
#include <stdexcept>
#include <vector>

#include "bentur/files/result_netcdf.h"
#include "bentur/io/case/case_toml.h"
#include "bentur/io/temporary_folder.h"
#include "bentur/pounding/pounding.h"

namespace bentur {
namespace {

std::string example_histories() {
  Diagnostics diagnostics;
  const auto c = read_case(BENTUR_SOURCE_DIR "/examples/free-impact.toml", diagnostics);
  const Problem problem = make_problem(c.value());
  SolveOptions options;
  options.output_step = 0.01;
  const Response response = solve(problem, ExactSolver{}, options);
  RunResults results = run_results(*c, problem, response);
  results.figures = figure_data(results);
  return histories_netcdf(results, "1");
}

TEST(NetcdfReaderTest, ReadsWhatIsWritten) {
  const NetcdfReader reader(example_histories(), "histories.nc");
  EXPECT_EQ(reader.texts("building_name"), (std::vector<std::string>{"Left", "Right"}));
  const StoredVariable& opening = reader.at("opening");
  EXPECT_EQ(opening.dimensions, (std::vector<std::string>{"time", "point"}));
  EXPECT_EQ(opening.shape, (std::vector<std::size_t>{reader.numbers("time").size(), 1}));
  EXPECT_EQ(opening.units, "m");
  EXPECT_EQ(opening.coordinates.front(), "point_elevation");
  EXPECT_EQ(reader.numbers("opening").size(), opening.shape[0]);
  EXPECT_EQ(reader.numbers("point_width"), std::vector<double>{0.01});
  EXPECT_EQ(reader.numbers("base_elevation_1"), std::vector<double>{0});
  EXPECT_EQ(reader.attribute("Conventions"), "CF-1.8");
  EXPECT_EQ(reader.attribute("nothing"), "");
  EXPECT_EQ(reader.attribute("opening", "units"), "m");
  EXPECT_EQ(reader.attribute("opening", "nothing"), "");
  EXPECT_EQ(reader.find("nothing"), nullptr);
}

TEST(NetcdfReaderTest, APlaceOfTheFirstDimensionIsPartOfTheWhole) {
  const NetcdfReader reader(example_histories(), "histories.nc");
  const std::vector<double> all = reader.numbers("displacement_1");
  const std::size_t each = reader.at("displacement_1").shape[1];
  ASSERT_GT(all.size(), 2 * each);
  const auto second = all.begin() + static_cast<std::ptrdiff_t>(each);
  EXPECT_EQ(reader.numbers("displacement_1", 1),
            std::vector<double>(second, second + static_cast<std::ptrdiff_t>(each)));
  EXPECT_THROW(static_cast<void>(reader.numbers("displacement_1", all.size() / each)), NetcdfError);
}

TEST(NetcdfReaderTest, AFileOnDiskIsTheSame) {
  const TemporaryFolder folder;
  const std::string bytes = example_histories();
  std::ofstream(folder.path() / "a.nc", std::ios::binary) << bytes;
  const NetcdfReader disk(folder.path() / "a.nc");
  const NetcdfReader memory(bytes, "a.nc");
  ASSERT_EQ(disk.variables().size(), memory.variables().size());
  EXPECT_EQ(disk.numbers("force"), memory.numbers("force"));
}

TEST(NetcdfNamesTest, SayWhatAFileIsWithoutReadingIt) {
  const TemporaryFolder folder;
  const std::filesystem::path file = folder.path() / "a.nc";
  const std::string bytes = example_histories();
  const auto is_ours = [](const NetcdfNames& names) {
    return names.attribute("Conventions") == "CF-1.8" && names.attribute("nothing").empty() &&
           names.has("displacement_1") && !names.has("nothing");
  };
  std::ofstream(file, std::ios::binary) << bytes;
  EXPECT_TRUE(ask_netcdf(file, is_ours));
  EXPECT_FALSE(ask_netcdf(file, [](const NetcdfNames& names) { return names.has("nothing"); }));
  EXPECT_FALSE(ask_netcdf(folder.path() / "nothing.nc", is_ours));
  std::ofstream(file, std::ios::binary | std::ios::trunc) << bytes.substr(0, bytes.size() / 2);
  EXPECT_FALSE(ask_netcdf(file, is_ours));
  std::ofstream(file, std::ios::binary | std::ios::trunc) << "no NetCDF";
  EXPECT_FALSE(ask_netcdf(file, is_ours));
}

TEST(NetcdfReaderTest, SaysWhatIsWrong) {
  const TemporaryFolder folder;
  std::ofstream(folder.path() / "a.nc") << "no results";
  try {
    const NetcdfReader reader(folder.path() / "a.nc");
    FAIL();
  } catch (const std::runtime_error& error) {
    EXPECT_NE(std::string(error.what()).find("a.nc: is not a NetCDF file"), std::string::npos) << error.what();
  }
  EXPECT_THROW(NetcdfReader(folder.path() / "none.nc"), std::runtime_error);
  const NetcdfReader reader(example_histories(), "h.nc");
  EXPECT_THROW(static_cast<void>(reader.numbers("nothing")), std::runtime_error);
  EXPECT_THROW(static_cast<void>(reader.numbers("building_name")), std::runtime_error);
  EXPECT_THROW(static_cast<void>(reader.texts("time")), std::runtime_error);
}

/// A file with a value of every type, the first row of its table behind the second.
void write_made_up(const std::string& path) {
  NetcdfWriter file(path);
  for (const ResultAttribute& one : file_attributes("t", "s", "1")) file.attribute(one);
  const ResultDimension rows{"row", 2}, columns{"column", 3};
  const auto table = file.add({"table",
                               {rows, columns},
                               "m",
                               "a table",
                               {{"coordinates", "name number"}, {"flags", std::vector<signed char>{0, 1}}}});
  const auto names = file.add({"name", {rows}, "", "names", {}, std::vector<std::string>()});
  file.chunk(names, {1});
  file.add({"number", {rows}, "", "numbers", {}, std::vector{3, -4}});
  file.add({"single", {}, "s", "a number", {}, std::vector{0.1}});
  file.add({"part/of", {rows, {"part/column", 1}}, "s", "of a group", {}, std::vector{7.0, 8.0}});
  file.put(table, std::vector{4.0, 5.0, 6.0}, {{1, 0}, {1, 3}});
  file.put(table, std::vector{1.0, 2.0, 3.0}, {{0, 0}, {1, 3}});
  file.put(names, std::vector<std::string>{"b"}, {{1}, {1}});
  file.put(names, std::vector<std::string>{""}, {{0}, {1}});
  file.finish();
}

TEST(NetcdfWriterTest, WritesBlocksOfEveryType) {
  const TemporaryFolder folder;
  const std::string path = (folder.path() / "a.nc").string();
  write_made_up(path);
  const NetcdfReader file(path);
  EXPECT_EQ(file.attribute("history"), "written by bentur 1");
  EXPECT_EQ(file.numbers("table"), (std::vector<double>{1, 2, 3, 4, 5, 6}));
  EXPECT_EQ(file.at("table").units, "m");
  EXPECT_EQ(file.at("table").coordinates, (std::vector<std::string>{"name", "number"}));
  EXPECT_EQ(file.texts("name"), (std::vector<std::string>{"", "b"}));
  EXPECT_EQ(file.numbers("number"), (std::vector<double>{3, -4}));
  EXPECT_EQ(file.numbers("single"), std::vector<double>{0.1});
  EXPECT_EQ(file.numbers("part/of"), (std::vector<double>{7, 8}));
  EXPECT_EQ(file.dimension_size("column"), 3U);
  EXPECT_EQ(file.dimension_size("part/column"), 1U);
  EXPECT_EQ(file.dimension_size("nothing"), 0U);
}

// The library would read what lies behind the values in memory.
TEST(NetcdfWriterTest, TakesAsManyValuesAsThereArePlaces) {
  const TemporaryFolder folder;
  NetcdfWriter file((folder.path() / "made-up.nc").string());
  EXPECT_THROW(file.add({"table", {{"row", 2}, {"column", 2}}, "", "table", {}, std::vector{1.0, 2.0}}),
               std::logic_error);
  const auto row = file.add({"row", {{"row", 2}}, "", "row", {}, {}});
  EXPECT_THROW(file.put(row, std::vector{1.0, 2.0}, {{0}, {1}}), std::logic_error);
  file.put(row, std::vector{1.0}, {{1}, {1}});
}

TEST(NetcdfWriterTest, SaysWhatTheLibraryRefuses) {
  const TemporaryFolder folder;
  NetcdfWriter file((folder.path() / "made-up.nc").string());
  const ResultVariable twice{"row", {{"row", 2}}, "", "rows", {}, std::vector{1.0, 2.0}};
  file.add(twice);
  try {
    file.add(twice);
    FAIL();
  } catch (const std::runtime_error& error) {
    EXPECT_NE(std::string(error.what()).find("made-up.nc: "), std::string::npos) << error.what();
  }
  EXPECT_THROW(NetcdfWriter("/no/such/folder/a.nc"), std::runtime_error);
}

}  // namespace
}  // namespace bentur
