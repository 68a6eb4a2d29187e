#include <fmt/format.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <atomic>
#include <chrono>
#include <map>
#include <mutex>
#include <optional>

#include "bentur/core/version.h"
#include "bentur/io/case/case_toml.h"
#include "bentur/study/gap/gap_study.h"
#include "bentur/study/remedy/least_gap.h"
#include "bentur/study/remedy/remedy.h"
#include "bentur/study/study_output.h"
#include "bentur/study/study_variables.h"
#include "bentur/study/suite/suite_run.h"
#include "case_run.h"
#include "python_law.h"
#include "toml_python.h"

namespace py = pybind11;

namespace bentur::python {
namespace {

namespace fs = std::filesystem;

/// A study that has been read and checked, and what its runs have given: kept here, or in the journal of its file.
class PyStudy {
 public:
  explicit PyStudy(std::unique_ptr<StudyRuns> runs, std::vector<std::shared_ptr<const PyCase>> cases = {})
      : runs_(std::move(runs)), cases_(std::move(cases)) {}

  [[nodiscard]] const StudyRuns& runs() const { return *runs_; }
  void stop() { stop_ = true; }

  /// Begins a file of results, or goes on with one. @return false where the results are there already.
  /// @param attributes of a NetCDF file that bentur has written, by its kind ("sweep" or "ida"); else none
  bool begin(const fs::path& file, bool resume, bool force, const py::function& attributes) {
    using Texts = std::optional<std::map<std::string, std::string>>;
    const bool ida = runs_->study().ida.has_value();
    const auto read = [attributes, ida](const fs::path& of) { return attributes(of, ida).cast<Texts>(); };
    try {
      output_.emplace(
          *runs_, StudyOutputOptions{
                      .kind = ida ? StudyKind::ida : StudyKind::sweep,
                      .output = file,
                      .resume = resume,
                      .force = force,
                      .version = std::string(version()),
                      .resumed_by = "resume=True",
                      .forced_by = "force=True",
                      .is_netcdf = [read](const fs::path& of, ResultKind /*kind*/) { return read(of).has_value(); },
                      .attribute = [read](const fs::path& of, const std::string& name) { return (*read(of))[name]; }});
      if (output_->is_finished()) return false;
      journal_.emplace(output_->begin());
      return true;
    } catch (const RefusedOutput& refused) {
      raise_error("RefusedOutput", refused.what());
    }
  }

  /// Solves some runs, in the order of the plan, and keeps what they give. @return how many are done of them; fewer
  /// where it was stopped.
  std::size_t solve(std::size_t first, std::size_t count) {
    std::size_t done = 0;
    {
      const py::gil_scoped_release unlocked;
      const std::vector<std::size_t> numbers = left(first, count);
      done = count - numbers.size();
      const auto goes_on = [&] { return !stop_.load(std::memory_order_relaxed); };
      std::vector<RunResult> found = cases_.empty() ? runs_->solve(numbers, goes_on) : solved_cases(numbers, goes_on);
      done += found.size();
      if (!law_has_raised()) keep(std::move(found));
    }
    rethrow_of_laws();
    return done;
  }

  /// Attributes of the file, and each variable, once all runs are solved.
  [[nodiscard]] py::tuple variables() const {
    const StudyFile file = study_file(*runs_, version());
    const std::vector<RunResult> results = journal_ ? journal_->read(0, runs_->design().runs()) : results_;
    py::list found;
    for (const StudyVariable& one : file.variables) {
      ResultVariable variable = one;
      if (one.of_runs) variable.values = one.of_runs(results);
      found.append(python_of(variable, py::none()));
    }
    return py::make_tuple(python_of(file.attributes), found);
  }

  /// The file of results, once `write` has made it under the name that it is given.
  void finish(const py::function& write) {
    try {
      output_->finish([&](const fs::path& file) { write(file); });
    } catch (const RefusedOutput& refused) {
      raise_error("RefusedOutput", refused.what());
    }
  }

