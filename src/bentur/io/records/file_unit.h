#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace bentur::records {

/// A unit of accelerations, with the factor that brings a file's numbers to it: of mg to g 0.001.
struct FileUnit {
  std::string unit;   ///< as acceleration_units()
  double factor = 1;  ///< [-]
};

/// The unit by one of the spellings that files have, as "gal", "cm/s/s"; nothing for others, those of velocity among
/// them.
[[nodiscard]] std::optional<FileUnit> file_unit(std::string_view spelling);

}  // namespace bentur::records
