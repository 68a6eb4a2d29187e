#include "bentur/io/exchange/block_case.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string_view>
#include <utility>
#include <vector>

#include "bentur/core/number_text.h"
#include "bentur/io/case/case_toml.h"
#include "bentur/io/toml/toml_view.h"
#include "bentur/model/gap/levels.h"
#include "bentur/pounding/plan/faces.h"
#include "bentur/pounding/plan/outline/common_area.h"
#include "bentur/pounding/plan/outline/near.h"
#include "bentur/structure/known/generic.h"

namespace bentur {
namespace {

constexpr std::size_t most_corners = 100;                         // as plan.polygon takes
constexpr double heaviest_floor = 1000;                           // [t/m²]
constexpr double shortest_period = 0.001, longest_period = 1000;  // [s]
constexpr double least_area = 1;                                  // [m²]
constexpr double lowest_storey = 1.5, highest_storey = 30;        // [m]

/// A house as a building in plan.
struct BlockBuilding {
  const House* house = nullptr;
  Footprint footprint;
  bool is_outline = true;  ///< the footprint covers what the floors do, but for trims
  double area = 0;         ///< of a floor [m²]
  PlanPoint centre;        ///< of that area
  double radius2 = 0;      ///< about it [m²]
  int storeys = 1;
  double storey_height = 0;  ///< [m]

  [[nodiscard]] std::vector<double> heights() const {
    return std::vector<double>(static_cast<std::size_t>(storeys), storey_height);
  }
  [[nodiscard]] FloorLevels levels() const { return {.elevations = floor_elevations(heights())}; }
};

double distance_from_line(const PlanPoint& at, const PlanPoint& from, const PlanPoint& to) {
  const PlanPoint edge = to - from, way = at - from;
  return std::abs(edge.x() * way.y() - edge.y() * way.x()) / edge.norm();
}

/// How far the corner of an outline that is deepest in its hull is from the hull's edge before it [m].
double depth_in_hull(std::vector<PlanPoint> outline, const std::vector<PlanPoint>& hull) {
  if (area_of(outline) < 0) std::reverse(outline.begin(), outline.end());
  const auto begin = std::find(outline.begin(), outline.end(), hull.front());
  std::rotate(outline.begin(), begin, outline.end());
  double deepest = 0;
  std::size_t edge = 0;  // the hull's corners are among the outline's, in the same order
  for (const PlanPoint& at : outline) {
    if (edge + 1 < hull.size() && at == hull[edge + 1]) ++edge;
    deepest = std::max(deepest, distance_from_line(at, hull[edge], hull[(edge + 1) % hull.size()]));
  }
  return deepest;
}

std::string metres(double length) { return fmt::format("{:.3g} m", length); }

/// To a millionth of a millimetre.
double rounded(double length) { return std::round(1e9 * length) / 1e9 + 0.0; }

std::string toml_text(const std::string& text) { return nlohmann::json(text).dump(); }

std::string toml_point(const PlanPoint& at) { return fmt::format("[{}, {}]", at.x() + 0.0, at.y() + 0.0); }

/// Lines of a comment.
std::string commented(const std::string& text) {
  std::istringstream words(text);
  std::string lines, line = "#";
  for (std::string word; words >> word;) {
    if (line.size() + 1 + word.size() > 98 && line.size() > 3) {
      lines += line + "\n";
      line = "#  ";
    }
    line += " " + word;
  }
  return lines + line + "\n";
}

class BlockMaker {
 public:
  BlockMaker(const Houses& houses, const std::string& file, const BlockRules& rules, Diagnostics& diagnostics)
      : houses_(houses), file_(file), rules_(rules), diagnostics_(diagnostics) {}

  std::optional<ImportedCase> make() {
    if (!(rules_.floor_mass > 0 && rules_.floor_mass <= heaviest_floor)) {
      diagnostics_.error({file_},
                         fmt::format("--floor-mass {}, must be in (0, {}] t/m²", rules_.floor_mass, heaviest_floor));
    }
    for (const House& house : houses_.all) add(house);
    check_overlaps();
    if (!diagnostics_.ok()) return std::nullopt;
    trim();
    if (diagnostics_.ok()) pair();
    if (!diagnostics_.ok()) return std::nullopt;
    say_rules();
    result_.unread = houses_.unread;
    write();
    check_case();
    if (!diagnostics_.ok()) return std::nullopt;
    return std::move(result_);
  }

