#pragma once

#include <cstddef>
#include <filesystem>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "bentur/io/case/case_parts.h"
#include "bentur/io/file_identity.h"
#include "bentur/io/records/record_files.h"

namespace bentur {

/// What many readings of nearly the same case share: all that no motion changes where only that differs, else buildings
/// that are given alike, with their modes; and records.
/// Only what was found right is kept, and only so much of it; anything else is read again. Many threads may use it at
/// once.
class CaseMemo {
 public:
  /// Of a study, whose files are those that stood there when it began, and which keeps their hashes itself.
  CaseMemo() = default;
  /// One that may outlive the files: what has changed since is read again, and of what has changed within the last
  /// seconds, whose next change its time might not show, nothing is kept. Its cases know their files by their hashes.
  [[nodiscard]] static std::shared_ptr<CaseMemo> of_files_that_change();

  /// The building made before of the same table, units and names of the buildings `before` it; null when there is none.
  [[nodiscard]] std::shared_ptr<const ReadBuilding> building(const TomlValue& table, const Units& units,
                                                             const std::vector<ReadBuilding>& before) const;
  /// Keeps the buildings of a case that is right.
  void keep(const TomlView& root, const Units& units, const std::vector<ReadBuilding>& buildings);

  /// What has been made before of a case in the same folder that says the same but for its [excitation], without all
  /// that follows from that; null when there is none, or files change.
  [[nodiscard]] std::shared_ptr<const ReadCase> but_motion(const TomlView& root,
                                                           const std::filesystem::path& folder) const;
  /// Keeps that of a case that is right.
  void keep(const TomlView& root, const std::filesystem::path& folder, const ReadCase& read);

  /// As read_record().
  [[nodiscard]] std::optional<StrongMotionRecord> record(const std::filesystem::path& file,
                                                         const RecordOptions& options, Diagnostics& diagnostics);

  [[nodiscard]] bool has_identities() const { return files_change_; }
  /// As identify(), of files that change.
  [[nodiscard]] FileIdentity identity(const std::filesystem::path& file);

 private:
  bool files_change_ = false;
  mutable std::mutex mutex_;
  std::map<std::string, std::shared_ptr<const ReadBuilding>> buildings_;
  std::map<std::string, std::shared_ptr<const ReadCase>> but_motions_;
  std::map<std::string, std::shared_ptr<const StrongMotionRecord>> records_;
  std::map<std::string, FileIdentity> identities_;
  std::size_t values_ = 0;  // of all records
};

}  // namespace bentur
