#include "bentur/study/sensitivity/sensitivity.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <type_traits>
#include <utility>

#include "bentur/core/errors.h"
#include "bentur/core/not_known.h"
#include "bentur/core/number_text.h"
#include "bentur/core/text.h"
#include "bentur/io/case/case_memo.h"
#include "bentur/io/case/case_parts.h"
#include "bentur/io/case/case_toml.h"
#include "bentur/io/file_identity.h"
#include "bentur/io/schema/case_keys.h"
#include "bentur/io/schema/table_view.h"
#include "bentur/io/toml/parameter_path.h"
#include "bentur/model/case.h"
#include "bentur/pounding/tangent/problem_tangents.h"
#include "bentur/study/problem_as.h"
#include "bentur/study/sensitivity/internal/suite_sensitivity.h"

namespace bentur {
namespace {

using Eigen::Index;

constexpr double relative_step = 1e-6;  // of a number: its square is below what assembly keeps
constexpr std::array tables_of_numbers = {"plan", "building", "gap", "link", "excitation", "initial"};
constexpr std::size_t most_buildings = 6;   // of a report
constexpr std::array samples = {"values"};  // lists that are no parameters

/// A number as a case has it, alone or as a text with its unit: "0.35 g".
struct Given {
  double value = 0;
  std::string unit;  ///< with the blank before it; empty: it stands alone

  [[nodiscard]] TomlValue other(double x) const {
    return unit.empty() ? toml_number(x) : toml_text(fmt::format("{:.17g}{}", x, unit));
  }
};

/// Nothing of what is neither.
std::optional<Given> number_in(const TomlValue& value) {
  if (value.is_number()) return Given{value.real, ""};
  if (value.kind != TomlValue::Kind::text) return std::nullopt;
  const std::string_view text = trimmed(value.text);
  Given given;
  const auto read = from_chars(text.data(), text.data() + text.size(), given.value);
  if (read.ec != std::errc()) return std::nullopt;
  given.unit = text.substr(static_cast<std::size_t>(read.ptr - text.data()));
  if (given.unit.empty()) return std::nullopt;
  return given;
}

/// All numbers of a value, with their paths. Texts are those of motions alone: a name may begin with a number.
void gather(const TomlValue& value, const ParameterPath& path, std::vector<ParameterPath>& paths) {
  const bool of_motion = path.front() == PathStep(std::string("excitation"));
  if (value.is_number() || (of_motion && number_in(value))) paths.push_back(path);
  const auto into = [&](const TomlValue& part, PathStep step) {
    ParameterPath longer = path;
    longer.push_back(std::move(step));
    gather(part, longer, paths);
  };
  for (std::size_t i = 0; i < value.items.size(); ++i) into(value.items[i], i);
  for (const TomlMember& member : value.members) {
    if (std::find(samples.begin(), samples.end(), member.key) == samples.end()) into(member.value, member.key);
  }
}

/// Whether a number is of a footprint's corners or size.
bool is_of_footprint(const ParameterPath& path) {
  constexpr std::array keys = {"corner", "size", "polygon", "court", "part"};
  return path.size() > 3 && path[0] == PathStep("building") && path[2] == PathStep("plan") &&
         std::any_of(keys.begin(), keys.end(), [&](const char* key) { return path[3] == PathStep(key); });
}

/// Of a case in plan the widths of its gaps, by what they are called as numbers.
std::vector<std::string> names_of_widths(const ReadCase& read) {
  std::vector<std::string> names;
  if (!read.plan) return names;
  for (const PlanGap& gap : read.plan->gaps) names.push_back(gap_name(*read.plan, gap) + ": width");
  return names;
}

/// The numbers of a case that are asked for.
struct Asked {
  std::vector<ParameterPath> paths = {};
  std::vector<std::size_t> widths = {};  ///< of these gaps in plan
};

/// Those that were asked for; what is none is an error.
Asked asked_numbers(const TomlValue& root, const std::filesystem::path& file, const std::vector<std::string>& asked,
                    const std::vector<std::string>& widths, Diagnostics& diagnostics) {
  Asked numbers;
  for (const std::string& text : asked) {
    if (const auto width = std::find(widths.begin(), widths.end(), text); width != widths.end()) {
      numbers.widths.push_back(static_cast<std::size_t>(width - widths.begin()));
      continue;
    }
    std::string error;
    std::optional<ParameterPath> path = parse_path(text, error);
    if (path) path = resolved(root, *path, error);
    const TomlValue* const value = path ? find_value(root, *path) : nullptr;
    if (path && (value == nullptr || !number_in(*value))) error = "is no number of this case";
    if (!error.empty()) {
      Diagnostic found;
      found.position.file = file.string();
      found.key = text;
      found.rule = error;
      if (path && value == nullptr) found.suggestion = near_unknown_key(case_keys(), *path, root).value_or("");
      diagnostics.add(std::move(found));
    } else {
      numbers.paths.push_back(*path);
    }
  }
  return numbers;
}

/// Whether a number of a gap or a link says at which floors it is, not how high these are: another one names none.
bool names_a_floor(const ParameterPath& path) {
  const auto is = [&](std::size_t step, const char* key) {
    const auto* const text = step < path.size() ? std::get_if<std::string>(&path[step]) : nullptr;
    return text != nullptr && *text == key;
  };
  return (is(0, "gap") || is(0, "link")) && (is(1, "elevations") || is(2, "elevations"));
}

class Maker {
 public:
  Maker(const TomlValue& root, const std::filesystem::path& file) : root_(root), file_(file) {}

