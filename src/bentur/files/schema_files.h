#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "bentur/io/output/output_rules.h"

namespace bentur {

/// Beside a case, what an editor completes and checks it by.
inline constexpr std::string_view schema_file_name = "bentur.schema.json";
inline constexpr std::string_view study_schema_file_name = "bentur-study.schema.json";  ///< the same beside a study

enum class SchemaOf { a_case, study };

/// The JSON Schema of a case or of a study (io/schema/json_schema.h).
[[nodiscard]] std::string schema_text(SchemaOf what);

/// The text of a file with the line that names its schema, "#:schema ./bentur.schema.json", as the last one of the
/// comment at its head.
[[nodiscard]] std::string with_schema_line(std::string_view text, std::string_view schema = schema_file_name);

/// Writes a schema. @throws as AtomicFiles; a file that is no schema of bentur is not replaced unless forced.
void write_schema(SchemaOf what, const std::filesystem::path& file, const OutputRules& rules = {});

}  // namespace bentur
