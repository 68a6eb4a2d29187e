#include <fmt/format.h>
#include <pybind11/eigen.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include "bentur/core/errors.h"
#include "bentur/io/case/case_memo.h"
#include "bentur/io/case/case_parts.h"
#include "bentur/io/file_identity.h"
#include "bentur/io/input_file.h"
#include "bentur/io/schema/case_keys.h"
#include "bentur/io/schema/file_names.h"
#include "bentur/io/toml/named_files.h"
#include "bentur/io/toml/parameter_path.h"
#include "bentur/io/toml/toml_view.h"
#include "bentur/io/toml/toml_writing.h"
#include "bentur/model/suite/suite.h"
#include "case_run.h"
#include "toml_python.h"

namespace py = pybind11;

namespace bentur::python {
namespace {

namespace fs = std::filesystem;

/// What cases that are made of others by with_values() share.
CaseMemo* shared_memo() {
  static const std::shared_ptr<CaseMemo> memo = CaseMemo::of_files_that_change();
  return memo.get();
}

std::shared_ptr<PyCase> read_unlocked(std::shared_ptr<const TomlValue> given, const std::string& name,
                                      const fs::path& folder, std::optional<CaseSource> source, CaseMemo* memo,
                                      Diagnostics& found) {
  auto made = std::make_shared<PyCase>();
  const TomlView view(*given, "", name, found);
  ReadCase parts = read_case_parts(view, folder, found, memo);
  if (found.ok() && !parts.plan) {
    try {
      made->problem = is_without_motion(parts.c) ? make_still_problem(parts.c) : parts.problem();
    } catch (const InvalidParameter& error) {
      found.error({name, 0, 0}, error.what());
    }
  }
  made->plan = std::move(parts.plan);
  made->c = std::move(parts.c);
  made->c.source = std::move(source);
  made->c.given = given;
  made->root = std::move(given);
  made->name = name;
  made->folder = folder;
  return made;
}

std::shared_ptr<PyCase> read_case(TomlValue root, const std::string& name, const fs::path& folder,
                                  std::optional<CaseSource> source, CaseMemo* memo = nullptr) {
  Diagnostics found;
  std::shared_ptr<PyCase> made;
  {
    // A law of Python's own must be taken and let go of with the lock.
    const bool has_own = has_own_law(root);
    std::optional<py::gil_scoped_release> unlocked;
    if (!has_own) unlocked.emplace();
    made = read_unlocked(std::make_shared<const TomlValue>(std::move(root)), name, folder, std::move(source),
                         has_own ? nullptr : memo, found);
  }
  if (!found.ok()) raise_case_error(found);
  return made;
}

std::shared_ptr<PyCase> from_text(const std::string& text, const std::string& name, const fs::path& folder) {
  Diagnostics found;
  std::optional<TomlValue> root = parse_toml(text, name, found);
  if (!root) raise_case_error(found);
  return read_case(std::move(*root), name, folder,
                   CaseSource{.file = fs::path(name).filename().string(), .text = text, .sha256 = sha256(text)});
}

std::shared_ptr<PyCase> from_file(const fs::path& file) {
  Diagnostics found;
  const std::optional<std::string> text = read_input(file, case_input, found);
  if (!text) raise_case_error(found);
  return from_text(*text, file.string(), file.parent_path());
}

std::shared_ptr<PyCase> with_values(const PyCase& given, const py::dict& values) {
  TomlValue root = *given.root;
  Diagnostics found;
  for (const auto& [key, value] : values) {
    const std::string text = py::str(key);
    std::string error;
    const auto path = parse_path(text, error);
    const auto place = path ? resolved(root, *path, error) : std::nullopt;
    if (!place) {
      Diagnostic& one = found.error(SourcePosition(), error);
      one.key = text;
      continue;
    }
    put_value(root, *place, toml_of(value, text));
  }
  if (!found.ok()) raise_case_error(found);
  return read_case(std::move(root), given.name, given.folder, std::nullopt, shared_memo());
}

/// The case of one record of its suite, from 1. Its values stay those of the whole case.
std::shared_ptr<PyCase> with_record(const PyCase& given, std::size_t record) {
  const auto& suite = given.c.excitation.suite;
  if (!suite) throw py::value_error("record is for a case with excitation.kind = \"suite\"");
  if (record == 0 || record > suite->records.size()) {
    throw py::value_error(fmt::format("record = {}, must be 1 to {}", record, suite->records.size()));
  }
  auto made = std::make_shared<PyCase>(given);
  made->c = case_of_record(given.c, record - 1);
  if (given.plan) {
    made->plan = make_plan_problem(made->c, given.plan->buildings);
  } else {
    made->problem = make_problem(made->c, given.problem.buildings);
  }
  return made;
}

py::dict excitation_of(const PyCase& given) {
  py::dict found;
  const ExcitationSpec& excitation = given.c.excitation;
  if (const auto* sampled = std::get_if<SampledMotion>(&excitation.motion)) {
    found["time_step"] = sampled->time_step;
    found["acceleration"] = array_of(sampled->acceleration);
  }
  found["delays"] = excitation.delays;
  return found;
}

bool are_same(const PyCase& a, const PyCase& b) {
  if (&a == &b) return true;
  std::error_code ignored;
  const auto whole = [&](const fs::path& folder) { return fs::absolute(folder, ignored).lexically_normal() / ""; };
  return whole(a.folder) == whole(b.folder) && same_content(*a.root, *b.root, are_equal);
}

}  // namespace

std::string PyCase::text_in(const fs::path& of) const {
  TomlValue moved = *root;
  bool is_moved = false;
  rename_files(moved, case_keys(), [&](const std::string& named) {
    if (fs::path(named).is_absolute()) return named;
    const std::string way = way_from(of, folder / named);
    is_moved = is_moved || fs::path(way).lexically_normal() != fs::path(named).lexically_normal();
    return way;
  });
  return c.source && !is_moved ? c.source->text : toml_file(is_moved ? moved : *root);
}

void bind_case(py::module_& module) {
  module.def(
      "toml_file", [](const py::dict& table) { return toml_file(toml_of(table)); }, py::arg("table"));
  py::class_<PyCase, std::shared_ptr<PyCase>>(module, "Case")
      .def_static("from_file", &from_file, py::arg("file"))
      .def_static("from_text", &from_text, py::arg("text"), py::arg("name"), py::arg("folder"))
      .def_static(
          "from_values",
          [](const py::dict& values, const std::string& name, const fs::path& folder) {
            return read_case(toml_of(values), name, folder, std::nullopt);
          },
          py::arg("values"), py::arg("name"), py::arg("folder"))
      .def("with_record", &with_record, py::arg("record"))
      .def_property_readonly(
          "records",
          [](const PyCase& c) { return c.c.excitation.suite ? c.c.excitation.suite->records.size() : std::size_t{0}; })
      .def("with_values", &with_values, py::arg("values"))
      .def("values", [](const PyCase& c) { return python_of(*c.root); })
      .def("is_same", &are_same, py::arg("other"))
      .def("text_in", &PyCase::text_in, py::arg("folder"))
      .def_property_readonly("has_own_law", [](const PyCase& c) { return has_own_law(*c.root); })
      .def_property_readonly("title", [](const PyCase& c) { return c.c.title; })
      .def_property_readonly("folder", [](const PyCase& c) { return c.folder; })
      .def_property_readonly("name", [](const PyCase& c) { return c.name; })
      .def_property_readonly(
          "text",
          [](const PyCase& c) -> py::object { return c.c.source ? py::object(py::str(c.c.source->text)) : py::none(); })
      .def_property_readonly("length", [](const PyCase& c) { return c.c.units.length; })
      .def_property_readonly("force", [](const PyCase& c) { return c.c.units.force; })
      .def_property_readonly("gravity", [](const PyCase& c) { return c.c.units.gravity; })
      .def_property_readonly("duration", [](const PyCase& c) { return c.c.analysis.duration; })
      .def_property_readonly("output_step", [](const PyCase& c) { return c.c.analysis.output_step; })
      .def_property_readonly("energy_audit", [](const PyCase& c) { return c.c.analysis.energy_audit; })
      .def_property_readonly("excitation", &excitation_of)
      .def_property_readonly("buildings",
                             [](const PyCase& c) {
                               std::vector<std::string> names;
                               for (const BuildingSpec& one : c.c.buildings) names.push_back(one.name);
                               return names;
                             })
      .def("matrices", [](const PyCase& c, std::size_t b) {
        py::dict found;
        const auto take = [&](const auto& model) {
          found["mass"] = model.mass;
          found["stiffness"] = model.stiffness;
          found["elevations"] = array_of(model.elevations);
        };
        if (c.plan) {
          take(c.plan->buildings.at(b).model);
        } else {
          take(c.problem.buildings.at(b).model);
        }
        return found;
      });
}

}  // namespace bentur::python
