#include "bentur/files/atomic_file.h"

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

/// A new file beside `file`, open for writing, with the permissions any new file gets; `path` becomes its name.
int open_temporary(const fs::path& file, std::string& path) {
  const fs::path folder = file.has_parent_path() ? file.parent_path() : fs::path(".");
  path = (folder / ("." + file.filename().string() + "-XXXXXX")).string();
  const int descriptor = ::mkstemp(path.data());
  if (descriptor < 0) fail(file, "cannot write", errno);
  const mode_t mask = ::umask(0);
  ::umask(mask);
  if (::fchmod(descriptor, 0666 & ~mask) != 0) {
    const int error = errno;
    ::close(descriptor);
    ::unlink(path.c_str());
    fail(file, "cannot write", error);
  }
  return descriptor;
}

/// Writes all of `content` to a new file beside `file`. @return its path; nothing is left behind on failure.
fs::path write_temporary(const fs::path& file, std::string_view content) {
  std::string path;
  const int descriptor = open_temporary(file, path);
  int error = 0;
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
    ::unlink(path.c_str());
    fail(file, "cannot write", error);
  }
  return path;
}

}  // namespace

fs::path make_temporary(const fs::path& file) { return write_temporary(file, ""); }

AtomicFiles::AtomicFiles(fs::path directory, OutputRules rules)
    : directory_(directory.empty() ? fs::path(".") : std::move(directory)), rules_(std::move(rules)) {
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
        if (errno == ENOTDIR) throw RefusedOutput(directory_, "is below something that is not a folder");
        fail(directory_, "cannot create the folder", errno);
      }
    }
    if (!fs::is_directory(directory_, code)) throw RefusedOutput(directory_, "is not a folder; give another name");
    fs::remove(make_temporary(directory_ / "bentur"));
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

void AtomicFiles::expect(const std::string& name, ResultKind kind) const {
  static_cast<void>(output_target(directory_ / name, kind, rules_));
}

void AtomicFiles::add(const std::string& name, std::string_view content, ResultKind kind) {
  const fs::path target = output_target(directory_ / name, kind, rules_);
  files_.emplace_back(write_temporary(target, content), target);
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
