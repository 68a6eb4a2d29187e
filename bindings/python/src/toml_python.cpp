#include "toml_python.h"

#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <algorithm>

#include "bentur/io/toml/toml_view.h"
#include "python_law.h"

namespace py = pybind11;

namespace bentur::python {

TomlValue toml_of(const py::handle& value, const std::string& path) {
  TomlValue toml;
  if (py::isinstance<py::dict>(value)) {
    for (const auto& [key, member] : py::reinterpret_borrow<py::dict>(value)) {
      if (member.is_none()) continue;
      const std::string name = py::str(key);
      toml.members.push_back({name, 0, 0, toml_of(member, key_path(path, name))});
    }
    return toml;
  }
  if (py::isinstance<py::bool_>(value)) {
    toml.kind = TomlValue::Kind::boolean;
    toml.boolean = value.cast<bool>();
    return toml;
  }
  if (py::isinstance<py::int_>(value)) {
    toml.kind = TomlValue::Kind::integer;
    toml.integer = value.cast<std::int64_t>();
    toml.real = static_cast<double>(toml.integer);
    return toml;
  }
  if (PyFloat_CheckExact(value.ptr()) != 0) return toml_number(value.cast<double>());
  if (py::isinstance<py::str>(value)) return toml_text(value.cast<std::string>());
  if (py::isinstance<py::list>(value) || py::isinstance<py::tuple>(value)) {
    toml.kind = TomlValue::Kind::list;
    std::size_t index = 0;
    for (const py::handle item : py::reinterpret_borrow<py::sequence>(value)) {
      toml.items.push_back(toml_of(item, path + "[" + std::to_string(index++) + "]"));
    }
    return toml;
  }
  if (py::hasattr(value, "stands_for_law")) {
    toml.law = own_law(py::reinterpret_borrow<py::object>(value));
    toml.kind = TomlValue::Kind::text;
    toml.text = toml.law->name;
    return toml;
  }
  if (py::hasattr(value, "stands_for_numbers")) {
    const auto numbers = value.attr("values").cast<py::array_t<double, py::array::c_style | py::array::forcecast>>();
    return toml_numbers({numbers.data(), numbers.data() + numbers.size()});
  }
  if (py::hasattr(value, "tolist")) return toml_of(value.attr("tolist")(), path);
  throw py::type_error(path + " is a " + std::string(py::str(py::type::of(value).attr("__name__"))) +
                       ", must be a number, text, true or false, a list or a table");
}

bool has_own_law(const TomlValue& value) {
  const auto in_member = [](const TomlMember& member) { return has_own_law(member.value); };
  return value.law != nullptr || std::any_of(value.items.begin(), value.items.end(), has_own_law) ||
         std::any_of(value.members.begin(), value.members.end(), in_member);
}

bool are_equal(const OwnLaw& a, const OwnLaw& b) {
  return static_cast<const PyLaw&>(a).given.equal(static_cast<const PyLaw&>(b).given);
}

py::object python_of(const TomlValue& value) {
  switch (value.kind) {
    case TomlValue::Kind::table: {
      py::dict table;
      for (const TomlMember& member : value.members) table[py::str(member.key)] = python_of(member.value);
      return table;
    }
    case TomlValue::Kind::list: {
      if (value.numbers) {
        return py::array_t<double>(static_cast<py::ssize_t>(value.size()), value.numbers->data());
      }
      py::list list;
      for (const TomlValue& item : value.items) list.append(python_of(item));
      return list;
    }
    case TomlValue::Kind::integer:
      return py::int_(value.integer);
    case TomlValue::Kind::real:
      return py::float_(value.real);
    case TomlValue::Kind::boolean:
      return py::bool_(value.boolean);
    case TomlValue::Kind::text:
    case TomlValue::Kind::date:
      break;
  }
  if (value.law) return static_cast<const PyLaw&>(*value.law).given;
  return py::str(value.text);
}

void raise_case_error(const Diagnostics& diagnostics) {
  py::list errors;
  for (const Diagnostic& one : diagnostics.errors()) {
    // Of what was made in Python the place is a folder.
    const std::string file = one.position.file.ends_with('/') ? "" : one.position.file;
    errors.append(py::make_tuple(file, one.position.line, one.position.column, one.message(), one.key, one.value,
                                 one.rule, one.suggestion));
  }
  const py::object type = py::module_::import("bentur._errors").attr("CaseError");
  PyErr_SetObject(type.ptr(), type(errors).ptr());
  throw py::error_already_set();
}

void raise_error(const char* name, const std::string& message) {
  const py::object type = py::module_::import("bentur._errors").attr(name);
  PyErr_SetString(type.ptr(), message.c_str());
  throw py::error_already_set();
}

}  // namespace bentur::python
