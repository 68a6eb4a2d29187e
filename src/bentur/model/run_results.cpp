#include "bentur/model/run_results.h"

#include <utility>
#include <variant>

namespace bentur {

FigureData figure_data(const Problem& problem, const Response& response, const Solver& solver) {
  FigureData data;
  data.close_up = close_up(problem, response, solver);
  if (const auto* motion = std::get_if<SampledMotion>(&problem.motion)) {
    data.spectrum_periods = logarithmic_periods(0.02, 5, 201);
    data.spectrum = response_spectrum(*motion, data.spectrum_periods, data.spectrum_damping);
  }
  return data;
}

RunResults run_results(Case c, Problem problem, Response response) {
  std::vector<Remark> found = remarks(c, problem, response);
  return {std::move(c), std::move(problem), std::move(response), std::move(found), {}};
}

}  // namespace bentur
