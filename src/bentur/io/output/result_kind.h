#pragma once

#include <filesystem>
#include <string_view>

namespace bentur {

/// The files that bentur writes.
enum class ResultKind {
  summary,          ///< summary.json
  impacts,          ///< impacts.csv
  histories,        ///< histories.nc
  case_copy,        ///< case.toml beside them
  sweep,            ///< results of bentur sweep
  ida,              ///< results of bentur ida
  spectrum,         ///< a response spectrum as CSV
  report,           ///< HTML
  figure_script,    ///< NAME.py, of a figure
  figure_data,      ///< NAME-data.csv beside it
  picture,          ///< NAME.svg, .pdf or .png beside it
  schema,           ///< a JSON Schema for editors
  demands,          ///< a sample of demands for pelicun
  fragility_model,  ///< fragility functions in NRML
  taxonomy,         ///< GEM taxonomy of buildings
  remedy,           ///< a search of bentur remedy
  sensitivity,      ///< derivatives of bentur sensitivity
  imported,         ///< a case made from another program's model
  example           ///< a case or record built into the program
};

/// What such a file is called, with its article: "a report by bentur".
[[nodiscard]] std::string_view kind_name(ResultKind kind);

/// Begins samples of demands, stands in the head of fragility functions, begins lists of taxonomies.
inline constexpr std::string_view demands_mark = "realization by bentur,1-";
inline constexpr std::string_view nrml_mark = "<!-- written by bentur";
inline constexpr std::string_view taxonomy_mark = "building,taxonomy\n";

/// Begins every script of a figure.
inline constexpr std::string_view figure_script_mark = "# Draws the figure whose data stand beside this script";
/// Ends the name of its data, whose beginning is that of the script.
inline constexpr std::string_view figure_data_ending = "-data.csv";
/// Stands in the head of every report.
inline constexpr std::string_view report_mark = "<meta name=\"generator\" content=\"bentur";

/// Whether a regular file is a result of this kind that bentur has written, by its content (docs/result-files.md): what
/// a user has is never taken for one, a result that is damaged may not be known. Never an example, nor one of NetCDF,
/// which OutputRules::is_netcdf knows.
[[nodiscard]] bool is_result(const std::filesystem::path& file, ResultKind kind);

}  // namespace bentur
