#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "bentur/core/not_known.h"
#include "bentur/model/story/remarks.h"

// What is usual, and the list of what is not, of rows and plans alike.
namespace bentur::remarking {

inline constexpr double none = not_known;  // of a range that is open on one side

/// What remarks may be about: what is usual of it, and from where on it is remarked on: a factor apart, so that the
/// unusual is not nagged at. Numbers in SI units.
struct RemarkKind {
  std::string_view key;
  std::string_view unit;                       ///< "F L-1" of the case, or as it is
  double usual_from = none, usual_to = none;   ///< none: nothing is too small, or too large
  double least = usual_from, most = usual_to;  ///< [usual] likewise
  double doubted = 0;                          ///< so many times beyond the usual it is in doubt; 0: it never is
};
[[nodiscard]] const RemarkKind& remark_kind(std::string_view key);
/// Ranges of the kind "dimension": where bearings yield, and how thick infill is.
extern const RemarkKind bearing_yield, infill_thickness;
/// How many times its number is beyond the usual, either way [-]; where nothing at all is usual, its number.
[[nodiscard]] double beyond_usual(const Remark& remark);

/// Remarks with their usual ranges in the units of a case. Values are in those, too.
class List {
 public:
  explicit List(const Units& units) : units_(units), newtons_(newtons(units.force)), metres_(metres(units.length)) {}

  /// A value that may be outside of what is usual of its kind.
  void check(std::string_view key, const std::string& subject, double value);
  /// The same by a range that is not the only one of its kind.
  void check(const RemarkKind& kind, const std::string& subject, double value);
  /// The same of what has a limit of its own, in the units of the case.
  void check(std::string_view key, const std::string& subject, double value, double most, double usual);
  /// What is unusual in any case. Of a kind and a subject the farthest out stays alone.
  void add(std::string_view key, const std::string& subject, double value, std::optional<double> usual_from,
           std::optional<double> usual_to, bool is_doubt = true);

  /// What one unit of a form, "F", "L" or "F L-2", has in SI units.
  [[nodiscard]] double si(std::string_view form) const;
  [[nodiscard]] const Units& units() const { return units_; }
  [[nodiscard]] std::vector<Remark> take() { return std::move(all_); }

 private:
  Units units_;
  double newtons_, metres_;
  std::vector<Remark> all_;
};

}  // namespace bentur::remarking
