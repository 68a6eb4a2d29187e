#include "bentur/io/schema/file_names.h"

#include <gtest/gtest.h>

#include "bentur/io/schema/case_keys.h"
#include "bentur/io/toml/toml_writing.h"

namespace bentur {
namespace {

TEST(FileNames, AreRenamedWhereverTheyStandAndNothingElseIs) {
  Diagnostics found;
  auto root = parse_toml(
      "title = \"a.csv\"\n[[building]]\nname = \"b\"\nmodal = { shapes_file = \"s.csv\" }\n"
      "[excitation]\nkind = \"suite\"\nfiles = [\"r/*.AT2\", { file = \"x.txt\", unit = \"g\" }]\n"
      "target = { shape = \"table\", file = \"t.csv\" }\n",
      "case.toml", found);
  ASSERT_TRUE(root);
  rename_files(*root, case_keys(), [](const std::string& name) { return "../" + name; });
  const std::string text = toml_file(*root);
  for (const char* const told :
       {"title = \"a.csv\"", "\"../s.csv\"", "\"../r/*.AT2\"", "\"../x.txt\"", "\"../t.csv\""}) {
    EXPECT_NE(text.find(told), std::string::npos) << told << "\n" << text;
  }
  root = parse_toml("[excitation]\nfile = \"e.csv\"\n[excitation.y]\nfile = \"y.csv\"\n", "case.toml", found);
  rename_files(*root, case_keys(), [](const std::string& name) { return "../" + name; });
  EXPECT_EQ(toml_file(*root), "[excitation]\nfile = \"../e.csv\"\n\n[excitation.y]\nfile = \"../y.csv\"\n");
}

}  // namespace
}  // namespace bentur
