#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "bentur/io/case/case_parts.h"
#include "bentur/io/input_file.h"
#include "bentur/io/schema/case_keys.h"
#include "bentur/study/design/internal/study_parts.h"
#include "bentur/study/design/study.h"
#include "bentur/study/design/study_keys.h"
#include "bentur/study/design/sweep_design.h"
#include "bentur/study/suite/suite_study.h"

namespace bentur {
namespace {

void read_sampling(const TomlView& root, Study& study) {
  const auto view = TableView(root, study_keys()).table("sampling");
  if (!view) return;
  const auto method = view->word("method");
  study.sampling.method = method == "sobol"    ? Sampling::Method::sobol
                          : method == "random" ? Sampling::Method::random
                                               : Sampling::Method::latin_hypercube;
  study.sampling.count = static_cast<std::size_t>(view->whole("count").value_or(1));
  study.sampling.seed = static_cast<std::uint64_t>(view->whole("seed").value_or(1));
}

/// The case's own number, or list of numbers, that a factor multiplies.
bool is_numeric(const TomlValue& value) {
  if (value.kind == TomlValue::Kind::list) {
    return !value.items.empty() && std::all_of(value.items.begin(), value.items.end(), is_numeric);
  }
  return value.is_number();
}

/// Keys of [excitation] that scale the record.
bool is_scale(const PathStep& key) { return key == PathStep("pga") || key == PathStep("scale"); }

/// Whether it is one of its keys, or of [excitation.y].
bool is_of_motion(const ParameterPath& path) {
  if (path.front() != PathStep("excitation")) return false;
  return path.size() == 2 || (path.size() == 3 && path[1] == PathStep("y"));
}

void take_out_scale(TomlValue& root) {
  const auto take_out = [](TomlValue* table) {
    if (table != nullptr) std::erase_if(table->members, [](const TomlMember& member) { return is_scale(member.key); });
  };
  TomlValue* const excitation = root.find("excitation");
  if (excitation != nullptr) take_out(excitation->find("y"));  // first, as members move
  take_out(excitation);
}

/// Finds the vary's key in the case, and refuses what a study must leave alone.
void place_in_case(const TomlView& parameter, const TomlValue& case_root, bool ida, Vary& vary) {
  if (vary.path.empty()) return;
  std::string error;
  const auto path = resolved(case_root, vary.path, error);
  if (!path) {
    parameter.error_value(error);
    vary.path.clear();
    return;
  }
  vary.path = *path;
  for (FileKey& key : vary.file_keys) {
    const PathStep last = key.path.back();
    key.path = vary.path;
    key.path.back() = last;
  }
  const auto& first = std::get<std::string>(vary.path.front());
  if (first == "units" || first == "title") {
    parameter.error_value("is the same in all runs of a study");
    return;
  }
  if (ida && is_of_motion(vary.path) && is_scale(vary.path.back())) {
    parameter.error_value("is set by [ida], which scales every record to each level");
    return;
  }
  const bool chooses_file = vary.path == ParameterPath{"excitation", "file"};
  if (!chooses_file && (!vary.normalise_by.empty() || !vary.normalisation.empty())) {
    parameter.error_value("is no record to be normalised: normalisation goes with excitation.file");
  }
  if (!vary.factor) return;
  const TomlValue* original = find_value(case_root, vary.path);
  if (original == nullptr || !is_numeric(*original)) {
    parameter.error_value("must be a number of the case, or a list of numbers, for a factor to multiply");
    return;
  }
  vary.original = *original;
}

/// Where the study says it, as a message tells it: "in line 4".
std::string place_of(const TomlView& view, const Vary& vary) {
  return view.value().line > 0 ? fmt::format("in line {}", view.value().line) : "as " + vary.parameter;
}

/// Two varies of one key would overwrite one another.
void refuse_overlaps(const std::vector<TomlView>& views, const std::vector<Vary>& varies) {
  const auto paths = [](const Vary& vary) {
    std::vector<ParameterPath> all = {vary.path};
    for (const FileKey& key : vary.file_keys) all.push_back(key.path);
    return all;
  };
  const auto meet = [&](const Vary& a, const Vary& b) {
    for (const ParameterPath& x : paths(a)) {
      for (const ParameterPath& y : paths(b)) {
        if (!x.empty() && !y.empty() && overlap(x, y)) return true;
      }
    }
    return false;
  };
  for (std::size_t i = 0; i < varies.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (!meet(varies[i], varies[j])) continue;
      if (const auto parameter = views[i].find("parameter")) {
        parameter->error_value(fmt::format("is varied {} already", place_of(views[j], varies[j])));
      }
      break;
    }
  }
}

std::string levels_text(const Vary& vary) {
  return vary.distribution ? "a distribution" : fmt::format("{} values", vary.values.size());
}

/// Which axis each vary moves along: its own, or that of its companions.
void settle_axes(const std::vector<TomlView>& views, const std::vector<std::string>& together, Study& study) {
  std::map<std::string, std::size_t> leaders;  // the first vary of each name
  for (std::size_t i = 0; i < study.varies.size(); ++i) {
    Vary& vary = study.varies[i];
    if (together[i].empty()) {
      vary.axis = study.axes.size();
      study.axes.push_back(vary.name);
      continue;
    }
    const auto [leader, is_new] = leaders.emplace(together[i], i);
    if (is_new) {
      vary.axis = study.axes.size();
      study.axes.push_back(together[i]);
      continue;
    }
    const Vary& first = study.varies[leader->second];
    vary.axis = first.axis;
    if (vary.values.size() != first.values.size() || vary.distribution.has_value() != first.distribution.has_value()) {
      views[i]
          .find("together")
          ->error_value(fmt::format("has {} here, and {} {}: these cannot move in step", levels_text(vary),
                                    levels_text(first), place_of(views[leader->second], first)));
    }
  }
  std::map<std::string, std::size_t> names;
  for (std::size_t i = 0; i < study.varies.size(); ++i) {
    const std::string& name = study.varies[i].name;
    const auto [first, is_new] = names.emplace(name, i);
    if (!name.empty() && !is_new) {
      views[i].error(fmt::format("has the name {} in the results, as the one {}: give name = \"..\"", in_quotes(name),
                                 place_of(views[first->second], study.varies[first->second])));
    }
  }
  for (const auto& [name, leader] : leaders) {
    const auto one = names.find(name);
    if (one != names.end() && study.varies[one->second].axis != study.varies[leader].axis) {
      views[one->second].error(
          fmt::format("has the name {} of others that move together: give name = \"..\"", in_quotes(name)));
    }
  }
}

void read_varies(const TomlView& root, Study& study) {
  const auto list = root.find("vary");
  if (!list && (study.ida || study.suite)) return;
  if (!list) {
    root.error_missing("vary", "one [[vary]] table for each thing that varies");
    return;
  }
  if (!list->is(TomlValue::Kind::list) || list->size() == 0) {
    list->error_value("must be one or more tables, each headed [[vary]]");
    return;
  }
  const VaryContext context{.folder = study.file.parent_path(),
                            .case_folder = study.case_file.parent_path(),
                            .remedy = study.remedy.has_value(),
                            .samples = root.has("sampling")};
  std::vector<TomlView> views;
  std::vector<std::string> together(list->size());
  for (std::size_t i = 0; i < list->size(); ++i) {
    views.push_back(list->item(i));
    Vary vary = read_vary(views[i], context, together[i]);
    if (const auto parameter = views[i].find("parameter")) {
      vary.parameter_position = parameter->position();
      place_in_case(*parameter, study.case_root, study.ida.has_value(), vary);
    }
    study.varies.push_back(std::move(vary));
  }
  refuse_overlaps(views, study.varies);
  settle_axes(views, together, study);
}

bool read_case_of(const TomlView& root, Study& study, Diagnostics& diagnostics) {
  const auto given = root.get("case");
  const auto name = given ? given->as_text() : std::nullopt;
  if (!name) return false;
  study.case_file = study.file.parent_path() / *name;
  std::string problem;
  const auto text = read_input(study.case_file, case_input, problem);
  if (!text) {
    given->error_value(problem + " (names are relative to the study)");
    return false;
  }
  study.case_text = *text;
  auto parsed = parse_toml(study.case_text, study.case_file.string(), diagnostics);
  if (!parsed) return false;
  study.case_root = std::move(*parsed);
  return true;
}

/// Whether a motion of a case, of [excitation] or [excitation.y], can act reversed.
bool has_polarity(const Study& study, ParameterPath motion) {
  motion.emplace_back("kind");
  const TomlValue* const kind = find_value(study.case_root, motion);
  return kind != nullptr && (kind->text == "record" || kind->text == "harmonic");
}

/// A vary of excitation.polarity, a choice of the record like its file. @param which one of its words, or "both"
Vary vary_of_polarity(const std::string& which, const SourcePosition& position, const Study& study) {
  Vary vary;
  vary.parameter = "excitation.polarity";
  vary.path = {"excitation", "polarity"};
  vary.name = "polarity";
  vary.axis = study.axes.size();
  for (const std::string_view word : excitation_keys().at("polarity").words) {
    const std::string one(word);
    if (which == "both" || which == one) {
      vary.values.push_back(toml_text(one));
      vary.labels.push_back(one);
    }
  }
  vary.parameter_position = vary.position = position;
  if (has_polarity(study, {"excitation", "y"})) {
    FileKey both{{"excitation", "y", "polarity"}, {vary.values.begin(), vary.values.end()}};
    vary.file_keys.push_back(std::move(both));
  }
  return vary;
}

/// Of a remedy for what gaps need each record or harmonic motion acts both ways, unless the case does not look at the
/// other one or the study says which way it acts.
void apply_both_ways(Study& study) {
  const std::string& objective = study.remedy->objective;
  if (objective != "gap_needed" && objective != "point_gap_needed") return;
  const TomlValue* const looks = find_value(study.case_root, {"analysis", "both_ways"});
  const bool is_off = looks != nullptr && looks->kind == TomlValue::Kind::boolean && !looks->boolean;
  if (!has_polarity(study, {"excitation"}) || is_off) return;
  Vary both = vary_of_polarity("both", study.remedy->position, study);
  for (const Vary& other : study.varies) {
    if (other.name == both.name || study.axes[other.axis] == both.name) return;
    std::vector<ParameterPath> paths = {other.path};
    for (const FileKey& key : other.file_keys) paths.push_back(key.path);
    for (const ParameterPath& path : paths) {
      if (!path.empty() && (overlap(path, both.path) || overlap(path, {"excitation", "y", "polarity"}))) return;
    }
  }
  study.axes.push_back(both.name);
  study.varies.push_back(std::move(both));
}

/// [ida] polarity.
void add_polarity(const TomlView& root, Study& study) {
  if (study.ida->polarity.empty()) return;
  const TomlView view = *root.find("ida")->find("polarity");
  Vary vary = vary_of_polarity(study.ida->polarity, view.position(), study);
  const ParameterPath& path = vary.path;
  for (const Vary& other : study.varies) {
    if (overlap(other.path, path) || overlap(other.path, {"excitation", "y", "polarity"})) {
      view.error_value(fmt::format("but {} is varied in line {}", other.parameter, other.parameter_position.line));
    } else if (other.name == vary.name || study.axes[other.axis] == vary.name) {
      view.error_value(fmt::format("has the name of what varies in line {}: give that another name = \"..\"",
                                   other.parameter_position.line));
    }
  }
  study.axes.push_back(vary.name);
  study.varies.push_back(std::move(vary));
}

/// By what the intensity of both components goes.
void settle_component(const TomlView& root, Study& study) {
  const bool both = moves_along_y(study.case_root);
  if (!both && study.ida->component) {
    root.find("ida")->find("component")->error("goes with [excitation.y], which the case does not have");
  }
  if (both && !study.ida->component) study.ida->component = IntensityOf::geometric_mean;
}

/// [remedy] needs something to choose, and what moves in step with it must have a range too.
void expect_a_range(const TomlView& root, const Study& study) {
  const auto has_range = [](const Vary& vary) { return vary.sought.has_value(); };
  const auto gives_range = [](const TomlView& view) {
    return view.is(TomlValue::Kind::table) && view.value().find("from") != nullptr;
  };
  const auto given = root.find("vary");
  bool is_given = false;  // right or wrong
  for (std::size_t i = 0; given && i < given->value().items.size(); ++i) {
    is_given = is_given || gives_range(given->item(i));
  }
  if (!is_given && std::none_of(study.varies.begin(), study.varies.end(), has_range)) {
    root.find("remedy")->error("needs a [[vary]] with from and to: what may be chosen");
  }
  for (const Vary& vary : study.varies) {
    if (vary.path.empty() || vary.values.empty() || has_range(vary) == has_range(study.first_along(vary.axis)))
      continue;
    root.find("vary")->item(&vary - study.varies.data()).error("moves with a range and has none: give from and to");
  }
}

/// All of a study but its case.
void read_tables(const TomlView& root, bool has_case, Study& study, Diagnostics& found) {
  (void)TableView::of(root, study_keys());
  std::optional<Vary> records = has_case ? take_suite(study, found) : std::nullopt;
  read_sampling(root, study);
  study.ida = read_ida(root);
  study.remedy = read_remedy(root);
  if (has_case) {
    read_varies(root, study);
    if (study.remedy) {
      expect_a_range(root, study);
      apply_both_ways(study);
    }
    if (study.ida) {
      add_polarity(root, study);
      settle_component(root, study);
    }
    if (found.ok()) settle_normalisation(root, study);
    if (records) vary_records_of_suite(std::move(*records), study, found);
    if (study.ida && study.ida->is_cloud && found.ok()) check_cloud(root, study);
    if (study.ida && found.ok()) expect_unit_of_levels(root, study);
  }
  check_values(root, study_keys());
  if (study.ida && has_case && found.ok()) draw_with_records(root, study);
  if (study.ida && !study.ida->is_cloud) {
    study.ida->axis = study.axes.size();
    study.axes.emplace_back("intensity");
  }
}

/// Says of each vary whose last key no table of a case has that it is unknown, as a trial of the study says it: where
/// something else is wrong already, none is made.
void refuse_unknown_keys(const Study& study, Diagnostics& found) {
  for (const Vary& vary : study.varies) {
    const auto near = near_unknown_key(case_keys(), vary.path, study.case_root);
    if (!near) continue;
    found.add({.position = vary.parameter_position,
               .key = vary.parameter,
               .rule = "is not a known key",
               .suggestion = *near,
               .unknown_key = true});
  }
}

TomlValue scaled(TomlValue value, double factor) {
  if (value.kind == TomlValue::Kind::list) {
    for (TomlValue& item : value.items) item = scaled(std::move(item), factor);
    return value;
  }
  return toml_number(value.real * factor);
}

}  // namespace

