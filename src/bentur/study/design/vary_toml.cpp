#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <set>

#include "bentur/io/toml/named_files.h"
#include "bentur/study/design/internal/study_parts.h"
#include "bentur/study/design/study_keys.h"

namespace bentur {
namespace {

namespace fs = std::filesystem;
using Kind = TomlValue::Kind;

bool is_name(const std::string& text) {
  const auto letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; };
  return !text.empty() && letter(text[0]) &&
         std::all_of(text.begin(), text.end(), [&](char c) { return letter(c) || (c >= '0' && c <= '9'); });
}

/// To the nearest of 15 decimal digits, so that 0.3/3 is the 0.1 that a user will ask for.
double rounded(double x) { return std::strtod(fmt::format("{:.15g}", x).c_str(), nullptr); }

/// The coordinate of values that are no numbers: the texts themselves, or `labels`.
void label_values(const TomlView& view, const TomlView& values, Vary& vary) {
  const bool numbers =
      std::all_of(vary.values.begin(), vary.values.end(), [](const TomlValue& value) { return value.is_number(); });
  if (const auto given = view.find("labels")) {
    if (!given->is_list_of("texts", {vary.values.size(), "one per value"})) return;
    for (const TomlView& label : given->items()) vary.labels.push_back(label.as_line().value_or(""));
  } else if (!numbers) {
    for (const TomlView& value : values.items()) {
      if (value.is(Kind::text)) {
        vary.labels.push_back(value.value().text);
      } else if (value.is(Kind::boolean)) {
        vary.labels.emplace_back(value.value().boolean ? "true" : "false");
      } else {
        value.error("cannot name itself in the results: give labels, one text per value");
        return;
      }
    }
  }
  if (view.has("together")) return;  // rows of a design, of which two may have the same of one thing
  std::set<std::pair<std::string, double>> seen;
  for (std::size_t i = 0; i < vary.values.size(); ++i) {
    const bool labelled = !vary.labels.empty();
    const bool is_new = seen.emplace(labelled ? vary.labels[i] : "", labelled ? 0 : vary.values[i].real).second;
    if (!is_new) values.item(i).error("stands twice");
  }
}

void read_values(const TomlView& view, const TomlView& values, Vary& vary) {
  if (!values.is_list_of("values")) return;
  vary.values = values.value().items;
  if (vary.factor) {
    for (const TomlView& value : values.items()) (void)value.as_number(Range::finite);
  }
  label_values(view, values, vary);
}

struct Ends {
  double from = 0, to = 0;
  bool log = false;  // spacing
};

std::optional<Ends> read_ends(const TableView& view) {
  const bool log = view.word("spacing") == "log";
  if (!view.has("to")) view.error_missing("to");
  const auto from = view.number("from");
  const auto to = view.number("to");
  if (!from || !to) return std::nullopt;
  if (!(*from < *to)) {
    view.find("to")->error_value(fmt::format("must be more than from = {}", *from));
    return std::nullopt;
  }
  return Ends{*from, *to, log};
}

void read_range(const TableView& view, const VaryContext& context, Vary& vary) {
  if (context.remedy) {
    view.refuse({"count"}, "is for a grid: with [remedy] a range is what may be chosen");
    const auto ends = read_ends(view);
    vary.ends_decide = true;
    if (!ends) return;
    vary.sought = SoughtRange{ends->from, ends->to, ends->log};
    vary.values = {toml_number(ends->from), toml_number(ends->to)};
    return;
  }
  if (!context.samples) {
    for (const double value : read_steps(view)) vary.values.push_back(toml_number(value));
    vary.ends_decide = true;
    return;
  }
  view.refuse({"count"}, "is for a grid: [sampling] says how many runs there are");
  if (const auto ends = read_ends(view)) {
    vary.distribution = Distribution{.kind = ends->log ? Distribution::Kind::log_uniform : Distribution::Kind::uniform,
                                     .low = ends->from,
                                     .high = ends->to};
  }
}

void read_distribution(const TomlView& view, const VaryContext& context, Vary& vary) {
  if (!context.samples) {
    view.error("needs a [sampling] table: a grid has no distributions");
    return;
  }
  const auto forms = TableView::of(view, distribution_keys());
  const auto kind = forms ? forms->exactly_one("kind") : std::nullopt;
  const auto given = kind ? forms->table(*kind) : std::nullopt;
  if (!given) return;
  const TableView& table = *given;
  Distribution d;
  if (*kind == "uniform" || *kind == "log_uniform") {
    d.kind = *kind == "log_uniform" ? Distribution::Kind::log_uniform : Distribution::Kind::uniform;
    const auto low = table.number("low");
    const auto high = table.number("high");
    if (!low || !high) return;
    d.low = *low;
    d.high = *high;
  } else {
    const bool normal = *kind == "normal";
    d.kind = normal ? Distribution::Kind::normal : Distribution::Kind::lognormal;
    const auto centre = table.number(normal ? "mean" : "median");
    const std::string form = normal ? table.exactly_one("spread").value_or("") : "cov";
    const double spread = form.empty() ? 0 : table.number(form).value_or(0);
    const auto low = table.number("low");
    const auto high = table.number("high");
    if (!centre || !(spread > 0)) return;
    d.centre = *centre;
    d.spread = !normal ? lognormal_spread(spread) : form == "cov" ? spread * std::abs(*centre) : spread;
    if (!(d.spread > 0)) {
      table.find("cov")->error("needs a mean other than 0");
      return;
    }
    if (low) d.low = *low;
    if (high) d.high = *high;
  }
  if (!(d.low < d.high)) {
    table.find("high")->error_value(fmt::format("must be more than low = {}", d.low));
    return;
  }
  if (const double off = d.deviations_off(); off > Distribution::farthest) {
    const bool normal = d.kind == Distribution::Kind::normal;
    table.error(
        fmt::format("lies, cut off at low and high, {:.0f} standard deviations from its {} {}, where it has no "
                    "values: check {}, low and high",
                    off, normal ? "mean" : "median", d.centre, normal ? "mean" : "median"));
    return;
  }
  vary.distribution = d;
}

/// Keys that say how a file is read.
std::vector<std::string> names_of_file_keys() {
  std::vector<std::string> names = file_entry_keys().names();
  std::erase(names, "file");
  return names;
}

/// The key that stands beside the one varied: excitation.unit beside excitation.file.
ParameterPath beside(ParameterPath path, const std::string& key) {
  path.back() = key;
  return path;
}

/// @param entries where the study names each file: a table may have keys of its own, which go before those of the vary.
void read_file_keys(const TomlView& view, const std::vector<const TomlValue*>& entries, Vary& vary) {
  for (const std::string& key : names_of_file_keys()) {
    if (vary.path.empty()) continue;
    FileKey found{beside(vary.path, key), std::vector<std::optional<TomlValue>>(entries.size())};
    if (const auto given = view.find(key)) {
      const bool list = given->is(Kind::list);
      if (list && !given->is_list_of("one value per file", {entries.size(), "one per file"})) continue;
      for (std::size_t i = 0; i < entries.size(); ++i)
        found.values[i] = list ? given->value().items[i] : given->value();
    }
    for (std::size_t i = 0; i < entries.size(); ++i) {
      if (const TomlValue* const own = entries[i]->find(key)) found.values[i] = *own;
    }
    const auto given = [](const std::optional<TomlValue>& value) { return value.has_value(); };
    if (std::any_of(found.values.begin(), found.values.end(), given)) vary.file_keys.push_back(std::move(found));
  }
}

void read_files(const TomlView& view, const TomlView& files, const VaryContext& context, Vary& vary) {
  std::vector<fs::path> paths;
  std::vector<const TomlValue*> places;  // where the study names them
  const auto add = [&](const TomlView& entry) {
    if (entry.is(Kind::table) && !TableView::of(entry, file_entry_keys())) return;
    const auto named = entry.is(Kind::table) ? entry.get("file") : entry;
    const auto text = named ? named->as_text() : std::nullopt;
    if (!text) return;
    const std::vector<fs::path> found = named_files(*named, *text, context.folder, "the study");
    paths.insert(paths.end(), found.begin(), found.end());
    places.resize(paths.size(), &entry.value());
  };
  if (files.is(Kind::list)) {
    if (!files.is_list_of("files")) return;
    for (const TomlView& file : files.items()) add(file);
  } else {
    add(files);
  }
  std::set<std::string> names;
  for (const fs::path& path : paths) names.insert(path.filename().string());
  std::set<std::string> seen;
  for (std::size_t i = 0; i < paths.size(); ++i) {
    const fs::path& path = paths[i];
    vary.values.push_back(toml_text(way_from(context.case_folder, path)));
    vary.values.back().line = places[i]->line;
    vary.values.back().column = places[i]->column;
    // Their names, or where two are alike their ways from the study.
    const std::string label = names.size() == paths.size() ? path.filename().string() : way_from(context.folder, path);
    vary.labels.push_back(label);
    if (!seen.insert(label).second) files.error(fmt::format("name {} twice", in_quotes(label)));
  }
  read_file_keys(view, places, vary);
  read_normalisation(view, context.folder, paths, vary);
}

/// The last key of a path.
std::string last_key(const ParameterPath& path) {
  std::string key;
  for (const PathStep& step : path) {
    if (const auto* text = std::get_if<std::string>(&step)) key = *text;
  }
  return key;
}

void read_name(const TomlView& view, const std::string& default_name, Vary& vary) {
  const auto given = view.find("name");
  const auto text = given ? given->as_text() : std::nullopt;
  vary.name = text.value_or(default_name);
  if (given && text && !is_name(*text)) {
    given->error_value("must be letters, digits and _, and begin with no digit");
  } else if (!given && !default_name.empty() && !is_name(default_name)) {
    view.error(fmt::format("needs a name = \"..\" for the results: {} is none", in_quotes(default_name)));
  }
}

}  // namespace

