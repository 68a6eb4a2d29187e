#pragma once

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "bentur/io/case/case_parts.h"
#include "bentur/io/results/result_variable.h"
#include "bentur/io/toml/toml_value.h"
#include "bentur/model/plan/any_run.h"

namespace bentur::python {

/// A case with its problem, and the values it was read from, so that others can be put into it.
struct PyCase {
  Case c;
  Problem problem;                  ///< of a row
  std::optional<PlanProblem> plan;  ///< in its place, of buildings in plan
  std::shared_ptr<const TomlValue> root;
  std::string name;              ///< that messages carry
  std::filesystem::path folder;  ///< that record files are relative to

  /// The case as a file in a folder has it: the text that it was read from, where the files that it names are found
  /// from there too, else written anew.
  [[nodiscard]] std::string text_in(const std::filesystem::path& of) const;
};

/// A run and all that is reported of it. Arrays that Python gets look into it and keep it alive.
struct PyRun {
  AnyRun run;
  bool has_figures = false;  ///< what figures show beyond histories has been found
};

void bind_case(pybind11::module_& module);
void bind_run(pybind11::module_& module);
void bind_records(pybind11::module_& module);
void bind_study(pybind11::module_& module);
void bind_fragility(pybind11::module_& module);

/// Calls `progress` with the fraction done, no more than 20 times a second, and asks for Ctrl-C. What either raises
/// stops the work and is raised by rethrow().
class Watcher {
 public:
  explicit Watcher(pybind11::object progress) : progress_(std::move(progress)) {}
  /// Without the lock. @return whether to go on.
  bool operator()(double fraction);
  /// With the lock.
  void rethrow();

 private:
  pybind11::object progress_;
  std::unique_ptr<pybind11::error_already_set> error_;
  double asked_ = 0;  // [s]
};

/// A variable of results as Python has it: name, names of dimensions, values, attributes. Of values that are there as
/// long as `owner` nothing is copied.
[[nodiscard]] pybind11::tuple python_of(const ResultVariable& variable, const pybind11::object& owner);
[[nodiscard]] pybind11::dict python_of(const std::vector<ResultAttribute>& attributes);

/// An array of its own.
[[nodiscard]] pybind11::array_t<double> array_of(const std::vector<double>& values);

}  // namespace bentur::python
