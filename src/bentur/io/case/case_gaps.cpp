#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include "bentur/contact/laws.h"
#include "bentur/core/errors.h"
#include "bentur/core/number_text.h"
#include "bentur/io/case/case_parts.h"
#include "bentur/io/case/plan/plan_parts.h"
#include "bentur/io/schema/case_keys.h"
#include "bentur/io/schema/table_view.h"

namespace bentur {
namespace {

/// Whether some floor of either building is between base and top of the other.
bool face_each_other(const FloorLevels& left, const FloorLevels& right) {
  const auto faces = [](const FloorLevels& a, const FloorLevels& b) {
    return std::any_of(a.elevations.begin(), a.elevations.end(),
                       [&](double floor) { return floor >= b.base && floor <= b.elevations.back(); });
  };
  return faces(left, right) || faces(right, left);
}

/// How floors are to strike columns where none meet, with the elevations at which they can.
std::string strike_columns(const ReadBuilding& left, const ReadBuilding& right) {
  std::vector<double> elevations = columns_in_reach(left, right);
  const std::vector<double> of_left = columns_in_reach(right, left);
  elevations.insert(elevations.end(), of_left.begin(), of_left.end());
  std::sort(elevations.begin(), elevations.end());
  return elevations.empty() ? "give one of them as a frame, whose columns floors can strike (strikes_columns = true)"
                            : fmt::format("let floors strike columns with strikes_columns = true and elevations = [{}]",
                                          written(elevations));
}

/// What to do where no floors meet: those nearest to one another say how far the tolerance is from it.
std::string no_common_elevation(const ReadBuilding& left, const ReadBuilding& right) {
  double apart = std::numeric_limits<double>::infinity();
  for (const double a : left.elevations) {
    for (const double b : right.elevations) apart = std::min(apart, std::abs(a - b));
  }
  return fmt::format(
      "has no elevation at which both buildings have a floor: {} has floors at {}, {} at {}; let floors that nearly "
      "meet do so with level_tolerance (the nearest two are {} apart), {}, or model no contact with elevations = []: "
      "floors are then watched against the columns they face, for the gap they need",
      in_quotes(left.spec.name), written(left.elevations), in_quotes(right.spec.name), written(right.elevations),
      written(apart), strike_columns(left, right));
}

/// The contact points' elevations [length]; empty when they are not known, or there are to be none.
std::vector<double> read_elevations(const TomlView& gap, const ReadBuilding& left, const ReadBuilding& right,
                                    std::optional<double> tolerance, bool strikes_columns) {
  const auto given = gap.find("elevations");
  const FloorLevels a = floor_levels(left);
  const FloorLevels b = floor_levels(right);
  const bool nothing_moves = left.has_displacements() || right.has_displacements();
  if (!checked_to_face(gap, left, right)) return {};
  if (given && nothing_moves) {
    given->error("is not for a building known by its displacements: all floors that face the other are looked at");
  }
  if (nothing_moves || (given && models_no_contact(*given))) return {};
  const std::vector<double> wanted =
      given ? given->as_numbers(gap_keys().at("elevations").range) : std::vector<double>();
  if (std::adjacent_find(wanted.begin(), wanted.end(), std::greater_equal<>()) != wanted.end()) {
    given->error("must ascend");
    return {};
  }
  if (left.elevations.empty() || right.elevations.empty() || (given && wanted.empty())) return {};
  const std::vector<LevelPair> pairs = level_floors(a, b, tolerance);
  if (strikes_columns) return given ? read_struck_columns(*given, wanted, pairs, left, right) : std::vector<double>();
  if (pairs.empty()) {
    gap.error(no_common_elevation(left, right));
    return {};
  }
  if (given) return named_elevations(*given, wanted, pairs, a, b);
  std::vector<double> common;
  for (const LevelPair& pair : pairs) common.push_back(pair.elevation);
  return common;
}

/// One key of the law into `spec`; false (and an error) unless its value is usable.
bool read_number(const TomlView& value, const LawEntry& law, const Key& key, const GapSides& sides, ContactSpec& spec) {
  const bool axial = !key.words.empty();
  // In plan frames are planes: whether some stand across the joint shows where its laws are made.
  const auto may_have_beams = [](const ReadBuilding& one) { return one.is_frame || one.spec.is_in_plan(); };
  if (value.is(TomlValue::Kind::text)) {
    if (value.value().text != "axial") {
      value.error_value(axial ? "must be a number, a list of numbers or \"axial\""
                              : "must be a number or a list of numbers");
    } else if (!axial) {
      value.error_value(fmt::format("must be a number or a list of numbers: with law = \"{}\" {} is no force/length",
                                    law.name, key.name));
    } else if (!may_have_beams(sides.left) || !may_have_beams(sides.right)) {
      value.error_value(fmt::format("needs two frames, but {} is none",
                                    (may_have_beams(sides.left) ? sides.right : sides.left).path));
    } else {
      spec.axial = true;
    }
    return spec.axial;
  }
  const std::vector<double> numbers = value.as_number_or_numbers(key.range, sides.points());
  if (numbers.empty()) return false;
  spec.numbers[std::string(key.name)] = numbers;
  return true;
}

/// What the law needs: each required key, exactly one of those that exclude one another.
bool read_numbers(const TableView& contact, const LawEntry& law, const GapSides& sides, ContactSpec& spec) {
  bool good = true;
  std::string_view group;
  for (const Key& key : law.keys) {
    if (key.need == Need::one_of) group = key.group;
    const auto value = contact.get(key.name);
    const bool read = value ? read_number(*value, law, key, sides, spec) : !key.is_required();
    good = good && read;
  }
  const bool one = group.empty() || contact.exactly_one(group).has_value();
  return good && one;
}

bool read_choices(const TableView& contact, const LawEntry& law, ContactSpec& spec) {
  bool good = true;
  for (const Key& choice : law.choices) {
    const auto value = contact.find(std::string(choice.name));
    if (!value) continue;
    if (const auto word = value->as_word({choice.words.begin(), choice.words.end()})) {
      spec.words[std::string(choice.name)] = *word;
    } else {
      good = false;
    }
    if (!choice.with.empty() && !contact.has(std::string(choice.with))) {
      value->error(fmt::format("goes with {}, which is not given", choice.with));
      good = false;
    }
  }
  return good;
}

/// What is of contact along a joint, of buildings in plan: friction, and what belongs to a corner.
bool read_along_joint(const TableView& contact, const GapSides& sides, ContactSpec& spec) {
  bool good = true, rubs = false;
  for (const char* const name : {"friction", "tangential_stiffness"}) {
    const auto value = contact.find(name);
    if (!value) continue;
    const std::vector<double> numbers = value->as_number_or_numbers(contact.key(name).range, sides.points());
    good = good && !numbers.empty();
    if (!numbers.empty()) spec.numbers[name] = numbers;
  }
  if (const auto spread = contact.find("spread")) {
    const auto length = spread->as_number(contact.key("spread").range);
    good = good && length;
    if (length) spec.numbers["spread"] = {*length};
  }
  if (const auto friction = spec.numbers.find("friction"); friction != spec.numbers.end()) {
    rubs = std::any_of(friction->second.begin(), friction->second.end(), [](double mu) { return mu > 0; });
  }
  if (!good || rubs || !contact.has("tangential_stiffness")) return good;
  contact.refuse({"tangential_stiffness"}, "goes with friction > 0");
  return false;
}

}  // namespace

Length GapSides::points() const {
  return {elevations.size(), fmt::format("one per contact point, at elevations {}", written(elevations))};
}

std::optional<ContactSpec> read_contact(const TomlView& gap, const GapSides& sides, Need need) {
  const auto view = gap.get("contact", need);
  if (!view) return std::nullopt;
  if (!view->is(TomlValue::Kind::table)) {
    view->error_value("must be a table with law and what that law needs");
    return std::nullopt;
  }
  const TableView contact = *TableView::of(*view, contact_keys());
  ContactSpec spec;
  const LawEntry* const law = contact.law("law", contact_laws(), &OwnLaw::contact, spec.own);
  if (law == nullptr) return std::nullopt;
  spec.law = law->name;
  const bool numbers = read_numbers(contact, *law, sides, spec);
  const bool choices = read_choices(contact, *law, spec);
  const bool friction = read_along_joint(contact, sides, spec);
  return numbers && choices && friction ? std::optional(spec) : std::nullopt;
}

bool say_of_law(const TomlView& contact, const InvalidParameter& fault, std::size_t point) {
  const auto value = contact.find(fault.parameter());
  if (!value) {
    contact.error(std::string("cannot be computed with: ") + fault.what());
  } else if (value->is(TomlValue::Kind::list)) {
    value->item(point).error_value(fault.rule());
    return false;
  } else {
    value->error_value(fault.rule());
  }
  return true;
}

namespace {

/// Values that are right one by one but do not go together, such as a contact that is stiffer once it has yielded: each
/// contact point's law is made once, with the masses and beams it will have.
void check_laws(const TomlView& contact, const GapSpec& spec, const GapSides& sides) {
  if (!sides.left.model || !sides.right.model) return;
  const SpecAndModel left{sides.left.spec, *sides.left.model}, right{sides.right.spec, *sides.right.model};
  std::vector<LevelPair> floors;
  for (std::size_t i = 0; i < spec.elevations.size(); ++i) {
    try {
      if (floors.empty()) floors = floors_of_points(spec, left, right);
      (void)make_contact_law(spec, i, left, right, floors[i]);
    } catch (const InvalidParameter& fault) {
      if (say_of_law(contact, fault, i)) return;
    }
  }
}

/// That the sections of struck columns say nothing else.
void check_column_capacity(const TableView& capacity, const GapSides& sides, const GapSpec& spec) {
  const std::size_t given = spec.column_capacity->shear.size();
  if (given == 0 || given != spec.elevations.size() || !sides.left.model || !sides.right.model) return;
  const SpecAndModel left{sides.left.spec, *sides.left.model}, right{sides.right.spec, *sides.right.model};
  const std::vector<LevelPair> floors = floors_of_points(spec, left, right);
  for (std::size_t i = 0; i < given; ++i) {
    try {
      static_cast<void>(column_shear_capacity(spec, i, left, right, floors[i]));
    } catch (const InvalidParameter& fault) {
      const auto value = capacity.find("shear");
      if (value->is(TomlValue::Kind::list)) {
        value->item(i).error_value(fault.rule());
        continue;
      }
      value->error_value(fault.rule());
      return;  // the other points would say the same
    }
  }
}

}  // namespace

void read_strikes_columns(const TableView& gap, GapSpec& spec) {
  spec.strikes_columns = gap.flag("strikes_columns");
  if (!spec.strikes_columns) {
    gap.refuse({"column_capacity"}, "goes with strikes_columns = true");
    return;
  }
  if (!gap.has("elevations")) gap.error_missing("elevations", "strikes_columns = true needs to know where");
}

void read_column_capacity(const TableView& gap, const GapSides& sides, GapSpec& spec) {
  const auto capacity = spec.strikes_columns ? gap.table("column_capacity") : std::nullopt;
  if (!capacity) return;
  if (!capacity->has("shear") && !capacity->has("moment")) capacity->error("needs shear, moment or both");
  const auto of_points = [&](const char* key) {
    const auto given = capacity->find(key);
    return given ? given->as_number_for_each(capacity->key(key).range, sides.points()) : std::vector<double>();
  };
  spec.column_capacity = GapSpec::ColumnCapacity{of_points("shear"), of_points("moment")};
  check_column_capacity(*capacity, sides, spec);
}

namespace {

GapSpec read_gap(const TomlView& entry, const ReadBuilding& left, const ReadBuilding& right,
                 const std::vector<ReadBuilding>& buildings) {
  GapSpec spec;
  const auto table = TableView::of(entry, gap_keys());
  if (!table) return spec;
  const TableView& gap = *table;
  const auto given_sides = read_between(gap, buildings, "the neighbours, left and right");
  if (given_sides && (&buildings[given_sides->first] != &left || &buildings[given_sides->second] != &right)) {
    const auto name = [&](std::size_t b) { return in_quotes(buildings[b].spec.name); };
    gap.find("between")->error_shown(fmt::format("[{}, {}]", name(given_sides->first), name(given_sides->second)),
                                     fmt::format("must be [{}, {}] (gaps and neighbours from left to right)",
                                                 in_quotes(left.spec.name), in_quotes(right.spec.name)));
  }
  spec.level_tolerance = gap.number("level_tolerance");
  read_strikes_columns(gap, spec);
  spec.elevations = read_elevations(gap, left, right, spec.level_tolerance, spec.strikes_columns);
  const std::size_t points = spec.elevations.size();
  const auto given = gap.find("elevations");
  const bool nothing_moves = left.has_displacements() || right.has_displacements();
  const bool no_contact = nothing_moves || (given && models_no_contact(*given));
  if (nothing_moves) gap.refuse({"contact"}, "is not for a building known by its displacements: nothing is simulated");
  const GapSides sides{left, right, spec.elevations};
  gap.refuse({"points"}, "is of buildings in plan: give them [building.plan]");
  if (!gap.has("width")) gap.error_missing("width");
  if (const auto width = gap.find("width")) {
    if (no_contact) {
      if (const auto number = width->as_number(gap.key("width").range)) spec.widths = {*number};
    } else {
      spec.widths = width->as_number_or_numbers(gap.key("width").range, sides.points());
    }
    if (spec.widths.size() == 1 && points > 1) spec.widths.resize(points, double{spec.widths.front()});
  }
  read_column_capacity(gap, sides, spec);
  if (const auto contact = read_contact(gap, sides, no_contact ? Need::optional : Need::required)) {
    spec.contact = *contact;
    check_laws(*gap.find("contact"), spec, sides);
  }
  if (const auto contact = gap.find("contact"); contact && contact->is(TomlValue::Kind::table)) {
    contact->refuse({"friction", "tangential_stiffness", "spread"},
                    "is of buildings in plan: give them [building.plan]");
  }
  return spec;
}

}  // namespace

bool models_no_contact(const TomlView& elevations) {
  return elevations.is(TomlValue::Kind::list) && elevations.size() == 0;
}

bool checked_to_face(const TomlView& gap, const ReadBuilding& left, const ReadBuilding& right) {
  const FloorLevels a = floor_levels(left), b = floor_levels(right);
  if (a.elevations.empty() || b.elevations.empty() || face_each_other(a, b)) return true;
  gap.error(fmt::format(
      "is between buildings of which no floor faces the other: {} reaches from {} to {}, {} from {} to {}",
      in_quotes(left.spec.name), a.base, a.elevations.back(), in_quotes(right.spec.name), b.base, b.elevations.back()));
  return false;
}

FloorLevels floor_levels(const ReadBuilding& building) { return {building.elevations, building.spec.base_elevation}; }

std::optional<std::pair<std::size_t, std::size_t>> read_between(const TomlView& table,
                                                                const std::vector<ReadBuilding>& buildings,
                                                                const std::string& what) {
  const auto between = table.get("between");
  if (!between || !between->is_list_of("building names", {2, what})) return std::nullopt;
  std::vector<std::string> names;
  for (const ReadBuilding& building : buildings) {
    const std::string& name = building.spec.name;
    // Without a name of its own for each building there is nothing to compare with; that has been said.
    if (name.empty() || std::find(names.begin(), names.end(), name) != names.end()) return std::nullopt;
    names.push_back(name);
  }
  std::vector<std::size_t> given;
  for (const TomlView& entry : between->items()) {
    const auto name = entry.as_text();
    if (!name) return std::nullopt;
    const auto found = std::find(names.begin(), names.end(), *name);
    if (found == names.end()) {
      return entry.error_value("there is no such building, " + suggestion(*name, names, "the buildings are"));
    }
    given.push_back(static_cast<std::size_t>(found - names.begin()));
  }
  return std::pair(given[0], given[1]);
}

namespace {

int nearest_floor_to(const FloorLevels& building, double elevation) {
  const auto nearest =
      std::min_element(building.elevations.begin(), building.elevations.end(),
                       [&](double a, double b) { return std::abs(a - elevation) < std::abs(b - elevation); });
  return static_cast<int>(nearest - building.elevations.begin());
}

/// The end of a message about an elevation in `list` where two floors would meet with a larger tolerance, or nothing.
std::string nearly_met(const TomlView& list, double elevation, const std::vector<LevelPair>& pairs,
                       const FloorLevels& left, const FloorLevels& right) {
  const int a = nearest_floor_to(left, elevation), b = nearest_floor_to(right, elevation);
  const auto meet = [&](const LevelPair& pair) { return pair.left_floor == a && pair.right_floor == b; };
  if (std::any_of(pairs.begin(), pairs.end(), meet)) return "";
  const double apart =
      std::abs(left.elevations[static_cast<std::size_t>(a)] - right.elevations[static_cast<std::size_t>(b)]);
  const std::string table = list.path().substr(0, list.path().rfind('.'));
  return fmt::format("; floors that nearly meet do so with {}.level_tolerance, here the nearest two are {} apart",
                     table, written(apart));
}

}  // namespace

std::vector<double> named_elevations(const TomlView& list, const std::vector<double>& wanted,
                                     const std::vector<LevelPair>& pairs, const FloorLevels& left,
                                     const FloorLevels& right) {
  std::vector<double> common, named;
  for (const LevelPair& pair : pairs) common.push_back(pair.elevation);
  std::vector<const LevelPair*> taken;
  const double round_off = round_off_of_levels(left, right);
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    const LevelPair* const pair = pair_at(wanted[i], pairs, left, right);
    if (pair == nullptr) {
      list.item(i).error_value(fmt::format("the buildings do not both have a floor there{}{}{}",
                                           common.empty() ? "" : ", they have at ", written(common),
                                           nearly_met(list, wanted[i], pairs, left, right)));
    } else if (const auto before = std::find(taken.begin(), taken.end(), pair); before != taken.end()) {
      list.item(i).error_value(fmt::format("names the floors that elevations[{}] = {} names: give each pair once",
                                           before - taken.begin(),
                                           wanted[static_cast<std::size_t>(before - taken.begin())]));
    }
    taken.push_back(pair);
    if (pair != nullptr)
      named.push_back(std::abs(wanted[i] - pair->elevation) <= round_off ? wanted[i] : pair->elevation);
  }
  return named.size() == wanted.size() ? named : std::vector<double>{};
}

std::vector<GapSpec> read_gaps(const TomlView& root, const std::vector<ReadBuilding>& buildings) {
  std::vector<GapSpec> gaps;
  const auto list = root.tables("gap", "one [[gap]] table between each pair of neighbours");
  if (!list) return gaps;
  const std::size_t expected = buildings.empty() ? 0 : buildings.size() - 1;
  if (list->size() != expected && buildings.size() > 1) {
    list->error(fmt::format("has {}, expected {} (one between each pair of neighbours)", list->entries(), expected));
  }
  for (std::size_t i = 0; i < std::min(list->size(), expected); ++i) {
    gaps.push_back(read_gap(list->item(i), buildings[i], buildings[i + 1], buildings));
  }
  return gaps;
}

}  // namespace bentur
