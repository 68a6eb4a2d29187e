#include "bentur/io/exchange/geojson.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <string_view>
#include <utility>

#include "bentur/core/number_text.h"
#include "bentur/io/exchange/local_plan.h"
#include "bentur/io/json_position.h"
#include "bentur/io/toml/toml_view.h"

namespace bentur {
namespace {

using GeoNode = nlohmann::json;

constexpr std::size_t most_houses = 200;
constexpr std::size_t most_ring_corners = 1000;
constexpr std::size_t longest_name = 100;  // bytes
constexpr double widest_block = 2000;      // [m]
constexpr std::size_t most_unread = 30;    // properties and geometries that are listed by name

/// Where the entries of the list `features` begin, of a text that is JSON.
std::vector<SourcePosition> places_of_features(const std::string& file, const std::string& text) {
  std::vector<SourcePosition> places;
  int line = 1, depth = 0;
  std::size_t line_begin = 0, string_begin = 0;
  bool in_string = false, is_features = false, is_entry_due = false;
  std::string_view last;  // the string that ended last
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (c == '\n') {
      ++line;
      line_begin = i + 1;
    }
    if (in_string) {
      if (c == '\\') ++i;
      if (c != '"') continue;
      in_string = false;
      last = std::string_view(text).substr(string_begin, i - string_begin);
      continue;
    }
    if (c == ' ' || c == '\t' || c == '\r' || c == '\n') continue;
    if (depth == 2 && is_features && is_entry_due && c != ']') {
      places.push_back({file, line, static_cast<int>(i - line_begin) + 1});
      is_entry_due = false;
    }
    if (c == '"') {
      in_string = true;
      string_begin = i + 1;
    } else if (c == ':' && depth == 1) {
      is_features = last == "features";
      if (is_features) places.clear();
    } else if (c == '{' || c == '[') {
      ++depth;
      if (depth == 2 && is_features) is_entry_due = true;
    } else if (c == '}' || c == ']') {
      --depth;
    } else if (c == ',' && depth == 2) {
      is_entry_due = true;
    }
  }
  return places;
}

std::string shown_node(const GeoNode& node) {
  if (node.is_object()) return "a table";
  if (node.is_array()) return "a list";
  if (node.is_string()) return in_quotes(node.get_ref<const std::string&>());
  return node.dump();
}

class GeoReader {
 public:
  GeoReader(const std::string& file, bool metres, Diagnostics& diagnostics)
      : file_(file), metres_(metres), diagnostics_(diagnostics) {}

  std::optional<Houses> read(const std::string& text) {
    GeoNode root;
    try {
      root = GeoNode::parse(text);
    } catch (const GeoNode::parse_error& fault) {
      diagnostics_.error(json_position(file_, text, fault.byte), no_json);
      return std::nullopt;
    } catch (const GeoNode::exception&) {
      return error("has a number that is too large");
    }
    const bool is_collection = root.is_object() && root.value("type", GeoNode()) == "FeatureCollection" &&
                               root.contains("features") && root["features"].is_array();
    if (!is_collection) return error("must be a GeoJSON FeatureCollection with its features (RFC 7946)");
    check_crs(root);
    const auto places = places_of_features(file_, text);
    const GeoNode& features = root["features"];
    const auto is_polygon = [](const GeoNode& feature) {
      const GeoNode* const shape = member(feature, "geometry");
      const GeoNode* const type = shape != nullptr ? member(*shape, "type") : nullptr;
      return type != nullptr && (*type == "Polygon" || *type == "MultiPolygon");
    };
    const auto polygons = std::count_if(features.begin(), features.end(), is_polygon);
    if (polygons > static_cast<std::ptrdiff_t>(most_houses)) {
      return error(fmt::format("has {} polygons, a block has at most {}", polygons, most_houses));
    }
    for (std::size_t i = 0; i < features.size(); ++i) {
      read_feature(features[i], i, i < places.size() ? places[i] : SourcePosition{file_});
    }
    list_unread();
    if (houses_.all.size() < 2 && diagnostics_.ok()) {
      error(fmt::format("has {}, a block has two or more", counted(houses_.all.size(), "polygon")));
    }
    if (diagnostics_.ok()) project();
    if (!diagnostics_.ok()) return std::nullopt;
    return std::move(houses_);
  }

