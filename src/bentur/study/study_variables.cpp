#include "bentur/study/study_variables.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <set>
#include <utility>

#include "bentur/core/not_known.h"
#include "bentur/io/results/plan/plan_variables.h"
#include "bentur/io/results/run_variables.h"
#include "bentur/io/schema/parameter_units.h"
#include "bentur/io/toml/toml_view.h"
#include "bentur/model/judgement/open_needs.h"
#include "bentur/model/plan/plan_places.h"
#include "bentur/model/story/remarks.h"
#include "bentur/study/fragility/ida_results.h"

namespace bentur {
namespace {

/// A value of each run, by a function of it.
template <class Value, class Of>
std::function<ResultValues(std::span<const RunResult>)> each_run(const Of& of) {
  return [of](std::span<const RunResult> results) {
    std::vector<Value> values;
    for (const RunResult& result : results) values.push_back(of(result));
    return ResultValues(std::move(values));
  };
}

class StudyList {
 public:
  explicit StudyList(const StudyRuns& runs)
      : runs_(runs), study_(runs.study()), facts_(runs.facts()), is_grid_(runs.design().is_grid()) {}

  StudyFile file(std::string_view version) {
    file_.attributes = file_attributes(facts_.title, "seismic pounding analysis", version);
    const auto text = [&](const char* name, std::string value) {
      file_.attributes.push_back({name, std::move(value)});
    };
    text("study", study_.text);
    text("case", study_.case_text);
    std::string records;
    for (const auto& [name, hash] : facts_.records) records += fmt::format("{}  {}\n", hash, name);
    if (!records.empty()) text("records", records);
    for (std::size_t axis = 0; is_grid_ && axis < study_.axes.size(); ++axis) {
      file_.runs.push_back({study_.axes[axis], runs_.design().axes()[axis].levels});
    }
    if (!is_grid_) file_.runs.push_back({"sample", runs_.design().runs()});
    places();
    for (const Vary& vary : study_.varies) varies(vary);
    for (std::size_t axis = 0; is_grid_ && axis < study_.axes.size(); ++axis) index(axis);
    if (study_.ida) intensities(*study_.ida);
    for (const RowPart& quantity : runs_.quantities()) {
      if (quantity.count > 0) values_of(quantity);  // else of contact points or links where there are none
    }
    ends();
    return std::move(file_);
  }

 private:
  void add(ResultVariable variable, std::function<ResultValues(std::span<const RunResult>)> of_runs = {}) {
    file_.variables.push_back({{std::move(variable)}, std::move(of_runs)});
  }

  void places() {
    const std::string length = udunit(facts_.units.length);
    const std::string point_length = facts_.points_move ? "" : length;
    if (facts_.plan) {
      for (const PlanBuilding& building : facts_.plan->buildings) floors(building.name, building.model.elevations);
      for (std::size_t b = 0; b < facts_.plan->buildings.size(); ++b) planes(b);
      for (std::size_t b = 0; b < facts_.plan->buildings.size(); ++b) bearings(b);
      places_ = plan_place_variables(*facts_.plan, point_length, facts_.links_move ? "" : length);
    } else {
      for (const Building& building : facts_.problem.buildings) floors(building.name, building.model.elevations);
      places_ = place_variables(facts_.problem, point_length, facts_.links_move ? "" : length);
    }
    for (ResultVariable& variable : places_.variables) add(std::move(variable));
  }

  void floors(const std::string& building, std::vector<double> elevations) {
    if (facts_.floors_move) std::iota(elevations.begin(), elevations.end(), 1);
    buildings_.push_back(building);
    floors_.push_back({fmt::format("elevation_{}", buildings_.size()), elevations.size()});
    const char* what = facts_.floors_move ? "floors, whose elevations differ between runs," : "elevation of the floors";
    add({floors_.back().name,
         {floors_.back()},
         facts_.floors_move ? "1" : udunit(facts_.units.length),
         fmt::format("{} of building \"{}\"", what, building),
         {},
         std::move(elevations)});
  }

  void planes(std::size_t b) {
    const auto& all = facts_.plan->buildings[b].model.planes;
    planes_.push_back(plane_dimension(b, all.size()));
    if (all.empty()) return;
    add(plane_names(planes_.back(), facts_.plan->buildings[b]));
    if (!facts_.planes_turn) add(plane_angles(planes_.back(), facts_.plan->buildings[b], b));
  }

  void bearings(std::size_t b) {
    const PlanBuilding& building = facts_.plan->buildings[b];
    const std::size_t count = building.model.bearings.size();
    bearings_.push_back(bearing_dimension(b, count, !facts_.bearings_move));
    if (count == 0 || facts_.bearings_move) return;
    for (ResultVariable& one : bearing_places(bearings_.back(), building, b, udunit(facts_.units.length))) {
      add(std::move(one));
    }
  }

