#include "bentur/io/case/case_memo.h"

#include <fmt/format.h>
#include <sys/stat.h>

#include <cstdint>
#include <ctime>
#include <span>

namespace bentur {
namespace {

constexpr std::size_t most_buildings = 128;
constexpr std::size_t most_cases = 32;
constexpr std::size_t most_identities = 1024;
constexpr std::size_t most_values = std::size_t{4} << 20;  // of records: 32 MiB

void append_text(const std::string& text, std::string& key) {
  key += std::to_string(text.size());
  key += ':';
  key += text;
}

template <typename Number>
void append_bytes(const Number& number, std::string& key) {
  key.append(reinterpret_cast<const char*>(&number), sizeof number);
}

/// Appends what a value says, without its place in a file: two values have one key if and only if they say the same.
void append_content(const TomlValue& value, std::string& key) {
  key += static_cast<char>('a' + static_cast<int>(value.kind));
  switch (value.kind) {
    case TomlValue::Kind::table:
      key += std::to_string(value.members.size());
      for (const TomlMember& member : value.members) {
        append_text(member.key, key);
        append_content(member.value, key);
      }
      break;
    case TomlValue::Kind::list:
      key += std::to_string(value.size());
      key += ':';
      if (value.numbers) {
        for (const double x : *value.numbers) append_bytes(x, key);
      }
      for (const TomlValue& item : value.items) append_content(item, key);
      break;
    case TomlValue::Kind::text:
      append_text(value.text, key);
      append_bytes(reinterpret_cast<std::uintptr_t>(value.law.get()), key);
      break;
    case TomlValue::Kind::integer:
      append_bytes(value.integer, key);
      break;
    case TomlValue::Kind::real:
      append_bytes(value.real, key);
      break;
    case TomlValue::Kind::boolean:
      key += value.boolean ? '1' : '0';
      break;
    case TomlValue::Kind::date:
      break;
  }
}

std::string building_key(const TomlValue& table, const Units& units, std::span<const ReadBuilding> before) {
  std::string key;
  append_text(units.length, key);
  append_text(units.force, key);
  append_bytes(units.gravity, key);
  for (const ReadBuilding& building : before) append_text(building.spec.name, key);
  append_content(table, key);
  return key;
}

std::string key_but_motion(const TomlValue& root, const std::filesystem::path& folder) {
  std::string key;
  append_text(folder.string(), key);
  for (const TomlMember& member : root.members) {
    if (member.key == "excitation") continue;
    append_text(member.key, key);
    append_content(member.value, key);
  }
  return key;
}

/// Appends what tells a file from what stands there later. @return whether any later change would show
bool append_state(const std::string& file, std::string& key) {
  struct stat state = {};
  if (::stat(file.c_str(), &state) != 0) return false;
  append_bytes(state.st_dev, key);
  append_bytes(state.st_ino, key);
  append_bytes(state.st_size, key);
  append_bytes(state.st_mtim.tv_sec, key);
  append_bytes(state.st_mtim.tv_nsec, key);
  append_bytes(state.st_ctim.tv_sec, key);
  append_bytes(state.st_ctim.tv_nsec, key);
  constexpr std::time_t coarse = 1;  // [s], steps that a file system may count in
  const std::time_t now = std::time(nullptr);
  return state.st_ctim.tv_sec + coarse < now && state.st_mtim.tv_sec + coarse < now;
}

}  // namespace

std::shared_ptr<CaseMemo> CaseMemo::of_files_that_change() {
  auto memo = std::make_shared<CaseMemo>();
  memo->files_change_ = true;
  return memo;
}

std::shared_ptr<const ReadBuilding> CaseMemo::building(const TomlValue& table, const Units& units,
                                                       const std::vector<ReadBuilding>& before) const {
  const std::string key = building_key(table, units, before);
  const std::lock_guard lock(mutex_);
  const auto found = buildings_.find(key);
  return found == buildings_.end() ? nullptr : found->second;
}

void CaseMemo::keep(const TomlView& root, const Units& units, const std::vector<ReadBuilding>& buildings) {
  const TomlView list = *root.find("building");
  for (std::size_t b = 0; b < buildings.size(); ++b) {
    if (has_column_nodes(buildings[b].spec)) continue;  // what makes them stands in gaps, not in its table
    if (files_change_ && !buildings[b].spec.shapes_path.empty()) continue;
    std::string key = building_key(list.item(b).value(), units, std::span(buildings).first(b));
    const std::lock_guard lock(mutex_);
    if (buildings_.find(key) != buildings_.end()) continue;
    if (buildings_.size() >= most_buildings) buildings_.clear();
    buildings_.emplace(std::move(key), std::make_shared<const ReadBuilding>(buildings[b]));
  }
}

std::shared_ptr<const ReadCase> CaseMemo::but_motion(const TomlView& root, const std::filesystem::path& folder) const {
  if (files_change_) return nullptr;
  const std::string key = key_but_motion(root.value(), folder);
  const std::lock_guard lock(mutex_);
  const auto found = but_motions_.find(key);
  return found == but_motions_.end() ? nullptr : found->second;
}

void CaseMemo::keep(const TomlView& root, const std::filesystem::path& folder, const ReadCase& read) {
  if (files_change_) return;
  auto kept = std::make_shared<ReadCase>(read);
  kept->c.excitation = kept->c.excitation_y = {};
  kept->c.angle = {};
  kept->c.analysis = {};
  if (kept->plan) kept->plan->motions = {};
  std::string key = key_but_motion(root.value(), folder);
  const std::lock_guard lock(mutex_);
  if (but_motions_.size() >= most_cases) but_motions_.clear();
  but_motions_.emplace(std::move(key), std::move(kept));
}

std::optional<StrongMotionRecord> CaseMemo::record(const std::filesystem::path& file, const RecordOptions& options,
                                                   Diagnostics& diagnostics) {
  std::string key;
  append_text(file.string(), key);
  append_text(options.format, key);
  append_bytes(options.time_step.value_or(0), key);
  append_bytes(options.column.value_or(0), key);
  append_bytes(options.channel.value_or(0), key);
  append_bytes(options.skip_lines, key);
  append_text(options.component.value_or(""), key);
  append_text(options.unit, key);
  const bool is_kept = !files_change_ || append_state(file.string(), key);
  {
    const std::lock_guard lock(mutex_);
    const auto found = records_.find(key);
    if (found != records_.end()) return *found->second;
  }
  std::optional<StrongMotionRecord> record = read_record(file, options, diagnostics);
  if (!record || !is_kept) return record;
  const std::lock_guard lock(mutex_);
  if (values_ + record->values.size() > most_values) {
    records_.clear();
    values_ = 0;
  }
  if (records_.emplace(std::move(key), std::make_shared<const StrongMotionRecord>(*record)).second) {
    values_ += record->values.size();
  }
  return record;
}

FileIdentity CaseMemo::identity(const std::filesystem::path& file) {
  std::string key;
  append_text(file.string(), key);
  const bool is_kept = append_state(file.string(), key);
  {
    const std::lock_guard lock(mutex_);
    const auto found = identities_.find(key);
    if (found != identities_.end()) return found->second;
  }
  FileIdentity identity = identify(file);
  if (!is_kept) return identity;
  const std::lock_guard lock(mutex_);
  if (identities_.size() >= most_identities) identities_.clear();
  identities_.emplace(std::move(key), identity);
  return identity;
}

}  // namespace bentur
