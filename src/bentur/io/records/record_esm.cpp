// ASCII files of ESM and ITACA: lines of "KEY: value", 64 in the present version, then one value a line.

#include <fmt/format.h>

#include <cmath>

#include "bentur/io/records/internal/heading.h"
#include "bentur/io/records/internal/record_text.h"

namespace bentur::records {
namespace {

/// Index of the first line that is no "KEY: value": keys are capitals, digits and signs without a blank.
std::size_t esm_header_end(const std::vector<Line>& lines) {
  std::size_t i = 0;
  for (; i < lines.size(); ++i) {
    const std::size_t colon = lines[i].text.find(':');
    if (colon == 0 || colon == std::string_view::npos) break;
    const std::string_view key = lines[i].text.substr(0, colon);
    if (key[0] < 'A' || key[0] > 'Z' || key.find(' ') != std::string_view::npos) break;
  }
  return i;
}

/// What stands behind the first colon of the line with the key, and its place; no text where there is none.
Token esm_value(const std::vector<Line>& lines, std::size_t end, std::string_view key) {
  for (std::size_t i = 0; i < end; ++i) {
    if (lines[i].text.substr(0, lines[i].text.find(':')) != key) continue;
    const std::string_view value = trimmed(lines[i].text.substr(key.size() + 1));
    const auto column =
        value.empty() ? key.size() + 2 : static_cast<std::size_t>(value.data() - lines[i].text.data()) + 1;
    return {value, lines[i].number, static_cast<int>(column)};
  }
  return {};
}

}  // namespace

bool looks_like_esm(const std::vector<Line>& lines) {
  const std::size_t end = esm_header_end(lines);
  const auto has = [&](std::string_view key) { return esm_value(lines, end, key).line > 0; };
  return has("SAMPLING_INTERVAL_S") && has("NDATA") && has("UNITS");
}

std::optional<StrongMotionRecord> read_esm(const std::vector<Line>& lines, const RecordOptions& /*options*/,
                                           RecordErrors& errors) {
  const std::size_t end = esm_header_end(lines);
  const auto value = [&](std::string_view key) {
    const Token token = esm_value(lines, end, key);
    if (token.line == 0) errors.error(fmt::format("is no esm file: it has no header line {}", key));
    return token;
  };
  const Token interval = value("SAMPLING_INTERVAL_S"), count = value("NDATA"), units = value("UNITS");
  if (!errors.ok()) return std::nullopt;
  const Token type = esm_value(lines, end, "DATA_TYPE");
  if (type.line > 0 && upper(type.text) != "ACCELERATION") {
    errors.error(type, fmt::format("the file holds {}, but ground accelerations are needed", shown(type.text)));
  }
  const auto unit = file_unit(units.text);
  if (!unit) errors.error(units, shown(units.text) + " is no unit of acceleration that is known");
  const double step = number_of(interval.text).value_or(0);
  if (!(std::isfinite(step) && step > 0)) errors.error(interval, shown(interval.text) + " must be a step > 0 s");
  const double expected = number_of(count.text).value_or(0);
  if (!(expected >= 1)) errors.error(count, shown(count.text) + " must be the number of values");
  if (!errors.ok()) return std::nullopt;

  StrongMotionRecord record;
  record.unit = unit->unit;
  record.unit_line = units.line;
  record.time_step = step;
  record.step_line = interval.line;
  record.component = esm_value(lines, end, "STREAM").text;
  record.header_lines = static_cast<int>(end);
  record.values = read_numbers(std::span(lines).subspan(end), 0, errors);
  for (double& number : record.values) number *= unit->factor;
  if (!errors.ok()) return std::nullopt;
  if (static_cast<double>(record.values.size()) != expected) {
    return errors.error(count,
                        fmt::format("NDATA is {}, but the file holds {} values", count.text, record.values.size()));
  }
  check_peak(read_heading(std::span(lines).subspan(0, end)), record.values, record.unit, {}, "", errors);
  return record;
}

}  // namespace bentur::records
