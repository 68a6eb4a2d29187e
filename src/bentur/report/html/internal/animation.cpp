#include "bentur/report/html/internal/animation.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <nlohmann/json.hpp>
#include <numeric>
#include <optional>
#include <variant>

#include "bentur/io/results/result_csv.h"
#include "bentur/report/html/report.h"

namespace bentur::html {
namespace {

using Json = nlohmann::ordered_json;

double height_of(const Building& building) {
  const std::vector<double>& storeys = building.model.storey_heights;
  return std::accumulate(storeys.begin(), storeys.end(), 0.0);
}

/// Bays the picture is drawn with: of a building that has no width one of a third of its height, of a wall one of a
/// twentieth of the highest building.
std::vector<double> bays(const Report& report, std::size_t b) {
  const std::vector<Building>& buildings = report.problem.buildings;
  if (buildings[b].is_rigid()) {
    double highest = 0;
    for (const Building& building : buildings) highest = std::max(highest, height_of(building));
    return {highest > 0 ? highest / 20 : 1};
  }
  const double slender = height_of(buildings[b]) / 3;
  if (!report.from_case()) return {slender};
  const BuildingSpec& spec = report.c.buildings.at(b);
  if (const auto* frame = std::get_if<PlaneFrame>(&spec.structure)) return frame->bay_widths;
  return {spec.width.value_or(slender)};
}

/// One sample in `stride`, floors of one instant side by side.
Json samples(const Eigen::MatrixXd& displacement, Eigen::Index stride, double scale) {
  std::string bytes;
  for (Eigen::Index frame = 0; frame < displacement.cols(); frame += stride) {
    for (Eigen::Index floor = 0; floor < displacement.rows(); ++floor) {
      const auto whole = static_cast<std::uint16_t>(std::lround(displacement(floor, frame) / scale));
      bytes += static_cast<char>(whole & 0xFFU);
      bytes += static_cast<char>(whole >> 8U);
    }
  }
  return base64(bytes);
}

/// Columns of the course at the start, the peak and the end of each impact shown, by time; none where it was not kept.
std::vector<Eigen::Index> key_columns(const Report& report, const std::vector<Eigen::Index>& shown) {
  const std::vector<double>& time = report.response.course.time;
  std::vector<Eigen::Index> columns;
  if (time.empty()) return columns;
  const auto add = [&](double at) {
    const auto next = std::lower_bound(time.begin(), time.end(), at);
    auto found = next == time.end() ? std::prev(next) : next;
    if (found != time.begin() && at - *std::prev(found) < *found - at) --found;
    columns.push_back(found - time.begin());
  };
  for (const Eigen::Index k : shown) {
    const Impact& impact = report.response.impacts[k];
    add(impact.start);
    if (impact.peak_force > 0) add(impact.peak_force_time);
    add(impact.end);
  }
  std::sort(columns.begin(), columns.end());
  const auto same_time = [&](Eigen::Index a, Eigen::Index b) { return time[a] == time[b]; };
  columns.erase(std::unique(columns.begin(), columns.end(), same_time), columns.end());
  return columns;
}

/// Where columns are struck between floors: behind the floors in the samples, in the outer column that faces the gap.
Json nodes_json(const Report& report, std::size_t b) {
  const Building& building = report.problem.buildings[b];
  Json nodes = Json::array();
  for (const double elevation : building.model.node_elevations) nodes.push_back({{"elevation", elevation}});
  for (const ContactPoint& point : report.problem.points) {
    const std::optional<StruckColumn> struck = struck_column(report.problem, point);
    if (struck && struck->building == static_cast<Eigen::Index>(b)) {
      nodes.at(static_cast<std::size_t>(struck->node))["left"] = point.left != struck->building;
    }
  }
  return nodes;
}

/// Displacements of floors, then of nodes in columns, at the instants of some columns of the histories.
template <typename Columns>
Eigen::MatrixXd displacements(const Histories& histories, std::size_t b, const Columns& columns) {
  const auto floors = histories.displacement.at(b)(Eigen::all, columns);
  const auto nodes = histories.node_displacement.at(b)(Eigen::all, columns);
  Eigen::MatrixXd both(floors.rows() + nodes.rows(), floors.cols());
  both << floors, nodes;
  return both;
}

Json building_json(const Report& report, std::size_t b, Eigen::Index stride, const std::vector<Eigen::Index>& keys) {
  const Building& building = report.problem.buildings[b];
  const Eigen::MatrixXd displacement = displacements(report.response.histories, b, Eigen::all);
  Eigen::MatrixXd exact;
  if (!keys.empty()) exact = displacements(report.response.course, b, keys);
  double largest = displacement.size() == 0 ? 0 : displacement.cwiseAbs().maxCoeff();
  if (exact.size() > 0) largest = std::max(largest, exact.cwiseAbs().maxCoeff());
  const double scale = largest > 0 ? largest / 32767 : 1;
  return {{"name", building.name},
          {"elevations", building.model.elevations},
          {"base", building.model.elevations.front() - building.model.storey_heights.front()},
          {"bays", bays(report, b)},
          {"rigid", building.is_rigid()},
          {"nodes", nodes_json(report, b)},
          {"scale", scale},
          {"samples", samples(displacement, stride, scale)},
          {"keys", samples(exact, 1, scale)}};
}

}  // namespace

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

std::string animation_json(const Report& report, const std::vector<Eigen::Index>& listed) {
  const Histories& histories = report.response.histories;
  const double wanted = report_output_step(report.problem);
  const double step = histories.time.size() > 1 ? histories.time[1] - histories.time[0] : report.problem.duration;
  const auto stride = std::max<Eigen::Index>(1, static_cast<Eigen::Index>(std::floor(wanted / step * (1 + 1e-9))));
  const std::vector<Eigen::Index> keys = key_columns(report, listed);
  Json key_times = Json::array();
  for (const Eigen::Index column : keys) key_times.push_back(report.response.course.time[column]);
  Json buildings = Json::array();
  for (std::size_t b = 0; b < report.problem.buildings.size(); ++b) {
    buildings.push_back(building_json(report, b, stride, keys));
  }
  Json points = Json::array();
  for (const ContactPoint& point : report.problem.points) {
    points.push_back({{"left", point.left},
                      {"leftFloor", point.left_floor},
                      {"rightFloor", point.right_floor},
                      {"elevation", point.elevation},
                      {"width", point.width}});
  }
  std::vector<double> widths;  // of the gaps at rest
  for (std::size_t gap = 0; gap + 1 < report.problem.buildings.size(); ++gap) {
    widths.push_back(std::numeric_limits<double>::max());
    const auto narrow = [&](const auto& one) {
      if (one.left == static_cast<int>(gap)) widths.back() = std::min(widths.back(), one.width);
    };
    std::for_each(report.problem.points.begin(), report.problem.points.end(), narrow);
    std::for_each(report.problem.watched.begin(), report.problem.watched.end(), narrow);
  }
  std::vector<Eigen::Index> by_start = listed;
  std::sort(by_start.begin(), by_start.end());
  Json impacts = Json::array();
  const ShownUnits& units = report.run.shown;
  Response shown;
  for (const std::size_t k : by_start) {
    const Impact& impact = report.response.impacts[k];
    shown.impacts.push_back(impact);
    impacts.push_back({impact.point, impact.start, impact.end, units.force * impact.peak_force, impact.peak_force_time,
                       impact.closing_speed, k + 1});
  }
  Json words;
  for (const char* const word : {"play", "pause", "impact", "level", "show_impact", "scale"}) {
    words[word] = report.say("script." + std::string(word));
  }
  const Json all = {{"words", words},
                    {"units", {{"length", report.c.units.length}, {"force", units.units.force}}},
                    {"duration", report.problem.duration},
                    {"step", step * static_cast<double>(stride)},
                    {"keys", key_times},
                    {"points", points},
                    {"widths", widths},
                    {"impacts", impacts},
                    {"csv", impacts_csv({report.problem, shown, report.c.units})},
                    {"buildings", buildings}};
  return all.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace bentur::html
