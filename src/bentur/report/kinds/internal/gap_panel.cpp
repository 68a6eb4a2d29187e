#include "bentur/report/kinds/internal/gap_panel.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>
#include <utility>

#include "bentur/core/number_text.h"
#include "bentur/model/gap/gap_outcome.h"
#include "bentur/model/story/judgement_story.h"
#include "bentur/report/figures/internal/text.h"
#include "bentur/report/figures/internal/text_width.h"
#include "bentur/report/figures/internal/ticks.h"
#include "bentur/report/kinds/internal/run_figures.h"
#include "bentur/report/scene/names.h"
#include "bentur/report/words.h"

namespace bentur {
namespace {

/// A gap that is given or needed [length]; NaN: not known.
struct GapBar {
  const char* name;
  double value = 0;
  Tone tone = Tone::black;
  bool is_hollow = false;
};

/// Where it falls short the most: given, needed as recorded, and, where the ground moves, reversed, whichever of them
/// the run is of. What is needed has the colour of what is judged of the gap, which may be too small though it is
/// wider.
std::vector<GapBar> bars_of(const JudgedGap& gap, const Case& c) {
  GoverningNeed found = governing_need(gap.facts).value_or(GoverningNeed{});
  if (acts_reversed(c)) std::swap(found.given, found.reversed);
  const auto needed = [&](const char* name, const GoverningNeed::OneWay& one, bool is_hollow) {
    return GapBar{name, one.needed.value_or(NAN),
                  is_hollow ? tone_of(gap.judgement.value) : area_tone_of(gap.judgement.value), is_hollow};
  };
  if (!gap.facts.has_other_way) return {{"given", found.at.width}, needed("needed", found.given, false)};
  return {
      {"given", found.at.width}, needed("as recorded", found.given, false), needed("reversed", found.reversed, true)};
}

bool is_known(const GapBar& bar) { return !std::isnan(bar.value); }

/// From 0 on, `thick` in places of the axis of names; nothing of what is not known.
void add_bar(Panel& panel, const GapBar& of, double place, double thick) {
  if (std::isnan(of.value)) return;
  panel.curves.push_back(of.is_hollow ? hollow_bar(0, of.value, place, thick, of.tone)
                                      : bar(0, of.value, place, thick, of.tone));
}

std::string level_text(const GoverningNeed& need, const std::string& length) {
  return number(need.at.elevation) + " " + length;
}

std::string judged_text(const JudgedGap& gap, const FigureOptions& options) {
  return word(options, Words("en")(judgement_word(gap.judgement.value)));
}

/// Each bar by its name and value, the given gap uppermost.
void add_one_gap(Panel& panel, const JudgedGap& gap, const Case& c, const FigureOptions& options) {
  const std::string& length = c.units.length;
  const std::vector<GapBar> bars = bars_of(gap, c);
  std::vector<double> values;
  for (const GapBar& one : bars) values.push_back(one.value);
  const std::vector<std::string> numbers = column(values);  // with digits alike
  for (std::size_t k = 0; k < bars.size(); ++k) {
    const std::size_t at = bars.size() - 1 - k;
    const GapBar& one = bars[at];
    const std::string value = std::isnan(one.value) ? word(options, "not known") : numbers[at] + " " + length;
    panel.y.names.push_back(word(options, one.name) + ": " + value);
    add_bar(panel, one, static_cast<double>(k), 0.6);
    if (at == 1 && !std::isnan(one.value)) panel.curves.back().label = judged_text(gap, options);
  }
  const std::optional<GoverningNeed> found = governing_need(gap.facts);
  if (found && (found->given.needed || found->reversed.needed)) {
    panel.title = word(options, "needed at level {}", level_text(*found, length));
  }
  panel.height = 1.8;
}

/// What the buildings of the gaps are called, left and right: in short where that is a part of their names.
std::vector<std::pair<std::string, std::string>> names_of(const std::vector<JudgedGap>& judged) {
  std::vector<std::string> names;
  const auto add = [&](const std::string& name) {
    if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
  };
  for (const JudgedGap& one : judged) {
    add(one.facts.left);
    add(one.facts.right);
  }
  const std::vector<std::string> in_short = short_names(names);
  const bool are_parts = are_parts_of(in_short, names);
  const auto called = [&](const std::string& name) {
    constexpr double longest = 1.2;  // [cm]
    const auto at = static_cast<std::size_t>(std::find(names.begin(), names.end(), name) - names.begin());
    return are_parts ? in_short[at] : cut_to(name, longest);
  };
  std::vector<std::pair<std::string, std::string>> all;
  for (const JudgedGap& one : judged) all.emplace_back(called(one.facts.left), called(one.facts.right));
  return all;
}

/// Gaps by the names of their buildings and the level, bars in the legend, the first uppermost; of many those that the
/// verdict names first.
void add_gaps(Panel& panel, const std::vector<JudgedGap>& judged, const Case& c, const FigureOptions& options) {
  const std::string& length = c.units.length;
  constexpr std::size_t most = 5;
  std::vector<std::size_t> gaps = worst_first(judged);
  gaps.resize(std::min(judged.size(), most));
  // From below: of many the worst is uppermost, of a few they stand as the buildings do.
  judged.size() > most ? std::reverse(gaps.begin(), gaps.end()) : std::sort(gaps.begin(), gaps.end(), std::greater<>());
  const auto names = names_of(judged);
  for (std::size_t place = 0; place < gaps.size(); ++place) {
    const JudgedGap& gap = judged[gaps[place]];
    const std::vector<GapBar> bars = bars_of(gap, c);
    const std::optional<GoverningNeed> found = governing_need(gap.facts);
    const std::string between = names[gaps[place]].first + " | " + names[gaps[place]].second;
    const std::string level = found ? level_text(*found, length) : "";
    const std::string with_word = found ? between + ", " + word(options, "level {}", level) : between;
    panel.y.names.push_back(std::none_of(bars.begin() + 1, bars.end(), is_known)
                                ? between + ": " + word(options, "not known")
                            : text_width(with_word) > longest_name ? between + ", " + level
                                                                   : with_word);
    const std::string labels[] = {
        word(options, "given"),
        word(options, bars.size() > 2 ? "needed as recorded, gap {}" : "needed, gap {}", judged_text(gap, options)),
        word(options, "reversed")};
    for (std::size_t k = 0; k < bars.size(); ++k) {
      add_bar(panel, bars[k], static_cast<double>(place) + 0.27 * (1 - static_cast<double>(k)), 0.22);
      if (!std::isnan(bars[k].value)) panel.curves.back().label = labels[k];
    }
  }
  if (judged.size() > most) panel.title = word(options, "the most critical of {} gaps", std::to_string(judged.size()));
  panel.height = 0.3 + 0.6 * static_cast<double>(gaps.size());
}

}  // namespace

Panel gap_panel(const std::vector<JudgedGap>& judged, const Case& c, const FigureOptions& options) {
  Panel panel{.x = {.label = with_unit(word(options, "Gap w"), c.units.length), .from = 0}};
  judged.size() == 1 ? add_one_gap(panel, judged.front(), c, options) : add_gaps(panel, judged, c, options);
  return panel;
}

void name_rules_at_ends(Panel& panel) {
  constexpr double of_name = 0.5, half_name = 0.18;  // [cm]
  constexpr double margin = 0.04;                    // of what there is to see
  double low = std::numeric_limits<double>::infinity(), high = -low;
  const auto take = [&](double y) {
    low = std::fmin(low, y);
    high = std::fmax(high, y);
  };
  for (const Curve& curve : panel.curves) {
    for (std::size_t i = 0; i < curve.x.size(); ++i) {
      if (curve.x[i] >= *panel.x.from && curve.x[i] <= *panel.x.to) take(curve.y[i]);
    }
  }
  for (const RuleLine& rule : panel.rules) {
    if (!rule.vertical) take(rule.at);
  }
  if (panel.y.least) {
    take(panel.y.least->first);
    take(panel.y.least->second);
  }
  const double from = low - margin * (high - low);
  const double one_cm = (high - from) / (panel.height - of_name);
  panel.y.from = from;
  panel.y.to = high + of_name * one_cm;
  panel.names_at_ends = true;
  std::vector<Curve> lines;
  for (const RuleLine& rule : panel.rules) {
    if (rule.label.empty()) continue;
    Curve line{.label = rule.label, .tone = rule.tone, .line = rule.line, .complete = true};
    line.x = rule.vertical ? std::vector{rule.at, rule.at} : std::vector{*panel.x.from, *panel.x.to};
    line.y = rule.vertical ? std::vector{from, *panel.y.to - half_name * one_cm} : std::vector{rule.at, rule.at};
    lines.push_back(std::move(line));
  }
  panel.curves.insert(panel.curves.begin(), lines.begin(), lines.end());  // below the others
  std::erase_if(panel.rules, [](const RuleLine& rule) { return !rule.label.empty(); });
}

}  // namespace bentur
