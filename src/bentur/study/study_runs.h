#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "bentur/model/plan/plan_run.h"
#include "bentur/model/quantity_row.h"
#include "bentur/pounding/pounding.h"
#include "bentur/study/design/study_check.h"
#include "bentur/study/design/sweep_design.h"

namespace bentur {

/// How a run ended. A case that no check beforehand could find wrong is one of values that do not go together.
enum class RunStatus : unsigned char { done = 0, failed = 1, invalid = 2 };

struct RunResult {
  std::size_t run = 0;
  RunStatus status = RunStatus::done;
  std::string message;         ///< why, unless done
  std::vector<double> values;  ///< a row by row_parts(); empty unless done
};

/// What is computed of a run in place of its row: nothing where it was stopped.
using RunValues = std::function<std::optional<std::vector<double>>(const std::vector<Choice>& choices,
                                                                   const std::function<bool()>& go_on)>;

/// The runs of a study. Runs of one group (SweepDesign) share buildings, record and the response without contact, runs
/// of different groups what is alike in them; runs of one record at several intensities share that response too where
/// it only scales with them. What a run gives does not depend on which others are run, or where. May serve many
/// threads.
class StudyRuns {
 public:
  /// `study` has been checked, with these facts.
  StudyRuns(Study study, StudyFacts facts, std::shared_ptr<CaseMemo> memo, RunValues values = {});
  ~StudyRuns();

  [[nodiscard]] const Study& study() const noexcept { return study_; }
  [[nodiscard]] const StudyFacts& facts() const noexcept { return facts_; }
  [[nodiscard]] const SweepDesign& design() const noexcept { return design_; }
  [[nodiscard]] const std::vector<RowPart>& quantities() const noexcept { return quantities_; }

  /// What run number `run` has along each axis.
  [[nodiscard]] std::vector<Choice> choices(std::size_t run) const;

  /// Solves the runs one after the other, best in the order of the plan. `go_on` is asked now and then; once it says
  /// false the rest is left out.
  [[nodiscard]] std::vector<RunResult> solve(std::span<const std::size_t> runs,
                                             const std::function<bool()>& go_on) const;

  /// The same of a run whose case is there already, made otherwise than by the study: its places are those of the
  /// others (take_places()). Nothing where it was stopped.
  [[nodiscard]] std::optional<RunResult> solve_case(std::size_t run, const Case& c, const Problem& problem,
                                                    const std::function<bool()>& go_on) const;
  [[nodiscard]] std::optional<RunResult> solve_case(std::size_t run, const Case& c, const PlanProblem& problem,
                                                    const std::function<bool()>& go_on) const;

 private:
  struct Group;
  struct Place;      // of a group in the making
  struct Workspace;  // what one call of solve() works with

  /// Its case, with the record at its intensity.
  [[nodiscard]] TomlValue root_of(std::size_t run) const;
  [[nodiscard]] ReadCase plan_of(std::size_t run) const;
  /// @param in_plan the run's case of buildings in plan, where it has been read
  [[nodiscard]] std::shared_ptr<const Group> made_group(std::size_t run, const ReadCase* in_plan) const;
  /// Of an [ida] in a grid, the run that differs from `run` by its intensity alone and has the first one.
  [[nodiscard]] std::optional<std::size_t> at_first_level(std::size_t run) const;
  /// @param of the free response of a group
  template <class Free, class AnyProblem>
  [[nodiscard]] Free free_response_of(std::size_t run, const AnyProblem& problem, const AnalysisSpec& analysis,
                                      std::optional<Free> Group::*of) const;
  [[nodiscard]] std::size_t representative(std::size_t run) const;
  [[nodiscard]] std::shared_ptr<const Group> group_of(std::size_t run, const ReadCase* in_plan = nullptr) const;
  [[nodiscard]] std::shared_ptr<const Group> shared_group(std::size_t run, const ReadCase* in_plan = nullptr) const;
  void set_problem(Workspace& workspace, std::size_t run) const;
  /// A run until its end, with its values where it got there; nothing where it was stopped.
  [[nodiscard]] std::optional<RunResult> solved(Workspace& workspace, std::size_t run, SolveOptions& options) const;
  [[nodiscard]] std::optional<RunResult> solved_in_plan(Workspace& workspace, std::size_t run,
                                                        SolveOptions& options) const;
  template <class AnyProblem>
  [[nodiscard]] std::optional<RunResult> solved_alone(std::size_t run, const Case& c, const AnyProblem& problem,
                                                      const std::function<bool()>& go_on) const;
  [[nodiscard]] std::optional<RunResult> row_of(std::size_t run, Case c, PlanProblem problem,
                                                PlanResponse response) const;
  [[nodiscard]] std::optional<RunResult> row_of(std::size_t run, const Case& c, const Problem& problem,
                                                const Response& response) const;

  Study study_;
  StudyFacts facts_;
  std::shared_ptr<CaseMemo> memo_;
  SweepDesign design_;
  std::vector<RowPart> quantities_;
  RunValues other_values_;    // empty: a row
  bool widths_only_ = false;  // nothing but widths varies within a group
  bool scales_ = false;       // free responses of other intensities serve the contacts of a group
  mutable std::mutex mutex_;
  mutable std::map<std::uint64_t, std::shared_ptr<Place>> groups_;  // those in use
  mutable std::vector<std::uint64_t> recent_;                       // their numbers, oldest first
};

}  // namespace bentur
