#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <utility>

#include "bentur/core/number_text.h"
#include "bentur/core/text.h"
#include "bentur/io/exchange/internal/geo_choice.h"
#include "bentur/io/exchange/internal/outline_distance.h"
#include "bentur/io/exchange/local_plan.h"
#include "bentur/io/toml/toml_view.h"

namespace bentur {
namespace {

constexpr std::size_t longest_name = 100;  // bytes
constexpr std::size_t most_listed = 20;    // houses that are left out and listed by name

/// Some of them by name.
std::string listed_names(const std::vector<std::string>& names) {
  const std::size_t shown = std::min(names.size(), most_listed);
  std::string all =
      fmt::format("{}", fmt::join(names.begin(), names.begin() + static_cast<std::ptrdiff_t>(shown), "; "));
  if (shown < names.size()) all += fmt::format("; and {} more", names.size() - shown);
  return all;
}

class GeoChooser {
 public:
  GeoChooser(const std::string& file, const GeoJsonOptions& options, Diagnostics& diagnostics)
      : file_(file), options_(options), diagnostics_(diagnostics) {}

  GeoChoice choose(const std::vector<GeoFeature>& features) {
    find_candidates(features);
    mark_unwanted();
    keep_those_around();
    std::erase_if(choice_.houses, [](const GeoCandidate& one) { return !one.is_wanted; });
    return std::move(choice_);
  }

 private:
  void error_at(const House& house, const std::string& way, const std::string& rule) {
    diagnostics_.add({.position = house.position, .key = house.key + way, .rule = rule});
  }

  void error_of_option(const std::string& option, const std::string& value, const std::string& rule,
                       const std::set<std::string>& known) {
    choice_.is_made = false;
    diagnostics_.add({.position = {file_},
                      .key = option,
                      .value = in_quotes(value),
                      .rule = rule,
                      .suggestion = likely(value, {known.begin(), known.end()})});
  }

  void find_candidates(const std::vector<GeoFeature>& features) {
    std::vector<std::string> nowhere;
    for (std::size_t i = 0; i < features.size(); ++i) {
      const GeoNode& feature = features[i].node;
      GeoCandidate one;
      one.house.position = features[i].position;
      one.house.key = fmt::format("features[{}]", i);
      const GeoNode* const type = geo_member(feature, "type");
      if (type == nullptr || *type != "Feature") {
        error_at(one.house, "", "must be a Feature");
        continue;
      }
      const GeoNode* const shape = geo_member(feature, "geometry");
      const GeoNode* const kind = shape != nullptr ? geo_member(*shape, "type") : nullptr;
      if (kind != nullptr && *kind != "Polygon" && *kind != "MultiPolygon") {
        choice_.unread.emplace_back("geometry " + shown_geo(*kind), &features[i]);
        continue;
      }
      one.properties = geo_member(feature, "properties");
      read_name(feature, i, one);
      if (kind == nullptr) {
        nowhere.push_back(in_quotes(one.house.name));
        continue;
      }
      one.is_multi = *kind == "MultiPolygon";
      one.coordinates = geo_member(*shape, "coordinates");
      if (one.coordinates == nullptr || !one.coordinates->is_array()) {
        error_at(one.house, ".geometry.coordinates", "must be a list of rings; " + without_it(one.house));
        continue;
      }
      choice_.houses.push_back(std::move(one));
    }
    if (!nowhere.empty())
      choice_.left_out.push_back("features without geometry are left out: " + listed_names(nowhere));
  }

