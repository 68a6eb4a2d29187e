#include "bentur/report/files/picture.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <boost/crc.hpp>
#include <cerrno>
#include <cmath>
#include <cstdint>
#include <fstream>
#include <iterator>
#include <optional>
#include <system_error>
#include <utility>

#include "bentur/core/text.h"
#include "bentur/io/output/atomic_file.h"
#include "bentur/io/temporary_folder.h"
#include "bentur/report/files/pdf_title.h"

namespace bentur {
namespace {

[[noreturn]] void fail(const std::string& what, int code) {
  throw std::runtime_error("rsvg-convert: " + what + ": " + std::generic_category().message(code));
}

/// What a program has printed, and its exit status.
struct Ended {
  int status = 0;
  std::string output;
};

/// What a child does with its files before it becomes another program.
class FileActions {
 public:
  FileActions() { check(posix_spawn_file_actions_init(&actions_)); }
  ~FileActions() { posix_spawn_file_actions_destroy(&actions_); }
  FileActions(const FileActions&) = delete;
  FileActions& operator=(const FileActions&) = delete;
  static void check(int error) {
    if (error != 0) fail("cannot be started", error);
  }
  posix_spawn_file_actions_t* get() { return &actions_; }

 private:
  posix_spawn_file_actions_t actions_{};
};

/// Runs rsvg-convert in a folder, standard input empty, standard output and error kept; nothing where there is no such
/// program.
std::optional<Ended> convert(std::vector<std::string> arguments, const std::string& folder) {
  arguments.insert(arguments.begin(), "rsvg-convert");
  std::vector<char*> argv;
  for (std::string& argument : arguments) argv.push_back(argument.data());
  argv.push_back(nullptr);
  std::array<int, 2> pipe{};
  if (::pipe2(pipe.data(), O_CLOEXEC) != 0) fail("cannot be started", errno);
  pid_t child = 0;
  int error = 0;
  {
    FileActions actions;
    FileActions::check(posix_spawn_file_actions_addopen(actions.get(), STDIN_FILENO, "/dev/null", O_RDONLY, 0));
    FileActions::check(posix_spawn_file_actions_adddup2(actions.get(), pipe[1], STDOUT_FILENO));
    FileActions::check(posix_spawn_file_actions_adddup2(actions.get(), pipe[1], STDERR_FILENO));
    FileActions::check(posix_spawn_file_actions_addchdir_np(actions.get(), folder.c_str()));
    error = posix_spawnp(&child, "rsvg-convert", actions.get(), nullptr, argv.data(), environ);
  }
  ::close(pipe[1]);
  Ended outcome;
  std::array<char, 4096> buffer{};
  for (ssize_t got = 0; error == 0 && (got = ::read(pipe[0], buffer.data(), buffer.size())) != 0;) {
    if (got > 0) {
      outcome.output.append(buffer.data(), static_cast<std::size_t>(got));
    } else if (errno != EINTR) {
      break;
    }
  }
  ::close(pipe[0]);
  if (error == ENOENT) return std::nullopt;
  if (error != 0) fail("cannot be started", error);
  while (::waitpid(child, &outcome.status, 0) < 0) {
    if (errno != EINTR) fail("is lost", errno);
  }
  return outcome;
}

std::string big_endian(std::uint32_t number) {
  std::string bytes;
  for (const int shift : {24, 16, 8, 0}) bytes += static_cast<char>(number >> shift & 0xFFU);
  return bytes;
}

/// A PNG that says how large it is: the chunk pHYs, in pixels per metre, before the first chunk of data (PNG
/// specification, 11.3.5.3), which rsvg-convert does not write. Without it a word processor takes 96 an inch.
std::string with_resolution(std::string png, double pixels_per_inch) {
  constexpr std::size_t behind_header =
      8 + 4 + 4 + 13 + 4;               // signature, and the chunk IHDR with length, name and check
  constexpr double metre = 1 / 0.0254;  // [inch]
  const std::string per_metre = big_endian(static_cast<std::uint32_t>(std::lround(pixels_per_inch * metre)));
  const std::string chunk = "pHYs" + per_metre + per_metre + '\x01';
  boost::crc_32_type check;
  check.process_bytes(chunk.data(), chunk.size());
  return png.insert(behind_header, big_endian(9) + chunk + big_endian(check.checksum()));
}

}  // namespace

NoConverter::NoConverter()
    : std::runtime_error(
          "rsvg-convert is not installed, which makes PDF and PNG of a figure (Debian: apt install librsvg2-bin "
          "fonts-dejavu-core); SVG needs nothing") {}

const std::vector<std::string>& picture_formats() {
  static const std::vector<std::string> formats = {"svg", "pdf", "png"};
  return formats;
}

bool can_draw(const std::string& format) {
  if (format == "svg") return true;
  const std::optional<Ended> outcome = convert({"--version"}, "/");
  return outcome && outcome->status == 0;
}

std::string draw(const Figure& figure, const std::string& format) {
  std::string svg = figure_svg(figure);
  if (format == "svg") return svg;
  const TemporaryFolder folder;
  AtomicFiles files(folder.path());
  files.add("figure.svg", std::move(svg), ResultKind::picture);
  files.commit();
  constexpr double png_density = 300, svg_density = 96;  // pixels an inch
  const std::string dense = fmt::format("{}", png_density / svg_density);
  const auto outcome = convert(
      {"--format", format, "--zoom", format == "png" ? dense : std::string("1"), "--output", "drawn", "figure.svg"},
      folder.path().string());
  if (!outcome) throw NoConverter();
  std::ifstream file(folder.path() / "drawn", std::ios::binary);
  const bool ended = WIFEXITED(outcome->status) && WEXITSTATUS(outcome->status) == 0;
  std::string bytes(std::istreambuf_iterator<char>(file), {});
  if (!ended || bytes.empty()) {
    const std::string_view reason = trimmed(outcome->output, " \t\r\n");
    throw std::runtime_error("rsvg-convert cannot draw: " + std::string(reason.empty() ? "no reason given" : reason));
  }
  if (format == "pdf") return with_title(std::move(bytes), figure.title);
  return format == "png" && bytes.size() > 64 ? with_resolution(std::move(bytes), png_density) : bytes;
}

}  // namespace bentur
