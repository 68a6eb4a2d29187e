#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <memory>
#include <optional>

#include "arguments.h"
#include "bentur/core/errors.h"
#include "bentur/files/netcdf.h"
#include "bentur/io/input_file.h"
#include "bentur/report/files/figure_files.h"
#include "bentur/report/files/figure_json.h"
#include "bentur/report/files/picture.h"
#include "bentur/report/kinds/figure_width.h"
#include "bentur/report/kinds/kinds.h"
#include "bentur/report/studies/file_kinds.h"
#include "cases/suite.h"
#include "commands.h"
#include "output/picture.h"
#include "session.h"

namespace bentur::cli {
namespace {

struct PlotArguments {
  std::string results, kind, output, language = "en";
  std::vector<std::string> at;
  std::string method = fragility_methods().front();
  FigureOptions options;
  double from = NAN, to = NAN, elevation = NAN, width = NAN;
  int gap = -1;
  bool list = false, force = false;
};

std::optional<double> given(double value) { return std::isnan(value) ? std::nullopt : std::optional(value); }

FigureOptions options_of(const PlotArguments& arguments) {
  FigureOptions options = arguments.options;
  options.say = figure_words(arguments.language);
  options.language = arguments.language;
  options.method = fragility_method(arguments.method);
  options.from = given(arguments.from);
  options.to = given(arguments.to);
  options.elevation = given(arguments.elevation);
  if (arguments.gap >= 0) options.gap = static_cast<std::size_t>(arguments.gap);
  for (const std::string& text : arguments.at) {
    const std::size_t sign = text.find('=');
    if (sign == std::string::npos) {
      throw Failure(exit_bad_input, fmt::format("bentur plot: --at {}: must be NAME=VALUE", text));
    }
    options.at.emplace_back(text.substr(0, sign), text.substr(sign + 1));
  }
  return options;
}

void list_kinds(const std::vector<FigureKind>& kinds) {
  std::string text;
  for (const FigureKind& kind : kinds) text += fmt::format("{:<20}{}\n", kind.name, kind.shows);
  print(text);
}

/// The figure, as wide as is asked for; where it cannot be, this is said.
Figure drawn(const MakeFigure& make, const PlotArguments& arguments) {
  const FigureOptions options = options_of(arguments);
  const std::optional<double> width = given(arguments.width);
  if (!width) return make(options);
  Figure figure = figure_of_width(make, options, *width);
  if (figure.width > *width) {
    message(fmt::format("{} is {:.3g} cm wide and not {:.3g} cm: its panels belong beside one another", arguments.kind,
                        figure.width, *width));
  }
  return figure;
}

/// A figure that the user describes.
void draw_own(const PlotArguments& arguments) {
  const std::filesystem::path file = arguments.results;
  Diagnostics diagnostics;
  std::optional<Figure> figure;
  if (const std::optional<std::string> text = read_input(file, figure_input, diagnostics)) {
    figure = figure_from_json(*text, file.string(), diagnostics);
  }
  if (!figure) throw Failure(diagnostics, arguments.language);
  figure->width = given(arguments.width).value_or(figure->width);
  if (!arguments.kind.empty() || arguments.list) {
    throw Failure(exit_bad_input, fmt::format("bentur plot: {} is one figure, without kinds", file.string()));
  }
  try {
    write_picture(arguments.output.empty() ? file.stem().string() + ".svg" : arguments.output, *figure,
                  {.inputs = {file}, .force = arguments.force});
  } catch (const InvalidParameter& error) {
    throw Failure(exit_bad_input, fmt::format("{}: error: {}", file.string(), error.what()));
  }
}

/// Of a case with a suite what each record needs, which is run for that, or the spectra of its records.
void draw_suite(const PlotArguments& arguments) {
  const Loaded loaded = load(arguments.results, arguments.language);
  const auto& suite = loaded.c.excitation.suite;
  if (!suite) {
    throw Failure(exit_bad_input,
                  "bentur plot: a case has results to draw once bentur run -o DIR has made them; "
                  "without a run it has figures of excitation.kind = \"suite\"");
  }
  if (arguments.list) return list_kinds(figure_kinds(SuiteRun{}));
  std::optional<SuiteRun> run;
  std::optional<GapStudy> gaps;
  if (arguments.kind != "suite") {
    const std::vector<FigureKind> kinds = figure_kinds(SuiteRun{});
    if (std::none_of(kinds.begin(), kinds.end(), [&](const FigureKind& one) { return one.name == arguments.kind; })) {
      throw Failure(exit_bad_input, fmt::format("bentur plot: a suite has no figure \"{}\"; --list shows those it has",
                                                arguments.kind));
    }
    run = run_records(loaded, true, arguments.language);
    gaps = gaps_over_records(loaded, arguments.results, arguments.language);
  }
  const auto make = [&](const FigureOptions& options) {
    return run ? make_figure(*run, *gaps, arguments.kind, options) : suite_figure(*suite, loaded.c.units, options);
  };
  std::optional<Figure> figure;
  try {
    figure = drawn(make, arguments);
  } catch (const NoFigure& error) {
    throw Failure(exit_bad_input, std::string("bentur plot: ") + error.what());
  }
  write_picture(arguments.output.empty() ? arguments.kind + ".svg" : arguments.output, *figure,
                {.inputs = loaded.files, .force = arguments.force});
}

void run(const PlotArguments& arguments) {
  if (std::filesystem::path(arguments.results).extension() == ".toml") return draw_suite(arguments);
  if (std::filesystem::path(arguments.results).extension() == ".json") return draw_own(arguments);
  std::error_code ignored;
  std::filesystem::path file = arguments.results;
  if (std::filesystem::is_directory(file, ignored)) file /= "histories.nc";  // as bentur run -o has left it
  if (!std::filesystem::exists(file, ignored)) {
    throw Failure(exit_bad_input, file.string() + ": error: there is no such file");
  }
  std::optional<Figure> figure;
  try {
    const NetcdfReader results{file};
    if (arguments.list) return list_kinds(figure_kinds(results));
    if (arguments.kind.empty()) {
      throw Failure(exit_bad_input, "bentur plot: KIND is required; --list shows what these results can give");
    }
    figure =
        drawn([&](const FigureOptions& options) { return make_figure(results, arguments.kind, options); }, arguments);
  } catch (const Failure&) {
    throw;
  } catch (const std::runtime_error& error) {  // no such figure, or results that cannot be read
    throw Failure(exit_bad_input, std::string("bentur plot: ") + error.what());
  }
  write_picture(arguments.output.empty() ? arguments.kind + ".svg" : arguments.output, *figure,
                {.inputs = {file}, .force = arguments.force});
}

}  // namespace

bool is_picture(const std::filesystem::path& file) {
  const std::string ending = file.extension().string();
  const std::vector<std::string>& known = picture_formats();
  return std::any_of(known.begin(), known.end(), [&](const std::string& one) { return ending == "." + one; });
}

void expect_picture(const std::filesystem::path& file, const OutputRules& rules) {
  const std::string name = file.stem().string();
  const auto is_control = [](unsigned char c) { return std::iscntrl(c) != 0; };
  if (!is_picture(file) || std::any_of(name.begin(), name.end(), is_control)) {
    throw Failure(exit_bad_input, fmt::format("bentur: --output {}: must end in .svg, .pdf or .png", file.string()));
  }
  const std::string format = file.extension().string().substr(1);
  if (!can_draw(format)) throw Failure(exit_other, std::string("bentur: ") + NoConverter().what());
  expect_figure(file.parent_path(), name, {format}, rules);
}

void tell_letters(const std::vector<NamedFigure>& figures) {
  std::string letters;
  for (const NamedFigure& one : figures) {
    if (letters.empty()) letters = letters_beyond_font(one.figure);
  }
  if (letters.empty()) return;
  message(
      fmt::format("DejaVu Sans, which the figures are measured by, has no \"{}\": another font draws them where there "
                  "is one, else boxes stand in their place",
                  letters));
}

void write_picture(const std::filesystem::path& file, const Figure& figure, const OutputRules& rules) {
  expect_picture(file, rules);
  const std::string name = file.stem().string();
  write_figures(file.parent_path(), {{name, figure}}, {file.extension().string().substr(1)}, rules);
  message(fmt::format("Wrote {}, and {}-data.csv and {}.py beside it to restyle it", file.string(), name, name));
  tell_letters({{name, figure}});
}

void add_plot_command(CLI::App& app) {
  auto arguments = std::make_shared<PlotArguments>();
  CLI::App* command = app.add_subcommand("plot", "Draw a figure from results");
  command
      ->add_option(
          "RESULTS", arguments->results,
          "histories.nc of a run or the folder it is in, the results of a sweep, a case with a suite of records, or a "
          "figure in JSON")
      ->required()
      ->check(not_empty());
  command->add_option("KIND", arguments->kind, "what to draw; --list shows the kinds");
  command->add_option("-o,--output", arguments->output, "the picture, .svg, .pdf or .png; default KIND.svg")
      ->check(not_empty())
      ->type_name("FILE");
  command->add_flag("--list", arguments->list, "the kinds of figure these results can give");
  command->add_option("--from", arguments->from, "of histories: first time [s]")->check(finite());
  command->add_option("--to", arguments->to, "of histories: last time [s]")->check(finite());
  command->add_option("--gap", arguments->gap, "of a run: gap, counted from 0; default the one hit hardest")
      ->check(CLI::Range(0, 1000000));
  command->add_option("--elevation", arguments->elevation, "of a run: contact point, by its elevation")
      ->check(finite());
  command->add_option("--at", arguments->at, "of a sweep: what stays fixed, and where; several allowed")
      ->type_name("NAME=VALUE")
      ->allow_extra_args(false);
  command->add_option("--against", arguments->options.against, "of a sweep: what stands along the x axis")
      ->type_name("NAME");
  command->add_option("--event", arguments->options.event,
                      "of a fragility: as in bentur fragility; default \"impacts > 0\"");
  command->add_option("--method", arguments->method, "of a fragility: as in bentur fragility; default likelihood")
      ->check(CLI::IsMember(fragility_methods()));
  command
      ->add_option("--width", arguments->width,
                   "of the figure [cm]; default 8.8, a journal's column, or 17, a page, for panels beside one another")
      ->check(finite())
      ->check(CLI::Range(5.0, 60.0));
  command->add_option("--lang", arguments->language, "language of the figure: en or id")
      ->check(CLI::IsMember(report_languages()));
  add_force(*command, arguments->force);
  command->footer(
      "Example: bentur plot results/histories.nc displacement -o displacement.pdf\n"
      "         bentur plot m12-gaps.nc peak-force --at excitation=harmonic");
  command->callback([arguments] { run(*arguments); });
}

}  // namespace bentur::cli
