#include "bentur/study/remedy/remedy.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <memory>
#include <numeric>
#include <set>
#include <stdexcept>

#include "bentur/io/schema/parameter_units.h"
#include "bentur/study/build_identity.h"
#include "bentur/study/design/record_intensity.h"
#include "bentur/study/design/study_check.h"
#include "bentur/study/design/sweep_design.h"
#include "bentur/study/journal.h"
#include "bentur/study/remedy/internal/measure.h"
#include "bentur/study/remedy/objective_slopes.h"
#include "bentur/study/remedy/optimiser.h"
#include "bentur/study/study_runs.h"
#include "bentur/study/study_variables.h"

namespace bentur {
namespace {

using Clock = std::chrono::steady_clock;
using Places = std::vector<double>;

constexpr double none = std::numeric_limits<double>::infinity();
constexpr double at_end = 1e-3;    // of a range, from its end
constexpr double same_to = 1e-6;   // of an objective, by two ways
constexpr double apart = 0.2;      // of a range, another place to begin at
constexpr int most_halvings = 12;  // of the way back, to 1/4096 of it
constexpr auto sync_every = std::chrono::seconds(2);

struct Stopped {};   // asked to end
struct NoneLeft {};  // of the evaluations

/// Axes that are chosen, in their order.
std::vector<std::size_t> chosen_axes(const Study& study) {
  std::set<std::size_t> axes;
  for (const Vary& vary : study.varies) {
    if (vary.sought) axes.insert(vary.axis);
  }
  return {axes.begin(), axes.end()};
}

/// Of a building whose calibrate_period is chosen and not in the case: its own first period [s], from what its
/// stiffness is multiplied by where that is `from`.
std::optional<double> own_period(const Vary& vary, const Problem& of_first_choice) {
  if (vary.path.size() != 3 || vary.path.back() != PathStep("calibrate_period")) return std::nullopt;
  const auto* const place = std::get_if<std::size_t>(&vary.path[1]);
  if (place == nullptr || *place >= of_first_choice.buildings.size()) return std::nullopt;
  const std::optional<double>& factor = of_first_choice.buildings[*place].model.stiffness_factor;
  return factor ? std::optional(vary.sought->from * std::sqrt(*factor)) : std::nullopt;
}

/// The place in its range of what the case says: of a list of one number that number; `from` where it says none.
double place_of_case(const Study& study, const Vary& vary, const Problem& of_first_choice) {
  if (vary.factor) return vary.sought->place(1);
  const TomlValue* value = find_value(study.case_root, vary.path);
  if (value == nullptr) {
    if (const auto period = own_period(vary, of_first_choice)) return vary.sought->place(*period);
  }
  while (value != nullptr && value->kind == TomlValue::Kind::list && !value->items.empty()) value = &value->items[0];
  return value != nullptr && value->is_number() ? vary.sought->place(value->real) : 0;
}

/// What one run gives.
struct Measured {
  double value = none;     ///< Measure
  std::uint64_t open = 0;  ///< what keeps that from being known, bits of OpenNeed
};

/// Tries choices, one after the other; each place once.
class Trials {
 public:
  Trials(RemedySearch& search, StudyFacts facts, std::shared_ptr<CaseMemo> memo, const RemedyOptions& options,
         const std::vector<RowPart>& quantities)
      : search_(search),
        facts_(std::move(facts)),
        memo_(std::move(memo)),
        options_(options),
        measure_(quantities, search.spec().objective),
        slopes_(measure_.parts(), search.study, chosen_axes(search.study), memo_) {
    for (const std::size_t axis : chosen_axes(search.study)) {
      start_.push_back(place_of_case(search.study, search.study.first_along(axis), facts_.problem));
    }
    find_records();
    open_journal();
  }

  [[nodiscard]] const Places& start() const { return start_; }
  [[nodiscard]] std::size_t left() const { return search_.spec().evaluations - search_.trials.size(); }
  [[nodiscard]] double size_of(const Places& places) const {
    double sum = 0;
    for (std::size_t i = 0; i < places.size(); ++i) sum += std::abs(places[i] - start_[i]);
    return sum / static_cast<double>(places.size());
  }

