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
#include "bentur/io/records/record_files.h"

namespace bentur {

/// What many readings of nearly the same case share: buildings that are given alike, with their modes, and records.
/// Only what was found right is kept, and only so much of it; anything else is read again. Many threads may use it at
/// once.
class CaseMemo {
 public:
  /// The building made before of the same table, units and names of the buildings `before` it; null when there is none.
  [[nodiscard]] std::shared_ptr<const ReadBuilding> building(const TomlValue& table, const Units& units,
                                                             const std::vector<ReadBuilding>& before) const;
  /// Keeps the buildings of a case that is right.
  void keep(const TomlView& root, const Units& units, const std::vector<ReadBuilding>& buildings);

  /// As read_record().
  [[nodiscard]] std::optional<StrongMotionRecord> record(const std::filesystem::path& file,
                                                         const RecordOptions& options, Diagnostics& diagnostics);

 private:
  mutable std::mutex mutex_;
  std::map<std::string, std::shared_ptr<const ReadBuilding>> buildings_;
  std::map<std::string, std::shared_ptr<const StrongMotionRecord>> records_;
  std::size_t values_ = 0;  // of all records
};

}  // namespace bentur
