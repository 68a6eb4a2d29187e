#include <algorithm>
#include <cmath>
#include <numeric>

#include "bentur/model/plan/plan_frames.h"
#include "bentur/model/quantities.h"
#include "bentur/model/story/internal/story_parts.h"
#include "bentur/model/story/worst_hinges.h"

namespace bentur::story {
namespace {

using Eigen::Index;

constexpr std::size_t most_told = 10;  // hinges of a table

/// The end of a member as a word of a table.
std::string end_word(const HingePlace& place) { return "hinge." + std::string(word_of(place.end)); }

/// Fills {where}: "the top of the column of line 2 in storey 1".
void add_place(const HingePlace& place, std::vector<StoryValue>& values) {
  values.push_back(word_of("where", "hinge.at." + std::string(word_of(place.end))));
  values.push_back(count_of("level", static_cast<long>(place.level)));
  values.push_back(count_of("number", static_cast<long>(place.number)));
}

/// The first storeys that sway without bending, "1, 2".
std::string storeys_text(const Building& building, const std::vector<Index>& storeys) {
  std::string text;
  for (const Index storey : storeys) {
    text += (text.empty() ? "" : ", ") + std::to_string(building.model.storey_number(storey));
  }
  return text;
}

/// What lets a frame sway without bending: hinges, columns that have broken, or both.
std::string causes(const BuildingPeaks& peaks, double time) {
  const bool hinges = std::any_of(peaks.hinges.begin(), peaks.hinges.end(), [&](const BuildingPeaks::Hinge& hinge) {
    return hinge.first_yield && *hinge.first_yield <= time;
  });
  const bool columns = std::any_of(
      peaks.columns.begin(), peaks.columns.end(),
      [&](const BuildingPeaks::Breaking& column) { return column.break_time && *column.break_time <= time; });
  return columns && hinges ? "story.by_both" : columns ? "story.by_breaks" : "story.by_hinges";
}

void tell_mechanism(const Building& building, Index b, const BuildingPeaks& peaks, std::vector<Statement>& statements) {
  if (!peaks.mechanism) return;
  const std::vector<Index>& storeys = peaks.mechanism->storeys;
  if (storeys.empty()) return;  // a struck column between its ends alone
  const bool whole = std::ssize(storeys) == building.model.floors() - building.model.first_storey();
  Statement statement{.kind = whole                 ? "mechanism"
                              : storeys.size() == 1 ? "soft_storey"
                                                    : "soft_storeys",
                      .severity = Severity::warning,
                      .buildings = {b}};
  statement.values = {text_of("building", building.name), value_in("time", peaks.mechanism->time, "s"),
                      text_of("storeys", storeys_text(building, storeys)),
                      word_of("by", causes(peaks, peaks.mechanism->time))};
  statements.push_back(std::move(statement));
}

void tell_rotations(const Building& building, Index b, const BuildingPeaks& peaks, const std::vector<Index>& turned,
                    std::vector<Statement>& statements) {
  Statement statement{.kind = turned.empty() ? "hinges_none" : "hinges", .buildings = {b}};
  statement.values = {text_of("building", building.name), count_of("count", std::ssize(peaks.hinges)),
                      count_of("formed", std::ssize(turned))};
  if (!turned.empty()) {
    const Index worst = turned.front();
    add_place(building.model.hinges.places[worst], statement.values);
    statement.values.push_back(value_in("rotation", 1e3 * peaks.hinges[worst].peak_rotation, "mrad"));
  }
  statements.push_back(std::move(statement));
  // The level of ASCE 41 that the worst of those with limits passes.
  const Eigen::MatrixXd& limits = building.model.hinges.rotation_limits;
  constexpr const char* levels[] = {"IO", "LS", "CP"};
  for (Index level = 3; level-- > 0;) {
    Index passed = -1;
    long count = 0;
    double most = 1;
    for (const Index h : turned) {
      if (h >= limits.rows() || std::isnan(limits(h, level))) continue;
      const double demand = peaks.hinges[h].peak_rotation / limits(h, level);
      count += demand > 1 ? 1 : 0;
      if (!(demand > most)) continue;
      most = demand;
      passed = h;
    }
    if (passed < 0) continue;
    Statement beyond{.kind = "hinges_beyond", .severity = Severity::warning, .buildings = {b}};
    beyond.values = {text_of("building", building.name), text_of("limit", levels[level]), count_of("count", count),
                     value_in("demand", most)};
    add_place(building.model.hinges.places[passed], beyond.values);
    statements.push_back(std::move(beyond));
    return;
  }
}

/// What hinges have lost of their strength: how many, and the one that has least left.
void tell_weakened(const Building& building, Index b, const BuildingPeaks& peaks, std::vector<Statement>& statements) {
  Index worst = -1;
  long count = 0, failed = 0;
  double released = 0;
  for (Index h = 0; h < std::ssize(peaks.hinges); ++h) {
    const BuildingPeaks::Hinge& hinge = peaks.hinges[h];
    const double left = hinge.strength_left.value_or(1);
    count += left < 1 ? 1 : 0;
    failed += hinge.failed_time ? 1 : 0;
    released += hinge.released_energy.value_or(0);
    if (left < (worst < 0 ? 1 : *peaks.hinges[worst].strength_left)) worst = h;
  }
  if (worst < 0) return;
  const bool capped = peaks.hinges[worst].cap_time.has_value();
  std::string kind = failed > 0 ? "hinges_failed" : released > 0 ? "hinges_snapped" : "hinges_weaker";
  if (!capped) kind = failed > 0 ? "hinges_worn_out" : "hinges_worn";
  Statement statement{.kind = kind, .severity = Severity::warning, .buildings = {b}};
  statement.values = {text_of("building", building.name), count_of("count", count)};
  if (failed > 0) {
    statement.values.push_back(count_of("failed", failed));
  } else {
    statement.values.push_back(value_in("left", 100 * *peaks.hinges[worst].strength_left, "%"));
  }
  const std::optional<double> time = capped ? peaks.hinges[worst].cap_time : peaks.hinges[worst].failed_time;
  if (time) statement.values.push_back(value_in("time", *time, "s"));
  add_place(building.model.hinges.places[worst], statement.values);
  statements.push_back(std::move(statement));
}

/// Columns that have broken, in order of time.
std::vector<Index> by_time(const std::vector<BuildingPeaks::Breaking>& columns) {
  std::vector<Index> broken(columns.size());
  std::iota(broken.begin(), broken.end(), 0);
  std::erase_if(broken, [&](Index n) { return !columns[n].break_time; });
  std::stable_sort(broken.begin(), broken.end(),
                   [&](Index a, Index b) { return *columns[a].break_time < *columns[b].break_time; });
  return broken;
}

StoryTable breaking_table(const Building& building, const std::vector<BuildingPeaks::Breaking>& columns,
                          const std::vector<Index>& broken, const ShownUnits& shown, const std::string& length) {
  const std::string of_energy = unit_text("F L", shown.units);
  StoryColumn storey{.label = "column.of_storey", .are_counts = true};
  StoryColumn line{.label = "column.line", .are_counts = true}, piece{.label = "column.piece", .are_counts = true};
  StoryColumn time{"column.breaks", "s"}, capacity{"column.shear_capacity", unit_text("F", shown.units)};
  StoryColumn energy{"column.set_free", of_energy}, slip{"column.slip", length};
  for (const Index n : broken) {
    const BreakingColumn& place = building.model.hinges.columns[n];
    storey.texts.push_back(std::to_string(place.storey));
    line.texts.push_back(std::to_string(place.line));
    piece.texts.push_back(place.piece > 0 ? std::to_string(place.piece) : "–");
    time.numbers.push_back(*columns[n].break_time);
    capacity.numbers.push_back(shown.factor("F") * place.capacity);
    energy.numbers.push_back(shown.factor("F L") * columns[n].released_energy);
    slip.numbers.push_back(columns[n].residual_slip);
  }
  StoryTable table{.kind = "broken_columns", .values = {text_of("building", building.name)}};
  table.columns = {storey, line, piece, time, capacity, energy, slip};
  return table;
}

StoryTable hinge_table(const RunResults& run, const Building& building, const BuildingPeaks& peaks,
                       const std::vector<Index>& turned) {
  const ShownUnits shown = shown_units(run.c.units, run.response);
  const double moments = shown.factor("F L");
  const std::string of_moment = unit_text("F L", shown.units);
  StoryColumn member{.label = "column.member", .are_words = true}, end{.label = "column.end", .are_words = true};
  StoryColumn level{.label = "column.of_storey", .are_counts = true};
  StoryColumn number{.label = "column.of_line", .are_counts = true};
  StoryColumn rotation{"column.rotation", "mrad"}, residual{"column.at_the_end", "mrad"},
      moment{"column.moment", of_moment};
  StoryColumn energy{"column.energy", of_moment}, yield{"column.first_yield", "s"};
  StoryTable table{.kind = "hinges", .values = {text_of("building", building.name)}};
  for (std::size_t n = 0; n < std::min(turned.size(), most_told); ++n) {
    const Index h = turned[n];
    const HingePlace& place = building.model.hinges.places[h];
    const BuildingPeaks::Hinge& hinge = peaks.hinges[h];
    member.texts.emplace_back(place.of_beam ? "hinge.beam" : "hinge.column");
    level.texts.push_back(std::to_string(place.level));
    number.texts.push_back(std::to_string(place.number));
    end.texts.emplace_back(end_word(place));
    rotation.numbers.push_back(1e3 * hinge.peak_rotation);
    residual.numbers.push_back(1e3 * hinge.residual_rotation);
    moment.numbers.push_back(moments * hinge.peak_moment);
    energy.numbers.push_back(moments * hinge.dissipated_energy);
    yield.numbers.push_back(hinge.first_yield.value_or(0));
  }
  table.columns = {member, level, number, end, rotation, residual, moment, energy, yield};
  return table;
}

}  // namespace

void tell_breaking(const RunResults& run, Story& told) {
  const ShownUnits shown = shown_units(run.c.units, run.response);
  for (Index b = 0; b < std::ssize(run.problem.buildings); ++b) {
    const Building& building = run.problem.buildings[b];
    const std::vector<BreakingColumn>& places = building.model.hinges.columns;
    const std::vector<BuildingPeaks::Breaking>& columns = run.response.buildings[b].columns;
    if (places.empty() || columns.empty()) continue;
    const std::vector<Index> broken = by_time(columns);
    Statement statement{.kind = broken.empty() ? "columns_whole" : "columns_break",
                        .severity = broken.empty() ? Severity::finding : Severity::danger,
                        .buildings = {b}};
    statement.values = {text_of("building", building.name), count_of("count", std::ssize(places))};
    if (broken.empty()) {
      const auto most = std::max_element(columns.begin(), columns.end(), [](const auto& one, const auto& other) {
        return one.shear_demand_capacity < other.shear_demand_capacity;
      });
      statement.values.push_back(value_in("ratio", most->shear_demand_capacity));
    } else {
      const BreakingColumn& first = places[broken.front()];
      statement.values.push_back(count_of("broken", std::ssize(broken)));
      statement.values.push_back(count_of("storey", static_cast<long>(first.storey)));
      statement.values.push_back(count_of("line", static_cast<long>(first.line)));
      statement.values.push_back(value_in("time", *columns[broken.front()].break_time, "s"));
      told.tables.push_back(breaking_table(building, columns, broken, shown, run.c.units.length));
    }
    told.statements.push_back(std::move(statement));
  }
}

void tell_hinges(const RunResults& run, Story& told) {
  for (Index b = 0; b < std::ssize(run.problem.buildings); ++b) {
    const Building& building = run.problem.buildings[b];
    const BuildingPeaks& peaks = run.response.buildings[b];
    tell_mechanism(building, b, peaks, told.statements);
    if (building.model.hinges.places.empty() || peaks.hinges.empty()) continue;
    const std::vector<Index> turned = worst_hinges(peaks);
    tell_rotations(building, b, peaks, turned, told.statements);
    tell_weakened(building, b, peaks, told.statements);
    if (const auto joints = indeterminate_joints(building.model.hinges, peaks); !joints.empty()) {
      told.statements.push_back(
          {.kind = "hinges_indeterminate",
           .severity = Severity::remark,
           .buildings = {b},
           .values = {text_of("building", building.name), count_of("count", std::ssize(joints))}});
    }
    if (!turned.empty()) told.tables.push_back(hinge_table(run, building, peaks, turned));
  }
}

void tell_hinges(const PlanRun& run, Story& told) {
  const std::vector<PlanFramePlace> places = frames_that_yield(run.problem);
  if (places.empty()) return;
  const RunResults frames = frames_of(run);
  Story of_frames;
  tell_breaking(frames, of_frames);
  tell_infill(frames, of_frames.statements);
  tell_hinges(frames, of_frames);
  for (Statement& statement : of_frames.statements) {
    for (Index& frame : statement.buildings) frame = places[frame].building;
    told.statements.push_back(std::move(statement));
  }
  for (StoryTable& table : of_frames.tables) told.tables.push_back(std::move(table));
}

}  // namespace bentur::story
