// Any bytes as a study.
#include "bentur/study/design/study.h"
#include "tests/fuzz/support.h"

void bentur::fuzz::feed(const std::string& input) {
  Diagnostics diagnostics;
  const bool good = read_study(as_file(input, "studies/fuzzed.toml"), diagnostics).has_value();
  demand(good == diagnostics.ok(), "a study is refused without a message, or read with one");
  accepted(good);
}
