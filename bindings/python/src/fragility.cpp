#include <pybind11/stl.h>

#include <optional>

#include "bentur/core/version.h"
#include "bentur/report/story_text.h"
#include "bentur/report/words.h"
#include "bentur/study/fragility/fragility_report.h"
#include "bentur/study/risk/risk_report.h"
#include "case_run.h"
#include "toml_python.h"

namespace py = pybind11;

namespace bentur::python {
namespace {

/// An xarray.Dataset of results, read as a file is. The lock must be held.
class DatasetSource final : public ResultSource {
 public:
  explicit DatasetSource(py::object dataset) : dataset_(std::move(dataset)) {
    for (const py::handle item : dataset_.attr("variables")) {
      const auto name = item.cast<std::string>();
      const py::object one = dataset_[item];
      variables_.push_back({.name = name,
                            .units = attribute(name, "units"),
                            .long_name = attribute(name, "long_name"),
                            .dimensions = py::list(one.attr("dims")).cast<std::vector<std::string>>(),
                            .shape = py::list(one.attr("shape")).cast<std::vector<std::size_t>>(),
                            .coordinates = {},
                            .text = std::string("OUT").find(kind(one)) != std::string::npos});
    }
  }

  [[nodiscard]] const std::vector<StoredVariable>& variables() const noexcept override { return variables_; }
  [[nodiscard]] std::size_t dimension_size(std::string_view dimension) const override {
    return dataset_.attr("sizes").attr("get")(dimension, 0).cast<std::size_t>();
  }
  [[nodiscard]] std::vector<double> numbers(std::string_view variable) const override {
    return values<double>(of(variable), "float");
  }
  [[nodiscard]] std::vector<double> numbers(std::string_view variable, std::size_t i) const override {
    return values<double>(of(variable)[py::int_(i)], "float");
  }
  [[nodiscard]] std::vector<std::string> texts(std::string_view variable) const override {
    return values<std::string>(of(variable), "str");
  }
  [[nodiscard]] std::string attribute(std::string_view variable, const std::string& attribute) const override {
    return py::str(of(variable).attr("attrs").attr("get")(attribute, ""));
  }
  [[nodiscard]] std::string attribute(const std::string& attribute) const override {
    return py::str(dataset_.attr("attrs").attr("get")(attribute, ""));
  }
  [[noreturn]] void fail(const std::string& why) const override { throw py::value_error("results: " + why); }

 private:
  [[nodiscard]] py::object of(std::string_view variable) const { return dataset_[py::cast(variable)]; }
  [[nodiscard]] static char kind(const py::object& one) { return one.attr("dtype").attr("kind").cast<char>(); }
  template <class Value>
  [[nodiscard]] static std::vector<Value> values(const py::object& one, const char* type) {
    return one.attr("to_numpy")().attr("astype")(type).attr("ravel")().attr("tolist")().cast<std::vector<Value>>();
  }

  py::object dataset_;
  std::vector<StoredVariable> variables_;
};

/// Fits the outcomes of an incremental dynamic analysis, as `bentur fragility --json` tells them.
std::string fragility(const py::object& dataset, const std::string& event, int resamples, double confidence,
                      std::uint64_t seed, const std::optional<double>& at, const std::vector<double>& probabilities,
                      const std::string& along, const std::string& method) {
  const FragilityRequest request{.event = event,
                                 .method = fragility_method(method),
                                 .bootstrap = {.resamples = resamples, .confidence = confidence, .seed = seed},
                                 .at = at,
                                 .probabilities = probabilities,
                                 .along = along};
  std::string error;
  const auto rule = parse_event(event, error);
  if (!rule) throw py::value_error("event \"" + event + "\" " + error);
  IdaResults results = read_ida_results(DatasetSource(dataset), *rule);
  std::optional<FragilityReport> report;
  {
    const py::gil_scoped_release unlocked;
    report = fragility_report(std::move(results), request, error);
  }
  if (!report) throw py::value_error(error);
  return fragility_json(*report, request, version());
}

/// Fragility times hazard, as `bentur risk --json` tells it, and in words.
/// @param hazard the name of a file, or with `is_text` what one holds
py::tuple risk(const py::object& dataset, const std::string& hazard, bool is_text, const std::string& event,
               const std::string& unit, const std::optional<long>& site, double years,
               const std::optional<double>& target, int resamples, double confidence, std::uint64_t seed,
               const std::string& method, const std::string& language) {
  const HazardOptions options{.site = site, .unit = unit};
  const RiskRequest request{.event = event,
                            .method = fragility_method(method),
                            .bootstrap = {.resamples = resamples, .confidence = confidence, .seed = seed},
                            .years = years,
                            .target = target};
  Diagnostics found;
  auto curve = is_text ? hazard_of(hazard, "", options, found) : read_hazard(hazard, options, found);
  if (!curve) raise_case_error(found);
  std::string error;
  const auto rule = parse_event(event, error);
  if (!rule) throw py::value_error("event \"" + event + "\" " + error);
  IdaResults results = read_ida_results(DatasetSource(dataset), *rule);
  std::optional<IdaResults> needed;
  if (target) needed = read_ida_results(DatasetSource(dataset), *parse_event(gap_needed_event, error));
  std::optional<RiskReport> report;
  {
    const py::gil_scoped_release unlocked;
    report = risk_report(std::move(results), needed, *std::move(curve), request, error);
  }
  if (!report) throw py::value_error("hazard " + error);
  const Words say(language);
  std::vector<std::string> lines =
      story_lines(std::vector<std::string>(), said(risk_story(*report, request).statements, say), say, Told::all);
  for (std::string& line : lines) line = with_spaces(std::move(line));
  return py::make_tuple(risk_json(*report, request, version()), lines);
}

}  // namespace

void bind_fragility(py::module_& module) {
  module.def("fragility_methods", &fragility_methods);
  module.def("fragility_json", &fragility, py::arg("results"), py::arg("event"), py::arg("resamples"),
             py::arg("confidence"), py::arg("seed"), py::arg("at"), py::arg("probabilities"), py::arg("along"),
             py::arg("method"));
  module.def("risk_json", &risk, py::arg("results"), py::arg("hazard"), py::arg("is_text"), py::arg("event"),
             py::arg("unit"), py::arg("site"), py::arg("years"), py::arg("target"), py::arg("resamples"),
             py::arg("confidence"), py::arg("seed"), py::arg("method"), py::arg("language"));
}

}  // namespace bentur::python
