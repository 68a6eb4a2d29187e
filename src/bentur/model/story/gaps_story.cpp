// What is said of several gaps together, of rows and of blocks in plan.
#include <algorithm>
#include <limits>
#include <numeric>

#include "bentur/model/story/internal/story_parts.h"

namespace bentur::story {
namespace {

constexpr std::size_t most_lines = 12;   ///< of a table; of more gaps it has the worst alone
constexpr std::size_t worst_lines = 10;  ///< of those
constexpr double not_there = std::numeric_limits<double>::quiet_NaN();

/// By how much a gap falls short of what it needs, as given or reversed [length]; below zero where it does not.
double lacking(const GoverningNeed& need) {
  return std::max(need.given.needed.value_or(0), need.reversed.needed.value_or(0)) - need.at.width;
}

/// The places of the gaps in the table: in their order, or of many the worst first.
std::vector<std::size_t> shown_gaps(const std::vector<GapLine>& gaps) {
  std::vector<std::size_t> order(gaps.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  if (gaps.size() <= most_lines) return order;
  const auto rank = [&](std::size_t g) {
    return gaps[g].judged == Sufficiency::too_small ? 0 : gaps[g].judged == Sufficiency::unknown ? 1 : 2;
  };
  std::vector<double> lacks;
  for (const GapLine& one : gaps) lacks.push_back(lacking(governing_need(*one.facts).value_or(GoverningNeed{})));
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return rank(a) != rank(b) ? rank(a) < rank(b) : lacks[a] > lacks[b];
  });
  order.resize(worst_lines);
  return order;
}

StoryTable table_of_gaps(const std::vector<GapLine>& gaps, const ShownUnits& shown, const std::string& length) {
  StoryColumn name{.label = "column.gap"}, verdict{.label = "gap.given_is", .are_words = true};
  StoryColumn given{"column.given", length}, needed{"column.simulated", length}, lacks{"column.short_by", length};
  StoryColumn impacts{.label = "column.impacts", .are_counts = true}, hardest{"column.hardest", shown.units.force};
  const std::vector<std::size_t> order = shown_gaps(gaps);
  StoryTable table{.kind = order.size() == gaps.size() ? "row" : "row_worst",
                   .values = {count_of("shown", std::ssize(order)), count_of("count", std::ssize(gaps))}};
  for (const std::size_t g : order) {
    const GapLine& one = gaps[g];
    const GoverningNeed need = governing_need(*one.facts).value_or(GoverningNeed{});
    if (one.judged == Sufficiency::too_small) table.marked.push_back(name.texts.size());
    name.texts.push_back(one.name);
    verdict.texts.emplace_back(judgement_word(one.judged));
    given.numbers.push_back(need.at.width);
    needed.numbers.push_back(need.given.needed.value_or(not_there));
    const double short_by = need.given.is_short ? need.given.needed.value_or(not_there) - need.at.width : not_there;
    lacks.numbers.push_back(short_by);
    impacts.texts.push_back(std::to_string(one.impacts));
    hardest.numbers.push_back(one.peak_force > 0 ? shown.force * one.peak_force : not_there);
  }
  table.columns = {name, verdict, given, needed, lacks, impacts, hardest};
  return table;
}

}  // namespace

void tell_gaps(const std::vector<GapLine>& gaps, const ShownUnits& shown, const std::string& length, Story& told) {
  if (gaps.size() < 2) return;
  told.tables.push_back(table_of_gaps(gaps, shown, length));
  const auto judged = [&](Sufficiency as) {
    return static_cast<long>(
        std::count_if(gaps.begin(), gaps.end(), [&](const GapLine& one) { return one.judged == as; }));
  };
  const long count = std::ssize(gaps), small = judged(Sufficiency::too_small), unknown = judged(Sufficiency::unknown);
  Statement statement{.kind = small == count ? "row_all"
                              : small > 0    ? "row_some"
                              : unknown > 0  ? "row_unknown"
                                             : "row_none",
                      .severity = small + unknown == 0 ? Severity::finding : Severity::warning};
  statement.values = {count_of("count", count), count_of("small", small), count_of("unknown", unknown)};
  const bool more = small > 0 && unknown > 0;
  statement.values.push_back(more ? word_of("others", "story.row_others") : text_of("others", ""));
  told.statements.push_back(std::move(statement));
}

}  // namespace bentur::story
