#include "bentur/runner/internal/journal.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <optional>
#include <stdexcept>
#include <system_error>
#include <thread>
#include <utility>

#include "bentur/files/atomic_file.h"

namespace bentur {
namespace {

namespace fs = std::filesystem;

constexpr char magic[16] = "bentur journal1";
constexpr std::size_t page = 4096;                  // where the first slot begins
constexpr std::size_t smallest_payload = 248;       // so that there is room for a message
constexpr std::size_t largest_header = 256U << 20;  // bytes

/// Stands before the payload of a slot: its values, or the text of its message.
struct SlotHead {
  std::uint64_t checksum = 0;
  std::uint32_t state = 0;   // 0 empty, else 1 + status
  std::uint32_t length = 0;  // of the message [bytes]
};

/// FNV-1a [FowlerNollVo] over eight bytes at a time.
std::uint64_t checksum(std::span<const char> bytes, std::uint64_t start) {
  std::uint64_t hash = 0xcbf29ce484222325U ^ start;
  for (std::size_t i = 0; i < bytes.size(); i += 8) {
    std::uint64_t word = 0;
    std::memcpy(&word, bytes.data() + i, std::min<std::size_t>(8, bytes.size() - i));
    hash = (hash ^ word) * 0x100000001b3U;
    hash ^= hash >> 32;
  }
  return hash;
}

/// Of everything in a slot behind the checksum, and of the run it belongs to.
std::uint64_t slot_checksum(std::span<const char> slot, std::size_t run) {
  return checksum(slot.subspan(sizeof(std::uint64_t)), run + 1);
}

void append(std::uint64_t number, std::string& text) {
  text.append(reinterpret_cast<const char*>(&number), sizeof number);
}

void append(const std::string& part, std::string& text) {
  append(part.size(), text);
  text += part;
}

std::string header_text(const JournalOrigin& origin) {
  std::string text;
  append(origin.version, text);
  append(origin.study, text);
  append(origin.case_text, text);
  append(origin.records.size(), text);
  for (const auto& [name, hash] : origin.records) {
    append(name, text);
    append(hash, text);
  }
  append(origin.runs, text);
  append(origin.values, text);
  return text;
}

/// Takes a header apart; the checksum has shown that it is whole.
class HeaderReader {
 public:
  explicit HeaderReader(const std::string& text) : text_(text) {}
  std::uint64_t number() {
    std::uint64_t result = 0;
    if (text_.size() - at_ < sizeof result) throw std::runtime_error("its header is too short");
    std::memcpy(&result, text_.data() + at_, sizeof result);
    at_ += sizeof result;
    return result;
  }
  std::string part() {
    const std::uint64_t size = number();
    if (text_.size() - at_ < size) throw std::runtime_error("its header is too short");
    at_ += size;
    return text_.substr(at_ - size, size);
  }

