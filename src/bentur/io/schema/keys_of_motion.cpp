#include "bentur/core/units.h"
#include "bentur/io/records/record_files.h"
#include "bentur/io/schema/case_keys.h"

namespace bentur {
namespace {

using Words = std::vector<std::string_view>;

constexpr std::int64_t last_place = 1000000;  // of a file

Words views(const std::vector<std::string>& words) { return {words.begin(), words.end()}; }

/// The same key of some kinds of excitation.
std::vector<Key> of_kind(const Words& kinds, std::vector<Key> keys) {
  for (Key& key : keys) key.when("kind", kinds);
  return keys;
}

/// Keys of spectra of some shapes.
std::vector<Key> of_shape(const Words& shapes, std::vector<Key> keys) {
  for (Key& key : keys) key.when("shape", shapes);
  return keys;
}

Key unit_of_file(std::string_view doc) {
  return Key::choice("unit", views(acceleration_units()), {"Unit of the file", "Satuan berkas"}, doc);
}

/// A file of a record, and how it is read.
std::vector<Key> file_keys() {
  return {
      Key::of("file", Key::Kind::file, {"Record", "Rekaman"}, "relative to the case file"),
      Key::choice("format", views(record_formats()), {"Format", "Format"}, "of the file").optional().goes_with("file"),
      Key::number("time_step", dimension::time, Range::positive, {"Time step", "Langkah waktu"},
                  "needed where the file does not say it")
          .optional("the file's"),
      unit_of_file("needed unless the file states it; `\"g\"` is the case's gravity").optional("the file's"),
      Key::whole("column", 1, last_place, {"Column", "Kolom"},
                 "the accelerations' column; needed where a file of columns has more than two")
          .by_default(2)
          .goes_with("file"),
      Key::whole("channel", 1, last_place, {"Channel", "Kanal"},
                 "which block of accelerations; needed where a file has several, or `component`")
          .by_default(1)
          .goes_with("file"),
      Key::of("component", Key::Kind::line, {"Component", "Komponen"},
              "the channel or column by the name that the file has for it, or another name of the same direction: "
              "`\"N-S\"`, `\"N80W\"`, `\"Up\"`")
          .optional("the only one")
          .goes_with("file"),
      Key::whole("skip_lines", 0, last_place, {"Lines to skip", "Baris dilewati"},
                 "how many lines at the beginning are skipped")
          .optional("0; headings are found")
          .goes_with("file")};
}

/// Which way a record or a harmonic motion acts.
Key polarity_key() {
  return Key::choice("polarity", {"as-recorded", "reversed"}, {"Polarity", "Polaritas"},
                     "reversed: every acceleration times −1, as if the pair of buildings were mirrored")
      .called({{"as recorded", "seperti direkam"},
               {"reversed: every acceleration times −1", "dibalik: setiap percepatan dikalikan −1"}})
      .optional();
}

std::vector<Key> record_keys() {
  std::vector<Key> keys = file_keys();
  keys.front().one_of("record");
  for (Key key : {Key::number("values", dimension::none, Range::finite, {"Accelerations", "Percepatan"},
                              "in place of `file` the accelerations themselves, in `unit`, every `time_step`")
                      .list()
                      .one_of("record")
                      .counted_in("unit"),
                  polarity_key(),
                  Key::quantity("pga", dimension::acceleration, {"Peak ground acceleration", "Percepatan tanah puncak"},
                                "scale to this peak")
                      .one_of("scale", Need::optional),
                  Key::number("scale", dimension::none, Range::not_zero, {"Scale", "Skala"},
                              "multiply by this; not together with `pga`")
                      .one_of("scale", Need::optional)
                      .by_default(1)}) {
    keys.push_back(std::move(key));
  }
  return of_kind({"record"}, std::move(keys));
}

std::vector<Key> harmonic_keys() {
  return of_kind({"harmonic"},
                 {Key::number("period", dimension::time, Range::positive, {"Period", "Periode"}),
                  Key::number("displacement_amplitude", dimension::length, Range::positive,
                              {"Displacement amplitude", "Amplitudo perpindahan"}, "A; or")
                      .one_of("amplitude"),
                  Key::quantity("acceleration_amplitude", dimension::acceleration,
                                {"Acceleration amplitude", "Amplitudo percepatan"}, "Aω²; exactly one of the two")
                      .one_of("amplitude"),
                  Key::choice("phase", {"sine", "cosine"}, {"Phase", "Fase"}, "of the displacement")
                      .called({{"displacement A sin ωt", "perpindahan A sin ωt"},
                               {"displacement A cos ωt", "perpindahan A cos ωt"}})
                      .optional(),
                  polarity_key()});
}

/// What gives a spectrum its ordinates, by its shape.
std::vector<Key> shape_keys() {
  std::vector<Key> keys;
  const auto add = [&](std::vector<Key> more) { keys.insert(keys.end(), more.begin(), more.end()); };
  add(of_shape(
      {"asce-7-22", "sni-1726-2019"},
      {Key::quantity("short_period", dimension::none, {"S_DS", "S_DS"}, "S_DS").counted_in("g"),
       Key::quantity("one_second", dimension::none, {"S_D1", "S_D1"}, "S_D1").counted_in("g"),
       Key::number("long_period", dimension::time, Range::positive, {"T_L", "T_L"}, "T_L, beyond S_D1/S_DS")}));
  add(of_shape({"en-1998-1"},
               {Key::quantity("ground_acceleration", dimension::none, {"Ground acceleration", "Percepatan tanah"},
                              "a_g, the importance factor in it")
                    .counted_in("g"),
                Key::whole("spectrum_type", 1, 2, {"Type of spectrum", "Tipe spektrum"}),
                Key::choice("ground_type", {"A", "B", "C", "D", "E"}, {"Type of ground", "Tipe tanah"},
                            "with `spectrum_type` it gives S, T_B, T_C, T_D")}));
  add(of_shape({"table"},
               {Key::number("periods", dimension::time, Range::not_negative, {"Periods", "Periode"}, "ascending; or")
                    .list()
                    .one_of("table"),
                Key::number("accelerations", dimension::none, Range::not_negative, {"Accelerations", "Percepatan"},
                            "with `periods`, in `unit`")
                    .list("one per period")
                    .optional()
                    .goes_with("periods")
                    .counted_in("unit"),
                Key::of("file", Key::Kind::file, {"File", "Berkas"},
                        "a table beside the case, periods in its first column; exactly one of the two")
                    .one_of("table"),
                unit_of_file("of the table's accelerations; `\"g\"` is the case's gravity"),
                Key::whole("column", 2, last_place, {"Column", "Kolom"},
                           "the accelerations' column of `file`; needed where it has more than two")
                    .by_default(2)
                    .goes_with("file")}));
  return keys;
}

Key shape_key() {
  return Key::choice("shape", {"asce-7-22", "sni-1726-2019", "en-1998-1", "table"}, {"Shape", "Bentuk"},
                     "of the spectrum");
}

std::vector<Key> spectrum_keys() {
  std::vector<Key> keys = of_kind(
      {"spectrum"},
      {shape_key(),
       Key::number("damping_ratio", dimension::none, Range::ratio, {"Damping ratio", "Rasio redaman"},
                   "that the ordinates of a `\"table\"` are for; spectra of codes are for 0.05")
           .by_default(0.05),
       Key::choice("damping_correction", {"en-1998-1", "none"}, {"Correction for damping", "Koreksi redaman"},
                   "`\"en-1998-1\"`: ordinates for other ratios by η = √(0.10/(0.05 + ζ)) ≥ 0.55; `\"none\"`: the same "
                   "for all")
           .optional(),
       Key::choice("modal_combination", {"cqc", "srss"}, {"Combination of modes", "Kombinasi ragam"},
                   "whose peaks the rules combine; both are printed")
           .optional(),
       Key::number("reduction", dimension::none, Range::positive,
                   {"What codes amplify is divided by", "Yang diperbesar peraturan dibagi"},
                   "such as R/I_e: the rules of codes take peaks divided by it")
           .for_each("one per building")
           .by_default(1)});
  std::vector<Key> shapes = shape_keys();
  for (Key& key : shapes) key.conditions.insert(key.conditions.begin(), Condition{"kind", {"spectrum"}});
  keys.insert(keys.end(), shapes.begin(), shapes.end());
  return keys;
}

Key suite_files_key(const char* what) {
  return Key::of("files", Key::Kind::file, {"Records", "Rekaman"}, what).list().or_table(suite_file_keys());
}

std::vector<Key> suite_keys() {
  return of_kind(
      {"suite"},
      {suite_files_key("patterns such as `\"records/*.AT2\"` (files sorted by name) and names, relative to the case "
                       "file; or tables with `file`, keys of their own and `event`, the earthquake"),
       Key::sub_table("target", target_keys(), {"Target spectrum", "Spektrum target"},
                      "what the records are chosen and scaled for, at 5 % damping: a design spectrum by its `shape` "
                      "and the keys of that"),
       Key::choice("scale", {"en-1998-1", "asce-7-16", "period"}, {"Scaling", "Penskalaan"},
                   "a code's ([how](suites.md#how-records-are-chosen-and-scaled)); `\"period\"`: S_a is the target's "
                   "at `period`; or factors as given")
           .called({{"EN 1998-1:2004, 3.2.3.1.2", "EN 1998-1:2004, 3.2.3.1.2"},
                    {"ASCE 7-16, 16.2.3.2", "ASCE 7-16, 16.2.3.2"},
                    {"to one period", "pada satu periode"}})
           .or_table(suite_factor_keys()),
       Key::number("period", dimension::time, Range::positive, {"Period", "Periode"}, "of `scale = \"period\"`")
           .optional("needed for that"),
       Key::whole("select", 1, last_place, {"How many", "Banyaknya"},
                  "how many, those whose shape fits the target best")
           .optional("all"),
       Key::number("factor_bounds", dimension::none, Range::positive, {"Bounds of factors", "Batas faktor"},
                   "what a record may be multiplied by")
           .list("least and most", 2)
           .optional("none"),
       Key::whole("per_event", 1, last_place, {"Records of one event", "Rekaman per gempa"},
                  "at most so many of one earthquake")
           .optional("any number"),
       Key::number("largest_misfit", dimension::none, Range::positive, {"Largest misfit", "Selisih terbesar"},
                   "σ of ln(S_a/target) over the band; records that fit worse are not taken")
           .optional("none")});
}

/// Of buildings in plan alone.
std::vector<Key> plan_motion_keys() {
  return {Key::sub_table("y", motion_along_y_keys(), {"Motion along y", "Gerakan searah y"},
                         "of buildings in plan: the motion along y, while this table is that along x")
              .optional("no motion along y"),
          Key::number("angle", dimension::none, Range::finite, {"Angle", "Sudut"},
                      "of buildings in plan: turns the axes of both motions, counter-clockwise")
              .by_default(0)
              .counted_in("degrees"),
          Key::number("wave_angle", dimension::none, Range::finite, {"Angle of the wave", "Sudut gelombang"},
                      "of buildings in plan: where the wave goes, from x counter-clockwise")
              .by_default(0)
              .counted_in("degrees")
              .goes_with("wave_velocity")};
}

}  // namespace

const KeyTable& motion_along_y_keys() {
  static const KeyTable table = [] {
    KeyTable made = {
        "excitation.y",
        "what shakes buildings in plan along y",
        {Key::choice("kind", {"record", "harmonic", "suite", "none"}, {"Kind", "Jenis"}, "as of `[excitation]`")
             .called({{"record", "rekaman"},
                      {"harmonic", "harmonik"},
                      {"suite of records", "kumpulan rekaman"},
                      {"none: no motion along y", "tidak ada gerakan searah y"}})}};
    const std::vector<Key> files =
        of_kind({"suite"}, {suite_files_key("as of `[excitation]`: the components along y, one for each file along x "
                                            "in the same order; both are scaled by one factor")});
    for (const std::vector<Key>& keys : {record_keys(), harmonic_keys(), files}) {
      made.keys.insert(made.keys.end(), keys.begin(), keys.end());
    }
    return made;
  }();
  return table;
}

const KeyTable& suite_file_keys() {
  static const KeyTable table = [] {
    KeyTable made = {"excitation.files", "a record with keys of its own", file_keys()};
    for (Key& key : made.keys) key.with = {};
    made.keys.push_back(Key::of("event", Key::Kind::line, {"Earthquake", "Gempa"}, "which one it is of")
                            .optional("what a PEER file or one of `./dev records` says"));
    return made;
  }();
  return table;
}

const KeyTable& suite_factor_keys() {
  static const KeyTable table = {
      "excitation.scale",
      "factors of records",
      {Key::number("factors", dimension::none, Range::positive, {"Factors", "Faktor"}, "").list("one per file")}};
  return table;
}

const KeyTable& target_keys() {
  static const KeyTable table = [] {
    KeyTable made = {"excitation.target", "the spectrum that records are chosen and scaled for", {shape_key()}};
    const std::vector<Key> shapes = shape_keys();
    made.keys.insert(made.keys.end(), shapes.begin(), shapes.end());
    return made;
  }();
  return table;
}

const KeyTable& case_keys() {
  static const KeyTable table = {
      "",
      "a case: buildings in a row, the gaps between them, what shakes them, and for how long",
      {Key::of("title", Key::Kind::line, {"Title", "Judul"}).or_empty().optional("empty"),
       Key::sub_table("units", unit_keys(), {"Units", "Satuan"}, "of every number").optional(),
       Key::sub_table("building", building_keys(), {"Buildings", "Bangunan"}, "two or more, from left to right")
           .list()
           .at_least(2)
           .up_to(1000),
       Key::sub_table("plan", plan_keys(), {"Plan", "Denah"}, "of [buildings in plan](case-plan.md#buildings-in-plan)")
           .optional("they stand in a row"),
       Key::sub_table("gap", gap_keys(), {"Gaps", "Celah"}, "one between each pair of neighbours")
           .list()
           .optional("needed but for buildings in plan"),
       Key::sub_table("link", link_keys(), {"Links", "Penghubung"}, "springs, dampers and cables")
           .list()
           .optional("none"),
       Key::sub_table("excitation", excitation_keys(), {"Ground motion", "Gerakan tanah"}, "what shakes them"),
       Key::sub_table("initial", initial_keys(), {"Initial state", "Keadaan awal"}, "where it starts from")
           .optional("at rest"),
       Key::sub_table("analysis", analysis_keys(), {"Analysis", "Analisis"}, "how long, and how").optional(),
       Key::sub_table("code", code_keys(), {"Code rules", "Aturan kode"},
                      "factors for [separation rules](case-file.md#code-rules)")
           .optional("none"),
       Key::sub_table("screening", screening_keys(), {"Screening", "Penapisan"},
                      "for [rules of thumb](case-file.md#screening)")
           .optional("none"),
       Key::sub_table("project", project_keys(), {"Project", "Proyek"},
                      "for [a report to hand in](case-file.md#project)")
           .optional("none")}};
  return table;
}

const KeyTable& unit_keys() {
  static const KeyTable table = {"units",
                                 "the units of every number; time is in seconds, mass is force·s²/length",
                                 {Key::choice("length", views(length_units()), {"Length", "Panjang"}).optional(),
                                  Key::choice("force", views(force_units()), {"Force", "Gaya"}).optional(),
                                  Key::number("gravity", dimension::acceleration, Range::size, {"Gravity", "Gravitasi"},
                                              "turns g and unit weights into accelerations and masses")
                                      .optional("9.80665 m/s², converted")}};
  return table;
}

const KeyTable& excitation_keys() {
  static const KeyTable table = [] {
    KeyTable made = {
        "excitation",
        "what shakes the buildings",
        {Key::choice(
             "kind", {"record", "harmonic", "none", "spectrum", "suite", "displacements"}, {"Kind", "Jenis"},
             "`\"none\"` is free vibration, and [initial] must then move something; `\"spectrum\"` is for gaps "
             "alone; `\"suite\"`: [records for a target](suites.md); `\"displacements\"`: none, all that moves is "
             "[known by its displacements](case-buildings.md#buildingdisplacements-from-another-program)")
             .called({{"record", "rekaman"},
                      {"harmonic", "harmonik"},
                      {"none: free vibration", "tidak ada: getaran bebas"},
                      {"design spectrum", "spektrum desain"},
                      {"suite of records", "kumpulan rekaman"},
                      {"displacements as given", "perpindahan yang diberikan"}}),
         Key::number("delays", dimension::time, Range::not_negative, {"Delays", "Keterlambatan"},
                     "how much later the ground motion reaches it")
             .list("one per building")
             .one_of("delay", Need::optional),
         Key::number("wave_velocity", dimension::velocity, Range::positive, {"Wave velocity", "Kecepatan gelombang"},
                     "in place of `delays`")
             .one_of("delay", Need::optional),
         Key::choice(
             "kinematics", {"relative", "absolute"}, {"Kinematics", "Kinematika"},
             "`\"relative\"`: openings from displacements relative to the bases; `\"absolute\"`: with the ground "
             "displacement")
             .called({{"relative to the bases", "relatif terhadap dasar"},
                      {"ground displacement included", "perpindahan tanah disertakan"}})
             .optional()}};
    for (const std::vector<Key>& keys :
         {plan_motion_keys(), record_keys(), harmonic_keys(), spectrum_keys(), suite_keys()}) {
      made.keys.insert(made.keys.end(), keys.begin(), keys.end());
    }
    return made;
  }();
  return table;
}

const KeyTable& initial_keys() {
  static const KeyTable table = {
      "initial",
      "displacements and velocities at the start, by building",
      {Key::by_building("displacements", dimension::length, Range::level, {"Displacements", "Perpindahan"},
                        "bottom to top, relative to the base; in plan `[x, y, rotation]` of each floor, in radians"),
       Key::by_building("velocities", dimension::velocity, Range::finite, {"Velocities", "Kecepatan"},
                        "the same of velocities")}};
  return table;
}

const KeyTable& analysis_keys() {
  static const KeyTable table = {
      "analysis",
      "how long, and how",
      {Key::number("duration", dimension::time, Range::size, {"Duration", "Durasi"})
           .optional("the record's length, (count − 1) × step; needed for the other kinds"),
       Key::choice("solver", {"exact", "runge-kutta", "adaptive"}, {"Solver", "Penyelesai"}, "see below")
           .called({{"exact: closed-form between impacts, no time step",
                     "exact: bentuk tertutup di antara benturan, tanpa langkah waktu"},
                    {"fourth-order Runge-Kutta", "Runge-Kutta orde empat"},
                    {"adaptive embedded Runge-Kutta pair", "pasangan Runge-Kutta adaptif"}})
           .optional(),
       Key::number("step", dimension::time, Range::positive, {"Step", "Langkah"},
                   "in free flight; a third of it in contact; for `\"runge-kutta\"` only")
           .by_default(0.006)
           .when("solver", {"runge-kutta"}),
       Key::number("tolerance", dimension::none, Range::tolerance, {"Tolerance", "Toleransi"},
                   "relative, of one step; for `\"adaptive\"` only")
           .by_default(1e-9)
           .when("solver", {"adaptive"}),
       Key::number("output_step", dimension::time, Range::positive, {"Output step", "Langkah keluaran"},
                   "of the histories only; at most 10⁷ samples")
           .by_default(0.01),
       Key::of("energy_audit", Key::Kind::flag, {"Energy audit", "Audit energi"},
               "energy that is not accounted for is reported; curves stand in `histories.nc`")
           .by_default(0),
       Key::of("both_ways", Key::Kind::flag, {"Both ways", "Dua arah"},
               "the need of the ground motion reversed is reported too")
           .by_default(1),
       Key::sub_table("limits", limit_keys(), {"Limits", "Batas"},
                      "see [What a run takes](case-file.md#what-a-run-takes)")
           .optional(),
       Key::number(
           "collapse_drift", dimension::none, Range::positive, {"Drift of collapse", "Simpangan runtuh"},
           "drift ratio at which a storey under [gravity loads](case-foundations.md#gravity-loads-p-δ) has collapsed")
           .by_default(0.1)}};
  return table;
}

const KeyTable& limit_keys() {
  static const KeyTable table = {
      "analysis.limits",
      "what a run may take",
      {Key::number("steps", dimension::none, Range::step_limit, {"Steps", "Langkah"},
                   "of a run, samples and searches for peaks included")
           .by_default(2e7),
       Key::number("events", dimension::none, Range::step_limit, {"Events", "Peristiwa"},
                   "of contacts of a response: touches, partings; each takes up to 1 kB")
           .by_default(1e6),
       Key::number("seconds", dimension::time, Range::positive, {"Seconds", "Detik"},
                   "of wall time, of each response: without contact, with it, and reversed")
           .optional(),
       Key::number("memory", dimension::none, Range::memory_limit, {"Memory", "Memori"}, "of a run with its histories")
           .by_default(1000)
           .counted_in("MB")}};
  return table;
}

}  // namespace bentur
