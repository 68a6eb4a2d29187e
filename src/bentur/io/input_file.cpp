#include "bentur/io/input_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <system_error>

namespace bentur {
namespace {

std::string cannot_be_read(int error) { return "cannot be read: " + std::generic_category().message(error); }

std::string too_large(const InputKind& kind) {
  return fmt::format("is larger than {} MiB, which no {} is", kind.largest >> 20, kind.what);
}

std::string problem_with(const struct stat& status, const InputKind& kind) {
  if (S_ISDIR(status.st_mode)) return fmt::format("is a folder, not a {}", kind.what);
  if (S_ISFIFO(status.st_mode)) return fmt::format("is a pipe, but a {} is read from a regular file only", kind.what);
  if (!S_ISREG(status.st_mode)) {
    return fmt::format("is a device, but a {} is read from a regular file only", kind.what);
  }
  return static_cast<std::uintmax_t>(status.st_size) > kind.largest ? too_large(kind) : "";
}

/// A file that closes by itself.
struct OpenInput {
  explicit OpenInput(int number) : descriptor(number) {}
  OpenInput(const OpenInput&) = delete;
  OpenInput& operator=(const OpenInput&) = delete;
  ~OpenInput() {
    if (descriptor >= 0) ::close(descriptor);
  }
  int descriptor;
};

}  // namespace

std::string input_problem(const std::filesystem::path& file, const InputKind& kind) {
  struct stat status {};
  if (file.native().find('\0') != std::string::npos) return "there is no such file";
  if (::stat(file.c_str(), &status) != 0) {
    return errno == ENOENT || errno == ENOTDIR ? "there is no such file" : cannot_be_read(errno);
  }
  return problem_with(status, kind);
}

std::optional<std::string> read_input(const std::filesystem::path& file, const InputKind& kind, std::string& problem) {
  problem = input_problem(file, kind);
  if (!problem.empty()) return std::nullopt;
  // It may have become something else since: O_NONBLOCK does not wait for a pipe, and what is open is looked at again.
  const OpenInput open(::open(file.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC | O_NOCTTY));
  struct stat status {};
  if (open.descriptor < 0 || ::fstat(open.descriptor, &status) != 0) {
    problem = cannot_be_read(errno);
    return std::nullopt;
  }
  problem = problem_with(status, kind);
  if (!problem.empty()) return std::nullopt;
  std::string text;
  text.reserve(static_cast<std::size_t>(status.st_size));
  std::array<char, std::size_t{1} << 16> buffer{};
  while (true) {
    const ssize_t count = ::read(open.descriptor, buffer.data(), buffer.size());
    if (count == 0) return text;
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) {
      problem = cannot_be_read(errno);
      return std::nullopt;
    }
    text.append(buffer.data(), static_cast<std::size_t>(count));
    if (text.size() > kind.largest) {  // a file of /proc has no size beforehand
      problem = too_large(kind);
      return std::nullopt;
    }
  }
}

std::optional<std::string> read_input(const std::filesystem::path& file, const InputKind& kind,
                                      Diagnostics& diagnostics) {
  std::string problem;
  auto text = read_input(file, kind, problem);
  if (!text) diagnostics.error({file.string(), 0, 0}, problem);
  return text;
}

}  // namespace bentur
