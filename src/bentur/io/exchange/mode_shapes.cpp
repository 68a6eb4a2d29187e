#include "bentur/io/exchange/mode_shapes.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <string_view>

#include "bentur/core/number_text.h"
#include "bentur/core/text.h"
#include "bentur/core/units.h"
#include "bentur/io/number_table.h"
#include "bentur/io/records/internal/column_rows.h"
#include "bentur/io/toml/toml_view.h"

namespace bentur {
namespace {

using Shapes = std::vector<std::vector<double>>;
constexpr double same_level = 1e-6;     // of the highest: levels that are written alike
constexpr double rounded_level = 1e-3;  // of the highest: as tables of programs round them
constexpr double most_modes = 1e6;      // a step beyond is the number of none

/// In capitals, without blanks and signs: "Step Num" and "StepNum" are one.
std::string plain_word(std::string_view text) {
  std::string plain;
  for (const char c : text) {
    if (std::isalnum(static_cast<unsigned char>(c)) != 0) {
      plain += static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
    }
  }
  return plain;
}

/// The floor at an elevation of the table; nothing where there is none.
std::optional<std::size_t> floor_at(double elevation, const std::vector<double>& elevations, double tolerance) {
  const auto found = std::find_if(elevations.begin(), elevations.end(), [&](double one) {
    return std::abs(one - elevation) <= tolerance * elevations.back();
  });
  if (found == elevations.end()) return std::nullopt;
  return static_cast<std::size_t>(found - elevations.begin());
}

class ShapesReader {
 public:
  ShapesReader(const std::string& file, const ShapesAsked& asked, Diagnostics& diagnostics)
      : file_(file), asked_(asked), diagnostics_(diagnostics) {}

  std::optional<Shapes> read(const std::string& text) {
    if (const auto rows = long_rows(text)) return *rows ? shapes_of(**rows) : std::nullopt;
    std::vector<std::string> names;
    const auto table = number_table(text, file_, diagnostics_, &names);
    return table ? shapes_of(*table, names) : std::nullopt;
  }

 private:
  struct Row {
    std::string name;
    int mode = 0;
    std::vector<double> values = {};   ///< of each component that is asked for
    std::optional<double> level = {};  ///< Z [length]
    int line = 0;
  };

  /// A column of a program's table with what the shapes are made of.
  struct Component {
    std::string name;
    std::size_t column = 0;
    double unit = 1;  ///< of what it holds, in those of the case
  };

  /// Numbers of a floor.
  [[nodiscard]] std::size_t each() const { return asked_.in_plan ? 3 : 1; }

  [[nodiscard]] std::vector<std::string> components_of(const std::map<std::string, std::size_t>& columns) const {
    if (!asked_.in_plan) return {*asked_.component};
    if (columns.contains("UX") || columns.contains("UY")) return {"UX", "UY", "RZ"};
    return {"U1", "U2", "R3"};
  }

  std::nullopt_t complain(int line, const std::string& message) {
    diagnostics_.error({file_, line, line > 0 ? 1 : 0}, message);
    return std::nullopt;
  }

  [[nodiscard]] std::optional<std::size_t> floor_named(const std::string& name) const {
    const auto found = std::find(asked_.names.begin(), asked_.names.end(), name);
    if (found == asked_.names.end()) return std::nullopt;
    return static_cast<std::size_t>(found - asked_.names.begin());
  }

