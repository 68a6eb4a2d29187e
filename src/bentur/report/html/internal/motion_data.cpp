#include "bentur/report/html/internal/motion_data.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <string_view>

#include "bentur/report/html/internal/sections.h"
#include "bentur/report/scene/names.h"

namespace bentur::html {
namespace {

using Eigen::Index;

std::string packed(const Eigen::MatrixXd& displacement, Index stride, double scale) {
  std::string bytes;
  for (Index frame = 0; frame < displacement.cols(); frame += stride) {
    for (Index row = 0; row < displacement.rows(); ++row) {
      const auto whole = static_cast<std::uint16_t>(std::lround(displacement(row, frame) / scale));
      bytes += static_cast<char>(whole & 0xFFU);
      bytes += static_cast<char>(whole >> 8U);
    }
  }
  return base64(bytes);
}

}  // namespace

double motion_step(double duration, Index rows) {
  const double bytes = 6e5 * std::clamp(duration / 10, 1.0, 5.0);
  const double samples = bytes * 3 / 4 / 2;
  const double least = duration * static_cast<double>(rows) / samples;
  double step = 5e-4;  // some samples of even a short impact
  for (const double longer : {1e-3, 2e-3, 5e-3, 1e-2, 2e-2, 5e-2, 0.1, 0.2, 0.5, 1.0}) {
    if (step < least) step = longer;
  }
  return std::max(std::min(step, duration / 100), least);
}

MotionSampling motion_sampling(const std::vector<double>& time, double wanted) {
  if (time.size() < 2) return {1, std::ssize(time), wanted};
  const double step = time[1] - time[0];
  const auto stride = std::max<Index>(1, static_cast<Index>(std::floor(wanted / step * (1 + 1e-9))));
  return {stride, (std::ssize(time) - 1) / stride + 1, step * static_cast<double>(stride)};
}

std::vector<Index> key_columns(const std::vector<double>& time, const std::vector<Impact>& impacts,
                               const std::vector<Index>& shown, double instant) {
  std::vector<Index> columns;
  if (time.empty()) return columns;
  const auto add = [&](double at) {
    const auto next = std::lower_bound(time.begin(), time.end(), at);
    auto found = next == time.end() ? std::prev(next) : next;
    if (found != time.begin() && at - *std::prev(found) < *found - at) --found;
    columns.push_back(found - time.begin());
  };
  for (const Index k : shown) {
    const Impact& impact = impacts[k];
    add(impact.start);
    if (impact.peak_force > 0) add(impact.peak_force_time);
    add(impact.end);
  }
  add(instant);
  std::sort(columns.begin(), columns.end());
  const auto same_time = [&](Index a, Index b) { return time[a] == time[b]; };
  columns.erase(std::unique(columns.begin(), columns.end(), same_time), columns.end());
  return columns;
}

Json samples_json(const Eigen::MatrixXd& displacement, const MotionSampling& sampling, const Eigen::MatrixXd& exact) {
  double largest = displacement.size() == 0 ? 0 : displacement.cwiseAbs().maxCoeff();
  if (exact.size() > 0) largest = std::max(largest, exact.cwiseAbs().maxCoeff());
  const double scale = largest > 0 ? largest / 32767 : 1;
  return {{"rows", displacement.rows()},
          {"scale", scale},
          {"samples", packed(displacement, sampling.stride, scale)},
          {"keys", packed(exact, 1, scale)}};
}

Json names_json(const std::vector<std::string>& names) {
  const std::vector<std::string> in_short = short_names(names);
  return {{"short", in_short}, {"key", numbered(names)}, {"parts", are_parts_of(in_short, names)}};
}

Json played_json(const MotionSampling& sampling, const std::vector<double>& times, const std::vector<Index>& keys,
                 const std::vector<Impact>& impacts, std::vector<Index> listed, double force, const Words& say) {
  Json key_times = Json::array();
  for (const Index column : keys) key_times.push_back(times[column]);
  std::sort(listed.begin(), listed.end());
  Json told = Json::array();
  for (const Index k : listed) {
    const Impact& impact = impacts[k];
    told.push_back({impact.point, impact.start, impact.end, force * impact.peak_force, impact.peak_force_time,
                    impact.closing_speed, k + 1, impact.slipped ? 1 : 0});
  }
  Json words;
  for (const char* const word : {"play", "pause", "impact", "level", "show_impact", "slips", "not_modelled"}) {
    words[word] = say("script." + std::string(word));
  }
  for (const char* const word : {"magnified", "peak", "closing_at"})
    words[word] = say("figure.text." + std::string(word));
  return {
      {"words", words}, {"frames", sampling.count}, {"step", sampling.step}, {"keys", key_times}, {"impacts", told}};
}

std::string base64(const std::string& bytes) {
  constexpr std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t group = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      group = group << 8U | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0U);
    }
    for (std::size_t k = 0; k < 4; ++k) text += i + k <= bytes.size() ? digits[group >> (18U - 6U * k) & 63U] : '=';
  }
  return text;
}

}  // namespace bentur::html
