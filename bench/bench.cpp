// What this measures and what it does not prove: bench/README.md.
#include <benchmark/benchmark.h>

#include <cstdlib>
#include <filesystem>
#include <stdexcept>
#include <string>

#include "bentur/io/case_toml.h"
#include "bentur/solve/solver.h"

namespace {

using namespace bentur;

/// The monograph's M1-2 under El Centro with the given gap [cm].
Problem m12(double gap) {
  Diagnostics diagnostics;
  auto c = read_case(std::filesystem::path(BENTUR_SOURCE_DIR) / "examples/m12-el-centro.toml", diagnostics);
  if (!c) throw std::runtime_error(diagnostics.errors().front().text());
  for (double& width : c->gaps[0].widths) width = gap;
  return make_problem(*c);
}

/// The solution alone: free response and response with contact, no reading and no writing.
void solve_m12(benchmark::State& state) {
  const Problem problem = m12(static_cast<double>(state.range(0)) / 10.0);
  Response response;
  for (auto _ : state) {
    response = solve(problem);
    benchmark::DoNotOptimize(response);
  }
  state.counters["impacts"] = static_cast<double>(response.impacts.size());
  state.counters["steps"] = static_cast<double>(response.steps);
}
BENCHMARK(solve_m12)->ArgName("gap_mm")->Arg(0)->Arg(2)->Arg(4)->Unit(benchmark::kMillisecond)->MinTime(1.0);

/// From the matrices of the frames to the problem: assembly, condensation, modes, damping.
void build_m12(benchmark::State& state) {
  Diagnostics diagnostics;
  const auto c = read_case(std::filesystem::path(BENTUR_SOURCE_DIR) / "examples/m12-el-centro.toml", diagnostics);
  for (auto _ : state) benchmark::DoNotOptimize(make_problem(*c));
}
BENCHMARK(build_m12)->Unit(benchmark::kMillisecond);

/// Reading and validating the case and its record.
void read_m12(benchmark::State& state) {
  for (auto _ : state) {
    Diagnostics diagnostics;
    benchmark::DoNotOptimize(
        read_case(std::filesystem::path(BENTUR_SOURCE_DIR) / "examples/m12-el-centro.toml", diagnostics));
  }
}
BENCHMARK(read_m12)->Unit(benchmark::kMillisecond);

/// The whole program, as a user starts it: `bentur run --quiet` of the built-in example, and the same with result
/// files.
void whole_process(benchmark::State& state) {
  const std::string results = "'" BENTUR_BINARY_DIR "/bench-results'";
  const std::string command = std::string("'") + BENTUR_PROGRAM + "' run --quiet" +
                              (state.range(0) != 0 ? " -o " + results : "") + " >/dev/null 2>&1";
  for (auto _ : state) {
    if (std::system(command.c_str()) != 0) state.SkipWithError("the program failed");
  }
}
BENCHMARK(whole_process)->ArgName("files")->Arg(0)->Arg(1)->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace

BENCHMARK_MAIN();
