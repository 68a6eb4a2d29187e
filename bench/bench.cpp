// What this measures and what it does not prove: bench/README.md.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <numbers>
#include <stdexcept>
#include <string>
#include <vector>

#include "bentur/contact/laws.h"
#include "bentur/io/case/case_toml.h"
#include "bentur/io/records/record_files.h"
#include "bentur/pounding/pounding.h"
#include "bentur/solve/engine/motion/polynomial.h"
#include "bentur/structure/modes.h"

namespace {

using namespace bentur;

/// The monograph's M1-2 under El Centro with linear contact and the given gap [cm].
Case m12(double gap) {
  Diagnostics diagnostics;
  auto c = read_case(std::filesystem::path(BENTUR_SOURCE_DIR) / "examples/m12-el-centro.toml", diagnostics);
  if (!c) throw std::runtime_error(diagnostics.errors().front().text());
  for (double& width : c->gaps[0].widths) width = gap;
  return *c;
}

constexpr double some_impacts = 0.2;  // gap [cm]

/// M1-2 with another law. Springs have the stiffness of the linear one, Hertz's kind one that makes impacts about as
/// long.
Problem m12_with(const LawEntry& law) {
  static const std::map<std::string_view, double> values = {
      {"stiffness", 2e6},  // kgf/cm^1.5, where not a spring's
      {"second_stiffness", 1e5}, {"yield_penetration", 0.005}, {"alpha", 0.02},
      {"crushing_force", 2e4},   {"thickness", 0.1},           {"crushing_strain", 0.1},
      {"locking_strain", 0.6},   {"locked_stiffness", 4e6},    {"restitution", 0.65}};
  Case c = m12(some_impacts);
  ContactSpec& contact = c.gaps[0].contact;
  const std::vector<double> spring = contact.numbers.at("stiffness");
  contact.law = law.name;
  contact.numbers.clear();
  for (const Key& key : law.keys) {
    if (key.need == Need::one_of && key.name != "restitution") continue;
    contact.numbers[std::string(key.name)] = !key.words.empty() ? spring : std::vector<double>{values.at(key.name)};
  }
  return make_problem(c);
}

void count(benchmark::State& state, const Response& response) {
  state.counters["impacts"] = static_cast<double>(response.impacts.size());
  state.counters["steps"] = static_cast<double>(response.steps);
  state.counters["events"] = static_cast<double>(response.events);
}

/// The solution alone: free response and response with contact, no reading and no writing.
void solve_m12(benchmark::State& state) {
  const Problem problem = make_problem(m12(static_cast<double>(state.range(0)) / 10.0));
  Response response;
  for (auto _ : state) {
    response = solve(problem);
    benchmark::DoNotOptimize(response);
  }
  count(state, response);
}
BENCHMARK(solve_m12)->ArgName("gap_mm")->Arg(0)->Arg(2)->Arg(4)->Unit(benchmark::kMillisecond)->MinTime(1.0);

/// Seconds that one solution takes.
double time_of(const Problem& problem, const Solver& solver, Response& response) {
  const auto began = std::chrono::steady_clock::now();
  response = solve(problem, solver);
  benchmark::DoNotOptimize(response);
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
}

/// A solution, in turn with the exact one of linear contact, so that both see the same state of the machine.
/// `to_linear` is the median of the ratios.
void solve_in_turn(benchmark::State& state, const Problem& problem, const Solver& solver) {
  const Problem linear = make_problem(m12(some_impacts));
  Response response, other;
  std::vector<double> ratios;
  for (auto _ : state) {
    const double time = time_of(problem, solver, response);
    state.SetIterationTime(time);
    ratios.push_back(time / time_of(linear, ExactSolver{}, other));
  }
  count(state, response);
  const auto middle = ratios.begin() + static_cast<std::ptrdiff_t>(ratios.size() / 2);
  std::nth_element(ratios.begin(), middle, ratios.end());
  state.counters["to_linear"] = *middle;
}

void register_solutions() {
  const auto add = [](const std::string& name, const Problem& problem, const Solver& solver) {
    const auto run = [problem, solver](benchmark::State& state) { solve_in_turn(state, problem, solver); };
    benchmark::RegisterBenchmark(name.c_str(), run)->UseManualTime()->Unit(benchmark::kMillisecond);
  };
  for (const LawEntry& law : contact_laws()) add("law/" + std::string(law.name), m12_with(law), ExactSolver{});
  const Problem linear = make_problem(m12(some_impacts));
  const Problem hertz = m12_with(*find_law("hertz"));
  for (const Solver& solver : {Solver{ExactSolver{}}, Solver{AdaptiveSolver{}}, Solver{RungeKuttaSolver{0.0005}}}) {
    add("solver/" + std::string(name(solver)) + "/linear", linear, solver);
    add("solver/" + std::string(name(solver)) + "/hertz", hertz, solver);
  }
}

/// From the matrices of the frames to the problem: assembly, condensation, modes, damping.
void build_m12(benchmark::State& state) {
  const Case c = m12(some_impacts);
  for (auto _ : state) benchmark::DoNotOptimize(make_problem(c));
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

/// A pair pressed together for good: a steady ground acceleration leans the softer building on the stiffer one.
Problem pressed() {
  Case c = m12(0.0);
  c.excitation.motion = SampledMotion{0.02, std::vector<double>(500, 300.0)};
  c.excitation.delays = {0, 0};
  return make_problem(c);
}

void count_per_step(benchmark::State& state, const Response& response) {
  using benchmark::Counter;
  state.counters["per_step"] =
      Counter(static_cast<double>(response.steps), Counter::kIsIterationInvariantRate | Counter::kInvert);
  count(state, response);
}

/// Time per step [s] of the response without contact.
void part_flight(benchmark::State& state) {
  const Problem problem = make_problem(m12(100.0));
  for (auto _ : state) {
    const FreeResponse free(problem);
    benchmark::DoNotOptimize(free);
  }
  count_per_step(state, solve(problem));
}
BENCHMARK(part_flight)->Name("part/free_flight")->Unit(benchmark::kMicrosecond);

/// Time per step [s] of the response with contact.
void per_step(benchmark::State& state, const Problem& problem) {
  const FreeResponse free(problem);
  Response response;
  for (auto _ : state) {
    response = free.solve(problem);
    benchmark::DoNotOptimize(response);
  }
  count_per_step(state, response);
}

void part_contact(benchmark::State& state) { per_step(state, pressed()); }
BENCHMARK(part_contact)->Name("part/contact")->Unit(benchmark::kMicrosecond);

/// The first negative value of an opening that nearly touches, and of one that does.
void part_event_search(benchmark::State& state) {
  const double lift = state.range(0) != 0 ? -1e-6 : 1e-6;
  engine::Polynomial opening;  // 1 + lift − cos(2 s − 1): lowest at s = 1/2
  double factorial = 1;
  for (int k = 0; k <= engine::highest_degree; ++k) {
    if (k > 0) factorial *= k;
    opening[k] = -std::pow(2.0, k) / factorial * std::cos(-1.0 + 0.5 * k * std::numbers::pi) + (k == 0 ? 1 + lift : 0);
  }
  for (auto _ : state) benchmark::DoNotOptimize(engine::first_negative(opening));
}
BENCHMARK(part_event_search)->Name("part/event_search")->ArgName("touches")->Arg(0)->Arg(1);

/// Modes of a chain of so many storeys.
void part_modes(benchmark::State& state) {
  const auto storeys = static_cast<Eigen::Index>(state.range(0));
  Eigen::MatrixXd stiffness = Eigen::MatrixXd::Zero(storeys, storeys);
  for (Eigen::Index i = 0; i < storeys; ++i) {
    stiffness(i, i) = i + 1 < storeys ? 2 : 1;
    if (i > 0) stiffness(i, i - 1) = stiffness(i - 1, i) = -1;
  }
  const Eigen::MatrixXd mass = Eigen::MatrixXd::Identity(storeys, storeys);
  for (auto _ : state) benchmark::DoNotOptimize(modes(mass, stiffness));
}
BENCHMARK(part_modes)
    ->Name("part/eigen_decomposition")
    ->ArgName("storeys")
    ->Arg(3)
    ->Arg(12)
    ->Arg(40)
    ->Unit(benchmark::kMicrosecond);

/// Reading a record of 1560 values.
void part_record(benchmark::State& state) {
  const auto file = std::filesystem::path(BENTUR_SOURCE_DIR) / "data/el-centro-1940-ns.csv";
  for (auto _ : state) {
    Diagnostics diagnostics;
    benchmark::DoNotOptimize(read_record(file, {}, diagnostics));
  }
}
BENCHMARK(part_record)->Name("part/read_record")->Unit(benchmark::kMicrosecond);

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

int main(int argc, char** argv) {
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 1;
  register_solutions();
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
}
