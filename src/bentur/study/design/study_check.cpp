#include "bentur/study/design/study_check.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <mutex>
#include <set>
#include <utility>
#include <variant>

#include "bentur/core/errors.h"
#include "bentur/core/not_known.h"
#include "bentur/io/file_identity.h"
#include "bentur/model/plan/plan_places.h"
#include "bentur/model/quantity_row.h"
#include "bentur/study/quantiles.h"

namespace bentur {
namespace {

constexpr int most_errors = 5;  // of one axis; the rest will be alike

/// " (case.toml:3:1)", or nothing where there is no place.
std::string place_text(const SourcePosition& position) {
  const std::string file = std::filesystem::path(position.file).filename().string();
  if (file.empty()) return "";
  return position.line > 0 ? fmt::format(" ({}:{}:{})", file, position.line, position.column)
                           : fmt::format(" ({})", file);
}

/// What comes of some choices.
struct Attempt {
  Diagnostics found;                         // of the case that they make
  std::vector<std::filesystem::path> files;  // that it is read from
  std::string unlike;                        // what of it must be alike in all runs and is not
  std::string invalid;                       // why no problem can be made of it
};

class Trial {
 public:
  Trial(const Study& study, CaseMemo& memo, const ForEachNumber& for_each, Diagnostics& diagnostics)
      : study_(study), memo_(memo), for_each_(for_each), diagnostics_(diagnostics) {}

  /// The first choices: errors here are those of the case, or of a value wherever it is put.
  bool first() {
    Diagnostics found;
    const std::vector<Choice> choices(study_.axes.size());
    const ReadCase read = tried(choices, found);
    for (const Diagnostic& one : found.errors()) {
      if (one.position.origin > 0) {
        report(one, choices);
      } else {
        diagnostics_.add(one);
      }
    }
    if (!found.ok()) return false;
    if (refuse_without_motion(read.c, diagnostics_)) return false;
    try {
      if (read.plan) {
        facts_.plan = read.plan;
      } else {
        facts_.problem = read.problem();
      }
    } catch (const InvalidParameter& error) {
      diagnostics_.error({study_.case_file.string(), 0, 0}, error.what());
      return false;
    }
    facts_.units = read.c.units;
    facts_.title = read.c.title;
    facts_.energy_audit = read.c.analysis.energy_audit;
    for (const Vary& vary : study_.varies) {
      if (!vary.normalisation_file.empty()) note(vary.normalisation_file);
    }
    return true;
  }

  /// Everything that axis can be but for its first choice.
  void along(std::size_t axis) {
    const Vary& vary = study_.first_along(axis);
    std::vector<Choice> choices(study_.axes.size());
    errors_ = 0;
    if (vary.distribution) {
      for (const bool high : {false, true}) {
        choices[axis].low_or_high = high;
        take(attempt(choices), choices, axis);
      }
      return;
    }
    // Read by many threads, and taken one after the other.
    constexpr std::size_t at_once = 256;
    const std::vector<std::size_t> levels = further_levels(axis);
    for (std::size_t begin = 0; begin < levels.size(); begin += at_once) {
      std::vector<Attempt> attempts(std::min(at_once, levels.size() - begin));
      for_each_(attempts.size(), [&](std::size_t i) {
        std::vector<Choice> own = choices;
        own[axis].level = levels[begin + i];
        attempts[i] = attempt(own);
      });
      for (std::size_t i = 0; i < attempts.size(); ++i) {
        if (errors_ >= most_errors) return;
        choices[axis].level = levels[begin + i];
        take(attempts[i], choices, axis);
      }
    }
  }

  /// The values of an axis that are wrong wherever they are put, where the first choices make no case to compare with.
  void values_alone(std::size_t axis) {
    std::vector<Choice> choices(study_.axes.size());
    int errors = 0;
    for (const std::size_t level : further_levels(axis)) {
      if (errors >= most_errors) break;
      choices[axis].level = level;
      Diagnostics found;
      (void)tried(choices, found);
      for (const Diagnostic& one : found.errors()) {
        // Others are of the case or of other values, and said of the first choices.
        if (one.position.origin == 0 || study_.varies[one.position.origin - 1].axis != axis) continue;
        report(one, choices);
        ++errors;
      }
    }
  }

  /// The intensities of all records, once all choices have been tried.
  void measure_records() {
    RecordIntensities found{record_axes(study_), {}, {}, 0};
    std::vector<Choice> choices(study_.axes.size());
    for (std::size_t place = 0; place < found.combinations(); ++place) {
      found.choose(place, choices);
      found.values.push_back(measured(choices));
      if (study_.ida->normalised) found.normalisation.push_back(normalisation_of(study_, choices));
    }
    std::vector<double> normalised;
    for (std::size_t i = 0; i < found.normalisation.size(); ++i) {
      if (found.values[i] > 0) normalised.push_back(found.values[i] * found.normalisation[i]);
    }
    if (!normalised.empty()) found.median = median_of(std::move(normalised));
    facts_.intensities = std::move(found);
  }

