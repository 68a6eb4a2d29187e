#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <limits>
#include <memory>
#include <optional>

#include "arguments.h"
#include "bentur/files/atomic_file.h"
#include "bentur/files/result_netcdf.h"
#include "bentur/io/results/result_csv.h"
#include "bentur/io/results/result_json.h"
#include "bentur/model/gap/gap_outcome.h"
#include "bentur/model/restitution.h"
#include "bentur/report/figures/figure_files.h"
#include "bentur/report/figures/gnuplot.h"
#include "bentur/report/kinds/kinds.h"
#include "bentur/report/remark_text.h"
#include "commands.h"
#include "output.h"
#include "session.h"
#include "text/table.h"

namespace bentur::cli {
namespace {

struct RunArguments {
  std::string file;
  std::string directory;
  std::vector<std::string> figures;  // their formats
  bool json = false;
  bool quiet = false;
  bool force = false;
};

/// Floors top to bottom, as the building stands.
std::vector<double> from_top(const Eigen::VectorXd& values) {
  std::vector<double> reversed(values.begin(), values.end());
  std::reverse(reversed.begin(), reversed.end());
  return reversed;
}

/// Indices of the contact points of one gap, highest first.
std::vector<std::size_t> points_of(const Problem& problem, int gap) {
  std::vector<std::size_t> points;
  for (std::size_t i = problem.points.size(); i-- > 0;) {
    if (problem.points[i].left == gap) {
      points.push_back(i);
    }
  }
  return points;
}

/// What to do about floors that met something where no contact is modelled; empty where none did.
std::string unmodelled_text(const Loaded& loaded, const Response& response, const std::vector<std::size_t>& floors) {
  const Problem& problem = loaded.problem;
  const std::string& length = loaded.c.units.length;
  constexpr std::size_t most = 3;  // told one by one
  std::string text;
  for (std::size_t n = 0; n < std::min(most, floors.size()); ++n) {
    const std::size_t i = floors[n];
    const WatchedFloor& floor = problem.watched[i];
    const WatchedSummary& summary = response.watched[i];
    const std::string met = fmt::format(
        "{} at elevation {} {} goes {} {} into {}, t = {} s", floor_text(problem, floor), number(floor.elevation),
        length, number(-summary.least_opening), length, faced_text(problem, floor), number(summary.least_time));
    text += text.empty() ? fmt::format(
                               "POUNDING THAT IS NOT MODELLED: {}.\n  The run goes on as if nothing were there: "
                               "its numbers do not tell what happens then.\n",
                               met)
                         : fmt::format("  Also {}.\n", met);
    text += fmt::format("  To model it: {}.\n", remedy_text(problem, floor, length));
  }
  if (floors.size() > most) {
    const std::size_t more = floors.size() - most;
    text += fmt::format("  And {} more floor{} less deep: --json lists them all.\n", more, more == 1 ? "" : "s");
  }
  return text;
}

/// Does it pound, where, how often, how hard; and how wide the gap would have to be.
std::string verdict(const Loaded& loaded, const Response& response, int gap) {
  const Problem& problem = loaded.problem;
  const std::string& length = loaded.c.units.length;
  const std::vector<std::size_t> points = points_of(problem, gap);
  const std::vector<std::size_t> unmodelled = unmodelled_contacts(problem, response, static_cast<std::size_t>(gap));
  int impacts = 0;
  int touched = 0;
  std::optional<std::size_t> hardest;
  for (const std::size_t i : points) {
    impacts += response.points[i].impacts;
    touched += response.points[i].impacts > 0 ? 1 : 0;
    if (!hardest || response.points[i].peak_force > response.points[*hardest].peak_force) hardest = i;
  }
  std::string text = gap_name(problem, gap) + ": " + unmodelled_text(loaded, response, unmodelled);
  if (!unmodelled.empty()) text += "  ";
  if (impacts == 0) {
    if (unmodelled.empty()) text += "NO POUNDING. ";
  } else {
    const PointSummary& worst = response.points[*hardest];
    text += fmt::format("POUNDING, {} impact{} at {} of {} contact point{}.\n  ", impacts, impacts == 1 ? "" : "s",
                        touched, points.size(), points.size() == 1 ? "" : "s");
    if (worst.peak_force_time) {  // an impact without duration has no force
      text += fmt::format("Hardest: {} {} at elevation {} {}, t = {} s.\n  ", number(worst.peak_force),
                          loaded.c.units.force, number(problem.points[*hardest].elevation), length,
                          number(*worst.peak_force_time));
    }
  }
  const GoverningLevel level = governing_level(problem, response, static_cast<std::size_t>(gap));
  text += fmt::format("Gap at elevation {} {}: {} {} given, {} {} needed to stay apart.\n", number(level.elevation),
                      length, number(level.width), length, number(level.needed), length);
  if (level.watched) {
    const WatchedFloor& floor = problem.watched[*level.watched];
    text += fmt::format("  There {} faces {}.\n", floor_text(problem, floor), faced_text(problem, floor));
  }
  return text;
}

Table contact_table(const Loaded& loaded, const Response& response, int gap) {
  const Units& units = loaded.c.units;
  std::vector<double> elevation, width, needed, duration, force, time, speed, penetration, impulse;
  std::vector<std::string> impacts;
  for (const std::size_t i : points_of(loaded.problem, gap)) {
    const PointSummary& point = response.points[i];
    elevation.push_back(loaded.problem.points[i].elevation);
    width.push_back(loaded.problem.points[i].width);
    needed.push_back(point.minimum_gap_no_contact);
    impacts.push_back(std::to_string(point.impacts));
    duration.push_back(point.contact_duration);
    force.push_back(point.peak_force);
    time.push_back(point.peak_force_time.value_or(std::numeric_limits<double>::quiet_NaN()));
    penetration.push_back(point.peak_penetration);
    speed.push_back(point.peak_closing_speed);
    impulse.push_back(point.impulse);
  }
  Table table;
  table.add("elevation", units.length, elevation);
  table.add("gap", units.length, width);
  table.add("needed", units.length, needed);
  table.add("impacts", "", impacts);
  table.add("in contact", "s", duration);
  table.add("force", units.force, force);
  table.add("at", "s", time);
  table.add("depth", units.length, penetration);
  table.add("speed", units.length + "/s", speed);
  table.add("impulse", units.force + "·s", impulse);
  return table;
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
std::string range_text(const PointRestitution& restitution) {
  if (!restitution.smallest) {
    return "–";
  }
  const std::string smallest = fmt::format("{:.4f}", *restitution.smallest);
  const std::string largest = fmt::format("{:.4f}", *restitution.largest);
  return smallest == largest ? smallest : smallest + " to " + largest;
}

/// The law of every contact point, the restitution it was asked for and the range its impacts had; empty where all are
/// linear springs, of which there is nothing to say.
std::string law_text(const Loaded& loaded, const Response& response) {
  const std::vector<GapSpec>& gaps = loaded.c.gaps;
  if (std::all_of(gaps.begin(), gaps.end(), [](const GapSpec& gap) { return gap.contact.law == "linear"; })) {
    return "";
  }
  const std::vector<PointRestitution> restitution = restitutions(loaded.problem, response);
  const bool single_points =
      std::all_of(gaps.begin(), gaps.end(), [](const GapSpec& gap) { return gap.elevations.size() <= 1; });
  std::vector<std::string> between, law, choices, parameter, asked, obtained;
  std::vector<double> elevation;
  for (std::size_t gap = 0; gap < gaps.size(); ++gap) {
    std::string made;
    for (const auto& [name, word] : gaps[gap].contact.choices()) {
      made += (made.empty() ? "" : ", ") + word;
    }
    for (const std::size_t i : points_of(loaded.problem, static_cast<int>(gap))) {
      between.push_back(gap_name(loaded.problem, gap));
      elevation.push_back(loaded.problem.points[i].elevation);
      law.push_back(gaps[gap].contact.law);
      choices.push_back(made);
      parameter.push_back(parameter_text(*loaded.problem.points[i].law));
      asked.push_back(restitution[i].asked ? number(*restitution[i].asked) : "–");
      obtained.push_back(range_text(restitution[i]));
    }
  }
  Table table;
  if (gaps.size() > 1) {
    table.add("gap", "", between);
  }
  if (!single_points) {
    table.add("elevation", loaded.c.units.length, elevation);
  }
  table.add("law", "", law);
  table.add("choices", "", choices);
  table.add("parameter", "", parameter);
  table.add("asked", "", asked);
  table.add("obtained", "", obtained);
  return "\nContact laws, restitution asked and obtained\n\n" + table.text();
}

Table building_table(const Loaded& loaded, const Building& building, const BuildingPeaks& peaks) {
  const Units& units = loaded.c.units;
  std::vector<double> elevations(building.model.elevations.rbegin(), building.model.elevations.rend());
  std::vector<std::string> amplification;
  for (Eigen::Index i = peaks.displacement.size() - 1; i >= 0; --i) {
    const double free = peaks.displacement_no_contact(i);
    amplification.push_back(free > 0 ? fmt::format("{:.3f}", peaks.displacement(i) / free) : "–");
  }
  Table table;
  table.add("elevation", units.length, elevations);
  table.add("displacement", units.length, from_top(peaks.displacement));
  table.add("no contact", units.length, from_top(peaks.displacement_no_contact));
  table.add("amplification", "", amplification);
  table.add("drift", "%", from_top(100 * peaks.drift_ratio));
  table.add("acceleration", units.length + "/s²", from_top(peaks.acceleration));
  table.add("storey shear", units.force, from_top(peaks.storey_shear));
  return table;
}

std::string summary_text(const Loaded& loaded, const Response& response) {
  const Problem& problem = loaded.problem;
  std::string text = loaded.c.title.empty() ? "" : loaded.c.title + "\n";
  text += excitation_line(loaded.c) + "\n\n";
  const int gaps = static_cast<int>(problem.buildings.size()) - 1;
  for (int gap = 0; gap < gaps; ++gap) {
    text += verdict(loaded, response, gap);
  }
  for (int gap = 0; gap < gaps; ++gap) {
    if (points_of(problem, gap).empty()) continue;
    text += fmt::format("\nContact {}, from the top down\n\n{}", gap_name(problem, gap),
                        contact_table(loaded, response, gap).text());
  }
  text += law_text(loaded, response);
  for (std::size_t b = 0; b < problem.buildings.size(); ++b) {
    const Building& building = problem.buildings[b];
    const Proportions found = proportions(building, loaded.c.units, &response.buildings[b]);
    text += fmt::format("\nPeaks of {}, from the top down\n\n{}", building.name,
                        building_table(loaded, building, response.buildings[b]).text());
    text += fmt::format("  Base shear {} of the weight; {}\n",
                        found.base_shear_coefficient ? number(*found.base_shear_coefficient) : "–",
                        proportions_text(building, found, loaded.c.units));
  }
  const std::string unusual = remarks_text(remarks(loaded.c, problem, response));
  text += "\n" + unusual + wrapped(model_text()) + "\n";
  if (response.energy) {
    text += fmt::format("\nEnergy: {} {}·{} put in, accounted for within {:.1e} of it\n",
                        number(response.energy->peak_input), loaded.c.units.force, loaded.c.units.length,
                        response.energy->relative_residual());
  }
  return text + fmt::format("\nSolver {}: {} s in {} ms, {} steps, {} contacts closed or opened\n",
                            solver_name(loaded.c.analysis.solver), number(problem.duration),
                            number(1e3 * response.wall_time), response.steps, response.events);
}

/// The result files of a run in one folder.
class RunOutput {
 public:
  /// Before the work, so that a folder that cannot be written to costs none. @throws as AtomicFiles.
  RunOutput(const RunArguments& arguments, Loaded& loaded)
      : arguments_(arguments),
        rules_{.inputs = loaded.files, .force = arguments.force},
        files_(arguments.directory, rules_) {
    // Where the case itself lies there under the name of its copy none is needed.
    loaded.c.source->copied = !rules_.is_input(folder() / "case.toml");
    files_.expect("summary.json", ResultKind::summary);
    files_.expect("impacts.csv", ResultKind::impacts);
    files_.expect("histories.nc", ResultKind::histories);
    if (loaded.c.source->copied) files_.expect("case.toml", ResultKind::case_copy);
    for (const std::string& name : run_figure_names()) {
      if (!arguments.figures.empty()) expect_figure(folder() / "figures", name, arguments.figures, rules_);
    }
  }

  void write(const Loaded& loaded, const Response& response, const std::string& summary) {
    const bool figures = !arguments_.figures.empty();
    const FigureData data = figures ? figure_data(loaded.problem, response, loaded.c.analysis.solver) : FigureData{};
    histories_ = histories_netcdf(loaded.c, loaded.problem, response, BENTUR_VERSION, figures ? &data : nullptr);
    if (loaded.c.source->copied) files_.add("case.toml", loaded.c.source->text, ResultKind::case_copy);
    files_.add("summary.json", summary, ResultKind::summary);
    files_.add("impacts.csv", impacts_csv(loaded.c.units, loaded.problem, response), ResultKind::impacts);
    files_.add("histories.nc", histories_, ResultKind::histories);
    remove_run_figures(folder() / "figures", rules_);  // never figures of one run beside the results of another
    files_.commit();
  }

  /// Draws what the run has to show into the folder "figures" beside its results.
  void write_pictures() const {
    const std::filesystem::path pictures = folder() / "figures";
    try {
      const std::vector<std::string> names = write_run_figures(pictures, histories_, arguments_.figures, rules_);
      if (arguments_.quiet) return;
      std::string list;
      for (const std::string& name : names) list += (list.empty() ? "" : ", ") + name;
      message(fmt::format("Wrote the figures {} into {}", list, pictures.string()));
    } catch (const NoGnuplot& error) {
      message(fmt::format("bentur: {}; their data and scripts are in {}", error.what(), pictures.string()));
    }
  }

 private:
  [[nodiscard]] std::filesystem::path folder() const { return arguments_.directory; }

  const RunArguments& arguments_;
  OutputRules rules_;
  AtomicFiles files_;
  std::string histories_;
};

void run(const RunArguments& arguments) {
  if (!arguments.figures.empty() && arguments.directory.empty()) {
    throw Failure(exit_bad_input, "bentur run: --figures needs --output, the folder for them");
  }
  if (arguments.file.empty() && !arguments.directory.empty()) {
    throw Failure(exit_bad_input,
                  "bentur run: --output needs a CASE; the built-in example is written out by "
                  "bentur example m12-el-centro -o DIR");
  }
  if (is_standard_output(arguments.directory)) {
    throw Failure(exit_bad_input, fmt::format("bentur run: --output {}: must be a folder; --json prints the summary to "
                                              "standard output",
                                              arguments.directory));
  }
  if (arguments.file.empty() && !arguments.quiet) {
    message("No case given: running the built-in example m12-el-centro.");
  }
  Loaded loaded = arguments.file.empty() ? load_example("m12-el-centro") : load(arguments.file);
  std::optional<RunOutput> output;
  if (!arguments.directory.empty()) output.emplace(arguments, loaded);
  const Response response = simulate(loaded, output ? loaded.c.analysis.output_step : 0, !arguments.quiet);
  const std::string summary = summary_json(loaded.c, loaded.problem, response, BENTUR_VERSION);
  if (output) output->write(loaded, response, summary);
  if (arguments.json) {
    print(summary);
  } else if (!arguments.quiet) {
    print(summary_text(loaded, response));
  }
  if (output && !arguments.quiet) {
    message(fmt::format("Wrote summary.json, impacts.csv, histories.nc{} into {}",
                        loaded.c.source->copied ? " and case.toml" : "", arguments.directory));
  }
  if (!arguments.figures.empty()) output->write_pictures();
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
  command->add_flag("--json", arguments->json, "print the summary as JSON instead of tables");
  command->add_flag("-q,--quiet", arguments->quiet, "no tables, no messages but errors");
  add_force(*command, arguments->force);
  command->footer("Example: bentur run case.toml -o results --figures svg,pdf");
  command->callback([arguments] { run(*arguments); });
}

}  // namespace bentur::cli
