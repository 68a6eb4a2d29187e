#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <optional>

#include "arguments.h"
#include "bentur/core/version.h"
#include "bentur/files/netcdf_kind.h"
#include "bentur/files/result_netcdf.h"
#include "bentur/io/results/result_csv.h"
#include "bentur/io/results/result_json.h"
#include "bentur/model/plan/plan_dense_run.h"
#include "bentur/model/plan/plan_places.h"
#include "bentur/model/story/story.h"
#include "bentur/report/errors.h"
#include "bentur/report/files/figure_files.h"
#include "bentur/report/files/picture.h"
#include "bentur/report/kinds/kinds.h"
#include "bentur/report/run_tables.h"
#include "bentur/report/words.h"
#include "cases/suite.h"
#include "commands.h"
#include "output/output.h"
#include "output/picture.h"
#include "session.h"
#include "text/table.h"

namespace bentur::cli {
namespace {

struct RunArguments {
  std::string file;
  std::string directory;
  std::vector<std::string> figures;  // their formats
  std::optional<int> record;         // of a suite, from 1
  bool json = false;
  bool quiet = false;
  bool force = false;
  std::string language = "en";
};

std::string text_of(const RunTable& table) {
  Table made;
  for (const TableColumn& column : table.columns) made.add(column.label, column.unit, column.cells);
  return made.text();
}

/// A table below its heading; empty where there is none.
std::string under(const std::string& heading, const RunTable& table) {
  return table.is_empty() ? "" : "\n" + heading + "\n\n" + text_of(table);
}

/// What decides the law beside its stiffness and the restitution asked for: "damping_ratio 0.1359".
std::string parameter_text(const ContactLaw& law) {
  for (const auto& [name, value] : law.parameters()) {
    if (name != "stiffness" && name != "restitution") {
      return fmt::format("{} {}", name, number(value));
    }
  }
  return "–";
}

/// "0.6500", or "0.6312 to 0.6644" where the impacts differ.
std::string range_text(const PointRestitution& restitution, const Words& say) {
  if (!restitution.smallest) {
    return "–";
  }
  const std::string smallest = fmt::format("{:.4f}", *restitution.smallest);
  const std::string largest = fmt::format("{:.4f}", *restitution.largest);
  return smallest == largest ? smallest : smallest + say("cli.to") + largest;
}

/// The law of every contact point, the restitution it was asked for and the range its impacts had; empty where all are
/// linear springs, of which there is nothing to say.
std::string law_text(const RunResults& run, const RunView& view, const Words& say) {
  const std::vector<GapSpec>& gaps = run.c.gaps;
  if (std::all_of(gaps.begin(), gaps.end(), [](const GapSpec& gap) { return gap.contact.law == "linear"; })) {
    return "";
  }
  const std::vector<PointRestitution>& restitution = view.restitutions;
  const bool single_points =
      std::all_of(gaps.begin(), gaps.end(), [](const GapSpec& gap) { return gap.elevations.size() <= 1; });
  std::vector<std::string> between, law, choices, parameter, asked, obtained;
  std::vector<double> elevation;
  for (Eigen::Index gap = 0; gap < std::ssize(gaps); ++gap) {
    std::string made;
    for (const auto& [name, word] : gaps[gap].contact.choices()) {
      made += (made.empty() ? "" : ", ") + word;
    }
    const std::vector<Eigen::Index> points = gap_at(run.problem, gap).points;
    for (auto point = points.rbegin(); point != points.rend(); ++point) {
      const Eigen::Index i = *point;
      between.push_back(gap_name(run.problem, gap));
      elevation.push_back(run.problem.points[i].elevation);
      law.push_back(gaps[gap].contact.law);
      choices.push_back(made);
      parameter.push_back(parameter_text(*run.problem.points[i].law));
      asked.push_back(restitution[i].asked ? number(*restitution[i].asked) : "–");
      obtained.push_back(range_text(restitution[i], say));
    }
  }
  Table table;
  if (gaps.size() > 1) {
    table.add(say("cli.gap"), "", between);
  }
  if (!single_points) {
    table.add(say("column.elevation"), run.c.units.length, elevation);
  }
  table.add(say("cli.law"), "", law);
  table.add(say("cli.choices"), "", choices);
  table.add(say("cli.parameter"), "", parameter);
  table.add(say("cli.asked"), "", asked);
  table.add(say("cli.obtained"), "", obtained);
  const bool pushed = std::any_of(restitution.begin(), restitution.end(),
                                  [](const PointRestitution& one) { return one.largest > 1.0; });
  const std::string note = pushed ? wrapped(say("cli.pushed")) + "\n" : "";
  return "\n" + say("cli.laws") + "\n\n" + table.text() + note;
}

/// The base shear of a building of a row over its weight, and what one compares first; of what moves nothing.
std::vector<std::string> proportions_of(const RunResults& run, const Words& say) {
  std::vector<std::string> lines;
  const ShownUnits shown = shown_units(run);
  for (std::size_t b = 0; b < run.problem.buildings.size(); ++b) {
    const Building& building = run.problem.buildings[b];
    lines.emplace_back();
    if (building.is_rigid()) continue;
    const Proportions found = proportions(building, run.c.units, &run.response.buildings[b]);
    const auto& coefficient = found.base_shear_coefficient;
    lines.back() = say("cli.base_shear", {{"coefficient", coefficient ? number(*coefficient) : "–"},
                                          {"proportions", proportions_text(building, found, shown, say)}});
  }
  return lines;
}

/// Points, laws, links and buildings, as tables. @param below the floors of each building, a line
std::string tables_text(const RunTables& tables, const std::vector<PointSummary>& points, const std::string& laws,
                        const std::vector<std::string>& below, const Words& say) {
  std::string text;
  for (const ContactTable& one : tables.contacts) {
    text += under(say("cli.contact", {{"gap", one.gap}}), one.points);
  }
  if (is_elastic(points)) text += "  " + say("peaks.elastic") + "\n";
  text += under(say("columns.table"), tables.struck) + laws;
  for (const LinkTable& one : tables.links) {
    text += under(say("cli.links", {{"link", one.link}, {"law", one.law}}), one.links);
  }
  for (std::size_t b = 0; b < tables.buildings.size(); ++b) {
    const BuildingTables& one = tables.buildings[b];
    const std::pair<std::string, std::string> of = {"building", one.building};
    text += under(say("cli.peaks", {of}), one.floors);
    if (!one.forces.is_empty()) text += "\n" + text_of(one.forces);
    if (one.moves_with_ground) text += "  " + say("cli.moves") + "\n";
    if (!below[b].empty()) text += "  " + below[b] + "\n";
    text += under(say("plan.foundation"), one.foundation) + under(say("cli.yielding", {of}), one.yielding) +
            under(say("plan.bearings"), one.bearings) + under(say("cli.planes", {of}), one.planes);
  }
  return text;
}

std::string run_text(const RunResults& run, const Words& say) {
  const RunView view = run.view();
  return tables_text(run_tables(view, run.c, say), run.response.points, law_text(run, view, say),
                     proportions_of(run, say), say);
}

std::string run_text(const PlanRun& run, const Words& say) {
  return tables_text(run_tables(run, say), run.response.points, "",
                     std::vector<std::string>(run.problem.buildings.size()), say);
}

template <class Run>
std::string summary_text(const Run& run, const Words& say) {
  const std::vector<std::string> gaps = gap_names(run.problem);
  const Story story = run_story(run);
  std::string text = heading(run.c, say) + "\n" + story_text(gaps, story, say, Told::outcome) + run_text(run, say) +
                     "\n" + say("cli.storeys") + "\n\n" + story_text(gaps, story, say, Told::remarks);
  if (run.response.energy) {
    const ShownUnits shown = shown_units(run);
    text += "\n" +
            say("cli.energy", {{"input", number(shown.force * run.response.energy->peak_input)},
                               {"force", shown.units.force},
                               {"length", run.c.units.length},
                               {"residual", number(run.response.energy->relative_residual())}}) +
            "\n";
  }
  const std::string all = number(run.problem.duration);
  return text + "\n" +
         say("cli.solver",
             {{"solver", solver_name(run.c.analysis.solver)},
              {"time", run.response.collapse
                           ? say("cli.time_of", {{"time", number(run.response.collapse->time)}, {"all", all}})
                           : all},
              {"ms", number(1e3 * run.response.wall_time)},
              {"steps", std::to_string(run.response.steps)},
              {"events", std::to_string(run.response.events)}}) +
         "\n";
}

/// The results of a run and their figures in one folder.
class RunOutput {
 public:
  /// @throws as RunFolder
  RunOutput(const RunArguments& arguments, Loaded& loaded)
      : arguments_(arguments),
        results_(arguments.directory,
                 {.inputs = loaded.files, .force = arguments.force, .is_netcdf = &is_netcdf_result}, *loaded.c.source),
        pictures_(results_, arguments.figures) {}

