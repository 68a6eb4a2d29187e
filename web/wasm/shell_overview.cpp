#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "bentur/core/not_known.h"
#include "bentur/core/version.h"
#include "bentur/model/judgement/judged_gaps.h"
#include "bentur/model/plan/plan_places.h"
#include "bentur/model/plan/plan_row.h"
#include "bentur/model/story/story.h"
#include "bentur/report/html/page_parts.h"
#include "bentur/report/html/spectral_report.h"
#include "bentur/report/html/suite_report.h"
#include "bentur/report/kinds/kinds.h"
#include "bentur/report/scene/plan_scene.h"
#include "bentur/report/story_text.h"
#include "shell.h"
#include "shell_answers.h"

namespace bentur::web {

double largest_amplification(const Response& response) {
  double largest = 0;
  for (const BuildingPeaks& peaks : response.buildings) {
    for (Eigen::Index floor = 0; floor < peaks.displacement.size(); ++floor) {
      const double alone = peaks.displacement_no_contact(floor);
      if (alone > 0) largest = std::max(largest, peaks.displacement(floor) / alone);
    }
  }
  return largest;
}

double largest_force(const Response& response) {
  double largest = 0;
  for (const PointSummary& point : response.points) largest = std::max(largest, point.peak_force);
  return largest;
}

Json number_or_null(double value) { return std::isfinite(value) ? Json(value) : Json(); }

namespace {

Json list(const Eigen::VectorXd& values) {
  Json all = Json::array();
  for (const double value : values) all.push_back(number_or_null(value));
  return all;
}

/// Of a gap what a slider shows: the width needed, the larger of both directions of the motion, with its name, and as
/// marks, ascending, what the other direction needs and what rules ask at most.
Json gap_overview(const std::string& name, double width, const GapFacts& facts, const Words& say) {
  const GoverningNeed need = governing_need(facts).value_or(GoverningNeed{});
  const auto of_gap = [&](const std::optional<double>& here) { return here ? need.at.of_gap(*here) : not_known; };
  const double given = of_gap(need.given.needed), reversed = of_gap(need.reversed.needed);
  const bool is_reversed = reversed > given || std::isnan(given);
  std::vector<std::pair<double, std::string>> marks;
  if (!std::isnan(given) && !std::isnan(reversed)) {
    marks.emplace_back(std::min(given, reversed), say(is_reversed ? "records.as_recorded" : "records.reversed"));
  }
  for (const RuleFinding& one : facts.rules) {
    if (one.at && std::isfinite(one.most)) marks.emplace_back(one.most, one.title);
  }
  std::sort(marks.begin(), marks.end());
  Json all = Json::array();
  for (const auto& [at, name] : marks) all.push_back({{"at", at}, {"name", name}});
  return {{"name", name},
          {"width", width},
          {"needed", number_or_null(is_reversed ? reversed : given)},
          {"needed_name", say(is_reversed ? "slider.needed_reversed" : "slider.needed")},
          {"marks", std::move(all)}};
}

/// Of a row, whose gap may be of another width at each level: the width where it falls short the most.
Json gap_overview(const Problem& problem, const Gap& gap, const std::vector<JudgedGap>& judged, const Words& say) {
  const GapFacts& facts = judged.at(static_cast<std::size_t>(gap.number)).facts;
  return gap_overview(gap_name(problem, gap.number), governing_need(facts).value_or(GoverningNeed{}).at.width, facts,
                      say);
}

/// What moves where a gap in plan becomes wider by one: each building with the corner of its footprint, along `by`;
/// `until` they meet one that stays, after so long a `way`.
Json movers_of(const PlanProblem& problem, std::size_t gap) {
  Json movers = Json::array(), until;
  const std::vector<Eigen::Index> beyond = buildings_beyond(problem, gap);
  if (const auto met = first_in_the_way(problem, gap, beyond)) {
    until = {{"building", met->building}, {"way", met->way}};
  }
  for (const Eigen::Index b : beyond) {
    const PlanPoint& corner = problem.buildings[b].model.footprint.corner;
    movers.push_back({{"building", b}, {"corner", {corner.x(), corner.y()}}});
  }
  const PlanPoint& n = problem.gaps[gap].stretch.n;
  return {{"all", movers}, {"by", {n.x(), n.y()}}, {"until", until}};
}

/// What is to be said, in words, the gravest first. @param gaps by name
Json statements_of(const std::vector<std::string>& gaps, const Story& story, const Words& say) {
  Json all = Json::array();
  for (const SaidStatement& one : said(story.statements, say)) {
    all.push_back({{"kind", one.kind},
                   {"severity", severity_name(one.severity)},
                   {"gap", one.gap ? Json(gaps.at(*one.gap)) : Json()},
                   {"rank", one.rank ? Json(*one.rank) : Json()},
                   {"badge", one.badge},
                   {"open", one.is_open},
                   {"lead", one.text.substr(0, one.lead)},
                   {"shown", shown_name(one.shown)},
                   {"text", one.text}});
  }
  return all;
}

Json buildings_of(const RunResults& run) {
  Json buildings = Json::array();
  for (std::size_t b = 0; b < run.problem.buildings.size(); ++b) {
    const Building& building = run.problem.buildings[b];
    const BuildingPeaks& peaks = run.response.buildings[b];
    buildings.push_back({{"name", building.name},
                         {"rigid", building.is_rigid()},
                         {"elevations", building.model.elevations},
                         {"heights", building.model.storey_heights},
                         {"yields", peaks.yielding.ductility.size() > 0},
                         {"displacement", list(peaks.displacement)},
                         {"alone", list(peaks.displacement_no_contact)},
                         {"drift", list(peaks.drift_ratio)}});
  }
  return buildings;
}

/// What is listed of an impact, by its number among all from 0.
Json impact_of(const Impact& one, Eigen::Index number, Eigen::Index gap, double elevation, double force) {
  const std::optional<double> e = one.restitution();
  return {gap,
          elevation,
          one.start,
          one.end,
          force * one.peak_force,
          one.closing_speed,
          e ? number_or_null(*e) : Json(),
          number + 1};
}

Json impacts_of(const RunResults& run, const ShownUnits& shown) {
  Json impacts = Json::array();
  for (const Eigen::Index k : listed_impacts(run.response.impacts)) {
    const Impact& one = run.response.impacts[k];
    const ContactPoint& point = run.problem.points[one.point];
    impacts.push_back(impact_of(one, k, point.left, point.elevation, shown.force));
  }
  return impacts;
}

/// The list of impacts as a report has it.
Json columns_of(const std::vector<TableColumn>& columns) {
  Json all = Json::array();
  for (const TableColumn& one : columns) {
    all.push_back({{"head", one.label}, {"unit", one.unit}, {"cells", one.cells}, {"numbers", !one.is_words}});
  }
  return all;
}

/// Every figure that the run can give, with its caption; those that do not tell something of it are given away alone.
template <class Run>
Json kinds_of(const Run& run, const Words& say) {
  Json all = Json::array();
  if (run.response.histories.time.empty()) return all;
  constexpr bool in_plan = std::is_same_v<Run, PlanRun>;
  for (const FigureKind& kind : figure_kinds(run)) {
    all.push_back({{"kind", kind.name},
                   {"caption", say(caption_key(kind.name, in_plan))},
                   {"tells", kind.tells},
                   {"overTime", kind.over_time}});
  }
  return all;
}

/// The tables of a first screen: of the gaps, and what else is known.
Json facts_of(const std::vector<std::string>& gaps, const Story& story, const Words& say) {
  std::vector<SaidTable> tables;
  for (const StoryTable& one : story.tables) {
    if (one.kind.starts_with("row")) tables.push_back(said(one, say));
  }
  if (auto known = known_table(gaps, said(story.statements, say), say)) tables.push_back(std::move(*known));
  Json all = Json::array();
  for (const SaidTable& table : tables) {
    Json columns = Json::array();
    for (std::size_t i = 0; i < table.columns.size(); ++i) {
      const TableColumn& one = table.columns[i];
      columns.push_back(
          {{"head", one.label}, {"unit", one.unit}, {"cells", one.cells}, {"numbers", bool{table.are_numbers[i]}}});
    }
    all.push_back({{"heading", table.heading}, {"columns", columns}, {"marked", table.marked}, {"note", table.note}});
  }
  return all;
}

}  // namespace

Json overview_of(const std::string& title, const Units& units, double duration, const Json& told,
                 const std::vector<std::string>& gaps, const Story& story, const Words& say) {
  return {{"ok", true},
          {"title", title},
          {"version", version()},
          {"duration", duration},
          {"units", {{"length", units.length}, {"force", units.force}}},
          {"gaps", told},
          {"tone", verdict_tone(said(story.statements, say))},
          {"statements", statements_of(gaps, story, say)},
          {"facts", facts_of(gaps, story, say)}};
}

namespace {

std::vector<std::string> names_of(const Problem& problem) {
  std::vector<std::string> names;
  for (const Gap& gap : gaps_of(problem)) names.push_back(gap_name(problem, gap.number));
  return names;
}

/// The largest displacement along x or y over that without contact.
double largest_amplification(const PlanRun& run) {
  double largest = 0;
  for (const char* const key : {"amplification_x", "amplification_y"}) {
    const Quantity& quantity = quantity_named(key, Owner::floor, true);
    for (Eigen::Index b = 0; b < std::ssize(run.problem.buildings); ++b) {
      for (const double value : values_at(quantity, run, floors_of(run.problem, b))) {
        if (value > largest) largest = value;  // NaN: none
      }
    }
  }
  return largest;
}

Json plan_overview(const PlanRun& run, const Words& say) {
  const PlanProblem& problem = run.problem;
  const std::vector<std::string> names = gap_names(problem);
  Json gaps = Json::array(), buildings = Json::array(), points = Json::array(), impacts = Json::array();
  const std::vector<JudgedGap> judged = judged_gaps(run);
  for (std::size_t g = 0; g < names.size(); ++g) {
    gaps.push_back(gap_overview(names[g], problem.gaps[g].stretch.width, judged.at(g).facts, say));
    gaps.back()["movers"] = movers_of(problem, g);
  }
  for (const PlanBuilding& building : problem.buildings) {
    buildings.push_back(
        {{"name", building.name}, {"rigid", building.is_rigid()}, {"elevations", building.model.elevations}});
  }
  for (Eigen::Index i = 0; i < std::ssize(run.response.points); ++i) {
    const PlanContactPlace place = contact_at(problem, i);
    points.push_back({{"gap", place.gap}, {"elevation", place.contact->elevation}, {"along", along_text(run, i)}});
  }
  const ShownUnits shown = shown_units(run);
  double force = 0;
  for (const PointSummary& point : run.response.points) force = std::max(force, point.peak_force);
  for (const Eigen::Index k : listed_impacts(run.response.impacts)) {
    const Impact& one = run.response.impacts[k];
    const PlanContactPlace place = contact_at(problem, one.point);
    impacts.push_back(impact_of(one, k, static_cast<Eigen::Index>(place.gap), place.contact->elevation, shown.force));
    impacts.back().push_back(along_text(run, one.point));
  }
  Json all = overview_of(run.c.title, run.c.units, problem.duration, gaps, names, run_story(run), say);
  all["spectral"] = false;
  all["plan"] = true;
  all["buildings"] = buildings;
  all["points"] = points;
  all["impacts"] = impacts;
  all["impactColumns"] = columns_of(impact_columns(run, say.language()));
  all["impactCount"] = run.response.impacts.size();
  all["force"] = shown.force * force;
  all["forceUnit"] = shown.units.force;
  all["amplification"] = largest_amplification(run);
  all["figures"] = kinds_of(run, say);
  return all;
}

}  // namespace

std::string Studio::overview(const std::string& language) const {
  return guarded([&]() -> Json {
    const Words say(language);
    if (plan_run_) {
      Json all = plan_overview(*plan_run_, say);
      if (suite_) all["suite"] = suite_choice(*suite_, record_);
      return all;
    }
    if (suite_run_) return suite_overview(say);
    Json gaps = Json::array();
    if (spectral_) {
      const std::vector<JudgedGap> judged = judged_gaps(*case_, *problem_, *spectral_);
      for (const Gap& gap : gaps_of(*problem_)) {
        gaps.push_back(gap_overview(*problem_, gap, judged, say));
      }
      Json all = overview_of(case_->title, case_->units, problem_->duration, gaps, names_of(*problem_),
                             spectral_story(*case_, *problem_, *spectral_), say);
      all["spectral"] = true;
      return all;
    }
    if (!run_) return failure("nothing was run");
    const RunResults& run = *run_;
    const std::vector<JudgedGap> judged = judged_gaps(run);
    for (const Gap& gap : gaps_of(run.problem)) {
      gaps.push_back(gap_overview(run.problem, gap, judged, say));
    }
    Json points = Json::array();
    for (const ContactPoint& point : run.problem.points) {
      points.push_back({{"gap", point.gap}, {"elevation", point.elevation}});
    }
    Json all =
        overview_of(run.c.title, run.c.units, run.problem.duration, gaps, names_of(run.problem), run_story(run), say);
    const ShownUnits shown = shown_units(run.c.units, run.response);
    all["spectral"] = false;
    all["buildings"] = buildings_of(run);
    all["points"] = points;
    all["impacts"] = impacts_of(run, shown);
    all["impactColumns"] = columns_of(impact_columns(run, language));
    all["impactCount"] = run.response.impacts.size();
    all["force"] = shown.force * largest_force(run.response);
    all["forceUnit"] = shown.units.force;
    all["amplification"] = largest_amplification(run.response);
    all["figures"] = kinds_of(run, say);
    if (suite_) all["suite"] = suite_choice(*suite_, record_);
    return all;
  });
}

std::string Studio::tables(const std::string& language) const {
  return guarded([&]() -> Json {
    std::vector<PagePart> parts;
    if (plan_run_)
      parts = table_parts(*plan_run_, language);
    else if (spectral_)
      parts = table_parts(*case_, *problem_, *spectral_, language);
    else if (suite_run_)
      parts = table_parts(*suite_run_, *suite_gaps_, language);
    else if (run_)
      parts = table_parts(*run_, language);
    Json all = Json::array();
    for (const PagePart& one : parts) all.push_back({{"id", one.id}, {"heading", one.heading}, {"markup", one.markup}});
    return {{"ok", true}, {"errors", Json::array()}, {"tables", all}};
  });
}

}  // namespace bentur::web
