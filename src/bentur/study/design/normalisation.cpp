#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <sstream>

#include "bentur/core/number_text.h"
#include "bentur/excitation/motion_measures.h"
#include "bentur/io/case/case_parts.h"
#include "bentur/io/input_file.h"
#include "bentur/io/schema/case_keys.h"
#include "bentur/study/design/internal/study_parts.h"
#include "bentur/study/design/study_keys.h"
#include "bentur/study/quantiles.h"

namespace bentur {
namespace {

namespace fs = std::filesystem;

/// The cells of a line of CSV.
std::vector<std::string> csv_cells(const std::string& line) {
  std::vector<std::string> cells(1);
  bool quoted = false;
  for (const char c : line) {
    if (c == '"') {
      quoted = !quoted;
    } else if (c == ',' && !quoted) {
      cells.emplace_back();
    } else if (c != '\r') {
      cells.back() += c;
    }
  }
  return cells;
}

/// Factors by file name, or nothing and why in `problem`.
std::optional<std::map<std::string, double>> factor_table(const fs::path& file, std::string& problem) {
  const auto text = read_input(file, {"table of factors", std::uintmax_t{16} << 20}, problem);
  if (!text) return std::nullopt;
  std::map<std::string, double> factors;
  std::size_t name = 0, factor = 1;
  std::istringstream lines(*text);
  std::string line;
  for (int number = 1; std::getline(lines, line); ++number) {
    const std::vector<std::string> cells = csv_cells(line);
    const auto title = [&](const char* key) { return std::find(cells.begin(), cells.end(), key) - cells.begin(); };
    const auto count = static_cast<std::ptrdiff_t>(cells.size());
    if (number == 1 && title("file") < count) {
      const auto column = title("factor") < count ? title("factor") : title("normalisation_factor");
      if (column == count) {
        problem = "has a column \"file\" in its heading, but none called \"factor\" or \"normalisation_factor\"";
        return std::nullopt;
      }
      name = static_cast<std::size_t>(title("file"));
      factor = static_cast<std::size_t>(column);
      continue;
    }
    if (cells.size() == 1 && cells[0].empty()) continue;
    const auto value = std::max(name, factor) < cells.size() ? parse_number(cells[factor]) : std::nullopt;
    if (!value || !(*value > 0)) {
      problem = fmt::format("line {} must have a file's name and its factor, a number > 0", number);
      return std::nullopt;
    }
    factors[fs::path(cells[name]).filename().string()] = *value;
  }
  return factors;
}

void read_factor_file(const TomlView& given, const fs::path& folder, const std::vector<fs::path>& paths, Vary& vary) {
  const auto table = TableView::of(given, factor_file_keys());
  if (!table) return;
  const auto file = table->get("file");
  const auto name = file ? file->as_text() : std::nullopt;
  if (!name) return;
  std::string problem;
  vary.normalisation_file = folder / *name;
  const auto factors = factor_table(vary.normalisation_file, problem);
  if (!factors) {
    file->error_value(problem + " (names are relative to the study)");
    return;
  }
  for (const fs::path& path : paths) {
    const auto found = factors->find(path.filename().string());
    if (found == factors->end()) {
      file->error_value("has no factor for " + in_quotes(path.filename().string()));
      return;
    }
    vary.normalisation.push_back(found->second);
  }
}

/// PGV of the record that a file of the vary is, of two components their geometric mean; nothing where it cannot be
/// read.
std::optional<double> pgv_of(const Study& study, const Vary& vary, std::size_t level) {
  std::vector<Choice> choices(study.axes.size());
  choices[vary.axis].level = level;
  Study plain = study;
  plain.ida = IdaSpec{};  // without the case's scale
  const TomlValue root = chosen_case(plain, choices);
  Diagnostics ignored;
  const std::string name = study.case_file.string();
  const TomlView view(root, "", name, ignored);
  const auto pgv = [&](const TomlView& given, const KeyTable& keys) -> std::optional<double> {
    ExcitationSpec excitation;
    if (const auto table = TableView::of(given, keys)) {
      read_motion(*table, read_units(view), study.case_file.parent_path(), ignored, excitation, nullptr);
    }
    return excitation.record ? std::optional(motion_measures(excitation.motion).pgv) : std::nullopt;
  };
  const auto excitation = view.find("excitation");
  const auto along_x = excitation ? pgv(*excitation, excitation_keys()) : std::nullopt;
  if (!along_x || !excitation->has("y")) return along_x;
  const auto along_y = pgv(*excitation->find("y"), motion_along_y_keys());
  return along_y ? std::optional(std::sqrt(*along_x * *along_y)) : std::nullopt;
}

void normalise_by_pgv(const TomlView& view, const Study& study, Vary& vary) {
  std::vector<double> velocities;
  for (std::size_t i = 0; i < vary.values.size(); ++i) {
    const auto pgv = pgv_of(study, vary, i);
    if (!pgv) return;
    if (!(*pgv > 0)) {
      view.error_value(in_quotes(vary.labels[i]) + " is zero throughout and has no PGV");
      return;
    }
    velocities.push_back(*pgv);
  }
  if (vary.normalise_by == "pgv-pairs") {
    for (std::size_t i = 0; i + 1 < velocities.size(); i += 2) {
      velocities[i] = velocities[i + 1] = std::sqrt(velocities[i] * velocities[i + 1]);
    }
  }
  const double median = median_of(velocities);
  for (const double velocity : velocities) vary.normalisation.push_back(median / velocity);
}

}  // namespace

void read_normalisation(const TomlView& view, const fs::path& folder, const std::vector<fs::path>& paths, Vary& vary) {
  const auto given = view.find("normalisation");
  if (!given || paths.empty()) return;
  const auto& known = vary_keys().at("normalisation").words;
  if (given->is(TomlValue::Kind::table)) {
    read_factor_file(*given, folder, paths, vary);
  } else if (given->is(TomlValue::Kind::list)) {
    vary.normalisation = given->as_numbers(Range::positive, {paths.size(), "one per file"});
  } else if (const auto rule = given->as_word({known.begin(), known.end()})) {
    if (*rule == "pgv-pairs" && paths.size() % 2 == 1) {
      given->error_value(fmt::format("takes files two by two, and there are {}", paths.size()));
    } else {
      vary.normalise_by = *rule;
    }
  }
}

void settle_normalisation(const TomlView& root, Study& study) {
  for (std::size_t i = 0; i < study.varies.size(); ++i) {
    Vary& vary = study.varies[i];
    if (vary.path.empty() || (vary.normalise_by.empty() && vary.normalisation.empty())) continue;
    const TomlView view = *root.find("vary")->item(i).find("normalisation");
    const bool both = moves_along_y(study.case_root);
    bool refused = false;
    for (const ParameterPath& pga : {ParameterPath{"excitation", "pga"}, ParameterPath{"excitation", "y", "pga"}}) {
      const bool varied =
          std::any_of(study.varies.begin(), study.varies.end(), [&](const Vary& other) { return other.path == pga; });
      if (study.ida || refused || !(varied || find_value(study.case_root, pga) != nullptr)) continue;
      refused = true;
      view.error(fmt::format("does not go with {}, which gives every record the same peak", path_text(pga)));
    }
    if (both && vary.normalise_by == "pgv-pairs") {
      refused = true;
      view.error_value("is for components that stand in one list; with [excitation.y] it is \"pgv\"");
    }
    for (const Vary& other : study.varies) {
      const bool along_y =
          other.path.size() > 1 && other.path[0] == PathStep("excitation") && other.path[1] == PathStep("y");
      if (!along_y || other.axis == vary.axis) continue;
      refused = true;
      view.error(fmt::format("is of both components: {} must move together with {}", other.parameter, vary.parameter));
    }
    if (refused) continue;
    if (vary.normalisation.empty()) normalise_by_pgv(view, study, vary);
    if (study.ida) study.ida->normalised = true;
  }
}

}  // namespace bentur
