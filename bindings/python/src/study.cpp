#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <algorithm>
#include <atomic>

#include "bentur/study/fragility/fragility_report.h"
#include "bentur/study/gap/gap_study.h"
#include "bentur/study/study_runs.h"
#include "bentur/study/study_variables.h"
#include "case_run.h"
#include "toml_python.h"

namespace py = pybind11;

namespace bentur::python {
namespace {

namespace fs = std::filesystem;

/// A study that has been read and checked.
class PyStudy {
 public:
  explicit PyStudy(std::unique_ptr<StudyRuns> runs) : runs_(std::move(runs)), results_(runs_->plan().runs()) {}

  [[nodiscard]] const StudyRuns& runs() const { return *runs_; }
  void stop() { stop_ = true; }

  /// Solves some runs, in the order of the plan, and keeps what they give. @return how many; fewer where it was
  /// stopped.
  std::size_t solve(std::size_t first, std::size_t count) {
    const py::gil_scoped_release unlocked;
    std::vector<std::size_t> numbers(count);
    for (std::size_t i = 0; i < count; ++i) numbers[i] = runs_->plan().run_at(first + i);
    std::vector<RunResult> found = runs_->solve(numbers, [&] { return !stop_.load(std::memory_order_relaxed); });
    for (RunResult& one : found) results_[one.run] = std::move(one);  // each run's own place: nobody else is there
    return found.size();
  }

  /// Attributes of the file, names of the dimensions of the runs, and each variable, once all runs are solved.
  [[nodiscard]] py::tuple variables() const {
    const StudyFile file = study_file(*runs_, BENTUR_VERSION);
    py::list found;
    for (const StudyVariable& one : file.variables) {
      ResultVariable variable = one;
      if (one.of_runs) variable.values = one.of_runs(results_);
      found.append(python_of(variable, py::none()));
    }
    return py::make_tuple(python_of(file.attributes), found);
  }

 private:
  std::unique_ptr<StudyRuns> runs_;
  std::vector<RunResult> results_;
  std::atomic<bool> stop_ = false;
};

std::shared_ptr<PyStudy> read(const fs::path& file) {
  Diagnostics found;
  std::optional<Study> study = read_study(file, found);
  if (study) check_names(*study, found);
  const auto memo = std::make_shared<CaseMemo>();
  std::optional<StudyFacts> facts = study ? check_study(*study, *memo, found) : std::nullopt;
  if (!facts || !found.ok()) raise_case_error(found);
  return std::make_shared<PyStudy>(std::make_unique<StudyRuns>(std::move(*study), std::move(*facts), memo));
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
      .def_property_readonly("title", [](const PyStudy& study) { return study.runs().facts().title; })
      .def_property_readonly("is_ida", [](const PyStudy& study) { return study.runs().study().ida.has_value(); })
      .def_property_readonly("runs", [](const PyStudy& study) { return study.runs().plan().runs(); })
      .def("variables", &PyStudy::variables)
      .def("solve", &PyStudy::solve, py::arg("first"), py::arg("count"))
      .def("stop", &PyStudy::stop);
  module.def("gap_study_json", &gap_study_text, py::arg("file"), py::arg("at"), py::arg("progress"));
  module.def("fragility_json", &fragility, py::arg("results"), py::arg("event"), py::arg("asked"));
  module.def("parse_event", &event_of, py::arg("text"));
  module.def("is_study", &is_study, py::arg("file"));
  module.def("index_title", [] { return index_title; });
}

}  // namespace bentur::python
