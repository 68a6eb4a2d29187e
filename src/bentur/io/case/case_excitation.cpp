#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "bentur/core/number_text.h"
#include "bentur/core/text.h"
#include "bentur/io/case/case_memo.h"
#include "bentur/io/case/case_parts.h"
#include "bentur/io/file_identity.h"
#include "bentur/io/input_file.h"
#include "bentur/io/records/record_files.h"
#include "bentur/io/schema/case_keys.h"
#include "bentur/io/schema/table_view.h"

namespace bentur {
namespace {

/// A whole number that says where in a file to look; `good` is set to false where it is none.
std::optional<int> read_place(const TableView& view, const char* key, bool& good) {
  const auto place = view.whole(key);
  good = good && (place || !view.has(key));
  return place ? std::optional(static_cast<int>(*place)) : std::nullopt;
}

/// The unit of the file's numbers: its own, or the case's where it says none; nothing where neither is known.
/// @param given the case's, empty: it has none, or a wrong one, of which has been said so
std::optional<std::string> settle_unit(const TableView& view, const StrongMotionRecord& record, const std::string& name,
                                       const std::string& given) {
  if (!record.unit.empty()) return record.unit;
  if (!view.has("unit")) {
    view.error_missing(
        "unit", fmt::format("{} does not say it; one of {}", in_quotes(name), fmt::join(acceleration_units(), ", ")));
  }
  return given.empty() ? std::nullopt : std::optional(given);
}

}  // namespace

std::optional<double> read_acceleration(const TomlView& value, const Units& units, double of_number) {
  if (!value.is(TomlValue::Kind::text)) {
    const auto number = value.as_number(Range::positive);
    return number ? std::optional(*number * of_number) : std::nullopt;
  }
  const std::string_view text = trimmed(value.value().text);
  double number = 0;
  const char* const end = text.data() + text.size();
  const auto read = from_chars(text.data(), end, number);
  const std::string known = fmt::format("{}, gal", fmt::join(acceleration_units(), ", "));
  if (read.ec != std::errc()) {
    return value.error_value(fmt::format("must be a number, or one with its unit as \"0.35 g\"; units are {}", known));
  }
  const std::string unit(trimmed(text.substr(static_cast<std::size_t>(read.ptr - text.data()))));
  if (unit.empty())
    return value.error_value(
        fmt::format("has no unit; one of {}, or without quotes {}", known, of_number == 1 ? "length/s²" : "g"));
  const bool gal = unit == "gal" || unit == "Gal";
  const std::vector<std::string>& all = acceleration_units();
  if (!gal && std::find(all.begin(), all.end(), unit) == all.end()) {
    return value.error_value(
        fmt::format("{} is no unit of acceleration, the known ones are {}", in_quotes(unit), known));
  }
  const double acceleration = number * acceleration_factor(gal ? "cm/s2" : unit, units);
  if (!std::isfinite(acceleration)) return value.error_value("must be finite");
  if (!(acceleration > 0)) return value.error_value("must be > 0");
  return acceleration;
}

namespace {

/// The peak that the record is scaled to, or the amplitude of a harmonic motion [length/s²].
std::optional<double> read_acceleration(const TomlView& view, const char* key, const Units& units) {
  const auto value = view.find(key);
  return value ? read_acceleration(*value, units) : std::nullopt;
}

/// Scales to the case's length/s² and, where asked for, to a peak or by a factor.
void apply_scale(const TableView& view, double unit_factor, const Units& units, SampledMotion& motion,
                 RecordEcho& echo) {
  const auto key = view.exactly_one("scale");
  double factor = unit_factor;
  if (key == "scale") {
    factor *= view.number("scale").value_or(1);
  } else if (key == "pga") {
    const auto pga = read_acceleration(view, "pga", units);
    if (!(echo.pga_read > 0)) {
      view.find("pga")->error("cannot be reached: the record is zero throughout");
    } else if (pga) {
      factor = *pga / echo.pga_read;
      if (view.find("pga")->is_number()) echo.pga_without_unit = *pga;
    }
  }
  echo.reversed = view.word("polarity") == "reversed";
  if (echo.reversed) factor = -factor;
  for (double& value : motion.acceleration) value *= factor;
  echo.pga = echo.pga_read * std::abs(factor);
  if (!std::isfinite(echo.pga / units.gravity)) view.error("scales the record beyond what can be computed with");
}

/// A record whose accelerations stand in the case itself.
std::optional<SampledMotion> read_values(const TableView& view, const Units& units, RecordEcho& echo, bool identified) {
  view.refuse({"format", "column", "channel", "component", "skip_lines"}, "is of a file, and there is none");
  for (const char* const key : {"time_step", "unit"}) {
    if (!view.has(key)) view.error_missing(key, "of values that stand in no file");
  }
  StrongMotionRecord record;
  record.format = "values";
  record.time_step = view.number("time_step").value_or(0);
  record.unit = view.word("unit").value_or("");
  record.values = view.numbers("values");
  if (record.values.size() == 1) view.find("values")->error("has 1 entry, must have at least 2");
  if (record.values.size() < 2 || !(record.time_step > 0) || record.unit.empty()) {
    if (view.exactly_one("scale") == "pga") (void)read_acceleration(view, "pga", units);
    return std::nullopt;
  }
  echo = echo_of(record, view.find("values")->path(), record.unit);
  if (identified) {
    const std::string_view bytes(reinterpret_cast<const char*>(record.values.data()),
                                 record.values.size() * sizeof(double));
    echo.size = bytes.size();
    echo.sha256 = sha256(bytes);
  }
  SampledMotion motion{record.time_step, std::move(record.values)};
  apply_scale(view, acceleration_factor(record.unit, units), units, motion, echo);
  return motion;
}

/// @param peak_by_case its largest value as a number [unit], where the case says the unit and no file does
std::optional<SampledMotion> read_record_motion(const TableView& view, const Units& units,
                                                const std::filesystem::path& folder, RecordEcho& echo,
                                                std::optional<double>& peak_by_case, Diagnostics& diagnostics,
                                                CaseMemo* memo) {
  const auto source = view.exactly_one("record");
  const bool is_identified = memo == nullptr || memo->has_identities();  // else many runs, whose study keeps the hashes
  if (source == "values") {
    auto motion = read_values(view, units, echo, is_identified);
    if (motion && !view.has("pga")) peak_by_case = echo.pga_read;
    return motion;
  }
  const auto file = source ? view.find("file") : std::nullopt;
  const auto name = file ? file->as_text() : std::nullopt;
  RecordOptions options;
  const auto format = view.word("format");
  options.format = format.value_or("auto");
  const bool format_usable = format || !view.has("format");
  options.time_step = view.number("time_step");
  const bool step_usable = options.time_step || !view.has("time_step");
  bool places_usable = true;
  options.column = read_place(view, "column", places_usable);
  options.channel = read_place(view, "channel", places_usable);
  options.skip_lines = read_place(view, "skip_lines", places_usable).value_or(0);
  if (const auto component = view.find("component")) {
    options.component = component->as_line();
    places_usable = places_usable && options.component;
  }
  options.unit = view.word("unit").value_or("");

  std::optional<StrongMotionRecord> record;
  if (name && format_usable && step_usable && places_usable) {
    if (const auto path = input_path(*file, *name, folder, record_input)) {
      record = memo != nullptr ? memo->record(*path, options, diagnostics) : read_record(*path, options, diagnostics);
    }
  }
  if (!record) {  // what can be said without the file
    if (view.exactly_one("scale") == "pga") (void)read_acceleration(view, "pga", units);
    return std::nullopt;
  }
  for (const RecordContradiction& one : contradictions(*record, options)) {
    view.find(one.key)->error_value("but the file says " + one.said);
  }
  const auto unit = settle_unit(view, *record, *name, options.unit);
  echo = echo_of(*record, *name, unit.value_or(""));
  echo.path = (folder / *name).string();
  if (record->unit.empty() && !view.has("pga")) peak_by_case = echo.pga_read;
  if (is_identified) {
    FileIdentity identity = memo != nullptr ? memo->identity(echo.path) : identify(echo.path);
    echo.size = identity.size;
    echo.sha256 = std::move(identity.sha256);
  }
  SampledMotion motion{record->time_step, std::move(record->values)};
  apply_scale(view, unit ? acceleration_factor(*unit, units) : 1.0, units, motion, echo);
  return motion;
}

/// @param without_unit an acceleration that is a plain number [length/s²]
HarmonicMotion read_harmonic(const TableView& view, const Units& units, std::optional<double>& without_unit) {
  HarmonicMotion motion;
  motion.period = view.number("period").value_or(1);
  const auto key = view.exactly_one("amplitude");
  if (key) {
    const bool of_displacement = *key == "displacement_amplitude";
    const auto given = of_displacement ? view.number("displacement_amplitude")
                                       : read_acceleration(view, "acceleration_amplitude", units);
    if (!of_displacement && view.find(*key)->is_number()) without_unit = given;
    const double amplitude = given.value_or(1);
    const double omega = 2 * std::numbers::pi / motion.period;  // [rad/s]
    motion.displacement_amplitude = of_displacement ? amplitude : amplitude / (omega * omega);
  }
  if (view.word("phase") == "cosine") motion.phase = HarmonicMotion::Phase::cosine;
  if (view.word("polarity") == "reversed") motion.displacement_amplitude *= -1;
  return motion;
}

/// Delay of each building behind the first [s]: the distance of their centres over the wave velocity [length/s].
/// Centres are half a width from the faces; a gap counts with its smallest width.
std::vector<double> wave_delays(const TableView& view, const std::vector<ReadBuilding>& buildings,
                                const std::vector<GapSpec>& gaps) {
  const auto velocity = view.number("wave_velocity");
  std::vector<double> delays(buildings.size(), 0.0);
  bool known = velocity.has_value() && gaps.size() + 1 == buildings.size();
  for (const ReadBuilding& building : buildings) {
    if (building.spec.width) continue;
    known = false;
    // A frame without a width has wrong bay_widths, and a building without floors is wrong as a whole: said already.
    if (!building.is_frame && !building.elevations.empty()) {
      view.find("wave_velocity")->error(fmt::format("needs {}.width, which is missing", building.path));
    }
  }
  for (std::size_t b = 1; known && b < buildings.size(); ++b) {
    const std::vector<double>& widths = gaps[b - 1].widths;
    if (widths.empty()) break;
    const double distance = 0.5 * (*buildings[b - 1].spec.width + *buildings[b].spec.width) +
                            *std::min_element(widths.begin(), widths.end());
    delays[b] = delays[b - 1] + distance / *velocity;
  }
  return delays;
}

/// τ_b = (s · C_b − min)/v [s] of a wave that goes along s: C_b is the middle of the footprint.
std::vector<double> wave_delays_in_plan(const TableView& view, const std::vector<ReadBuilding>& buildings) {
  const double velocity = view.number("wave_velocity").value_or(1);
  const double angle = view.number("wave_angle").value_or(0) * std::numbers::pi / 180;
  const PlanPoint along(std::cos(angle), std::sin(angle));
  std::vector<double> delays;
  double first = std::numeric_limits<double>::infinity();
  for (const ReadBuilding& building : buildings) {
    const Footprint& footprint = building.spec.footprint();
    delays.push_back(along.dot(footprint.corner + footprint.middle()));
    first = std::min(first, delays.back());
  }
  for (double& delay : delays) delay = (delay - first) / velocity;
  return delays;
}

std::vector<double> read_delays(const TableView& view, const std::vector<ReadBuilding>& buildings, bool in_plan,
                                const std::vector<GapSpec>& gaps) {
  const auto key = view.exactly_one("delay");
  if (key == "wave_velocity") {
    return in_plan ? wave_delays_in_plan(view, buildings) : wave_delays(view, buildings, gaps);
  }
  if (in_plan) view.refuse({"wave_angle"}, "goes with wave_velocity, which is not given");
  if (key == "delays") {
    auto delays = view.numbers("delays", buildings.size());
    if (!delays.empty()) return delays;
  }
  return std::vector<double>(buildings.size(), 0.0);
}

/// [x, y, rotation] of each floor one after the other; empty (and an error) unless all are right.
std::vector<double> read_triples(const TomlView& given, Range range, std::size_t floors) {
  std::vector<double> values;
  if (floors == 0 || !given.is_list_of("[x, y, rotation]", {floors, "one per floor"})) return values;
  for (const TomlView& item : given.items()) {
    const std::vector<double> triple = item.as_numbers(range, {3, "x, y and rotation"});
    values.insert(values.end(), triple.begin(), triple.end());
  }
  return values.size() == 3 * floors ? values : std::vector<double>{};
}

/// One list per building, zeros where the case names none; empty when the table is missing.
std::vector<std::vector<double>> read_initial_table(const TableView& initial, const std::string& key,
                                                    const std::vector<ReadBuilding>& buildings, bool in_plan) {
  const auto table = initial.find(key);
  if (!table) return {};
  const Key& known = initial.key(key);
  std::vector<std::string> names;
  std::vector<std::vector<double>> lists;
  for (const ReadBuilding& building : buildings) {
    names.push_back(building.spec.name);
    lists.emplace_back((in_plan ? 3 : 1) * building.elevations.size(), 0.0);
  }
  const std::string each = in_plan ? "list of one [x, y, rotation] per floor" : "list, one value per floor";
  const bool is_table = read_by_building(*table, each, names, [&](std::size_t b, const TomlView& given) {
    const std::size_t floors = buildings[b].elevations.size();
    if (in_plan && buildings[b].spec.is_rigid()) {
      given.error("is of a wall, which moves with the ground");
      return;
    }
    const std::vector<double> values = in_plan ? read_triples(given, known.range, floors)
                                               : given.as_numbers(known.range, {floors, std::string(known.each)});
    if (!values.empty()) lists[b] = values;
  });
  return is_table ? lists : std::vector<std::vector<double>>{};
}

}  // namespace

void read_motion(const TableView& view, const Units& units, const std::filesystem::path& folder,
                 Diagnostics& diagnostics, ExcitationSpec& spec, CaseMemo* memo) {
  const auto kind = view.word("kind");
  if (kind == "record") {
    RecordEcho echo;
    if (auto motion = read_record_motion(view, units, folder, echo, spec.amplitude_without_unit, diagnostics, memo)) {
      spec.motion = std::move(*motion);
      spec.record = std::move(echo);
    }
  } else if (kind == "harmonic") {
    spec.motion = read_harmonic(view, units, spec.amplitude_without_unit);
  }
}

void read_excitation(const TomlView& root, const std::vector<ReadBuilding>& buildings, const CaseFiles& files,
                     bool in_plan, Case& c) {
  ExcitationSpec& spec = c.excitation;
  const bool of_displacements =
      std::any_of(buildings.begin(), buildings.end(), [](const ReadBuilding& one) { return one.has_displacements(); });
  if (of_displacements && !root.has("excitation")) {
    root.error_missing("excitation", "kind = \"displacements\" where nothing is to be computed");
    return;
  }
  const auto given = root.get("excitation");
  const auto view = given ? TableView::of(*given, excitation_keys()) : std::nullopt;
  if (!view) return;
  const std::string kind = view->has("kind") ? view->find("kind")->value().text : "";
  if (!in_plan) view->refuse({"y", "angle", "wave_angle"}, "is of buildings in plan: give them [building.plan]");
  if (kind == "spectrum") {
    view->refuse({"y", "angle", "wave_angle"}, "is for motions: a spectrum acts along x and along y alike");
    spec.spectrum = read_spectrum(*view, c.units, buildings.size(), files.folder, files.diagnostics);
    spec.delays.assign(buildings.size(), 0.0);
    return;
  }
  if (kind == "displacements" && !in_plan) {
    SpectrumSpec& none = spec.spectrum.emplace();
    none.shape = kind;
    none.position = view->find("kind")->position();
    none.of_displacements = true;
    spec.delays.assign(buildings.size(), 0.0);
    for (const ReadBuilding& building : buildings) {
      if (building.has_displacements() || std::holds_alternative<RigidSpec>(building.spec.structure)) continue;
      view->find("kind")->error(
          fmt::format("is for buildings known by their displacements: {} has none; kind = "
                      "\"spectrum\" computes those of others",
                      building.path));
    }
    return;
  }
  for (const ReadBuilding& building : buildings) {
    if (!building.has_displacements()) continue;
    given->error(
        fmt::format("cannot shake {}, which is known by its displacements alone: give kind = "
                    "\"displacements\", or \"spectrum\" where others are to be computed",
                    building.path));
    break;
  }
  const std::optional<TableView> along_y = in_plan && view->has("y") ? view->table("y") : std::nullopt;
  const bool of_pairs = along_y && along_y->has("kind") && along_y->find("kind")->value().text == "suite";
  if (along_y && of_pairs != (kind == "suite")) {
    along_y->find("kind")->error_value(kind == "suite" ? "must be \"suite\", as along x"
                                                       : "is for a suite of records along x too");
  }
  if (kind == "suite") {
    spec.suite = read_suite(*view, of_pairs ? along_y : std::nullopt, c.units, files.folder, files.diagnostics);
  } else {
    read_motion(*view, c.units, files.folder, files.diagnostics, spec, files.memo);
  }
  spec.delays = read_delays(*view, buildings, in_plan, c.gaps);
  if (view->word("kinematics") == "absolute") spec.kinematics = Kinematics::absolute;
  if (!in_plan) return;
  c.angle = view->number("angle").value_or(0);
  if (along_y && !of_pairs) {
    read_motion(*along_y, c.units, files.folder, files.diagnostics, c.excitation_y, files.memo);
  }
}

InitialSpec read_initial(const TomlView& root, const std::vector<ReadBuilding>& buildings, bool in_plan) {
  InitialSpec initial;
  const auto view = TableView(root, case_keys()).table("initial");
  if (!view) return initial;
  initial.displacements = read_initial_table(*view, "displacements", buildings, in_plan);
  initial.velocities = read_initial_table(*view, "velocities", buildings, in_plan);
  return initial;
}

}  // namespace bentur
