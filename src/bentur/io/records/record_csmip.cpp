// Files of CSMIP and CDMG, volumes 1 and 2, and what RENADIC (Chile) writes alike: each channel has lines of text, of
// integers and of reals, whose number is not the same in all of them, and blocks of values, each behind a line that
// says what it holds. Fields touch.

#include <fmt/format.h>

#include <algorithm>

#include "bentur/io/records/internal/channels.h"
#include "bentur/io/records/internal/record_text.h"

namespace bentur::records {
namespace {

/// "3251 POINTS OF ACCEL DATA EQUALLY SPACED AT  .020 SEC.  (UNITS: CM/SEC/SEC)" or, of volume 1, "13200 Accelerogram
/// points at 200 pts/sec in units of g .      Format: (8f9.6)". @param text in capitals.
std::optional<Channel> csmip_block(const std::string& text) {
  const auto words = words_of({text, 0});
  const auto count = words.empty() ? std::nullopt : number_of(words[0].text);
  if (!is_count(count)) return std::nullopt;
  Channel channel;
  channel.count = static_cast<long>(*count);
  channel.width = field_width(text);
  const auto unit_behind = [&](std::string_view key, std::string_view ends) {
    const std::size_t at = text.find(key);
    if (at == std::string::npos) return std::string();
    const std::size_t from = at + key.size();
    return std::string(trimmed(std::string_view(text).substr(from, text.find_first_of(ends, from) - from)));
  };
  if (text.find("POINTS OF ACCEL") != std::string::npos && text.find("SPACED") != std::string::npos) {
    channel.time_step = number_after(text, " AT ").value_or(0);
    channel.unit = unit_behind("UNITS:", ")");
    if (channel.unit.empty()) channel.unit = unit_behind(", IN ", ".(");
    return channel;
  }
  if (text.find("ACCELEROGRAM POINTS AT") != std::string::npos && text.find("PTS/SEC") != std::string::npos) {
    channel.time_step = 1 / number_after(text, "POINTS AT").value_or(0);
    channel.unit = unit_behind("UNITS OF", ".(");
    return channel;
  }
  return std::nullopt;
}

/// "Chan  1:  90 Deg" of a line that has it, single blanks between the words.
std::string csmip_title(std::string_view line) {
  const std::string text = upper(line);
  const std::size_t at = text.find("CHAN ");
  if (at == std::string::npos || text.find(':', at) == std::string::npos) return "";
  const std::size_t end = std::min(text.find(" FROM", at), text.find('(', at));
  return single_spaced(line.substr(at, std::min(std::size_t{40}, end - at)));
}

constexpr std::size_t csmip_in_line = 8;  // fields

// Of volume 1 with pairs of time and acceleration, from the beginning of a channel: 13 lines of text, 7 of integers
// (16I5), 7 of reals (8F10.3); then 5 pairs in a line, in fields of 7 characters, which touch from 100 s on.
constexpr std::size_t csmip_pair_headers = 27, csmip_pair_fields = 10;

/// "UNITS OF UNCOR ACCEL ARE SEC AND G/10.     MAX  =  -.055 G, AT  15.992 SEC."
bool heads_csmip_pairs(const Line& line) { return line.says("UNITS ") && line.says("SEC AND G/10"); }

/// "Response and Fourier amplitude spectra (78 periods,  .04 -  6.0 sec)   for", of volume 3.
bool heads_csmip_spectra(const Line& line) { return line.says("FOURIER AMPLITUDE SPECTRA"); }

/// Such a channel, whose line on units is line `at`; nothing where no count is stated before it or no values follow.
std::optional<Channel> csmip_pairs(const std::vector<Line>& lines, std::size_t begin, std::size_t at) {
  if (begin + csmip_pair_headers >= lines.size() || at >= begin + csmip_pair_headers) return std::nullopt;
  Channel channel;
  channel.heading = read_heading(std::span(lines).subspan(begin, at + 1 - begin));
  if (channel.heading.counts.empty()) return std::nullopt;
  channel.count = static_cast<long>(channel.heading.counts.back().value);
  channel.unit = "G/10";
  channel.line = lines[at].number;
  channel.timed = true;
  channel.first_line = begin + csmip_pair_headers;
  channel.width = width_of_lines(lines, channel.first_line, csmip_pair_fields);
  channel.header_lines = static_cast<int>(csmip_pair_headers);
  return channel;
}

/// A line behind the values of a block: another block, the end of a channel or the beginning of the next.
bool ends_csmip_block(const Line& line) {
  return line.says("/&") || line.says("POINTS OF") || line.says("ACCELEROGRAM");
}

}  // namespace

bool looks_like_csmip(const std::vector<Line>& lines) {
  const auto heads_block = [](const Line& line) {
    return line.says("POINTS OF ") || line.says("ACCELEROGRAM POINTS AT") || heads_csmip_pairs(line);
  };
  if (lines.size() < 10) return false;
  return heads_csmip_spectra(lines[0]) ||
         (lines[0].says("CORRECTED ACCELEROGRAM") && std::any_of(lines.begin(), lines.end(), heads_block));
}

std::optional<StrongMotionRecord> read_csmip(const std::vector<Line>& lines, const RecordOptions& options,
                                             RecordErrors& errors) {
  if (heads_csmip_spectra(lines[0])) {
    return errors.error(lines[0], "a file of spectra (volume 3), but ground accelerations are needed");
  }
  std::vector<Channel> channels;
  std::string title;
  std::size_t begin = 0;  // of the channel
  const bool corrected = !lines[0].says("UNCORRECTED");
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (lines[i].text.starts_with("/&")) begin = i + 1;
    if (std::string found = csmip_title(lines[i].text); !found.empty()) title = std::move(found);
    auto block = csmip_block(upper(lines[i].text));
    if (block) {
      block->first_line = i + 1;
      block->header_lines = static_cast<int>(i + 1 - begin);
      block->heading = read_heading(std::span(lines).subspan(begin, i - begin));
      if (block->width == 0) block->width = width_of_lines(lines, i + 1, csmip_in_line);
    } else if (!corrected && heads_csmip_pairs(lines[i])) {
      block = csmip_pairs(lines, begin, i);
    }
    if (!block) continue;
    block->title = title;
    channels.push_back(std::move(*block));
  }
  static constexpr ChannelFormat format = {
      "\"3000 points of accel data equally spaced at .020 sec\" or \"UNITS OF UNCOR ACCEL ARE SEC AND G/10\"",
      "must say how far apart the values are, more than 0 s", ends_csmip_block};
  return read_channel(lines, channels, format, options, errors);
}

}  // namespace bentur::records
