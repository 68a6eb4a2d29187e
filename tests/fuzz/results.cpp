// Results damaged as the input says: histories, summary or case of a run, or an incremental dynamic analysis. Each is
// read, or refused by a message that names the file.
#include <array>
#include <cstdint>
#include <fstream>
#include <iterator>
#include <stdexcept>

#include "bentur/files/ida_reading.h"
#include "bentur/files/result_netcdf.h"
#include "bentur/files/result_reading.h"
#include "bentur/io/case/case_toml.h"
#include "bentur/io/results/result_json.h"
#include "bentur/runner/sweep.h"
#include "tests/fuzz/support.h"

namespace bentur::fuzz {
namespace {

namespace fs = std::filesystem;

constexpr std::array names = {"run/histories.nc", "run/summary.json", "run/case.toml", "ida.nc"};

std::string contents(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

/// A run of two buildings and an analysis of four runs, as the program writes them. @return each file, whole
std::array<std::string, names.size()> made() {
  Diagnostics diagnostics;
  const fs::path file = folder() / "kelvin-voigt-pair.toml";
  Case c = read_case(file, diagnostics).value();
  c.analysis.duration = 0.5;
  fs::create_directory(folder() / "run");
  Problem problem = make_problem(c);
  SolveOptions all = solve_options(c);
  all.output_step = c.analysis.output_step;
  all.course = true;
  Response response = solve(problem, c.analysis.solver, all);
  const RunResults run = run_results(c, std::move(problem), std::move(response));
  as_file("case = \"m12-el-centro.toml\"\n[ida]\nintensity = \"pga\"\nunit = \"g\"\nlevels = [0.1, 0.2]\n", "ida.toml");
  SweepOptions options;
  options.kind = StudyKind::ida;
  options.output = folder() / "ida.nc";
  options.version = "1";
  options.threads = 1;
  Ranks ranks;
  demand(sweep(folder() / "ida.toml", options, ranks, diagnostics).has_value(), "the analysis has not been run");
  return {histories_netcdf(run, "1"), summary_json(run, "1"), contents(file), contents(options.output)};
}

}  // namespace

void feed(const std::string& input) {
  static const auto whole = [] {
    const auto files = made();
    for (std::size_t i = 0; i < files.size(); ++i) as_file(files[i], names[i]);
    (void)read_results(folder() / "run");
    Diagnostics none;
    demand(read_ida_results(folder() / "ida.nc", "impacts > 0", none).has_value(), "what is whole is not read");
    return files;
  }();
  const std::size_t which = input.empty() ? 0 : static_cast<std::uint8_t>(input[0]) / 8 % names.size();
  const fs::path file = as_file(damaged(whole[which], input), names[which]);
  Diagnostics diagnostics;
  try {
    if (which + 1 < names.size()) {
      (void)read_results(folder() / "run");
      accepted();
    } else {
      accepted(read_ida_results(file, "impacts > 0", diagnostics).has_value());
    }
  } catch (const std::runtime_error& error) {
    const std::string what = error.what(), where = folder() / "run";
    demand(what.compare(0, where.size(), where) == 0, "an error does not name the file: " + what);
  }
  as_file(whole[which], names[which]);
}

}  // namespace bentur::fuzz
