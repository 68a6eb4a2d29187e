// SMC files of the US Geological Survey: 11 lines of text, 6 of integers (8I10), 10 of reals (5E15.7), comments that
// begin with "|", and accelerations in cm/s² in eight fields of ten characters, which touch.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "bentur/io/records/internal/heading.h"
#include "bentur/io/records/internal/record_text.h"

namespace bentur::records {
namespace {

constexpr std::size_t smc_texts = 11, smc_integers = 6, smc_reals = 10;  // lines

/// Field `index`, from 0, of header lines of fixed width that begin with line `first`; nothing where it is blank.
std::optional<double> smc_header(const std::vector<Line>& lines, std::size_t first, std::size_t width,
                                 std::size_t index) {
  const std::size_t columns = 80 / width;
  const auto fields = fields_of(lines[first + index / columns], width);
  return index % columns < fields.size() ? number_of(fields[index % columns].text) : std::nullopt;
}

}  // namespace

bool looks_like_smc(const std::vector<Line>& lines) {
  if (lines.size() < smc_texts + smc_integers + smc_reals) return false;
  const std::string kind = upper(lines[0].text);
  const auto words = words_of({kind, 1});
  return words.size() >= 2 && words[0].text.size() == 1 && words[0].text[0] >= '0' && words[0].text[0] <= '9' &&
         (words[1].text == "CORRECTED" || words[1].text == "UNCORRECTED" || words[1].text == "VELOCITY" ||
          words[1].text == "DISPLACEMENT" || words[1].text == "RESPONSE");
}

std::optional<StrongMotionRecord> read_smc(const std::vector<Line>& lines, const RecordOptions& /*options*/,
                                           RecordErrors& errors) {
  const std::size_t headers = smc_texts + smc_integers + smc_reals;
  if (lines.size() < headers) {
    return errors.error(
        fmt::format("has {} lines, an smc file has {} header lines and then values", lines.size(), headers));
  }
  if (!lines[0].says("ACCELEROGRAM")) {
    return errors.error(
        lines[0], fmt::format("the file holds {}, but ground accelerations are needed", shown(trimmed(lines[0].text))));
  }
  const auto integer = [&](std::size_t index) { return smc_header(lines, smc_texts, 10, index); };
  const auto real = [&](std::size_t index) { return smc_header(lines, smc_texts + smc_integers, 15, index); };
  const auto no_integer = integer(0), no_real = real(0);  // what stands for a value that is missing
  const int count_line = lines[smc_texts + 2].number, rate_line = lines[smc_texts + smc_integers].number;
  const double comments = integer(15).value_or(-1), count = integer(16).value_or(-1), rate = real(1).value_or(-1);
  if (!(comments >= 0 && comments < static_cast<double>(lines.size() - headers))) {
    errors.error(count_line - 1, 71, "integer 16 of an smc file must be the number of comment lines that follow");
  }
  if (!is_count(count) || count == no_integer) {
    errors.error(count_line, 1, "integer 17 of an smc file must be the number of values");
  }
  if (no_real && rate >= *no_real) {
    errors.error(rate_line, 16,
                 "no sampling rate: the samples are pairs of time and acceleration at uneven times; take the corrected "
                 "accelerogram");
  } else if (!(rate > 0 && rate < 1e6)) {
    errors.error(rate_line, 16, "real 2 of an smc file must be the number of samples per second");
  }
  if (!errors.ok()) return std::nullopt;
  std::size_t at = headers + static_cast<std::size_t>(comments);
  for (std::size_t i = headers; i < at; ++i) {
    if (lines[i].text.substr(0, 1) == "|") continue;
    return errors.error(lines[i], fmt::format("must be one of {} comment lines, which begin with \"|\"", comments));
  }
  StrongMotionRecord record;
  record.unit = "cm/s2";
  record.time_step = 1 / rate;
  record.step_line = rate_line;
  record.header_lines = static_cast<int>(at);
  record.values = read_numbers(std::span(lines).subspan(at), 10, errors);
  for (const double value : record.values) {
    if (no_real && std::abs(value) < *no_real) continue;
    errors.error("has values that are marked as missing");
    break;
  }
  if (!errors.ok()) return std::nullopt;
  if (record.values.size() != static_cast<std::size_t>(count)) {
    return errors.error(
        count_line, 1,
        fmt::format("says {} values, but the file holds {}", static_cast<long>(count), record.values.size()));
  }
  // Reals 30 and 32 are the largest and the least value.
  const double largest = std::max(std::abs(real(29).value_or(0)), std::abs(real(31).value_or(0)));
  if (real(29) && real(31) && largest > 0 && no_real && largest < *no_real) {
    Heading heading;
    heading.peaks = {{.value = largest, .unit = "cm/s2", .line = rate_line + 5, .column = 61}};
    check_peak(heading, record.values, record.unit, {}, "", errors);
  }
  return record;
}

}  // namespace bentur::records
