#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <memory>
#include <string>
#include <string_view>

#include "arguments.h"
#include "bentur/files/example_files.h"
#include "commands.h"
#include "session.h"

namespace bentur::cli {
namespace {

struct ExampleArguments {
  std::string name;
  std::string directory = ".";
  bool force = false;
  bool no_schema = false;
};

void list_examples() {
  std::size_t widest = 0;
  for (const Example& example : examples()) {
    widest = std::max(widest, example.name.size());
  }
  bool told = false;
  for (const Example& example : examples()) {
    if (!example.command.empty() && !told) message("\nStudies:");
    told = told || !example.command.empty();
    print(fmt::format("{:<{}}  {}\n", example.name, widest, example.description));
  }
  message("\nWrite one with its ground motion, ready to edit: bentur example NAME -o DIR");
}

/// As a shell takes it for one word.
std::string shell_word(const std::string& text) {
  const auto plain = [](char c) { return std::string_view("_-./+,:@%=").find(c) != std::string_view::npos; };
  const auto is_plain = [&](unsigned char c) { return std::isalnum(c) != 0 || plain(static_cast<char>(c)); };
  if (std::all_of(text.begin(), text.end(), is_plain)) return text;
  std::string word = "'";
  for (const char c : text) word += c == '\'' ? "'\\''" : std::string(1, c);
  return word + "'";
}

void run(const ExampleArguments& arguments) {
  const std::vector<Example> all = examples();
  const auto example = std::find_if(all.begin(), all.end(), [&](const Example& e) { return e.name == arguments.name; });
  if (example == all.end()) {
    throw Failure(exit_bad_input, "no example \"" + arguments.name + "\"; `bentur example` lists them");
  }
  const std::filesystem::path file =
      write_example(*example, arguments.directory, {.force = arguments.force}, !arguments.no_schema);
  print(file.string() + "\n");
  const std::string word = shell_word(file.string());
  if (example->command.empty()) {
    message("Run it: bentur run " + word);
  } else if (example->command == "remedy") {
    message("Run it: bentur remedy " + word);
  } else {
    const std::string results = std::filesystem::path(file).replace_extension(".nc").string();
    message(fmt::format("Run it: bentur {} {} -o {}", example->command, word, shell_word(results)));
  }
}

}  // namespace

void add_example_command(CLI::App& app) {
  auto arguments = std::make_shared<ExampleArguments>();
  CLI::App* command = app.add_subcommand("example", "List the built-in examples, or write one out ready to edit");
  CLI::Option* name = command->add_option("NAME", arguments->name, "the example to write; without it they are listed")
                          ->check(not_empty());
  command->add_option("-o,--output", arguments->directory, "folder to write into, made if missing")
      ->type_name("DIR")
      ->capture_default_str()
      ->check(not_empty())
      ->needs(name);
  command->add_flag("--no-schema", arguments->no_schema, "without the schema for editors and the line that names it")
      ->needs(name);
  add_force(*command, arguments->force);
  command->footer(
      "Nothing that differs is overwritten without --force.\n\nExample: bentur example m12-el-centro -o mine");
  command->callback([arguments] { arguments->name.empty() ? list_examples() : run(*arguments); });
}

}  // namespace bentur::cli