  /// The problem where a number is another one; nothing where the case is then wrong, and why.
  template <class AnyProblem>
  std::optional<AnyProblem> with(const ParameterPath& path, const TomlValue& value, std::string& why) {
    TomlValue root = root_;
    put_value(root, path, value);
    Diagnostics found;
    try {
      const ReadCase read =
          read_case_parts(TomlView(root, "", file_.string(), found), file_.parent_path(), found, &memo_);
      if (found.ok()) return problem_as<AnyProblem>(read);
      why = found.errors().front().rule;
    } catch (const InvalidParameter& error) {
      why = error.what();
    }
    return std::nullopt;
  }

  ReadCase itself(Diagnostics& diagnostics) {
    return read_case_parts(TomlView(root_, "", file_.string(), diagnostics), file_.parent_path(), diagnostics, &memo_);
  }

 private:
  const TomlValue& root_;
  const std::filesystem::path& file_;
  CaseMemo memo_;
};

using Kind = SensitivePeak::Kind;

std::vector<SensitivePeak> peaks_of(const Problem& problem, const Tangents& found) {
  std::vector<SensitivePeak> peaks;
  for (Index gap = 0; gap < gap_count(problem); ++gap) {
    for (const auto& [kind, of] : {std::pair(Kind::gap_needed, &found.needed), {Kind::peak_force, &found.peak_force}}) {
      for (const Index point : gap_at(problem, gap).points) {
        peaks.push_back({.kind = kind,
                         .item = gap,
                         .place = point,
                         .name = gap_name(problem, gap),
                         .level = problem.points[point].elevation,
                         .derivative = (*of)[point]});
      }
    }
  }
  return peaks;
}

std::vector<SensitivePeak> peaks_of(const PlanProblem& problem, const Tangents& found) {
  std::vector<SensitivePeak> peaks;
  Index first = 0;
  for (Index gap = 0; gap < std::ssize(problem.gaps); ++gap) {
    const PlanGap& between = problem.gaps[gap];
    for (const auto& [kind, of] : {std::pair(Kind::gap_needed, &found.needed), {Kind::peak_force, &found.peak_force}}) {
      for (Index i = 0; i < std::ssize(between.contacts); ++i) {
        peaks.push_back({.kind = kind,
                         .item = gap,
                         .place = first + i,
                         .name = gap_name(problem, between),
                         .level = between.contacts[i].elevation,
                         .at = between.middle(between.contacts[i]),
                         .derivative = (*of)[first + i]});
      }
    }
    first += std::ssize(between.contacts);
  }
  return peaks;
}

/// Displacements of one kind, of the floors of a building, in what was found from `begin` on; of a wall there are none.
void add_floors(Kind kind, Index building, const std::string& name, const std::vector<double>& elevations,
                const std::vector<Derivative>& of, Index begin, std::vector<SensitivePeak>& peaks) {
  for (Index floor = 0; floor < std::ssize(elevations) && begin + floor < std::ssize(of); ++floor) {
    peaks.push_back({.kind = kind,
                     .item = building,
                     .place = floor,
                     .name = name,
                     .level = elevations[floor],
                     .derivative = of[begin + floor]});
  }
}

void add_displacements(const Problem& problem, const Tangents& found, std::vector<SensitivePeak>& peaks) {
  for (Index b = 0; b < std::ssize(problem.buildings); ++b) {
    const Building& of = problem.buildings[b];
    const auto add = [&](Kind kind, const auto& list) {
      add_floors(kind, b, of.name, of.model.elevations, list[b], 0, peaks);
    };
    add(Kind::displacement, found.displacement);
    add(Kind::displacement_no_contact, found.displacement_free);
  }
}

void add_displacements(const PlanProblem& problem, const Tangents& found, std::vector<SensitivePeak>& peaks) {
  for (Index b = 0; b < std::ssize(problem.buildings); ++b) {
    const PlanBuilding& of = problem.buildings[b];
    if (of.is_rigid()) continue;
    const auto add = [&](Kind kind, const auto& list, Index begin) {
      add_floors(kind, b, of.name, of.model.elevations, list[b], begin, peaks);
    };
    add(Kind::displacement_x, found.displacement, 0);
    add(Kind::displacement_x_no_contact, found.displacement_free, 0);
    add(Kind::displacement_y, found.displacement, of.model.floors());
    add(Kind::displacement_y_no_contact, found.displacement_free, of.model.floors());
  }
}

}  // namespace

std::vector<ParameterPath> numbers_in(const TomlValue& root) {
  std::vector<ParameterPath> paths;
  for (const char* table : tables_of_numbers) {
    if (const TomlValue* const value = root.find(table)) gather(*value, {std::string(table)}, paths);
  }
  return paths;
}

void mark_largest(std::vector<SensitivePeak>& peaks) {
  for (SensitivePeak& peak : peaks) {
    peak.is_largest =
        peak.derivative.by.size() > 0 && std::none_of(peaks.begin(), peaks.end(), [&](const SensitivePeak& other) {
          return &other != &peak && other.kind == peak.kind && other.item == peak.item &&
                 (other.derivative.value > peak.derivative.value ||
                  (other.derivative.value == peak.derivative.value && &other < &peak));
        });
  }
}

std::string_view key_of(SensitivePeak::Kind kind) {
  switch (kind) {
    case Kind::gap_needed:
      return "gap_needed";
    case Kind::peak_force:
      return "peak_force";
    case Kind::displacement:
      return "displacement";
    case Kind::displacement_no_contact:
      return "displacement_no_contact";
    case Kind::displacement_x:
      return "displacement_x";
    case Kind::displacement_x_no_contact:
      return "displacement_x_no_contact";
    case Kind::displacement_y:
      return "displacement_y";
    case Kind::displacement_y_no_contact:
      break;
  }
  return "displacement_y_no_contact";
}

bool is_of_gap(SensitivePeak::Kind kind) { return kind == Kind::gap_needed || kind == Kind::peak_force; }

double Sensitivity::elasticity(const SensitivePeak& peak, std::size_t number) const {
  const Derivative& of = peak.derivative;
  if (of.by.size() == 0 || !(of.value > 0) || numbers[number].is_of_footprint) return not_known;
  return of.by(static_cast<Index>(number)) * numbers[number].value / of.value;
}

namespace {

/// A gap in plan with another width: all its contacts are as much further apart, and no others.
PlanProblem with_width(PlanProblem problem, std::size_t gap, double more) {
  problem.gaps[gap].stretch.width += more;
  return problem;
}

/// Of a case that is right, with one motion, by these numbers. Nothing (and an error) where there are none.
template <class AnyProblem>
std::optional<Sensitivity> found_by(const ReadCase& read, Maker& maker, const TomlValue& root, const Asked& asked,
                                    const SensitivityOptions& options,
                                    const std::function<std::nullopt_t(const std::string&)>& refuse) {
  Sensitivity result{.title = read.c.title, .units = read.c.units, .numbers = {}, .left_out = {}, .peaks = {}};
  const AnyProblem problem = problem_as<AnyProblem>(read);
  std::vector<VariationOf<AnyProblem>> variations;
  std::vector<CaseNumber> numbers;
  if constexpr (std::is_same_v<AnyProblem, PlanProblem>) {
    const std::vector<std::string> names = names_of_widths(read);
    for (const std::size_t gap : asked.widths) {
      const CaseNumber width{names[gap], problem.gaps[gap].stretch.width};
      const double step = relative_step * width.value;
      if (step == 0.0) {
        result.left_out.emplace_back(width.path, "is zero: no part of it can be added");
        continue;
      }
      variations.push_back({step, with_width(problem, gap, -step), with_width(problem, gap, step)});
      numbers.push_back(width);
    }
  }
  for (const ParameterPath& path : asked.paths) {
    const Given given = *number_in(*find_value(root, path));
    const CaseNumber number{path_text(path), given.value, is_of_footprint(path)};
    const double step = relative_step * std::abs(number.value);
    if (step == 0.0 || names_a_floor(path)) {
      const char* const why = step == 0.0 ? "is zero: no part of it can be added" : "names a floor: another names none";
      result.left_out.emplace_back(number.path, why);
      continue;
    }
    std::string why;
    std::optional<AnyProblem> below = maker.with<AnyProblem>(path, given.other(number.value - step), why), above;
    if (below) above = maker.with<AnyProblem>(path, given.other(number.value + step), why);
    if (!above) {
      result.left_out.emplace_back(number.path, why);
      continue;
    }
    variations.push_back({step, *std::move(below), *std::move(above)});
    numbers.push_back(number);
  }
  const ProblemTangents found = tangents(problem, variations, run_limits(read.c.analysis), options.progress);
  if (found.refused) return refuse("there are no sensitivities of this case: " + *found.refused);
  if (found.status == Status::stopped) return std::nullopt;
  if (found.status != Status::done) return refuse("the run did not get to its end: " + found.message);
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    if (found.left_out[i]) {
      result.left_out.emplace_back(numbers[i].path, *found.left_out[i]);
    } else {
      result.numbers.push_back(numbers[i]);
    }
  }
  result.peaks = peaks_of(problem, found.found);
  add_displacements(problem, found.found, result.peaks);
  mark_largest(result.peaks);
  return result;
}

}  // namespace

