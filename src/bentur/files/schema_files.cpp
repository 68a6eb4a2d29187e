#include "bentur/files/schema_files.h"

#include <algorithm>

#include "bentur/io/output/atomic_file.h"
#include "bentur/io/schema/case_keys.h"
#include "bentur/io/schema/json_schema.h"
#include "bentur/study/design/study_keys.h"

namespace bentur {

std::string schema_text(SchemaOf what) {
  return what == SchemaOf::study ? json_schema(study_keys(), "A study of bentur")
                                 : json_schema(case_keys(), "A case of bentur");
}

std::string with_schema_line(std::string_view text, std::string_view schema) {
  std::size_t end = 0;
  while (end < text.size() && text[end] == '#') end = std::min(text.find('\n', end), text.size() - 1) + 1;
  std::string made(text.substr(0, end));
  made += "#:schema ./" + std::string(schema) + "\n";
  return made + std::string(text.substr(end));
}

void write_schema(SchemaOf what, const std::filesystem::path& file, const OutputRules& rules) {
  AtomicFiles output(file.parent_path().empty() ? "." : file.parent_path(), rules);
  output.add(file.filename().string(), schema_text(what), ResultKind::schema);
  output.commit();
}

}  // namespace bentur
