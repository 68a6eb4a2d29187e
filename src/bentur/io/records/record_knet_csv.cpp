// K-NET and KiK-net as CSV, which NIED offers since 2023: lines that begin with "#", each of names and one of values
// below it, then the time of the day, seconds, and accelerations in gal. They hold the instrument's offset, so that the
// mean is taken off.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>

#include "bentur/io/records/internal/channels.h"
#include "bentur/io/records/internal/column_rows.h"
#include "bentur/io/records/internal/record_text.h"

namespace bentur::records {
namespace {

/// "#Time,RelativeTime(s),N-S(gal),E-W(gal),U-D(gal)"; the end where there is none.
std::size_t knet_csv_names(const std::vector<Line>& lines) {
  for (std::size_t i = 0; i < lines.size() && lines[i].text.starts_with('#'); ++i) {
    if (lines[i].text.starts_with("#Time,")) return i;
  }
  return lines.size();
}

constexpr std::size_t knet_csv_times = 2;  // columns

/// How long the record is [s], which stands below "#DurationTime(s)"; nothing where that is not there.
std::optional<double> knet_csv_duration(const std::vector<Line>& lines, std::size_t names) {
  for (std::size_t i = 0; i + 1 < names; ++i) {
    if (lines[i].text.starts_with("#DurationTime(s)")) return number_of(trimmed(lines[i + 1].text.substr(1)));
  }
  return std::nullopt;
}

constexpr double rounded = 0.75;  // of a step: times of two decimals at 200 Hz

/// The seconds of the second column, which are there twice: a row that is missing, or there twice, shows in them.
void check_seconds(std::span<const Line> rows, double step, RecordErrors& errors) {
  std::size_t count = 0;
  for (const Line& row : rows) {
    if (trimmed(row.text).empty()) continue;
    const auto cells = split_cells(row, ',');
    const double time = cells.size() > 1 ? number_of(cells[1].text).value_or(-1) : -1;
    const double expected = step * static_cast<double>(count++);
    if (std::abs(time - expected) <= rounded * step) continue;
    errors.error(row, fmt::format("stands at {} s, but values every {:.6g} s have reached {:.6g} s",
                                  cells.size() > 1 ? shown(cells[1].text) : "no", step, expected));
    return;
  }
}

}  // namespace

bool looks_like_knet_csv(const std::vector<Line>& lines) {
  return !lines.empty() && lines[0].says("#K-NET CSV") && knet_csv_names(lines) < lines.size();
}

std::optional<StrongMotionRecord> read_knet_csv(const std::vector<Line>& lines, const RecordOptions& options,
                                                RecordErrors& errors) {
  const std::size_t names = knet_csv_names(lines);
  if (names == lines.size()) {
    return errors.error("is no knet-csv file: no line begins with \"#Time,RelativeTime(s),\"");
  }
  const Heading heading = read_heading(std::span(lines).subspan(0, names));
  StrongMotionRecord record;
  record.unit = "cm/s2";
  record.unit_line = lines[names].number;
  record.header_lines = static_cast<int>(names) + 1;
  ComponentColumns columns;
  columns.before = knet_csv_times;
  columns.separator = ',';
  const auto cells = split_cells(lines[names], ',');
  for (std::size_t i = knet_csv_times; i < cells.size(); ++i) {
    const std::string_view name = cells[i].text;
    const std::size_t unit = std::min(name.find("(gal)"), name.size());
    if (unit == name.size()) {
      return errors.error(cells[i], fmt::format("{} must be the name of a component in gal", shown(name)));
    }
    columns.names.emplace_back(name.substr(0, unit));
  }
  if (columns.names.empty()) return errors.error(lines[names], "names no components");
  const auto channel = read_component(lines, names + 1, columns, options, record, errors);
  if (!channel || !errors.ok() || record.values.empty()) return std::nullopt;
  record.time_step = stated_step(heading, *channel, record.step_line, errors);
  const auto duration = knet_csv_duration(lines, names);
  const auto count = static_cast<double>(record.values.size());
  if (errors.ok() && duration && !(std::abs(count * record.time_step - *duration) <= 1.5 * record.time_step)) {
    errors.error(lines[names], fmt::format("is followed by {} values, but the heading says {:.6g} s of {:.6g} s each",
                                           record.values.size(), *duration, record.time_step));
  }
  if (errors.ok()) check_seconds(std::span(lines).subspan(names + 1), record.time_step, errors);
  record.mean_removed =
      std::accumulate(record.values.begin(), record.values.end(), 0.0) / static_cast<double>(record.values.size());
  for (double& value : record.values) value -= record.mean_removed;
  return record;
}

}  // namespace bentur::records