 private:
  void error(const House& house, const std::string& way, const std::string& rule) {
    diagnostics_.add({.position = house.position, .key = house.key + way, .rule = rule});
  }

  /// One that no option helps with but the one that leaves the house out.
  void error_without(const House& house, const std::string& way, const std::string& rule) {
    error(house, way, fmt::format("{}; --without {} leaves it out", rule, in_quotes(house.name)));
  }

  void add(const House& house) {
    BlockBuilding made;
    made.house = &house;
    const bool is_shaped = shape(house, made);
    const bool has_storeys = give_storeys(house, made);
    if (is_shaped && has_storeys) buildings_.push_back(std::move(made));
  }

  bool shape(const House& house, BlockBuilding& made) {
    bool whole = true;
    const auto check = [&](const std::vector<PlanPoint>& ring, std::size_t index) {
      const auto fault = fault_of_outline(ring);
      if (fault) error_without(house, fmt::format(".geometry.coordinates[{}]", index), *fault);
      whole = whole && !fault;
    };
    check(house.outline, 0);
    for (std::size_t i = 0; i < house.holes.size(); ++i) check(house.holes[i], i + 1);
    if (!whole) return false;
    const std::vector<PlanPoint> hull = convex_hull(house.outline);
    const double depth = depth_in_hull(house.outline, hull);
    const bool takes_hull = depth <= rules_.snap || rules_.hull;
    const std::vector<PlanPoint>& corners = takes_hull ? hull : house.outline;
    if (corners.size() > most_corners) {
      error_without(house, ".geometry",
                    fmt::format("must have at most {} corners, not {}", most_corners, corners.size()));
      return false;
    }
    const bool drops_courts = rules_.hull && !house.holes.empty();
    made.footprint =
        polygon_footprint({0, 0}, corners, drops_courts ? std::vector<std::vector<PlanPoint>>() : house.holes);
    if (!courts_are_right(house, made.footprint) || !take_area(house, made)) return false;
    if (depth > rules_.snap && takes_hull) {
      made.is_outline = false;
      say("the hull stands for an outline that is not convex, the mass stays that of the outline",
          fmt::format("{}, {:.4g} m² more", in_quotes(house.name), area_of(hull) - std::abs(area_of(house.outline))));
    } else if (depth > 0 && takes_hull) {
      say("outlines that turn inwards by no more than --snap are made straight",
          fmt::format("{}, by {}", in_quotes(house.name), metres(depth)));
    }
    if (drops_courts) {
      made.is_outline = false;
      say("holes are left out of mass and stiffness, and touch nothing", in_quotes(house.name));
    }
    return true;
  }

  bool courts_are_right(const House& house, const Footprint& footprint) {
    for (std::size_t i = 0; i < footprint.rings.size(); ++i) {
      const auto fault = fault_of_court(footprint, i);
      if (fault) error_without(house, fmt::format(".geometry.coordinates[{}]", i + 1), *fault);
      if (fault) return false;
    }
    return true;
  }

  /// Of the outline, less its holes.
  bool take_area(const House& house, BlockBuilding& made) {
    double second = 0;
    PlanPoint first = PlanPoint::Zero();
    for (std::size_t i = 0; i <= house.holes.size(); ++i) {
      const Footprint ring{.polygon = i == 0 ? house.outline : house.holes[i - 1]};
      for (const PlanPoint& at : ring.polygon) {
        if (i == 0 || made.footprint.contains(at)) continue;
        error_without(house, fmt::format(".geometry.coordinates[{}]", i), "must lie in the outline");
        return false;
      }
      const double area = std::abs(area_of(ring.polygon)) * (i == 0 ? 1 : -1);
      made.area += area;
      first += area * ring.middle();
      second += area * (ring.radius2() + ring.middle().squaredNorm());
    }
    made.centre = first / made.area;
    made.radius2 = second / made.area - made.centre.squaredNorm();
    const bool is_possible = made.area >= least_area && made.radius2 > 0 && made.footprint.contains(made.centre);
    if (!is_possible) {
      error_without(house, ".geometry",
                    fmt::format("has {:.4g} m² of floor, must have {} or more", made.area, least_area));
    }
    return is_possible;
  }

