#include "bentur/io/results/atomic_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <stdexcept>
#include <system_error>

namespace bentur {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(const fs::path& path, const std::string& what, int code) {
  throw std::runtime_error(path.string() + ": " + what + ": " + std::generic_category().message(code));
}

/// Writes all of `content` to a new file made from `pattern` (ending in XXXXXX) with the permissions any new file gets.
/// @return its path; nothing is left behind on failure.
fs::path write_temporary(std::string pattern, std::string_view content, const fs::path& shown) {
  const int descriptor = ::mkstemp(pattern.data());
  if (descriptor < 0) {
    fail(shown, "cannot write", errno);
  }
  const mode_t mask = ::umask(0);
  ::umask(mask);
  int error = ::fchmod(descriptor, 0666 & ~mask) == 0 ? 0 : errno;
  while (error == 0 && !content.empty()) {
    const ssize_t written = ::write(descriptor, content.data(), content.size());
    if (written >= 0) {
      content.remove_prefix(static_cast<std::size_t>(written));
    } else if (errno != EINTR) {
      error = errno;
    }
  }
  if (::close(descriptor) != 0 && error == 0) {
    error = errno;
  }
  if (error != 0) {
    ::unlink(pattern.c_str());
    fail(shown, "cannot write", error);
  }
  return pattern;
}

}  // namespace

AtomicFiles::AtomicFiles(fs::path directory) : directory_(directory.empty() ? fs::path(".") : std::move(directory)) {
  std::error_code code;
  for (fs::path path = directory_; !path.empty() && !fs::exists(path, code); path = path.parent_path()) {
    if (path.has_filename()) {  // "a/b/" has an empty last part
      made_.push_back(path);
    }
  }
  std::reverse(made_.begin(), made_.end());
  std::size_t done = 0;
  try {
    for (; done < made_.size(); ++done) {
      if (::mkdir(made_[done].c_str(), 0777) != 0) {
        fail(directory_, "cannot create the folder", errno);
      }
    }
    if (!fs::is_directory(directory_, code)) {
      throw std::runtime_error(directory_.string() + ": is not a folder");
    }
    fs::remove(write_temporary((directory_ / ".bentur-XXXXXX").string(), "", directory_));
  } catch (...) {
    while (done > 0) {
      fs::remove(made_[--done], code);
    }
    throw;
  }
}

AtomicFiles::~AtomicFiles() {
  std::error_code code;
  for (const auto& [temporary, name] : files_) {
    fs::remove(temporary, code);
  }
  for (auto path = made_.rbegin(); path != made_.rend(); ++path) {
    fs::remove(*path, code);  // fails, as it should, where something else has been put into the folder
  }
}

void AtomicFiles::add(const std::string& name, std::string_view content) {
  const fs::path path = directory_ / name;
  if (fs::is_directory(path)) {
    throw std::runtime_error(path.string() + ": is a folder");
  }
  files_.emplace_back(write_temporary((directory_ / ("." + name + "-XXXXXX")).string(), content, path), path);
}

void AtomicFiles::commit() {
  while (!files_.empty()) {
    const auto& [temporary, name] = files_.front();
    std::error_code code;
    fs::rename(temporary, name, code);
    if (code) {
      fail(name, "cannot write", code.value());
    }
    files_.erase(files_.begin());
    made_.clear();
  }
}

}  // namespace bentur
