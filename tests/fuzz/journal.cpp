// A journal of three runs, damaged as the input says, gone on with; from half of the inputs with checksums that fit
// what stands there now, so that what lies behind them is met too.
#include "bentur/study/journal.h"

#include <array>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <iterator>
#include <stdexcept>

#include "tests/fuzz/support.h"

namespace bentur::fuzz {
namespace {

namespace fs = std::filesystem;

JournalOrigin origin() {
  return {.version = "1", .build = "b", .study = "a\nb\n", .case_text = "x\n", .records = {}, .runs = 4, .values = 3};
}

// As src/bentur/study/journal.cpp writes it: a head of 32 bytes, the origin, and from a page on slots of 264.
constexpr std::size_t head = 32, slots = 4096, slot = 264;

std::uint64_t checksum(const std::string& bytes, std::size_t from, std::size_t to, std::uint64_t start) {
  std::uint64_t hash = 0xcbf29ce484222325U ^ start;
  for (std::size_t i = from; i < to; i += 8) {
    std::uint64_t word = 0;
    std::memcpy(&word, bytes.data() + i, std::min<std::size_t>(8, to - i));
    hash = (hash ^ word) * 0x100000001b3U;
    hash ^= hash >> 32;
  }
  return hash;
}

void put(std::string& bytes, std::size_t at, std::uint64_t word) { std::memcpy(bytes.data() + at, &word, sizeof word); }

void make_fitting(std::string& bytes) {
  if (bytes.size() < head) return;
  std::uint64_t length = 0;
  std::memcpy(&length, bytes.data() + 16, sizeof length);
  if (length <= bytes.size() - head) put(bytes, 24, checksum(bytes, head, head + length, 0));
  for (std::size_t run = 0, at = slots; at + slot <= bytes.size(); ++run, at += slot) {
    put(bytes, at, checksum(bytes, at + 8, at + slot, run + 1));
  }
}

std::string whole() {
  const fs::path file = folder() / "whole.part";
  {
    Journal journal = Journal::begin(file, origin());
    journal.write({0, RunStatus::done, "", {1, 2, 3}});
    journal.write({1, RunStatus::failed, "no longer finite", {}});
    journal.write({3, RunStatus::done, "", {4, 5, 6}});
  }
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

}  // namespace

void feed(const std::string& input) {
  static const std::string good = whole();
  static const bool known = [] {
    std::string same = good;
    make_fitting(same);
    return same.substr(0, slots + 2 * slot) == good.substr(0, slots + 2 * slot);
  }();
  demand(known, "the form of a journal is another one: mend this target");
  std::string bytes = damaged(good, input);
  if (!input.empty() && (input[0] & 16) != 0) make_fitting(bytes);
  const fs::path file = as_file(bytes, "fuzzed.part");
  try {
    Journal journal = Journal::resume(file, origin());
    for (std::size_t run = 0; run < origin().runs; ++run) {
      if (!journal.is_done(run)) continue;
      const RunResult result = journal.read(run, 1).at(0);
      demand(result.run == run && (result.status != RunStatus::done || result.values.size() == 3),
             "a row is not whole");
    }
    accepted();
  } catch (const std::runtime_error& error) {
    const std::string what = error.what();
    demand(what.compare(0, file.string().size(), file.string()) == 0, "an error does not name the file: " + what);
  }
}

}  // namespace bentur::fuzz
