#include <memory>

#include "arguments.h"
#include "bentur/files/schema_files.h"
#include "commands.h"
#include "output/output.h"
#include "session.h"

namespace bentur::cli {
namespace {

struct SchemaArguments {
  std::string what = "case";
  std::string output;
  bool force = false;
};

void run(const SchemaArguments& arguments) {
  const SchemaOf what = arguments.what == "study" ? SchemaOf::study : SchemaOf::a_case;
  if (arguments.output.empty()) {
    print(schema_text(what));
    return;
  }
  write_schema(what, arguments.output, {.force = arguments.force});
  message("The comment at the head of a file beside it may end with the line\n#:schema ./" +
          std::filesystem::path(arguments.output).filename().string());
}

}  // namespace

void add_schema_command(CLI::App& app) {
  auto arguments = std::make_shared<SchemaArguments>();
  CLI::App* command = app.add_subcommand("schema", "Write the JSON Schema of a case or a study, for editors");
  command->add_option("WHAT", arguments->what, "case or study")
      ->capture_default_str()
      ->check(CLI::IsMember({"case", "study"}));
  command->add_option("-o,--output", arguments->output, "file to write; without it the schema is printed")
      ->type_name("FILE")
      ->check(not_empty());
  add_force(*command, arguments->force);
  command->footer("Example: bentur schema -o bentur.schema.json");
  command->callback([arguments] { run(*arguments); });
}

}  // namespace bentur::cli
