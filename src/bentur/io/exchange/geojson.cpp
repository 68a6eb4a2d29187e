#include "bentur/io/exchange/geojson.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <utility>

#include "bentur/core/number_text.h"
#include "bentur/io/exchange/house_tags.h"
#include "bentur/io/exchange/internal/geo_choice.h"
#include "bentur/io/exchange/internal/geo_text.h"
#include "bentur/io/toml/toml_view.h"

namespace bentur {
namespace {

constexpr std::size_t most_houses = 1000;
constexpr std::size_t most_ring_corners = 1000;
constexpr double widest_block = 2000;    // [m]
constexpr std::size_t most_unread = 30;  // properties and geometries that are listed by name
constexpr const char* take_a_part = "--around NAME --radius METRES takes those near one";

bool is_usual_levels(const std::string& key) {
  return key == "building:levels" || key == "levels" || key == "num_floors" || key == "storeys";
}

/// What a house says of itself.
struct GeoProperty {
  std::string way;  ///< to it, from the properties
  const GeoNode* value = nullptr;
};

class GeoReader {
 public:
  GeoReader(const std::string& file, const GeoJsonOptions& options, Diagnostics& diagnostics)
      : file_(file), options_(options), diagnostics_(diagnostics) {}

  std::optional<Houses> read(const std::string& text) {
    const auto geo = read_geo_text(text, file_, diagnostics_);
    if (!geo) return std::nullopt;
    check_crs(geo->crs);
    const GeoChoice choice = choose_houses(geo->features, file_, options_, diagnostics_);
    if (!choice.is_made) return std::nullopt;
    houses_.left_out = choice.left_out;
    names_ = choice.names;
    for (const auto& [what, feature] : choice.unread) leave_unread(what, feature->position);
    std::size_t polygons = 0;
    for (const GeoCandidate& one : choice.houses) polygons += options_.parts ? one.polygons().size() : 1;
    if (polygons > most_houses) {
      return error(fmt::format("has {} polygons, a block has at most {}; {}", polygons, most_houses, take_a_part));
    }
    for (const GeoCandidate& one : choice.houses) read_candidate(one);
    list_unread();
    say_what_was_read();
    if (houses_.all.size() < 2 && diagnostics_.ok()) {
      std::string rule = fmt::format("has {}, a block has two or more", counted(houses_.all.size(), "polygon"));
      for (const std::string& one : houses_.left_out) rule += "; " + one;
      error(rule);
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
    diagnostics_.add({.position = house.position,
                      .key = house.key + way,
                      .value = value,
                      .rule = house.name.empty() ? rule : rule + "; " + without_it(house)});
  }

  /// RFC 7946 has WGS 84 alone; what stood before it, and some programs still write, names it.
  void check_crs(const GeoNode& crs) {
    if (crs.is_null()) return;
    const GeoNode* const properties = geo_member(crs, "properties");
    const GeoNode* const name = properties != nullptr ? geo_member(*properties, "name") : nullptr;
    static const std::set<std::string> known = {"urn:ogc:def:crs:OGC:1.3:CRS84", "urn:ogc:def:crs:OGC::CRS84",
                                                "urn:ogc:def:crs:EPSG::4326", "EPSG:4326"};
    const std::string called = name != nullptr && name->is_string() ? name->get_ref<const std::string&>() : "";
    House whole;
    whole.position.file = file_;
    if (options_.metres) {
      if (!called.ends_with(":3857") && !called.ends_with(":900913")) return;
      return error_at(whole, "crs", shown_geo(*name),
                      "is Web Mercator, whose metres are longer than those on the ground: give the file in a plane "
                      "system of the country or in degrees");
    }
    if (known.count(called) > 0) return;
    error_at(whole, "crs", name != nullptr ? shown_geo(*name) : "a table",
             "must be WGS 84 (CRS84), in degrees; give --metres where coordinates are metres");
  }

  void read_candidate(const GeoCandidate& one) {
    diagnostics_.add(one.faults);
    House house = one.house;
    if (house.name != one.asked && one.faults.ok()) houses_.renamed.push_back(house.name);
    if (one.properties != nullptr && !one.properties->is_object()) {
      error_at(house, ".properties", "", "must be a table");
    } else if (one.properties != nullptr) {
      read_properties(*one.properties, house);
    }
    const std::vector<const GeoNode*> polygons = one.polygons();
    if (polygons.size() == 1) {
      if (read_rings(*polygons.front(), house)) houses_.all.push_back(std::move(house));
      return;
    }
    if (polygons.empty() || !options_.parts) {
      return error_at(house, ".geometry", "",
                      fmt::format("has {} polygons, must be one: parts that stand apart move apart; --parts takes "
                                  "each as a house of its own",
                                  polygons.size()));
    }
    for (std::size_t i = 0; i < polygons.size(); ++i) {
      const std::string asked = one.name_of_part(i + 1);
      if (std::find(options_.without.begin(), options_.without.end(), asked) != options_.without.end()) continue;
      House part = house;
      part.name = asked;
      for (int k = 2; !names_.insert(part.name).second; ++k) part.name = fmt::format("{} ({})", asked, k);
      part.key = fmt::format("{} ({})", house.key.substr(0, house.key.find(' ')), in_quotes(part.name));
      if (read_rings(*polygons[i], part)) houses_.all.push_back(std::move(part));
    }
    parted_.push_back(fmt::format("{}, {} parts", in_quotes(house.name), polygons.size()));
  }

  /// @return whether they are a list, right or wrong
  bool read_rings(const GeoNode& rings, House& house) {
    if (!rings.is_array() || rings.empty()) {
      error_at(house, ".geometry.coordinates", "", "must be a list of rings");
      return false;
    }
    for (std::size_t ring = 0; ring < rings.size(); ++ring) {
      std::vector<PlanPoint> corners = read_ring(rings[ring], ring, house);
      if (ring == 0) {
        house.outline = std::move(corners);
      } else {
        house.holes.push_back(std::move(corners));
      }
    }
    return true;
  }

  /// Of a feature, and of a table `tags` among them that it does not have itself.
  static std::map<std::string, GeoProperty> properties_of(const GeoNode& node) {
    std::map<std::string, GeoProperty> all;
    const auto take = [&all](const GeoNode& table, const std::string& way) {
      for (const auto& [key, value] : table.items()) {
        const bool is_blank = value.is_string() && value.get_ref<const std::string&>().empty();
        if (!value.is_null() && !is_blank) all.try_emplace(key, GeoProperty{way + key, &value});
      }
    };
    take(node, "");
    const GeoNode* const tags = geo_member(node, "tags");
    if (tags == nullptr || !tags->is_object()) return all;
    all.erase("tags");
    take(*tags, "tags.");
    return all;
  }

  void read_properties(const GeoNode& node, House& house) {
    const std::map<std::string, GeoProperty> all = properties_of(node);
    std::vector<GeoProperty> levels;
    const auto named = options_.levels.empty() ? all.end() : all.find(options_.levels);
    const bool is_named = named != all.end();
    if (is_named) levels.push_back(named->second);
    has_levels_ = has_levels_ || is_named;
    if (!is_named) without_levels_.push_back(in_quotes(house.name));
    for (const auto& [key, property] : all) {
      properties_.insert(key);
      const bool is_levels = is_usual_levels(key);
      if (key == "name" || (is_named && key == options_.levels)) continue;
      if (key == "height") {
        read_height(property, house);
      } else if (is_levels && !is_named) {
        levels.push_back(property);
      } else {
        leave_unread("property " + in_quotes(property.way), house.position);
      }
    }
    for (const GeoProperty& one : levels) read_storeys(one, levels.front(), house);
  }

  /// A number, or a text.
  static std::string tag_of(const GeoNode& value) {
    if (value.is_number()) return value.dump();
    return value.is_string() ? value.get<std::string>() : "";
  }

  void cannot_read(const GeoProperty& property, const House& house, const std::string& rule) {
    if (options_.unread_as_none) {
      unreadable_.push_back(
          fmt::format("{}, {} = {}", in_quotes(house.name), property.way, shown_geo(*property.value)));
      return;
    }
    error_at(house, ".properties." + property.way, shown_geo(*property.value),
             rule + "; --storeys takes it as not given");
  }

  void read_height(const GeoProperty& property, House& house) {
    const std::string text = tag_of(*property.value);
    const auto height = height_tag(text);
    if (!height) {
      return cannot_read(property, house, "must be metres in (0, 1000], as 12.5 or \"12.5 m\", or feet as \"40 ft\"");
    }
    house.height = height->value;
    if (height->as_written) return;
    heights_read_.push_back(
        fmt::format("{}, {} as {} m", in_quotes(house.name), text, std::round(1000 * height->value) / 1000));
  }

  void read_storeys(const GeoProperty& property, const GeoProperty& first, House& house) {
    const std::string text = tag_of(*property.value);
    const auto storeys = storeys_tag(text);
    if (!storeys) {
      return cannot_read(property, house, "must be a whole number from 1 to 200, as 3 or \"3;4\", of which the most");
    }
    if (house.storeys && *house.storeys != storeys->value) {
      return error_at(house, ".properties." + property.way, shown_geo(*property.value),
                      fmt::format("must not stand beside {} = {}; --levels PROPERTY says which is read", first.way,
                                  shown_geo(*first.value)));
    }
    house.storeys = storeys->value;
    if (!storeys->as_written) {
      storeys_read_.push_back(fmt::format("{}, {} as {}", in_quotes(house.name), text, storeys->value));
    }
  }

  /// What is not as it stands, and what is wrong about all of them.
  void say_what_was_read() {
    if (!options_.levels.empty() && !has_levels_) {
      diagnostics_.add({.position = {file_},
                        .key = "--levels",
                        .value = in_quotes(options_.levels),
                        .rule = "must be a property of a house that is read",
                        .suggestion = likely(options_.levels, {properties_.begin(), properties_.end()})});
    }
    const auto say = [&](const char* what, const std::vector<std::string>& whom) {
      if (!whom.empty()) houses_.taken.push_back(fmt::format("{}: {}", what, fmt::join(whom, "; ")));
    };
    if (has_levels_) {
      houses_.taken.push_back(fmt::format("storeys are those of property {}{}", in_quotes(options_.levels),
                                          without_levels_.empty() ? "" : "; read as usual, without it: "));
      houses_.taken.back() += fmt::format("{}", fmt::join(without_levels_, "; "));
    }
    say("parts of a MultiPolygon are houses of their own, of the same storeys and height", parted_);
    say("storeys are whole (of several the most, a part of one is one, of a sum all)", storeys_read_);
    say("heights with a decimal comma or in feet are read as metres", heights_read_);
    say("what cannot be read is as if not given, as there is --storeys", unreadable_);
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
      const std::optional<PlanPoint> at = geo_place(place);
      if (!at) {
        error_at(house, fmt::format("{}[{}]", way, corners.size()), shown_geo(place), "must be a list of numbers");
        return {};
      }
      if (!is_geo_place(*at, options_.metres)) {
        error_at(house, fmt::format("{}[{}]", way, corners.size()), fmt::format("[{}, {}]", at->x(), at->y()),
                 options_.metres ? "must be metres within 1e8"
                                 : "must be a longitude in [-180, 180] and a latitude in [-90, 90]; give --metres "
                                   "where coordinates are metres");
        return {};
      }
      corners.push_back(*at);
    }
    if (corners.front() != corners.back()) {
      error_at(house, way, "", "must end where it begins (RFC 7946, 3.1.6)");
      return {};
    }
    corners.pop_back();
    return corners;
  }

