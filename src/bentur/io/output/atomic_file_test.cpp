#include "bentur/io/output/atomic_file.h"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <fstream>
#include <iterator>
#include <stdexcept>

#include "bentur/io/temporary_folder.h"

namespace bentur {
namespace {

namespace fs = std::filesystem;

class AtomicFilesTest : public testing::Test {
 protected:
  [[nodiscard]] static std::string read(const fs::path& path) {
    std::ifstream stream(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
  }
  [[nodiscard]] static long entries(const fs::path& path) {
    return std::distance(fs::directory_iterator(path), fs::directory_iterator());
  }

  TemporaryFolder folder_;
  const fs::path& root_ = folder_.path();
};

TEST_F(AtomicFilesTest, FilesAppearTogetherAtCommit) {
  AtomicFiles files(root_ / "a" / "b" / "");
  files.add("one", "1\n", ResultKind::report);
  files.add("two", std::string("nul\0byte", 8), ResultKind::report);
  EXPECT_FALSE(fs::exists(root_ / "a/b/one"));
  files.commit();
  EXPECT_EQ(read(root_ / "a/b/one"), "1\n");
  EXPECT_EQ(read(root_ / "a/b/two").size(), 8U);
  EXPECT_EQ(entries(root_ / "a/b"), 2);
}

TEST_F(AtomicFilesTest, WithoutCommitNothingStays) {
  {
    AtomicFiles files(root_ / "a" / "b");
    files.add("one", "1", ResultKind::report);
    EXPECT_TRUE(fs::exists(root_ / "a/b"));
  }
  EXPECT_EQ(entries(root_), 0);
}

TEST_F(AtomicFilesTest, WhatKilledRunsLeftIsRemoved) {
  const fs::path living = make_temporary(root_ / "one"), foreign = root_ / ".bentur-00000000-1-abcdef";
  std::ofstream(foreign) << "of another machine";
  const pid_t killed = ::fork();
  ASSERT_GE(killed, 0);
  if (killed == 0) {
    AtomicFiles files(root_);
    files.add("one", "1", ResultKind::report);
    files.add("two", "2", ResultKind::report);
    ::kill(::getpid(), SIGKILL);
  }
  ASSERT_EQ(::waitpid(killed, nullptr, 0), killed);
  EXPECT_EQ(entries(root_), 4);
  AtomicFiles files(root_);
  EXPECT_EQ(entries(root_), 2);
  EXPECT_TRUE(fs::exists(living));
  EXPECT_TRUE(fs::exists(foreign));
}

TEST_F(AtomicFilesTest, WithoutCommitWhatWasThereStays) {
  std::ofstream(root_ / "one") << "old";
  {
    AtomicFiles files(root_, {.force = true});
    files.add("one", "new", ResultKind::report);
  }
  EXPECT_EQ(read(root_ / "one"), "old");
  EXPECT_EQ(entries(root_), 1);
}

TEST_F(AtomicFilesTest, ReplacesAtCommit) {
  std::ofstream(root_ / "one") << "a long old content";
  AtomicFiles files(root_, {.force = true});
  files.add("one", "new", ResultKind::report);
  files.commit();
  EXPECT_EQ(read(root_ / "one"), "new");
}

TEST_F(AtomicFilesTest, RefusesAFileInPlaceOfTheFolder) {
  std::ofstream(root_ / "plain") << "x";
  EXPECT_THROW(AtomicFiles{root_ / "plain"}, std::runtime_error);
  EXPECT_THROW(AtomicFiles{root_ / "plain" / "below"}, std::runtime_error);
  EXPECT_EQ(read(root_ / "plain"), "x");
}

TEST_F(AtomicFilesTest, RefusesAFolderInPlaceOfAFileAndLeavesNothing) {
  fs::create_directory(root_ / "two");
  {
    AtomicFiles files(root_);
    files.add("one", "1", ResultKind::report);
    EXPECT_THROW(files.add("two", "2", ResultKind::report), std::runtime_error);
  }
  EXPECT_EQ(entries(root_), 1);
}

TEST_F(AtomicFilesTest, NewFilesHaveTheUsualPermissions) {
  AtomicFiles files(root_);
  files.add("one", "1", ResultKind::report);
  files.commit();
  std::ofstream(root_ / "two") << "2";
  EXPECT_EQ(fs::status(root_ / "one").permissions(), fs::status(root_ / "two").permissions());
}

}  // namespace
}  // namespace bentur
