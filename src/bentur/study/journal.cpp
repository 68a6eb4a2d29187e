#include "bentur/study/journal.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>
#include <system_error>
#include <utility>

namespace bentur {

NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(JournalOrigin, version, build, study, case_text, records, runs, values)

namespace {

namespace fs = std::filesystem;

constexpr std::size_t page = 4096;                  // bytes; where the first slot begins
constexpr std::size_t smallest_payload = 248;       // bytes; so that there is room for a message
constexpr std::size_t largest_origin = 256U << 20;  // bytes

/// Begins the file; the origin as JSON follows, then, at a page, the slots.
struct FileHead {
  char magic[16] = "bentur journal3";
  std::uint64_t origin_bytes = 0;
  std::uint64_t checksum = 0;  // of the origin
};

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

/// The head of a slot; as that of an empty one where the slot is not whole, or says what write() never does.
SlotHead head_of(std::span<const char> slot, std::size_t run) {
  constexpr std::uint32_t most = 1 + static_cast<std::uint32_t>(RunStatus::invalid);
  SlotHead head;
  std::memcpy(&head, slot.data(), sizeof head);
  const bool is_whole = head.checksum == slot_checksum(slot, run);
  return is_whole && head.state <= most && head.length <= slot.size() - sizeof head ? head : SlotHead{};
}

/// As text: its reader needs no more stack for what is nested deeper. Bytes that are not UTF-8 are replaced.
std::string packed(const JournalOrigin& origin) {
  using nlohmann::json;
  return json(origin).dump(-1, ' ', false, json::error_handler_t::replace);
}

/// @throws nlohmann::json::exception where that is of no origin.
JournalOrigin unpacked(const std::string& text) { return nlohmann::json::parse(text).get<JournalOrigin>(); }

/// Number of the first line in which two texts differ, from 1.
std::size_t differing_line(const std::string& a, const std::string& b) {
  const auto at = std::mismatch(a.begin(), a.end(), b.begin(), b.end()).first;
  return static_cast<std::size_t>(std::count(a.begin(), at, '\n')) + 1;
}

[[noreturn]] void refuse(const fs::path& file, const std::string& why) {
  throw std::runtime_error(file.string() + ": " + why);
}

/// Nobody else may write the same file. One that was killed may take its time to go.
void lock(const OpenFile& file) {
  constexpr ::useconds_t pause = 100'000;  // [µs]
  constexpr int most = 30;
  for (int tries = 0; ::flock(file.descriptor(), LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK; ++tries) {
    if (tries == most) refuse(file.name(), "another program is writing it");
    ::usleep(pause);
  }
}

}  // namespace

std::optional<std::string> difference(const JournalOrigin& then, const JournalOrigin& now) {
  if (then.build != now.build) {
    return then.version == now.version ? fmt::format("by a bentur {} of other sources", then.version)
                                       : fmt::format("by bentur {}, this is {}", then.version, now.version);
  }
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

Journal::Journal(OpenFile file, const JournalOrigin& origin, std::size_t origin_bytes)
    : file_(std::move(file)),
      values_(origin.values),
      slot_(sizeof(SlotHead) + std::max(smallest_payload, origin.values * sizeof(double))),
      first_slot_((sizeof(FileHead) + origin_bytes + page - 1) / page * page),
      done_(origin.runs, false),
      buffer_(slot_) {}

Journal Journal::begin(const fs::path& file, const JournalOrigin& origin) {
  const std::string text = packed(origin);
  const FileHead head{.origin_bytes = text.size(), .checksum = checksum(text, 0)};
  const fs::path unfinished = make_temporary(file);  // its name until all of this is written
  try {
    OpenFile open(::open(unfinished.c_str(), O_RDWR | O_CLOEXEC), file);
    lock(open);
    open.write({reinterpret_cast<const char*>(&head), sizeof head}, 0);
    open.write(text, sizeof head);
    open.sync();
    if (::link(unfinished.c_str(), file.c_str()) == 0) {
      ::unlink(unfinished.c_str());
    } else if (errno == EEXIST) {
      refuse(file, "another program has just begun it");
    } else if (::rename(unfinished.c_str(), file.c_str()) != 0) {  // a file system without hard links
      refuse(file, "cannot write: " + std::generic_category().message(errno));
    }
    return {std::move(open), origin, text.size()};
  } catch (...) {
    ::unlink(unfinished.c_str());
    throw;
  }
}

Journal Journal::resume(const fs::path& file, const JournalOrigin& origin) {
  OpenFile open(::open(file.c_str(), O_RDWR | O_CLOEXEC), file, "cannot go on with it");
  lock(open);
  FileHead head;
  open.read({reinterpret_cast<char*>(&head), sizeof head}, 0);
  if (std::memcmp(head.magic, FileHead{}.magic, sizeof head.magic) != 0 || head.origin_bytes > largest_origin) {
    refuse(file, "is not the journal of a sweep");
  }
  std::string text(static_cast<std::size_t>(head.origin_bytes), '\0');
  open.read(text, sizeof head);
  if (head.checksum != checksum(text, 0)) refuse(file, "is damaged");
  JournalOrigin then;
  try {
    then = unpacked(text);
  } catch (const nlohmann::json::exception&) {
    refuse(file, "is damaged");
  }
  if (const auto differs = difference(then, unpacked(packed(origin)))) {
    refuse(file, fmt::format("was begun {}. Remove it to begin anew", *differs));
  }
  Journal journal(std::move(open), origin, text.size());
  journal.find_done();
  return journal;
}

void Journal::find_done() {
  const std::size_t at_once = std::max<std::size_t>(1, (1U << 20) / slot_);
  std::vector<char> bytes(at_once * slot_);
  for (std::size_t first = 0; first < done_.size(); first += at_once) {
    const std::size_t count = std::min(at_once, done_.size() - first);
    file_.read(std::span(bytes).first(count * slot_), first_slot_ + first * slot_);
    for (std::size_t i = 0; i < count; ++i) {
      const std::span<const char> slot = std::span(bytes).subspan(i * slot_, slot_);
      done_[first + i] = head_of(slot, first + i).state != 0;
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
  file_.write(buffer_, first_slot_ + result.run * slot_);
  if (!done_[result.run]) ++count_;
  done_[result.run] = true;
}

std::vector<RunResult> Journal::read(std::size_t first, std::size_t count) const {
  std::vector<char> bytes(count * slot_);
  file_.read(bytes, first_slot_ + first * slot_);
  std::vector<RunResult> results(count);
  for (std::size_t i = 0; i < count; ++i) {
    const std::span<const char> slot = std::span<const char>(bytes).subspan(i * slot_, slot_);
    const SlotHead head = head_of(slot, first + i);
    if (head.state == 0) refuse(file_.name(), fmt::format("the results of run {} are damaged", first + i));
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