  /// The objective at a place. @throws Stopped, NoneLeft
  double objective(const Places& places) {
    for (const RemedyTrial& known : search_.trials) {
      if (known.places == places) return known.objective;
    }
    if (left() == 0) throw NoneLeft();
    RemedyTrial trial{.places = places, .values = {}, .objective = 0, .size = size_of(places), .failed = 0};
    for (const RemedyParameter& one : search_.parameters) trial.values.push_back(one.range.at(places[one.axis]));
    const std::vector<Measured> measures = measures_of(places);
    std::map<std::size_t, double> of_records;  // the worst of all runs of each
    for (std::size_t i = 0; i < measures.size(); ++i) {
      const bool is_known = std::isfinite(measures[i].value);
      trial.failed += is_known ? 0 : 1;
      if (is_known) trial.open.add(measures[i].open);
      double& worst = of_records[record_of_[i]];
      worst = std::max(worst, measures[i].value);
    }
    for (const auto& [record, worst] : of_records) {
      trial.objective = search_.spec().mean ? trial.objective + worst / static_cast<double>(of_records.size())
                                            : std::max(trial.objective, worst);
    }
    search_.trials.push_back(std::move(trial));
    return search_.trials.back().objective;
  }

  /// The same with a number for a search where there is none: as bad as the worst so far.
  double finite(const Places& places) {
    const double value = objective(places);
    if (std::isfinite(value)) return value;
    double worst = 1;
    for (const RemedyTrial& one : search_.trials) {
      if (std::isfinite(one.objective)) worst = std::max(worst, 2 * one.objective);
    }
    return worst;
  }

  /// The peaks near the objective at a place where it is known, with their slopes; empty: there are none. Of the mean
  /// over records it is one peak for all, of the largest of each.
  std::vector<FunctionPart> parts(const Places& places) {
    if (!options_.slopes || !slopes_.may_be()) return {};
    const double value = objective(places);
    if (!std::isfinite(value)) return {};
    const auto known = known_parts_.find(places);
    return known != known_parts_.end() ? known->second : known_parts_[places] = found_parts(places, value);
  }

  [[nodiscard]] PlaceFunction function() {
    return [this](const Places& places) { return finite(places); };
  }
  [[nodiscard]] FunctionParts slopes() {
    return [this](const Places& places) { return parts(places); };
  }

  void finish() {
    if (journal_) journal_->sync();
  }

 private:
  /// Which record each run of a trial is of, whichever way it is applied and whatever else varies.
  void find_records() {
    const Study one = chosen_study(search_.study, start_);
    const SweepDesign design(design_axes(one), one.sampling);
    const AxisSubset records = record_axes(one, false);
    for (std::size_t run = 0; run < search_.runs_each; ++run) {
      std::size_t place = 0;
      for (std::size_t i = 0; i < records.axes.size(); ++i) {
        place = place * records.sizes[i] + design.level(run, records.axes[i]);
      }
      record_of_.push_back(place);
    }
  }

  void open_journal() {
    if (options_.journal.empty()) return;
    const JournalOrigin origin{.version = options_.version,
                               .build = std::string(build_identity()),
                               .study = search_.study.text,
                               .case_text = search_.study.case_text,
                               .records = facts_.records,
                               .runs = search_.spec().evaluations * search_.runs_each,
                               .values = 2 + search_.axes};
    std::error_code failed;
    if (!std::filesystem::exists(options_.journal, failed)) {
      journal_.emplace(Journal::begin(options_.journal, origin));
    } else if (!options_.resume) {
      throw std::runtime_error(
          fmt::format("{}: evaluations of an unfinished search are there: go on with {}, or remove the file",
                      options_.journal.string(), options_.resumed_by));
    } else {
      journal_.emplace(Journal::resume(options_.journal, origin));
    }
  }

