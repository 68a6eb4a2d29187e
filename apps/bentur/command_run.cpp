#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <optional>

#include "arguments.h"
#include "bentur/core/version.h"
#include "bentur/files/netcdf_kind.h"
#include "bentur/files/result_netcdf.h"
#include "bentur/io/results/plan/plan_json.h"
#include "bentur/io/results/result_csv.h"
#include "bentur/io/results/result_json.h"
#include "bentur/model/plan/plan_dense_run.h"
#include "bentur/model/plan/plan_places.h"
#include "bentur/model/story/story.h"
#include "bentur/report/errors.h"
#include "bentur/report/files/figure_files.h"
#include "bentur/report/files/picture.h"
#include "bentur/report/kinds/kinds.h"
#include "bentur/report/words.h"
#include "cases/plan_text.h"
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

/// Columns behind the elevations [length] of their places.
Table table_of(std::vector<TableColumn> columns, const RunView& run, const std::vector<double>& elevations,
               const Words& say) {
  Table table;
  table.add(say("cli.level"), run.units.length, elevations);
  for (TableColumn& column : columns) {
    table.add(std::move(column.label), std::move(column.unit), std::move(column.cells));
  }
  return table;
}

/// Every quantity of contact points, links or floors that is for tables, behind the elevations of the places.
Table quantity_table(const RunView& run, Owner owner, const std::vector<QuantityPlace>& places, const Words& say) {
  std::vector<double> elevations;
  for (const QuantityPlace& at : places) {
    elevations.push_back(owner == Owner::point  ? run.problem.points[at.item].elevation
                         : owner == Owner::link ? run.problem.links[at.item].elevation
                                                : run.problem.buildings[at.item].model.elevations[at.floor]);
  }
  return table_of(table_columns(owner, run, places, say.number()), run, elevations, say);
}

/// What the storeys of a building do that yield, each by the floor above it; empty where none can.
std::string yielding_table(const RunView& run, Eigen::Index building, const Words& say) {
  const std::vector<double>& levels = run.problem.buildings[building].model.elevations;
  std::vector<TableColumn> columns =
      table_columns(Owner::floor, run, floors_from_top(run.problem, building), say.number(), QuantityTable::yielding);
  if (columns.empty()) return "";
  return "\n" + say("cli.yielding", {{"building", run.problem.buildings[building].name}}) + "\n\n" +
         table_of(std::move(columns), run, {levels.rbegin(), levels.rend()}, say).text();
}

/// Accelerations and storey shears of a building with and without contact, storeys by the floor above them.
std::string force_table(const RunView& run, Eigen::Index building, const Words& say) {
  const std::vector<double>& levels = run.problem.buildings[building].model.elevations;
  return "\n" + table_of(table_columns(Owner::floor, run, floors_from_top(run.problem, building), say.number(),
                                       QuantityTable::forces),
                         run, {levels.rbegin(), levels.rend()}, say)
                    .text();
}

/// The contact points of a gap from the top down.
std::vector<Eigen::Index> points_from_top(const Gap& gap) { return {gap.points.rbegin(), gap.points.rend()}; }

/// What the columns bear that floors strike in a gap, from the top down; empty where floors meet.
std::string struck_table(const RunView& run, const Gap& gap, const Words& say) {
  std::vector<Eigen::Index> points = points_from_top(gap);
  std::erase_if(points, [&](Eigen::Index i) { return !struck_column(run.problem, run.problem.points[i]); });
  if (points.empty()) return "";
  std::vector<double> elevations;
  std::vector<std::string> struck;
  for (const Eigen::Index i : points) {
    const ContactPoint& point = run.problem.points[i];
    elevations.push_back(point.elevation);
    struck.push_back(run.problem.buildings[struck_column(run.problem, point)->building].name);
  }
  std::vector<TableColumn> columns =
      table_columns(Owner::point, run, places_of(points), say.number(), QuantityTable::struck);
  columns.insert(columns.begin(), {say("cli.column_of"), "", struck});
  return "\n" + say("cli.columns", {{"gap", gap_name(run.problem, gap.number)}}) + "\n\n" +
         table_of(std::move(columns), run, elevations, say).text();
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
    for (const Eigen::Index i : points_from_top(gap_at(run.problem, gap))) {
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

using cli::run_tables;  // of buildings in plan

/// Points, laws, links and floors of a row, as tables.
std::string run_tables(const RunResults& run, const Words& say) {
  const RunView view = run.view();
  const Problem& problem = run.problem;
  std::string text;
  for (const Gap& gap : gaps_of(problem)) {
    if (gap.points.empty()) continue;
    text += "\n" + say("cli.contact", {{"gap", gap_name(problem, gap.number)}}) + "\n\n" +
            quantity_table(view, Owner::point, places_of(points_from_top(gap)), say).text() +
            struck_table(view, gap, say);
  }
  text += law_text(run, view, say);
  const std::vector<std::vector<Eigen::Index>> links = links_by_spec(run.c.links);
  for (std::size_t k = 0; k < links.size(); ++k) {
    if (links[k].empty()) continue;
    const std::vector<Eigen::Index> from_top(links[k].rbegin(), links[k].rend());
    text += "\n" +
            say("cli.links",
                {{"link", link_name(problem, problem.links.at(from_top.front()))}, {"law", run.c.links[k].law}}) +
            "\n\n" + quantity_table(view, Owner::link, places_of(from_top), say).text();
  }
  for (Eigen::Index b = 0; b < std::ssize(problem.buildings); ++b) {
    const Building& building = problem.buildings[b];
    const Proportions found = proportions(building, run.c.units, &run.response.buildings[b]);
    text += "\n" + say("cli.peaks", {{"building", building.name}}) + "\n\n" +
            quantity_table(view, Owner::floor, floors_from_top(problem, b), say).text();
    text += force_table(view, b, say);
    if (building.is_rigid()) {
      text += "  " + say("cli.moves") + "\n";
      continue;
    }
    const auto& coefficient = found.base_shear_coefficient;
    text += "  " +
            say("cli.base_shear", {{"coefficient", coefficient ? number(*coefficient) : "–"},
                                   {"proportions", proportions_text(building, found, view.shown, say)}}) +
            "\n";
    if (const Eigen::VectorXd& foundation = run.response.buildings[b].foundation; foundation.size() == 2) {
      text +=
          "  " +
          say("cli.foundation",
              {{"sway", number(foundation(0))}, {"length", run.c.units.length}, {"rocking", number(foundation(1))}}) +
          "\n";
    }
    text += yielding_table(view, b, say);
  }
  return text;
}

template <class Run>
std::string summary_text(const Run& run, const Words& say) {
  const std::vector<std::string> gaps = gap_names(run.problem);
  const Story story = run_story(run);
  std::string text = heading(run.c, say) + "\n" + story_text(gaps, story, say, Told::outcome) + run_tables(run, say) +
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
  if (loaded.c.is_in_plan()) {
    PlanRun run = simulate_plan(loaded, step, !arguments.quiet, arguments.language);
    if (!arguments.figures.empty()) run.closer = dense_findings(run);
    return tell(arguments, run, output);
  }
  RunResults run = simulate(loaded, step, !arguments.quiet, arguments.language);
  if (!arguments.figures.empty()) run.figures = figure_data(run);
  tell(arguments, run, output);
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
