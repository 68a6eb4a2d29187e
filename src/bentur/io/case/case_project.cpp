#include <fmt/format.h>

#include <string>

#include "bentur/io/case/case_parts.h"
#include "bentur/io/input_file.h"
#include "bentur/io/schema/case_keys.h"
#include "bentur/io/schema/table_view.h"

namespace bentur {
namespace {

constexpr const char* svg_namespace = "http://www.w3.org/2000/svg";

std::vector<std::string> read_lines(const TableView& view, const char* key) {
  std::vector<std::string> lines;
  const auto list = view.find(key);
  if (!list || !list->is_list_of("texts")) return lines;
  for (const TomlView& one : list->items()) lines.push_back(one.as_line().value_or(""));
  return lines;
}

/// Media type of a picture by its first bytes, or of an SVG by its namespace, without which no browser draws it; empty
/// of anything else.
std::string image_type(const std::string& bytes) {
  if (bytes.starts_with("\x89PNG\r\n\x1A\n")) return "image/png";
  if (bytes.starts_with("\xFF\xD8\xFF")) return "image/jpeg";
  const bool is_svg = bytes.find("<svg") != std::string::npos && bytes.find(svg_namespace) != std::string::npos;
  return is_svg ? "image/svg+xml" : "";
}

void read_logo(const TomlView& key, const std::filesystem::path& folder, Diagnostics& diagnostics,
               ProjectSpec& project) {
  const auto name = key.as_text();
  const auto path = name ? input_path(key, *name, folder, logo_input) : std::nullopt;
  if (!path) return;
  const auto bytes = read_input(*path, logo_input, diagnostics);
  if (!bytes) return;
  project.logo_type = image_type(*bytes);
  if (project.logo_type.empty()) {
    key.error_value(fmt::format("must be a picture: PNG, JPEG, or SVG with xmlns=\"{}\"", svg_namespace));
    return;
  }
  project.logo = *bytes;
  project.logo_path = path->string();
}

}  // namespace

std::optional<ProjectSpec> read_project(const TomlView& root, const std::filesystem::path& folder,
                                        Diagnostics& diagnostics) {
  const auto view = TableView(root, case_keys()).table("project");
  if (!view) return std::nullopt;
  ProjectSpec project;
  for (const auto& [key, value] :
       {std::pair("name", &ProjectSpec::name), std::pair("number", &ProjectSpec::number),
        std::pair("engineer", &ProjectSpec::engineer), std::pair("date", &ProjectSpec::date),
        std::pair("revision", &ProjectSpec::revision), std::pair("code_basis", &ProjectSpec::code_basis)}) {
    if (const auto given = view->find(key)) project.*value = given->as_line().value_or("");
  }
  project.assumptions = read_lines(*view, "assumptions");
  project.sources = read_lines(*view, "sources");
  if (const auto logo = view->find("logo")) read_logo(*logo, folder, diagnostics, project);
  return project;
}

}  // namespace bentur