  template <class Run>
  void write(const Run& run, const std::string& summary, const std::string& impacts) {
    results_.write(*run.c.source, summary, impacts, histories_netcdf(run, version()));
  }

  /// Draws what the run has to show into the folder "figures" beside its results.
  template <class Run>
  void write_pictures(const Run& run) const {
    pictures_.write(run_figures(run, RunPictures::options(arguments_.language)), arguments_.quiet);
  }

 private:
  const RunArguments& arguments_;
  RunFolder results_;
  RunPictures pictures_;
};

/// All records of a suite in short. @throws Failure after what is done has been told, where it was stopped.
void execute_suite(const RunArguments& arguments, const Loaded& loaded) {
  if (!arguments.directory.empty()) {
    throw Failure(exit_bad_input,
                  "bentur run: " + error_words("--output is for one run: of a suite give --record N too; --json prints "
                                               "all records in short",
                                               arguments.language));
  }
  const SuiteRun run = run_records(loaded, !arguments.quiet, arguments.language);
  const GapStudy gaps = run.all_ran() ? gaps_over_records(loaded, arguments.file, arguments.language) : GapStudy();
  if (arguments.json) {
    print(suite_run_json(run, gaps, version()));
  } else if (!arguments.quiet) {
    const Words say(arguments.language);
    std::string text =
        heading(loaded.c, say) + "\n" + story_text(gap_names(run.problem), suite_story(run, gaps), say, Told::all);
    print(fitted(text + "\n" + wrapped(say("suite.note")) + "\n"));
  }
  if (!run.is_whole()) throw Failure(exit_other, "");
}

/// Writes what is asked for and prints the summary.
template <class Run>
void tell(const RunArguments& arguments, const Run& run, std::optional<RunOutput>& output) {
  const std::string summary = output || arguments.json ? summary_json(run, version()) : "";
  if (output) output->write(run, summary, impacts_csv(run.view()));
  if (arguments.json) {
    print(summary);
  } else if (!arguments.quiet) {
    print(fitted(summary_text(run, Words(arguments.language))));
  }
  if (output && !arguments.quiet) message(written_line(*run.c.source, arguments.directory));
  if (!arguments.figures.empty()) output->write_pictures(run);
}

void execute(const RunArguments& arguments) {
  const auto refuse = [&](const std::string& why) {
    throw Failure(exit_bad_input, "bentur run: " + error_words(why, arguments.language));
  };
  if (!arguments.figures.empty() && arguments.directory.empty()) {
    refuse("--figures needs --output, the folder for them");
  }
  if (arguments.file.empty() && !arguments.directory.empty()) {
    refuse("--output needs a CASE; the built-in example is written out by bentur example m12-el-centro -o DIR");
  }
  if (is_standard_output(arguments.directory)) {
    refuse(fmt::format("--output {}: must be a folder; --json prints the summary to standard output",
                       arguments.directory));
  }
  if (arguments.file.empty() && !arguments.quiet) {
    message(error_words("No case given: running the built-in example m12-el-centro.", arguments.language));
  }
  if (arguments.file.empty() && arguments.record) refuse("--record needs a CASE");
  Loaded loaded = arguments.file.empty() ? load_example("m12-el-centro")
                                         : load_for_run(arguments.file, arguments.record, arguments.language);
  if (loaded.c.excitation.suite) return execute_suite(arguments, loaded);
  std::optional<RunOutput> output;
  if (!arguments.directory.empty()) output.emplace(arguments, loaded);
  const double step = output ? loaded.c.analysis.output_step : 0;
  with_problem(loaded, [&](const auto& problem) {
    auto run = simulate(loaded, problem, step, !arguments.quiet, arguments.language);
    if (!arguments.figures.empty()) find_figures(run);
    tell(arguments, run, output);
  });
}

}  // namespace

void add_run_command(CLI::App& app) {
  auto arguments = std::make_shared<RunArguments>();
  CLI::App* command = app.add_subcommand("run", "Simulate a case and print what happens");
  command->add_option("CASE", arguments->file, "the case file (TOML); without it the example m12-el-centro is run")
      ->check(not_empty());
  command
      ->add_option("-o,--output", arguments->directory,
                   "folder for summary.json, impacts.csv, histories.nc and case.toml")
      ->check(not_empty())
      ->type_name("DIR");
  command->add_option("--figures", arguments->figures, "draw figures too, as svg, pdf, png or several: svg,pdf")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->check(CLI::IsMember(picture_formats()))
      ->type_name("FORMATS");
  add_record(*command, arguments->record);
  command->add_flag("--json", arguments->json, "print the summary as JSON instead of tables");
  command->add_flag("-q,--quiet", arguments->quiet, "no tables, no messages but errors");
  add_language(*command, arguments->language);
  add_force(*command, arguments->force);
  command->footer("Example: bentur run case.toml -o results --figures svg,pdf");
  command->callback([arguments] { execute(*arguments); });
}

}  // namespace bentur::cli