  bool give_storeys(const House& house, BlockBuilding& made) {
    std::optional<int> storeys = house.storeys;
    if (!storeys && house.height) {
      storeys = std::max(1, static_cast<int>(std::lround(*house.height / rules_.storey_height)));
      say(fmt::format("as many storeys of about {} as the height has, where no number is given",
                      metres(rules_.storey_height)),
          fmt::format("{}, {}", in_quotes(house.name), *storeys));
    } else if (!storeys && rules_.storeys) {
      storeys = rules_.storeys;
      say(fmt::format("{} of {}, where neither storeys nor a height are given", counted(*storeys, "storey"),
                      metres(rules_.storey_height)),
          in_quotes(house.name));
    } else if (!storeys) {
      error(house, "",
            "has neither storeys (building:levels) nor a height; --levels PROPERTY reads storeys from another one, "
            "--storeys gives all such their number");
      return false;
    } else if (!house.height) {
      say(fmt::format("storeys are {} high, where no height is given", metres(rules_.storey_height)),
          in_quotes(house.name));
    }
    made.storeys = *storeys;
    made.storey_height = house.height ? std::round(1000 * *house.height / *storeys) / 1000 : rules_.storey_height;
    const double period = period_of(made);
    if (!(period >= shortest_period && period <= longest_period)) {
      error_without(house, "",
                    fmt::format("has a first period of {:.4g} s by --period-formula, must be in [{}, {}] s", period,
                                shortest_period, longest_period));
      return false;
    }
    if (made.storey_height >= lowest_storey && made.storey_height <= highest_storey) return true;
    error_without(house, "",
                  fmt::format("has storeys of {}, must be in [{}, {}] m", metres(made.storey_height), lowest_storey,
                              highest_storey));
    return false;
  }

  [[nodiscard]] double period_of(const BlockBuilding& one) const {
    return rules_.period_coefficient * std::pow(one.storeys * one.storey_height, rules_.period_exponent);
  }

  /// Calls it with both of every pair that may be within `reach` [m], the earlier one first, by the later ones.
  template <class Call>
  void each_pair(double reach, const Call& call) {
    std::vector<Footprint> footprints;
    for (const BlockBuilding& one : buildings_) footprints.push_back(one.footprint);
    auto pairs = pairs_near(footprints, reach);
    std::sort(pairs.begin(), pairs.end(),
              [](const auto& a, const auto& b) { return std::pair(a.second, a.first) < std::pair(b.second, b.first); });
    for (const auto& [earlier, later] : pairs) call(buildings_[earlier], buildings_[later]);
  }

  static std::string names_of(const BlockBuilding& one, const BlockBuilding& other) {
    return fmt::format("{} and {}", in_quotes(one.house->name), in_quotes(other.house->name));
  }

  void check_overlaps() {
    each_pair(0, [&](const BlockBuilding& earlier, const BlockBuilding& later) {
      if (!overlap(earlier.footprint, later.footprint)) return;
      const double depth = overlap_depth(earlier.footprint, later.footprint);
      if (depth <= rules_.snap) return;
      error_without(
          *later.house, "",
          fmt::format("overlaps {} by {}, {:.4g} m², must be at most --snap {}", in_quotes(earlier.house->name),
                      metres(depth), common_area(earlier.footprint, later.footprint), metres(rules_.snap)));
    });
  }

  void trim() {
    each_pair(0, [&](const BlockBuilding& earlier, BlockBuilding& later) {
      if (later.footprint.polygon.empty() || !overlap(earlier.footprint, later.footprint)) return;
      const double depth = overlap_depth(earlier.footprint, later.footprint);
      auto cut = cut_back(later.footprint, earlier.footprint);
      const auto round = [](std::vector<PlanPoint>& ring) {
        for (PlanPoint& at : ring) at = at.unaryExpr(&rounded);
      };
      if (cut) {
        round(cut->polygon);
        for (std::vector<PlanPoint>& ring : cut->rings) round(ring);
      }
      if (!cut || fault_of_outline(cut->polygon) || cut->area() < least_area || cut->polygon.size() > most_corners) {
        error_without(*later.house, "",
                      fmt::format("overlaps {} by {}, without which nothing is left of it",
                                  in_quotes(earlier.house->name), metres(depth)));
        later.footprint.polygon.clear();
        return;
      }
      later.footprint = polygon_footprint({0, 0}, cut->polygon, cut->rings);
      say("overlaps of no more than --snap are cut off the later one",
          fmt::format("{}, by {} at {}", in_quotes(later.house->name), metres(depth), in_quotes(earlier.house->name)));
    });
    for (BlockBuilding& one : buildings_) {
      if (!one.is_outline || one.footprint.polygon.empty()) continue;
      one.area = one.footprint.area();
      one.centre = one.footprint.middle();
      one.radius2 = one.footprint.radius2();
    }
  }