std::vector<double> read_steps(const TableView& view) {
  const auto ends = read_ends(view);
  const auto count = view.find("count");
  if (!count) {
    view.error_missing("count", "how many values from `from` to `to`");
    return {};
  }
  const auto number = view.whole("count");
  if (!number || !ends) return {};
  std::vector<double> values;
  const auto steps = static_cast<double>(*number - 1);
  for (std::int64_t i = 0; i < *number; ++i) {
    const auto k = static_cast<double>(i);
    const double value = ends->log ? ends->from * std::pow(ends->to / ends->from, k / steps)
                                   : (ends->from * (steps - k) + ends->to * k) / steps;
    values.push_back(k == 0 ? ends->from : k == steps ? ends->to : rounded(value));
  }
  return values;
}

Vary read_vary(const TomlView& entry, const VaryContext& context, std::string& together) {
  Vary vary;
  const auto read = TableView::of(entry, vary_keys());
  if (!read) return vary;
  const TableView& view = *read;
  const auto parameter = view.get("parameter");
  if (const auto text = parameter ? parameter->as_text() : std::nullopt) {
    vary.parameter = *text;
    std::string error;
    if (const auto path = parse_path(*text, error)) {
      vary.path = *path;
    } else {
      parameter->error_value(error);
    }
  }
  const auto factor = view.find("factor");
  const bool listed = factor && factor->is(Kind::list);
  vary.factor = listed || (factor && factor->as_flag().value_or(false));
  if (const auto name = view.text("together")) {
    together = *name;
    if (!is_name(*name)) view.find("together")->error_value("must be letters, digits and _, and begin with no digit");
  }
  read_name(view, last_key(vary.path), vary);

  // What it is to be: exactly one of these; `from` stands for from and to.
  std::vector<std::string> forms = view.keys().names_of("form");
  if (listed) forms.emplace_back("factor");
  const auto form = view.TomlView::exactly_one(forms);
  for (const std::string& name : view.keys().names()) {
    const std::string with(view.key(name).with);
    if (form && !with.empty() && *form != with) view.refuse({name}, "goes with " + with);
  }
  if (!form) return vary;
  if (*form == "files" && vary.factor) view.find("factor")->error("goes with numbers, not with files");
  const TomlView given = *view.find(*form);
  vary.position = given.position();
  if (*form == "values" || *form == "factor") read_values(view, given, vary);
  if (*form == "from") read_range(view, context, vary);
  if (*form == "files") read_files(view, given, context, vary);
  if (*form == "distribution") read_distribution(given, context, vary);
  return vary;
}

}  // namespace bentur