  /// Of each run of a choice, known from the journal or solved.
  std::vector<Measured> measures_of(const Places& places) {
    const std::size_t first = search_.trials.size() * search_.runs_each;
    std::vector<Measured> measures(search_.runs_each);
    std::vector<std::size_t> missing;
    for (std::size_t i = 0; i < measures.size(); ++i) {
      if (!journal_ || !journal_->is_done(first + i)) {
        missing.push_back(i);
        continue;
      }
      const RunResult known = journal_->read(first + i, 1).front();
      if (known.status != RunStatus::done) continue;
      if (!std::equal(places.begin(), places.end(), known.values.begin() + 2)) {
        throw std::runtime_error(options_.journal.string() + ": has another search's evaluations; remove the file");
      }
      measures[i] = {known.values[0], static_cast<std::uint64_t>(known.values[1])};
    }
    if (!missing.empty()) solve(places, first, missing, measures);
    return measures;
  }

  std::vector<RunResult> solved(const StudyRuns& runs, const std::vector<std::size_t>& wanted) {
    const auto goes_on = [&] {
      const double done = static_cast<double>(search_.trials.size()) / static_cast<double>(search_.spec().evaluations);
      return !options_.goes_on || options_.goes_on(done);
    };
    return options_.solve ? options_.solve(runs, wanted, goes_on) : runs.solve(wanted, goes_on);
  }

  std::vector<FunctionPart> found_parts(const Places& places, double value) {
    std::vector<std::size_t> all(search_.runs_each);
    std::iota(all.begin(), all.end(), std::size_t{0});
    const StudyRuns runs(chosen_study(search_.study, places), facts_, memo_, slopes_.at(places));
    const std::vector<RunResult> results = solved(runs, all);
    if (results.size() < all.size()) throw Stopped();
    std::map<std::size_t, FunctionPart> worst;  // of each record
    std::vector<FunctionPart> parts;
    for (const RunResult& result : results) {
      for (FunctionPart& part : slopes_.parts(result.values)) {
        FunctionPart& of_record = worst[record_of_[result.run]];
        if (part.value > of_record.value) of_record = part;
        parts.push_back(std::move(part));
      }
    }
    if (search_.spec().mean) parts = {mean_of(worst)};
    // Where another thing than these peaks is the largest, their slopes are not the objective's.
    double most = 0;
    for (const FunctionPart& part : parts) most = std::max(most, part.value);
    if (parts.empty() || !(std::abs(most - value) <= same_to * value)) return {};
    ++search_.with_slopes;
    return parts;
  }

  FunctionPart mean_of(const std::map<std::size_t, FunctionPart>& of_records) const {
    FunctionPart mean{0, Places(start_.size(), 0.0)};
    for (const auto& [record, part] : of_records) {
      mean.value += part.value / static_cast<double>(of_records.size());
      for (std::size_t i = 0; i < part.slope.size(); ++i) {
        mean.slope[i] += part.slope[i] / static_cast<double>(of_records.size());
      }
    }
    return mean;
  }

  void solve(const Places& places, std::size_t first, const std::vector<std::size_t>& missing,
             std::vector<Measured>& measures) {
    const StudyRuns runs(chosen_study(search_.study, places), facts_, memo_);
    const std::vector<RunResult> results = solved(runs, missing);
    for (const RunResult& result : results) {
      const Measured& measured = measures[result.run] = {measure_(result), measure_.open(result)};
      if (!journal_) continue;
      RunResult kept{.run = first + result.run, .status = RunStatus::failed, .message = result.message, .values = {}};
      if (std::isfinite(measured.value)) {
        kept.status = RunStatus::done;
        kept.values = {measured.value, static_cast<double>(measured.open)};
        kept.values.insert(kept.values.end(), places.begin(), places.end());
      }
      journal_->write(kept);
    }
    if (results.size() < missing.size()) throw Stopped();
    if (journal_ && Clock::now() - synced_ >= sync_every) {
      journal_->sync();
      synced_ = Clock::now();
    }
  }