  /// Of a row a floor its floor, in any order that is said; an error where it is of none or stands there twice.
  std::optional<std::vector<std::size_t>> floors_of(const NumberTable& table, const std::vector<std::string>& names,
                                                    bool elevations_first) {
    const std::size_t floors = asked_.elevations.size();
    std::vector<std::size_t> floor_of(floors);
    for (std::size_t i = 0; i < floors; ++i) floor_of[i] = i;
    if (!elevations_first && names.empty()) return floor_of;
    if (!elevations_first && asked_.names.empty()) return floors_by_numbers(names, table.lines.front());
    std::vector<bool> seen(floors, false);
    for (std::size_t i = 0; i < floors; ++i) {
      const auto floor =
          elevations_first ? floor_at(table.rows[i][0], asked_.elevations, same_level) : floor_named(names[i]);
      const std::string what = elevations_first ? fmt::format("elevation {}", table.rows[i][0])
                                                : fmt::format("floor {}", in_quotes(names[i]));
      if (!floor) return complain(table.lines[i], what + " is of no floor of the case");
      if (seen[*floor]) return complain(table.lines[i], what + " stands here twice");
      seen[*floor] = true;
      floor_of[i] = *floor;
    }
    return floor_of;
  }

  /// Names that end in numbers, as Story1 does, say which floor is the lower one.
  std::optional<std::vector<std::size_t>> floors_by_numbers(const std::vector<std::string>& names, int line) {
    std::vector<double> numbers;
    for (const std::string& name : names) {
      const std::size_t last = name.find_last_not_of("0123456789");
      const std::size_t digits = last == std::string::npos ? 0 : last + 1;
      if (digits < name.size()) numbers.push_back(std::stod(name.substr(digits)));
    }
    const std::size_t count = names.size();
    const bool all = numbers.size() == count;
    const bool up = all && std::adjacent_find(numbers.begin(), numbers.end(), std::greater_equal<>()) == numbers.end();
    const bool down = all && std::adjacent_find(numbers.begin(), numbers.end(), std::less_equal<>()) == numbers.end();
    if (!up && !down) {
      return complain(line, fmt::format("names of floors ({}) do not say which is the lower one: give floor_names, "
                                        "lowest first, or elevations before the modes",
                                        fmt::join(names, ", ")));
    }
    std::vector<std::size_t> floors(count);
    for (std::size_t i = 0; i < count; ++i) floors[i] = up ? i : count - 1 - i;
    return floors;
  }

  std::optional<Shapes> shapes_of(const NumberTable& table, const std::vector<std::string>& names) {
    const std::size_t floors = asked_.elevations.size(), modes = asked_.modes;
    if (asked_.component || !asked_.numbers.empty()) {
      return complain(0, "is no table of a row a storey and mode, of which shapes_column and shapes_modes are");
    }
    const std::size_t columns = each() * modes;
    if (table.columns() != columns && table.columns() != columns + 1) {
      return complain(table.lines.front(),
                      fmt::format("has {}, expected {} ({} per period of the case), or {} with the "
                                  "elevations first",
                                  counted(table.columns(), "column"), columns,
                                  asked_.in_plan ? "three, UX, UY and RZ," : "one", columns + 1));
    }
    if (table.rows.size() != floors) {
      return complain(0, fmt::format("has {} of numbers, expected {} (one per floor of the case)",
                                     counted(table.rows.size(), "row"), floors));
    }
    const bool elevations_first = table.columns() == columns + 1;
    const auto floor_of = floors_of(table, names, elevations_first);
    if (!floor_of) return std::nullopt;
    Shapes shapes(modes, std::vector<double>(each() * floors));
    for (std::size_t i = 0; i < floors; ++i) {
      for (std::size_t k = 0; k < columns; ++k) {
        shapes[k / each()][each() * (*floor_of)[i] + k % each()] = table.rows[i][k + (elevations_first ? 1 : 0)];
      }
    }
    return shapes;
  }

