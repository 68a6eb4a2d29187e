#include "bentur/io/results/internal/asked_json.h"

#include <cmath>
#include <nlohmann/json.hpp>
#include <numeric>
#include <variant>

#include "bentur/io/results/internal/record_json.h"

namespace bentur {

Json or_null(const std::optional<double>& value) { return value ? Json(*value) : Json(nullptr); }
Json or_null_if_unknown(double value) { return std::isnan(value) ? Json(nullptr) : Json(value); }

Json remarks_json(const std::vector<Remark>& remarks) {
  Json json = Json::array();
  for (const Remark& remark : remarks) {
    json.push_back({{"key", remark.key},
                    {"subject", remark.subject},
                    {"value", remark.value},
                    {"unit", remark.unit},
                    {"usual", {or_null(remark.usual_from), or_null(remark.usual_to)}},
                    {"doubt", remark.is_doubt}});
  }
  return json;
}

namespace {

std::size_t values_in(const Json& json) {
  return std::accumulate(json.begin(), json.end(), std::size_t{1}, [](std::size_t sum, const Json& one) {
    return sum + (one.is_structured() ? values_in(one) : 1);
  });
}

/// As dump() writes it, item by item.
void write(const Json& json, std::size_t indent, std::string& text) {
  if (!json.is_structured() || json.empty() || indent > 4) {
    const std::string part = json.dump(2, ' ', false, Json::error_handler_t::replace);
    for (const char c : part) {
      text += c;
      if (c == '\n') text.append(indent, ' ');
    }
    return;
  }
  text += json.is_object() ? '{' : '[';
  bool first = true;
  for (auto item = json.begin(); item != json.end(); ++item) {
    text += first ? "\n" : ",\n";
    first = false;
    text.append(indent + 2, ' ');
    if (json.is_object()) text += Json(item.key()).dump(2, ' ', false, Json::error_handler_t::replace) + ": ";
    write(*item, indent + 2, text);
  }
  text += '\n';
  text.append(indent, ' ');
  text += json.is_object() ? '}' : ']';
}

}  // namespace

std::string text_of(const Json& json) {
  constexpr std::size_t bytes_of_one = 60;  // more than a value takes with its name and what is before it
  std::string text;
  text.reserve(json.is_structured() ? bytes_of_one * values_in(json)
                                    : 0);  // a long one would be there twice as it grows
  write(json, 0, text);
  text += '\n';
  return text;
}

Json units_json(const Units& units) { return {{"length", units.length}, {"force", units.force}}; }

namespace {

Json spectrum_json(const SpectrumSpec& spec) {
  if (spec.of_displacements) return {{"kind", "displacements"}};
  Json json = {{"kind", "spectrum"}, {"shape", spec.shape}};
  if (!spec.file.empty()) json["file"] = spec.file;
  if (const auto* shape = std::get_if<TwoPeriodSpectrum>(&spec.spectrum.shape)) {
    json["short_period"] = shape->short_period;
    json["one_second"] = shape->one_second;
    json["long_period"] = shape->long_period;
  } else if (const auto* eurocode = std::get_if<EurocodeSpectrum>(&spec.spectrum.shape)) {
    json["ground_acceleration"] = eurocode->ground_acceleration;
    json["soil_factor"] = eurocode->soil_factor;
    json["corner_periods"] = {eurocode->corner_b, eurocode->corner_c, eurocode->corner_d};
  } else {
    const auto& table = std::get<TableSpectrum>(spec.spectrum.shape);
    json["periods"] = table.periods;
    json["accelerations"] = table.accelerations;
  }
  json["damping_ratio"] = spec.spectrum.damping_ratio;
  json["damping_correction"] = spec.spectrum.corrects_damping ? "en-1998-1" : "none";
  json["modal_combination"] = spec.combination == ModalCombination::cqc ? "cqc" : "srss";
  if (!spec.reduction.empty()) json["reduction"] = spec.reduction;
  return json;
}

}  // namespace

Json excitation_json(const ExcitationSpec& excitation) {
  Json json;
  if (excitation.spectrum) return spectrum_json(*excitation.spectrum);
  if (excitation.record) {
    json = {{"kind", "record"}};
    put_record(*excitation.record, json);
    json["size"] = excitation.record->size;
    json["sha256"] = excitation.record->sha256;
  } else if (const auto* harmonic = std::get_if<HarmonicMotion>(&excitation.motion)) {
    json = {{"kind", "harmonic"},
            {"period", harmonic->period},
            {"displacement_amplitude", std::abs(harmonic->displacement_amplitude)},
            {"phase", harmonic->phase == HarmonicMotion::Phase::sine ? "sine" : "cosine"},
            {"polarity", harmonic->is_reversed() ? "reversed" : "as-recorded"},
            {"pga", peak_acceleration(excitation.motion)}};
  } else {
    json = {{"kind", "none"}};
  }
  json["delays"] = excitation.delays;
  json["kinematics"] = excitation.kinematics == Kinematics::relative ? "relative" : "absolute";
  return json;
}

Json source_json(const std::optional<CaseSource>& source) {
  if (!source) return nullptr;
  return {
      {"file", source->file}, {"size", source->text.size()}, {"sha256", source->sha256}, {"copied", source->copied}};
}

Json contact_json(const ContactLaw& law, const ContactSpec& spec) {
  Json json = {{"law", law.name()}};
  for (const auto& [name, value] : law.parameters()) json[std::string(name)] = value;
  for (const auto& [name, word] : spec.choices()) json[name] = word;
  return json;
}

}  // namespace bentur
