// PEER strong-motion files: four header lines, then accelerations in g, any number in a line.

#include <fmt/format.h>

#include <cctype>
#include <cmath>
#include <string>

#include "bentur/io/record_files_text.h"

namespace bentur {
namespace {

std::string upper(std::string_view text) {
  std::string result(text);
  for (char& c : result) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  return result;
}

/// Line 3 must say accelerations in units of g: velocities (VT2) and displacements (DT2) come in the same layout.
void check_quantity(const Line& line, RecordErrors& errors) {
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
  if (at == std::string::npos) {
    errors.error(line.number, 1, "line 3 of a peer-at2 file must say \"... IN UNITS OF G\"");
    return;
  }
  const Line rest{std::string_view(text).substr(at + phrase.size()), line.number};
  const auto words = words_of(rest, " \t.,;()");
  if (!words.empty() && words.front().text == "G") return;
  errors.error(line.number, static_cast<int>(at) + 1,
               fmt::format("units of {}, but a peer-at2 file must be in g",
                           words.empty() ? "nothing" : shown(words.front().text)));
}

struct Header {
  long count = 0;        ///< number of values
  double time_step = 0;  ///< [s]
};

/// `NPTS=  4000, DT= .01000 SEC` or `3930 0.00500 NPTS, DT`, in any spacing and case.
std::optional<Header> read_header(const Line& line, RecordErrors& errors) {
  const std::string text = upper(line.text);
  const auto words = words_of({text, line.number}, " \t,=");
  std::string_view count, step;
  Token count_at, step_at;
  const auto take = [](const Token& token, std::string_view& value, Token& at) {
    value = token.text;
    at = token;
  };
  for (std::size_t i = 0; i + 1 < words.size(); ++i) {
    if (words[i].text == "NPTS" && count.empty() && number_of(words[i + 1].text)) take(words[i + 1], count, count_at);
    if (words[i].text == "DT" && step.empty()) take(words[i + 1], step, step_at);
  }
  const bool behind = words.size() >= 4 && count.empty() && number_of(words[0].text) && number_of(words[1].text) &&
                      words[2].text == "NPTS" && words[3].text == "DT";
  if (behind) {
    take(words[0], count, count_at);
    take(words[1], step, step_at);
  }
  if (step.size() > 3 && step.substr(step.size() - 3) == "SEC") step.remove_suffix(3);
  const auto count_value = number_of(count);
  const auto step_value = number_of(step);
  if (!count_value || !step_value) {
    errors.error(
        line.number, 1,
        "line 4 of a peer-at2 file must give the number of values and the step, as in \"NPTS= 4000, DT= .01 SEC\"");
    return std::nullopt;
  }
  if (!(*count_value >= 1 && *count_value <= 1e9 && *count_value == std::floor(*count_value))) {
    errors.error(count_at, fmt::format("NPTS = {}, must be a whole number > 0", count_at.text));
  }
  if (!(std::isfinite(*step_value) && *step_value > 0)) {
    errors.error(step_at, fmt::format("DT = {}, must be > 0", step_at.text));
  }
  if (!errors.ok()) return std::nullopt;
  return Header{static_cast<long>(*count_value), *step_value};
}

}  // namespace

bool looks_like_peer(const std::vector<Line>& lines) {
  if (lines.size() < 4) return !lines.empty() && upper(lines[0].text).find("PEER") != std::string::npos;
  return upper(lines[3].text).find("NPTS") != std::string::npos ||
         upper(lines[2].text).find("UNITS OF") != std::string::npos;
}

std::optional<Record> read_peer(const std::vector<Line>& lines, const RecordOptions& options, RecordErrors& errors) {
  if (options.column) errors.error(0, 0, "is a peer-at2 file, which has no columns to choose from");
  if (lines.size() < 5) {
    errors.error(0, 0,
                 fmt::format("has {} lines, a peer-at2 file has four header lines and then values", lines.size()));
    return std::nullopt;
  }
  check_quantity(lines[2], errors);
  const auto header = read_header(lines[3], errors);
  if (!header || !errors.ok()) return std::nullopt;

  Record record{"peer-at2", "g", header->time_step, {}};
  for (std::size_t i = 4; i < lines.size() && !errors.full(); ++i) {
    for (const Token& token : words_of(lines[i], " \t")) {
      if (const auto value = finite_number(token, false, errors)) record.values.push_back(*value);
    }
  }
  if (!errors.ok()) return std::nullopt;
  if (static_cast<long>(record.values.size()) != header->count) {
    errors.error(lines[3].number, 1,
                 fmt::format("NPTS = {}, but the file holds {} values", header->count, record.values.size()));
    return std::nullopt;
  }
  return record;
}

}  // namespace bentur