  /// The rows of a program's table; nothing where it is none; an empty option inside where it is wrong.
  std::optional<std::optional<std::vector<Row>>> long_rows(const std::string& text) {
    std::string plain = records::decoded(text);
    std::replace(plain.begin(), plain.end(), '\t', ';');
    records::ColumnRows shape;
    shape.separator = plain.find(';') != std::string::npos ? ';' : ',';
    shape.decimal_comma = shape.separator == ';';
    const std::vector<records::Line> lines = records::lines_of(plain);
    for (std::size_t i = 0; i < lines.size(); ++i) {
      std::map<std::string, std::size_t> columns;
      const std::vector<records::Token> cells = records::split_cells(lines[i], shape.separator);
      for (std::size_t k = 0; k < cells.size(); ++k) columns.emplace(plain_word(unquoted(cells[k].text)), k);
      const auto one_of = [&](std::initializer_list<const char*> names) -> std::optional<std::size_t> {
        for (const char* const name : names) {
          if (const auto found = columns.find(name); found != columns.end()) return found->second;
        }
        return std::nullopt;
      };
      const auto name = one_of({"STORY", "JOINT"}), step = one_of({"STEPNUMBER", "STEPNUM", "MODE"});
      if (!name || !step || (!one_of({"UX", "U1"}) && !one_of({"UY", "U2"}))) continue;
      return rows_below(lines, i, shape, columns, *name, *step, one_of({"STEPTYPE"}), one_of({"Z"}));
    }
    return std::nullopt;
  }

  static std::string_view unquoted(std::string_view text) {
    text = trimmed(text);
    if (text.size() > 1 && text.front() == '"' && text.back() == '"') text = text.substr(1, text.size() - 2);
    return text;
  }

  std::optional<std::vector<Row>> rows_below(const std::vector<records::Line>& lines, std::size_t heading,
                                             const records::ColumnRows& shape,
                                             const std::map<std::string, std::size_t>& columns, std::size_t name,
                                             std::size_t step, std::optional<std::size_t> type,
                                             std::optional<std::size_t> level) {
    const int heading_line = lines[heading].number;
    if (!asked_.component && !asked_.in_plan) {
      return complain(heading_line,
                      "has displacements both ways: say with shapes_column which, \"UX\" or \"UY\" (of "
                      "SAP2000 \"U1\" or \"U2\")");
    }
    std::vector<Component> components;
    for (const std::string& one : components_of(columns)) {
      const auto found = columns.find(one);
      if (found == columns.end()) return complain(heading_line, fmt::format("has no column {}", one));
      components.push_back({one, found->second});
    }
    std::vector<Row> rows;
    double unit = 1;  // of Z [length]
    for (std::size_t i = heading + 1; i < lines.size(); ++i) {
      const std::vector<records::Token> cells = records::split_cells(lines[i], shape.separator);
      const auto cell = [&](std::size_t at) {
        return at < cells.size() ? unquoted(cells[at].text) : std::string_view();
      };
      const auto number = [&](std::size_t at) { return records::number_of(cell(at), shape.decimal_comma); };
      const auto mode = number(step);
      if (!mode) {
        if (rows.empty() && level) unit = unit_of(std::string(cell(*level)));
        if (!rows.empty() || !asked_.in_plan) continue;
        for (Component& one : components) one.unit = unit_of(std::string(cell(one.column)));
        continue;  // the line of units, a blank one, or of a case without steps
      }
      if (type && plain_word(cell(*type)) != "MODE") continue;
      if (!(*mode >= 0 && *mode <= most_modes && *mode == std::floor(*mode))) {
        return complain(lines[i].number, fmt::format("has the step {}, must be the number of a mode",
                                                     in_quotes(std::string(cell(step)))));
      }
      Row row{std::string(cell(name)), static_cast<int>(*mode), {}, {}, lines[i].number};
      for (const Component& one : components) {
        const auto value = number(one.column);
        if (!value || !std::isfinite(*value)) {
          return complain(lines[i].number,
                          fmt::format("{} = {}, must be a number", one.name, in_quotes(std::string(cell(one.column)))));
        }
        row.values.push_back(one.unit * *value);
      }
      if (level && number(*level)) row.level = *number(*level) * unit;
      rows.push_back(std::move(row));
    }
    if (rows.empty()) return complain(heading_line, "has no rows of modes below");
    return rows;
  }

