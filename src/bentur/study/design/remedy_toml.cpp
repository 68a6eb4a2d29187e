#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "bentur/model/quantities.h"
#include "bentur/study/design/internal/study_parts.h"
#include "bentur/study/design/study_keys.h"
#include "bentur/study/study_variables.h"

namespace bentur {

double SoughtRange::at(double u) const {
  if (u <= 0) return from;
  if (u >= 1) return to;
  return log ? from * std::pow(to / from, u) : from + (to - from) * u;
}

double SoughtRange::place(double x) const {
  const double u = log ? std::log(x / from) / std::log(to / from) : (x - from) / (to - from);
  return std::clamp(std::isnan(u) ? 0.0 : u, 0.0, 1.0);
}

namespace {

/// Whether the results of any study have such a quantity.
bool is_of_results(const std::string& objective, std::vector<std::string>& known) {
  known.emplace_back("drift");
  for (const Quantity& one : quantities()) {
    if (one.owner != Owner::impact && !one.single_run) known.push_back(file_name(one));
  }
  return std::any_of(known.begin(), known.end(), [&](const std::string& name) {
    return is_quantity(name, objective) || name == without_number(objective);
  });
}

}  // namespace

std::optional<RemedySpec> read_remedy(const TomlView& root) {
  const auto given = root.find("remedy");
  if (!given) return std::nullopt;
  RemedySpec spec;
  const auto view = TableView::of(*given, remedy_keys());
  root.refuse({"sampling", "ida"}, "does not go with [remedy], which chooses from ranges");
  if (!view) return spec;
  spec.objective = view->text("objective").value_or("");
  spec.mean = view->word("of_records") == "mean";
  spec.limit = view->number("limit");
  if (const auto most = view->whole("evaluations")) spec.evaluations = static_cast<std::size_t>(*most);
  if (const auto objective = view->find("objective")) {
    spec.position = objective->position();
    std::vector<std::string> known;
    if (!spec.objective.empty() && !is_of_results(spec.objective, known)) {
      const std::string near = likely(spec.objective, known);
      const std::string rule = "must be a quantity of the results";
      objective->error_value(near.empty() ? fmt::format("{}: {}", rule, fmt::join(known, ", ")) : rule, near);
    }
  }
  return spec;
}

}  // namespace bentur
