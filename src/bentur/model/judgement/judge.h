#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "bentur/model/judgement/facts.h"

namespace bentur {

/// What may be said of a gap, worst first.
enum class Sufficiency {
  too_small,  ///< it closes in some run, a run would close it, or a rule of [code] asks for more
  unknown,    ///< none of these, but something that decides it is not known
  enough      ///< neither, in both ways of the motion
};
/// "too small", "not known", "enough".
[[nodiscard]] std::string_view word_of(Sufficiency value);

/// Why a gap is too small, or not known to be enough.
struct Reason {
  enum class Kind {
    contact,       ///< the buildings collide: `count` impacts, up to `value` [force]
    unmodelled,    ///< a floor goes `value` [length] into what it faces, where no contact is modelled
    need,          ///< they need `value` [length] without contact
    rule,          ///< a rule of [code], `subject`, asks for `value` [length]
    collapse,      ///< storey `storey` of `subject` falls at `value` [s], with contact (`count` 1) or without
    drift,         ///< it drifts by `value` of its height without contact [-], beyond collapse
    capacity,      ///< by a spectrum it carries `value` times what it can, as an elastic one
    phase,         ///< peaks alone are known: both at once need `value` [length]
    doubt,         ///< GapFacts::doubts[`count`]
    motion_left,   ///< free vibration after the end could still need `value` [length]
    not_looked_at  ///< the motion, with contact or without; `count` says what of it, NotLookedAt
  };
  Kind kind = Kind::need;
  Way way = Way::given;
  std::optional<std::size_t> level = {};  ///< index into GapFacts::levels
  double value = 0, width = 0;            ///< `width`: given at the level [length]
  long count = 0;
  std::string subject = {};
  Eigen::Index storey = 0;
};
/// What of a motion was not looked at.
enum class NotLookedAt {
  motion,  ///< all of it, or contact
  masses,  ///< contact with masses elsewhere than expected
  rules    ///< what rules of [code] ask, of results read back without their case
};
/// "contact", "unmodelled contact", …, as results have it.
[[nodiscard]] std::string_view word_of(Reason::Kind kind);
/// The same, "contact reversed" where it is of the motion reversed.
[[nodiscard]] std::string word_of(const Reason& reason);
/// Whether a gap is too small for this reason; else it is why that is not known.
[[nodiscard]] bool says_too_small(Reason::Kind kind);
/// Whether it does by how the buildings move, not by a rule.
[[nodiscard]] bool is_by_motion(Reason::Kind kind);

/// What is known of one gap.
struct Judgement {
  Sufficiency value = Sufficiency::enough;
  std::vector<Reason> reasons = {};      ///< worst first; empty: it is enough
  std::vector<Sufficiency> levels = {};  ///< of each of GapFacts::levels
  bool alone = false;                    ///< what is needed is needed if no other gap closes, as one does

  [[nodiscard]] bool is_enough() const { return value == Sufficiency::enough; }
  /// Whether something that decides it is not known, whatever else makes it too small.
  [[nodiscard]] bool is_open() const { return !reasons.empty() && !says_too_small(reasons.back().kind); }
};

/// The one judgement of a gap, from all facts: "enough", "to spare", "met", "stay apart" are said by it alone.
[[nodiscard]] Judgement judge(const GapFacts& facts);

/// Of a gap the level that falls short the most, as recorded or reversed.
struct GoverningNeed {
  /// Of one way of the motion.
  struct OneWay {
    std::optional<double> needed = {};  ///< without contact [length]; nothing: not known
    bool is_short = false;              ///< more than is given
  };
  FacingLevel at;
  OneWay given = {}, reversed = {};
};
/// Nothing where no floors face one another.
[[nodiscard]] std::optional<GoverningNeed> governing_need(const GapFacts& facts);

/// What is known of one gap in many runs: of the records of a suite, of the points of a study.
struct JudgementOfMany {
  /// Of a kind of reason and a way of the motion the worst, in which run, and in how many runs there is one.
  struct Found {
    Reason worst;
    std::size_t run = 0;
    long runs = 0;
  };
  Sufficiency value = Sufficiency::enough;  ///< the worst of all
  long runs = 0, too_small = 0, not_known = 0, enough = 0;
  std::vector<Found> reasons = {};  ///< worst first

  [[nodiscard]] bool is_enough() const { return value == Sufficiency::enough; }
  /// As Judgement::is_open().
  [[nodiscard]] bool is_open() const { return !reasons.empty() && !says_too_small(reasons.back().worst.kind); }
};
/// What is judged of a gap but for what rules ask.
[[nodiscard]] Sufficiency without_rules(const Judgement& judgement);
/// The union of what is judged of a gap in many runs. What rules ask of single runs is left out, as codes take records
/// together. @param of_rules what they ask of all runs together and is not given
[[nodiscard]] JudgementOfMany judge(const std::vector<Judgement>& of_runs, const std::vector<Reason>& of_rules);

}  // namespace bentur
