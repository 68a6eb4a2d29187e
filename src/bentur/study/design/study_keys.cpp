#include "bentur/study/design/study_keys.h"

#include "bentur/core/units.h"
#include "bentur/io/schema/case_keys.h"

namespace bentur {
namespace {

constexpr std::int64_t most_samples_of_a_study = 1000000000;
constexpr std::int64_t most_numbers = 10000000;
constexpr std::int64_t most_evaluations = 100000;

/// What [excitation] says of a file, of one among several.
std::vector<Key> keys_of_files() {
  std::vector<Key> keys;
  for (const std::string_view name : {"unit", "format", "time_step", "column", "channel", "component", "skip_lines"}) {
    Key key = excitation_keys().at(name);
    key.conditions.clear();
    keys.push_back(key.optional("the case's"));
  }
  return keys;
}

Key number_of(std::string_view name, Range range, Label label, std::string_view doc = {}) {
  return Key::number(name, dimension::none, range, label, doc);
}

/// Both ends of a range, in the order from, to.
std::vector<Key> keys_of_ends(Range range, std::string_view doc) {
  return {number_of("from", range, {"From", "Dari"}, doc),
          number_of("to", range, {"To", "Sampai"}, "more than `from`").optional().goes_with("from")};
}

Key spacing_key() {
  return Key::choice("spacing", {"linear", "log"}, {"Spacing", "Jarak"}, "of the numbers").optional().goes_with("from");
}

Key count_of_range() {
  return Key::whole("count", 2, most_numbers, {"Count", "Banyaknya"},
                    "numbers, both ends among them, rounded to 15 digits")
      .optional()
      .goes_with("from");
}

Key low_key(Range range) { return number_of("low", range, {"Low", "Batas bawah"}, "nothing is below it"); }
Key high_key(Range range) { return number_of("high", range, {"High", "Batas atas"}, "nothing is above it"); }

const KeyTable& uniform_keys() {
  static const KeyTable table = {
      "vary.distribution.uniform", "alike between two ends", {low_key(Range::finite), high_key(Range::finite)}};
  return table;
}

const KeyTable& log_uniform_keys() {
  static const KeyTable table = {"vary.distribution.log_uniform",
                                 "the logarithm alike between two ends",
                                 {low_key(Range::positive), high_key(Range::finite)}};
  return table;
}

const KeyTable& normal_keys() {
  static const KeyTable table = {
      "vary.distribution.normal",
      "a normal distribution",
      {number_of("mean", Range::finite, {"Mean", "Rata-rata"}),
       number_of("standard_deviation", Range::positive, {"Standard deviation", "Simpangan baku"}, "or")
           .one_of("spread"),
       number_of("cov", Range::positive, {"Coefficient of variation", "Koefisien variasi"},
                 "standard deviation over mean")
           .one_of("spread"),
       low_key(Range::finite).optional("not cut off"), high_key(Range::finite).optional("not cut off")}};
  return table;
}

const KeyTable& lognormal_keys() {
  static const KeyTable table = {
      "vary.distribution.lognormal",
      "a lognormal distribution",
      {number_of("median", Range::positive, {"Median", "Median"}),
       number_of("cov", Range::positive, {"Coefficient of variation", "Koefisien variasi"},
                 "standard deviation over mean; σ² = ln(1 + cov²)"),
       low_key(Range::not_negative).optional("not cut off"), high_key(Range::positive).optional("not cut off")}};
  return table;
}

}  // namespace

const KeyTable& study_keys() {
  static const KeyTable table = {
      "",
      "a study: one case many times with varied values",
      {Key::of("case", Key::Kind::file, {"Case", "Kasus"}, "relative to the study"),
       Key::sub_table("vary", vary_keys(), {"What varies", "Yang divariasikan"}, "one for each thing that varies")
           .list()
           .optional("needed but for `[ida]`"),
       Key::sub_table("sampling", sampling_keys(), {"Sampling", "Penyampelan"}, "samples in place of a grid")
           .optional("the full grid"),
       Key::sub_table("ida", ida_keys(), {"Incremental dynamic analysis", "Analisis dinamik inkremental"},
                      "every record at every intensity")
           .optional(),
       Key::sub_table("remedy", remedy_keys(), {"Remedy", "Tindakan"}, "what is sought within the ranges").optional()}};
  return table;
}

const KeyTable& vary_keys() {
  static const KeyTable table = [] {
    KeyTable made = {"vary",
                     "one thing that varies",
                     {Key::of("parameter", Key::Kind::text, {"Parameter", "Parameter"},
                              "any key of the case: `gap[0].width`, `building[\"Model 2\"].frame.beams[0].mass`. "
                              "Entries of a list count from 0, or go by their `name`. An optional key need not stand "
                              "in the case. Whole tables, such as `excitation`, vary too"),
                      Key::of("values", Key::Kind::any, {"Values", "Nilai"},
                              "of numbers, texts, true/false, or of tables and lists with `labels`")
                          .list()
                          .one_of("form")}};
    const auto add = [&](std::vector<Key> more) { made.keys.insert(made.keys.end(), more.begin(), more.end()); };
    for (std::vector<Key> both : {keys_of_ends(Range::finite,
                                               "the first of `count` numbers; with `[sampling]` the low end of a "
                                               "uniform distribution, with `[remedy]` of what may be chosen"),
                                  keys_of_ends(Range::positive, "the same of `spacing = \"log\"`")}) {
      for (Key& key : both) key.when("spacing", {key.range == Range::finite ? "linear" : "log"});
      both.front().one_of("form");
      add(both);
    }
    add({count_of_range(), spacing_key(),
         Key::of("files", Key::Kind::file, {"Files", "Berkas"},
                 "a pattern such as `\"../records/*.AT2\"` (files sorted by name), a name, or a list of both, relative "
                 "to the study; in a list also tables, `{ file = \"a/*.txt\", unit = \"m/s2\", column = 2 }`")
             .for_each({})
             .or_table(file_entry_keys())
             .one_of("form"),
         Key::of("distribution", Key::Kind::table, {"Distribution", "Distribusi"}, "with `[sampling]`: see there")
             .or_table(distribution_keys())
             .one_of("form"),
         Key::of("factor", Key::Kind::any, {"Factor", "Faktor"},
                 "a list: each number multiplies the case's number or whole list; or `factor = true`: the numbers of "
                 "another form are factors")
             .optional(),
         Key::of("labels", Key::Kind::line, {"Labels", "Label"}, "what the results call values that are no numbers")
             .or_empty()
             .list("one per value")
             .optional()
             .goes_with("values")});
    for (Key& key : keys_of_files()) add({key.for_each("one per file").goes_with("files")});
    add({Key::number("normalisation", dimension::none, Range::positive, {"Normalisation", "Normalisasi"},
                     "with `files` of `excitation.file`: [below](#normalisation)")
             .list("one per file")
             .or_one_of({"pgv", "pgv-pairs"})
             .or_table(factor_file_keys())
             .optional("none")
             .goes_with("files"),
         Key::of("together", Key::Kind::text, {"Together", "Bersama"},
                 "a name: all `vary` of it move in step along one dimension of that name, whose coordinate holds their "
                 "first labels, or numbers from 0. Rows may be alike")
             .optional(),
         Key::of("name", Key::Kind::text, {"Name", "Nama"}, "of the coordinate in the results")
             .optional("the last key of the parameter")});
    return made;
  }();
  return table;
}

const KeyTable& file_entry_keys() {
  static const KeyTable table = [] {
    KeyTable made = {
        "vary.files", "a file with keys of its own", {Key::of("file", Key::Kind::file, {"File", "Berkas"})}};
    const std::vector<Key> more = keys_of_files();
    made.keys.insert(made.keys.end(), more.begin(), more.end());
    return made;
  }();
  return table;
}

const KeyTable& factor_file_keys() {
  static const KeyTable table = {"vary.normalisation",
                                 "factors of files from a table",
                                 {Key::of("file", Key::Kind::file, {"File", "Berkas"}, "relative to the study")}};
  return table;
}

const KeyTable& distribution_keys() {
  static const KeyTable table = {
      "vary.distribution",
      "what samples are drawn from",
      {Key::sub_table("uniform", uniform_keys(), {"Uniform", "Seragam"}, "alike between `low` and `high`")
           .one_of("kind"),
       Key::sub_table("log_uniform", log_uniform_keys(), {"Uniform logarithm", "Seragam logaritmik"},
                      "the logarithm alike between them")
           .one_of("kind"),
       Key::sub_table(
           "normal", normal_keys(), {"Normal", "Normal"},
           "`mean`, and `standard_deviation` or `cov` (standard deviation over mean); optional `low`, `high`")
           .one_of("kind"),
       Key::sub_table(
           "lognormal", lognormal_keys(), {"Lognormal", "Lognormal"},
           "`median`, `cov`, the standard deviation over the mean; σ² = ln(1 + cov²); optional `low`, `high`")
           .one_of("kind")}};
  return table;
}

const KeyTable& sampling_keys() {
  static const KeyTable table = {
      "sampling",
      "samples in place of a grid",
      {Key::choice("method", {"latin-hypercube", "sobol", "random"}, {"Method", "Metode"}, "see below"),
       Key::whole("count", 1, most_samples_of_a_study, {"Samples", "Sampel"}, "how many"),
       Key::whole("seed", 0, most_samples_of_a_study, {"Seed", "Benih"}, "it decides each sample").by_default(1)}};
  return table;
}

const KeyTable& remedy_keys() {
  static const KeyTable table = {
      "remedy",
      "what is sought within the ranges",
      {Key::of("objective", Key::Kind::text, {"Objective", "Sasaran"},
               "a quantity, named as in an event, such as `peak_force`: its largest value is to become small"),
       Key::choice("of_records", {"largest", "mean"}, {"Of the records", "Dari rekaman"},
                   "of all records and whatever else has a list of values, what counts")
           .optional(),
       number_of("limit", Range::not_negative, {"Limit", "Batas"},
                 "of the objective, in its unit: the smallest remedy that keeps it is sought too")
           .optional("none"),
       Key::whole("evaluations", 10, most_evaluations, {"Evaluations", "Evaluasi"},
                  "choices that are tried at most, each with all records")
           .by_default(200)}};
  return table;
}

const KeyTable& ida_keys() {
  static const KeyTable table = [] {
    std::vector<Key> both = keys_of_ends(Range::positive, "the lowest of `count` levels");
    both.front().one_of("levels");
    KeyTable made = {
        "ida",
        "incremental dynamic analysis",
        {Key::choice("intensity", {"pga", "sa"}, {"Intensity", "Intensitas"},
                     "peak ground acceleration, or pseudo-acceleration of a linear oscillator"),
         Key::number("period", dimension::time, Range::positive, {"Period", "Periode"}, "of that oscillator")
             .when("intensity", {"sa"}),
         Key::number("damping", dimension::none, Range::ratio, {"Damping", "Redaman"}, "of that oscillator")
             .by_default(0.05)
             .when("intensity", {"sa"}),
         // In the order of IntensityOf.
         Key::choice("component", {"geometric-mean", "larger", "x", "y"}, {"Component", "Komponen"},
                     "of buildings in plan with `[excitation.y]`: which intensity of both components counts; both are "
                     "multiplied by one factor")
             .optional("\"geometric-mean\""),
         Key::choice("unit", {acceleration_units().begin(), acceleration_units().end()}, {"Unit", "Satuan"},
                     "of the levels; needed where the highest would be usual in g")
             .optional("the case's length/s²"),
         number_of("levels", Range::positive, {"Levels", "Tingkat"},
                   "ascending; or `\"unscaled\"`: a [cloud](#a-cloud-of-unscaled-records)")
             .list()
             .or_one_of({"unscaled"})
             .one_of("levels"),
         both[0], both[1], count_of_range(), spacing_key(),
         Key::choice("polarity", {"as-recorded", "reversed", "both"}, {"Polarity", "Polaritas"},
                     "every record as it is, reversed, or both")
             .optional("as the case says")}};
    return made;
  }();
  return table;
}

}  // namespace bentur
