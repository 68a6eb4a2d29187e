#include "bentur/io/output/result_kind.h"

#include <cstddef>
#include <fstream>
#include <initializer_list>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>

#include "bentur/io/file_identity.h"

namespace bentur {
namespace {

namespace fs = std::filesystem;
using FoundJson = nlohmann::json;

/// At most so many bytes from a file's beginning.
std::string beginning(const fs::path& file, std::size_t most) {
  std::ifstream stream(file, std::ios::binary);
  std::string text(most, '\0');
  stream.read(text.data(), static_cast<std::streamsize>(most));
  text.resize(static_cast<std::size_t>(stream.gcount()));
  return text;
}

FoundJson json_of(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return FoundJson::parse(stream, nullptr, false);
}

bool has_keys(const FoundJson& json, std::initializer_list<const char*> keys) {
  if (!json.is_object()) return false;
  for (const char* key : keys) {
    if (!json.contains(key)) return false;
  }
  return true;
}

/// A copy that nobody has changed: the summary beside it says that it was made, and of what content.
bool is_untouched_copy(const fs::path& file) {
  const FoundJson summary = json_of(file.parent_path() / "summary.json");
  if (!has_keys(summary, {"case"})) return false;
  const FoundJson& source = summary["case"];
  return has_keys(source, {"copied", "sha256"}) && source["copied"] == true &&
         source["sha256"] == identify(file).sha256;
}

}  // namespace

std::string_view kind_name(ResultKind kind) {
  static constexpr std::string_view names[] = {
      // in the order of the kinds
      "a summary of bentur run",
      "a list of impacts of bentur run",
      "histories of bentur run",
      "the copy of a case that bentur run has made, unchanged since",
      "results of bentur sweep",
      "results of bentur ida",
      "a response spectrum of bentur spectrum",
      "a report of bentur report",
      "the script of a figure by bentur",
      "data of a figure by bentur, whose script would stand beside them",
      "a figure by bentur, whose script would stand beside it",
      "a schema of bentur schema",
      "demands of bentur export",
      "fragility functions of bentur export",
      "taxonomies of bentur export",
      "a search of bentur remedy",
      "derivatives of bentur sensitivity",
      "the imported case",
      "the example",
  };
  return names[static_cast<std::size_t>(kind)];
}

bool is_result(const fs::path& file, ResultKind kind) {
  switch (kind) {
    case ResultKind::summary:
      return has_keys(json_of(file), {"version", "solver", "excitation", "buildings", "gaps"});
    case ResultKind::impacts:
      return beginning(file, 64).starts_with("left,right,elevation [");
    case ResultKind::case_copy:
      return is_untouched_copy(file);
    case ResultKind::demands:
      return beginning(file, demands_mark.size()) == demands_mark;
    case ResultKind::fragility_model:
      return beginning(file, 256).find(nrml_mark) != std::string::npos;
    case ResultKind::taxonomy:
      return beginning(file, taxonomy_mark.size()) == taxonomy_mark;
    case ResultKind::spectrum:
      return beginning(file, 64).starts_with("period [s],displacement [");
    case ResultKind::report:
      return beginning(file, 1024).find(report_mark) != std::string::npos;
    case ResultKind::figure_script:
      return beginning(file, figure_script_mark.size()) == figure_script_mark;
    case ResultKind::figure_data: {
      const std::string name = file.filename().string();
      return name.ends_with(figure_data_ending) &&
             is_result(file.parent_path() / (name.substr(0, name.size() - figure_data_ending.size()) + ".py"),
                       ResultKind::figure_script);
    }
    case ResultKind::picture: {
      fs::path script = file;
      return is_result(script.replace_extension(".py"), ResultKind::figure_script);
    }
    case ResultKind::remedy:
      return has_keys(json_of(file), {"version", "objective", "parameters", "smallest", "evaluations"});
    case ResultKind::sensitivity:
      return has_keys(json_of(file), {"version", "numbers", "left_out", "peaks"});
    case ResultKind::schema: {
      const FoundJson schema = json_of(file);
      return has_keys(schema, {"$schema", "title"}) && schema["title"].is_string() &&
             schema["title"].get<std::string>().ends_with(" of bentur");
    }
    case ResultKind::histories:
    case ResultKind::sweep:
    case ResultKind::ida:
    case ResultKind::imported:
    case ResultKind::example:
      break;
  }
  return false;
}

}  // namespace bentur
