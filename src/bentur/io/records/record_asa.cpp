// ASA 2.0, the standard file of accelerations of Mexico: lines of "KEY : value", where what is of each
// channel stands in a list "/0.005/0.005/0.005", and a row of accelerations for each moment, in fields of the format
// stated.

#include <fmt/format.h>

#include <algorithm>

#include "bentur/io/records/internal/channels.h"
#include "bentur/io/records/internal/record_text.h"

namespace bentur::records {
namespace {

bool heads_asa(const Line& line) { return line.says("ARCHIVO ESTANDAR DE ACELERACION"); }

constexpr std::size_t asa_furthest_mark = 30;  // line that says what the file is

/// What stands behind the colon of the first line that begins so; no text where there is none.
Token asa_value(std::span<const Line> lines, std::string_view key) {
  for (const Line& line : lines) {
    const std::size_t colon = line.text.find(':');
    if (colon == std::string_view::npos || !upper(line.text).starts_with(key)) continue;
    const std::string_view value = trimmed(line.text.substr(colon + 1));
    return {value, line.number, static_cast<int>(value.empty() ? colon : value.data() - line.text.data()) + 1};
  }
  return {};
}

/// The line that the values begin behind: a ruler, the numbers of the channels, their names, a ruler again.
std::size_t asa_values(const std::vector<Line>& lines) {
  std::size_t at = 0;
  while (at < lines.size() && !lines[at].says("DATOS DE ACELERACION")) ++at;
  for (++at; at < lines.size(); ++at) {
    const auto words = words_of(lines[at]);
    const auto numeric = [](const Token& word) { return number_of(word.text, true).has_value(); };
    if (!words.empty() && std::all_of(words.begin(), words.end(), numeric)) return at;
  }
  return lines.size();
}

/// Rows beyond the stated number that repeat the last one fill up a block of the recorder.
void leave_out_padding(const Heading& heading, ChannelPlace channel, std::vector<double>& values) {
  for (const Statement& said : heading.counts) {
    if (said.of == channel.of && said.place != channel.place) continue;
    const auto count = static_cast<std::size_t>(said.value);
    if (count == 0 || count >= values.size()) continue;
    const auto repeats = [&](double value) { return value == values[count - 1]; };
    if (std::all_of(values.begin() + static_cast<std::ptrdiff_t>(count), values.end(), repeats)) values.resize(count);
  }
}

std::vector<std::string> asa_names(const Token& list) {
  std::vector<std::string> names;
  for (const Token& name : words_of({list.text, list.line}, "/")) {
    names.emplace_back(trimmed(name.text.substr(0, name.text.find(';'))));  // "N90E;+"
  }
  return names;
}

}  // namespace

bool looks_like_asa(const std::vector<Line>& lines) {
  const auto head = std::span(lines).subspan(0, std::min(lines.size(), asa_furthest_mark));
  return std::any_of(head.begin(), head.end(), heads_asa);
}

std::optional<StrongMotionRecord> read_asa(const std::vector<Line>& lines, const RecordOptions& options,
                                           RecordErrors& errors) {
  const std::size_t first = asa_values(lines);
  const auto head = std::span(lines).subspan(0, std::min(first, lines.size()));
  const Token units = asa_value(head, "UNIDADES DE LOS DATOS"), format = asa_value(head, "FORMATO DATOS"),
              names = asa_value(head, "ORIENTACION C1-C6");
  ComponentColumns columns;
  columns.names = asa_names(names);
  if (first == lines.size() || units.line == 0 || columns.names.empty()) {
    return errors.error(
        "is no asa file: its heading must have the lines \"UNIDADES DE LOS DATOS\" and \"ORIENTACION C1-C6\", and "
        "values must follow \"DATOS DE ACELERACION\"");
  }
  const auto unit = file_unit(units.text.substr(0, units.text.find('(')));
  if (!unit) return errors.error(units, shown(units.text) + " is no unit of acceleration that is known");
  const Heading heading = read_heading(head);
  StrongMotionRecord record;
  record.unit = unit->unit;
  record.unit_line = units.line;
  record.header_lines = static_cast<int>(first);
  columns.width = field_width("(" + std::string(format.text) + ")");
  const auto channel = read_component(lines, first, columns, options, record, errors);
  if (!channel) return std::nullopt;
  for (double& value : record.values) value *= unit->factor;
  record.time_step = stated_step(heading, *channel, record.step_line, errors);
  leave_out_padding(heading, *channel, record.values);
  if (errors.ok()) check_stated_count(heading, record.values.size(), *channel, errors);
  if (errors.ok()) check_peak(heading, record.values, record.unit, *channel, "", errors);
  return record;
}

}  // namespace bentur::records