  void leave_unread(const std::string& what, const SourcePosition& position) {
    UnreadKind& unread = unread_.try_emplace(what, UnreadKind{position.line}).first->second;
    unread.last = position.line;
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
    const auto placed = [&](const PlanPoint& at) { return geo_plan(at, middle, options_.metres); };
    const double extent = (placed(high) - placed(low)).maxCoeff();
    if (!(extent <= widest_block)) {
      error(fmt::format("is {} m from end to end, a block is at most {} m; {}", number(extent), number(widest_block),
                        take_a_part));
      return;
    }
    houses_.middle = options_.metres ? fmt::format("({:.3f}, {:.3f}) of the file", middle.x(), middle.y())
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
  const GeoJsonOptions& options_;
  Diagnostics& diagnostics_;
  Houses houses_;
  std::set<std::string> names_;       // of all houses, wanted or not
  std::set<std::string> properties_;  // of those that are wanted
  bool has_levels_ = false;           // one of them has the property of `levels`
  std::vector<std::string> without_levels_;
  std::vector<std::string> parted_, heights_read_, storeys_read_, unreadable_;  // which houses, and how
  std::map<std::string, UnreadKind> unread_;                                    // by what messages call it
};

}  // namespace

std::optional<Houses> read_geojson(const std::string& text, const std::string& name, const GeoJsonOptions& options,
                                   Diagnostics& diagnostics) {
  return GeoReader(name, options, diagnostics).read(text);
}

}  // namespace bentur
