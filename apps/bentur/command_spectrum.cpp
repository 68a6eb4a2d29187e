#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <filesystem>
#include <memory>
#include <optional>

#include "arguments.h"
#include "bentur/core/errors.h"
#include "bentur/core/units.h"
#include "bentur/core/version.h"
#include "bentur/io/records/record_files.h"
#include "bentur/io/results/spectrum_files.h"
#include "bentur/model/story/remarks.h"
#include "bentur/model/story/story.h"
#include "bentur/report/kinds/kinds.h"
#include "bentur/report/words.h"
#include "commands.h"
#include "output/output.h"
#include "output/picture.h"
#include "session.h"
#include "text/table.h"

namespace bentur::cli {
namespace {

struct SpectrumArguments {
  std::string file, periods, length = "m", output, language = "en";
  RecordOptions options;
  double damping = 0.05;
  bool json = false, force = false;
};

/// "FROM:TO:COUNT" as periods.
std::vector<double> read_periods(const std::string& text) {
  const auto refuse = [&] {
    return Failure(exit_bad_input, fmt::format("bentur: --periods {}: must be FROM:TO:COUNT, 0 < FROM < TO in seconds "
                                               "and COUNT from 2 to 100000",
                                               text));
  };
  double from = 0, to = 0;
  int count = 0;
  const char* at = text.data();
  const char* const last = at + text.size();
  const auto take = [&](auto& value, bool more) {
    const auto [next, error] = std::from_chars(at, last, value);
    if (error != std::errc() || (next != last) != more || (more && *next != ':')) throw refuse();
    at = more ? next + 1 : next;
  };
  take(from, true);
  take(to, true);
  take(count, false);
  if (!(from > 0 && from < to && to < 1e6) || count < 2 || count > 100000) throw refuse();
  return logarithmic_periods(from, to, count);
}

/// The unit of the file's numbers: the file's own, or the user's where it says none.
std::string settle_unit(const SpectrumArguments& arguments, const StrongMotionRecord& record) {
  if (!record.unit.empty()) return record.unit;
  if (!arguments.options.unit.empty()) return arguments.options.unit;
  std::string known;
  for (const std::string& one : acceleration_units()) known += (known.empty() ? "" : ", ") + one;
  throw Failure(exit_bad_input, fmt::format("{}: error: the file does not say its unit: give --unit, one of {}",
                                            arguments.file, known));
}

SampledMotion read_motion(const SpectrumArguments& arguments, const Units& units, RecordEcho& echo) {
  Diagnostics diagnostics;
  std::optional<StrongMotionRecord> record = read_record(arguments.file, arguments.options, diagnostics);
  if (!record) throw Failure(diagnostics, arguments.language);
  for (const RecordContradiction& one : contradictions(*record, arguments.options)) {
    diagnostics.error(
        {.file = arguments.file, .line = one.line, .column = one.line > 0 ? 1 : 0},
        fmt::format("{} is {}, but the file says {}", arguments.options.name(one.key), one.given, one.said));
  }
  if (!diagnostics.ok()) throw Failure(diagnostics, arguments.language);
  const std::string unit = settle_unit(arguments, *record);
  echo = echo_of(*record, arguments.file, unit);
  SampledMotion motion{record->time_step, std::move(record->values)};
  const double factor = acceleration_factor(unit, units);
  for (double& a : motion.acceleration) a *= factor;
  echo.pga = peak_acceleration(motion);
  return motion;
}

/// What is unusual of the record, each in a line of its own; empty without any.
std::string remarks_text(const RecordSpectrum& spectrum, const Words& say) {
  return story_text(std::vector<std::string>(), {remark_statements(remarks(spectrum.record, spectrum.units))}, say,
                    Told::all);
}

std::string spectrum_text(const RecordSpectrum& spectrum, const Words& say) {
  const std::string& length = spectrum.units.length;
  std::vector<std::string> displacement;  // each with its own digits: it grows a thousandfold over the periods
  std::vector<double> velocity, acceleration, absolute;
  for (const OscillatorPeaks& p : spectrum.peaks) {
    displacement.push_back(number(p.displacement));
    velocity.push_back(p.pseudo_velocity);
    acceleration.push_back(p.pseudo_acceleration / spectrum.units.gravity);
    absolute.push_back(p.absolute_acceleration / spectrum.units.gravity);
  }
  Table table;
  table.add(say("column.period"), "s", spectrum.periods);
  table.add(say("spectrum.displacement"), length, displacement);
  table.add(say("spectrum.velocity"), length + "/s", velocity);
  table.add(say("spectrum.acceleration"), "g", acceleration);
  table.add(say("spectrum.absolute"), "g", absolute);
  const std::string unit = unit_of(spectrum.record), in_g = number(spectrum.record.pga / spectrum.units.gravity) + " g";
  const std::string peak = unit == "g" ? in_g : number(spectrum.record.pga_read) + " " + unit + " = " + in_g;
  return record_line(spectrum.record, say) + "\n" +
         say("spectrum.heading", {{"damping", number(100 * spectrum.damping_ratio)}, {"peak", peak}}) + "\n\n" +
         table.text();
}

Figure spectrum_picture(const RecordSpectrum& spectrum, const std::string& language) {
  SpectrumCurves curves;
  curves.periods = spectrum.periods;
  for (const OscillatorPeaks& p : spectrum.peaks) {
    curves.acceleration.push_back(p.pseudo_acceleration / spectrum.units.gravity);
    curves.displacement.push_back(p.displacement);
  }
  curves.acceleration_unit = "g";
  curves.length = spectrum.units.length;
  curves.damping = spectrum.damping_ratio;
  FigureOptions options;
  options.say = figure_words(language);
  options.language = language;
  return spectrum_figure(curves, options);
}

void run(const SpectrumArguments& arguments) {
  const std::filesystem::path output(arguments.output);
  const char* const usual = is_picture(output) ? "0.05:5:301" : "0.05:5:41";  // a curve, or a table
  const std::vector<double> periods = read_periods(arguments.periods.empty() ? usual : arguments.periods);
  if (!(arguments.damping >= 0 && arguments.damping < 1)) {
    throw Failure(exit_bad_input, fmt::format("bentur: --damping {}: must be in [0, 1)", arguments.damping));
  }
  const OutputRules rules{.inputs = {arguments.file}, .force = arguments.force};
  std::optional<OutputFile> csv;
  if (is_picture(output)) {
    expect_picture(output, rules);
  } else if (!arguments.output.empty()) {
    if (is_standard_output(arguments.output) && arguments.json) {
      throw Failure(exit_bad_input, "bentur spectrum: --json and --output both ask for standard output");
    }
    csv.emplace(arguments.output, ResultKind::spectrum, rules);
  }
  RecordSpectrum spectrum;
  spectrum.units.length = arguments.length;
  spectrum.units.gravity = standard_gravity(arguments.length);
  spectrum.damping_ratio = arguments.damping;
  spectrum.periods = periods;
  const SampledMotion motion = read_motion(arguments, spectrum.units, spectrum.record);
  try {
    spectrum.peaks = response_spectrum(motion, periods, arguments.damping);
  } catch (const InvalidParameter& error) {
    throw Failure(exit_bad_input, fmt::format("{}: error: {}", arguments.file, error.what()));
  }
  if (is_picture(output)) write_picture(output, spectrum_picture(spectrum, arguments.language), rules);
  if (csv) csv->write(spectrum_csv(spectrum));
  const std::string unusual = remarks_text(spectrum, Words(arguments.language));
  if (arguments.json) {
    print(spectrum_json(spectrum, version()));
  } else if (arguments.output.empty()) {
    print(fitted(spectrum_text(spectrum, Words(arguments.language)) + (unusual.empty() ? "" : "\n" + unusual)));
  } else {
    if (!unusual.empty()) message(unusual.substr(0, unusual.size() - 1));
    if (csv && !csv->is_streamed()) print(fmt::format("{}: {} periods\n", arguments.output, periods.size()));
  }
}

}  // namespace

void add_spectrum_command(CLI::App& app) {
  auto arguments = std::make_shared<SpectrumArguments>();
  arguments->options.of_command = true;
  CLI::App* command = app.add_subcommand("spectrum", "The response spectrum of a record");
  command->add_option("FILE", arguments->file, "the record (docs/record-files.md)")->required()->check(not_empty());
  command->add_option("--unit", arguments->options.unit, "of the accelerations, where the file does not say it")
      ->check(CLI::IsMember(acceleration_units()));
  command->add_option("--format", arguments->options.format, "of the file; default auto")
      ->check(CLI::IsMember(record_formats()));
  command->add_option("--time-step", arguments->options.time_step, "[s], where the file does not say it")
      ->check(positive());
  command->add_option("--column", arguments->options.column, "of the accelerations, where there are more than two")
      ->check(CLI::Range(1, 1000000));
  command->add_option("--channel", arguments->options.channel, "of accelerations, where the file has several")
      ->check(CLI::Range(1, 1000000));
  command
      ->add_option("--component", arguments->options.component,
                   "the channel or column by its name in the file, as N-S or Up")
      ->check(not_empty());
  command->add_option("--skip-lines", arguments->options.skip_lines, "lines at the beginning to pass over")
      ->check(CLI::Range(0, 1000000));
  command->add_option("--damping", arguments->damping, "ratio, default 0.05")->check(finite());
  command->add_option("--periods", arguments->periods,
                      "FROM:TO:COUNT in seconds, evenly spaced on a logarithmic scale; default 0.05:5:41, of a picture "
                      "0.05:5:301");
  command->add_option("--length", arguments->length, "unit of length of the results, default m")
      ->check(CLI::IsMember(length_units()));
  command
      ->add_option("-o,--output", arguments->output,
                   "write a CSV file (- for standard output), or draw a picture: .svg, .pdf or .png")
      ->check(not_empty());
  command->add_option("--lang", arguments->language, "en (default) or id: English or Indonesian")
      ->check(CLI::IsMember(report_languages()));
  add_force(*command, arguments->force);
  command->add_flag("--json", arguments->json, "JSON instead of a table");
  command->footer(
      "Displacement is relative to the ground, acceleration with it; every peak is that of the continuous response.\n"
      "Example: bentur spectrum record.AT2 --damping 0.02 --periods 0.1:10:50 -o spectrum.csv");
  command->callback([arguments] { run(*arguments); });
}

}  // namespace bentur::cli