  RemedySearch& search_;
  StudyFacts facts_;
  std::shared_ptr<CaseMemo> memo_;
  const RemedyOptions& options_;
  Measure measure_;
  ObjectiveSlopes slopes_;
  std::map<Places, std::vector<FunctionPart>> known_parts_;
  Places start_;
  std::vector<std::size_t> record_of_;  ///< per run of a trial
  std::optional<Journal> journal_;
  Clock::time_point synced_ = Clock::now();
};

/// Towards what the case says as far as the limit is kept.
void go_back(RemedySearch& search, Trials& trials) {
  const Places far = search.smallest()->places;
  double kept = 1, broken = 0;  // parts of the way from the case
  for (int i = 0; i < most_halvings; ++i) {
    const double middle = (kept + broken) / 2;
    Places places = trials.start();
    for (std::size_t a = 0; a < places.size(); ++a) places[a] += middle * (far[a] - places[a]);
    (trials.objective(places) <= *search.spec().limit ? kept : broken) = middle;
  }
}

/// The best of those that lie apart from all of some places; nothing where none has a number.
const RemedyTrial* best_apart(const RemedySearch& search, const std::vector<Places>& from) {
  const RemedyTrial* found = nullptr;
  for (const RemedyTrial& one : search.trials) {
    const bool is_apart =
        std::all_of(from.begin(), from.end(), [&](const Places& other) { return farthest(one.places, other) > apart; });
    if (is_apart && std::isfinite(one.objective) && (found == nullptr || one.objective < found->objective))
      found = &one;
  }
  return found;
}

/// From the best on; with slopes, which need few steps, from another one too.
void seek_least(RemedySearch& search, Trials& trials, std::size_t evaluations) {
  if (search.best() == nullptr) return;
  const std::size_t before = search.trials.size();
  Descent down{trials.function(), trials.slopes(), search.best()->places, evaluations};
  if (!search_by_slopes(down)) {
    return search_nearby({.objective = down.function, .start = down.start, .evaluations = evaluations});
  }
  const RemedyTrial* const other = best_apart(search, {down.start, search.best()->places});
  const std::size_t used = search.trials.size() - before;
  if (other == nullptr || used >= evaluations) return;
  down.start = other->places;
  down.evaluations = evaluations - used;
  search_by_slopes(down);
}

/// From the smallest on that keeps the limit.
void seek_smallest(RemedySearch& search, Trials& trials, std::size_t evaluations) {
  const double limit = *search.spec().limit;
  const Places start = search.smallest()->places;
  const Nearest nearest{trials.start(), limit};
  if (search_by_slopes({trials.function(), trials.slopes(), start, evaluations, nearest})) return;
  search_nearby({.objective = [&](const Places& places) { return trials.size_of(places); },
                 .constraint = [&](const Places& places) { return trials.finite(places) - limit; },
                 .start = start,
                 .evaluations = evaluations});
}

void seek(RemedySearch& search, Trials& trials) {
  (void)trials.objective(trials.start());
  const bool limited = search.spec().limit.has_value();
  const std::size_t back = limited ? std::min<std::size_t>(most_halvings, trials.left() / 4) : 0;
  Minimisation everywhere{
      .objective = trials.function(), .start = trials.start(), .evaluations = (trials.left() - back) / 4};
  const std::size_t half = (trials.left() - back) / 2;
  search_everywhere(everywhere);
  if (search.best() == nullptr || trials.parts(search.best()->places).empty()) {
    everywhere.evaluations = half;  // once more from its beginning: what is known costs nothing
    search_everywhere(everywhere);
  }
  const std::size_t rest = trials.left() - back;
  seek_least(search, trials, limited ? rest / 2 : rest);
  if (search.smallest() == nullptr || search.smallest()->size == 0) return;
  if (search.axes > 1) seek_smallest(search, trials, trials.left() - back);
  go_back(search, trials);
}

/// An error where the results have no such quantity, with those they have.
bool refuse_objective(const std::vector<RowPart>& quantities, const RemedySpec& spec, Diagnostics& diagnostics) {
  if (!parts_named(quantities, spec.objective).empty()) return false;
  std::set<std::string> names;
  for (const RowPart& part : quantities) names.insert(part.is_of_building() ? without_number(part.name) : part.name);
  diagnostics.error(spec.position, fmt::format("remedy.objective = \"{}\", must be a quantity of the results: {}",
                                               spec.objective, fmt::join(names, ", ")));
  return true;
}

}  // namespace

Study chosen_study(const Study& study, const std::vector<double>& places) {
  Study one = study;
  const std::vector<std::size_t> axes = chosen_axes(study);
  for (Vary& vary : one.varies) {
    if (!vary.sought) continue;
    const auto place = static_cast<std::size_t>(std::find(axes.begin(), axes.end(), vary.axis) - axes.begin());
    vary.values = {toml_number(vary.sought->at(places[place]))};
  }
  return one;
}

const RemedyTrial* RemedySearch::best() const {
  const RemedyTrial* found = nullptr;
  for (const RemedyTrial& one : trials) {
    if (!std::isfinite(one.objective)) continue;
    const bool better = found == nullptr || one.objective < found->objective ||
                        (one.objective == found->objective && one.size < found->size);
    if (better) found = &one;
  }
  return found;
}

const RemedyTrial* RemedySearch::smallest() const {
  const RemedyTrial* found = nullptr;
  for (const RemedyTrial& one : trials) {
    if (!spec().limit || !(one.objective <= *spec().limit)) continue;
    if (found == nullptr || one.size < found->size) found = &one;
  }
  return found;
}

std::vector<std::size_t> RemedySearch::at_bounds(const RemedyTrial& trial) const {
  std::vector<std::size_t> found;
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    const double u = trial.places[parameters[i].axis];
    const bool moved = std::abs(u - trials.front().places[parameters[i].axis]) > at_end;
    if (moved && (u < at_end || u > 1 - at_end)) found.push_back(i);
  }
  return found;
}

