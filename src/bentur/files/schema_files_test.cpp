#include "bentur/files/schema_files.h"

#include <gtest/gtest.h>

#include <fstream>

#include "bentur/io/temporary_folder.h"

namespace bentur {
namespace {

TEST(SchemaFiles, TheLineEndsTheCommentAtTheHead) {
  EXPECT_EQ(with_schema_line("# one\n# two\n\n# later\nx = 1\n"),
            "# one\n# two\n#:schema ./bentur.schema.json\n\n# later\nx = 1\n");
  EXPECT_EQ(with_schema_line("x = 1\n", "s.json"), "#:schema ./s.json\nx = 1\n");
}

TEST(SchemaFiles, AreReplacedButNothingElseIs) {
  const TemporaryFolder folder;
  const std::filesystem::path file = folder.path() / "some.json";
  EXPECT_NO_THROW(write_schema(SchemaOf::a_case, file));
  EXPECT_NO_THROW(write_schema(SchemaOf::study, file));
  std::ofstream(file) << "{}";
  EXPECT_THROW(write_schema(SchemaOf::study, file), RefusedOutput);
}

}  // namespace
}  // namespace bentur