std::optional<Study> read_study(const std::filesystem::path& file, Diagnostics& diagnostics) {
  const auto text = read_input(file, study_input, diagnostics);
  if (!text) return std::nullopt;
  Study study;
  study.file = file;
  study.text = *text;
  Diagnostics found;
  const std::string name = file.string();
  if (const auto parsed = parse_toml(study.text, name, found)) {
    const TomlView root(*parsed, "", name, found);
    if (!root.has("case") && root.has("building")) {
      found.error({name, 0, 0},
                  "is a case and no study, which names one, case = \"case.toml\", and what varies: bentur run, gap and "
                  "report take it as it is");
    } else {
      const bool has_case = read_case_of(root, study, found);
      read_tables(root, has_case, study, found);
      if (has_case && !found.ok()) refuse_unknown_keys(study, found);
    }
  }
  diagnostics.add(found);
  return found.ok() ? std::optional(std::move(study)) : std::nullopt;
}

std::optional<Study> read_study(const TomlValue& tables, Study study, Diagnostics& diagnostics) {
  Diagnostics found;
  const std::string no_file;
  read_tables(TomlView(tables, "", no_file, found), true, study, found);
  diagnostics.add(found);
  return found.ok() ? std::optional(std::move(study)) : std::nullopt;
}

bool moves_along_y(const TomlValue& case_root) { return find_value(case_root, {"excitation", "y"}) != nullptr; }

