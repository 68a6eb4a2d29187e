#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <algorithm>
#include <atomic>
#include <limits>

#include "bentur/io/case/parameter_units.h"
#include "bentur/study/fragility/fragility_report.h"
#include "bentur/study/gap/gap_study.h"
#include "bentur/study/study_runs.h"
#include "case_run.h"
#include "toml_python.h"

namespace py = pybind11;

namespace bentur::python {
namespace {

namespace fs = std::filesystem;

/// A study that has been read and checked.
class PyStudy {
 public:
  explicit PyStudy(std::unique_ptr<StudyRuns> runs) : runs_(std::move(runs)) {}

  [[nodiscard]] const StudyRuns& runs() const { return *runs_; }
  void stop() { stop_ = true; }

  /// Rows of numbers, one per run, NaN where it failed; how each ended, and why not. Fewer where it was stopped.
  [[nodiscard]] py::tuple solve(std::size_t first, std::size_t count) const {
    const std::size_t size = row_size(runs_->quantities());
    std::vector<std::size_t> numbers(count);
    for (std::size_t i = 0; i < count; ++i) numbers[i] = runs_->plan().run_at(first + i);
    std::vector<RunResult> results;
    {
      const py::gil_scoped_release unlocked;
      results = runs_->solve(numbers, [&] { return !stop_.load(std::memory_order_relaxed); });
    }
    py::array_t<double> values({results.size(), size});
    py::array_t<std::int64_t> run(static_cast<py::ssize_t>(results.size()));
    py::array_t<std::int8_t> status(static_cast<py::ssize_t>(results.size()));
    py::list messages;
    double* row = values.mutable_data();
    for (std::size_t i = 0; i < results.size(); ++i, row += size) {
      const RunResult& one = results[i];
      run.mutable_at(i) = static_cast<std::int64_t>(one.run);
      status.mutable_at(i) = static_cast<std::int8_t>(one.status);
      messages.append(one.message);
      if (one.values.empty()) {
        std::fill(row, row + size, std::numeric_limits<double>::quiet_NaN());
      } else {
        std::copy(one.values.begin(), one.values.end(), row);
      }
    }
    return py::make_tuple(run, status, messages, values);
  }

