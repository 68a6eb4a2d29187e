#include "bentur/study/journal.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <stdexcept>
#include <string>

#include "bentur/io/temporary_folder.h"

namespace bentur {
namespace {

namespace fs = std::filesystem;

class JournalFile : public testing::Test {
 protected:
  static JournalOrigin origin() {
    return {.version = "1",
            .build = "b",
            .study = "a\nb\nc\n",
            .case_text = "x\n",
            .records = {{"r", "12"}},
            .runs = 100,
            .values = 3};
  }
  static RunResult result(std::size_t run) {
    return {run, RunStatus::done, "", {static_cast<double>(run), 0.1, -1e300}};
  }
  std::string refusal(const JournalOrigin& other) const {
    try {
      (void)Journal::resume(file_, other);
    } catch (const std::runtime_error& error) {
      return std::string(error.what()).substr(file_.string().size() + 2);
    }
    return "gone on with";
  }

  TemporaryFolder folder_;
  fs::path file_ = folder_.path() / "r.nc.part";
};

TEST_F(JournalFile, KeepsWhatWasWrittenInAnyOrder) {
  {
    Journal journal = Journal::begin(file_, origin());
    for (const std::size_t run : {99U, 0U, 42U}) journal.write(result(run));
    journal.write({7, RunStatus::failed, "no longer finite at t = 1 s", {}});
    EXPECT_EQ(journal.done(), 4U);
  }
  Journal journal = Journal::resume(file_, origin());
  EXPECT_EQ(journal.done(), 4U);
  EXPECT_TRUE(journal.is_done(42));
  EXPECT_FALSE(journal.is_done(41));
  EXPECT_EQ(journal.read(42, 1)[0].values, result(42).values);
  const RunResult failed = journal.read(7, 1)[0];
  EXPECT_EQ(failed.status, RunStatus::failed);
  EXPECT_EQ(failed.message, "no longer finite at t = 1 s");
  EXPECT_THROW((void)journal.read(41, 2), std::runtime_error);
  journal.write(result(41));
  EXPECT_EQ(journal.read(41, 2)[1].run, 42U);
}

TEST_F(JournalFile, ASlotCutShortAnywhereIsARunNotDone) {
  {
    Journal journal = Journal::begin(file_, origin());
    journal.write(result(0));
    journal.write(result(1));
  }
  const auto whole = fs::file_size(file_);
  int cut = 0;
  for (auto size = whole - 1; size > whole - 264 && size > 4096 + 264; size -= 10, ++cut) {
    fs::resize_file(file_, size);
    const Journal journal = Journal::resume(file_, origin());
    EXPECT_TRUE(journal.is_done(0));
    // Behind its values a slot is zeros; as long as those are there nothing of it is lost.
    EXPECT_EQ(journal.is_done(1), size >= whole - 264 + 16 + 3 * sizeof(double)) << size;
  }
  EXPECT_GT(cut, 20);
}

TEST_F(JournalFile, ADamagedSlotIsARunNotDone) {
  Journal::begin(file_, origin()).write(result(1));
  const auto slot = 4096 + 264;
  for (const int offset : {0, 8, 16, 31, 100}) {
    std::fstream stream(file_, std::ios::in | std::ios::out | std::ios::binary);
    stream.seekg(slot + offset);
    const char before = static_cast<char>(stream.get());
    stream.seekp(slot + offset);
    stream.put(static_cast<char>(before ^ 1));
    stream.close();
    EXPECT_FALSE(Journal::resume(file_, origin()).is_done(1)) << offset;
    stream.open(file_, std::ios::in | std::ios::out | std::ios::binary);
    stream.seekp(slot + offset);
    stream.put(before);
  }
  EXPECT_TRUE(Journal::resume(file_, origin()).is_done(1));
}

TEST_F(JournalFile, RefusesAnotherOriginAndSaysWhatDiffers) {
  { const Journal journal = Journal::begin(file_, origin()); }
  EXPECT_EQ(refusal(origin()), "gone on with");
  JournalOrigin other = origin();
  other.version = "2";
  EXPECT_EQ(refusal(other), "gone on with") << "a commit elsewhere";
  other.build = "c";
  EXPECT_EQ(refusal(other), "was begun by bentur 1, this is 2. Remove it to begin anew");
  other = origin();
  other.build = "c";
  EXPECT_EQ(refusal(other), "was begun by a bentur 1 of other sources. Remove it to begin anew");
  other = origin();
  other.study = "a\nB\nc\n";
  EXPECT_EQ(refusal(other), "was begun with another study: line 2 has changed. Remove it to begin anew");
  other = origin();
  other.case_text = "x\ny\n";
  EXPECT_EQ(refusal(other), "was begun with another case: line 2 has changed. Remove it to begin anew");
  other = origin();
  other.records["r"] = "13";
  EXPECT_EQ(refusal(other), "was begun with another record: r has changed. Remove it to begin anew");
  other = origin();
  other.records = {{"s", "12"}};
  EXPECT_EQ(refusal(other), "was begun without the record s. Remove it to begin anew");
  other = origin();
  other.records.clear();
  EXPECT_EQ(refusal(other), "was begun with the record r, which is gone. Remove it to begin anew");
  other = origin();
  other.values = 4;
  EXPECT_EQ(refusal(other), "was begun with 100 runs of 3 values, now there are 100 of 4. Remove it to begin anew");
}

TEST_F(JournalFile, RefusesWhatIsNone) {
  for (const std::string& content : {std::string(), std::string("bentur"), std::string(5000, 'x')}) {
    std::ofstream(file_, std::ios::binary) << content;
    EXPECT_EQ(refusal(origin()), "is not the journal of a sweep");
  }
  fs::remove(file_);
  { const Journal journal = Journal::begin(file_, origin()); }
  std::fstream stream(file_, std::ios::in | std::ios::out | std::ios::binary);
  stream.seekp(40);
  stream.put('!');
  stream.close();
  EXPECT_EQ(refusal(origin()), "is damaged");
}

/// The checksum of journal.cpp: whoever damages a file on purpose can make it fit.
std::uint64_t checksum(const std::string& bytes, std::uint64_t start) {
  std::uint64_t hash = 0xcbf29ce484222325U ^ start;
  for (std::size_t i = 0; i < bytes.size(); i += 8) {
    std::uint64_t word = 0;
    std::memcpy(&word, bytes.data() + i, std::min<std::size_t>(8, bytes.size() - i));
    hash = (hash ^ word) * 0x100000001b3U;
    hash ^= hash >> 32;
  }
  return hash;
}

std::string bytes_of(std::uint64_t number) { return {reinterpret_cast<const char*>(&number), sizeof number}; }

// A checksum that fits proves nothing: other depths, shapes, states and lengths than write() makes are damage too.
TEST_F(JournalFile, TrustsNoChecksum) {
  std::string nested = std::string(200000, '[') + std::string(200000, ']');
  for (const std::string& text : {nested, std::string("[1, 2]"), std::string("{}"), std::string("{\"version\": 1}"),
                                  std::string("\x91\x91\x91"), std::string()}) {
    std::string head = "bentur journal3";
    head.push_back('\0');
    std::ofstream(file_, std::ios::binary) << head << bytes_of(text.size()) << bytes_of(checksum(text, 0)) << text;
    EXPECT_EQ(refusal(origin()), "is damaged");
  }
  fs::remove(file_);
  Journal::begin(file_, origin()).write(result(1));
  struct {
    std::uint32_t state, length;
  } const heads[] = {{9, 0}, {2, 249}, {2, 0xffffffff}, {0xffffffff, 3}, {0, 5}};
  for (const auto& head : heads) {
    std::string slot(reinterpret_cast<const char*>(&head), sizeof head);
    slot.resize(264 - 8, 'x');
    std::fstream stream(file_, std::ios::in | std::ios::out | std::ios::binary);
    stream.seekp(4096 + 264);
    stream << bytes_of(checksum(slot, 1 + 1)) << slot;
    stream.close();
    EXPECT_FALSE(Journal::resume(file_, origin()).is_done(1)) << head.state << " " << head.length;
  }
}

TEST_F(JournalFile, HasOneWriter) {
  const Journal journal = Journal::begin(file_, origin());
  EXPECT_EQ(refusal(origin()), "another program is writing it");
}

}  // namespace
}  // namespace bentur