  /// Who may touch, and at which floors where these are not at one level.
  void pair() {
    each_pair(rules_.clearance, [&](const BlockBuilding& earlier, const BlockBuilding& later) {
      const auto stretch = joint_between(earlier.footprint, later.footprint);
      if (!stretch || stretch->width > rules_.clearance) return;
      const bool meet = !level_floors(earlier.levels(), later.levels()).empty();
      if (!meet && stretch->is_corner()) return;
      joints_.push_back(
          fmt::format("{}, {}", names_of(earlier, later), stretch->width > 0 ? metres(stretch->width) : "touching"));
      const FloorLevels one = earlier.levels(), other = later.levels();
      if (meet) return;
      double least = std::numeric_limits<double>::infinity();
      for (const double low : one.elevations) {
        for (const double high : other.elevations) least = std::min(least, std::abs(low - high));
      }
      gaps_ += fmt::format("\n[[gap]]\nbetween = [{}, {}]\nlevel_tolerance = {}\n", toml_text(earlier.house->name),
                           toml_text(later.house->name), std::ceil(1000 * least + 0.5) / 1000);
      say("floors that are nearest in height meet as if at one level, where none do (in truth one may strike columns)",
          fmt::format("{}, {} apart in height", names_of(earlier, later), metres(least)));
    });
    if (joints_.empty()) {
      std::string rule = fmt::format("no two buildings are within --clearance {} of one another: nothing can touch",
                                     metres(rules_.clearance));
      for (const std::string& one : houses_.left_out) rule += "; " + one;
      diagnostics_.error({file_}, rule);
    }
  }

  /// Of which buildings something is taken.
  void say(const std::string& what, const std::string& whom) {
    const auto found = std::find_if(said_.begin(), said_.end(), [&](const auto& one) { return one.first == what; });
    if (found != said_.end()) {
      found->second.push_back(whom);
    } else {
      said_.push_back({what, {whom}});
    }
  }

  void say_rules() {
    std::vector<std::string>& taken = result_.taken;
    taken.push_back(fmt::format("x is east and y north, counted from {}", houses_.middle));
    taken.insert(taken.end(), houses_.left_out.begin(), houses_.left_out.end());
    taken.insert(taken.end(), houses_.taken.begin(), houses_.taken.end());
    if (!houses_.renamed.empty()) {
      std::vector<std::string> names;
      for (const std::string& name : houses_.renamed) names.push_back(in_quotes(name));
      taken.push_back(fmt::format("names that others have are numbered: {}", fmt::join(names, "; ")));
    }
    for (const auto& [what, whom] : said_) {
      const bool of_all = whom.size() == buildings_.size() && whom.front() == in_quotes(houses_.all.front().name);
      taken.push_back(fmt::format("{}: {}", what, of_all ? "all buildings" : fmt::format("{}", fmt::join(whom, "; "))));
    }
    taken.push_back(fmt::format("a floor has {} t per m², roofs too: all buildings", rules_.floor_mass));
    taken.push_back(fmt::format(
        "first periods are {} H^{} s, H the height in metres{}; along x and y alike, all storeys of a "
        "building of one stiffness, elastic: all buildings",
        rules_.period_coefficient, rules_.period_exponent,
        rules_.period_coefficient == BlockRules{}.period_coefficient &&
                rules_.period_exponent == BlockRules{}.period_exponent
            ? " (concrete moment frames, ASCE 7-16, table 12.8-2: shorter than most that are measured, so that "
              "movements come out small)"
            : ""));
    taken.push_back(
        "stiffness is spread evenly over the floor: about its centre, k_theta = k r^2 (P-5), no eccentricity: all "
        "buildings");
    taken.push_back("damping is 0.05 of critical: all buildings");
    taken.push_back(
        "contact is kelvin-voigt with 4e5 kN/m for the whole joint of a level and a restitution of 0.65: all joints");
    taken.push_back(
        fmt::format("bases are at one elevation, and who stands further apart than {} never touches; "
                    "joints: {}",
                    metres(rules_.clearance), fmt::join(joints_, "; ")));
    taken.push_back(
        "the ground moves harmonically, 0.1 g at a period of 0.5 s, along 45 degrees: it stands for a record, no "
        "result means anything before [excitation] is yours");
  }

