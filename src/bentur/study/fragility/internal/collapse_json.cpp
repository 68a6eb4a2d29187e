#include "bentur/study/fragility/internal/collapse_json.h"

#include <cmath>

namespace bentur {

NLOHMANN_JSON_SERIALIZE_ENUM(CollapseFit::Kind, {{CollapseFit::Kind::none, "none"},
                                                 {CollapseFit::Kind::all, "all"},
                                                 {CollapseFit::Kind::fitted, "fitted"},
                                                 {CollapseFit::Kind::separated, "separated"},
                                                 {CollapseFit::Kind::falling, "falling"}})

namespace {

nlohmann::ordered_json bounds_json(const std::optional<Interval>& bounds) {
  if (!bounds || std::isnan(bounds->lower)) return nullptr;
  return nlohmann::ordered_json::array({bounds->lower, bounds->upper});
}

}  // namespace

nlohmann::ordered_json collapse_json(const CaseFragility& fragility) {
  const CollapseFit fit = fragility.fit.collapse.value_or(CollapseFit{.runs = fragility.runs});
  const bool is_fitted = fit.kind == CollapseFit::Kind::fitted;
  nlohmann::ordered_json json = {{"kind", fit.kind}};
  json["intercept"] = is_fitted ? nlohmann::ordered_json(fit.intercept) : nlohmann::ordered_json(nullptr);
  json["slope"] = is_fitted ? nlohmann::ordered_json(fit.slope) : nlohmann::ordered_json(nullptr);
  json["runs"] = fit.runs;
  json["collapsed"] = fit.collapsed;
  return json;
}

nlohmann::ordered_json of_all_json(const CaseFragility& fragility) {
  const auto found = fragility.of_all();
  if (!found) return nullptr;
  return {{"median", found->median},
          {"median_bounds", bounds_json(found->median_bounds)},
          {"dispersion", found->dispersion},
          {"dispersion_bounds", bounds_json(found->dispersion_bounds)}};
}

}  // namespace bentur