std::optional<Sensitivity> sensitivity_of(const TomlValue& root, const std::filesystem::path& file,
                                          const SensitivityOptions& options, Diagnostics& diagnostics) {
  Maker maker(root, file);
  const ReadCase read = maker.itself(diagnostics);
  if (!diagnostics.ok()) return std::nullopt;
  const Case& c = read.c;
  const auto refuse = [&](const std::string& why) {
    diagnostics.error({file.string(), 0, 0}, why);
    return std::nullopt;
  };
  if (c.excitation.suite) return sensitivity_of_suite(root, file, c.excitation.suite, options, diagnostics);
  if (refuse_without_motion(c, diagnostics)) return std::nullopt;
  if (!std::holds_alternative<ExactSolver>(c.analysis.solver)) {
    return refuse("sensitivities are found by the solver \"exact\" alone");
  }
  const std::vector<std::string> widths = names_of_widths(read);
  Asked asked{.paths = numbers_in(root)};
  for (std::size_t gap = 0; gap < widths.size(); ++gap) asked.widths.push_back(gap);
  if (!options.numbers.empty()) asked = asked_numbers(root, file, options.numbers, widths, diagnostics);
  if (!diagnostics.ok()) return std::nullopt;
  return read.plan ? found_by<PlanProblem>(read, maker, root, asked, options, refuse)
                   : found_by<Problem>(read, maker, root, asked, options, refuse);
}

