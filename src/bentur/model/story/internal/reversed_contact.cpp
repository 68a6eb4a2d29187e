#include <algorithm>

#include "bentur/model/story/internal/story_parts.h"

namespace bentur::story {

void tell_reversed_contact(const GapView& view, const ShownUnits& shown, std::vector<Statement>& statements) {
  long closed = 0;
  bool is_more = false;
  double most = 0, given = 0;
  std::size_t hardest = 0;
  for (std::size_t g = 0; g < view.gaps.size(); ++g) {
    const GapFacts& facts = view.gaps[g].facts;
    given = std::max(given, facts.peak_force());
    if (!facts.touch(Way::reversed)) continue;
    ++closed;
    is_more = is_more || !facts.touch();
    const double force = facts.peak_force(Way::reversed);
    if (force > most) most = force, hardest = g;
  }
  constexpr double round_off = 1e-6;
  if (closed == 0 || !(is_more || most > (1 + round_off) * given)) return;
  const GapFacts& facts = view.gaps[hardest].facts;
  const auto level = std::find_if(facts.levels.begin(), facts.levels.end(),
                                  [&](const LevelFacts& one) { return one.reversed.peak_force == most; });
  Statement statement{.kind = most > 0 ? "row_reversed" : "row_reversed_impulse",
                      .severity = Severity::warning,
                      .values = {count_of("closed", closed), count_of("count", std::ssize(view.gaps))}};
  if (most > 0) {
    statement.values.push_back(text_of("left", facts.left));
    statement.values.push_back(text_of("right", facts.right));
    statement.values.push_back(value_in("force", shown.force * most, shown.units.force));
    statement.values.push_back(value_in("level", level->at.elevation, view.c.units.length));
  }
  statements.push_back(std::move(statement));
}

}  // namespace bentur::story
