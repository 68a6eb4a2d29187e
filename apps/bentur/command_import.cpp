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
#include "bentur/io/exchange/e2k.h"
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
  bool force = false;
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

void run(const ImportArguments& arguments) {
  const std::map<std::string, E2kProperties> sections = sections_of(arguments.sections);
  Diagnostics diagnostics;
  const auto text = read_input(arguments.file, {"model", std::uintmax_t{256} << 20}, diagnostics);
  if (!text) throw Failure(diagnostics);
  const auto made = read_e2k(*text, arguments.file, {arguments.along == "x", arguments.at, sections}, diagnostics);
  if (!made) throw Failure(diagnostics);
  OutputFile output(arguments.output, ResultKind::imported, {.inputs = {arguments.file}, .force = arguments.force});
  output.write(made->text);
  for (const std::string& one : made->taken) message("taken: " + one);
  for (const E2kUnread& one : made->unread) {
    const std::string lines =
        one.first == one.last ? fmt::format("{}", one.first) : fmt::format("{}-{}", one.first, one.last);
    message(fmt::format("{}:{}: not read: {}", arguments.file, lines, one.what));
  }
}

}  // namespace

void add_import_command(CLI::App& app) {
  auto arguments = std::make_shared<ImportArguments>();
  CLI::App* command = app.add_subcommand("import", "A frame of an ETABS model (.e2k) as the beginning of a case");
  command->add_option("FILE", arguments->file, "model.e2k, the text that ETABS exports")
      ->required()
      ->check(not_empty());
  command->add_option("--along", arguments->along, "axis along which its bays run, x or y; default x")
      ->check(CLI::IsMember({"x", "y"}));
  command->add_option("--at", arguments->at, "where across that axis the frame stands, in the model's length")
      ->check(finite());
  command
      ->add_option("--section", arguments->sections,
                   "area and moments of inertia of a section of a library, as often as needed")
      ->type_name("NAME=AREA,I33[,I22]")
      ->allow_extra_args(false);
  command->add_option("-o,--output", arguments->output, "case file to write; default - for standard output")
      ->check(not_empty());
  add_force(*command, arguments->force);
  command->footer("What is not read is listed with its lines.\nExample: bentur import model.e2k --at 6 -o frame.toml");
  command->callback([arguments] { run(*arguments); });
}

}  // namespace bentur::cli
