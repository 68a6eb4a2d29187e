#include "bench/plans.h"

#include <fmt/format.h>

#include <stdexcept>

#include "bench/timing.h"
#include "bentur/io/case/case_toml.h"
#include "bentur/model/plan/plan_run.h"
#include "bentur/pounding/plan/plan_pounding.h"

namespace bentur::bench {
namespace {

/// A house in plan, stiffer along one side and along x, of another stiffness and mass than its neighbours. Five are
/// different, so that larger blocks repeat the block of five and what a house takes compares like with like.
std::string house(int number, int column, int row, double clear, int storeys) {
  constexpr double length = 10, width = 12;
  const auto list = [storeys](double value) {
    std::string all;
    for (int j = 0; j < storeys; ++j) all += fmt::format("{}{}", j == 0 ? "" : ", ", value * (1 - 0.1 * j));
    return all;
  };
  const auto plane = [&](const char* along, double at, double stiffness) {
    return fmt::format("[[building.plane]]\nalong = \"{}\"\nat = {}\nstiffnesses = [{}]\n", along, at, list(stiffness));
  };
  return fmt::format(
             "[[building]]\nname = \"House {}\"\ndamping = 0.05\n[building.plan]\ncorner = [{}, {}]\nsize = [{}, {}]\n"
             "storey_heights = [{}]\nmasses = [{}]\n",
             number + 1, column * (length + clear), row * (width + clear), length, width, list(3.0),
             list(120 + 7 * (number * 3 % 5))) +
         plane("x", 0, 9e4 * (1 + 0.13 * (number * 7 % 5))) + plane("x", width, 4e4 * (1 + 0.1 * (number * 4 % 5))) +
         plane("y", 0, 6.4e4) + plane("y", length, 6e4 * (1 + 0.1 * (number * 2 % 5)));
}

}  // namespace

PlanProblem houses(int count, int columns, double clear, int storeys, const std::filesystem::path& record) {
  std::string text =
      "[units]\nlength = \"m\"\nforce = \"kN\"\n[plan]\nclearance = 0.5\n"
      "contact = { law = \"linear\", stiffness = 4e5 }\n[analysis]\nduration = 10.0\n";
  for (const auto& [table, pga] : {std::pair("excitation", 3.4), std::pair("excitation.y", 2.0)}) {
    text +=
        fmt::format("[{}]\nkind = \"record\"\nfile = \"{}\"\nunit = \"g\"\npga = {}\n", table, record.string(), pga);
  }
  for (int n = 0; n < count; ++n) text += house(n, n % columns, n / columns, clear, storeys);
  Diagnostics diagnostics;
  const auto c = read_case_text(text, "houses.toml", diagnostics);
  if (!c) throw std::runtime_error(diagnostics.errors().front().text());
  return make_plan_problem(*c);
}

PlanTime time_of_plan(const PlanProblem& problem) {
  PlanResponse response;
  const Timing timing = time_of([&] { response = solve(problem); }, 0.3);
  if (response.status != Status::done) throw std::runtime_error(response.message);
  return {timing.minimum, response.impacts.size()};
}

}  // namespace bentur::bench
