// answers COUNT: prints all that a run tells of each of COUNT random cases of every kind of building and link. Two
// programs that print the same answer all of them alike, to the bit (tools/mutate.py).

#include <iostream>
#include <string>
#include <utility>

#include "bentur/core/errors.h"
#include "bentur/io/results/result_json.h"
#include "bentur/pounding/pounding.h"
#include "tests/invariance/every_kind.h"
#include "tests/invariance/random_case.h"

namespace {

void answer(bentur::Case c) {
  try {
    bentur::Problem problem = bentur::make_problem(c);
    bentur::SolveOptions options = bentur::solve_options(c);
    options.energy_audit = true;
    bentur::Response response = bentur::solve(problem, c.analysis.solver, options);
    response.wall_time = 0;
    const std::string message = response.message;
    const bentur::RunResults run = bentur::run_results(std::move(c), std::move(problem), std::move(response));
    std::cout << message << bentur::summary_json(run, "") << bentur::gap_json(run, "") << '\n';
  } catch (const bentur::InvalidParameter& error) {
    std::cout << error.what() << '\n';
  }
}

}  // namespace

int main(int argc, char** argv) {
  const unsigned count = argc > 1 ? static_cast<unsigned>(std::stoul(argv[1])) : 1000;
  for (unsigned seed = 1; seed <= count; ++seed) {
    answer(seed % 2 == 0 ? bentur::test::EveryKindGenerator(seed).make() : bentur::test::CaseGenerator(seed).make().c);
  }
}
