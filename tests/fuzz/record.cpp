// Any bytes as a record, of the format that is found and, by the length, of one that is said, each in turn, or as the
// component of a name.
#include <algorithm>
#include <cmath>

#include "bentur/io/records/record_files.h"
#include "tests/fuzz/support.h"

namespace bentur::fuzz {
namespace {

void read(const std::string& input, const RecordOptions& options) {
  Diagnostics diagnostics;
  const auto record = record_of(input, "fuzzed.txt", options, diagnostics);
  demand(record.has_value() == diagnostics.ok(), "a record is refused without a message, or read with one");
  if (!record) return;
  accepted();
  const auto finite = [](double x) { return std::isfinite(x); };
  demand(std::all_of(record->values.begin(), record->values.end(), finite), "a value of a record is no number");
  demand(record->values.size() > 1, "a record has one value");
  demand(record->time_step > 0 && std::isfinite(record->time_step), "a step of a record is no number > 0");
  (void)contradictions(*record, options);
}

}  // namespace

void feed(const std::string& input) {
  read(input, {});
  const auto& formats = record_formats();
  const std::size_t which = input.size() / 2;
  if (input.size() % 2 == 0) {
    read(input, {.format = formats[which % formats.size()], .time_step = 0.01, .column = 1, .channel = 1});
  } else {
    read(input, {.time_step = 0.01, .component = which % 2 == 0 ? "N-S" : "Up", .unit = "g"});
  }
}

}  // namespace bentur::fuzz
