#pragma once

#include <string>

#include "bentur/model/quantities.h"

namespace bentur {

/// A text as one field, quoted where it must be (RFC 4180). One that a spreadsheet would compute, as it begins with
/// = + - @ or a tab, begins with an apostrophe.
[[nodiscard]] std::string csv_field(const std::string& text);

/// "peak_force [kgf]", of a quantity with this name.
[[nodiscard]] std::string csv_heading(const Quantity& quantity, const Units& units);
/// A number to its last digit, without the sign of a zero; empty for NaN.
[[nodiscard]] std::string csv_number(double value);

/// `impacts.csv`: one row per impact by start, a header row with units, numbers to the last digit (RFC 4180, LF). Every
/// quantity of an impact is a column, behind those that say where it was; one that is not known stays empty.
[[nodiscard]] std::string impacts_csv(const RunView& run);
/// The same of buildings in plan, with the places of the contact points.
[[nodiscard]] std::string impacts_csv(const PlanRun& run);

}  // namespace bentur
