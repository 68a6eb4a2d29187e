#include "bentur/io/records/internal/channels.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "bentur/core/number_text.h"
#include "bentur/io/records/internal/column_rows.h"
#include "bentur/io/records/internal/components.h"

namespace bentur::records {
namespace {

constexpr double steps_alike = 0.01;  // [-]

/// Those of a list of one per channel that are of the channel, and all others.
std::vector<const Statement*> of_channel(const std::vector<Statement>& all, ChannelPlace channel) {
  std::vector<const Statement*> found;
  for (const Statement& said : all) {
    if (channel.of > 1 && said.of == channel.of && said.place != channel.place) continue;
    found.push_back(&said);
  }
  return found;
}

/// Leaves the accelerations of pairs of time and acceleration. An error where the times are uneven.
void take_times(const Line& heading, StrongMotionRecord& record, RecordErrors& errors) {
  std::vector<double> times, values;
  for (std::size_t i = 0; i + 1 < record.values.size(); i += 2) {
    times.push_back(record.values[i]);
    values.push_back(record.values[i + 1]);
  }
  record.values = std::move(values);
  std::size_t bad = 0;
  const auto step = even_step(times, bad);
  record.time_step = step.value_or(0);
  if (step || !errors.ok()) return;
  if (times.size() < 2 || bad == 0) {
    errors.error(heading, "is followed by pairs of time and acceleration, whose times do not go forward");
    return;
  }
  double least = times[1] - times[0], most = least;
  for (std::size_t i = 1; i < times.size(); ++i) {
    least = std::min(least, times[i] - times[i - 1]);
    most = std::max(most, times[i] - times[i - 1]);
  }
  errors.error(heading,
               fmt::format("is followed by pairs of time and acceleration at uneven times, which go forward by "
                           "{:.4g} to {:.4g} s: take the corrected accelerogram (volume 2)",
                           least, most));
}

}  // namespace

std::optional<std::size_t> chosen_channel(const std::vector<std::string>& titles, const RecordOptions& options,
                                          RecordErrors& errors) {
  if (options.channel && static_cast<std::size_t>(*options.channel) > titles.size()) {
    return errors.error(fmt::format("has {} of accelerations, {} is not there", counted(titles.size(), "channel"),
                                    options.setting("channel", std::to_string(*options.channel))));
  }
  if (options.component) {
    const auto named = named_component(titles, "channel", options, errors);
    if (named && options.channel && static_cast<std::size_t>(*options.channel) != *named + 1) {
      return errors.error(fmt::format("has {} as channel {}, but {} is given", in_words(*options.component), *named + 1,
                                      options.setting("channel", std::to_string(*options.channel))));
    }
    return named;
  }
  if (options.channel) return static_cast<std::size_t>(*options.channel) - 1;
  if (titles.size() == 1) return 0;
  std::string list;
  for (std::size_t i = 0; i < std::min(titles.size(), std::size_t{12}); ++i) {
    list += fmt::format("{}{} {}", i == 0 ? "" : ", ", i + 1, shown(titles[i]));
  }
  return errors.error(fmt::format("has {} channels of accelerations: say in {} or {} which one: {}{}", titles.size(),
                                  options.name("channel"), options.name("component"), list,
                                  titles.size() > 12 ? ", ..." : ""));
}

std::string channel_text(const std::vector<std::string>& titles, std::size_t chosen) {
  if (titles.size() < 2) return "";
  const std::string title = printable(titles[chosen]);
  return fmt::format("channel {} of {}{}", chosen + 1, titles.size(), title.empty() ? "" : " (" + title + ")");
}

std::optional<StrongMotionRecord> read_channel(const std::vector<Line>& lines, const std::vector<Channel>& channels,
                                               const ChannelFormat& format, const RecordOptions& options,
                                               RecordErrors& errors) {
  if (channels.empty()) {
    return errors.error(fmt::format("has no block of accelerations, which a line such as {} heads", format.heading));
  }
  std::vector<std::string> titles;
  for (const Channel& channel : channels) titles.push_back(channel.title);
  const auto chosen = chosen_channel(titles, options, errors);
  if (!chosen || !errors.ok()) return std::nullopt;
  const Channel& channel = channels[*chosen];
  const std::span values = std::span(lines).subspan(channel.first_line);
  const Line& heading = lines[channel.first_line - 1];
  const int line = channel.line > 0 ? channel.line : heading.number;
  if (!channel.timed && !(channel.time_step > 0 && std::isfinite(channel.time_step))) {
    return errors.error(heading, format.step_rule);
  }
  StrongMotionRecord record;
  record.time_step = channel.time_step;
  record.step_line = line;
  record.channel = channel_text(titles, *chosen);
  record.header_lines = channel.header_lines;
  const auto end = channel.lines > 0 ? values.begin() + static_cast<std::ptrdiff_t>(channel.lines)
                                     : std::find_if(values.begin(), values.end(), format.ends);
  record.values = read_numbers({values.begin(), end}, channel.width, errors);
  if (channel.timed) take_times(lines[static_cast<std::size_t>(line) - 1], record, errors);
  // Files of some networks are known to be off by one value.
  const auto count = static_cast<long>(record.values.size());
  if (errors.ok() && std::abs(count - channel.count) > (channel.exact_count ? 0 : 1)) {
    errors.error(line, 1, fmt::format("says {} values, but {} follow", channel.count, count));
  }
  if (const auto unit = file_unit(channel.unit)) {
    record.unit = unit->unit;
    record.unit_line = line;
    for (double& value : record.values) value *= unit->factor;
  }
  if (errors.ok()) check_peak(channel.heading, record.values, record.unit, {}, "", errors);
  return record;
}

std::optional<ChannelPlace> read_component(const std::vector<Line>& lines, std::size_t first,
                                           const ComponentColumns& columns, const RecordOptions& options,
                                           StrongMotionRecord& record, RecordErrors& errors) {
  const std::size_t all = columns.before + columns.names.size();
  RecordOptions chosen_by = options;
  if (options.column && !options.channel) {
    const auto column = static_cast<std::size_t>(*options.column);
    if (column <= columns.before || column > all) {
      return errors.error(fmt::format("has accelerations from column {} to {}, {} is not one of them",
                                      columns.before + 1, all,
                                      options.setting("column", std::to_string(*options.column))));
    }
    chosen_by.channel = static_cast<int>(column - columns.before);
  }
  const auto chosen = chosen_channel(columns.names, chosen_by, errors);
  if (!chosen) return std::nullopt;
  ColumnRows rows;
  rows.separator = columns.separator;
  std::vector<Token> numbers;
  for (std::size_t i = first; i < lines.size() && !errors.full(); ++i) {
    const Line& line = lines[i];
    if (line.text.find_first_not_of(" \t") == std::string_view::npos) continue;
    const auto cells = columns.width > 0 ? fields_of(line, columns.width) : rows.cells(line);
    if (cells.size() != all) {
      errors.error(line, fmt::format("has {}, not {}", counted(cells.size(), "column"), all));
      continue;
    }
    numbers.push_back(cells[columns.before + *chosen]);
  }
  const bool points = std::any_of(numbers.begin(), numbers.end(),
                                  [](const Token& number) { return number.text.find('.') != std::string_view::npos; });
  for (const Token& number : numbers) {
    if (errors.full()) break;
    record.values.push_back(finite_number(number, !points, errors).value_or(0));
  }
  record.channel = channel_text(columns.names, *chosen);
  return ChannelPlace{*chosen, columns.names.size()};
}

std::size_t width_of_lines(const std::vector<Line>& lines, std::size_t first, std::size_t in_line) {
  if (first + 1 >= lines.size()) return 0;  // one line may be shorter
  const std::string_view text = lines[first].text.substr(0, lines[first].text.find_last_not_of(" \t") + 1);
  return text.size() % in_line == 0 ? text.size() / in_line : 0;
}

void check_stated_count(const Heading& heading, std::size_t count, ChannelPlace channel, RecordErrors& errors) {
  const auto said = of_channel(heading.counts, channel);
  const auto fits = [&](const Statement* one) { return one->value == static_cast<double>(count); };
  if (said.empty() || std::any_of(said.begin(), said.end(), fits)) return;
  errors.error(said.front()->line, said.front()->column,
               fmt::format("says {} values, but {} follow", said.front()->value, count));
}

double stated_step(const Heading& heading, ChannelPlace channel, int& line, RecordErrors& errors) {
  const Statement* step = nullptr;
  for (const Statement* said : of_channel(heading.steps, channel)) {
    if (said->vague) continue;
    if (step != nullptr && std::abs(said->value / step->value - 1) > steps_alike) {
      errors.error(said->line, said->column,
                   fmt::format("says {:.6g} s from value to value, but line {} says {:.6g} s", said->value, step->line,
                               step->value));
      return 0;
    }
    if (step == nullptr) step = said;
  }
  if (step == nullptr) {
    errors.error("says nowhere in its heading how far apart the values are");
    return 0;
  }
  line = step->line;
  return step->value;
}

}  // namespace bentur::records
