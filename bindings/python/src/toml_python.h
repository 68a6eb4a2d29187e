#pragma once

#include <pybind11/pybind11.h>

#include <string>

#include "bentur/core/diagnostics.h"
#include "bentur/io/toml/toml_value.h"

namespace bentur::python {

/// A value as Python has it, into what a case is read from: dict, list or tuple, str, bool, int, float, and whatever
/// has tolist() (NumPy's arrays and numbers), and laws of Python's own. Members that are None are left out.
/// @throws a Python TypeError, naming the key, for anything else.
[[nodiscard]] TomlValue toml_of(const pybind11::handle& value, const std::string& path = "");

/// Whether a law of Python's own stands anywhere in it: then what is read of it needs the lock.
[[nodiscard]] bool has_own_law(const TomlValue& value);

/// Whether two laws of Python's own are equal, as Python has it.
[[nodiscard]] bool are_equal(const OwnLaw& a, const OwnLaw& b);

/// The same in the other direction.
[[nodiscard]] pybind11::object python_of(const TomlValue& value);

/// Raises bentur.CaseError with all errors: (file, line, column, message) each.
[[noreturn]] void raise_case_error(const Diagnostics& diagnostics);

/// Raises bentur.SolveError, or another one of bentur's.
[[noreturn]] void raise_error(const char* name, const std::string& message);

}  // namespace bentur::python
