#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "bentur/core/diagnostics.h"

namespace bentur {

/// A hazard curve: the mean annual frequency that the intensity of the ground motion at a site exceeds x. Between its
/// numbers it is straight in ln–ln,
///
///   λ(x) = λ_a (x/a)⁻ᵏ,   a ≤ x ≤ b,   k = ln(λ_a/λ_b)/ln(b/a).                                            (1)
struct HazardCurve {
  std::vector<double> intensity;  ///< x [unit] > 0, ascending; two or more
  std::vector<double> rate;       ///< λ [1/year] > 0, not rising
  std::string measure = {};       ///< "PGA", "SA(0.5)" where the file says it, "SA" where it says no period
  std::string unit = {};          ///< of x, as acceleration_units(); empty: the file does not say it

  [[nodiscard]] std::size_t segments() const { return intensity.size() - 1; }
  [[nodiscard]] double slope(std::size_t segment) const;  ///< k [-] ≥ 0
  /// The segment of x; of what is beyond an end the first or last.
  [[nodiscard]] std::size_t segment_of(double x) const;
  /// (1); beyond an end as the first or last segment goes on.
  [[nodiscard]] double rate_at(double x) const;
};

/// Which of several sites, and what the file does not say.
struct HazardOptions {
  std::optional<long> site = {};  ///< from 1, of a file with several
  std::string unit = {};          ///< of x, where the file does not say it
};

/// Reads a hazard curve (docs/risk.md): a table of x and λ, whose heading or first comment may say measure and unit of
/// x, or a curve of OpenQuake (hazard_curve-mean-PGA.csv), whose probabilities of exceedance P in t years are
/// λ = −ln(1 − P)/t. What is wrong goes to `diagnostics` with its line.
/// Source: OpenQuake engine manual, "Outputs from classical PSHA".
[[nodiscard]] std::optional<HazardCurve> read_hazard(const std::filesystem::path& file, const HazardOptions& options,
                                                     Diagnostics& diagnostics);
/// The same of a text. @param name of the file, for messages
[[nodiscard]] std::optional<HazardCurve> hazard_of(std::string_view text, const std::string& name,
                                                   const HazardOptions& options, Diagnostics& diagnostics);

}  // namespace bentur