 private:
  const std::string& text_;
  std::size_t at_ = 0;
};

JournalOrigin origin_of(const std::string& header) {
  HeaderReader reader(header);
  JournalOrigin origin;
  origin.version = reader.part();
  origin.study = reader.part();
  origin.case_text = reader.part();
  for (std::uint64_t left = reader.number(); left > 0; --left) {
    const std::string name = reader.part();
    origin.records[name] = reader.part();
  }
  origin.runs = reader.number();
  origin.values = reader.number();
  return origin;
}

/// Number of the first line in which two texts differ, from 1.
std::size_t differing_line(const std::string& a, const std::string& b) {
  const auto at = std::mismatch(a.begin(), a.end(), b.begin(), b.end()).first;
  return static_cast<std::size_t>(std::count(a.begin(), at, '\n')) + 1;
}

[[noreturn]] void fail_with(const fs::path& file, const std::string& what, int code) {
  throw std::runtime_error(fmt::format("{}: {}: {}", file.string(), what, std::generic_category().message(code)));
}

void write_bytes(int descriptor, const fs::path& file, std::span<const char> bytes, std::size_t offset) {
  while (!bytes.empty()) {
    const ssize_t written = ::pwrite(descriptor, bytes.data(), bytes.size(), static_cast<off_t>(offset));
    if (written < 0) {
      if (errno == EINTR) continue;
      fail_with(file, "cannot write", errno);
    }
    bytes = bytes.subspan(static_cast<std::size_t>(written));
    offset += static_cast<std::size_t>(written);
  }
}

/// Nobody else may write the same file. One that was killed may take its time to go.
void lock(int descriptor, const fs::path& file) {
  constexpr auto pause = std::chrono::milliseconds(100);
  constexpr int most = 30;
  for (int tries = 0; ::flock(descriptor, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK; ++tries) {
    if (tries == most) throw std::runtime_error(file.string() + ": another program is writing it");
    std::this_thread::sleep_for(pause);
  }
}

/// Bytes before the first slot: magic, size, header, checksum, up to a whole page.
std::size_t slots_begin(std::size_t header) {
  return (sizeof magic + 2 * sizeof(std::uint64_t) + header + page - 1) / page * page;
}

struct Descriptor {
  int value = -1;
  ~Descriptor() {
    if (value >= 0) ::close(value);
  }
  int release() { return std::exchange(value, -1); }
};

}  // namespace

std::optional<std::string> difference(const JournalOrigin& then, const JournalOrigin& now) {
  if (then.version != now.version) return fmt::format("by bentur {}, this is {}", then.version, now.version);
  if (then.study != now.study) {
    return fmt::format("with another study: line {} has changed", differing_line(then.study, now.study));
  }
  if (then.case_text != now.case_text) {
    return fmt::format("with another case: line {} has changed", differing_line(then.case_text, now.case_text));
  }
  for (const auto& [name, hash] : now.records) {
    const auto before = then.records.find(name);
    if (before == then.records.end()) return fmt::format("without the record {}", name);
    if (before->second != hash) return fmt::format("with another record: {} has changed", name);
  }
  for (const auto& [name, hash] : then.records) {
    if (now.records.find(name) == now.records.end()) return fmt::format("with the record {}, which is gone", name);
  }
  if (then.runs != now.runs || then.values != now.values) {
    return fmt::format("with {} runs of {} values, now there are {} of {}", then.runs, then.values, now.runs,
                       now.values);
  }
  return std::nullopt;
}

Journal::Journal(fs::path file, int descriptor, const JournalOrigin& origin, std::size_t first_slot)
    : file_(std::move(file)),
      descriptor_(descriptor),
      values_(origin.values),
      slot_(sizeof(SlotHead) + std::max(smallest_payload, origin.values * sizeof(double))),
      first_slot_(first_slot),
      done_(origin.runs, false),
      buffer_(slot_) {}

Journal::Journal(Journal&& other) noexcept
    : file_(std::move(other.file_)),
      descriptor_(std::exchange(other.descriptor_, -1)),
      values_(other.values_),
      slot_(other.slot_),
      first_slot_(other.first_slot_),
      done_(std::move(other.done_)),
      count_(other.count_),
      buffer_(std::move(other.buffer_)) {}

Journal::~Journal() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

void Journal::fail(const char* what, int code) const { fail_with(file_, what, code); }

Journal Journal::begin(const fs::path& file, const JournalOrigin& origin) {
  // Under another name until its header is whole.
  const std::string header = header_text(origin);
  std::string start(magic, sizeof magic);
  append(header.size(), start);
  start += header;
  append(checksum(header, 0), start);
  const fs::path unfinished = make_temporary(file);
  try {
    Descriptor descriptor{::open(unfinished.c_str(), O_RDWR | O_CLOEXEC)};
    if (descriptor.value < 0) fail_with(file, "cannot write", errno);
    lock(descriptor.value, file);
    write_bytes(descriptor.value, file, start, 0);
    if (::fsync(descriptor.value) != 0) fail_with(file, "cannot write", errno);
    if (::link(unfinished.c_str(), file.c_str()) == 0) {
      ::unlink(unfinished.c_str());
    } else if (errno == EEXIST) {
      throw std::runtime_error(file.string() + ": another program has just begun it");
    } else if (::rename(unfinished.c_str(), file.c_str()) != 0) {  // a file system without hard links
      fail_with(file, "cannot write", errno);
    }
    return {file, descriptor.release(), origin, slots_begin(header.size())};
  } catch (...) {
    ::unlink(unfinished.c_str());
    throw;
  }
}

Journal Journal::resume(const fs::path& file, const JournalOrigin& origin) {
  Descriptor descriptor{::open(file.c_str(), O_RDWR | O_CLOEXEC)};
  if (descriptor.value < 0) fail_with(file, "cannot go on with it", errno);
  lock(descriptor.value, file);
  const auto refuse = [&](const std::string& why) { throw std::runtime_error(file.string() + ": " + why); };
  char start[sizeof magic + sizeof(std::uint64_t)];
  const auto read_all = [&](char* bytes, std::size_t size, std::size_t offset) {
    if (::pread(descriptor.value, bytes, size, static_cast<off_t>(offset)) != static_cast<ssize_t>(size)) {
      refuse("is not the journal of a sweep");
    }
  };
  read_all(start, sizeof start, 0);
  std::uint64_t size = 0;
  std::memcpy(&size, start + sizeof magic, sizeof size);
  if (std::memcmp(start, magic, sizeof magic) != 0 || size > largest_header) refuse("is not the journal of a sweep");
  std::string header(size, '\0');
  read_all(header.data(), size, sizeof start);
  std::uint64_t sum = 0;
  read_all(reinterpret_cast<char*>(&sum), sizeof sum, sizeof start + size);
  if (sum != checksum(header, 0)) refuse("is damaged");
  if (const auto differs = difference(origin_of(header), origin)) {
    refuse(fmt::format("was begun {}. Remove it to begin anew", *differs));
  }
  Journal journal(file, descriptor.release(), origin, slots_begin(size));
  journal.find_done();
  return journal;
}

void Journal::read_bytes(std::span<char> bytes, std::size_t offset) const {
  while (!bytes.empty()) {
    const ssize_t got = ::pread(descriptor_, bytes.data(), bytes.size(), static_cast<off_t>(offset));
    if (got < 0) {
      if (errno == EINTR) continue;
      fail("cannot read", errno);
    }
    if (got == 0) {  // not written so far
      std::fill(bytes.begin(), bytes.end(), '\0');
      return;
    }
    bytes = bytes.subspan(static_cast<std::size_t>(got));
    offset += static_cast<std::size_t>(got);
  }
}

void Journal::find_done() {
  const std::size_t at_once = std::max<std::size_t>(1, (1U << 20) / slot_);
  std::vector<char> bytes(at_once * slot_);
  for (std::size_t first = 0; first < done_.size(); first += at_once) {
    const std::size_t count = std::min(at_once, done_.size() - first);
    read_bytes(std::span(bytes).first(count * slot_), first_slot_ + first * slot_);
    for (std::size_t i = 0; i < count; ++i) {
      const std::span<const char> slot = std::span(bytes).subspan(i * slot_, slot_);
      SlotHead head;
      std::memcpy(&head, slot.data(), sizeof head);
      done_[first + i] = head.state != 0 && head.checksum == slot_checksum(slot, first + i);
      count_ += done_[first + i] ? 1 : 0;
    }
  }
}

void Journal::write(const RunResult& result) {
  SlotHead head;
  head.state = 1 + static_cast<std::uint32_t>(result.status);
  std::fill(buffer_.begin(), buffer_.end(), '\0');
  char* payload = buffer_.data() + sizeof head;
  if (result.status == RunStatus::done) {
    std::memcpy(payload, result.values.data(), values_ * sizeof(double));
  } else {
    head.length = static_cast<std::uint32_t>(std::min(result.message.size(), slot_ - sizeof head));
    std::memcpy(payload, result.message.data(), head.length);
  }
  std::memcpy(buffer_.data(), &head, sizeof head);
  head.checksum = slot_checksum(buffer_, result.run);
  std::memcpy(buffer_.data(), &head, sizeof head);
  write_bytes(descriptor_, file_, buffer_, first_slot_ + result.run * slot_);
  if (!done_[result.run]) ++count_;
  done_[result.run] = true;
}

void Journal::sync() {
  if (::fdatasync(descriptor_) != 0) fail("cannot write", errno);
}

std::vector<RunResult> Journal::read(std::size_t first, std::size_t count) const {
  std::vector<char> bytes(count * slot_);
  read_bytes(bytes, first_slot_ + first * slot_);
  std::vector<RunResult> results(count);
  for (std::size_t i = 0; i < count; ++i) {
    const std::span<const char> slot = std::span<const char>(bytes).subspan(i * slot_, slot_);
    SlotHead head;
    std::memcpy(&head, slot.data(), sizeof head);
    if (head.state == 0 || head.checksum != slot_checksum(slot, first + i)) {
      throw std::runtime_error(fmt::format("{}: the results of run {} are damaged", file_.string(), first + i));
    }
    RunResult& result = results[i];
    result.run = first + i;
    result.status = static_cast<RunStatus>(head.state - 1);
    const char* payload = slot.data() + sizeof head;
    if (result.status == RunStatus::done) {
      result.values.resize(values_);
      std::memcpy(result.values.data(), payload, values_ * sizeof(double));
    } else {
      result.message.assign(payload, head.length);
    }
  }
  return results;
}

}  // namespace bentur