 private:
  std::unique_ptr<StudyRuns> runs_;
  std::atomic<bool> stop_ = false;
};

std::shared_ptr<PyStudy> read(const fs::path& file) {
  Diagnostics found;
  std::optional<Study> study = read_study(file, found);
  const auto memo = std::make_shared<CaseMemo>();
  std::optional<StudyFacts> facts = study ? check_study(*study, *memo, found) : std::nullopt;
  if (!facts || !found.ok()) raise_case_error(found);
  return std::make_shared<PyStudy>(std::make_unique<StudyRuns>(std::move(*study), std::move(*facts), memo));
}

/// A coordinate or variable of the results: name, dimensions, values, attributes.
py::tuple variable(const std::string& name, const std::vector<std::string>& dimensions, const py::object& values,
                   const std::string& units, const std::string& long_name) {
  py::dict attributes;
  if (!units.empty()) attributes["units"] = units;
  attributes["long_name"] = long_name;
  return py::make_tuple(name, dimensions, values, attributes);
}

/// What varies, as coordinates along the dimensions of the runs.
void add_varies(const StudyRuns& runs, const std::vector<std::string>& dimensions, py::list& coordinates) {
  const Study& study = runs.study();
  const bool grid = runs.plan().is_grid();
  for (const Vary& vary : study.varies) {
    const std::vector<std::string> along = {grid ? dimensions[vary.axis] : dimensions[0]};
    const std::size_t size = grid ? runs.plan().axes()[vary.axis].levels : runs.plan().runs();
    const auto choice = [&](std::size_t i) {
      Choice chosen;
      if (!grid) return runs.choices(i)[vary.axis];
      chosen.level = i;
      return chosen;
    };
    py::list values, normalisation;
    for (std::size_t i = 0; i < size; ++i) {
      const Choice chosen = choice(i);
      if (vary.labels.empty()) {
        values.append(grid ? vary.values[i].real : *chosen_number(vary, chosen));
      } else {
        values.append(vary.labels[chosen.level]);
      }
      if (!vary.normalisation.empty()) normalisation.append(vary.normalisation[chosen.level]);
    }
    const std::string units = !vary.labels.empty() ? ""
                              : vary.factor        ? "1"
                                                   : parameter_units(vary.path, study.case_root, runs.facts().units);
    py::tuple one = variable(vary.name, along, values, units, (vary.factor ? "factor of " : "") + vary.parameter);
    if (!vary.factor) one[3]["parameter"] = path_text(vary.path);
    coordinates.append(one);
    if (vary.normalisation.empty()) continue;
    coordinates.append(variable("normalisation", along, normalisation, "1", "factor that normalises the record"));
  }
}

void add_intensities(const StudyRuns& runs, const std::vector<std::string>& dimensions, py::list& coordinates) {
  const IdaSpec& ida = *runs.study().ida;
  const std::string units = intensity_units(ida, runs.facts().units);
  const std::string name = intensity_name(ida);
  py::tuple levels = variable("intensity", {dimensions[ida.axis]}, array_of(ida.levels), units, name);
  levels[3]["measure"] = ida.spectral ? "sa" : "pga";
  levels[3]["study_unit"] = ida.unit.empty() ? runs.facts().units.length + "/s2" : ida.unit;
  if (ida.spectral) {
    levels[3]["period"] = ida.period;
    levels[3]["damping"] = ida.damping;
  }
  coordinates.append(levels);
  const RecordIntensities& records = runs.facts().intensities;
  std::vector<std::string> along;
  std::vector<std::size_t> shape;
  for (std::size_t i = 0; i < records.axes.size(); ++i) {
    along.push_back(dimensions[records.axes[i]]);
    shape.push_back(records.sizes[i]);
  }
  py::object values = array_of(records.values).attr("reshape")(py::cast(shape));
  coordinates.append(variable("record_intensity", along, values, units, name + " of the record as its file has it"));
  std::vector<double> factors;
  for (std::size_t place = 0; place < records.values.size(); ++place) {
    for (const double level : ida.levels) factors.push_back(record_factor(records, place, level));
  }
  along.push_back(dimensions[ida.axis]);
  shape.push_back(ida.levels.size());
  values = array_of(factors).attr("reshape")(py::cast(shape));
  coordinates.append(variable("scale_factor", along, values, "1", "what the record is multiplied by"));
}

/// Where things are: floors, points, gaps, links.
void add_places(const StudyRuns& runs, py::list& coordinates) {
  const StudyFacts& facts = runs.facts();
  const Problem& problem = facts.problem;
  const std::string length = udunit(facts.units.length);
  for (std::size_t b = 0; b < problem.buildings.size(); ++b) {
    const Building& building = problem.buildings[b];
    const std::string name = "elevation_" + std::to_string(b + 1);
    std::vector<double> places = building.model.elevations;
    for (std::size_t i = 0; facts.floors_move && i < places.size(); ++i) places[i] = static_cast<double>(i + 1);
    coordinates.append(variable(
        name, {name}, array_of(places), facts.floors_move ? "1" : length,
        std::string(facts.floors_move ? "floors, whose elevations differ between runs," : "elevation of the floors") +
            " of building \"" + building.name + "\""));
  }
  py::list gaps, left, right, elevations;
  for (const Gap& gap : gaps_of(problem)) gaps.append(gap_name(problem, gap.left));
  coordinates.append(variable("gap_name", {"gap"}, gaps, "", "buildings on both sides of the gaps"));
  const auto add = [&](const std::string& what, bool move) {
    const std::string of = what == "point" ? "contact points" : "links";
    coordinates.append(variable(what + "_left", {what}, left, "", "building to the left of the " + of));
    coordinates.append(variable(what + "_right", {what}, right, "", "building to the right of the " + of));
    if (!move) coordinates.append(variable(what + "_elevation", {what}, elevations, length, "elevation of the " + of));
    left = right = elevations = py::list();
  };
  for (const ContactPoint& point : problem.points) {
    left.append(problem.buildings[point.left].name);
    right.append(problem.buildings[point.left + 1].name);
    elevations.append(point.elevation);
  }
  if (!problem.points.empty()) add("point", facts.points_move);
  for (const Link& link : problem.links) {
    left.append(problem.buildings[link.left].name);
    right.append(problem.buildings[link.right].name);
    elevations.append(link.elevation);
  }
  if (!problem.links.empty()) add("link", facts.links_move);
}

/// Everything that a Dataset needs but the numbers: dimensions of the runs, coordinates, the parts of a row.
py::dict description(const PyStudy& study) {
  const StudyRuns& runs = study.runs();
  py::dict told;
  std::vector<std::string> dimensions;
  std::vector<std::size_t> sizes;
  if (runs.plan().is_grid()) {
    for (std::size_t axis = 0; axis < runs.study().axes.size(); ++axis) {
      dimensions.push_back(runs.study().axes[axis]);
      sizes.push_back(runs.plan().axes()[axis].levels);
    }
  } else {
    dimensions = {"sample"};
    sizes = {runs.plan().runs()};
  }
  py::list coordinates, parts;
  add_places(runs, coordinates);
  add_varies(runs, dimensions, coordinates);
  if (runs.study().ida) add_intensities(runs, dimensions, coordinates);
  for (const RowPart& part : runs.quantities()) {
    if (part.count == 0) continue;
    std::string along;
    if (part.owner == Owner::floor) along = "elevation_" + std::to_string(part.building + 1);
    if (part.owner == Owner::gap) along = "gap";
    if (part.owner == Owner::point) along = "point";
    if (part.owner == Owner::link) along = "link";
    py::dict attributes;
    attributes["units"] = part.units;
    attributes["long_name"] = part.long_name;
    attributes["symbol"] = std::string(part.quantity->symbol);
    if (part.quantity->by_size) attributes["compared_by"] = "size";
    parts.append(py::make_tuple(part.name, along, part.first, part.count, attributes));
  }
  told["title"] = runs.facts().title;
  told["study"] = runs.study().text;
  told["case"] = runs.study().case_text;
  told["records"] = runs.facts().records;
  told["dimensions"] = dimensions;
  told["sizes"] = sizes;
  told["ida"] = runs.study().ida.has_value();
  told["runs"] = runs.plan().runs();
  told["coordinates"] = coordinates;
  told["parts"] = parts;
  return told;
}

/// A study over records, as `bentur gap STUDY --json` tells it.
std::string gap_study_text(const fs::path& file, const std::optional<double>& at, const py::object& progress) {
  Diagnostics found;
  Watcher watcher(progress);
  std::optional<GapStudy> study;
  try {
    const py::gil_scoped_release unlocked;
    study = gap_study(
        file, at,
        [&](double fraction) {
          if (!watcher(fraction)) throw std::runtime_error("stopped");
        },
        found);
  } catch (const std::runtime_error& error) {
    watcher.rethrow();
    raise_solve_error(error.what());
  }
  if (!study) raise_case_error(found);
  return gap_study_json(*study, BENTUR_VERSION);
}

/// Fits the outcomes of an incremental dynamic analysis, as `bentur fragility --json` tells them.
std::string fragility(const py::dict& told, const std::string& event, const py::dict& asked) {
  IdaResults results;
  results.title = told["title"].cast<std::string>();
  results.intensity = told["intensity"].cast<std::string>();
  results.units = told["units"].cast<std::string>();
  results.study_unit = told["study_unit"].cast<std::string>();
  results.quantity_units = told["quantity_units"].cast<std::string>();
  OutcomeTable& table = results.table;
  table.levels = told["levels"].cast<std::vector<double>>();
  table.cases = told["cases"].cast<std::size_t>();
  table.records = told["records"].cast<std::size_t>();
  table.together = told["together"].cast<std::size_t>();
  for (const int one : told["outcomes"].cast<std::vector<int>>()) table.outcomes.push_back(static_cast<Outcome>(one));
  for (const py::handle one : told["axes"]) {
    ResultAxis axis{one["name"].cast<std::string>(), one["size"].cast<std::size_t>(), {}};
    for (const py::handle coordinate : one["coordinates"]) {
      axis.coordinates.push_back({coordinate["name"].cast<std::string>(), coordinate["units"].cast<std::string>(),
                                  coordinate["parameter"].cast<std::string>(),
                                  coordinate["numbers"].cast<std::vector<double>>(),
                                  coordinate["texts"].cast<std::vector<std::string>>()});
    }
    results.axes.push_back(std::move(axis));
  }
  FragilityRequest request;
  request.event = event;
  request.bootstrap.resamples = asked["resamples"].cast<int>();
  request.bootstrap.confidence = asked["confidence"].cast<double>();
  request.bootstrap.seed = asked["seed"].cast<std::uint64_t>();
  request.at = asked["at"].cast<std::optional<double>>();
  request.probabilities = asked["probabilities"].cast<std::vector<double>>();
  request.along = asked["along"].cast<std::string>();
  std::string error;
  std::optional<FragilityReport> report;
  {
    const py::gil_scoped_release unlocked;
    report = fragility_report(std::move(results), request, error);
  }
  if (!report) throw py::value_error(error);
  return fragility_json(*report, request, BENTUR_VERSION);
}

py::tuple event_of(const std::string& text) {
  std::string error;
  const auto rule = parse_event(text, error);
  if (!rule) throw py::value_error("event \"" + text + "\" " + error);
  using C = EventRule::Comparison;
  const char* comparison = rule->comparison == C::more       ? ">"
                           : rule->comparison == C::at_least ? ">="
                           : rule->comparison == C::less     ? "<"
                                                             : "<=";
  return py::make_tuple(rule->quantity, comparison, rule->threshold);
}

}  // namespace

void bind_study(py::module_& module) {
  py::class_<PyStudy, std::shared_ptr<PyStudy>>(module, "Study")
      .def(py::init(&read), py::arg("file"))
      .def("description", &description)
      .def("solve", &PyStudy::solve, py::arg("first"), py::arg("count"))
      .def("stop", &PyStudy::stop);
  module.def("gap_study_json", &gap_study_text, py::arg("file"), py::arg("at"), py::arg("progress"));
  module.def("fragility_json", &fragility, py::arg("results"), py::arg("event"), py::arg("asked"));
  module.def("parse_event", &event_of, py::arg("text"));
  module.def("udunit", &udunit, py::arg("unit"));
  module.def("is_study", &is_study, py::arg("file"));
  module.def("index_title", [] { return index_title; });
}

}  // namespace bentur::python
