#include "bentur/io/input_file.h"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <sys/sysmacros.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "bentur/core/diagnostics.h"
#include "bentur/io/case/case_toml.h"
#include "bentur/io/temporary_folder.h"

namespace bentur {
namespace {

namespace fs = std::filesystem;

constexpr InputKind small{"note", std::uintmax_t{1} << 20};

class InputFile : public ::testing::Test {
 protected:
  std::string refused(const fs::path& file) {
    std::string problem;
    EXPECT_FALSE(read_input(file, small, problem).has_value()) << file;
    return problem;
  }

  TemporaryFolder folder_;
};

TEST_F(InputFile, ReadsARegularFileAndWhatALinkLeadsTo) {
  const std::string text("a\0b\r\n\xFF", 6);
  std::ofstream(folder_.path() / "a", std::ios::binary) << text;
  fs::create_symlink("a", folder_.path() / "b");
  std::string problem = "before";
  EXPECT_EQ(read_input(folder_.path() / "b", small, problem), text);
  EXPECT_EQ(problem, "");
}

TEST_F(InputFile, FoldersPipesAndDevicesAreRefusedAtOnce) {
  EXPECT_EQ(refused(folder_.path()), "is a folder, not a note");
  const fs::path pipe = folder_.path() / "pipe";
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  EXPECT_EQ(refused(pipe), "is a pipe, but a note is read from a regular file only");
  fs::create_symlink("pipe", folder_.path() / "link");
  EXPECT_EQ(refused(folder_.path() / "link"), "is a pipe, but a note is read from a regular file only");
  const fs::path device = folder_.path() / "device";
  if (::mknod(device.c_str(), S_IFCHR | 0600, makedev(1, 5)) != 0) GTEST_SKIP() << "may not make a device node";
  EXPECT_EQ(refused(device), "is a device, but a note is read from a regular file only");
}

TEST_F(InputFile, SizeIsBounded) {
  const fs::path file = folder_.path() / "large";
  std::ofstream(file) << "x";
  fs::resize_file(file, small.largest);
  std::string problem;
  EXPECT_EQ(read_input(file, small, problem)->size(), small.largest);
  fs::resize_file(file, small.largest + 1);
  EXPECT_EQ(refused(file), "is larger than 1 MiB, which no note is");
}

TEST_F(InputFile, SaysWhyTheSystemRefuses) {
  EXPECT_EQ(refused(folder_.path() / "none"), "there is no such file");
  EXPECT_EQ(refused(fs::path(std::string("a\0b", 3))), "there is no such file");
  fs::create_symlink("itself", folder_.path() / "itself");
  EXPECT_NE(refused(folder_.path() / "itself").find("cannot be read: "), std::string::npos);

  const fs::path file = folder_.path() / "secret.toml";
  std::ofstream(file) << "x = 1";
  fs::permissions(file, fs::perms::none);
  // The superuser may read anything: try as nobody.
  fs::permissions(folder_.path(), fs::perms::all);
  const bool root = ::geteuid() == 0;
  if (root && ::seteuid(65534) != 0) GTEST_SKIP() << "may not become another user";
  const std::string problem = refused(file);
  Diagnostics of_case;
  EXPECT_FALSE(read_case(file, of_case).has_value());
  if (root) {
    ASSERT_EQ(::seteuid(0), 0);
  }
  EXPECT_EQ(problem, "cannot be read: Permission denied");
  EXPECT_EQ(of_case.errors().at(0).message(), "cannot be read: Permission denied");
}

}  // namespace
}  // namespace bentur
