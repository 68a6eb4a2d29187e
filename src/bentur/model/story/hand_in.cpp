#include "bentur/model/story/hand_in.h"
#include "bentur/model/contact/worst_column.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "bentur/model/plan/plan_frames.h"
#include "bentur/model/plan/plan_row.h"
#include "bentur/model/story/internal/hand_in_open.h"

namespace bentur {
namespace {

using Eigen::Index;
using story::assumptions_of;
using story::GapView;
using story::level_text;
using story::text_of;
using story::unchecked_of;
using story::with_unit;

constexpr double of_hundred = 100;

/// The table of checks, row by row.
class Checks {
 public:
  /// @param by a key of the case, a clause or a publication
  /// @param result a word of the catalogue
  void add(const std::string& check, const std::string& by, const std::string& where, const std::string& demand,
           const std::string& limit, const std::string& result, bool stands_out) {
    if (stands_out) table_.marked.push_back(check_.texts.size());
    check_.texts.push_back(check);
    by_.texts.push_back(by);
    where_.texts.push_back(where);
    demand_.texts.push_back(demand);
    limit_.texts.push_back(limit);
    result_.texts.push_back(result);
  }
  void add(const std::string& check, const std::string& by, const std::string& where, const std::string& demand,
           const std::string& limit, bool is_met) {
    add(check, by, where, demand, limit, is_met ? "check.met" : "check.not_met", !is_met);
  }
  [[nodiscard]] StoryTable take() {
    if (!check_.texts.empty()) table_.columns = {check_, by_, where_, demand_, limit_, result_};
    return std::move(table_);
  }

