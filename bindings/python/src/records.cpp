#include <pybind11/eigen.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <cmath>

#include "bentur/core/units.h"
#include "bentur/io/records/record_files.h"
#include "bentur/io/results/spectrum_files.h"
#include "bentur/solve/spectrum/response_spectrum.h"
#include "case_run.h"
#include "toml_python.h"

namespace py = pybind11;

namespace bentur::python {
namespace {

py::dict read_record(const std::filesystem::path& file, const std::string& format,
                     const std::optional<double>& time_step, const std::optional<int>& column,
                     const std::optional<int>& channel, const std::optional<std::string>& component, int skip_lines) {
  Diagnostics found;
  RecordOptions options{.format = format,
                        .time_step = time_step,
                        .column = column,
                        .channel = channel,
                        .component = component,
                        .skip_lines = skip_lines};
  const auto record = read_record(file, options, found);
  if (!record) raise_case_error(found);
  for (const RecordContradiction& one : contradictions(*record, options)) {
    found.error({.file = file.string(), .line = one.line, .column = one.line > 0 ? 1 : 0},
                one.key + " is " + one.given + ", but the file says " + one.said);
  }
  if (!found.ok()) raise_case_error(found);
  py::dict told;
  told["file"] = file.string();
  told["format"] = record->format;
  told["unit"] = record->unit;
  told["time_step"] = record->time_step;
  told["values"] = array_of(record->values);
  told["header_lines"] = record->header_lines;
  told["channel"] = record->channel;
  told["mean_removed"] = record->mean_removed;
  return told;
}

/// Peaks of oscillators, one row per period: displacement, pseudo-velocity, pseudo- and absolute acceleration.
Eigen::Matrix<double, Eigen::Dynamic, 4> spectrum(
    const py::array_t<double, py::array::c_style | py::array::forcecast>& values, double time_step, double factor,
    const std::vector<double>& periods, double damping) {
  SampledMotion motion{time_step, {values.data(), values.data() + values.size()}};
  for (double& a : motion.acceleration) a *= factor;
  std::vector<OscillatorPeaks> peaks;
  {
    const py::gil_scoped_release unlocked;
    peaks = response_spectrum(motion, periods, damping);
  }
  Eigen::Matrix<double, Eigen::Dynamic, 4> rows(std::ssize(peaks), 4);
  for (Eigen::Index i = 0; i < rows.rows(); ++i) {
    const OscillatorPeaks& p = peaks[static_cast<std::size_t>(i)];
    rows.row(i) << p.displacement, p.pseudo_velocity, p.pseudo_acceleration, p.absolute_acceleration;
  }
  return rows;
}

}  // namespace

void bind_records(py::module_& module) {
  module.def("read_record", &read_record, py::arg("file"), py::arg("format"), py::arg("time_step"), py::arg("column"),
             py::arg("channel"), py::arg("component"), py::arg("skip_lines"));
  module.def("response_spectrum", &spectrum, py::arg("values"), py::arg("time_step"), py::arg("factor"),
             py::arg("periods"), py::arg("damping"));
  module.def("logarithmic_periods",
             [](double first, double last, int count) { return array_of(logarithmic_periods(first, last, count)); });
  module.def("acceleration_factor", [](const std::string& unit, const std::string& length) {
    return acceleration_factor(unit, {.length = length, .force = "N", .gravity = standard_gravity(length)});
  });
}

}  // namespace bentur::python
