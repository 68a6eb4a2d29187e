#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "bentur/io/output/output_rules.h"

namespace bentur {

/// A file of examples/, examples/studies/ or data/ as it stood when the program was built.
struct EmbeddedFile {
  std::string_view name;  ///< "m12-el-centro.toml"
  std::string_view content;
};

/// All of them, in the order of the build.
[[nodiscard]] std::span<const EmbeddedFile> embedded_files();

/// A case built into the program, or a study of one.
struct Example {
  std::string_view name;                   ///< "m12-el-centro"
  std::string_view description;            ///< the first comment line of its file
  std::vector<const EmbeddedFile*> files;  ///< itself first, then the case of a study, then the records they name
  std::string_view command = {};           ///< of a study what it is for: "sweep", "ida" or "remedy"; empty: a case
};

/// Cases, the default one first, then studies, both by name.
[[nodiscard]] std::vector<Example> examples();

/// Writes an example's files into `directory`, which is made if missing.
/// A file that is there already with other content is not overwritten unless forced.
/// @param schema for editors: the case names the one beside it, which is written too
/// @return the path of the case. @throws as AtomicFiles; nothing is written then.
std::filesystem::path write_example(const Example& example, const std::filesystem::path& directory,
                                    const OutputRules& rules = {}, bool schema = false);

}  // namespace bentur