  StudyFacts take() { return std::move(facts_); }

 private:
  /// Those to be tried after the first: of a range whose ends decide the last, of a list all; of a distribution none.
  [[nodiscard]] std::vector<std::size_t> further_levels(std::size_t axis) const {
    // Of companions one may be a range and the other a list.
    const bool ends = std::all_of(study_.varies.begin(), study_.varies.end(),
                                  [&](const Vary& v) { return v.axis != axis || v.ends_decide; });
    std::vector<std::size_t> levels;
    const std::size_t count = study_.first_along(axis).values.size();
    for (std::size_t level = 1; level < count; ++level) {
      if (!ends || level + 1 == count) levels.push_back(level);
    }
    return levels;
  }

  /// A file that the results come from.
  void note(const std::filesystem::path& file) {
    if (!facts_.record_files.insert(file.string()).second) return;
    std::string& hashes = facts_.records[file.filename().string()];
    hashes += (hashes.empty() ? "" : " ") + identify(file).sha256;
  }

  /// Reads the case that choices make; `files` are what it is read from.
  ReadCase made(const std::vector<Choice>& choices, Diagnostics& found,
                std::vector<std::filesystem::path>& files) const {
    ReadCase read = read_chosen(study_, chosen_case(study_, choices), memo_, found);
    if (!found.ok()) return read;
    for (const ExcitationSpec* const one : read.c.excitations()) {
      if (one->record && !one->record->path.empty()) {
        files.push_back(study_.case_file.parent_path() / one->record->file);
      }
    }
    for (const BuildingSpec& building : read.c.buildings) {
      if (!building.shapes_path.empty()) files.emplace_back(building.shapes_path);
    }
    return read;
  }

  ReadCase tried(const std::vector<Choice>& choices, Diagnostics& found) {
    std::vector<std::filesystem::path> files;
    ReadCase read = made(choices, found, files);
    for (const std::filesystem::path& file : files) note(file);
    return read;
  }

  double measured(const std::vector<Choice>& choices) {
    Diagnostics found;
    const ReadCase read = tried(choices, found);
    if (!found.ok()) return not_known;  // each alone is right, so its runs are marked
    std::string what = "[ida]";
    for (const std::size_t axis : record_axes(study_).axes) {
      const Vary& vary = study_.first_along(axis);
      what += fmt::format(" with {} = {}", vary.parameter, chosen_text(vary, choices[axis]));
    }
    const auto component = study_.ida->component;
    const bool both = read.plan && moves_along_y(chosen_case(study_, choices));
    if (both != component.has_value()) {
      diagnostics_.error(study_.ida->position, what + ": the ground moves along y in some runs alone");
      return 0;
    }
    std::vector<double> intensities;  // of x and, where the ground moves along both, y
    for (std::size_t direction = 0; direction < (both ? 2 : 1); ++direction) {
      const auto* motion = std::get_if<SampledMotion>(&read.c.excitations()[direction]->motion);
      if (motion == nullptr) {
        const std::string table = direction == 0 ? "excitation" : "excitation.y";
        diagnostics_.error(study_.ida->position,
                           fmt::format("{} needs records: {}.kind must be \"record\"", what, table));
        return 0;
      }
      try {
        intensities.push_back(intensity_of(*study_.ida, *motion, facts_.units));
      } catch (const InvalidParameter& error) {
        diagnostics_.error(study_.ida->position, fmt::format("{}: {}", what, error.what()));
        return 0;
      }
    }
    const double intensity = both ? intensity_of_both(*component, intensities[0], intensities[1]) : intensities.front();
    if (!(intensity > 0)) {
      diagnostics_.error(study_.ida->position,
                         what + (study_.ida->is_cloud ? ": the record is zero throughout and has no intensity"
                                                      : ": the record is zero throughout, no factor scales it"));
    }
    return intensity;
  }

