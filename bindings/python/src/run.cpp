#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <chrono>
#include <filesystem>
#include <optional>
#include <utility>

#include "bentur/core/in_a_thread.h"
#include "bentur/core/version.h"
#include "bentur/io/case/case_toml.h"
#include "bentur/io/file_identity.h"
#include "bentur/io/output/atomic_file.h"
#include "bentur/io/results/result_csv.h"
#include "bentur/io/results/result_json.h"
#include "bentur/io/results/rules_json.h"
#include "bentur/io/results/run_variables.h"
#include "bentur/io/toml/toml_writing.h"
#include "bentur/model/gap/minimum_gap.h"
#include "bentur/model/limits.h"
#include "bentur/model/plan/plan_dense_run.h"
#include "bentur/model/plan/plan_places.h"
#include "bentur/model/plan/plan_row.h"
#include "bentur/model/story/story.h"
#include "bentur/pounding/pounding.h"
#include "bentur/report/html/report.h"
#include "bentur/report/kinds/figure_width.h"
#include "bentur/report/kinds/kinds.h"
#include "bentur/report/story_text.h"
#include "bentur/report/words.h"
#include "bentur/structure/modes.h"
#include "bentur/study/remedy/least_gap.h"
#include "bentur/study/sensitivity/sensitivity.h"
#include "case_run.h"
#include "python_law.h"
#include "toml_python.h"

namespace py = pybind11;
namespace fs = std::filesystem;

