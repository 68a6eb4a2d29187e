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

}  // namespace

std::vector<Example> examples() {
  std::vector<Example> result;
  for (const EmbeddedFile& file : embedded_files()) {
    if (!file.name.ends_with(".toml")) {
      continue;
    }
    Example example{.name = file.name.substr(0, file.name.size() - 5),
                    .description = description_of(file.content),
                    .files = {&file}};
    for (const EmbeddedFile& record : embedded_files()) {
      if (!record.name.ends_with(".toml") && file.content.find(record.name) != std::string_view::npos) {
        example.files.push_back(&record);
      }
    }
    result.push_back(std::move(example));
  }
  std::sort(result.begin(), result.end(), [](const Example& a, const Example& b) {
    const bool a_later = a.name != default_example;
    const bool b_later = b.name != default_example;
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
    const std::string content = names_schema ? with_schema_line(file->content) : std::string(file->content);
    if (std::filesystem::is_regular_file(path)) {
      std::string problem;
      if (read_input(path, record_input, problem) == content) continue;
    }
    output.add(std::string(file->name), content, ResultKind::example);
  }
  if (schema) output.add(std::string(schema_file_name), schema_text(SchemaOf::a_case), ResultKind::schema);
  output.commit();
  return directory / example.files.front()->name;
}

}  // namespace bentur