  /// What choices make, held against the first ones. Many threads may ask.
  Attempt attempt(const std::vector<Choice>& choices) {
    Attempt tried_out;
    const ReadCase read = made(choices, tried_out.found, tried_out.files);
    if (!tried_out.found.ok()) return tried_out;
    try {
      const std::optional<Problem> row = read.plan ? std::nullopt : std::optional(read.problem());
      const std::lock_guard lock(facts_mutex_);
      if (read.plan && !take_places(*read.plan, facts_)) {
        tried_out.unlike =
            "which buildings meet, the numbers of floors, planes, bearings and contact points, and which of them can "
            "yield or rub, must be the same in all runs";
      } else if (row && !take_places(*row, facts_)) {
        tried_out.unlike =
            "the numbers of floors, contact points and links, and which buildings can yield, must be the same in all "
            "runs";
      }
    } catch (const InvalidParameter& error) {
      tried_out.invalid = error.what();
    }
    return tried_out;
  }

  void take(const Attempt& tried_out, const std::vector<Choice>& choices, std::size_t axis) {
    for (const std::filesystem::path& file : tried_out.files) note(file);
    for (const Diagnostic& error : tried_out.found.errors()) {
      if (error.position.origin > 0) {
        report(error, choices);
      } else {
        because_of(axis, choices, error.message() + place_text(error.position));
      }
      ++errors_;
    }
    for (const std::string& why : {tried_out.unlike, tried_out.invalid}) {
      if (why.empty()) continue;
      because_of(axis, choices, why);
      ++errors_;
    }
  }

  /// Where the study gives the value chosen.
  static SourcePosition place_of(const Vary& vary, const std::vector<Choice>& choices) {
    SourcePosition position = vary.position;
    if (vary.values.empty() || vary.values[choices[vary.axis].level].line <= 0) return position;
    position.line = vary.values[choices[vary.axis].level].line;
    position.column = vary.values[choices[vary.axis].level].column;
    return position;
  }

  /// An error about a value that the study has put in.
  void report(const Diagnostic& error, const std::vector<Choice>& choices) {
    const Vary& vary = study_.varies[static_cast<std::size_t>(error.position.origin - 1)];
    Diagnostic told = error;
    if (vary.distribution) {
      told.rule += choices[vary.axis].low_or_high ? " (the distribution can give that: cut it off with low, high)"
                                                  : " (the median of the distribution)";
    } else if (vary.factor) {
      told.rule += fmt::format(" (factor {})", chosen_text(vary, choices[vary.axis]));
    }
    // An unknown key is the parameter's fault, not the value's.
    told.position = error.unknown_key ? vary.parameter_position : place_of(vary, choices);
    diagnostics_.add(std::move(told));
  }

  /// An error elsewhere, in the case or a record, that a choice along `axis` brings about.
  void because_of(std::size_t axis, const std::vector<Choice>& choices, const std::string& what) {
    const Vary& vary = study_.first_along(axis);
    diagnostics_.error(place_of(vary, choices),
                       fmt::format("with {} = {}: {}", vary.parameter, chosen_text(vary, choices[axis]), what));
  }

