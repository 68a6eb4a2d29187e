// A case file is read, solved and told of: ex2-case-file CASE.toml
#include <bentur/io/case/case_toml.h>
#include <bentur/pounding/pounding.h>

#include <cstdio>

using namespace bentur;

int main(int count, char** arguments) {
  if (count != 2) return 2;
  Diagnostics diagnostics;
  const auto c = read_case(arguments[1], diagnostics);
  if (!c) {
    for (const Diagnostic& error : diagnostics.errors()) std::printf("%s\n", error.rule.c_str());
    return 2;
  }
  const Problem problem = make_problem(*c);
  const Response response = solve(problem, c->analysis.solver);
  for (std::size_t b = 0; b < problem.buildings.size(); ++b) {
    std::printf("%s: %.4g with contact, %.4g without\n", problem.buildings[b].name.c_str(),
                response.buildings[b].displacement.maxCoeff(),
                response.buildings[b].displacement_no_contact.maxCoeff());
  }
  for (const Impact& impact : response.impacts) {
    std::printf("%8.4f s  %10.4g\n", impact.start, impact.peak_force);
  }
}
