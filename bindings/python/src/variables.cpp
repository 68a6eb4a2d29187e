#include <pybind11/stl.h>

#include "case_run.h"

namespace py = pybind11;

namespace bentur::python {
namespace {

py::object values_of(const ResultVariable& variable, const py::object& owner) {
  std::vector<py::ssize_t> shape;
  for (const ResultDimension& dimension : variable.dimensions)
    shape.push_back(static_cast<py::ssize_t>(dimension.size));
  if (const auto* texts = std::get_if<std::vector<std::string>>(&variable.values)) {
    return py::module_::import("numpy").attr("array")(*texts, py::arg("dtype") = "O").attr("reshape")(shape);
  }
  if (const auto* there = std::get_if<std::span<const double>>(&variable.values)) {
    py::array_t<double> view(shape, there->data(), owner);
    view.attr("setflags")(false);
    return view;
  }
  if (const auto* made = std::get_if<std::vector<double>>(&variable.values)) {
    return py::array_t<double>(shape, made->data());
  }
  if (const auto* whole = std::get_if<std::vector<int>>(&variable.values))
    return py::array_t<int>(shape, whole->data());
  return py::array_t<signed char>(shape, std::get<std::vector<signed char>>(variable.values).data());
}

}  // namespace

py::dict python_of(const std::vector<ResultAttribute>& given) {
  py::dict attributes;
  for (const auto& [name, value] : given) {
    if (const auto* flags = std::get_if<std::vector<signed char>>(&value)) {
      attributes[py::str(name)] = py::array_t<signed char>(std::ssize(*flags), flags->data());
    } else if (const auto* number = std::get_if<double>(&value)) {
      attributes[py::str(name)] = *number;
    } else {
      attributes[py::str(name)] = std::get<std::string>(value);
    }
  }
  return attributes;
}

py::tuple python_of(const ResultVariable& variable, const py::object& owner) {
  std::vector<std::string> dimensions;
  for (const ResultDimension& dimension : variable.dimensions) dimensions.push_back(dimension.name);
  py::dict attributes;
  if (!variable.units.empty()) attributes["units"] = variable.units;
  attributes["long_name"] = variable.long_name;
  for (const auto& [key, value] : python_of(variable.attributes)) attributes[key] = value;
  return py::make_tuple(variable.name, py::tuple(py::cast(dimensions)), values_of(variable, owner), attributes);
}

}  // namespace bentur::python
