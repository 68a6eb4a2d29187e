// Text of AFAD (Turkiye): lines of "KEY : value", among them "NUMBER OF DATA" and "SAMPLING INTERVAL (sec)", a line
// that names the components, and a row of accelerations in gal for each moment.

#include <algorithm>

#include "bentur/io/records/internal/channels.h"
#include "bentur/io/records/internal/record_text.h"

namespace bentur::records {
namespace {

constexpr std::size_t afad_most_headers = 40;  // lines

bool heads_afad(const Line& line) { return line.says("STRONG GROUND MOTION RECORDS OF TURKIYE"); }

/// The line behind the heading that names the components, as "N-S E-W U-D"; the end where there is none.
std::size_t afad_names(const std::vector<Line>& lines) {
  const std::size_t most = std::min(lines.size(), afad_most_headers);
  for (std::size_t i = 1; i < most; ++i) {
    const auto words = words_of(lines[i]);
    const auto is_name = [](const Token& word) { return word.text.size() <= 4 && !number_of(word.text); };
    if (!words.empty() && words.size() <= 3 && std::all_of(words.begin(), words.end(), is_name)) return i;
  }
  return lines.size();
}

}  // namespace

bool looks_like_afad(const std::vector<Line>& lines) { return !lines.empty() && heads_afad(lines[0]); }

std::optional<StrongMotionRecord> read_afad(const std::vector<Line>& lines, const RecordOptions& options,
                                            RecordErrors& errors) {
  const std::size_t names = afad_names(lines);
  if (names == lines.size()) {
    return errors.error("is no afad file: no line names the components, as \"N-S  E-W  U-D\"");
  }
  const Heading heading = read_heading(std::span(lines).subspan(0, names));
  StrongMotionRecord record;
  record.unit = "cm/s2";
  record.header_lines = static_cast<int>(names) + 1;
  ComponentColumns columns;
  for (const Token& name : words_of(lines[names])) columns.names.emplace_back(name.text);
  const auto channel = read_component(lines, names + 1, columns, options, record, errors);
  if (!channel) return std::nullopt;
  record.time_step = stated_step(heading, *channel, record.step_line, errors);
  if (errors.ok()) check_stated_count(heading, record.values.size(), *channel, errors);
  if (errors.ok()) check_peak(heading, record.values, record.unit, *channel, "", errors);
  for (const Statement& said : heading.peaks) record.unit_line = said.line;
  return record;
}

}  // namespace bentur::records
