// Any bytes as the text of an ETABS model: by the length its only frame, or the one at 0 along either axis.
#include "bentur/io/exchange/e2k.h"

#include "tests/fuzz/support.h"

namespace bentur::fuzz {
namespace {

void import_frame(const std::string& input, const E2kFrame& frame) {
  Diagnostics diagnostics;
  const auto made = read_e2k(input, "fuzzed.e2k", frame, diagnostics);
  demand(made.has_value() == diagnostics.ok(), "a model is refused without a message, or read with one");
  if (!made) return;
  demand(made->text.find("[building.frame]") != std::string::npos, "a model has become no frame");
  for (const UnreadLines& one : made->unread) demand(one.first > 0 && one.first <= one.last, "lines have no place");
  accepted();
}

}  // namespace

void feed(const std::string& input) {
  if (input.size() % 3 == 0) import_frame(input, {});
  if (input.size() % 3 == 1) import_frame(input, {.at = 0});
  if (input.size() % 3 == 2) {
    import_frame(input, {.along_x = false, .at = 0, .sections = {{"PIPE", {.area = 0.01, .major = 1e-4}}}});
  }
}

}  // namespace bentur::fuzz
