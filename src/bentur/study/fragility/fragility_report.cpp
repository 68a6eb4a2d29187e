#include "bentur/study/fragility/fragility_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <numeric>

#include "bentur/io/toml/toml_view.h"
#include "bentur/study/fragility/internal/collapse_json.h"
#include "bentur/study/fragility/internal/open_json.h"

namespace bentur {

NLOHMANN_JSON_SERIALIZE_ENUM(Fragility::Kind, {{Fragility::Kind::fitted, "fitted"},
                                               {Fragility::Kind::separated, "separated"},
                                               {Fragility::Kind::no_event, "no_event"},
                                               {Fragility::Kind::all_events, "all_events"},
                                               {Fragility::Kind::one_intensity, "one_intensity"},
                                               {Fragility::Kind::falling, "falling"},
                                               {Fragility::Kind::no_data, "no_data"}})

NLOHMANN_JSON_SERIALIZE_ENUM(GapForProbability::Kind, {{GapForProbability::Kind::between, "between"},
                                                       {GapForProbability::Kind::smallest, "smallest"},
                                                       {GapForProbability::Kind::beyond, "beyond"}})

namespace {

using Json = nlohmann::ordered_json;

/// The axis and coordinate that gaps are asked for along.
struct GapCoordinate {
  std::size_t axis = 0;
  const ResultCoordinate* coordinate = nullptr;
};

std::optional<GapCoordinate> gap_coordinate(const IdaResults& results, const std::string& along, std::string& error) {
  std::vector<GapCoordinate> found;
  std::vector<std::string> names;
  for (std::size_t axis = 0; axis < results.axes.size(); ++axis) {
    for (const ResultCoordinate& coordinate : results.axes[axis].coordinates) {
      if (!coordinate.is_gap_width()) continue;
      names.push_back(coordinate.name);
      if (along.empty() || coordinate.name == along) found.push_back({axis, &coordinate});
    }
  }
  if (found.size() == 1) return found.front();
  if (names.empty()) {
    error = "has no gap width that varies: --probability needs one";
  } else if (found.empty()) {
    error = fmt::format("--along {}: {}", in_quotes(along), suggestion(along, names));
  } else {
    error = "has several gap widths: choose one with --along";
    for (const std::string& name : names) error += (name == names.front() ? " " : ", ") + name;
  }
  return std::nullopt;
}

/// Cases along one axis, from the case with its first value.
std::vector<std::size_t> cases_along(const IdaResults& results, std::size_t axis, std::size_t first) {
  std::size_t stride = 1;
  for (std::size_t later = axis + 1; later < results.axes.size(); ++later) stride *= results.axes[later].size;
  std::vector<std::size_t> cases;
  for (std::size_t i = 0; i < results.axes[axis].size; ++i) cases.push_back(first + i * stride);
  return cases;
}

/// Where the gaps of a request lie among the results.
std::optional<GapCoordinate> where_gaps_are(const IdaResults& results, const FragilityRequest& request,
                                            std::string& error) {
  const auto found = gap_coordinate(results, request.along, error);
  const std::vector<double> levels = results.table.intensities();
  if (found && levels.empty()) {
    error = "has no record with an intensity";
    return std::nullopt;
  }
  if (found && !(*request.at >= levels.front() && *request.at <= levels.back())) {
    error = fmt::format("--at {} must be from {} to {}, the {}", *request.at, levels.front(), levels.back(),
                        results.table.is_cloud() ? "intensities of the records" : "levels of the analysis");
    return std::nullopt;
  }
  return found;
}

/// What is infinite or no number is null in the text.
Json interval_json(const Interval& interval) { return Json::array({interval.lower, interval.upper}); }

/// What the axes have in a case, but for the axis left out.
Json case_json(const IdaResults& results, std::size_t c, std::optional<std::size_t> without) {
  Json json = Json::object();
  const std::vector<std::size_t> places = results.places(c);
  for (std::size_t axis = 0; axis < results.axes.size(); ++axis) {
    if (axis == without) continue;
    for (const ResultCoordinate& coordinate : results.axes[axis].coordinates) {
      json[coordinate.name] =
          coordinate.texts.empty() ? Json(coordinate.numbers[places[axis]]) : Json(coordinate.texts[places[axis]]);
    }
  }
  return json;
}

/// Of collapse alone, or of the runs that stand.
Json part_json(const Fragility& fit, const std::vector<IntensityCount>& counts) {
  const bool known = fit.kind == Fragility::Kind::fitted;
  const auto distance = fit_distance(counts, fit);
  long runs = 0, events = 0;
  for (const IntensityCount& one : counts) {
    runs += one.runs;
    events += one.events;
  }
  return {{"kind", fit.kind},
          {"median", known ? Json(fit.median) : Json(nullptr)},
          {"dispersion", known ? Json(fit.dispersion) : Json(nullptr)},
          {"distance", distance ? Json(*distance) : Json(nullptr)},
          {"misfit", is_misfit(counts, fit)},
          {"extrapolated", is_extrapolated(counts, fit)},
          {"runs", runs},
          {"events", events}};
}

/// @param confidence of the bounds
Json curve_json(const IdaResults& results, std::size_t c, const CaseFragility& fragility, double confidence) {
  const bool known = fragility.fit.kind == Fragility::Kind::fitted;
  Json counts = Json::array();
  for (const IntensityCount& count : fragility.counts) {
    const auto p = known ? fragility.probability(count.intensity) : std::nullopt;
    const auto band = p ? probability_bounds(fragility, count.intensity, confidence) : std::nullopt;
    counts.push_back({{"intensity", count.intensity},
                      {"runs", count.runs},
                      {"events", count.events},
                      {"probability", p ? Json(*p) : Json(nullptr)},
                      {"bounds", band ? interval_json(*band) : Json(nullptr)}});
  }
  const auto& bounds = fragility.bounds;
  const auto distance = fragility.distance();
  Json json = {{"case", case_json(results, c, std::nullopt)},
               {"kind", fragility.fit.kind},
               {"median", known ? Json(fragility.fit.median) : Json(nullptr)},
               {"median_bounds", known && bounds ? interval_json(bounds->median) : Json(nullptr)},
               {"dispersion", known ? Json(fragility.fit.dispersion) : Json(nullptr)},
               {"dispersion_bounds", known && bounds ? interval_json(bounds->dispersion) : Json(nullptr)},
               {"median_between", interval_json({fragility.fit.lower, fragility.fit.upper})},
               {"runs", fragility.runs},
               {"events", fragility.events},
               {"failed", fragility.failed},
               {"counts", counts},
               {"distance", distance ? Json(*distance) : Json(nullptr)},
               {"misfit", fragility.is_misfit()},
               {"extrapolated", is_extrapolated(fragility.counts, fragility.fit)}};
  if (fragility.split) {
    json["collapse"] = part_json(fragility.split->collapse, fragility.split->collapse_counts);
    json["standing"] = part_json(fragility.split->standing, fragility.split->standing_counts);
  }
  if (const auto& cloud = fragility.cloud) {
    json["cloud"] = {{"a", cloud->a},
                     {"b", cloud->b},
                     {"sigma", cloud->sigma},
                     {"determination", cloud->determination},
                     {"distance", cloud->distance},
                     {"runs", cloud->runs},
                     {"collapse", collapse_json(fragility)},
                     {"of_all", of_all_json(fragility)}};
  }
  for (const Stripe& one : fragility.stripes) {
    json["stripes"].push_back({{"intensity", one.intensity},
                               {"runs", one.runs},
                               {"collapsed", one.collapsed},
                               {"median", one.median},
                               {"dispersion", one.dispersion}});
  }
  return json;
}

Json gaps_json(const FragilityReport& report, const FragilityRequest& request) {
  Json json = Json::array();
  for (const GapAt& gap : report.gaps) {
    const auto& estimate = gap.estimate;
    json.push_back({{"case", case_json(report.results, gap.first_case, report.gap_axis)},
                    {"at", *request.at},
                    {"probability", gap.probability},
                    {"kind", estimate.gap ? Json(estimate.gap->kind) : Json(nullptr)},
                    {report.gap_name, estimate.gap ? Json(estimate.gap->width) : Json(nullptr)},
                    {"bounds", estimate.bounds ? interval_json(*estimate.bounds) : Json(nullptr)}});
  }
  return json;
}

}  // namespace

bool find_gaps(FragilityReport& report, const FragilityRequest& request, std::string& error) {
  const auto along = where_gaps_are(report.results, request, error);
  if (!along) return false;
  const ResultCoordinate& coordinate = *along->coordinate;
  report.gap_axis = along->axis;
  report.gap_name = coordinate.name;
  report.gap_units = coordinate.units;
  report.gaps.clear();
  std::vector<std::size_t> order(coordinate.numbers.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(),
            [&](std::size_t a, std::size_t b) { return coordinate.numbers[a] < coordinate.numbers[b]; });
  std::vector<double> widths;
  for (const std::size_t i : order) widths.push_back(coordinate.numbers[i]);
  for (std::size_t c = 0; c < report.results.table.cases; ++c) {
    if (report.results.places(c)[report.gap_axis] != 0) continue;
    const std::vector<std::size_t> cases = cases_along(report.results, report.gap_axis, c);
    std::vector<const CaseFragility*> fragilities;
    for (const std::size_t i : order) fragilities.push_back(&report.fragilities[cases[i]]);
    for (const double p : request.probabilities) {
      report.gaps.push_back({c, p, gap_estimate(widths, fragilities, *request.at, p, request.bootstrap.confidence)});
    }
  }
  return true;
}

std::string method_fault(const IdaResults& results, FragilityMethod method) {
  if (method != FragilityMethod::likelihood && !results.table.threshold) {
    return fmt::format("--method {} needs an event that exceeds a number above 0, as \"drift > 0.01\"",
                       name_of(method));
  }
  if (method == FragilityMethod::stripes && results.table.is_cloud()) {
    return "--method stripes needs levels that all records are scaled to, and these are not scaled";
  }
  return {};
}

std::optional<FragilityReport> fragility_report(IdaResults results, const FragilityRequest& request,
                                                std::string& error) {
  FragilityReport report;
  report.results = std::move(results);
  if (request.at && !where_gaps_are(report.results, request, error)) return std::nullopt;  // before the long part
  error = method_fault(report.results, request.method);
  if (!error.empty()) return std::nullopt;
  for (std::size_t c = 0; c < report.results.table.cases; ++c) {
    report.fragilities.push_back(fit_case(report.results.table, c, request.bootstrap, request.method));
  }
  if (request.at && !find_gaps(report, request, error)) return std::nullopt;
  return report;
}

std::string fragility_json(const FragilityReport& report, const FragilityRequest& request, std::string_view version) {
  Json curves = Json::array();
  for (std::size_t c = 0; c < report.fragilities.size(); ++c) {
    curves.push_back(curve_json(report.results, c, report.fragilities[c], request.bootstrap.confidence));
  }
  const Json json = {
      {"title", report.results.title},
      {"version", version},
      {"event", request.event},
      {"method", name_of(request.method)},
      {"event_units", report.results.quantity_units},
      {"intensity",
       {{"name", report.results.intensity},
        {"units", report.results.units},
        {"scaled", !report.results.table.is_cloud()},
        {"levels", report.results.table.is_cloud() ? Json::array() : Json(report.results.table.levels)}}},
      {"records", report.results.table.records / report.results.table.together},
      {"bootstrap",
       {{"resamples", request.bootstrap.resamples},
        {"confidence", request.bootstrap.confidence},
        {"seed", request.bootstrap.seed}}},
      {"open_needs", open_json(report.results)},
      {"curves", curves},
      {"gaps", gaps_json(report, request)}};
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace bentur
