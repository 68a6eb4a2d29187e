#include "bentur/io/results/internal/asked_json.h"

#include <cmath>
#include <nlohmann/json.hpp>
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

std::string text_of(const Json& json) { return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n"; }

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
            {"displacement_amplitude", harmonic->displacement_amplitude},
            {"phase", harmonic->phase == HarmonicMotion::Phase::sine ? "sine" : "cosine"},
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
