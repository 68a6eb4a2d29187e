#include "bentur/files/example_files.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <set>
#include <stdexcept>

#include "bentur/io/temporary_folder.h"

namespace bentur {
namespace {

namespace fs = std::filesystem;

std::string read(const fs::path& path) {
  std::ifstream stream(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size())) {
    text.replace(at, from.size(), to);
  }
  return text;
}

TEST(ExampleFiles, AreTheFilesOfTheRepositoryButForThePathOfTheRecord) {
  std::size_t compared = 0;
  for (const EmbeddedFile& file : embedded_files()) {
    const fs::path root = BENTUR_SOURCE_DIR;
    const std::vector<fs::path> places = {root / "examples", root / "examples" / "studies", root / "data"};
    const auto place =
        std::find_if(places.begin(), places.end(), [&](const fs::path& p) { return exists(p / file.name); });
    ASSERT_NE(place, places.end()) << file.name;
    std::string expected = read(*place / file.name);
    for (const char* const way : {"\"../../data/", "\"../data/", "\"../"}) expected = replaced(expected, way, "\"");
    EXPECT_EQ(file.content, expected) << file.name;
    ++compared;
  }
  EXPECT_EQ(compared, 22U);  // sixteen cases, four studies and two records
}

TEST(ExampleFiles, DefaultCaseComesFirstAndEachHasADescription) {
  const std::vector<Example> all = examples();
  ASSERT_EQ(all.size(), 20U);
  EXPECT_EQ(all.front().name, "m12-el-centro");
  EXPECT_EQ(all.front().files.size(), 2U);
  std::set<std::string_view> names;
  for (const Example& example : all) {
    names.insert(example.name);
    EXPECT_GT(example.description.size(), 20U) << example.name;
    if (!example.command.empty()) continue;
    const bool shaken_by_record = example.files.front()->content.find("kind = \"record\"") != std::string_view::npos;
    EXPECT_EQ(example.files.size(), shaken_by_record ? 2U : 1U) << example.name;
  }
  EXPECT_EQ(names.size(), 20U);
}

TEST(ExampleFiles, StudiesComeLastWithTheirCaseAndItsRecord) {
  std::string told;
  for (const Example& example : examples()) {
    if (example.command.empty()) {
      EXPECT_TRUE(told.empty()) << example.name;
      continue;
    }
    told += fmt::format("{} {}:", example.command, example.name);
    for (const EmbeddedFile* file : example.files) told += fmt::format(" {}", file->name);
    told += "\n";
  }
  EXPECT_EQ(told,
            "remedy linked-pair-damper: linked-pair-damper.toml linked-pair.toml el-centro-1940-ns.csv\n"
            "sweep m12-gap-period: m12-gap-period.toml m12-el-centro.toml el-centro-1940-ns.csv\n"
            "sweep m12-gaps: m12-gaps.toml m12-el-centro.toml el-centro-1940-ns.csv\n"
            "ida two-frames-ida: two-frames-ida.toml two-frames-si.toml el-centro-1940-ns.csv\n");
}

TEST(ExampleFiles, TheRecordHasItsPeakInItsPlace) {
  const auto files = embedded_files();
  const auto record = std::find_if(files.begin(), files.end(),
                                   [](const EmbeddedFile& file) { return file.name == "el-centro-1940-ns.csv"; });
  ASSERT_NE(record, files.end());
  EXPECT_EQ(record->content.substr(0, 18), "time,acceleration\n");
  EXPECT_NE(record->content.find("\n2.04,-0.31882\n"), std::string_view::npos);
  EXPECT_EQ(std::count(record->content.begin(), record->content.end(), '\n'), 1 + 1560);
}

TEST(ExampleFiles, WritesOnceAndNeverOverAnEditedFile) {
  const TemporaryFolder folder;
  const fs::path& root = folder.path();
  const Example example = examples().front();
  const fs::path file = write_example(example, root / "mine");
  EXPECT_EQ(read(file), example.files.front()->content);
  EXPECT_EQ(read(root / "mine" / "el-centro-1940-ns.csv"), example.files.back()->content);
  EXPECT_NO_THROW(write_example(example, root / "mine"));  // the same again changes nothing
  std::ofstream(file, std::ios::app) << "# edited\n";
  fs::remove(root / "mine" / "el-centro-1940-ns.csv");
  EXPECT_THROW(write_example(example, root / "mine"), std::runtime_error);
  EXPECT_TRUE(read(file).ends_with("# edited\n"));
  EXPECT_FALSE(fs::exists(root / "mine" / "el-centro-1940-ns.csv"));
}

}  // namespace
}  // namespace bentur
