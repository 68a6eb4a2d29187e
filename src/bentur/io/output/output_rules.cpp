#include "bentur/io/output/output_rules.h"

#include <algorithm>
#include <string>
#include <system_error>

namespace bentur {
namespace {

namespace fs = std::filesystem;

constexpr int most_links = 40;  // of a chain, as the system has it

/// What a symbolic link leads to in the end, there or not; `path` itself where it is none.
fs::path behind_links(const fs::path& path) {
  fs::path place = path;
  for (int links = 0; links < most_links; ++links) {
    std::error_code failed;
    if (!fs::is_symlink(fs::symlink_status(place, failed))) return place;
    const fs::path next = fs::read_symlink(place, failed);
    if (failed) break;
    place = place.parent_path() / next;  // `next` alone where it is absolute
  }
  throw RefusedOutput(path, "is a symbolic link that leads nowhere; give the name of a file");
}

/// Why nothing is written to something that is not a regular file; empty for a regular one and where there is nothing.
std::string not_a_file(fs::file_type type) {
  switch (type) {
    case fs::file_type::directory:
      return "is a folder; give the name of a file";
    case fs::file_type::block:
    case fs::file_type::character:
      return "is a device; give the name of a file";
    case fs::file_type::fifo:
      return "is a pipe; give the name of a file";
    case fs::file_type::socket:
      return "is a socket; give the name of a file";
    default:
      return "";
  }
}

}  // namespace

bool OutputRules::is_input(const fs::path& file) const {
  return std::any_of(inputs.begin(), inputs.end(), [&](const fs::path& input) {
    std::error_code failed;
    return fs::equivalent(file, input, failed) && !failed;
  });
}

fs::path output_target(const fs::path& path, ResultKind kind, const OutputRules& rules) {
  std::error_code failed;
  const fs::file_status there = fs::status(path, failed);
  if (const std::string why = not_a_file(there.type()); !why.empty()) throw RefusedOutput(path, why);
  fs::path target = behind_links(path);
  if (!fs::exists(there)) return target;
  if (rules.is_input(target)) throw RefusedOutput(path, "is read by this very command; give another name");
  if (rules.force) return target;
  constexpr fs::perms writable = fs::perms::owner_write | fs::perms::group_write | fs::perms::others_write;
  if ((there.permissions() & writable) == fs::perms::none) {
    throw RefusedOutput(path, std::string("is write-protected; ") + rules.forced_by + " replaces it");
  }
  const bool is_ours = is_result(target, kind) || (rules.is_netcdf && rules.is_netcdf(target, kind));
  if (fs::file_size(target, failed) != 0 && !is_ours) {
    throw RefusedOutput(path, "is there and is not " + std::string(kind_name(kind)) +
                                  "; give another name, or replace it with " + rules.forced_by);
  }
  return target;
}

}  // namespace bentur