 private:
  std::nullopt_t error(const std::string& message) {
    diagnostics_.error({file_}, message);
    return std::nullopt;
  }

  void error_at(const House& house, const std::string& way, const std::string& value, const std::string& rule) {
    diagnostics_.add({.position = house.position, .key = house.key + way, .value = value, .rule = rule});
  }

  static const GeoNode* member(const GeoNode& node, const char* key) {
    if (!node.is_object()) return nullptr;
    const auto found = node.find(key);
    return found == node.end() || found->is_null() ? nullptr : &*found;
  }

  /// RFC 7946 has WGS 84 alone; what stood before it, and some programs still write, names it.
  void check_crs(const GeoNode& root) {
    const GeoNode* const crs = member(root, "crs");
    if (crs == nullptr || metres_) return;
    const GeoNode* const properties = member(*crs, "properties");
    const GeoNode* const name = properties != nullptr ? member(*properties, "name") : nullptr;
    static const std::set<std::string> known = {"urn:ogc:def:crs:OGC:1.3:CRS84", "urn:ogc:def:crs:OGC::CRS84",
                                                "urn:ogc:def:crs:EPSG::4326", "EPSG:4326"};
    if (name != nullptr && name->is_string() && known.count(name->get_ref<const std::string&>()) > 0) return;
    House whole;
    whole.position.file = file_;
    error_at(whole, "crs", name != nullptr ? shown_node(*name) : "a table",
             "must be WGS 84 (CRS84), in degrees; give --metres where coordinates are metres");
  }

  void read_feature(const GeoNode& feature, std::size_t index, const SourcePosition& position) {
    House house;
    house.position = position;
    house.key = fmt::format("features[{}]", index);
    const GeoNode* const type = member(feature, "type");
    if (type == nullptr || *type != "Feature") return error_at(house, "", "", "must be a Feature");
    const GeoNode* const shape = member(feature, "geometry");
    const GeoNode* const kind = shape != nullptr ? member(*shape, "type") : nullptr;
    if (kind == nullptr || (*kind != "Polygon" && *kind != "MultiPolygon")) {
      leave_unread(kind != nullptr ? "geometry " + shown_node(*kind) : "a missing geometry", house);
      return;
    }
    const GeoNode* const properties = member(feature, "properties");
    read_name(feature, properties, index, house);
    if (properties != nullptr && !properties->is_object()) error_at(house, ".properties", "", "must be a table");
    if (properties != nullptr && properties->is_object()) read_properties(*properties, house);
    const GeoNode* coordinates = member(*shape, "coordinates");
    if (coordinates == nullptr || !coordinates->is_array()) {
      return error_at(house, ".geometry.coordinates", "", "must be a list of rings");
    }
    if (*kind == "MultiPolygon") {
      if (coordinates->size() != 1) {
        return error_at(house, ".geometry", "",
                        fmt::format("has {} polygons, must be one: parts that stand apart move apart, and are "
                                    "features of their own",
                                    coordinates->size()));
      }
      coordinates = &(*coordinates)[0];
    }
    if (!coordinates->is_array() || coordinates->empty()) {
      return error_at(house, ".geometry.coordinates", "", "must be a list of rings");
    }
    for (std::size_t ring = 0; ring < coordinates->size(); ++ring) {
      std::vector<PlanPoint> corners = read_ring((*coordinates)[ring], ring, house);
      if (ring == 0) {
        house.outline = std::move(corners);
      } else {
        house.holes.push_back(std::move(corners));
      }
    }
    houses_.all.push_back(std::move(house));
  }

