#include "bentur/io/output/atomic_file.h"

#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <charconv>
#include <csignal>
#include <cstdlib>
#include <functional>
#include <stdexcept>
#include <system_error>

namespace bentur {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(const fs::path& path, const std::string& what, int code) {
  throw std::runtime_error(path.string() + ": " + what + ": " + std::generic_category().message(code));
}

/// What the names of this process's temporary files begin with, and those of others that ran where it runs: numbers of
/// processes mean the same only on one machine and in one container of it. Empty where that cannot be told.
const std::string& temporary_names() {
  static const std::string names = [] {
    std::array<char, 256> host{}, container{};
    if (::gethostname(host.data(), host.size() - 1) != 0) return std::string();
    if (::readlink("/proc/self/ns/pid", container.data(), container.size() - 1) <= 0) return std::string();
    const std::size_t place = std::hash<std::string>()(std::string(host.data()) + container.data());
    return fmt::format(".bentur-{:08x}-", place & 0xffffffff);
  }();
  return names;
}

/// Removes what runs that were killed have left in a folder. Only files named as ours of a process that is gone.
void remove_orphans(const fs::path& folder) {
  const std::string& ours = temporary_names();
  if (ours.empty()) return;
  std::error_code code;
  std::vector<fs::path> orphans;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, code)) {
    const std::string name = entry.path().filename().string();
    if (!name.starts_with(ours)) continue;
    const char* const end = name.data() + name.size();
    pid_t process = 0;
    const auto [rest, problem] = std::from_chars(name.data() + ours.size(), end, process);
    const bool named_so = problem == std::errc() && process > 0 && end - rest == 7 && *rest == '-';
    if (named_so && ::kill(process, 0) != 0 && errno == ESRCH) orphans.push_back(entry.path());
  }
  for (const fs::path& orphan : orphans) fs::remove(orphan, code);
}

/// Writes all of `content` to a new file beside `file`, with the permissions any new file gets. @return its path;
/// nothing is left behind on failure.
fs::path write_temporary(const fs::path& file, std::string_view content) {
  const fs::path folder = file.has_parent_path() ? file.parent_path() : fs::path(".");
  remove_orphans(folder);
  const std::string ours = temporary_names().empty() ? ".bentur-" : temporary_names();
  std::string path = (folder / fmt::format("{}{}-XXXXXX", ours, ::getpid())).string();
  OpenFile open(::mkstemp(path.data()), file);
  try {
    const mode_t mask = ::umask(0);
    ::umask(mask);
    if (::fchmod(open.descriptor(), 0666 & ~mask) != 0) fail(file, "cannot write", errno);
    open.write(content, 0);
    open.close();
  } catch (...) {
    ::unlink(path.c_str());
    throw;
  }
  return path;
}

}  // namespace

OpenFile::OpenFile(int descriptor, fs::path name, const char* problem)
    : descriptor_(descriptor), name_(std::move(name)) {
  if (descriptor < 0) fail(problem);
}

OpenFile::OpenFile(OpenFile&& other) noexcept
    : descriptor_(std::exchange(other.descriptor_, -1)), name_(std::move(other.name_)) {}

OpenFile::~OpenFile() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

void OpenFile::fail(const char* problem) const { bentur::fail(name_, problem, errno); }

void OpenFile::write(std::span<const char> bytes, std::size_t offset) const {
  while (!bytes.empty()) {
    const ssize_t written = ::pwrite(descriptor_, bytes.data(), bytes.size(), static_cast<off_t>(offset));
    if (written < 0) {
      if (errno == EINTR) continue;
      fail("cannot write");
    }
    bytes = bytes.subspan(static_cast<std::size_t>(written));
    offset += static_cast<std::size_t>(written);
  }
}

void OpenFile::read(std::span<char> bytes, std::size_t offset) const {
  while (!bytes.empty()) {
    const ssize_t got = ::pread(descriptor_, bytes.data(), bytes.size(), static_cast<off_t>(offset));
    if (got < 0) {
      if (errno == EINTR) continue;
      fail("cannot read");
    }
    if (got == 0) {
      std::fill(bytes.begin(), bytes.end(), '\0');
      return;
    }
    bytes = bytes.subspan(static_cast<std::size_t>(got));
    offset += static_cast<std::size_t>(got);
  }
}

void OpenFile::sync() const {
  if (::fdatasync(descriptor_) != 0) fail("cannot write");
}

void OpenFile::close() {
  if (::close(std::exchange(descriptor_, -1)) != 0) fail("cannot write");
}

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
