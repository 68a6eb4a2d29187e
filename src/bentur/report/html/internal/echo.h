#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "bentur/core/key.h"
#include "bentur/io/toml/toml_value.h"
#include "bentur/report/html/internal/sections.h"

namespace bentur::html {

/// A record as it was read.
[[nodiscard]] Rows rows_of_record(const RecordEcho& record, const Words& say);

[[nodiscard]] inline std::string label_text(const Label& label, const Words& say) {
  return std::string(say.language() == "id" ? label.indonesian : label.english);
}

/// "3", "2", "1".
[[nodiscard]] std::vector<std::string> numbers_from_the_top(std::size_t count);

/// Unit of the numbers of a key in the units of the case; empty where they have none.
[[nodiscard]] std::string unit_of(const Key& key, const Units& units);

/// A table of the case as it was given.
struct Echoed {
  Html markup;
  HtmlTable row;  ///< a column to a key; lists in their order
};

/// A table of the case, those below it too: every key by its label, with its unit, and what is without it where that is
/// not nothing. In tables, values of storeys, floors and elevations stand from the top down.
/// @param with_lines of the case, on which each stands @param more rows after those of the keys
[[nodiscard]] Echoed echo(const KeyTable& keys, const TomlValue& given, const Words& say, const Units& units,
                          bool with_lines, const Rows& more = {});

/// What the report says of a table of the case beside its keys: what follows from them.
struct Derived {
  std::string heading;
  Rows rows = {};
  Html tables = {};
  std::vector<HtmlTable> printed = {};  ///< of many, what stands for the tables on paper
};

/// What the section of the input is written from, of a row or of buildings in plan, whose case is known.
struct InputOf {
  const Case& c;
  const Words& say;
  bool to_hand_in = false;
  double duration = 0;                                                  ///< [s]
  long events = 0;                                                      ///< of the run
  Rows motion = {};                                                     ///< as read and as applied
  std::vector<std::string> links = {};                                  ///< their names, of each [[link]]
  std::function<Derived(std::size_t, const TomlValue&)> building = {};  ///< by its place in the case and its table
  std::function<Derived(std::size_t)> gap = {};                         ///< likewise
};

/// Of a building in plan: where its planes are and how they yield, and its modes.
[[nodiscard]] Derived of_building_in_plan(const Case& c, const PlanProblem& problem, Eigen::Index building,
                                          const TomlValue& given, const Words& say);

}  // namespace bentur::html