  void read_name(const GeoNode& feature, const GeoNode* properties, std::size_t index, House& house) {
    const GeoNode* given = properties != nullptr ? member(*properties, "name") : nullptr;
    const auto is_text = [](const GeoNode* node) { return node != nullptr && node->is_string(); };
    const auto is_blank = [](const std::string& text) { return text.find_first_not_of(' ') == std::string::npos; };
    if (given != nullptr && !given->is_string()) {
      error_at(house, ".properties.name", shown_node(*given), "must be a text in quotes");
    }
    if (!is_text(given) || is_blank(given->get_ref<const std::string&>())) given = member(feature, "id");
    house.name = fmt::format("building {}", index + 1);
    if (given != nullptr && given->is_number_integer()) house.name = given->dump();
    if (is_text(given) && !is_blank(given->get_ref<const std::string&>())) house.name = given->get<std::string>();
    if (!is_one_line(house.name)) {
      error_at(house, ".properties.name", in_quotes(house.name),
               "must be one line without control characters and marks of direction");
      house.name = fmt::format("building {}", index + 1);
    }
    if (house.name.size() > longest_name) {
      error_at(house, ".properties.name", in_quotes(house.name),
               fmt::format("must have at most {} bytes", longest_name));
      house.name = fmt::format("building {}", index + 1);
    }
    const std::string asked = house.name;
    for (int i = 2; !names_.insert(house.name).second; ++i) house.name = fmt::format("{} ({})", asked, i);
    if (house.name != asked) houses_.renamed.push_back(house.name);
    house.key += fmt::format(" ({})", in_quotes(house.name));
  }

  void read_properties(const GeoNode& properties, House& house) {
    std::string levels;
    for (const auto& [key, value] : properties.items()) {
      const bool is_blank = value.is_string() && value.get_ref<const std::string&>().empty();
      if (value.is_null() || is_blank || key == "name") continue;
      if (key == "height") {
        read_height(value, house);
      } else if (key == "building:levels" || key == "levels" || key == "storeys") {
        if (!levels.empty()) error_at(house, ".properties." + key, "", "must not stand beside " + levels);
        levels = key;
        read_storeys(key, value, house);
      } else {
        leave_unread("property " + in_quotes(key), house);
      }
    }
  }

  /// A number, or the text that is one.
  static std::optional<double> number_of(const GeoNode& value) {
    if (value.is_number()) return value.get<double>();
    if (!value.is_string()) return std::nullopt;
    return parse_number(value.get_ref<const std::string&>());
  }

  void read_height(const GeoNode& value, House& house) {
    std::optional<double> height = number_of(value);
    if (!height && value.is_string()) {
      std::string text = value.get<std::string>();
      if (text.ends_with('m')) {
        text.pop_back();
        while (text.ends_with(' ')) text.pop_back();
        height = parse_number(text);
      }
    }
    if (height && *height > 0 && *height <= 1000) {
      house.height = height;
    } else {
      error_at(house, ".properties.height", shown_node(value), "must be metres in (0, 1000], as 12.5 or \"12.5 m\"");
    }
  }

  void read_storeys(const std::string& key, const GeoNode& value, House& house) {
    const std::optional<double> storeys = number_of(value);
    if (storeys && *storeys >= 1 && *storeys <= 200 && *storeys == std::floor(*storeys)) {
      house.storeys = static_cast<int>(*storeys);
    } else {
      error_at(house, ".properties." + key, shown_node(value), "must be a whole number from 1 to 200");
    }
  }

