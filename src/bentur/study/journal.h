#pragma once

#include <cstddef>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "bentur/io/output/atomic_file.h"
#include "bentur/study/study_runs.h"

namespace bentur {

/// What the runs of a journal come from. A journal is gone on with only where all of it but `version` is the same: a
/// commit to other sources than those of `build` changes no number.
struct JournalOrigin {
  std::string version;  ///< of the program
  std::string build;    ///< build_identity() of its library
  std::string study;    ///< texts of the two files
  std::string case_text;
  std::map<std::string, std::string> records;  ///< name to hash
  std::size_t runs = 0;
  std::size_t values = 0;  ///< of a row
};

/// What differs between what something was begun with and what there is now, to be read after "was begun": "with
/// another study: line 5 has changed"; nothing where all is the same.
[[nodiscard]] std::optional<std::string> difference(const JournalOrigin& then, const JournalOrigin& now);

/// Results of runs on disk while a study is under way. One file: a header, then a slot of one size for each run, in the
/// order of their numbers. A slot is written once, whole, with a checksum; one that was not written, or was cut short
/// when the program was killed, is a run not done. So nothing that write() has returned from is lost with the program,
/// and nothing that sync() has returned from with the machine. Slots not yet written take no room.
/// The file belongs to one program at a time; another waits three seconds for it. All functions throw
/// std::runtime_error with the file and the reason.
class Journal {
 public:
  /// Begins a new one; `file` must not exist.
  static Journal begin(const std::filesystem::path& file, const JournalOrigin& origin);
  /// Goes on with one. @throws std::runtime_error saying what differs where the origin is another one.
  static Journal resume(const std::filesystem::path& file, const JournalOrigin& origin);

  [[nodiscard]] bool is_done(std::size_t run) const { return done_[run]; }
  [[nodiscard]] std::size_t done() const noexcept { return count_; }

  void write(const RunResult& result);
  void sync() { file_.sync(); }

  /// The results of `count` runs from `first` on, all of them done.
  [[nodiscard]] std::vector<RunResult> read(std::size_t first, std::size_t count) const;

 private:
  Journal(OpenFile file, const JournalOrigin& origin, std::size_t header_bytes);
  void find_done();

  OpenFile file_;
  std::size_t values_, slot_, first_slot_;  // numbers in a row; bytes of a slot; bytes before the first one
  std::vector<bool> done_;
  std::size_t count_ = 0;
  std::vector<char> buffer_;
};

}  // namespace bentur