const Vary& Study::first_along(std::size_t axis) const {
  return *std::find_if(varies.begin(), varies.end(), [&](const Vary& vary) { return vary.axis == axis; });
}

double normalisation_of(const Study& study, const std::vector<Choice>& choices) {
  double factor = 1;
  for (const Vary& vary : study.varies) {
    if (!vary.normalisation.empty()) factor *= vary.normalisation[choices[vary.axis].level];
  }
  return factor;
}

std::optional<double> chosen_number(const Vary& vary, const Choice& choice) {
  if (vary.distribution) {
    if (!choice.low_or_high) return vary.distribution->quantile(choice.u);
    const Extremes ends = extremes(*vary.distribution);
    return *choice.low_or_high ? ends.high : ends.low;
  }
  if (!vary.labels.empty()) return std::nullopt;
  return vary.values[choice.level].real;
}

std::string chosen_text(const Vary& vary, const Choice& choice) {
  if (!vary.distribution && !vary.labels.empty()) return in_quotes(vary.labels[choice.level]);
  return fmt::format("{}", *chosen_number(vary, choice));
}

TomlValue chosen_value(const Vary& vary, const Choice& choice) {
  if (vary.factor) {
    const double factor = vary.distribution ? *chosen_number(vary, choice) : vary.values[choice.level].real;
    return scaled(vary.original, factor);
  }
  return vary.distribution ? toml_number(*chosen_number(vary, choice)) : vary.values[choice.level];
}

