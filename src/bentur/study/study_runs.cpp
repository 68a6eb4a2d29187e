#include "bentur/study/study_runs.h"

#include <fmt/format.h>

#include <algorithm>
#include <exception>
#include <optional>
#include <stdexcept>
#include <utility>

#include "bentur/core/errors.h"
#include "bentur/model/quantity_row.h"
#include "bentur/model/story/remarks.h"
#include "bentur/pounding/assemble.h"
#include "bentur/pounding/pounding.h"

namespace bentur {
namespace {

constexpr std::size_t most_groups = 64;  // kept, of those with several runs

/// The values of a run do not make a case.
struct NotACase : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Number of the gap whose widths a path leads to, and of the point where it names one; nothing for other paths.
struct WidthPlace {
  int gap = 0;
  std::optional<std::size_t> point;
};

std::optional<WidthPlace> width_place(const ParameterPath& path) {
  if (path.size() < 3 || path.size() > 4 || path[0] != PathStep("gap") || path[2] != PathStep("width")) {
    return std::nullopt;
  }
  WidthPlace place{static_cast<int>(std::get<std::size_t>(path[1])), std::nullopt};
  if (path.size() == 4) place.point = std::get<std::size_t>(path[3]);
  return place;
}

/// Sets the widths of a gap, or of one of its points, to a number or to the numbers of a list.
void set_widths(const WidthPlace& place, const TomlValue& value, Problem& problem) {
  std::size_t point = 0;
  for (ContactPoint& p : problem.points) {
    if (p.gap != place.gap) continue;
    if (!place.point || *place.point == point) {
      p.width = value.kind == TomlValue::Kind::list ? value.items.at(point).real : value.real;
    }
    ++point;
  }
  for (WatchedFloor& floor : problem.watched) {
    if (floor.gap == place.gap) {
      floor.width = watched_width(problem.points, floor.gap, floor.elevation).value_or(value.real);
    }
  }
}

}  // namespace

struct StudyRuns::Group {
  std::uint64_t number = 0;
  TomlValue root = {};  // of one of its runs
  ReadCase read = {};
  Problem problem = {};
  std::optional<FreeResponse> free = {};
  std::optional<PlanFreeResponse> free_in_plan = {};  // of buildings in plan, in place of all of these
};

struct StudyRuns::Place {
  std::mutex mutex;
  std::shared_ptr<const Group> group;
};

struct StudyRuns::Workspace {
  std::shared_ptr<const Group> group;
  Problem problem;
  TomlValue root;
  Case c;
};

StudyRuns::StudyRuns(Study study, StudyFacts facts, std::shared_ptr<CaseMemo> memo, RunValues values)
    : study_(std::move(study)),
      facts_(std::move(facts)),
      memo_(std::move(memo)),
      design_(design_axes(study_, true), study_.sampling),
      quantities_(quantities_of(facts_)),
      other_values_(std::move(values)) {
  widths_only_ = std::all_of(study_.varies.begin(), study_.varies.end(), [&](const Vary& vary) {
    return !design_.axes()[vary.axis].inner || width_place(vary.path).has_value();
  });
  // In plan laws may vary within a group: a run that a scaled response does not serve is solved by itself.
  const System system = facts_.plan ? system_of(*facts_.plan) : system_of(facts_.problem);
  scales_ = (facts_.plan || widths_only_) && are_homogeneous(system.contacts, system.rubbing);
}

StudyRuns::~StudyRuns() = default;

std::vector<Choice> StudyRuns::choices(std::size_t run) const {
  std::vector<Choice> result(design_.axes().size());
  for (std::size_t axis = 0; axis < result.size(); ++axis) {
    if (design_.axes()[axis].levels > 0) {
      result[axis].level = design_.level(run, axis);
    } else {
      result[axis].u = design_.unit(run, axis);
    }
  }
  return result;
}

TomlValue StudyRuns::root_of(std::size_t run) const {
  const std::vector<Choice> chosen = choices(run);
  TomlValue root = chosen_case(study_, chosen);
  if (const auto& ida = study_.ida; ida && ida->axis) {
    put_intensity(facts_.intensities, chosen, ida->levels[chosen[*ida->axis].level], root);
  }
  return root;
}

ReadCase StudyRuns::plan_of(std::size_t run) const {
  Diagnostics found;
  ReadCase read = read_chosen(study_, root_of(run), *memo_, found);
  if (!found.ok()) throw NotACase(first_message(found));
  if (!same_places(*read.plan, *facts_.plan)) {
    throw NotACase("other numbers of floors, planes, bearings or contact points");
  }
  return read;
}

std::shared_ptr<const StudyRuns::Group> StudyRuns::made_group(std::size_t run, const ReadCase* in_plan) const {
  Group group{.number = design_.group(run)};
  if (facts_.plan) {
    const std::optional<ReadCase> read = in_plan == nullptr ? std::optional(plan_of(run)) : std::nullopt;
    const ReadCase& chosen = read ? *read : *in_plan;
    group.free_in_plan = free_response_of(run, *chosen.plan, chosen.c.analysis, &Group::free_in_plan);
    return std::make_shared<const Group>(std::move(group));
  }
  Diagnostics found;
  group.root = root_of(run);
  group.read = read_chosen(study_, group.root, *memo_, found);
  if (!found.ok()) throw NotACase(first_message(found));
  group.problem = group.read.problem();
  if (!same_places(group.problem, facts_.problem)) throw NotACase("other numbers of floors, contact points or links");
  group.free = free_response_of(run, group.problem, group.read.c.analysis, &Group::free);
  return std::make_shared<const Group>(std::move(group));
}

/// Of a run whose record is scaled to another level that of the one at the first level, scaled, where that can be.
template <class Free, class AnyProblem>
Free StudyRuns::free_response_of(std::size_t run, const AnyProblem& problem, const AnalysisSpec& analysis,
                                 std::optional<Free> Group::*of) const {
  const std::optional<std::size_t> first = at_first_level(run);
  const auto is_scalable = [&](const System& system) {
    return is_homogeneous(system) && (facts_.plan || are_homogeneous(system.contacts, system.rubbing));
  };
  if (first && *first != run && scales_ && is_scalable(system_of(problem))) {
    const std::shared_ptr<const Group> group = shared_group(*first);
    if (std::optional<Free> scaled = (*group.*of)->scaled(problem)) return *std::move(scaled);
  }
  return Free(problem, analysis.solver, nullptr, run_limits(analysis), facts_.plan.has_value());
}

std::optional<std::size_t> StudyRuns::at_first_level(std::size_t run) const {
  if (!study_.ida || !study_.ida->axis || !design_.is_grid()) return std::nullopt;
  return design_.at_level(run, *study_.ida->axis, 0);
}

/// Of those of its group the one that the group is made of, whichever comes first: at the first level of all inner
/// axes.
std::size_t StudyRuns::representative(std::size_t run) const {
  for (std::size_t axis = 0; design_.is_grid() && axis < design_.axes().size(); ++axis) {
    if (design_.axes()[axis].inner) run = design_.at_level(run, axis, 0);
  }
  return run;
}

std::shared_ptr<const StudyRuns::Group> StudyRuns::group_of(std::size_t run, const ReadCase* in_plan) const {
  const bool is_shared = design_.has_groups() || at_first_level(run) == run;
  return is_shared ? shared_group(run, in_plan) : made_group(run, in_plan);
}

std::shared_ptr<const StudyRuns::Group> StudyRuns::shared_group(std::size_t run, const ReadCase* in_plan) const {
  const std::uint64_t number = design_.group(run);
  std::shared_ptr<Place> place;
  {
    const std::lock_guard lock(mutex_);
    std::shared_ptr<Place>& known = groups_[number];
    if (!known) {
      known = std::make_shared<Place>();
      recent_.push_back(number);
    }
    place = known;
    if (recent_.size() > most_groups) {
      groups_.erase(recent_.front());
      recent_.erase(recent_.begin());
    }
  }
  const std::lock_guard lock(place->mutex);  // others that need the same group wait for it
  const std::size_t of = facts_.plan ? representative(run) : run;
  if (!place->group) place->group = made_group(of, of == run ? in_plan : nullptr);
  return place->group;
}

void StudyRuns::set_problem(Workspace& workspace, std::size_t run) const {
  if (!workspace.group || (workspace.group->number != design_.group(run))) {
    workspace.group = nullptr;
    workspace.group = group_of(run);
    workspace.problem = workspace.group->problem;
    if (!widths_only_) {
      workspace.root = workspace.group->root;
      workspace.c = workspace.group->read.c;
    }
  }
  const std::vector<Choice> chosen = choices(run);
  if (widths_only_) {
    for (const Vary& vary : study_.varies) {
      if (design_.axes()[vary.axis].inner) {
        set_widths(*width_place(vary.path), chosen_value(vary, chosen[vary.axis]), workspace.problem);
      }
    }
    return;
  }
  put_choices(study_, chosen, workspace.root);
  Diagnostics found;
  const std::string name = study_.case_file.string();
  workspace.c.gaps = read_gaps(TomlView(workspace.root, "", name, found), workspace.group->read.buildings);
  if (!found.ok()) throw NotACase(first_message(found));
  workspace.problem.points = contact_points(workspace.c, workspace.problem.buildings);
  workspace.problem.watched = watched_floors(workspace.c, workspace.problem.buildings, workspace.problem.points);
}

namespace {

/// How a run ended, with a row of so many values that `fill` fills where it got to its end; nothing where it was
/// stopped.
template <class Of, class Fill>
std::optional<RunResult> result_of(std::size_t run, const Of& response, std::size_t size, const Fill& fill) {
  if (response.status == Status::stopped) return std::nullopt;
  if (response.status == Status::failed) return RunResult{run, RunStatus::failed, response.message, {}};
  RunResult result{run, RunStatus::done, {}, std::vector<double>(size)};
  fill(result.values);
  return result;
}

}  // namespace

std::optional<RunResult> StudyRuns::solved(Workspace& workspace, std::size_t run, SolveOptions& options) const {
  set_problem(workspace, run);
  options.limits = run_limits(workspace.group->read.c.analysis);
  const Response response = workspace.group->free->solve(workspace.problem, options);
  return row_of(run, workspace.group->read.c, workspace.problem, response);
}

std::optional<RunResult> StudyRuns::row_of(std::size_t run, const Case& c, const Problem& problem,
                                           const Response& response) const {
  return result_of(run, response, row_size(quantities_), [&](std::span<double> row) {
    RunView view(problem, response, facts_.units);
    const std::vector<Remark> found = remarks(c, problem, &response);
    view.remarks = &found;
    fill_row(quantities_, view, row);
  });
}

std::optional<RunResult> StudyRuns::solved_in_plan(Workspace& workspace, std::size_t run, SolveOptions& options) const {
  ReadCase chosen = plan_of(run);
  if (!workspace.group || workspace.group->number != design_.group(run)) {
    workspace.group = nullptr;
    try {
      workspace.group = group_of(run, &chosen);
    } catch (const NotACase&) {  // another run, which the group is made of
    } catch (const InvalidParameter&) {
    }
  }
  options.limits = run_limits(chosen.c.analysis);
  options.levels = true;
  std::optional<PlanResponse> response;
  try {
    if (workspace.group) response = workspace.group->free_in_plan->solve(*chosen.plan, options);
  } catch (const InvalidParameter&) {  // more than gaps and laws differs from what the group is made of
  }
  if (!response) response = bentur::solve(*chosen.plan, chosen.c.analysis.solver, options);
  return row_of(run, std::move(chosen.c), std::move(*chosen.plan), *std::move(response));
}

std::optional<RunResult> StudyRuns::row_of(std::size_t run, Case c, PlanProblem problem, PlanResponse response) const {
  return result_of(run, response, row_size(quantities_), [&](std::span<double> row) {
    fill_row(quantities_, run_results(std::move(c), std::move(problem), std::move(response)), row);
  });
}

template <class AnyProblem>
std::optional<RunResult> StudyRuns::solved_alone(std::size_t run, const Case& c, const AnyProblem& problem,
                                                 const std::function<bool()>& go_on) const {
  SolveOptions options;
  options.energy_audit = facts_.energy_audit;
  options.limits = run_limits(c.analysis);
  options.levels = facts_.plan.has_value();
  options.progress = [&](double) { return go_on(); };
  try {
    return row_of(run, c, problem, bentur::solve(problem, c.analysis.solver, options));
  } catch (const InvalidParameter& error) {
    return RunResult{run, RunStatus::invalid, error.what(), {}};
  }
}

std::optional<RunResult> StudyRuns::solve_case(std::size_t run, const Case& c, const Problem& problem,
                                               const std::function<bool()>& go_on) const {
  return solved_alone(run, c, problem, go_on);
}

std::optional<RunResult> StudyRuns::solve_case(std::size_t run, const Case& c, const PlanProblem& problem,
                                               const std::function<bool()>& go_on) const {
  return solved_alone(run, c, problem, go_on);
}

std::vector<RunResult> StudyRuns::solve(std::span<const std::size_t> runs, const std::function<bool()>& go_on) const {
  std::vector<RunResult> results;
  results.reserve(runs.size());
  SolveOptions options;
  options.energy_audit = facts_.energy_audit;
  options.progress = [&](double) { return go_on(); };
  Workspace workspace;
  for (const std::size_t run : runs) {
    if (!go_on()) break;
    RunResult result{run, RunStatus::done, {}, {}};
    try {
      if (other_values_) {
        std::optional<std::vector<double>> values = other_values_(choices(run), go_on);
        if (!values) break;
        results.push_back({run, RunStatus::done, {}, *std::move(values)});
        continue;
      }
      std::optional<RunResult> one =
          facts_.plan ? solved_in_plan(workspace, run, options) : solved(workspace, run, options);
      if (!one) break;
      result = std::move(*one);
    } catch (const NotACase& error) {
      result = {run, RunStatus::invalid, error.what(), {}};
    } catch (const InvalidParameter& error) {
      result = {run, RunStatus::invalid, error.what(), {}};
    }
    results.push_back(std::move(result));
  }
  return results;
}

}  // namespace bentur
