/// bentur._core: what the package bentur of Python is made on. Names, checks and results for people are in the package.

#include <pybind11/pybind11.h>

#include "bentur/core/version.h"
#include "bentur/io/schema/case_keys.h"
#include "bentur/io/schema/json_schema.h"
#include "bentur/study/design/study_keys.h"
#include "case_run.h"

namespace py = pybind11;

PYBIND11_MODULE(_core, module) {
  module.doc() = "The compiled part of bentur.";
  module.attr("pybind11") = py::make_tuple(PYBIND11_VERSION_MAJOR, PYBIND11_VERSION_MINOR);
  module.attr("version") = std::string(bentur::version());
  module.def("schema", [](bool study) {
    return study ? bentur::json_schema(bentur::study_keys(), "A study of bentur")
                 : bentur::json_schema(bentur::case_keys(), "A case of bentur");
  });
  bentur::python::bind_case(module);
  bentur::python::bind_run(module);
  bentur::python::bind_records(module);
  bentur::python::bind_study(module);
  bentur::python::bind_fragility(module);
}