namespace {

/// For a report: what cannot be found is left out of it.
std::optional<Sensitivity> found_or_nothing(const TomlValue& root, const std::filesystem::path& file) {
  Diagnostics found;
  try {
    auto sensitivity = sensitivity_of(root, file, {}, found);
    return found.ok() ? std::move(sensitivity) : std::nullopt;
  } catch (const InvalidParameter&) {
    return std::nullopt;
  }
}

/// Whether a file is the record that was run.
bool is_record(const std::filesystem::path& file, const RecordEcho& record) {
  std::error_code failed;
  return std::filesystem::is_regular_file(file, failed) && std::filesystem::file_size(file, failed) == record.size &&
         identify(file).sha256 == record.sha256;
}

}  // namespace

std::optional<Sensitivity> sensitivity_of_report(const Case& c, const std::filesystem::path& file) {
  if (c.given == nullptr || c.buildings.size() > most_buildings) return std::nullopt;
  return found_or_nothing(*c.given, file);
}

std::optional<Sensitivity> sensitivity_of_results(const Case& c, const std::vector<std::filesystem::path>& folders) {
  if (!c.source || c.buildings.size() > most_buildings) return std::nullopt;
  Diagnostics ignored;
  const auto root = parse_toml(c.source->text, c.source->file, ignored);
  if (!root) return std::nullopt;
  // Of buildings in plan a second motion, along y, may have one too.
  const auto is_there = [&](const ParameterPath& path, const ExcitationSpec& motion, const std::filesystem::path& at) {
    const TomlValue* const named = find_value(*root, path);
    return named == nullptr || (motion.record && is_record(at / named->text, *motion.record));
  };
  for (const std::filesystem::path& folder : folders) {
    const bool is_here = is_there({"excitation", "file"}, c.excitation, folder) &&
                         is_there({"excitation", "y", "file"}, c.excitation_y, folder);
    if (is_here) return found_or_nothing(*root, folder / c.source->file);
  }
  return std::nullopt;
}

}  // namespace bentur