  const Study& study_;
  CaseMemo& memo_;
  const ForEachNumber& for_each_;
  Diagnostics& diagnostics_;
  std::mutex facts_mutex_;
  StudyFacts facts_;
  int errors_ = 0;
};

/// Whether a vary changes contacts alone.
bool is_of_contact(const ParameterPath& path) {
  return path.size() > 1 && path[0] == PathStep("plan") && path[1] == PathStep("contact");
}

/// Whether it moves a building in plan as a whole.
bool is_of_place(const ParameterPath& path) {
  return path.size() > 3 && path[0] == PathStep("building") && path[2] == PathStep("plan") &&
         path[3] == PathStep("corner");
}

bool touches(const ParameterPath& path, const char* table, const char* key) {
  if (path.empty() || std::get<std::string>(path[0]) != table) return false;
  const auto* last = path.size() > 2 ? std::get_if<std::string>(&path[2]) : nullptr;
  return last != nullptr && *last == key;
}

/// Whether delays depend on the widths.
bool has_wave_velocity(const TomlValue& value) {
  return std::any_of(value.members.begin(), value.members.end(), [](const TomlMember& member) {
    return member.key == "wave_velocity" || has_wave_velocity(member.value);
  });
}

bool has_wave_velocity(const Vary& vary) {
  return std::any_of(vary.path.begin(), vary.path.end(),
                     [](const PathStep& s) { return s == PathStep("wave_velocity"); }) ||
         std::any_of(vary.values.begin(), vary.values.end(), [](const TomlValue& v) { return has_wave_velocity(v); });
}

}  // namespace

ReadCase read_chosen(const Study& study, const TomlValue& root, CaseMemo& memo, Diagnostics& found) {
  const std::string name = study.case_file.string();
  return read_case_parts(TomlView(root, "", name, found), study.case_file.parent_path(), found, &memo);
}

bool take_places(const PlanProblem& other, StudyFacts& facts) {
  const PlanProblem& first = *facts.plan;
  if (!same_places(first, other)) return false;
  for (std::size_t b = 0; b < first.buildings.size(); ++b) {
    const PlanModel &a = first.buildings[b].model, &model = other.buildings[b].model;
    facts.floors_move |= a.elevations != model.elevations;
    for (std::size_t p = 0; p < a.planes.size(); ++p) {
      facts.planes_turn |= a.planes[p].direction() != model.planes[p].direction();
    }
    for (std::size_t n = 0; n < a.bearings.size(); ++n) {
      facts.bearings_move |= a.footprint.corner + a.bearings[n].at != model.footprint.corner + model.bearings[n].at;
    }
  }
  for (Eigen::Index i = 0; i < contact_count(first); ++i) {
    const PlanContactPlace a = contact_at(first, i), b = contact_at(other, i);
    facts.points_move |= a.at != b.at || a.contact->elevation != b.contact->elevation;
  }
  for (std::size_t i = 0; i < first.links.size(); ++i) {
    const PlanLink &a = first.links[i], &b = other.links[i];
    facts.links_move |= a.stretch.middle(a.along) != b.stretch.middle(b.along) || a.link.elevation != b.link.elevation;
  }
  return true;
}

bool take_places(const Problem& other, StudyFacts& facts) {
  const Problem& first = facts.problem;
  if (!same_places(first, other)) return false;
  for (std::size_t b = 0; b < first.buildings.size(); ++b) {
    facts.floors_move |= first.buildings[b].model.elevations != other.buildings[b].model.elevations;
  }
  for (std::size_t i = 0; i < first.points.size(); ++i) {
    facts.points_move |= first.points[i].elevation != other.points[i].elevation;
  }
  for (std::size_t i = 0; i < first.links.size(); ++i) {
    facts.links_move |= first.links[i].elevation != other.links[i].elevation;
  }
  return true;
}

std::vector<RowPart> quantities_of(const StudyFacts& facts) {
  return facts.plan ? row_parts(*facts.plan, facts.units, facts.energy_audit)
                    : row_parts(facts.problem, facts.units, facts.energy_audit);
}

std::vector<std::string> building_names(const StudyFacts& facts) {
  std::vector<std::string> names;
  if (facts.plan) {
    for (const PlanBuilding& building : facts.plan->buildings) names.push_back(building.name);
  } else {
    for (const Building& building : facts.problem.buildings) names.push_back(building.name);
  }
  return names;
}

void one_after_the_other(std::size_t count, const std::function<void(std::size_t)>& work) {
  for (std::size_t i = 0; i < count; ++i) work(i);
}

std::optional<StudyFacts> check_study(const Study& study, CaseMemo& memo, Diagnostics& diagnostics,
                                      const ForEachNumber& for_each) {
  Diagnostics found;
  Trial trial(study, memo, for_each, found);
  try {
    (void)SweepDesign(design_axes(study), study.sampling);
    const bool makes_case = trial.first();
    for (std::size_t axis = 0; axis < study.axes.size(); ++axis) {
      if (study.ida && axis == study.ida->axis) continue;
      if (makes_case) {
        trial.along(axis);
      } else {
        trial.values_alone(axis);
      }
    }
    if (makes_case && study.ida && found.ok()) trial.measure_records();
  } catch (const InvalidParameter& error) {
    found.error({study.file.string(), 0, 0}, error.what());
  }
  // Several values can lead to one message.
  std::set<std::string> said;
  for (const Diagnostic& one : found.errors()) {
    if (said.insert(one.text()).second) diagnostics.add(one);
  }
  return found.ok() ? std::optional(trial.take()) : std::nullopt;
}

std::vector<SweepAxis> design_axes(const Study& study, bool places) {
  const bool wave =
      has_wave_velocity(study.case_root) ||
      std::any_of(study.varies.begin(), study.varies.end(), [](const Vary& vary) { return has_wave_velocity(vary); });
  std::vector<SweepAxis> axes(study.axes.size(), SweepAxis{.levels = 0, .inner = !wave});
  for (const Vary& vary : study.varies) {
    SweepAxis& axis = axes[vary.axis];
    axis.levels = vary.values.size();
    axis.inner = axis.inner && (touches(vary.path, "gap", "width") || touches(vary.path, "gap", "contact") ||
                                is_of_contact(vary.path) || (places && is_of_place(vary.path)));
  }
  if (study.ida && study.ida->axis) axes[*study.ida->axis] = {.levels = study.ida->levels.size(), .inner = false};
  return axes;
}

std::string first_message(const Diagnostics& diagnostics) {
  const std::vector<Diagnostic> errors = diagnostics.errors();
  return errors.empty() ? "" : errors.front().message();
}

}  // namespace bentur
