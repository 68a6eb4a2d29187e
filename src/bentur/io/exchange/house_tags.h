#pragma once

#include <optional>
#include <string>

// Heights and numbers of storeys as OpenStreetMap and those who copy it write them.
namespace bentur {

/// What a tag says.
template <class Value>
struct HouseTag {
  Value value{};
  bool as_written = true;  ///< else it was read otherwise than it stands, which is to be reported
};

/// A height [m] in (0, 1000]: `12.5`, `12.5 m`; read otherwise than they stand `12,5` (a decimal comma), `40'`,
/// `40'6"` and `40 ft` (feet of 0.3048 m and their twelfths).
/// @return nothing where it is none of them
[[nodiscard]] std::optional<HouseTag<double>> height_tag(const std::string& text);

/// Storeys, 1 to 200: `3`, `4.0`; read otherwise than they stand `3.5` and `3,5` (a part of one is one: 4), `3;4` and
/// `2-3` (the most), `4+1` (the sum).
/// @return nothing where it is none of them
[[nodiscard]] std::optional<HouseTag<int>> storeys_tag(const std::string& text);

}  // namespace bentur