  /// What varies, along its axis or run by run.
  void varies(const Vary& vary) {
    const ResultDimension along = is_grid_ ? file_.runs[vary.axis] : file_.runs[0];
    const auto put = [&](ResultVariable variable, const auto& of_choice) {
      using Value = std::decay_t<decltype(of_choice(Choice()))>;
      std::vector<Value> values;
      for (Choice choice; is_grid_ && choice.level < along.size; ++choice.level) values.push_back(of_choice(choice));
      variable.values = values;
      if (is_grid_) return add(std::move(variable));
      add(std::move(variable), each_run<Value>([&runs = runs_, of_choice, axis = vary.axis](const RunResult& result) {
            return of_choice(runs.choices(result.run)[axis]);
          }));
    };
    ResultVariable variable{vary.name, {along}, "", (vary.factor ? "factor of " : "") + vary.parameter};
    if (!vary.factor) variable.attributes.push_back({"parameter", path_text(vary.path)});
    if (!is_grid_ || vary.name != study_.axes[vary.axis]) coordinates_ += " " + vary.name;
    if (vary.labels.empty()) {
      variable.units = vary.factor ? "1" : parameter_units(vary.path, study_.case_root, facts_.units);
      put(std::move(variable), [&vary](const Choice& choice) { return *chosen_number(vary, choice); });
    } else {
      put(std::move(variable), [&vary](const Choice& choice) { return vary.labels[choice.level]; });
    }
    if (vary.normalisation.empty()) return;
    put({"normalisation", {along}, "1", "factor that normalises the record"},
        [&vary](const Choice& choice) { return vary.normalisation[choice.level]; });
    coordinates_ += " normalisation";
  }

  /// What a dimension along which several move together is chosen by: the first labels among them, or numbers from 0.
  void index(std::size_t axis) {
    const ResultDimension& along = file_.runs[axis];
    if (study_.ida && axis == study_.ida->axis) return;
    ResultVariable variable{along.name, {along}, "", std::string(index_title)};
    std::vector<int> numbers(along.size);
    std::iota(numbers.begin(), numbers.end(), 0);
    variable.values = numbers;
    bool labelled = false;
    for (const Vary& vary : study_.varies) {
      if (vary.axis != axis) continue;
      if (vary.name == along.name) return;
      const bool names = std::set<std::string>(vary.labels.begin(), vary.labels.end()).size() == along.size;
      if (!labelled && names) variable.values = vary.labels;
      labelled = labelled || names;
    }
    add(std::move(variable));
  }

  /// The levels, and what they say of each record; of a cloud those of the records. Read again by read_ida_results().
  void intensities(const IdaSpec& ida) {
    const std::string units = intensity_units(ida, facts_.units);
    const std::string name = intensity_name(ida);
    const RecordIntensities& records = facts_.intensities;
    std::vector<ResultDimension> along;
    for (const std::size_t axis : records.axes) along.push_back(file_.runs[axis]);
    const std::vector<ResultDimension> levels = ida.axis ? std::vector<ResultDimension>{file_.runs[*ida.axis]} : along;
    ResultVariable intensity{"intensity", levels, units, name, {}, ida.axis ? ida.levels : records.values};
    intensity.attributes = {{"measure", ida.spectral ? "sa" : "pga"},
                            {"study_unit", ida.unit.empty() ? facts_.units.length + "/s2" : ida.unit}};
    if (ida.spectral) {
      intensity.attributes.push_back({"period", ida.period});
      intensity.attributes.push_back({"damping", ida.damping});
    }
    add(std::move(intensity));
    add({"record_intensity", along, units, name + " of the record as its file has it", {}, records.values});
    coordinates_ += " record_intensity";
    if (!ida.axis) {
      coordinates_ += " intensity";
      return;
    }
    along.push_back(levels.front());
    std::vector<double> factors;
    for (std::size_t place = 0; place < records.values.size(); ++place) {
      for (const double one : ida.levels) factors.push_back(record_factor(records, place, one));
    }
    add({"scale_factor", along, "1", "what the record is multiplied by", {}, factors});
    coordinates_ += " scale_factor";
  }

