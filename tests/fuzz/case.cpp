// Any bytes as a case; one that is read is run for two seconds.
#include <utility>

#include "bentur/io/case/case_toml.h"
#include "tests/fuzz/support.h"

void bentur::fuzz::feed(const std::string& input) {
  Diagnostics diagnostics;
  auto c = read_case_text(input, folder() / "fuzzed.toml", diagnostics);
  demand(c.has_value() == diagnostics.ok(), "a case is refused without a message, or read with one");
  if (c) accepted(run_shortly(*std::move(c)));
}