 private:
  StoryTable table_{.kind = "checks"};
  StoryColumn check_{.label = "check.check", .are_words = true}, by_{.label = "check.by", .are_words = true};
  StoryColumn where_{.label = "check.where"}, demand_{.label = "check.demand"}, limit_{.label = "check.limit"};
  StoryColumn result_{.label = "check.result", .are_words = true};
};

/// The worst demand over capacity of the columns that are struck in each gap.
void check_columns(const RunResults& run, Checks& checks) {
  for (const bool shear : {true, false}) {
    for (const Gap& gap : gaps_of(run.problem)) {
      const std::optional<WorstColumn> worst = worst_column(run, gap, shear);
      if (!worst) continue;
      const std::string& building = run.problem.buildings[worst->building].name;
      const double level = run.problem.points[worst->point].elevation;
      checks.add(shear ? "check.column_shear" : "check.column_moment", "column_capacity",
                 building + ", " + with_unit(level, run.c.units.length), with_unit(worst->demand, worst->unit),
                 worst->ratio > 0 ? with_unit(worst->demand / worst->ratio, worst->unit) : "–",
                 !(worst->ratio > 1 - reached));
    }
  }
}

/// Of the columns of each building that can break the most loaded one.
void check_shears(const RunResults& run, Checks& checks) {
  const RunView view = run.view();
  const std::string unit = unit_text("F", view.shown.units);
  for (Index b = 0; b < std::ssize(run.problem.buildings); ++b) {
    const std::vector<BuildingPeaks::Breaking>& columns = run.response.buildings[b].columns;
    if (columns.empty()) continue;
    const auto less = [](const auto& one, const auto& other) {
      return one.shear_demand_capacity < other.shear_demand_capacity;
    };
    const BuildingPeaks::Breaking& worst = *std::max_element(columns.begin(), columns.end(), less);
    const bool broken = std::any_of(columns.begin(), columns.end(), [](const auto& one) { return one.break_time; });
    const double demand = view.shown.factor("F") * worst.peak_shear;
    checks.add("check.shear_capacity", "shear_capacity", run.problem.buildings[b].name, with_unit(demand, unit),
               worst.peak_shear > 0 ? with_unit(demand / worst.shear_demand_capacity, unit) : "–", !broken);
  }
}

/// Of the hinges of each building the worst against each limit that is given.
void check_hinges(const RunResults& run, Checks& checks) {
  constexpr const char* names[] = {"check.hinge_io", "check.hinge_ls", "check.hinge_cp"};
  for (Index b = 0; b < std::ssize(run.problem.buildings); ++b) {
    const Building& building = run.problem.buildings[b];
    const std::vector<BuildingPeaks::Hinge>& hinges = run.response.buildings[b].hinges;
    const Eigen::MatrixXd& limits = building.model.hinges.rotation_limits;
    for (Index level = 0; level < 3; ++level) {
      double most = -1, demand = 0, limit = 0;
      for (Index h = 0; h < std::min<Index>(std::ssize(hinges), limits.rows()); ++h) {
        if (std::isnan(limits(h, level)) || hinges[h].peak_rotation <= most * limits(h, level)) continue;
        demand = hinges[h].peak_rotation;
        limit = limits(h, level);
        most = demand / limit;
      }
      if (most < 0) continue;
      checks.add(names[level], "rotation_limits", building.name, with_unit(1e3 * demand, "mrad"),
                 with_unit(1e3 * limit, "mrad"), !(most > 1));
    }
  }
}

/// The largest drift of a building against that which counts as collapse. Where no gravity acts nothing looks for
/// collapse, so that no limit is met.
void check_drift(const std::string& building, bool has_gravity_loads, double most, bool falls, double limit,
                 Checks& checks) {
  const bool is_met = !falls && !(most > limit);
  if (!has_gravity_loads && is_met) return;
  checks.add(has_gravity_loads ? "check.stability" : "check.drift", "collapse_drift", building,
             with_unit(of_hundred * most, "%"), with_unit(of_hundred * limit, "%"), is_met);
}

bool falls_in(const RunOutcome& response, Index building) {
  const auto is_of_it = [&](const std::optional<Collapse>& one) { return one && one->building == building; };
  return is_of_it(response.collapse) || is_of_it(response.collapse_no_contact);
}

void check_storeys(const RunResults& run, Checks& checks) {
  for (Index b = 0; b < std::ssize(run.problem.buildings); ++b) {
    const Building& building = run.problem.buildings[b];
    if (building.is_rigid()) continue;
    const BuildingPeaks& peaks = run.response.buildings[b];
    const double most =
        std::max(largest_drift(peaks.drift_ratio).ratio, largest_drift(peaks.drift_ratio_no_contact).ratio);
    check_drift(building.name, building.has_gravity_loads, most, falls_in(run.response, b), run.problem.collapse_drift,
                checks);
  }
}

/// What is judged of a gap that this alone would let pass: "met" is said of a gap that is enough alone.
const char* passing_word(const GapView& facts, Index gap) {
  if (facts.gaps.empty()) return "check.met";
  return facts.gaps.at(static_cast<std::size_t>(gap)).judgement.is_enough() ? "check.met" : "gap.asks_less";
}

void add_against(const GapView& facts, Index gap, bool is_short, Checks& checks, const std::string& check,
                 const std::string& by, const std::string& where, const std::string& demand, const std::string& limit) {
  checks.add(check, by, where, demand, limit, is_short ? "check.not_met" : passing_word(facts, gap), is_short);
}

/// Contact in the run and in that of the motion reversed, and where no contact is modelled.
void check_contact(const GapView& view, Index gap, Checks& checks) {
  if (view.response == nullptr) return;
  const GapFacts& facts = view.gaps.at(static_cast<std::size_t>(gap)).facts;
  if (facts.levels.empty()) return;
  const Judgement& judged = view.gaps.at(static_cast<std::size_t>(gap)).judgement;
  for (const auto& [kind, check] :
       {std::pair(Reason::Kind::contact, "check.contact"), std::pair(Reason::Kind::unmodelled, "check.unmodelled")}) {
    const Reason* found = nullptr;  // of both directions the worse one
    for (const Reason& one : judged.reasons) {
      if (one.kind == kind && (found == nullptr || one.value > found->value)) found = &one;
    }
    if (found != nullptr) {
      const ShownUnits shown = shown_units(view.c.units, *view.response);
      const bool is_force = kind == Reason::Kind::contact;
      const std::string demand = !is_force          ? with_unit(found->value, view.c.units.length)
                                 : found->value > 0 ? with_unit(shown.force * found->value, shown.units.force)
                                                    : std::to_string(found->count);
      checks.add(check, "check.by_motion", level_text(view, gap, facts.levels.at(*found->level).at.elevation), demand,
                 "0", false);
      continue;
    }
    const bool known = !judged.is_open() && facts.reversed.contact_looked_at;
    checks.add(check, "check.by_motion", gap_name(view.problem, gap), "0", "0", known ? "check.met" : "check.not_known",
               !known);
  }
}

void check_need(const GapView& facts, Index gap, Checks& checks) {
  check_contact(facts, gap, checks);
  std::vector<LevelSeparation> levels = of_gap(facts.levels, gap);
  const std::string& length = facts.c.units.length;
  const auto add = [&](const char* check, bool is_known) {
    const auto found = governing_level(levels, facts.scale(gap));
    if (!found) return;
    const std::string where = level_text(facts, gap, found->elevation), limit = with_unit(found->width_here, length);
    const char* const by = facts.response == nullptr ? "check.by_spectrum" : "check.by_motion";
    if (!is_known) {
      checks.add(check, by, where, "–", limit, "check.not_known", true);
      return;
    }
    add_against(facts, gap, found->is_short(), checks, check, by, where, with_unit(found->needed_here, length), limit);
  };
  if (is_known_by_peaks(facts.problem, gap)) return;  // rules alone say what peaks are held against
  if (facts.response == nullptr) return add("check.gap_spectrum", true);
  const GapFacts& of = facts.gaps.at(static_cast<std::size_t>(gap)).facts;
  const auto is_known = [&](Way way) {
    return std::all_of(of.levels.begin(), of.levels.end(),
                       [&](const LevelFacts& one) { return one.in(way).need.has_value(); });
  };
  const bool is_alone = facts.gaps.at(static_cast<std::size_t>(gap)).judgement.alone;
  add(is_alone ? "check.gap_alone" : "check.gap", is_known(Way::given));
  if (!of.has_other_way) return;
  for (LevelSeparation& one : levels) one.gap_needed = one.gap_needed_reversed.value_or(0);
  add(is_alone ? "check.gap_reversed_alone" : "check.gap_reversed", is_known(Way::reversed));
}

void check_rules(const GapView& facts, Index gap, Checks& checks) {
  const std::vector<LevelSeparation> levels = of_gap(facts.levels, gap);
  const std::string& length = facts.c.units.length;
  for (const RuleFinding& found : story::findings_of(facts, levels, gap)) {
    const CodeRule* const code = find_code_rule(found.rule);
    if (code == nullptr) continue;  // no code has it
    const std::string clause(code->clause);
    if (!found.at) {
      checks.add(found.title, clause, gap_name(facts.problem, gap), "–", "–", story::silence_word(found.silence), true);
      continue;
    }
    const LevelSeparation& level = levels[*found.at];
    add_against(facts, gap, found.is_short, checks, found.title, clause, level_text(facts, gap, level.level.elevation),
                with_unit(found.gap, length), with_unit(level.level.width, length));
  }
}

/// @return whether a rule needs to know the seismicity
bool check_screening(const GapView& facts, Index gap, Checks& checks) {
  using Verdict = ScreeningFinding::Verdict;
  bool open = false;
  for (const ScreeningFinding& found : facts.screened.at(static_cast<std::size_t>(gap))) {
    open = open || found.verdict == Verdict::needs_seismicity;
    if (found.verdict == Verdict::needs_seismicity || found.verdict == Verdict::not_applicable) continue;
    const std::string unit = found.rule->unit == "length" ? facts.c.units.length : std::string(found.rule->unit);
    const std::string value = found.rule->yes_or_no ? "–" : with_unit(found.value, unit);
    const bool attention = found.verdict == Verdict::attention;
    checks.add("screening." + std::string(found.rule->name),
               found.rule->wording == "ours" ? "screening.ours" : std::string(found.rule->source),
               gap_name(facts.problem, gap), value, found.limit ? with_unit(*found.limit, unit) : "–",
               attention ? "screening.attention" : "screening.fine", attention);
  }
  return open;
}

/// What the program checks of its own solution.
void check_solution(const std::vector<Discrepancy>& discrepancies, Checks& checks) {
  double most = 0;
  for (const Discrepancy& found : discrepancies) most = std::max(most, found.size);
  checks.add("check.solution", "check.by_program", "", discrepancies.empty() ? "–" : number(most), "–",
             discrepancies.empty());
}

/// Rules of thumb for every gap. @return whether one of them needs to know the seismicity
bool check_screenings(const GapView& facts, Checks& checks) {
  bool needs_seismicity = false;
  for (Index gap = 0; gap < std::ssize(facts.screened); ++gap) {
    needs_seismicity = check_screening(facts, gap, checks) || needs_seismicity;
  }
  return needs_seismicity;
}

void check_gaps(const GapView& facts, Checks& checks) {
  for (Index gap = 0; gap < gap_count(facts.problem); ++gap) {
    check_need(facts, gap, checks);
    check_rules(facts, gap, checks);
  }
}

/// Rules of thumb for every gap, and all that is told of what is checked. @param run null: there is none
HandIn hand_in_with(const GapView& facts, Checks checks, const RunResults* run) {
  const bool needs_seismicity = check_screenings(facts, checks);
  if (run != nullptr) check_solution(run->response.discrepancies, checks);
  const bool without_energy = facts.response != nullptr && !facts.response->energy;
  return {facts.plan != nullptr ? assumptions_of({.c = facts.c, .problem = *facts.plan, .response = {}})
                                : assumptions_of(facts.c, facts.problem),
          checks.take(), unchecked_of(facts.c, facts, needs_seismicity, facts.plan, without_energy)};
}

HandIn hand_in(const GapView& facts, Checks checks, const RunResults* run) {
  check_gaps(facts, checks);
  return hand_in_with(facts, std::move(checks), run);
}

}  // namespace

HandIn hand_in(const RunResults& run) {
  Checks checks;
  check_columns(run, checks);
  check_shears(run, checks);
  check_hinges(run, checks);
  check_storeys(run, checks);
  HandIn made = hand_in(story::judged_view_of(run), std::move(checks), &run);
  made.assumptions.insert(made.assumptions.begin(), story::model_statement(run));
  return made;
}

namespace {

/// Storeys of planes; of a building without planes its edges.
void check_planes(const PlanRun& run, Checks& checks) {
  for (Index b = 0; b < std::ssize(run.problem.buildings); ++b) {
    const PlanBuilding& building = run.problem.buildings[b];
    if (building.is_rigid()) continue;
    const double with = run.response.buildings[b].largest_drift().ratio;
    const double most = std::max(with, run.response.buildings_no_contact[b].largest_drift().ratio);
    check_drift(building.name, building.has_gravity_loads(), most, falls_in(run.response, b),
                run.problem.collapse_drift, checks);
  }
}

}  // namespace

HandIn hand_in(const PlanRun& run) {
  Checks checks;
  check_columns(*row_of(run), checks);
  const RunResults frames = frames_of(run);
  check_shears(frames, checks);
  check_hinges(frames, checks);
  check_planes(run, checks);
  const GapView facts = story::judged_view_of(run);
  check_gaps(facts, checks);
  const bool needs_seismicity = check_screenings(facts, checks);
  check_solution(run.response.discrepancies, checks);
  return {assumptions_of(run), checks.take(),
          unchecked_of(run.c, facts, needs_seismicity, &run.problem, !run.response.energy)};
}

namespace {

/// By a spectrum what yields or breaks, and drifts beyond what counts as collapse.
void check_spectral(const Problem& problem, const SpectralGaps& spectral, Checks& checks) {
  for (std::size_t b = 0; b < problem.buildings.size(); ++b) {
    const Building& building = problem.buildings[b];
    if (const double ratio = spectral.demands.at(b).ratio; ratio > 0) {
      checks.add("check.capacity", "check.by_spectrum", building.name, number(ratio), "1", !(ratio > 1));
    }
    check_drift(building.name, false, spectral.drifts.at(b).ratio, false, problem.collapse_drift, checks);
  }
}

}  // namespace

HandIn hand_in(const Case& c, const Problem& problem, const SpectralGaps& spectral) {
  Checks checks;
  check_spectral(problem, spectral, checks);
  HandIn made = hand_in(story::judged_view_of(c, problem, spectral), std::move(checks), nullptr);
  const bool is_given = std::any_of(problem.buildings.begin(), problem.buildings.end(),
                                    [](const Building& one) { return one.given.has_value(); });
  if (is_given) {
    made.assumptions.insert(made.assumptions.begin(),
                            {.kind = "assumption.displacements", .severity = Severity::remark});
  }
  if (!c.excitation.spectrum || !c.excitation.spectrum->of_displacements) {
    made.assumptions.insert(made.assumptions.begin(), {.kind = "assumption.spectrum", .severity = Severity::remark});
  }
  return made;
}

namespace {

void check_records(const std::vector<CheckRow>& of_records, Checks& checks) {
  const auto text = [](const std::optional<double>& value, const std::string& unit) {
    return value ? with_unit(*value, unit) : "–";
  };
  for (const CheckRow& row : of_records) {
    const std::string demand = text(row.demand, row.unit), limit = text(row.limit, row.unit);
    if (row.result.empty()) {
      checks.add(row.check, row.by, row.where, demand, limit, row.is_met);
    } else {
      checks.add(row.check, row.by, row.where, demand, limit, row.result, row.result != "gap.asks_less");
    }
  }
}

}  // namespace

HandIn hand_in(const Case& c, const PlanProblem& problem, const std::vector<CheckRow>& of_records) {
  Checks checks;
  check_records(of_records, checks);
  const Problem row = row_of(problem);
  GapView facts{.c = c, .problem = row, .levels = {}, .plan = &problem};
  facts.screened = story::screened(c, problem);
  return hand_in_with(facts, std::move(checks), nullptr);
}

HandIn hand_in(const Case& c, const Problem& problem, const std::vector<CheckRow>& of_records) {
  Checks checks;
  check_records(of_records, checks);
  HandIn made = hand_in_with(GapView{.c = c, .problem = problem, .levels = {}, .screened = story::screened(c, problem)},
                             std::move(checks), nullptr);
  const RunResults still{.c = c, .problem = problem, .response = {}, .remarks = {}};
  made.assumptions.insert(made.assumptions.begin(), story::model_statement(still));
  return made;
}

}  // namespace bentur