  /// A unit of length of the table in those of the case; as the case's where it is none.
  [[nodiscard]] double unit_of(std::string text) const {
    std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return std::tolower(c); });
    const std::vector<std::string>& known = length_units();
    return std::find(known.begin(), known.end(), text) == known.end() ? 1 : metres(text) * asked_.metre;
  }

  /// The modes that are wanted, by their numbers in the table.
  std::optional<std::vector<int>> modes_of(const std::vector<Row>& rows) {
    std::vector<int> all;
    for (const Row& row : rows) all.push_back(row.mode);
    std::sort(all.begin(), all.end());
    all.erase(std::unique(all.begin(), all.end()), all.end());
    if (asked_.numbers.empty() && all.size() != asked_.modes) {
      return complain(rows.front().line,
                      fmt::format("has {}, the case {}: say with shapes_modes which of them, one per period",
                                  counted(all.size(), "mode"), counted(asked_.modes, "period")));
    }
    const std::vector<int>& wanted = asked_.numbers.empty() ? all : asked_.numbers;
    for (const int mode : wanted) {
      if (std::find(all.begin(), all.end(), mode) == all.end())
        return complain(rows.front().line, fmt::format("has no mode {}", mode));
    }
    return wanted;
  }

  /// What Z of the table is less than elevations of the case: 0, or so much that the highest are one.
  [[nodiscard]] double base_of_table(const std::vector<Row>& rows) const {
    double highest = 0;
    bool fits = true;
    for (const Row& row : rows) {
      highest = std::max(highest, row.level.value_or(highest));
      fits = fits && row.level && floor_at(*row.level, asked_.elevations, rounded_level);
    }
    return fits ? 0 : highest - asked_.elevations.back();
  }

  std::optional<Shapes> shapes_of(const std::vector<Row>& rows) {
    const auto wanted = modes_of(rows);
    if (!wanted) return std::nullopt;
    const std::size_t floors = asked_.elevations.size();
    const double base = asked_.names.empty() ? base_of_table(rows) : 0;
    Shapes shapes(asked_.modes, std::vector<double>(each() * floors));
    std::vector<std::vector<bool>> seen(asked_.modes, std::vector<bool>(floors, false));
    for (const Row& row : rows) {
      const auto place = std::find(wanted->begin(), wanted->end(), row.mode);
      if (place == wanted->end()) continue;
      const auto mode = static_cast<std::size_t>(place - wanted->begin());
      if (asked_.names.empty() && !row.level) {
        return complain(row.line, "has no elevation (Z): give floor_names, lowest first");
      }
      const auto floor =
          asked_.names.empty() ? floor_at(*row.level - base, asked_.elevations, rounded_level) : floor_named(row.name);
      if (!floor) {
        if (!asked_.names.empty()) continue;  // joints that are not named are not asked for
        return complain(row.line, fmt::format("{} at {} above the base is of no floor of the case", in_quotes(row.name),
                                              *row.level - base));
      }
      if (seen[mode][*floor]) {
        return complain(row.line, fmt::format("{} has mode {} twice, of two diaphragms or cases: leave one",
                                              in_quotes(row.name), row.mode));
      }
      seen[mode][*floor] = true;
      std::copy(row.values.begin(), row.values.end(), shapes[mode].begin() + static_cast<long>(each() * *floor));
    }
    for (std::size_t mode = 0; mode < asked_.modes; ++mode) {
      for (std::size_t floor = 0; floor < floors; ++floor) {
        if (seen[mode][floor]) continue;
        return complain(0, fmt::format("has no row of mode {} at the floor at {} of the case", (*wanted)[mode],
                                       asked_.elevations[floor]));
      }
    }
    return shapes;
  }

  const std::string& file_;
  const ShapesAsked& asked_;
  Diagnostics& diagnostics_;
};

}  // namespace

std::optional<Shapes> mode_shapes(const std::string& text, const std::string& file, const ShapesAsked& asked,
                                  Diagnostics& diagnostics) {
  return ShapesReader(file, asked, diagnostics).read(text);
}

}  // namespace bentur
