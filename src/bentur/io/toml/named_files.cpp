#include "bentur/io/toml/named_files.h"

#include <fmt/format.h>
#include <glob.h>

#include <algorithm>
#include <system_error>

namespace bentur {

namespace fs = std::filesystem;

namespace {

/// The files that a pattern names, sorted, with the pattern's own folder before them.
std::vector<fs::path> matches(const std::string& pattern, const fs::path& folder) {
  std::string whole;
  for (const char c : folder.string()) {
    if (c == '*' || c == '?' || c == '[' || c == '\\') whole += '\\';
    whole += c;
  }
  whole = (fs::path(whole) / pattern).string();
  glob_t found{};
  std::vector<fs::path> names;
  if (::glob(whole.c_str(), 0, nullptr, &found) == 0) {
    for (std::size_t i = 0; i < found.gl_pathc; ++i) names.emplace_back(found.gl_pathv[i]);
  }
  ::globfree(&found);
  std::sort(names.begin(), names.end());
  return names;
}

}  // namespace

std::vector<fs::path> named_files(const TomlView& named, const std::string& text, const fs::path& folder,
                                  const std::string& relative_to, const std::string& otherwise) {
  std::error_code ignored;
  const std::string relative = fmt::format(" (names are relative to {}){}", relative_to, otherwise);
  if (text.find_first_of("*?[") == std::string::npos) {
    if (fs::exists(folder / text, ignored)) return {folder / text};
    named.error_value("there is no such file" + relative);
    return {};
  }
  std::vector<fs::path> found = matches(text, folder);
  if (found.empty()) {
    const fs::path above = fs::path(text).parent_path();
    const bool there = above.empty() || fs::is_directory(folder / above, ignored) ||
                       above.string().find_first_of("*?[") != std::string::npos;
    named.error_value(fmt::format("no file matches{}{}",
                                  there ? "" : fmt::format(": there is no folder {}", above.string()), relative));
  }
  return found;
}

std::string way_from(const fs::path& folder, const fs::path& file) {
  std::error_code failed;
  const fs::path absolute = fs::absolute(file, failed).lexically_normal();
  const fs::path base = fs::absolute(folder.empty() ? fs::path(".") : folder, failed).lexically_normal();
  const fs::path way = absolute.lexically_relative(base);
  return (way.empty() ? absolute : way).string();
}

}  // namespace bentur
