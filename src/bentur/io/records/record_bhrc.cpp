// Files of BHRC (Iran), volume 1: of each of three components 13 lines of text, 7 of integers and 7 of reals, which are
// cut off at the right, and accelerations in g/10 in ten fields of 13 characters, up to a line "/&".

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "bentur/io/records/internal/channels.h"
#include "bentur/io/records/internal/record_text.h"

namespace bentur::records {
namespace {

constexpr std::size_t bhrc_texts = 13, bhrc_integers = 7, bhrc_reals = 7;  // lines
constexpr std::size_t bhrc_headers = bhrc_texts + bhrc_integers + bhrc_reals;
constexpr std::size_t bhrc_width = 13;

/// "* VOL1DS FILE:  5522/01"
bool heads_bhrc(const Line& line) { return line.text.starts_with("* VOL"); }

bool says_bhrc_unit(const Line& line) { return line.says("UNITS ARE") && line.says("G/10"); }

bool ends_bhrc_block(const Line& line) { return line.text.starts_with("/&") || heads_bhrc(line); }

/// One component, from its line `begin` on; an error where its heading does not say what is needed.
Channel bhrc_channel(const std::vector<Line>& lines, std::size_t begin, RecordErrors& errors) {
  Channel channel;
  const auto texts = std::span(lines).subspan(begin, bhrc_texts);
  const auto unit = std::find_if(texts.begin(), texts.end(), says_bhrc_unit);
  channel.heading = read_heading(texts);
  if (unit == texts.end() || channel.heading.counts.empty()) {
    errors.error(lines[begin],
                 "begins a component of a bhrc file, whose heading must say \"NO. OF POINTS\" and \"UNITS ARE SECONDS "
                 "AND G/10\"");
    return channel;
  }
  const Statement& count = channel.heading.counts.front();
  channel.count = static_cast<long>(count.value);
  channel.exact_count = true;
  channel.line = count.line;
  channel.unit = "G/10";
  channel.width = bhrc_width;
  channel.title = trimmed(lines[begin + 4].text);
  channel.first_line = begin + bhrc_headers;
  channel.header_lines = static_cast<int>(bhrc_headers);
  // Samples a second is the first real of the second line; the duration is that of all values, the last step too.
  const auto reals = fields_of(lines[begin + bhrc_texts + bhrc_integers + 1], bhrc_width);
  const double rate = reals.empty() ? 0 : number_of(reals[0].text).value_or(0);
  const std::string text = upper(lines[static_cast<std::size_t>(count.line) - lines[0].number].text);
  const double duration = number_after(text, "DURATION").value_or(0);
  if (!(rate > 0) || !(std::abs(count.value / rate - duration) <= 1.5 / rate)) {
    errors.error(
        count.line, 1,
        fmt::format("says {} values in {} s, but the headers {:.6g} values a second", channel.count, duration, rate));
    return channel;
  }
  channel.time_step = 1 / rate;
  return channel;
}

}  // namespace

bool looks_like_bhrc(const std::vector<Line>& lines) {
  const auto head = std::span(lines).subspan(0, std::min(lines.size(), bhrc_texts));
  const auto says_count = [](const Line& line) { return line.says("NO. OF POINTS"); };
  return !lines.empty() && heads_bhrc(lines[0]) && std::any_of(head.begin(), head.end(), says_count);
}

std::optional<StrongMotionRecord> read_bhrc(const std::vector<Line>& lines, const RecordOptions& options,
                                            RecordErrors& errors) {
  std::vector<Channel> channels;
  for (std::size_t i = 0; i + bhrc_headers < lines.size() && errors.ok(); ++i) {
    if (heads_bhrc(lines[i])) channels.push_back(bhrc_channel(lines, i, errors));
  }
  if (!errors.ok()) return std::nullopt;
  static constexpr ChannelFormat format = {"\"* VOL1DS FILE:\"", "must say how far apart the values are",
                                           ends_bhrc_block};
  return read_channel(lines, channels, format, options, errors);
}

}  // namespace bentur::records