  void read_name(const GeoNode& feature, std::size_t index, GeoCandidate& one) {
    House& house = one.house;
    const GeoNode* const tags = one.properties != nullptr ? geo_member(*one.properties, "tags") : nullptr;
    const GeoNode* given = one.properties != nullptr ? geo_member(*one.properties, "name") : nullptr;
    if (given == nullptr && tags != nullptr) given = geo_member(*tags, "name");
    const GeoNode* const id = geo_member(feature, "id");
    const auto is_text = [](const GeoNode* node) { return node != nullptr && node->is_string(); };
    const auto is_blank = [](const std::string& text) { return text.find_first_not_of(' ') == std::string::npos; };
    const std::string unnamed = fmt::format("building {}", index + 1);
    if (is_text(id)) one.id = id->get<std::string>();
    if (id != nullptr && id->is_number_integer()) one.id = id->dump();
    const bool has_name = is_text(given) && !is_blank(given->get_ref<const std::string&>());
    one.asked = has_name ? given->get<std::string>() : is_blank(one.id) ? unnamed : one.id;
    house.name = one.asked;
    std::string value, rule;
    if (given != nullptr && !given->is_string()) {
      value = shown_geo(*given);
      rule = "must be a text in quotes";
    }
    if (!is_one_line(house.name) || house.name.size() > longest_name) {
      value = in_quotes(house.name);
      rule = is_one_line(house.name) ? fmt::format("must have at most {} bytes", longest_name)
                                     : "must be one line without control characters and marks of direction";
      house.name = unnamed;
    }
    house.name = unlike_others(house.name);
    if (!rule.empty()) {
      one.faults.add({.position = house.position,
                      .key = house.key + ".properties.name",
                      .value = value,
                      .rule = rule + "; " + without_it(house)});
    }
    house.key += fmt::format(" ({})", in_quotes(house.name));
  }

  std::string unlike_others(const std::string& asked) {
    std::string name = asked;
    int& last = last_of_name_.try_emplace(asked, 1).first->second;
    while (!choice_.names.insert(name).second) name = fmt::format("{} ({})", asked, ++last);
    return name;
  }

  /// Outlines of a house as far as they can be read, about `middle` [m].
  [[nodiscard]] std::vector<std::vector<PlanPoint>> outlines_about(const GeoCandidate& one,
                                                                   const PlanPoint& middle) const {
    std::vector<std::vector<PlanPoint>> outlines;
    for (const GeoNode* const rings : one.polygons()) {
      std::vector<PlanPoint> corners;
      const GeoNode* const outline = rings->is_array() && !rings->empty() ? &(*rings)[0] : nullptr;
      for (std::size_t i = 0; outline != nullptr && outline->is_array() && i < outline->size(); ++i) {
        if (const auto at = geo_place((*outline)[i])) corners.push_back(geo_plan(*at, middle, options_.metres));
      }
      if (!corners.empty()) outlines.push_back(std::move(corners));
    }
    return outlines;
  }

  /// The place that a text is, "LON,LAT".
  [[nodiscard]] std::optional<PlanPoint> place_of(const std::string& text) const {
    const std::size_t comma = text.find(',');
    if (comma == std::string::npos) return std::nullopt;
    const auto x = parse_number(trimmed(std::string_view(text).substr(0, comma)));
    const auto y = parse_number(trimmed(std::string_view(text).substr(comma + 1)));
    if (!x || !y || !is_geo_place({*x, *y}, options_.metres)) return std::nullopt;
    return PlanPoint(*x, *y);
  }

  void keep_those_around() {
    if (options_.around.empty()) return;
    std::vector<const GeoCandidate*> named;
    for (const GeoCandidate& one : choice_.houses) {
      if (one.is_called(options_.around)) named.push_back(&one);
    }
    std::optional<PlanPoint> middle;
    std::vector<std::vector<PlanPoint>> near;
    if (named.empty()) {
      middle = place_of(options_.around);
      near = {{PlanPoint::Zero()}};
    } else {
      for (const GeoNode* const rings : named.front()->polygons()) {
        const bool has_corner = rings->is_array() && !rings->empty() && (*rings)[0].is_array() && !(*rings)[0].empty();
        if (has_corner && !middle) middle = geo_place((*rings)[0][0]);
      }
      if (middle && !is_geo_place(*middle, options_.metres)) middle.reset();
      for (const GeoCandidate* const one : named) {
        const auto more = middle ? outlines_about(*one, *middle) : std::vector<std::vector<PlanPoint>>();
        near.insert(near.end(), more.begin(), more.end());
      }
    }
    if (!middle) {
      error_of_option("--around", options_.around,
                      options_.metres ? "must be the name or id of a polygon, or X,Y in metres"
                                      : "must be the name or id of a polygon, or LON,LAT in degrees",
                      candidate_names());
      return;
    }
    const auto is_far = [&](const GeoCandidate& one) {
      const auto outlines = outlines_about(one, *middle);
      if (outlines.empty()) return false;  // its errors are told
      for (const auto& outline : outlines) {
        for (const auto& other : near) {
          if (!(distance_of_boxes(outline, other) <= options_.radius)) continue;
          if (outline_distance(outline, other) <= options_.radius) return false;
        }
      }
      return true;
    };
    const std::size_t far = std::erase_if(choice_.houses, is_far);
    if (far == 0) return;
    choice_.left_out.push_back(fmt::format("who is further than --radius {} m from {} is left out: {}",
                                           number(options_.radius), in_quotes(options_.around), counted(far, "house")));
  }

