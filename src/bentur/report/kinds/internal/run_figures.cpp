#include "bentur/report/kinds/internal/run_figures.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <set>

#include "bentur/core/number_text.h"
#include "bentur/model/gap/gap_outcome.h"
#include "bentur/model/judgement/judged_gaps.h"
#include "bentur/model/story/judgement_story.h"
#include "bentur/model/story/story.h"
#include "bentur/report/figures/internal/text.h"
#include "bentur/report/scene/tones.h"

namespace bentur {

const Impact* hardest_impact(const RunResults& run, Eigen::Index point) {
  return hardest_impact(run.response.impacts, point);
}

bool is_at(const FigureOptions& options, double elevation) {
  return !options.elevation || std::abs(elevation - *options.elevation) <= 1e-6 * std::max(1.0, std::abs(elevation));
}

Eigen::Index chosen_struck_point(const RunResults& run, const FigureOptions& options) {
  std::optional<Eigen::Index> best;
  for (Eigen::Index i = 0; i < std::ssize(run.problem.points); ++i) {
    const ContactPoint& point = run.problem.points[i];
    const std::optional<ColumnPeaks>& column = run.response.points[i].column;
    if (!column || !is_at(options, point.elevation) ||
        (options.gap && point.gap != static_cast<Eigen::Index>(*options.gap))) {
      continue;
    }
    if (!best || column->shear > run.response.points[*best].column->shear) best = i;
  }
  if (!best) throw NoFigure("no column is struck there: strikes_columns = true in a gap of the case lets floors do so");
  return *best;
}

Eigen::Index chosen_point(const RunResults& run, const FigureOptions& options) {
  const std::vector<ContactPoint>& points = run.problem.points;
  const std::vector<Building>& buildings = run.problem.buildings;
  std::vector<Eigen::Index> candidates;
  std::string known;
  for (Eigen::Index i = 0; i < std::ssize(points); ++i) {
    if (options.gap && points[i].left != static_cast<Eigen::Index>(*options.gap)) continue;
    known += (known.empty() ? "" : ", ") + number(points[i].elevation);
    if (is_at(options, points[i].elevation)) candidates.push_back(i);
  }
  if (points.empty()) throw NoFigure("no contact is modelled in this run");
  if (known.empty() && *options.gap + 1 < buildings.size()) {
    throw NoFigure(fmt::format("no contact is modelled in gap {}", *options.gap));
  }
  if (known.empty()) {
    throw NoFigure(
        fmt::format("there is no gap {}: gaps are counted from 0 to {}", *options.gap, buildings.size() - 2));
  }
  if (candidates.empty()) {
    throw NoFigure(fmt::format("no contact point at level {} {}: there are {}", number(*options.elevation),
                               run.c.units.length, known));
  }
  Eigen::Index best = candidates.front();
  const Impact* hard = nullptr;
  for (const Eigen::Index i : candidates) {
    const Impact* one = hardest_impact(run, i);
    if (one != nullptr && (hard == nullptr || is_harder(*one, *hard))) {
      hard = one;
      best = i;
    }
  }
  if (hard != nullptr) return best;
  double closest = INFINITY;
  for (const Eigen::Index i : candidates) {
    const double smallest = run.response.histories.opening.row(i).minCoeff();
    if (smallest < closest) {
      closest = smallest;
      best = i;
    }
  }
  return best;
}

const Histories& histories_with(const RunResults& run, std::vector<Eigen::MatrixXd> Histories::*list,
                                Eigen::Index building) {
  const std::vector<Eigen::MatrixXd>& exact = run.response.course.*list;
  const bool has = std::ssize(exact) > building && exact[building].size() > 0;
  return has ? run.response.course : run.response.histories;
}

std::vector<Eigen::Index> shown_buildings(const RunResults& run, const FigureOptions& options, std::size_t most) {
  std::vector<Eigen::Index> all(run.problem.buildings.size());
  std::iota(all.begin(), all.end(), Eigen::Index{0});
  const bool is_asked = options.gap || options.elevation;
  if (all.size() <= (is_asked ? most_together : most)) return all;
  const std::vector<ContactPoint>& points = run.problem.points;
  const Eigen::Index left =
      points.empty() ? static_cast<Eigen::Index>(options.gap.value_or(0)) : points[chosen_point(run, options)].left;
  std::set<Eigen::Index> shown = {left, left + 1};
  if (is_asked) return {shown.begin(), shown.end()};
  const std::size_t most_named = std::max<std::size_t>(8, most);
  const auto add = [&](std::set<Eigen::Index> more) {
    more.insert(shown.begin(), shown.end());
    const bool has_room = more.size() <= most_named;
    if (has_room) shown = std::move(more);
    return has_room;
  };
  for (const Shown how : {Shown::sentence, Shown::row}) {
    for (const Statement& one : run_story(run).statements) {
      if (one.shown != how || one.severity == Severity::remark) continue;
      std::set<Eigen::Index> named(one.buildings.begin(), one.buildings.end());
      if (one.gap) named.insert({*one.gap, *one.gap + 1});
      add(std::move(named));
    }
  }
  const std::vector<JudgedGap> judged = judged_gaps(run);
  for (const std::size_t gap : worst_first(judged)) {
    const std::optional<GoverningNeed> need = governing_need(judged[gap].facts);
    if (!need || !(need->given.is_short || need->reversed.is_short)) continue;
    const auto left_of = static_cast<Eigen::Index>(gap);
    if (!add({left_of, left_of + 1})) break;  // a milder one in its place would say that it is worse
  }
  return {shown.begin(), shown.end()};
}

std::vector<Tone> tones_of(const RunResults& run, const FigureOptions& options) {
  return options.tones.empty() ? tones_of(run.problem, run.response) : options.tones;
}

Tone tone_of(const RunResults& run, const FigureOptions& options, Eigen::Index building) {
  return tones_of(run, options).at(building);
}

std::string filled_word(const FigureWords& say, std::string_view english, const std::vector<std::string>& values) {
  std::string text = say ? say(english) : std::string(english);
  std::size_t at = 0;
  for (const std::string& value : values) {
    at = text.find("{}", at);
    if (at == std::string::npos) break;
    text.replace(at, 2, value);
    at += value.size();
  }
  return text;
}

std::string shown_unit(const RunResults& run, std::string_view form) {
  return unit_text(form, shown_units(run.c.units, run.response).units);
}

double shown_factor(const RunResults& run, std::string_view form) {
  return shown_units(run.c.units, run.response).factor(form);
}

std::vector<double> shown_values(const RunResults& run, std::vector<double> values, std::string_view form) {
  const double factor = shown_factor(run, form);
  for (double& value : values) value *= factor;
  return values;
}

std::string shown_value(const RunResults& run, double value, std::string_view form) {
  return number(value * shown_factor(run, form)) + " " + shown_unit(run, form);
}

std::string seconds_text(double time) { return number(time) + " s"; }

std::string point_text(const RunResults& run, Eigen::Index point, const FigureOptions& options) {
  const ContactPoint& place = run.problem.points[point];
  return gap_name(run.problem, place.left) + ", " +
         word(options, "level {}", number(place.elevation) + " " + run.c.units.length);
}

double base_of(const Building& building) {
  return building.model.elevations.front() - building.model.storey_heights.front();
}

std::optional<double> first_period(const Building& building) {
  const Eigen::VectorXd& omega = building.modes.omega;
  return omega.size() > 0 ? std::optional(2 * std::numbers::pi / omega(0)) : std::nullopt;
}

Mark mark_of(std::size_t index) {
  constexpr Mark marks[] = {Mark::disc, Mark::circle, Mark::square, Mark::triangle, Mark::diamond, Mark::cross};
  return marks[index % 6];
}

Curve bar(double from, double to, double place, double thick, Tone tone) {
  const double low = place - thick / 2, high = place + thick / 2;
  return {.x = {from, to}, .y = {low, low}, .top = {high, high}, .tone = tone};
}

Curve hollow_bar(double from, double to, double place, double thick, Tone tone) {
  const double low = place - thick / 2, high = place + thick / 2;
  return {.x = {from, to, to, from, from},
          .y = {low, low, high, high, low},
          .tone = tone,
          .complete = true,
          .is_bar = true};
}

Tone tone_of(Sufficiency value) {
  return value == Sufficiency::too_small ? Tone::red : value == Sufficiency::unknown ? Tone::amber : Tone::teal;
}

Tone area_tone_of(Sufficiency value) {
  return value == Sufficiency::too_small ? Tone::red : value == Sufficiency::unknown ? Tone::gold : Tone::pale_teal;
}

std::optional<std::size_t> worst_besides(const std::vector<JudgedGap>& judged, std::size_t gap) {
  if (judged.size() < 2) return std::nullopt;
  const std::size_t worst = worst_first(judged).front();
  return worst == gap ? std::nullopt : std::optional(worst);
}

FigureOptions options_of_worst(const JudgedGap& judged, std::size_t worst, FigureOptions options) {
  options.gap = worst;
  const std::optional<GoverningNeed> need = governing_need(judged.facts);
  const std::vector<LevelFacts>& levels = judged.facts.levels;
  const auto is_hit_there = [&](const LevelFacts& one) {
    return one.at.elevation == need->at.elevation && one.given.impacts > 0;
  };
  if (need && std::any_of(levels.begin(), levels.end(), is_hit_there)) options.elevation = need->at.elevation;
  return options;
}

std::string place_text(const std::vector<std::string>& gaps, std::size_t gap, std::size_t worst, bool is_hit,
                       const FigureOptions& options, bool with_worst) {
  const std::string &shown = gaps.at(gap), &other = gaps.at(worst);
  if (with_worst) {
    return is_hit ? word(options, "First {}, with the hardest impact, then the worst gap, {}", shown, other)
                  : word(options, "First {}, which come closest, then the worst gap, {}", shown, other);
  }
  return is_hit ? word(options, "Shown is {}, with the hardest impact; the worst gap is {}", shown, other)
                : word(options, "Shown is {}, which come closest; the worst gap is {}", shown, other);
}

void add_part(Figure& figure, const std::string& text) { figure.part += (figure.part.empty() ? "" : ". ") + text; }

void tell_bands(Figure& figure, const FigureOptions& options) {
  if (has_bands(figure)) add_part(figure, word(options, "Bands reach from the lowest to the highest value"));
}

namespace {

/// Whether a legend of both would have two names for one look.
bool do_clash(const Figure& one, const Figure& other) {
  for (const Panel& panel : one.panels) {
    for (const Curve& curve : panel.curves) {
      const auto is_alike = [&](const Curve& c) {
        return !c.label.empty() && !curve.label.empty() && c.label != curve.label && c.tone == curve.tone &&
               c.line == curve.line && c.mark == curve.mark;
      };
      for (const Panel& theirs : other.panels) {
        if (std::any_of(theirs.curves.begin(), theirs.curves.end(), is_alike)) return true;
      }
    }
  }
  return false;
}

}  // namespace

void append(Figure& figure, Figure&& below) {
  constexpr double lower = 0.75;
  const int columns = std::max(figure.columns, below.columns);
  const auto widen = [&](Figure& one) {
    for (Panel& panel : one.panels) {
      panel.height *= lower;
      if (one.columns < columns) panel.across = columns;
    }
  };
  widen(figure);
  widen(below);
  if (figure.shared_legend && do_clash(figure, below)) {  // each has its own, above its first panel
    figure.shared_legend = false;
    for (Figure* const one : {&figure, &below}) {
      for (std::size_t i = 1; i < one->panels.size(); ++i) {
        Panel& panel = one->panels[i];
        for (Curve& curve : panel.curves) curve.in_legend = false;
        for (RuleLine& rule : panel.rules) rule.label.clear();
        panel.events.label.clear();
      }
    }
  }
  figure.columns = columns;
  figure.width = std::max(figure.width, below.width);
  figure.finding += "; " + below.panels.front().title + ": " + below.finding;
  below.panels.front().begins_row = true;
  for (Panel& panel : below.panels) figure.panels.push_back(std::move(panel));
}

void leave_to_neighbour(Axis& axis) {
  axis.label = "";
  axis.numbers = false;
}

Line line_beside(Tone tone, Tone other) { return are_distinct_in_grey(tone, other) ? Line::solid : Line::dashed; }

void tell_apart(Curve& curve, std::size_t index, std::optional<Tone> tone) {
  constexpr Tone tones[] = {Tone::black, Tone::teal, Tone::grey};
  constexpr Line lines[] = {Line::solid,  Line::dashed,    Line::dash_dot,
                            Line::dotted, Line::long_dash, Line::dash_dot_dot};
  curve.tone = tone.value_or(tones[index % 3]);
  curve.line = lines[(index + index / 6) % 6];
  if (curve.line == Line::dotted) curve.width = 1.4;
  constexpr std::size_t most_marks = 25;
  curve.mark = curve.x.size() <= most_marks ? mark_of(index) : Mark::none;
}

}  // namespace bentur
