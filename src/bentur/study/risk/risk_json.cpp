#include <cmath>
#include <nlohmann/json.hpp>

#include "bentur/study/fragility/internal/collapse_json.h"
#include "bentur/study/fragility/internal/open_json.h"
#include "bentur/study/risk/risk_report.h"

namespace bentur {
namespace {

using Json = nlohmann::ordered_json;

/// Null where it is no number that JSON has.
Json finite_json(double x) { return std::isfinite(x) ? Json(x) : Json(nullptr); }

/// @param along of each axis, whether it is there; empty: all are
Json risk_case_json(const IdaResults& results, std::size_t c, const std::vector<bool>& along = {}) {
  Json json = Json::object();
  const std::vector<std::size_t> places = results.places(c);
  for (std::size_t axis = 0; axis < results.axes.size(); ++axis) {
    if (!along.empty() && !along[axis]) continue;
    for (const ResultCoordinate& one : results.axes[axis].coordinates) {
      json[one.name] = one.texts.empty() ? Json(one.numbers[places[axis]]) : Json(one.texts[places[axis]]);
    }
  }
  return json;
}

Json rate_json(const AnnualRate& rate) {
  return {{"rate", rate.rate}, {"beyond", rate.beyond}, {"below", finite_json(rate.below)}, {"parts", rate.parts}};
}

Json risk_of_case(const RiskReport& report, const CaseRisk& risk, const RiskRequest& request) {
  const double rate = risk.told().rate;
  // Without an event the rate is a bound, which is one of all runs alone.
  const bool is_bound = risk.fragility.events == 0;
  const bool is_known = risk.is_of_some() && !(is_bound && (risk.failed() > 0 || report.results.open.runs > 0));
  const bool fitted = risk.lognormal.has_value();
  const std::optional<double> distance = risk.fragility.distance();
  Json records = Json::array();
  for (std::size_t i = 0; i < risk.of_records.size(); ++i) {
    records.push_back(
        {{"record", i < report.results.records.size() ? report.results.records[i] : ""}, {"rate", risk.of_records[i]}});
  }
  return {{"case", risk_case_json(report.results, risk.c)},
          {"rate", is_known ? Json(rate) : Json(nullptr)},
          {"probability", is_known ? Json(probability_in(request.years, rate)) : Json(nullptr)},
          {"by", risk.is_lognormal() ? "lognormal" : "observed"},
          {"bounds", risk.bounds ? Json::array({finite_json(risk.bounds->lower), finite_json(risk.bounds->upper)})
                                 : Json(nullptr)},
          {"median", fitted ? Json(risk.fragility.fit.median) : Json(nullptr)},
          {"dispersion", fitted ? Json(risk.fragility.fit.dispersion) : Json(nullptr)},
          {"collapse", risk.fragility.cloud ? collapse_json(risk.fragility) : Json(nullptr)},
          {"of_all", of_all_json(risk.fragility)},
          {"distance", distance ? Json(*distance) : Json(nullptr)},
          {"misfit", risk.fragility.is_misfit()},
          {"runs", risk.fragility.runs},
          {"failed", risk.failed()},
          {"events", risk.fragility.events},
          {"lognormal", fitted ? rate_json(*risk.lognormal) : Json(nullptr)},
          {"closed_form", risk.closed_form ? Json(*risk.closed_form) : Json(nullptr)},
          {"observed", rate_json(risk.observed)},
          {"records", records}};
}

}  // namespace

std::string risk_json(const RiskReport& report, const RiskRequest& request, std::string_view version) {
  Json cases = Json::array(), gaps = Json::array();
  for (const CaseRisk& risk : report.cases) cases.push_back(risk_of_case(report, risk, request));
  for (const TargetGap& gap : report.gaps) {
    gaps.push_back({{"case", risk_case_json(report.results, gap.c, report.gaps_vary_along)},
                    {"gap", gap.is_known() ? Json(*gap.width) : Json(nullptr)},
                    {"gap_by_what_is_known", gap.width && gap.runs > 0 ? Json(*gap.width) : Json(nullptr)},
                    {"units", report.gap_units},
                    {"rate", gap.runs > 0 ? Json(gap.rate) : Json(nullptr)},
                    {"failed", gap.failed},
                    {"open", gap.open}});
  }
  const Json json = {
      {"title", report.results.title},
      {"version", version},
      {"event", request.event},
      {"years", request.years},
      {"target", request.target ? Json(*request.target) : Json(nullptr)},
      {"intensity", {{"name", report.results.intensity}, {"measure", report.measure}, {"unit", report.hazard.unit}}},
      {"hazard", {{"intensity", report.hazard.intensity}, {"rate", report.hazard.rate}}},
      {"open_needs", open_json(report.results)},
      {"cases", cases},
      {"gaps", gaps}};
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace bentur
