#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>

#include "bentur/model/case.h"
#include "bentur/model/story/remarks.h"

// What a run was asked for, as results tell it, and how they write values.
namespace bentur {

using Json = nlohmann::ordered_json;

[[nodiscard]] Json or_null(const std::optional<double>& value);
/// null where it is NaN
[[nodiscard]] Json or_null_if_unknown(double value);

/// What is unusual, with what is usual: [from, to], null where a side is open.
[[nodiscard]] Json remarks_json(const std::vector<Remark>& remarks);
/// A whole document; bytes that are no UTF-8 are replaced.
[[nodiscard]] std::string text_of(const Json& json);

[[nodiscard]] Json units_json(const Units& units);
[[nodiscard]] Json excitation_json(const ExcitationSpec& excitation);
/// The file the case was read from, as far as it can be distinguished from others.
[[nodiscard]] Json source_json(const std::optional<CaseSource>& source);

/// The law with everything it works with, given or derived, and the choices that apply.
[[nodiscard]] Json contact_json(const ContactLaw& law, const ContactSpec& spec);

}  // namespace bentur