namespace bentur::python {

bool Watcher::operator()(double fraction) {
  if (error_) return false;
  const double now = std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
  if (now - asked_ < 0.05) return true;
  asked_ = now;
  const py::gil_scoped_acquire lock;
  try {
    if (PyErr_CheckSignals() != 0) throw py::error_already_set();
    if (!progress_.is_none()) progress_(fraction);
    return true;
  } catch (py::error_already_set& error) {
    error_ = std::make_unique<py::error_already_set>(error);
    return false;
  }
}

void Watcher::rethrow() {
  if (!error_) return;
  py::error_already_set error = *error_;
  error_.reset();
  throw error;
}

py::array_t<double> array_of(const std::vector<double>& values) {
  return py::array_t<double>(static_cast<py::ssize_t>(values.size()), values.data());
}

namespace {

void refuse(const std::string& refusal, const PyCase& given) {
  if (refusal.empty()) return;
  Diagnostics found;
  found.error({given.name, 0, 0}, refusal);
  raise_case_error(found);
}

/// What solve() gives, without the lock and told of. @throws what the watcher, or a law written in Python, has raised
template <class Solve>
auto watched(const PyCase& given, SolveOptions& options, const py::object& progress, const Solve& solve) {
  Watcher watcher(progress);
  if (!has_own_law(*given.root)) options.beside = in_a_thread;  // what such a law raises belongs to this thread
  options.progress = [&](double fraction) { return watcher(fraction); };
  decltype(solve()) response;
  {
    const py::gil_scoped_release unlocked;
    response = solve();
  }
  watcher.rethrow();
  rethrow_of_laws();
  if (response.status != Status::done && response.status != Status::collapsed)
    raise_error("SolveError", response.message);
  return response;
}

/// What gaps under a spectrum are told of, of buildings in plan as a row; and these gaps.
Problem still_of(const PyCase& given) { return given.plan ? row_of(*given.plan) : given.problem; }
SpectralGaps spectral_of(const PyCase& given) {
  const Case& c = given.c;
  return given.plan ? spectral_gaps(*given.plan, *c.excitation.spectrum, c.code, c.units)
                    : spectral_gaps(given.problem, *c.excitation.spectrum, c.code, c.units);
}

template <class AnyProblem>
std::shared_ptr<PyRun> solved_of(const PyCase& given, AnyProblem problem, std::optional<double> output_step,
                                 const py::object& progress) {
  const AnalysisSpec& analysis = given.c.analysis;
  SolveOptions options = solve_options(analysis);
  options.output_step = output_step.value_or(report_output_step(problem));
  if (!output_step) options.energy_step = analysis.output_step;
  options.course = options.output_step > 0;
  refuse(beyond_limits(given.c, problem, effort(problem, analysis.solver, options)), given);
  auto response = watched(given, options, progress, [&] { return solve(problem, analysis.solver, options); });
  const py::gil_scoped_release unlocked;
  return std::make_shared<PyRun>(PyRun{run_results(given.c, std::move(problem), std::move(response))});
}

/// With histories at so many seconds, or, with nothing, as a report needs them.
std::shared_ptr<PyRun> solved(const PyCase& given, std::optional<double> output_step, const py::object& progress) {
  if (Diagnostics found; refuse_without_motion(given.c, found)) raise_case_error(found);
  return given.plan ? solved_of(given, *given.plan, output_step, progress)
                    : solved_of(given, given.problem, output_step, progress);
}

std::string sensitivities(const PyCase& given, const std::vector<std::string>& numbers, const py::object& progress) {
  Watcher watcher(progress);
  Diagnostics found;
  std::optional<Sensitivity> result;
  {
    const py::gil_scoped_release unlocked;
    SensitivityOptions options{.numbers = numbers};
    options.progress = [&](double fraction) { return watcher(fraction); };
    result = sensitivity_of(*given.root, given.folder / given.name, options, found);
  }
  watcher.rethrow();
  rethrow_of_laws();
  if (!result) raise_case_error(found);
  return sensitivity_json(*result, version());
}

/// What `use` makes of a run, of a row or in plan.
template <class Run, class Use>
decltype(auto) with(Run& run, const Use& use) {
  return std::visit(use, run.run);
}

Case& case_of(PyRun& run) {
  return with(run, [](auto& of) -> Case& { return of.c; });
}

/// A case that was made in Python has no file: what it says as one, so that results tell what was run.
void tell_source(PyRun& run) {
  Case& c = case_of(run);
  if (c.source || c.given == nullptr) return;
  const std::string text = toml_file(*c.given);
  c.source = CaseSource{.file = "case.toml", .text = text, .sha256 = sha256(text)};
}

/// Attributes of the file, and each variable.
py::tuple variables(const std::shared_ptr<PyRun>& run) {
  tell_source(*run);
  const ResultFile file = with(*run, [](const auto& of) { return run_file(of, version()); });
  const py::object owner = py::cast(run);
  py::list found;
  for (const ResultVariable& one : file.variables) found.append(python_of(one, owner));
  return py::make_tuple(python_of(file.attributes), found);
}

/// The columns of the list of impacts that are numbers: key, unit, values, whether they are yes or no.
py::list impacts(const PyRun& run) {
  return with(run, [](const auto& of) {
    py::list found;
    const auto& seen = of.view();
    for (const Quantity* const one : quantities_of(Owner::impact, of.c.is_in_plan())) {
      std::vector<double> values;
      for (const QuantityPlace& at : first_places(std::ssize(of.response.impacts))) {
        values.push_back(value_of(*one, seen, at));
      }
      found.append(
          py::make_tuple(std::string(one->key), udunits(one->units, of.c.units), array_of(values), is_whole(*one)));
    }
    return found;
  });
}

std::string summary(PyRun& run) {
  tell_source(run);
  return with(run, [](const auto& of) { return summary_json(of, version()); });
}

const std::vector<Remark>& remarks_of(const PyRun& run) {
  return with(run, [](const auto& of) -> const std::vector<Remark>& { return of.remarks; });
}

std::string table_of_impacts(const PyRun& run) {
  return with(run, [](const auto& of) { return impacts_csv(of.view()); });
}

std::string gaps(PyRun& run) {
  tell_source(run);
  return with(run, [](const auto& of) { return gap_json(of, version()); });
}

/// Writes the results into a folder by the rules that the command line has. @return the names of the files.
std::vector<std::string> save(PyRun& run, const PyCase& of, const fs::path& folder,
                              const std::optional<py::bytes>& histories, const py::function& is_histories, bool force) {
  tell_source(run);
  OutputRules rules{
      .inputs = files_read(case_of(run)),
      .force = force,
      .is_netcdf = [&](const fs::path& file,
                       ResultKind kind) { return kind == ResultKind::histories && is_histories(file).cast<bool>(); },
      .forced_by = "force=True"};
  rules.inputs.push_back(of.name);
  try {
    AtomicFiles files(folder, rules);
    std::vector<std::string> names;
    const auto add = [&](const char* name, const std::string& content, ResultKind kind) {
      files.add(name, content, kind);
      names.emplace_back(name);
    };
    std::optional<CaseSource>& source = case_of(run).source;
    if (source) source->copied = !rules.is_input(folder / "case.toml");
    add("summary.json", summary(run), ResultKind::summary);
    add("impacts.csv", table_of_impacts(run), ResultKind::impacts);
    if (source && std::exchange(source->copied, false)) add("case.toml", source->text, ResultKind::case_copy);
    if (histories) {
      add("histories.nc", *histories, ResultKind::histories);
    } else if (fs::exists(folder / "histories.nc")) {
      throw RefusedOutput(folder / "histories.nc",
                          "is there already, and these results have no histories to replace it; give another folder");
    }
    files.commit();
    return names;
  } catch (const RefusedOutput& refused) {
    raise_error("RefusedOutput", refused.what());
  }
}

std::string modes(const PyCase& given, bool jacobi) {
  const auto told = [&](auto problem) {
    if (jacobi) {
      for (auto& building : problem.buildings) find_modes_by_jacobi(building);
    }
    return modes_json(problem, given.c.units);
  };
  return given.plan ? told(*given.plan) : told(given.problem);
}

/// The run with what figures show beyond histories.
const AnyRun& with_figures(PyRun& run) {
  if (!run.has_figures) with(run, [](auto& of) { find_figures(of); });
  run.has_figures = true;
  return run.run;
}

/// Kinds of figure that the run can give, each with what it shows.
std::vector<std::pair<std::string, std::string>> kinds_of(PyRun& run) {
  std::vector<std::pair<std::string, std::string>> kinds;
  const auto all = std::visit([](const auto& of) { return figure_kinds(of); }, with_figures(run));
  for (const FigureKind& kind : all) kinds.emplace_back(kind.name, kind.shows);
  return kinds;
}

/// @throws ValueError naming what the run can give.
std::string drawn(PyRun& run, const std::string& kind, const std::string& language, std::optional<double> width,
                  std::optional<double> start, std::optional<double> end, std::optional<std::size_t> gap,
                  std::optional<double> elevation) {
  FigureOptions options;
  options.say = figure_words(language);
  options.language = language;
  options.from = start;
  options.to = end;
  options.gap = gap;
  options.elevation = elevation;
  const auto make = [&](const FigureOptions& of) {
    return std::visit([&](const auto& results) { return make_figure(results, kind, of); }, with_figures(run));
  };
  try {
    return figure_svg(width ? figure_of_width(make, options, *width) : make(options));
  } catch (const NoFigure& error) {
    throw py::value_error(error.what());
  }
}

}  // namespace

void bind_run(py::module_& module) {
  py::class_<PyRun, std::shared_ptr<PyRun>>(module, "Run")
      .def("summary_json", &summary)
      .def("impacts_csv", &table_of_impacts)
      .def("gap_json", &gaps)
      .def("variables", &variables)
      .def("save", &save, py::arg("case"), py::arg("folder"), py::arg("histories"), py::arg("is_histories"),
           py::arg("force"))
      .def("impacts", &impacts)
      .def("lines",
           [](const PyRun& run, const std::string& language) {
             const Words say(language);
             const std::vector<std::string> gaps = with(run, [](const auto& of) { return gap_names(of.problem); });
             const Story story = with(run, [](const auto& of) { return run_story(of); });
             const std::vector<SaidStatement> all = said(story.statements, say);
             std::vector<std::string> lines = story_lines(gaps, all, say, Told::outcome);
             if (const auto known = known_table(gaps, all, say)) {
               for (std::string& line : rows_in_words(*known)) lines.push_back(std::move(line));
             }
             for (std::string& line : lines) line = with_spaces(std::move(line));
             return lines;
           })
      .def_property_readonly("remark_count", [](const PyRun& run) { return remarks_of(run).size(); })
      .def("remarks",
           [](const PyRun& run, const std::string& language) {
             std::vector<std::string> texts;
             for (const SaidStatement& one : said(remark_statements(remarks_of(run)), Words(language))) {
               texts.push_back(with_spaces(one.text));
             }
             return texts;
           })
      .def(
          "report_html",
          [](PyRun& run, const std::string& language, const PyCase* given) {
            ReportOptions options{.language = language, .version = std::string(version())};
            tell_source(run);
            if (given != nullptr) {
              options.sensitivity = sensitivity_of_report(given->c, given->folder / fs::path(given->name).filename());
            }
            return std::visit([&](const auto& of) { return report_html(of, options); }, with_figures(run));
          },
          py::arg("language") = "en", py::arg("case") = py::none())
      .def("figure_kinds", &kinds_of)
      .def("figure_svg", &drawn, py::arg("kind"), py::arg("language"), py::arg("width"), py::arg("start"),
           py::arg("end"), py::arg("gap"), py::arg("elevation"));

  module.def("palette", &palette);
  module.def("building_colours", &building_colours);
  module.def("solve", &solved, py::arg("case"), py::arg("output_step"), py::arg("progress"));
  module.def(
      "gap_json",
      [](const PyCase& given, const py::object& progress) {
        const Case& c = given.c;
        if (!c.excitation.spectrum) return gaps(*solved(given, 0, progress));
        return spectral_gap_json(c, still_of(given), spectral_of(given), version());
      },
      py::arg("case"), py::arg("progress"));
  module.def(
      "least_gap_json",
      [](const PyCase& given, const py::object& progress) {
        const Case& c = given.c;
        if (c.excitation.spectrum) {
          return least_gap_json(least_gaps(c, still_of(given), spectral_of(given)), version());
        }
        const std::shared_ptr<PyRun> run = solved(given, 0, progress);
        return least_gap_json(with(*run, [](const auto& of) { return least_gaps(of); }), version());
      },
      py::arg("case"), py::arg("progress"));
  module.def("sensitivity_json", &sensitivities, py::arg("case"), py::arg("numbers"), py::arg("progress"));
  module.def(
      "height_rules_json",
      [](const PyCase& given) {
        if (given.plan) return height_rules_json(given.c, *given.plan, version());
        return height_rules_json(given.c, given.problem, version());
      },
      py::arg("case"));
  module.def("modes_json", &modes, py::arg("case"), py::arg("jacobi"));
}

}  // namespace bentur::python