  /// Those of --without, and checks that each name is of a house or of a part of one.
  void mark_unwanted() {
    std::vector<std::string> left;
    for (const std::string& name : options_.without) {
      bool is_known = false;
      for (GeoCandidate& one : choice_.houses) {
        if (one.is_called(name)) one.is_wanted = false;
        is_known = is_known || one.is_called(name);
        if (!options_.parts || !one.is_multi) continue;
        for (std::size_t part = 1; part <= one.coordinates->size(); ++part) {
          const std::string part_name = one.name_of_part(part);
          is_known = is_known || part_name == name;
          if (part_name == name) left.push_back(in_quotes(name));
        }
      }
      if (!is_known) error_of_option("--without", name, "must be the name or id of a polygon", candidate_names());
    }
    for (const GeoCandidate& one : choice_.houses) {
      if (!one.is_wanted) left.push_back(in_quotes(one.house.name));
    }
    if (!left.empty()) choice_.left_out.push_back("--without leaves out: " + listed_names(left));
  }

  [[nodiscard]] std::set<std::string> candidate_names() const {
    std::set<std::string> names;
    for (const GeoCandidate& one : choice_.houses) names.insert(one.house.name);
    return names;
  }

  const std::string& file_;
  const GeoJsonOptions& options_;
  Diagnostics& diagnostics_;
  GeoChoice choice_;
  std::map<std::string, int> last_of_name_;  // the number that the last house of a name has
};

}  // namespace

std::string shown_geo(const GeoNode& node) {
  if (node.is_object()) return "a table";
  if (node.is_array()) return "a list";
  if (node.is_string()) return in_quotes(node.get_ref<const std::string&>());
  return node.dump();
}

const GeoNode* geo_member(const GeoNode& node, const char* key) {
  if (!node.is_object()) return nullptr;
  const auto found = node.find(key);
  return found == node.end() || found->is_null() ? nullptr : &*found;
}

std::optional<PlanPoint> geo_place(const GeoNode& node) {
  const bool is_place = node.is_array() && node.size() >= 2 && node[0].is_number() && node[1].is_number();
  if (!is_place) return std::nullopt;
  return PlanPoint(node[0].get<double>(), node[1].get<double>());
}

bool is_geo_place(const PlanPoint& at, bool metres) {
  return metres ? at.cwiseAbs().maxCoeff() <= 1e8 : std::abs(at.x()) <= 180 && std::abs(at.y()) <= 90;
}

PlanPoint geo_plan(const PlanPoint& at, const PlanPoint& middle, bool metres) {
  return metres ? PlanPoint(at - middle) : local_plan({at.x(), at.y()}, {middle.x(), middle.y()});
}

std::string without_it(const House& house) { return fmt::format("--without {} leaves it out", in_quotes(house.name)); }

std::vector<const GeoNode*> GeoCandidate::polygons() const {
  if (!is_multi) return {coordinates};
  std::vector<const GeoNode*> all;
  for (const GeoNode& one : *coordinates) all.push_back(&one);
  return all;
}

std::string GeoCandidate::name_of_part(std::size_t part) const { return fmt::format("{}, part {}", house.name, part); }

GeoChoice choose_houses(const std::vector<GeoFeature>& features, const std::string& file, const GeoJsonOptions& options,
                        Diagnostics& diagnostics) {
  return GeoChooser(file, options, diagnostics).choose(features);
}

}  // namespace bentur