void put_choices(const Study& study, const std::vector<Choice>& choices, TomlValue& root) {
  for (std::size_t v = 0; v < study.varies.size(); ++v) {
    const Vary& vary = study.varies[v];
    const Choice& choice = choices[vary.axis];
    const int origin = 1 + static_cast<int>(v);
    put_value(root, vary.path, chosen_value(vary, choice), origin);
    for (const FileKey& key : vary.file_keys) {
      if (const auto& value = key.values[choice.level]) put_value(root, key.path, *value, origin);
    }
  }
  if (study.ida) {
    take_out_scale(root);
  } else if (const double factor = normalisation_of(study, choices); factor != 1) {
    // The case's own scale, or the one that varies, and not what an earlier call has put here.
    const auto multiply = [&](const ParameterPath& path) {
      const TomlValue* const given = find_value(study.case_root, path);
      double scale = given != nullptr ? given->real : 1;
      for (const Vary& vary : study.varies) {
        if (vary.path == path) scale = chosen_value(vary, choices[vary.axis]).real;
      }
      put_value(root, path, toml_number(scale * factor));
    };
    multiply({"excitation", "scale"});
    if (moves_along_y(root)) multiply({"excitation", "y", "scale"});
  }
}

TomlValue chosen_case(const Study& study, const std::vector<Choice>& choices) {
  TomlValue root = study.case_root;
  put_choices(study, choices, root);
  return root;
}

}  // namespace bentur
