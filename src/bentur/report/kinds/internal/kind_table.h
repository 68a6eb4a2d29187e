#pragma once

#include <algorithm>
#include <iterator>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "bentur/report/kinds/internal/run_figures.h"
#include "bentur/report/kinds/kinds.h"

// The tables of what can be drawn of a run, of a row or of buildings in plan.
namespace bentur {

template <class Run>
bool always(const Run&) {
  return true;
}

template <class Run>
struct KindOf {
  const char* name;
  const char* shows;
  bool (*is_there)(const Run&);
  Figure (*make)(const Run&, const FigureOptions&);
  bool (*tells)(const Run&) = always<Run>;
  bool over_time = false;
};

/// Those of a table that a run has.
template <class Run, class Table>
std::vector<FigureKind> kinds_of(const Table& table, const Run& run) {
  std::vector<FigureKind> kinds;
  for (const KindOf<Run>& kind : table) {
    if (kind.is_there(run)) kinds.push_back({kind.name, kind.shows, kind.tells(run), kind.over_time});
  }
  return kinds;
}

/// Whether a kind shows one place between two buildings.
inline bool is_of_a_place(const std::string& kind) {
  constexpr std::string_view all[] = {"overview", "scene", "displacement", "opening",
                                      "orbit",    "force", "impact",       "loop"};
  return std::find(std::begin(all), std::end(all), kind) != std::end(all);
}

template <class Table>
std::vector<std::string> names_of(const Table& table) {
  std::vector<std::string> names;
  for (const auto& kind : table) names.emplace_back(kind.name);
  return names;
}

/// Of a figure of one place says which that is where another gap is the worst, which some kinds show as well.
/// @param gap shown @param is_hit there
template <class Run>
void tell_place(const KindOf<Run>& kind, const Run& run, const std::vector<JudgedGap>& judged, std::size_t gap,
                bool is_hit, const FigureOptions& options, Figure& figure) {
  const std::optional<std::size_t> worst = worst_besides(judged, gap);
  if (!worst) return;
  const std::string_view name = kind.name;
  bool with_worst = name == "overview" && figure.panels.size() > overview_panels;  // which adds it by itself
  if (name == "displacement" || name == "opening") {
    with_worst = add_worst(figure, options_of_worst(judged[*worst], *worst, options),
                           [&](const FigureOptions& there) { return kind.make(run, there); });
  }
  add_part(figure, place_text(gap_names(run.problem), gap, *worst, is_hit, options, with_worst));
}

}  // namespace bentur
