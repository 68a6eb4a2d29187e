// PEER strong-motion files: four header lines, then accelerations in g, any number in a line.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "bentur/io/records/internal/components.h"
#include "bentur/io/records/internal/heading.h"
#include "bentur/io/records/internal/record_text.h"

namespace bentur::records {
namespace {

/// Line 3 must say accelerations in units of g, in these or other words ("The units are (g)"): velocities (VT2) and
/// displacements (DT2) come in the same layout.
void check_quantity(const Line& line, const RecordOptions& options, RecordErrors& errors) {
  const std::string text = upper(line.text);
  for (const char* const other : {"VELOCITY", "DISPLACEMENT"}) {
    const std::size_t at = text.find(other);
    if (at == std::string::npos || text.find("ACCELERATION") < at) continue;
    errors.error(line.number, static_cast<int>(at) + 1,
                 fmt::format("a {} record, but ground accelerations are needed (the AT2 file of the same motion)",
                             *other == 'V' ? "velocity" : "displacement"));
    return;
  }
  const std::string phrase = "UNITS OF";
  const std::size_t at = text.find(phrase);
  const std::string as_values = options.setting("format", "values");
  if (at == std::string::npos) {
    const Heading heading = read_heading(std::span(&line, 1));
    if (heading.units.empty()) {
      errors.error(line,
                   fmt::format("line 3 of a peer-at2 file must say \"... IN UNITS OF G\": where it does not, give "
                               "{} and {}",
                               as_values, options.name("unit")));
    } else if (heading.units[0].unit != "g" || heading.units[0].factor != 1) {
      errors.error(line.number, heading.units[0].column,
                   fmt::format("units of {}, but a peer-at2 file must be in g: in others it is read with {}",
                               in_words(heading.units[0].unit), as_values));
    }
    return;
  }
  const Line rest{std::string_view(text).substr(at + phrase.size()), line.number};
  const auto words = words_of(rest, " \t.,;()");
  if (!words.empty() && words.front().text == "G") return;
  errors.error(line.number, static_cast<int>(at) + 1,
               fmt::format("units of {}, but a peer-at2 file must be in g: in others it is read with {}",
                           words.empty() ? "nothing" : shown(words.front().text), as_values));
}

/// A line whose decimal commas are points: those before a digit, in a number without a point.
std::string with_points(std::string text) {
  for (std::size_t i = 0; i + 1 < text.size(); ++i) {
    const auto is_digit = [&](std::size_t at) { return at < text.size() && text[at] >= '0' && text[at] <= '9'; };
    if (text[i] != ',' || !is_digit(i + 1) || (i > 0 && !is_digit(i - 1) && text[i - 1] != ' ' && text[i - 1] != '=')) {
      continue;
    }
    std::size_t end = i + 1;
    while (is_digit(end)) ++end;
    if (end == text.size() || text[end] != '.') text[i] = '.';
  }
  return text;
}

/// What a header line gives for NPTS and DT, as it is spelled; no text where it does not say.
struct PeerHeader {
  Token count, step;
};

/// `NPTS=  4000, DT= .01000 SEC` or `3930 0.00500 NPTS, DT`, in any spacing. @param text in capitals.
PeerHeader peer_header(const std::string& text, int number) {
  const auto words = words_of({text, number}, " \t,=");
  PeerHeader header;
  for (std::size_t i = 0; i + 1 < words.size(); ++i) {
    if (words[i].text == "NPTS" && header.count.text.empty() && number_of(words[i + 1].text)) {
      header.count = words[i + 1];
    }
    if (words[i].text == "DT" && header.step.text.empty()) header.step = words[i + 1];
  }
  const bool behind = words.size() >= 4 && header.count.text.empty() && number_of(words[0].text) &&
                      number_of(words[1].text) && words[2].text == "NPTS" && words[3].text == "DT";
  if (behind) {
    header.count = words[0];
    header.step = words[1];
  }
  if (header.step.text.ends_with("SEC") && header.step.text.size() > 3) header.step.text.remove_suffix(3);
  return header;
}

std::optional<CountAndStep> read_peer_header(const Line& line, RecordErrors& errors) {
  const std::string text = with_points(upper(line.text));
  const PeerHeader header = peer_header(text, line.number);
  const auto count = number_of(header.count.text);
  const auto step = number_of(header.step.text);
  if (!count || !step) {
    return errors.error(
        line,
        "line 4 of a peer-at2 file must give the number of values and the step, as in \"NPTS= 4000, DT= .01 SEC\"");
  }
  if (!is_count(count)) {
    errors.error(header.count, fmt::format("NPTS = {}, must be a whole number > 0", header.count.text));
  }
  if (!(std::isfinite(*step) && *step > 0)) {
    errors.error(header.step, fmt::format("DT = {}, must be > 0", header.step.text));
  }
  if (!errors.ok()) return std::nullopt;
  return CountAndStep{static_cast<long>(*count), *step};
}

/// Index of the line with NPTS and DT: the fourth, or where there are more lines of titles the first that says both
/// behind one with UNITS OF.
std::size_t peer_header_line(const std::vector<Line>& lines) {
  bool units = false;
  for (std::size_t i = 0; i < std::min(lines.size(), std::size_t{40}); ++i) {
    if (units && count_and_step(lines[i])) return i;
    units = units || lines[i].says("UNITS OF");
  }
  return 3;
}

}  // namespace

std::optional<CountAndStep> count_and_step(const Line& line) {
  Diagnostics ignored;
  RecordErrors errors("", ignored);
  return read_peer_header(line, errors);
}

bool looks_like_peer(const std::vector<Line>& lines) {
  if (lines.size() < 4) return !lines.empty() && lines[0].says("PEER");
  // Headings of columns may say NPTS in line 4, and units in line 3, too.
  const bool units = lines[2].says("UNITS");
  const bool quantity = lines[2].says("ACCELERATION") || lines[2].says("VELOCITY") || lines[2].says("DISPLACEMENT");
  return (lines[3].says("NPTS") && lines[3].says("DT") && (units || quantity)) ||
         (units && quantity && lines[2].says("TIME ")) || peer_header_line(lines) != 3;
}

std::optional<StrongMotionRecord> read_peer(const std::vector<Line>& lines, const RecordOptions& options,
                                            RecordErrors& errors) {
  const std::size_t at = peer_header_line(lines);
  if (lines.size() < at + 2) {
    return errors.error(
        fmt::format("has {} lines, a peer-at2 file has four header lines and then values", lines.size()));
  }
  std::size_t units = at - 1;
  while (at != 3 && !lines[units].says("UNITS OF")) --units;
  check_quantity(lines[units], options, errors);
  const auto header = read_peer_header(lines[at], errors);
  if (!header || !errors.ok()) return std::nullopt;

  StrongMotionRecord record;
  record.unit = "g";
  record.unit_line = lines[units].number;
  record.time_step = header->time_step;
  record.step_line = lines[at].number;
  record.header_lines = static_cast<int>(at) + 1;
  record.values = read_numbers(std::span(lines).subspan(at + 1), 0, errors);
  if (!errors.ok()) return std::nullopt;
  if (static_cast<long>(record.values.size()) != header->count) {
    return errors.error(lines[at],
                        fmt::format("NPTS = {}, but the file holds {} values", header->count, record.values.size()));
  }
  return record;
}

}  // namespace bentur::records