  void write() {
    std::string& text = result_.text;
    text =
        "# Made by bentur import. What the polygons do not say was taken by these rules; put what you know\n"
        "# in their place:\n";
    for (const std::string& one : result_.taken) text += commented("- " + one);
    text += fmt::format(
        "title = \"A block of {} buildings\"\n\n[units]\nlength = \"m\"\nforce = \"kN\"\n\n"
        "[plan]\nclearance = {}\ncontact = {{ law = \"kelvin-voigt\", stiffness = 4e5, restitution = 0.65 }}\n",
        buildings_.size(), rules_.clearance);
    for (const BlockBuilding& one : buildings_) text += building(one);
    text += gaps_ +
            "\n[excitation]\nkind = \"harmonic\"  # in place of a record\nperiod = 0.5\n"
            "acceleration_amplitude = \"0.1 g\"\nangle = 45.0\n\n[analysis]\nduration = 5.0\n";
  }

  /// What is written can be read, whatever the rules are.
  void check_case() {
    Diagnostics found;
    if (read_case_text(result_.text, "", found)) return;
    for (const Diagnostic& one : found.errors()) {
      diagnostics_.error({file_}, "would become a case with an error: " + one.message());
    }
  }

  [[nodiscard]] std::string building(const BlockBuilding& one) const {
    const std::vector<double> heights = one.heights();
    const double mass = rules_.floor_mass * one.area;
    const double height = one.storeys * one.storey_height;
    const double period = period_of(one);
    constexpr double pure_shear = 30;  // equal storeys then have one stiffness
    const GenericBuilding known{.storey_heights = heights,
                                .floor_masses = std::vector<double>(heights.size(), mass),
                                .period = period,
                                .stiffness_ratio = pure_shear};
    const double stiffness = generic_model(known).stiffness(one.storeys - 1, one.storeys - 1);
    const auto corners_of = [](const std::vector<PlanPoint>& ring) {
      std::vector<std::string> corners;
      for (const PlanPoint& at : ring) corners.push_back(toml_point(at));
      return fmt::format("[{}]", fmt::join(corners, ", "));
    };
    const auto floors = [&](const std::string& value) {
      return fmt::format("[{}]", fmt::join(std::vector<std::string>(heights.size(), value), ", "));
    };
    const std::string centre = fmt::format("[{:.3f}, {:.3f}]", one.centre.x(), one.centre.y());
    std::string text = fmt::format(
        "\n[[building]]\nname = {}\ndamping = 0.05\n\n[building.plan]\npolygon = {}\nstorey_heights = {}\n"
        "masses = {}  # {:.1f} m² a floor\ncentres_of_mass = {}\n",
        toml_text(one.house->name), corners_of(one.footprint.polygon), floors(fmt::format("{}", one.storey_height)),
        floors(fmt::format("{:.6g}", mass)), one.area, centre);
    if (!one.is_outline) {
      text += fmt::format("inertias = {}  # of the outline less its holes, as their centre is\n",
                          floors(fmt::format("{:.6g}", mass * one.radius2)));
    }
    for (const std::vector<PlanPoint>& court : one.footprint.rings) {
      text += fmt::format("\n[[building.plan.court]]\npolygon = {}\n", corners_of(court));
    }
    return text + fmt::format(
                      "\n[building.rigidity]  # T = {:.3f} s of H = {:.4g} m\ncentre = {}\nx = {:.6g}\n"
                      "y = {:.6g}\ntorsion = {:.6g}\n",
                      period, height, centre, stiffness, stiffness, stiffness * one.radius2);
  }

  const Houses& houses_;
  const std::string& file_;
  const BlockRules& rules_;
  Diagnostics& diagnostics_;
  std::vector<BlockBuilding> buildings_;
  std::vector<std::pair<std::string, std::vector<std::string>>> said_;  // in the order in which they were first said
  std::vector<std::string> joints_;
  std::string gaps_;
  ImportedCase result_;
};

}  // namespace

std::optional<ImportedCase> make_block_case(const Houses& houses, const std::string& file, const BlockRules& rules,
                                            Diagnostics& diagnostics) {
  return BlockMaker(houses, file, rules, diagnostics).make();
}

}  // namespace bentur