  /// Corners of a ring without the last, which is the first.
  std::vector<PlanPoint> read_ring(const GeoNode& ring, std::size_t index, const House& house) {
    const std::string way = fmt::format(".geometry.coordinates[{}]", index);
    if (!ring.is_array() || ring.size() < 4 || ring.size() > most_ring_corners) {
      error_at(house, way, "", fmt::format("must be a list of 4 to {} places", most_ring_corners));
      return {};
    }
    std::vector<PlanPoint> corners;
    for (const GeoNode& place : ring) {
      const bool is_place = place.is_array() && place.size() >= 2 && place[0].is_number() && place[1].is_number();
      if (!is_place) {
        error_at(house, fmt::format("{}[{}]", way, corners.size()), shown_node(place), "must be a list of numbers");
        return {};
      }
      const PlanPoint at(place[0].get<double>(), place[1].get<double>());
      const bool is_in = metres_ ? at.cwiseAbs().maxCoeff() <= 1e8 : std::abs(at.x()) <= 180 && std::abs(at.y()) <= 90;
      if (!is_in) {
        error_at(house, fmt::format("{}[{}]", way, corners.size()), fmt::format("[{}, {}]", at.x(), at.y()),
                 metres_ ? "must be metres within 1e8"
                         : "must be a longitude in [-180, 180] and a latitude in [-90, 90]; give --metres where "
                           "coordinates are metres");
        return {};
      }
      corners.push_back(at);
    }
    if (corners.front() != corners.back()) {
      error_at(house, way, "", "must end where it begins (RFC 7946, 3.1.6)");
      return {};
    }
    corners.pop_back();
    return corners;
  }

  void leave_unread(const std::string& what, const House& house) {
    UnreadKind& unread = unread_.try_emplace(what, UnreadKind{house.position.line}).first->second;
    unread.last = house.position.line;
    ++unread.count;
  }

  void list_unread() {
    std::size_t listed = 0;
    for (const auto& [what, unread] : unread_) {
      if (listed++ == most_unread) {
        houses_.unread.push_back(
            {unread.first, unread.last,
             counted(unread_.size() - most_unread, "other property or geometry", "other properties and geometries")});
        break;
      }
      houses_.unread.push_back(
          {unread.first, unread.last, fmt::format("{} of {}", what, counted(unread.count, "feature"))});
    }
    std::stable_sort(houses_.unread.begin(), houses_.unread.end(),
                     [](const UnreadLines& a, const UnreadLines& b) { return a.first < b.first; });
  }

  /// About their middle, to the millimetre.
  void project() {
    PlanPoint low = houses_.all.front().outline.front(), high = low;
    for (const House& house : houses_.all) {
      for (const PlanPoint& at : house.outline) {
        low = low.cwiseMin(at);
        high = high.cwiseMax(at);
      }
    }
    const PlanPoint middle = 0.5 * (low + high);
    const auto placed = [&](const PlanPoint& at) {
      return metres_ ? PlanPoint(at - middle) : local_plan({at.x(), at.y()}, {middle.x(), middle.y()});
    };
    const double extent = (placed(high) - placed(low)).maxCoeff();
    if (!(extent <= widest_block)) {
      error(fmt::format("is {} m from end to end, a block is at most {} m", number(extent), number(widest_block)));
      return;
    }
    houses_.middle = metres_ ? fmt::format("({:.3f}, {:.3f}) of the file", middle.x(), middle.y())
                             : fmt::format("longitude {:.7f}, latitude {:.7f}", middle.x(), middle.y());
    const auto to_plan = [&](std::vector<PlanPoint>& corners) {
      std::vector<PlanPoint> kept;
      for (const PlanPoint& at : corners) {
        const PlanPoint there = (1000 * placed(at)).array().round() / 1000;
        if (kept.empty() || there != kept.back()) kept.push_back(there);
      }
      while (kept.size() > 1 && kept.back() == kept.front()) kept.pop_back();
      corners = std::move(kept);
    };
    for (House& house : houses_.all) {
      to_plan(house.outline);
      for (std::vector<PlanPoint>& hole : house.holes) to_plan(hole);
    }
  }

  struct UnreadKind {
    int first = 0, last = 0;
    std::size_t count = 0;
  };

  const std::string& file_;
  bool metres_;
  Diagnostics& diagnostics_;
  Houses houses_;
  std::set<std::string> names_;
  std::map<std::string, UnreadKind> unread_;  // by what messages call it
};

}  // namespace

std::optional<Houses> read_geojson(const std::string& text, const std::string& name, bool metres,
                                   Diagnostics& diagnostics) {
  return GeoReader(name, metres, diagnostics).read(text);
}

}  // namespace bentur
