#pragma once

#include <algorithm>
#include <iterator>
#include <string>
#include <string_view>
#include <vector>

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

/// Kinds of a place that show the worst gap as well, where that is another one.
inline bool is_of_the_worst_too(const std::string& kind) { return kind == "displacement" || kind == "opening"; }

template <class Table>
std::vector<std::string> names_of(const Table& table) {
  std::vector<std::string> names;
  for (const auto& kind : table) names.emplace_back(kind.name);
  return names;
}

}  // namespace bentur
