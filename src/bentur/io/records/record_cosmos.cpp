// COSMOS files, volumes 1 and 2 [COSMOS2001]: of each channel lines of text, counted integers, reals and comments, and
// blocks of values, each behind a line that says what it holds.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "bentur/io/records/internal/channels.h"
#include "bentur/io/records/internal/record_text.h"

namespace bentur::records {
namespace {

constexpr double cosmos_missing = -999;
constexpr std::size_t cosmos_texts = 14;  // lines

/// A counted header: "100 Integer-header values follow on  10 lines, Format= (10I8)" at line `at`.
std::vector<double> cosmos_header(const std::vector<Line>& lines, std::size_t at, RecordErrors& errors) {
  const auto words = words_of(lines[at]);
  const double count = words.empty() ? 0 : number_of(words[0].text).value_or(0);
  const double rows = number_after(lines[at].text, "follow on").value_or(0);
  const std::size_t width = field_width(lines[at].text);
  if (!(count >= 0 && rows >= 1 && rows < static_cast<double>(lines.size() - at)) || width == 0) {
    errors.error(lines[at],
                 "must say how many values follow, on how many lines and in which format, as in \"100 Real-header "
                 "values follow on  17 lines, Format= (6F13.6)\"");
    return {};
  }
  return read_numbers(std::span(lines).subspan(at + 1, static_cast<std::size_t>(rows)), width, errors);
}

bool ends_cosmos_block(const Line& line) {
  return line.says("END-OF-DATA") || line.says("END OF DATA") || line.says("(FORMAT V") || line.says(" PTS,");
}

/// "Sta Chan  1: 360 deg" up to what the recorder calls it.
std::string cosmos_title(std::string_view line) {
  const std::string text = upper(line);
  const std::size_t end = std::min(text.find("(RCRDR"), text.find("LOCATION:"));
  return single_spaced(line.substr(0, std::min(end, std::size_t{50})), "STA");
}

/// The headers of a channel, as far as they are needed.
struct CosmosHeaders {
  std::string title;
  double unit = cosmos_missing;  ///< its code
  double step = cosmos_missing;  ///< [ms]
};

/// "7000  acceleration pts, approx   70 secs, units=cm/sec2(04),Format=(8F10.5)"; 0 values where it is none.
Channel cosmos_block(const Line& line, const CosmosHeaders& headers, RecordErrors& errors) {
  const std::string text = upper(line.text);
  Channel channel;
  const auto words = words_of({text, line.number});
  if (words.size() < 3 || words[1].text != "ACCELERATION" || !words[2].text.starts_with("PTS")) return channel;
  if (const auto count = number_of(words[0].text); is_count(count)) channel.count = static_cast<long>(*count);
  channel.width = field_width(text);
  channel.time_step = headers.step / 1000;
  channel.title = headers.title;
  if (channel.count < 1 || channel.width == 0) {
    errors.error(line, "must give the number of values and their format, as in \"Format=(8F10.5)\"");
  }
  // The unit as a code in parentheses here, and as integer 3 of the headers.
  const std::size_t units = text.find("UNITS=");
  std::size_t open = units == std::string::npos ? std::string::npos : text.find('(', units);
  if (open > text.find("FORMAT")) open = std::string::npos;
  double code = cosmos_missing;
  if (open != std::string::npos) code = number_after(text.substr(open), "(").value_or(cosmos_missing);
  if (code == cosmos_missing) code = headers.unit;
  if (headers.unit != cosmos_missing && code != headers.unit) {
    errors.error(line.number, static_cast<int>(open) + 2,
                 fmt::format("says unit {}, but integer 3 of the headers says {}", code, headers.unit));
  }
  if (code == 2) channel.unit = "g";
  if (code == 4 || code == 10) channel.unit = "gal";
  if (code == 11) channel.unit = "mg";
  if (code >= 50 && code < 60) {
    errors.error(line, "the values are counts or volts of the instrument, not accelerations");
  }
  return channel;
}

}  // namespace

bool looks_like_cosmos(const std::vector<Line>& lines) { return !lines.empty() && lines[0].says("(FORMAT V"); }

std::optional<StrongMotionRecord> read_cosmos(const std::vector<Line>& lines, const RecordOptions& options,
                                              RecordErrors& errors) {
  std::vector<Channel> channels;
  CosmosHeaders headers;
  std::size_t begin = 0;  // of the channel
  for (std::size_t i = 0; i < lines.size() && errors.ok(); ++i) {
    if (lines[i].says("(FORMAT V")) {
      headers = {};
      begin = i;
    }
    if (i == begin + 8) headers.title = cosmos_title(lines[i].text);
    if (lines[i].says("INTEGER-HEADER")) {
      const auto integers = cosmos_header(lines, i, errors);
      if (integers.size() >= 3) headers.unit = integers[2];
    }
    if (lines[i].says("REAL-HEADER")) {
      const auto reals = cosmos_header(lines, i, errors);
      if (reals.size() >= 62) headers.step = reals[61];
    }
    if (!lines[i].says(" PTS,")) continue;
    Channel block = cosmos_block(lines[i], headers, errors);
    block.first_line = i + 1;
    block.header_lines = static_cast<int>(i + 1 - begin);
    block.heading = read_heading(std::span(lines).subspan(begin, std::min(cosmos_texts, i - begin)));
    if (block.count > 0) channels.push_back(std::move(block));
  }
  if (!errors.ok()) return std::nullopt;
  static constexpr ChannelFormat format = {
      "\"7000 acceleration pts, approx 70 secs, units=cm/sec2(04),Format=(8F10.5)\"",
      "real 62 of the headers before this must be the step in milliseconds", ends_cosmos_block};
  return read_channel(lines, channels, format, options, errors);
}

}  // namespace bentur::records
