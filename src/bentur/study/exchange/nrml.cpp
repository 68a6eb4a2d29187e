#include "bentur/study/exchange/nrml.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "bentur/core/errors.h"
#include "bentur/core/number_text.h"
#include "bentur/core/require.h"
#include "bentur/core/units.h"
#include "bentur/io/output/result_kind.h"
#include "bentur/study/fragility/ida_fragility.h"

namespace bentur {
namespace {

std::string xml_text(std::string_view text) {
  std::string escaped;
  for (const char c : text) {
    switch (c) {
      case '&':
        escaped += "&amp;";
        break;
      case '<':
        escaped += "&lt;";
        break;
      case '>':
        escaped += "&gt;";
        break;
      case '"':
        escaped += "&quot;";
        break;
      default:
        escaped += static_cast<unsigned char>(c) < 0x20 ? ' ' : c;
    }
  }
  return escaped;
}

/// "pounding", or an event in characters that a name of NRML may have: "peak_force_500".
std::string state_name(const std::string& event) {
  if (event == pounding_event) return "pounding";
  if (event == collapse_event) return "collapse";
  std::string name;
  for (const char c : event) {
    const bool plain =
        (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '.' || c == '-';
    if (plain) {
      name += c;
    } else if (!name.empty() && name.back() != '_') {
      name += '_';
    }
  }
  return name;
}

}  // namespace

LognormalMoments lognormal_moments(double median, double dispersion) {
  require_positive("median", median);
  require_positive("dispersion", dispersion);
  const double square = dispersion * dispersion;
  const double mean = median * std::exp(square / 2);
  return {mean, mean * std::sqrt(std::expm1(square))};
}

std::optional<NrmlResults> nrml_of(const std::vector<std::pair<std::string, IdaResults>>& events, const std::string& id,
                                   bool misfits, std::string& error) {
  const IdaResults& first = events.at(0).second;
  NrmlResults made;
  NrmlModel& model = made.model;
  model.id = "bentur";
  model.description = first.title.empty() ? id : first.title;
  model.period = first.period();
  made.damping = number_after(first.intensity, "damping ").value_or(5) / 100;
  const double in_g = acceleration_factor(first.study_unit, {.length = "m"}) / standard_gravity("m");
  const std::vector<double> intensities = first.table.intensities();
  if (intensities.empty()) {
    error = "has no record with an intensity";
    return std::nullopt;
  }
  model.lowest = intensities.front() * in_g;
  model.highest = intensities.back() * in_g;
  for (std::size_t c = 0; c < first.table.cases; ++c) {
    NrmlFunction function{.id = id};
    const std::vector<std::size_t> places = first.places(c);
    for (std::size_t axis = 0; first.table.cases > 1 && axis < places.size(); ++axis) {
      for (const ResultCoordinate& of : first.axes[axis].coordinates) {
        function.id += "/" + of.name + "=" +
                       (of.texts.empty() ? fmt::format("{}", of.numbers[places[axis]]) : of.texts[places[axis]]);
      }
    }
    std::string fault;
    bool left_out = false;
    for (const auto& [event, results] : events) {
      const CaseFragility fragility = fit_case(results.table, c, {.resamples = 1});
      if (fragility.fit.kind != Fragility::Kind::fitted) {
        fault = event;
        break;
      }
      function.curves.push_back({.limit_state = state_name(event),
                                 .median = fragility.fit.median * in_g,
                                 .dispersion = fragility.fit.dispersion,
                                 .extrapolated = is_extrapolated(fragility.counts, fragility.fit),
                                 .misfit = fragility.is_misfit()});
      if (!function.curves.back().misfit) continue;
      made.misfits.push_back(function.id + " (" + event + ")");
      left_out = left_out || !misfits;
    }
    if (left_out) continue;
    if (fault.empty()) {
      for (std::size_t i = 0; i < events.size(); ++i) {
        if (function.curves[i].extrapolated) made.extrapolated.push_back(function.id + " (" + events[i].first + ")");
      }
      model.functions.push_back(std::move(function));
    } else {
      made.left_out.push_back(function.id + " (" + fault + ")");
    }
  }
  if (model.functions.empty()) {
    error = made.misfits.empty()
                ? "no case has a median and a dispersion for every event; bentur fragility says why"
                : "no case has a curve for every event that its runs follow; bentur fragility says which do not, "
                  "--misfits takes them all the same";
    return std::nullopt;
  }
  return made;
}

std::string nrml_fragility(const NrmlModel& model, std::string_view version) {
  if (model.functions.empty()) throw InvalidParameter("functions", "none", "must be one at least");
  require_positive("lowest", model.lowest);
  require_positive("highest", model.highest);
  std::vector<std::string> states;
  for (const NrmlCurve& curve : model.functions.front().curves) states.push_back(xml_text(curve.limit_state));
  const std::string imt = model.period ? fmt::format("SA({})", *model.period) : "PGA";
  std::string xml = fmt::format(
      "<?xml version=\"1.0\" encoding=\"utf-8\"?>\n"
      "{} {} -->\n"
      "<nrml xmlns=\"http://openquake.org/xmlns/nrml/0.5\">\n"
      "  <fragilityModel id=\"{}\" assetCategory=\"building\" lossCategory=\"structural\">\n"
      "    <description>{}</description>\n"
      "    <limitStates>{}</limitStates>\n",
      nrml_mark, version, xml_text(model.id), xml_text(model.description), fmt::join(states, " "));
  for (const NrmlFunction& function : model.functions) {
    xml += fmt::format(
        "    <fragilityFunction id=\"{}\" format=\"continuous\" shape=\"logncdf\">\n"
        "      <imls imt=\"{}\" noDamageLimit=\"0\" minIML=\"{}\" maxIML=\"{}\"/>\n",
        xml_text(function.id), imt, model.lowest, model.highest);
    if (function.curves.size() != states.size()) {
      throw InvalidParameter("curves", fmt::format("{}", function.curves.size()),
                             "must be those of the first function");
    }
    for (std::size_t i = 0; i < states.size(); ++i) {
      const NrmlCurve& curve = function.curves[i];
      if (xml_text(curve.limit_state) != states[i]) {
        throw InvalidParameter("limit_state", curve.limit_state, "must be that of the first function");
      }
      const LognormalMoments moments = lognormal_moments(curve.median, curve.dispersion);
      if (curve.extrapolated) {
        xml += fmt::format("      <!-- extrapolated: median {} g, levels analysed from {} g to {} g -->\n",
                           curve.median, model.lowest, model.highest);
      }
      if (curve.misfit) xml += "      <!-- misfit: the runs do not follow a lognormal (KS, 5 %) -->\n";
      xml +=
          fmt::format("      <params ls=\"{}\" mean=\"{}\" stddev=\"{}\"/>\n", states[i], moments.mean, moments.stddev);
    }
    xml += "    </fragilityFunction>\n";
  }
  return xml + "  </fragilityModel>\n</nrml>\n";
}

}  // namespace bentur