std::optional<RemedySearch> seek_remedy(const std::filesystem::path& file, const RemedyOptions& options,
                                        Diagnostics& diagnostics) {
  std::optional<Study> study = read_study(file, diagnostics);
  if (!study) return std::nullopt;
  if (!study->remedy) {
    diagnostics.error({file.string(), 0, 0}, "[remedy] is missing, with objective: what is to become small");
    return std::nullopt;
  }
  if (!has_optimiser()) {
    diagnostics.error(study->remedy->position, "[remedy] needs NLopt, which this build of bentur has not");
    return std::nullopt;
  }
  check_names(*study, diagnostics);
  const auto memo = std::make_shared<CaseMemo>();
  std::optional<StudyFacts> facts = check_study(*study, *memo, diagnostics);
  if (!facts || !diagnostics.ok()) return std::nullopt;
  const std::vector<RowPart> quantities = quantities_of(*facts);
  if (refuse_objective(quantities, *study->remedy, diagnostics)) return std::nullopt;

  RemedySearch search;
  search.study = std::move(*study);
  search.title = facts->title;
  search.buildings = building_names(*facts);
  search.unit = parts_named(quantities, search.spec().objective).front().units;
  const std::vector<std::size_t> axes = chosen_axes(search.study);
  search.axes = axes.size();
  std::set<std::size_t> of_records;
  for (const Vary& vary : search.study.varies) {
    if (vary.sought) {
      const auto axis = std::find(axes.begin(), axes.end(), vary.axis) - axes.begin();
      search.parameters.push_back({vary.name, vary.parameter,
                                   vary.factor ? "1" : parameter_units(vary.path, search.study.case_root, facts->units),
                                   *vary.sought, static_cast<std::size_t>(axis)});
    } else if (of_records.insert(vary.axis).second) {
      search.runs_each *= vary.values.size();
    }
  }
  search.both_ways = std::any_of(search.study.varies.begin(), search.study.varies.end(), [](const Vary& vary) {
    return vary.path == ParameterPath{"excitation", "polarity"} && vary.values.size() == 2;
  });
  Trials trials(search, std::move(*facts), memo, options, quantities);
  try {
    seek(search, trials);
  } catch (const NoneLeft&) {  // all that may be tried has been
  } catch (const Stopped&) {
    search.stopped = true;
  }
  trials.finish();
  return search;
}

}  // namespace bentur
