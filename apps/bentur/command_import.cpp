#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include "arguments.h"
#include "bentur/core/number_text.h"
#include "bentur/io/exchange/block_case.h"
#include "bentur/io/exchange/e2k.h"
#include "bentur/io/exchange/geojson.h"
#include "bentur/io/input_file.h"
#include "commands.h"
#include "output/output.h"
#include "session.h"

namespace bentur::cli {
namespace {

struct ImportArguments {
  std::string file, output = "-", along = "x";
  std::optional<double> at;
  std::vector<std::string> sections;  ///< NAME=AREA,I33
  BlockRules rules;
  std::vector<double> period_formula;
  GeoJsonOptions houses;
  std::optional<double> radius;
  bool force = false;
  std::vector<std::string> of_frame, of_block;  ///< options that were given
};

std::map<std::string, E2kProperties> sections_of(const std::vector<std::string>& given) {
  std::map<std::string, E2kProperties> sections;
  for (const std::string& one : given) {
    const std::size_t equals = one.rfind('=');
    std::vector<double> numbers;
    std::istringstream list(equals == std::string::npos ? "" : one.substr(equals + 1));
    for (std::string number; std::getline(list, number, ',');) numbers.push_back(parse_number(number).value_or(0));
    const bool positive = std::all_of(numbers.begin(), numbers.end(), [](double value) { return value > 0; });
    if (equals == 0 || !positive || numbers.size() < 2 || numbers.size() > 3) {
      throw Failure(exit_bad_input,
                    "bentur import: --section " + one +
                        ", must be NAME=AREA,I33 or NAME=AREA,I33,I22, numbers > 0 in the model's length");
    }
    sections[one.substr(0, equals)] = {numbers[0], numbers[1], numbers.size() > 2 ? numbers[2] : 0};
  }
  return sections;
}

/// GeoJSON by its name, or by how it begins.
bool is_geojson(const std::string& file, const std::string& text) {
  for (const char* const end : {".geojson", ".json", ".geojsonl", ".geojsons", ".geojsonseq", ".ndjson"}) {
    if (file.ends_with(end)) return true;
  }
  const std::size_t begin = text.find_first_not_of(" \t\r\n\x1e");
  return begin != std::string::npos && text[begin] == '{';
}

std::optional<ImportedCase> read_block(const ImportArguments& arguments, const std::string& text,
                                       Diagnostics& diagnostics) {
  BlockRules rules = arguments.rules;
  if (!arguments.period_formula.empty()) {
    rules.period_coefficient = arguments.period_formula[0];
    rules.period_exponent = arguments.period_formula[1];
  }
  GeoJsonOptions options = arguments.houses;
  options.radius = arguments.radius.value_or(options.radius);
  options.unread_as_none = rules.storeys.has_value();
  const auto houses = read_geojson(text, arguments.file, options, diagnostics);
  if (!houses) return std::nullopt;
  return make_block_case(*houses, arguments.file, rules, diagnostics);
}

void run(const ImportArguments& arguments) {
  const std::map<std::string, E2kProperties> sections = sections_of(arguments.sections);
  Diagnostics diagnostics;
  const auto text = read_input(arguments.file, {"model", std::uintmax_t{256} << 20}, diagnostics);
  if (!text) throw Failure(diagnostics);
  const bool is_block = is_geojson(arguments.file, *text);
  const std::vector<std::string>& astray = is_block ? arguments.of_frame : arguments.of_block;
  if (!astray.empty()) {
    throw Failure(exit_bad_input, fmt::format("bentur import: {} is of {}, not of this file", astray.front(),
                                              is_block ? "ETABS models" : "GeoJSON"));
  }
  if (arguments.radius && arguments.houses.around.empty()) {
    throw Failure(exit_bad_input, "bentur import: --radius needs --around, a house or a place to be near to");
  }
  const auto made =
      is_block ? read_block(arguments, *text, diagnostics)
               : read_e2k(*text, arguments.file, {arguments.along == "x", arguments.at, sections}, diagnostics);
  if (!made) throw Failure(diagnostics);
  OutputFile output(arguments.output, ResultKind::imported, {.inputs = {arguments.file}, .force = arguments.force});
  output.write(made->text);
  for (const std::string& one : made->taken) message("taken: " + one);
  for (const UnreadLines& one : made->unread) {
    const std::string lines =
        one.first == one.last ? fmt::format("{}", one.first) : fmt::format("{}-{}", one.first, one.last);
    message(fmt::format("{}:{}: not read: {}", arguments.file, lines, one.what));
  }
}

}  // namespace

void add_import_command(CLI::App& app) {
  auto arguments = std::make_shared<ImportArguments>();
  CLI::App* command = app.add_subcommand(
      "import", "A frame of an ETABS model (.e2k) as the beginning of a case, or a block of houses (.geojson) as one");
  command->add_option("FILE", arguments->file, "model.e2k, the text that ETABS exports, or block.geojson")
      ->required()
      ->check(not_empty());
  const std::vector<CLI::Option*> of_frame = {
      command->add_option("--along", arguments->along, "axis along which its bays run, x or y; default x")
          ->check(CLI::IsMember({"x", "y"})),
      command->add_option("--at", arguments->at, "where across that axis the frame stands, in the model's length")
          ->check(finite()),
      command
          ->add_option("--section", arguments->sections,
                       "area and moments of inertia of a section of a library, as often as needed")
          ->type_name("NAME=AREA,I33[,I22]")
          ->allow_extra_args(false)};
  BlockRules& rules = arguments->rules;
  GeoJsonOptions& houses = arguments->houses;
  const std::vector<CLI::Option*> of_block = {
      command->add_option("--snap", rules.snap, "overlaps up to this are trimmed, in metres; default 0.1")
          ->check(positive()),
      command->add_flag("--hull", rules.hull, "footprints that are not convex become their hulls"),
      command->add_flag("--metres", houses.metres, "coordinates are metres east and north, not degrees"),
      command->add_option("--around", houses.around, "houses that are near to one, by its name or id, or to a place")
          ->type_name("NAME|LON,LAT")
          ->check(not_empty()),
      command->add_option("--radius", arguments->radius, "how near, in metres; default 50")->check(positive()),
      command->add_option("--without", houses.without, "a house to leave out, by its name or id, as often as needed")
          ->type_name("NAME")
          ->allow_extra_args(false)
          ->check(not_empty()),
      command->add_flag("--parts", houses.parts, "parts of a MultiPolygon become buildings of their own"),
      command->add_option("--levels", houses.levels, "a property that has storeys, where it is not a usual one")
          ->type_name("PROPERTY")
          ->check(not_empty()),
      command->add_option("--clearance", rules.clearance, "who stands so near may touch, in metres; default 0.5")
          ->check(positive()),
      command->add_option("--storeys", rules.storeys, "of buildings of which neither storeys nor a height can be read")
          ->check(CLI::Range(1, 200)),
      command->add_option("--storey-height", rules.storey_height, "where none is given, in metres; default 3")
          ->check(positive()),
      command->add_option("--floor-mass", rules.floor_mass, "in tonnes per square metre; default 1")->check(positive()),
      command
          ->add_option("--period-formula", arguments->period_formula,
                       "the first period is COEFFICIENT H^EXPONENT, H in metres; default 0.0466,0.9")
          ->type_name("COEFFICIENT,EXPONENT")
          ->delimiter(',')
          ->expected(2)
          ->check(positive())};
  command->add_option("-o,--output", arguments->output, "case file to write; default - for standard output")
      ->check(not_empty());
  add_force(*command, arguments->force);
  command->footer(
      "What is not read is listed with its lines, what is taken in place of what the file does not say as well.\n"
      "Example: bentur import model.e2k --at 6 -o frame.toml\n"
      "Example: bentur import block.geojson -o block.toml\n"
      "Example: bentur import ward.geojson --around Hotel --radius 40 --hull --parts --storeys 3 -o hotel.toml");
  command->callback([arguments, of_frame, of_block] {
    const auto given = [](const std::vector<CLI::Option*>& options) {
      std::vector<std::string> names;
      for (const CLI::Option* const one : options) {
        if (one->count() > 0) names.push_back(one->get_name());
      }
      return names;
    };
    arguments->of_frame = given(of_frame);
    arguments->of_block = given(of_block);
    run(*arguments);
  });
}

}  // namespace bentur::cli
