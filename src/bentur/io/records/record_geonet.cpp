// Files of GeoNet (New Zealand), V1A and V2A: of each of three components 16 lines of text, 4 of integers
// and 6 of reals, ten in a line, and accelerations in mm/s² in ten fields of eight characters, which touch; then, of
// V2A, velocities and displacements.

#include <fmt/format.h>

#include <algorithm>

#include "bentur/io/records/internal/channels.h"
#include "bentur/io/records/internal/record_text.h"

namespace bentur::records {
namespace {

constexpr std::size_t geonet_texts = 16, geonet_integers = 4, geonet_reals = 6;  // lines
constexpr std::size_t geonet_headers = geonet_texts + geonet_integers + geonet_reals;
constexpr std::size_t geonet_in_line = 10, geonet_width = 8;

/// "Corrected accelerogram 20161113_110256_HSES_20 GNS Science"
bool heads_geonet(const Line& line) {
  const std::string text = upper(line.text.substr(0, 30));
  return text.starts_with("CORRECTED ACCELEROGRAM ") || text.starts_with("UNCORRECTED ACCELEROGRAM ");
}

/// "Raw readings in units of 1.00 mm/s/s  at intervals of 0.005 s", "... data at 0.020 sec intervals"
bool says_geonet_unit(const Line& line) { return line.says("MM/S/S"); }

/// Lines of numbers behind the headers: of accelerations, velocities, displacements, as many as the fourth line of
/// integers says of each; 0 where that says nothing.
std::size_t geonet_data_lines(const std::vector<Line>& lines, std::size_t begin) {
  const auto integers = fields_of(lines[begin + geonet_texts + geonet_integers - 1], geonet_width);
  std::size_t rows = 0;
  for (const std::size_t i : {3, 4, 5}) {
    const auto count = i < integers.size() ? number_of(integers[i].text) : std::nullopt;
    if (is_count(count)) rows += (static_cast<std::size_t>(*count) + geonet_in_line - 1) / geonet_in_line;
  }
  return rows;
}

/// One component, from its line `begin` up to `end`; an error where its lines do not add up.
Channel geonet_channel(const std::vector<Line>& lines, std::size_t begin, std::size_t end, RecordErrors& errors) {
  Channel channel;
  if (end - begin <= geonet_headers) {
    errors.error(lines[begin], fmt::format("begins a component of {} lines, but {} of heading and values must follow",
                                           end - begin, geonet_headers));
    return channel;
  }
  const auto texts = std::span(lines).subspan(begin, geonet_texts);
  channel.heading = read_heading(texts);
  int line = 0;
  channel.time_step = stated_step(channel.heading, {}, line, errors);
  if (channel.heading.counts.empty()) {
    errors.error(lines[begin], "must be followed by a line such as \"Number of points  8192\"");
    return channel;
  }
  const Statement& count = channel.heading.counts.front();
  channel.count = static_cast<long>(count.value);
  channel.exact_count = true;
  channel.line = count.line;
  channel.unit = "mm/s/s";
  channel.width = geonet_width;
  channel.title = channel.heading.components.empty() ? "" : channel.heading.components.front().text;
  const std::size_t rows = (static_cast<std::size_t>(channel.count) + geonet_in_line - 1) / geonet_in_line;
  const std::size_t all = std::max(geonet_data_lines(lines, begin), rows);
  if (end - begin < geonet_headers + all) {
    errors.error(count.line, 1,
                 fmt::format("says {} values, but {} lines are too few for them and what stands with them",
                             channel.count, end - begin - geonet_headers));
    return channel;
  }
  channel.first_line = end - all;
  channel.lines = rows;
  channel.header_lines = static_cast<int>(channel.first_line - begin);
  return channel;
}

}  // namespace

bool looks_like_geonet(const std::vector<Line>& lines) {
  const auto head = std::span(lines).subspan(0, std::min(lines.size(), geonet_headers));
  return !lines.empty() && heads_geonet(lines[0]) && std::any_of(head.begin(), head.end(), says_geonet_unit);
}

std::optional<StrongMotionRecord> read_geonet(const std::vector<Line>& lines, const RecordOptions& options,
                                              RecordErrors& errors) {
  std::size_t end = lines.size();
  while (end > 0 && trimmed(lines[end - 1].text).empty()) --end;
  std::vector<std::size_t> begins;
  for (std::size_t i = 0; i < end; ++i) {
    if (heads_geonet(lines[i])) begins.push_back(i);
  }
  std::vector<Channel> channels;
  for (std::size_t i = 0; i < begins.size() && errors.ok(); ++i) {
    channels.push_back(geonet_channel(lines, begins[i], i + 1 < begins.size() ? begins[i + 1] : end, errors));
  }
  if (!errors.ok()) return std::nullopt;
  static constexpr ChannelFormat format = {"\"Corrected accelerogram\" or \"Uncorrected accelerogram\"",
                                           "must say how far apart the values are", [](const Line&) { return false; }};
  return read_channel(lines, channels, format, options, errors);
}

}  // namespace bentur::records
