// What a file made here holds, read by the library of NetCDF, against what that library writes itself.
#include "bentur/files/image/netcdf_image.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <random>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "bentur/files/netcdf.h"
#include "bentur/io/temporary_folder.h"

namespace bentur {
namespace {

/// Both files of the same variables, the library's on disk, have the same of everything.
void expect_as_by_library(const ResultFile& file) {
  const TemporaryFolder folder;
  const std::string path = (folder.path() / "a.nc").string();
  NetcdfWriter writer(path);
  for (const ResultAttribute& one : file.attributes) writer.attribute(one);
  for (const ResultVariable& one : file.variables) writer.add(one);
  writer.finish();
  const NetcdfReader theirs(path), ours(netcdf_image(file), "ours.nc");
  for (const ResultAttribute& one : file.attributes) {
    if (std::holds_alternative<std::string>(one.value)) {
      EXPECT_EQ(ours.attribute(one.name), theirs.attribute(one.name)) << one.name;
    }
  }
  ASSERT_EQ(ours.variables().size(), theirs.variables().size());
  for (const StoredVariable& one : theirs.variables()) {
    const StoredVariable& own = ours.at(one.name);
    EXPECT_EQ(own.dimensions, one.dimensions) << one.name;
    EXPECT_EQ(own.shape, one.shape) << one.name;
    EXPECT_EQ(own.units, one.units) << one.name;
    EXPECT_EQ(own.long_name, one.long_name) << one.name;
    EXPECT_EQ(own.coordinates, one.coordinates) << one.name;
    ASSERT_EQ(own.text, one.text) << one.name;
    for (const std::string& dimension : one.dimensions) {
      EXPECT_EQ(ours.dimension_size(dimension), theirs.dimension_size(dimension)) << dimension;
    }
    if (one.text) {
      EXPECT_EQ(ours.texts(one.name), theirs.texts(one.name)) << one.name;
    } else {
      EXPECT_EQ(ours.numbers(one.name), theirs.numbers(one.name)) << one.name;
    }
  }
}

TEST(NetcdfImageTest, HoldsEveryTypeAsTheLibraryWritesIt) {
  const ResultDimension rows{"row", 2}, columns{"column", 3}, parts{"part/column", 1};
  expect_as_by_library({{{"title", std::string()}, {"history", std::string("written by \u00e9")}, {"one", 0.5}},
                        {{"table",
                          {rows, columns},
                          "m",
                          "a table",
                          {{"coordinates", "name number"}, {"flags", std::vector<signed char>{0, 1, -1}}},
                          std::vector{1.0, 2.0, 3.0, 4.0, 5.0, 6.5}},
                         {"row", {rows}, "s", "a scale", {{"axis", "T"}}, std::vector{0.25, -1e300}},
                         {"name", {rows}, "", "names", {}, std::vector<std::string>{"", "b \u00e9"}},
                         {"number", {rows}, "", "numbers", {}, std::vector{3, -4}},
                         {"byte", {rows}, "", "bytes", {}, std::vector<signed char>{3, -4}},
                         {"single", {}, "s", "", {}, std::vector{0.1}},
                         {"word", {}, "", "a text", {}, std::vector<std::string>{"alone"}},
                         {"part/of", {rows, parts}, "s", "of a group", {}, std::vector{7.0, 8.0}},
                         {"part/column", {parts}, "s", "of a group", {}, std::vector{9.0}},
                         {"column", {rows, columns}, "", "not of its places", {}, std::vector(6, 2)}}});
}

// Names that fill leaves of a tree to the last place and by one more; references and texts that fill collections.
TEST(NetcdfImageTest, HoldsManyVariables) {
  std::mt19937_64 random(54);
  for (const int count : {1, 31, 32, 33, 64, 65, 170, 171, 1000}) {
    ResultFile file;
    for (int i = 0; i < count; ++i) {
      const ResultDimension along{fmt::format("along_{}", random() % 50), 0};
      ResultVariable one{fmt::format("v{}_{}", random() % 100, i), {{"time", 2}, along}, "", "number", {}, {}};
      one.dimensions[1].size = 1 + along.name.size() % 4;
      one.values = std::vector(2 * one.dimensions[1].size, i + 0.5);
      file.variables.push_back(std::move(one));
    }
    std::vector<std::string> texts;
    for (int i = 0; i < count; ++i) texts.emplace_back(random() % 200, static_cast<char>('a' + i % 26));
    file.variables.push_back({"texts", {{"text", texts.size()}}, "", "texts", {}, texts});
    SCOPED_TRACE(count);
    expect_as_by_library(file);
  }
}

TEST(NetcdfImageTest, RefusesWhatIsNoFile) {
  const ResultVariable row{"row", {{"row", 2}}, "", "rows", {}, std::vector{1.0, 2.0}};
  const auto refused = [](const std::vector<ResultVariable>& variables, const std::string& why) {
    try {
      static_cast<void>(netcdf_image({{}, variables}));
      ADD_FAILURE() << why;
    } catch (const std::invalid_argument& error) {
      EXPECT_NE(std::string(error.what()).find(why), std::string::npos) << error.what();
    }
  };
  refused({row, row}, "row: there are two of this name");
  refused({{"row", {{"row", 3}}, "", "rows", {}, std::vector{1.0, 2.0}}}, "row: 2 values for 3 places");
  refused({row, {"other", {{"row", 1}}, "", "rows", {}, std::vector{1.0}}}, "row: a dimension of two sizes");
  refused({{"none", {{"none", 0}}, "", "none", {}, std::vector<double>()}}, "none: a dimension without places");
  refused({{"long", {}, "", std::string(70000, 'x'), {}, std::vector{1.0}}}, "HDF5 has no messages of 70040 bytes");
}

}  // namespace
}  // namespace bentur
