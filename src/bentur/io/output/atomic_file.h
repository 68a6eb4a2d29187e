#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "bentur/io/output/output_rules.h"

namespace bentur {

/// An open file, closed with the object. All functions throw std::runtime_error with its name and the system's reason.
class OpenFile {
 public:
  /// @param descriptor as the system gave it; where it gave none, `problem` is thrown. @param name for messages.
  OpenFile(int descriptor, std::filesystem::path name, const char* problem = "cannot write");
  OpenFile(OpenFile&& other) noexcept;
  OpenFile& operator=(OpenFile&&) = delete;
  OpenFile(const OpenFile&) = delete;
  OpenFile& operator=(const OpenFile&) = delete;
  ~OpenFile();

  [[nodiscard]] int descriptor() const noexcept { return descriptor_; }
  [[nodiscard]] const std::filesystem::path& name() const noexcept { return name_; }
  /// Writes all bytes, from `offset` [bytes] of the file on.
  void write(std::span<const char> bytes, std::size_t offset) const;
  /// Reads from `offset` [bytes] on; behind the end of the file zeros.
  void read(std::span<char> bytes, std::size_t offset) const;
  /// Returns once what was written would survive a crash of the machine.
  void sync() const;
  /// Closes the file, which may show an error that writing has not.
  void close();

 private:
  [[noreturn]] void fail(const char* problem) const;

  int descriptor_;
  std::filesystem::path name_;
};

/// Makes a new empty file in the folder of `file`, with the permissions any new file gets, and removes those that
/// killed runs have left there. @return its path.
/// @throws std::runtime_error naming `file`, with the system's reason.
[[nodiscard]] std::filesystem::path make_temporary(const std::filesystem::path& file);

/// Writes files of one folder so that a reader sees each of them whole or not at all: every file goes to a temporary
/// name in the same folder, and only when all are there do they take their names. Without commit() nothing stays, not
/// even the folder if it was made here. Where a name is a symbolic link, the same goes for the file that it leads to.
/// All functions throw RefusedOutput by the rules, and std::runtime_error with the path and the system's reason.
class AtomicFiles {
 public:
  /// Makes the folder if missing and proves that it can be written to.
  explicit AtomicFiles(std::filesystem::path directory, OutputRules rules = {});
  ~AtomicFiles();
  AtomicFiles(const AtomicFiles&) = delete;
  AtomicFiles& operator=(const AtomicFiles&) = delete;

  /// Refuses before the work what add() would refuse after it.
  void expect(const std::string& name, ResultKind kind) const;

  /// Writes `content` under a temporary name beside `name`, a plain file name.
  void add(const std::string& name, std::string_view content, ResultKind kind);

  /// Renames every file added to its own name, replacing what was there.
  void commit();

 private:
  std::filesystem::path directory_;
  OutputRules rules_;
  std::vector<std::filesystem::path> made_;                                     // folders made here, outermost first
  std::vector<std::pair<std::filesystem::path, std::filesystem::path>> files_;  // temporary and final path
};

}  // namespace bentur
