#include "bentur/model/story/story.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <functional>
#include <iterator>

#include "bentur/core/number_text.h"
#include "bentur/model/story/internal/remark_list.h"
#include "bentur/model/story/internal/story_parts.h"

namespace bentur {
namespace {

constexpr std::size_t most_named = 4;  // buildings or gaps in one sentence

/// One number where all are alike, else one for each that is named, or of many the least and the largest.
std::string numbers_of(const std::vector<double>& values) {
  std::vector<std::string> texts;
  for (const double value : values) texts.push_back(number(value));
  if (std::adjacent_find(texts.begin(), texts.end(), std::not_equal_to<>()) == texts.end()) return texts.front();
  if (texts.size() <= most_named) return fmt::format("{}", fmt::join(texts, ", "));
  const auto [least, largest] = std::minmax_element(values.begin(), values.end());
  return number(*least) + "–" + number(*largest);
}

StoryValue usual_range(const Remark& remark) {
  if (remark.usual_from && remark.usual_to) return story::word_of("usual", "remark.between");
  return story::word_of("usual", remark.usual_to ? "remark.up_to" : "remark.at_least");
}

}  // namespace

std::string_view severity_name(Severity severity) {
  constexpr std::string_view names[] = {"danger", "warning", "finding", "remark"};
  return names[static_cast<std::size_t>(severity)];
}

std::string_view shown_name(Shown shown) {
  constexpr std::string_view names[] = {"sentence", "row", "table"};
  return names[static_cast<std::size_t>(shown)];
}

std::vector<Statement> remark_statements(const std::vector<Remark>& remarks) {
  std::vector<Statement> statements;
  std::vector<char> told(remarks.size(), 0);
  for (std::size_t i = 0; i < remarks.size(); ++i) {
    const Remark& first = remarks[i];
    Statement statement{.kind = "remark." + first.key,
                        .severity = first.is_doubt ? Severity::danger : Severity::remark};
    std::vector<double> values;
    for (std::size_t k = i; k < remarks.size(); ++k) {
      const Remark& other = remarks[k];
      if (told[k] != 0 || other.key != first.key || other.is_doubt != first.is_doubt ||
          other.usual_from != first.usual_from || other.usual_to != first.usual_to) {
        continue;
      }
      told[k] = 1;
      values.push_back(other.value);
      statement.beyond = std::max(statement.beyond, remarking::beyond_usual(other));
      if (values.size() > most_named) continue;
      statement.subject += (statement.subject.empty() ? "" : ", ") + other.subject;
    }
    if (values.empty()) continue;
    if (values.size() > most_named) {
      statement.values.push_back(story::count_of("more", static_cast<long>(values.size() - most_named)));
    }
    const std::string numbers = numbers_of(values);
    if (numbers == number(first.value)) {
      statement.values.push_back(story::value_in("value", first.value, first.unit));
    } else {
      statement.values.push_back(
          story::text_of("value", fmt::format("{}{}{}", numbers, first.unit.empty() ? "" : "\u00A0", first.unit)));
    }
    statement.values.push_back(usual_range(first));
    if (first.usual_from) statement.values.push_back(story::text_of("from", number(*first.usual_from)));
    statement.values.push_back(story::text_of("unit", first.unit.empty() ? "" : "\u00A0" + first.unit));
    if (first.usual_to) statement.values.push_back(story::value_in("to", *first.usual_to, first.unit));
    statements.push_back(std::move(statement));
  }
  return statements;
}

void put_remarks(const std::vector<Remark>& remarks, std::vector<Statement>& statements) {
  std::vector<Statement> doubts;
  for (Statement& one : remark_statements(remarks)) {
    (one.severity == Severity::remark ? statements : doubts).push_back(std::move(one));
  }
  statements.insert(statements.begin(), std::make_move_iterator(doubts.begin()), std::make_move_iterator(doubts.end()));
}

void sort_by_severity(std::vector<Statement>& statements) {
  std::stable_sort(statements.begin(), statements.end(),
                   [](const Statement& a, const Statement& b) { return a.severity < b.severity; });
}

const Statement* hardest_impact_of(const std::vector<Statement>& statements) {
  const Statement* hardest = nullptr;
  double most = 0;
  for (const Statement& one : statements) {
    if (!one.gap || !one.kind.starts_with("pounding")) continue;
    const std::string_view name = one.kind == "pounding" ? "force" : "speed";
    const auto at =
        std::find_if(one.values.begin(), one.values.end(), [&](const StoryValue& v) { return v.name == name; });
    const double size = std::get<double>(at->value);
    if (hardest == nullptr || one.kind < hardest->kind || (one.kind == hardest->kind && size > most)) {
      hardest = &one;
      most = size;
    }
  }
  return hardest;
}

namespace story {

const std::string& faced_name(const Problem& problem, const WatchedFloor& floor) {
  return problem.buildings[floor.faced()].name;
}

void add_faces(const Problem& problem, const WatchedFloor& floor, bool in_plan, std::vector<StoryValue>& values) {
  const char* const column = faces_base(problem, floor) ? "story.the_base_of"
                             : in_plan                  ? "story.the_edge_of"
                                                        : "story.the_column_of";
  values.push_back(text_of("building", problem.buildings[floor.floor_of].name));
  values.push_back(text_of("faced_building", faced_name(problem, floor)));
  values.push_back(word_of("faced", floor.facing_floor ? "story.the_floor_of" : column));
}

}  // namespace story
}  // namespace bentur
