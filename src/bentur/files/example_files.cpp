#include "bentur/files/example_files.h"

#include <algorithm>

#include "bentur/files/schema_files.h"
#include "bentur/io/input_file.h"
#include "bentur/io/output/atomic_file.h"

namespace bentur {
namespace {

constexpr std::string_view default_example = "m12-el-centro";

std::string_view description_of(std::string_view content) {
  const std::string_view line = content.substr(0, content.find('\n'));
  const std::size_t start = line.find_first_not_of("# ");
  return start == std::string_view::npos ? std::string_view{} : line.substr(start);
}

/// What a study is for; empty of a case.
std::string_view command_of(std::string_view content) {
  if (content.find("\n[[vary]]") == std::string_view::npos) return {};
  for (const std::string_view command : {"ida", "remedy"}) {
    if (content.find("\n[" + std::string(command) + "]") != std::string_view::npos) return command;
  }
  return "sweep";
}

/// The files that those of an example name, one after the other.
void add_named(Example& example) {
  for (std::size_t i = 0; i < example.files.size(); ++i) {
    for (const EmbeddedFile& other : embedded_files()) {
      const bool is_named =
          example.files[i]->content.find("\"" + std::string(other.name) + "\"") != std::string_view::npos;
      const bool is_new = std::find(example.files.begin(), example.files.end(), &other) == example.files.end();
      if (is_named && is_new) example.files.push_back(&other);
    }
  }
  std::stable_partition(example.files.begin() + 1, example.files.end(),
                        [](const EmbeddedFile* file) { return file->name.ends_with(".toml"); });
}

}  // namespace

std::vector<Example> examples() {
  std::vector<Example> result;
  for (const EmbeddedFile& file : embedded_files()) {
    if (!file.name.ends_with(".toml")) {
      continue;
    }
    Example example{.name = file.name.substr(0, file.name.size() - 5),
                    .description = description_of(file.content),
                    .files = {&file},
                    .command = command_of(file.content)};
    add_named(example);
    result.push_back(std::move(example));
  }
  std::sort(result.begin(), result.end(), [](const Example& a, const Example& b) {
    const bool a_later = a.name != default_example;
    const bool b_later = b.name != default_example;
    if (a.command.empty() != b.command.empty()) return a.command.empty();
    return a_later != b_later ? b_later : a.name < b.name;
  });
  return result;
}

std::filesystem::path write_example(const Example& example, const std::filesystem::path& directory,
                                    const OutputRules& rules, bool schema) {
  AtomicFiles output(directory, rules);
  for (const EmbeddedFile* file : example.files) {
    const std::filesystem::path path = directory / file->name;
    const bool names_schema = schema && file->name.ends_with(".toml");
    const bool is_study = !command_of(file->content).empty();
    const std::string_view of = is_study ? study_schema_file_name : schema_file_name;
    const std::string content = names_schema ? with_schema_line(file->content, of) : std::string(file->content);
    if (std::filesystem::is_regular_file(path)) {
      std::string problem;
      if (read_input(path, record_input, problem) == content) continue;
    }
    output.add(std::string(file->name), content, ResultKind::example);
  }
  if (schema) output.add(std::string(schema_file_name), schema_text(SchemaOf::a_case), ResultKind::schema);
  if (schema && !example.command.empty()) {
    output.add(std::string(study_schema_file_name), schema_text(SchemaOf::study), ResultKind::schema);
  }
  output.commit();
  return directory / example.files.front()->name;
}

}  // namespace bentur