  /// Lets others go on with the journal, where it is left.
  void close() {
    if (journal_) journal_->sync();
    journal_.reset();
  }

 private:
  [[nodiscard]] std::vector<RunResult> solved_cases(const std::vector<std::size_t>& numbers,
                                                    const std::function<bool()>& goes_on) const {
    std::vector<RunResult> found;
    for (const std::size_t run : numbers) {
      if (!goes_on()) break;
      const PyCase& one = *cases_[run];
      auto result = one.plan ? runs_->solve_case(run, one.c, *one.plan, goes_on)
                             : runs_->solve_case(run, one.c, one.problem, goes_on);
      if (!result) break;
      found.push_back(*std::move(result));
    }
    return found;
  }

  /// Of some runs those that no journal has.
  std::vector<std::size_t> left(std::size_t first, std::size_t count) {
    const std::lock_guard lock(mutex_);
    std::vector<std::size_t> numbers;
    for (std::size_t i = first; i < first + count; ++i) {
      const std::size_t run = runs_->design().run_at(i);
      if (!journal_ || !journal_->is_done(run)) numbers.push_back(run);
    }
    return numbers;
  }

  void keep(std::vector<RunResult> found) {
    const std::lock_guard lock(mutex_);
    if (!journal_) {
      results_.resize(runs_->design().runs());
      for (RunResult& one : found) results_[one.run] = std::move(one);
      return;
    }
    for (const RunResult& one : found) journal_->write(one);
    const auto now = std::chrono::steady_clock::now();
    if (now - synced_ < std::chrono::seconds(2)) return;
    journal_->sync();
    synced_ = now;
  }

