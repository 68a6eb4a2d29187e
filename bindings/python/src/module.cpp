/// bentur._core: what the package bentur of Python is made on. Names, checks and results for people are in the package.

#include <pybind11/pybind11.h>

#include "case_run.h"

PYBIND11_MODULE(_core, module) {
  module.doc() = "The compiled part of bentur.";
  module.attr("version") = BENTUR_VERSION;
  bentur::python::bind_laws(module);
  bentur::python::bind_case(module);
  bentur::python::bind_run(module);
  bentur::python::bind_records(module);
  bentur::python::bind_study(module);
}
