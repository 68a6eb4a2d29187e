// K-NET and KiK-net files of NIED: 17 lines of a name and what it is, then integers, which the scale factor turns into
// gal. They hold the instrument's offset, so that the mean is taken off.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "bentur/io/records/internal/heading.h"
#include "bentur/io/records/internal/record_text.h"

namespace bentur::records {
namespace {

constexpr std::size_t knet_headers = 17;  // lines

/// The header line that begins with `name`, or null.
const Line* knet_line(const std::vector<Line>& lines, std::string_view name) {
  for (std::size_t i = 0; i < std::min(lines.size(), knet_headers); ++i) {
    if (lines[i].text.starts_with(name)) return &lines[i];
  }
  return nullptr;
}

/// "3920(gal)/6182761" as gal per count; nothing where it is not of that form.
std::optional<double> knet_scale(std::string_view text) {
  const std::size_t unit = text.find("(gal)"), slash = text.find('/');
  if (unit == std::string_view::npos || slash != unit + 5) return std::nullopt;
  const auto gal = number_of(trimmed(text.substr(0, unit)));
  const auto counts = number_of(trimmed(text.substr(slash + 1)));
  if (!gal || !counts || !(*gal > 0) || !(*counts > 0) || !std::isfinite(*gal / *counts)) return std::nullopt;
  return *gal / *counts;
}

}  // namespace

bool looks_like_knet(const std::vector<Line>& lines) {
  return knet_line(lines, "Sampling Freq(Hz)") != nullptr && knet_line(lines, "Scale Factor") != nullptr;
}

std::optional<StrongMotionRecord> read_knet(const std::vector<Line>& lines, const RecordOptions& /*options*/,
                                            RecordErrors& errors) {
  const Line* const rate_line = knet_line(lines, "Sampling Freq(Hz)");
  const Line* const scale_line = knet_line(lines, "Scale Factor");
  if (rate_line == nullptr || scale_line == nullptr || lines.size() <= knet_headers) {
    return errors.error(
        "is no knet file: of 17 header lines one must give the \"Sampling Freq(Hz)\", one the \"Scale "
        "Factor\", and values must follow");
  }
  const double rate = number_after(rate_line->text, "Sampling Freq(Hz)").value_or(0);
  if (!(rate > 0 && rate < 1e6)) {
    errors.error(*rate_line, "must give the sampling frequency, as in \"Sampling Freq(Hz) 100Hz\"");
  }
  const auto scale = knet_scale(scale_line->text.substr(std::string_view("Scale Factor").size()));
  if (!scale) {
    errors.error(*scale_line, "must give gal per count, as in \"Scale Factor      3920(gal)/6182761\"");
  }
  StrongMotionRecord record;
  record.unit = "cm/s2";
  record.unit_line = scale_line->number;
  record.time_step = 1 / rate;
  record.step_line = rate_line->number;
  record.header_lines = static_cast<int>(knet_headers);
  record.values = read_numbers(std::span(lines).subspan(knet_headers), 0, errors);
  if (!errors.ok()) return std::nullopt;
  if (record.values.empty()) return errors.error("holds no numbers");
  const double mean =
      std::accumulate(record.values.begin(), record.values.end(), 0.0) / static_cast<double>(record.values.size());
  for (double& value : record.values) value = (value - mean) * *scale;
  record.mean_removed = mean * *scale;
  const Heading heading = read_heading(std::span(lines).subspan(0, knet_headers));
  if (!heading.components.empty()) record.component = heading.components.front().text;
  check_peak(heading, record.values, record.unit, {}, "", errors);
  return record;
}

}  // namespace bentur::records
