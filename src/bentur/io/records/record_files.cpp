#include "bentur/io/records/record_files.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <string_view>

#include "bentur/core/number_text.h"
#include "bentur/core/text.h"
#include "bentur/io/input_file.h"
#include "bentur/io/records/internal/components.h"
#include "bentur/io/records/internal/record_text.h"

namespace bentur::records {
namespace {

/// What the user may choose by: of a file with one channel nothing, of blocks one behind the other channel or
/// component, of columns side by side also the column.
enum class Choice { none, channels, columns };

struct RecordFormat {
  std::string_view name;
  bool (*looks_like)(const std::vector<Line>& lines);
  RecordReader* read;
  Choice choice = Choice::none;
  bool mixed = true;  ///< its numbers are not accelerations alone, so that it is not read as columns or row by row
};

/// Those with marks of their own, in the order they are tried; columns are what is left.
constexpr RecordFormat marked_formats[] = {
    {"cosmos", looks_like_cosmos, read_cosmos, Choice::channels},
    {"geonet", looks_like_geonet, read_geonet, Choice::channels},
    {"csmip", looks_like_csmip, read_csmip, Choice::channels},
    {"bhrc", looks_like_bhrc, read_bhrc, Choice::channels},
    {"smc", looks_like_smc, read_smc},
    {"knet", looks_like_knet, read_knet},
    {"knet-csv", looks_like_knet_csv, read_knet_csv, Choice::columns, false},
    {"afad", looks_like_afad, read_afad, Choice::columns, false},
    {"asa", looks_like_asa, read_asa, Choice::columns, false},
    {"esm", looks_like_esm, read_esm, Choice::none, false},
    {"peer-at2", looks_like_peer, read_peer, Choice::none, false},
};

/// Of a file of one component: whether it is the one that the user asks for.
void check_component(const std::string& own, const RecordOptions& options, RecordErrors& errors) {
  const std::string asked = options.setting("component", *options.component);
  if (own.empty()) {
    errors.error(fmt::format("names no component, so that {} cannot be held against it: leave it out", asked));
  } else if (!same_component(own, *options.component)) {
    errors.error(fmt::format("is of the component {}, but {} is given", in_words(own), asked));
  }
}

std::optional<StrongMotionRecord> read_lines(const std::vector<Line>& lines, const RecordOptions& options,
                                             RecordErrors& errors) {
  const auto* const format = std::find_if(std::begin(marked_formats), std::end(marked_formats), [&](const auto& one) {
    return options.format == one.name || (options.format == "auto" && one.looks_like(lines));
  });
  if (format == std::end(marked_formats)) {
    const auto* const own = std::find_if(std::begin(marked_formats), std::end(marked_formats),
                                         [&](const auto& one) { return one.mixed && one.looks_like(lines); });
    if (own == std::end(marked_formats)) return read_columns(lines, options, errors);
    return errors.error(fmt::format("is a {} file, whose numbers are not accelerations alone: leave {} out", own->name,
                                    options.setting("format", options.format)));
  }
  if (options.column && format->choice != Choice::columns) {
    errors.error(fmt::format("is a {} file, which has no columns to choose from", format->name));
  }
  if (format->choice == Choice::none && options.channel.value_or(1) != 1) {
    errors.error(fmt::format("is a {} file, which has one channel: {} is not there", format->name,
                             options.setting("channel", std::to_string(*options.channel))));
  }
  std::optional<StrongMotionRecord> record = format->read(lines, options, errors);
  if (!record) return record;
  record->format = format->name;
  if (options.component && format->choice == Choice::none) check_component(record->component, options, errors);
  return record;
}

/// Why a file is no text, or nothing.
std::string not_text(std::string_view text) {
  if (text.substr(0, 4) == "PK\x03\x04") {
    return "is a spreadsheet or a zip archive: export the record as CSV, or unpack it";
  }
  const std::size_t end = text.find_last_not_of(std::string_view("\0\x1A", 2));  // zeros fill up the last block
  const std::string_view written = end == std::string_view::npos ? text : text.substr(0, end + 1);
  return written.find('\0') != std::string_view::npos ? "is a binary file, but records are text" : "";
}

/// The place of a date such as 10/28/83 or 5/19/1940 in a text, and its length; nothing where there is none.
std::optional<std::pair<std::size_t, std::size_t>> date_in(const std::string& text) {
  const auto is_digit = [&](std::size_t i) { return i < text.size() && text[i] >= '0' && text[i] <= '9'; };
  for (std::size_t from = 0; from < text.size(); ++from) {
    if (!is_digit(from) || (from > 0 && is_digit(from - 1))) continue;
    std::size_t at = from;
    std::size_t parts = 0;
    while (parts < 3 && is_digit(at)) {
      while (is_digit(at)) ++at;
      ++parts;
      if (parts < 3 && at < text.size() && text[at] == '/') ++at;
    }
    if (parts == 3 && at - from >= 6 && text.find('/', from) < at) return std::pair(from, at - from);
  }
  return std::nullopt;
}

/// The earthquake: of a PEER file the name before the date of its second line, and the date; of one of ./dev records
/// name and year in its first. Two that say the same in the same words are one.
std::string event_of(const std::vector<Line>& lines, const std::string& format) {
  const auto name_in = [](std::string_view part) { return std::string(trimmed(part, " \t#,")); };
  if (format == "peer-at2" && lines.size() > 1) {
    const std::string text = upper(lines[1].text);
    const auto date = date_in(text);
    if (!date) return "";
    std::string name = name_in(std::string_view(text).substr(0, date->first));
    if (name.ends_with(" EQ")) name = name_in(std::string_view(name).substr(0, name.size() - 3));
    return name.empty() ? "" : name + " " + text.substr(date->first, date->second);
  }
  if (format == "peer-at2" || !lines.front().text.starts_with('#')) return "";
  const std::string text = upper(lines.front().text);
  const std::size_t end = text.find(", M ");
  return end == std::string::npos ? "" : name_in(std::string_view(text).substr(0, end));
}

}  // namespace
}  // namespace bentur::records