  void values_of(const RowPart& part) {
    ResultVariable variable{part.name, file_.runs, part.units, part.long_name};
    if (part.owner == Owner::plane) variable.dimensions.push_back(planes_[part.building]);
    if (part.owner == Owner::floor || part.owner == Owner::plane) variable.dimensions.push_back(floors_[part.building]);
    if (part.owner == Owner::hinge) {
      variable.dimensions.push_back({fmt::format("hinge_{}", part.building + 1), static_cast<std::size_t>(part.count)});
    }
    if (part.owner == Owner::column) {
      variable.dimensions.push_back(
          {fmt::format("breaking_column_{}", part.building + 1), static_cast<std::size_t>(part.count)});
    }
    if (part.owner == Owner::bearing) variable.dimensions.push_back(bearings_[part.building]);
    if (part.owner == Owner::gap) variable.dimensions.push_back(places_.gaps);
    if (part.owner == Owner::point) variable.dimensions.push_back(places_.points);
    if (part.owner == Owner::link) variable.dimensions.push_back(places_.links);
    variable.attributes.push_back({"symbol", std::string(part.quantity->symbol)});
    if (part.is_of_building()) {
      variable.attributes.push_back({"building", buildings_[part.building]});
    }
    const bool is_of_remarks = part.name == "remark_kinds";
    if (is_of_remarks || part.name == "open_needs") {
      std::string meanings;
      for (const std::string_view key : is_of_remarks ? remark_keys() : open_need_keys()) {
        meanings += (meanings.empty() ? "" : " ") + std::string(key);
      }
      variable.attributes.push_back({"flag_meanings", meanings});
    }
    if (part.quantity->by_size) variable.attributes.push_back({"compared_by", "size"});
    name_coordinates(variable, own_coordinates());
    variable.values = std::vector<double>();
    const auto count = static_cast<std::size_t>(part.count);
    add(std::move(variable), [first = part.first, count](std::span<const RunResult> results) {
      std::vector<double> values(results.size() * count, not_known);
      for (std::size_t i = 0; i < results.size(); ++i) {
        if (results[i].status != RunStatus::done) continue;
        std::copy_n(results[i].values.begin() + static_cast<std::ptrdiff_t>(first), count,
                    values.begin() + static_cast<std::ptrdiff_t>(i * count));
      }
      return ResultValues(std::move(values));
    });
  }

  void ends() {
    ResultVariable status{"status", file_.runs, "", "how the run ended"};
    status.attributes = {{"flag_values", std::vector<signed char>{0, 1, 2}},
                         {"flag_meanings", "done numbers_failed not_a_case"}};
    status.values = std::vector<signed char>();
    ResultVariable message{std::string(message_variable), file_.runs, "", "why a run failed"};
    message.values = std::vector<std::string>();
    for (ResultVariable* one : {&status, &message}) name_coordinates(*one, own_coordinates());
    add(std::move(status),
        each_run<signed char>([](const RunResult& result) { return static_cast<signed char>(result.status); }));
    add(std::move(message), each_run<std::string>([](const RunResult& result) { return result.message; }));
  }

  /// Those of every run that are not dimensions.
  [[nodiscard]] std::string own_coordinates() const { return coordinates_.empty() ? "" : coordinates_.substr(1); }

  const StudyRuns& runs_;
  const Study& study_;
  const StudyFacts& facts_;
  bool is_grid_;
  StudyFile file_;
  std::vector<std::string> buildings_;
  std::vector<ResultDimension> floors_, planes_, bearings_;  // of each building
  PlaceVariables places_;
  std::string coordinates_;
};

}  // namespace

StudyFile study_file(const StudyRuns& runs, std::string_view version) { return StudyList(runs).file(version); }

void check_names(const Study& study, Diagnostics& diagnostics) {
  // Whatever the case has: no name may mean one thing in one study and another in the next.
  std::set<std::string> taken = {"point",         "gap",        "intensity",      "record_intensity", "scale_factor",
                                 "normalisation", "sample",     "status",         "message",          "point_left",
                                 "point_right",   "gap_name",   "elevation",      "point_elevation",  "link",
                                 "link_left",     "link_right", "link_elevation", "point_x",          "point_y",
                                 "link_along",    "link_x",     "link_y"};
  for (const Quantity& quantity : quantities()) {
    if (quantity.owner != Owner::impact) taken.insert(file_name(quantity));
  }
  const auto is_taken = [&](const std::string& name) { return taken.count(name) > 0 || without_number(name) != name; };
  for (const Vary& vary : study.varies) {
    for (const std::string& name : {vary.name, study.axes[vary.axis]}) {
      if (is_taken(name)) {
        diagnostics.error(vary.parameter_position,
                          fmt::format("{} is the name of something else in the results, or like one: give another "
                                      "name = \"..\"",
                                      in_quotes(name)));
        break;
      }
    }
  }
}

std::string without_number(const std::string& name) {
  const std::size_t end = name.find_last_not_of("0123456789");
  return end != std::string::npos && end + 1 < name.size() && name[end] == '_' ? name.substr(0, end) : name;
}

bool is_quantity(const std::string& variable, const std::string& asked) {
  const std::string name = without_number(variable);
  if (asked == "drift") return name == "peak_drift_ratio" || name == plane_drift;
  return variable == asked || name == asked;
}

}  // namespace bentur