  std::unique_ptr<StudyRuns> runs_;
  const std::vector<std::shared_ptr<const PyCase>> cases_;  // one per run; none: the study makes them
  std::optional<StudyOutput> output_;
  std::mutex mutex_;  // of what follows
  std::optional<Journal> journal_;
  std::vector<RunResult> results_;
  std::chrono::steady_clock::time_point synced_ = std::chrono::steady_clock::now();
  std::atomic<bool> stop_ = false;
};

std::shared_ptr<PyStudy> checked(std::unique_ptr<StudyRuns> runs, const Diagnostics& found) {
  if (!runs) raise_case_error(found);
  return std::make_shared<PyStudy>(std::move(runs));
}

/// By threads of Python's, each with a part of the numbers. @param for_each for_each(count, part), which calls
/// part(from, to) so that each number below the count is in one part
ForEachNumber by_threads_of(const py::object& for_each) {
  return [&for_each](std::size_t count, const std::function<void(std::size_t)>& work) {
    const py::gil_scoped_acquire locked;
    for_each(count, py::cpp_function([&work](std::size_t from, std::size_t to) {
               const py::gil_scoped_release unlocked;
               for (std::size_t i = from; i < to; ++i) work(i);
             }));
  };
}

std::shared_ptr<PyStudy> read_study(const fs::path& file, bool ida, const py::object& for_each) {
  Diagnostics found;
  std::unique_ptr<StudyRuns> runs;
  {
    const py::gil_scoped_release unlocked;
    runs = checked_runs(file, ida ? StudyKind::ida : StudyKind::sweep, "bentur.", found, by_threads_of(for_each));
  }
  return checked(std::move(runs), found);
}

/// A study of a case that is there. @param text,case_text what the results keep of both
std::shared_ptr<PyStudy> of_values(const PyCase& of, const py::dict& tables, const std::string& text,
                                   const std::string& case_text, const py::object& for_each) {
  Diagnostics found;
  Study start;
  start.file = of.folder / "";
  start.case_file = of.folder / fs::path(of.name).filename();
  start.text = text;
  start.case_text = case_text;
  start.case_root = *of.root;
  const TomlValue given = toml_of(tables);
  std::unique_ptr<StudyRuns> runs;
  {
    // A law of Python's own must be taken and let go of with the lock, which a single thread can hold.
    const bool has_own = has_own_law(given) || has_own_law(start.case_root);
    std::optional<py::gil_scoped_release> unlocked;
    if (!has_own) unlocked.emplace();
    std::optional<Study> study = read_study(given, std::move(start), found);
    if (study)
      runs = checked_runs(std::move(*study), found,
                          has_own ? ForEachNumber(one_after_the_other) : by_threads_of(for_each));
  }
  return checked(std::move(runs), found);
}

/// Cases that are there, one after the other, as a study whose runs they are.
std::shared_ptr<PyStudy> of_cases(const std::vector<std::shared_ptr<PyCase>>& cases,
                                  const std::vector<std::string>& labels) {
  const PyCase& first = *cases.at(0);
  StudyFacts facts;
  facts.problem = first.problem;
  if (first.plan) facts.plan = first.plan;
  facts.units = first.c.units;
  facts.title = first.c.title;
  facts.energy_audit = first.c.analysis.energy_audit;
  for (std::size_t i = 0; i < cases.size(); ++i) {
    const PyCase& one = *cases[i];
    const auto refuse = [&](const char* why) { throw py::value_error(fmt::format("cases[{}] {}", i, why)); };
    Diagnostics found;
    if (refuse_without_motion(one.c, found)) raise_case_error(found);
    const Units &a = one.c.units, &b = facts.units;
    if (a.length != b.length || a.force != b.force || a.gravity != b.gravity) refuse("has other units than cases[0]");
    if (one.plan.has_value() != first.plan.has_value()) refuse("is not in plan or in a row as cases[0] is");
    if (one.c.analysis.energy_audit != facts.energy_audit) refuse("has another analysis.energy_audit than cases[0]");
    if (!(one.plan ? take_places(*one.plan, facts) : take_places(one.problem, facts))) {
      refuse("has other numbers of floors, contact points or links than cases[0], or other buildings that can yield");
    }
  }
  Study study;
  study.case_file = first.folder / "case.toml";
  study.case_root = *first.root;
  study.case_text = first.text_in(first.folder);
  study.axes = {"case"};
  Vary vary;
  vary.parameter = vary.name = "case";
  vary.path = {PathStep("title")};
  for (std::size_t i = 0; i < cases.size(); ++i) vary.values.push_back(toml_number(static_cast<double>(i)));
  vary.labels = labels;
  study.varies = {std::move(vary)};
  auto runs = std::make_unique<StudyRuns>(std::move(study), std::move(facts), std::make_shared<CaseMemo>());
  return std::make_shared<PyStudy>(std::move(runs),
                                   std::vector<std::shared_ptr<const PyCase>>(cases.begin(), cases.end()));
}

/// A study over records, as `bentur gap STUDY --json` tells it.
std::string gap_study_text(const fs::path& file, const std::optional<double>& at, const py::object& progress) {
  Diagnostics found;
  Watcher watcher(progress);
  std::optional<GapStudy> study;
  try {
    const py::gil_scoped_release unlocked;
    study = gap_study(
        file, at,
        [&](double fraction) {
          if (!watcher(fraction)) throw std::runtime_error("stopped");
          return true;
        },
        found);
  } catch (const std::runtime_error& error) {
    watcher.rethrow();
    raise_error("SolveError", error.what());
  }
  if (!study) raise_case_error(found);
  return gap_study_json(*study, version());
}

/// A search for a remedy, as `bentur remedy --json` tells it. @param journal where what is tried is kept, if anywhere
std::string remedy_text(const fs::path& file, const fs::path& journal, bool resume, const py::object& progress) {
  Diagnostics found;
  Watcher watcher(progress);
  std::optional<RemedySearch> search;
  try {
    const py::gil_scoped_release unlocked;
    search = seek_remedy(file,
                         {.journal = journal,
                          .resume = resume,
                          .version = std::string(version()),
                          .resumed_by = "resume=True",
                          .goes_on = [&](double fraction) { return watcher(fraction); }},
                         found);
  } catch (const std::runtime_error& error) {
    watcher.rethrow();
    raise_error("RefusedOutput", error.what());
  }
  watcher.rethrow();
  if (!search) raise_case_error(found);
  return remedy_json(*search, version());
}

/// The gaps over the records of a case's suite.
GapStudy suite_gaps(const PyCase& given, const py::object& progress) {
  Diagnostics found;
  Watcher watcher(progress);
  std::optional<GapStudy> study;
  try {
    const py::gil_scoped_release unlocked;
    study = gap_study(
        given.c, given.folder / fs::path(given.name).filename(), [&](double fraction) { return watcher(fraction); },
        found);
  } catch (const std::runtime_error& error) {
    watcher.rethrow();
    raise_error("SolveError", error.what());
  }
  watcher.rethrow();
  if (!study) raise_case_error(found);
  return *std::move(study);
}

/// A case's suite: what happens under its records, and the gaps over them. `progress` goes from 0 to 1 in each.
struct SuiteResults {
  SuiteRun run;
  GapStudy gaps;
};
SuiteResults suite_results(const PyCase& given, const py::object& progress) {
  if (!given.c.excitation.suite) throw py::value_error("the case has no suite: excitation.kind must be \"suite\"");
  Watcher watcher(progress);
  std::optional<SuiteRun> run;
  {
    const py::gil_scoped_release unlocked;
    run = run_suite(given.c, [&](double fraction) { return watcher(fraction); });
  }
  watcher.rethrow();
  GapStudy gaps = run->all_ran() ? suite_gaps(given, progress) : GapStudy();
  return {*std::move(run), std::move(gaps)};
}

}  // namespace

void bind_study(py::module_& module) {
  py::class_<PyStudy, std::shared_ptr<PyStudy>>(module, "Study")
      .def(py::init(&read_study), py::arg("file"), py::arg("ida"), py::arg("for_each"))
      .def(py::init(&of_values), py::arg("case"), py::arg("tables"), py::arg("text"), py::arg("case_text"),
           py::arg("for_each"))
      .def_static("of_cases", &of_cases, py::arg("cases"), py::arg("labels"))
      .def_property_readonly("title", [](const PyStudy& study) { return study.runs().facts().title; })
      .def_property_readonly("runs", [](const PyStudy& study) { return study.runs().design().runs(); })
      .def("begin", &PyStudy::begin, py::arg("file"), py::arg("resume"), py::arg("force"), py::arg("attributes"))
      .def("variables", &PyStudy::variables)
      .def("finish", &PyStudy::finish, py::arg("write"))
      .def("close", &PyStudy::close)
      .def("solve", &PyStudy::solve, py::arg("first"), py::arg("count"))
      .def("stop", &PyStudy::stop);
  module.def(
      "suite_gap_json",
      [](const PyCase& given, const py::object& progress) {
        const SuiteResults found = suite_results(given, progress);
        return gap_study_json(found.gaps, version(), suite_said_json(found.run, found.gaps));
      },
      py::arg("case"), py::arg("progress"));
  module.def(
      "suite_run_json",
      [](const PyCase& given, const py::object& progress) {
        const SuiteResults found = suite_results(given, progress);
        return suite_run_json(found.run, found.gaps, version());
      },
      py::arg("case"), py::arg("progress"));
  module.def("gap_study_json", &gap_study_text, py::arg("file"), py::arg("at"), py::arg("progress"));
  module.def("remedy_json", &remedy_text, py::arg("file"), py::arg("journal"), py::arg("resume"), py::arg("progress"));
  module.def(
      "suite_least_gap_json",
      [](const PyCase& given, const py::object& progress) {
        const SuiteResults found = suite_results(given, progress);
        return least_gap_json(least_gaps(found.run, found.gaps), version());
      },
      py::arg("case"), py::arg("progress"));
  module.def("is_study", &is_study, py::arg("file"));
}

}  // namespace bentur::python
