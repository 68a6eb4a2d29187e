#include "tests/fuzz/support.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <utility>

#include "bentur/core/errors.h"
#include "bentur/io/temporary_folder.h"
#include "bentur/pounding/pounding.h"

namespace bentur::fuzz {

namespace fs = std::filesystem;

void demand(bool holds, const std::string& what) {
  if (holds) return;
  std::cerr << "fuzz: " << what << '\n';
  std::abort();
}

long accepted(bool is) {
  static long count = 0;
  return count += is ? 1 : 0;
}

const fs::path& folder() {
  static const TemporaryFolder made;
  static const fs::path examples = [] {
    for (const char* name : {"examples", "data"}) {
      fs::copy(fs::path(BENTUR_SOURCE_DIR) / name, made.path() / name, fs::copy_options::recursive);
    }
    return made.path() / "examples";
  }();
  return examples;
}

fs::path as_file(const std::string& input, const std::string& name) {
  fs::path file = folder() / name;
  std::ofstream(file, std::ios::binary) << input;
  return file;
}

bool run_shortly(Case c) {
  c.analysis.duration = std::min(c.analysis.duration, 2.0);
  c.analysis.limits = {.steps = 2e4, .memory = 200};
  if (is_without_motion(c) || c.buildings.size() > 6) return false;
  try {
    const Problem problem = make_problem(c);
    for (const Building& building : problem.buildings) {
      if (building.model.floors() > 20) return false;
    }
    const Response response = solve(problem, c.analysis.solver, solve_options(c));
    demand(response.status != Status::failed || !response.message.empty(), "a run has failed without a word");
    demand(response.message.find("contradicts itself") == std::string::npos, response.message);
    for (const Impact& impact : response.impacts) demand(std::isfinite(impact.peak_force), "a force is no number");
    return true;
  } catch (const InvalidParameter&) {  // told as any error of a case
    return false;
  }
}

std::string damaged(std::string whole, const std::string& input) {
  const auto byte = [&](std::size_t i) { return std::size_t{static_cast<std::uint8_t>(input[i])}; };
  const bool cut = !input.empty() && byte(0) % 8 == 7;
  for (std::size_t i = 1; i + 3 < input.size() && !whole.empty(); i += 4) {
    const std::size_t place = (byte(i) << 16 | byte(i + 1) << 8 | byte(i + 2)) % whole.size();
    whole[place] = input[i + 3];
    if (cut && i == 1) whole.resize(place);
  }
  return whole;
}

}  // namespace bentur::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  bentur::fuzz::feed(std::string(data, data + size));
  return 0;
}