namespace bentur {

std::string RecordOptions::name(const std::string& key) const {
  if (!of_command) return "excitation." + key;
  std::string option = "--" + key;
  std::replace(option.begin(), option.end(), '_', '-');
  return option;
}

std::string RecordOptions::setting(const std::string& key, const std::string& value) const {
  if (of_command) return name(key) + " " + value;
  const bool text = key == "component" || value.find_first_not_of("0123456789") != std::string::npos;
  return name(key) + (text ? " = \"" + value + "\"" : " = " + value);
}

const std::vector<std::string>& record_formats() {
  static const std::vector<std::string> formats = {"auto",     "peer-at2", "two-column", "one-column", "values", "csv",
                                                   "cosmos",   "csmip",    "bhrc",       "geonet",     "smc",    "knet",
                                                   "knet-csv", "esm",      "afad",       "asa"};
  return formats;
}

std::optional<StrongMotionRecord> read_record(const std::filesystem::path& file, const RecordOptions& options,
                                              Diagnostics& diagnostics) {
  std::string problem;
  auto bytes = read_input(file, record_input, problem);
  if (!bytes) return records::RecordErrors(file.string(), diagnostics).error(problem);
  return record_of(*std::move(bytes), file.string(), options, diagnostics);
}

std::optional<StrongMotionRecord> record_of(std::string bytes, const std::string& name, const RecordOptions& options,
                                            Diagnostics& diagnostics) {
  using namespace records;
  RecordErrors errors(name, diagnostics);
  const std::string text = decoded(std::move(bytes));
  std::vector<Line> lines = lines_of(text);
  const auto skipped = std::min(static_cast<std::size_t>(options.skip_lines), lines.size());
  lines.erase(lines.begin(), lines.begin() + static_cast<std::ptrdiff_t>(skipped));
  if (lines.size() > most_lines) {
    return errors.error(fmt::format("has more than {} lines, which no record has", most_lines));
  }
  for (const Line& line : lines) {
    if (line.text.size() <= longest_line) continue;
    return errors.error(line, fmt::format("is a line of more than {} MiB, which no record has", longest_line >> 20));
  }
  const std::string problem = not_text(text);
  if (!problem.empty()) return errors.error(problem);
  const bool blank = std::all_of(lines.begin(), lines.end(), [](const Line& line) {
    return line.text.find_first_not_of(" \t") == std::string_view::npos;
  });
  if (blank) {
    return errors.error(
        skipped > 0 ? fmt::format("holds nothing behind the {} lines of {}", skipped, options.name("skip_lines"))
                    : "is empty");
  }
  auto record = read_lines(lines, options, errors);
  if (record && record->values.size() < 2) errors.error("holds one value only, a record needs two or more");
  if (!record || !errors.ok()) return std::nullopt;
  record->header_lines += static_cast<int>(skipped);
  record->event = event_of(lines, record->format);
  return record;
}

std::vector<RecordContradiction> contradictions(const StrongMotionRecord& record, const RecordOptions& options) {
  std::vector<RecordContradiction> found;
  const auto in_line = [](int line) { return line == 0 ? "" : fmt::format(" in line {}", line); };
  // A step that rounding explains is let pass; the file's own is used.
  if (options.time_step && std::abs(*options.time_step / record.time_step - 1) > 0.01) {
    found.push_back({"time_step", fmt::format("{:.6g} s", *options.time_step),
                     fmt::format("{:.6g} s{}", record.time_step, in_line(record.step_line)), record.step_line});
  }
  if (!options.unit.empty() && !record.unit.empty() && options.unit != record.unit) {
    found.push_back(
        {"unit", "\"" + options.unit + "\"", "\"" + record.unit + "\"" + in_line(record.unit_line), record.unit_line});
  }
  return found;
}

RecordEcho echo_of(const StrongMotionRecord& record, const std::string& file, const std::string& unit) {
  RecordEcho echo;
  echo.file = file;
  echo.format = record.format;
  echo.unit = unit;
  echo.channel = record.channel;
  echo.header_lines = record.header_lines;
  echo.mean_removed = record.mean_removed;
  echo.time_step = record.time_step;
  echo.count = static_cast<long>(record.values.size());
  echo.duration = static_cast<double>(echo.count - 1) * echo.time_step;
  for (const double value : record.values) echo.pga_read = std::max(echo.pga_read, std::abs(value));
  return echo;
}

std::string echo_notes(const RecordEcho& echo) {
  std::string text;
  if (!echo.channel.empty()) text += ", " + echo.channel;
  if (echo.header_lines > 0) text += ", " + counted(static_cast<std::size_t>(echo.header_lines), "header line");
  if (echo.reversed) text += ", reversed";
  if (echo.mean_removed != 0) text += fmt::format(", mean {:.4g} {} removed", echo.mean_removed, echo.unit);
  return text;
}

}  // namespace bentur
