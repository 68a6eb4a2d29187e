#include "bentur/model/story/study_story.h"

#include <algorithm>
#include <utility>

#include "bentur/model/judgement/open_needs.h"
#include "bentur/model/story/internal/story_parts.h"

namespace bentur {
namespace {

using story::count_of;
using story::text_of;
using story::value_in;
using story::word_of;

Statement placed(std::string kind, const PlacedValue& value) {
  Statement statement{.kind = std::move(kind)};
  statement.values = {value_in("value", value.value, value.unit), text_of("places", value.where),
                      value.where.empty() ? text_of("where", "") : word_of("where", "story.at_places")};
  return statement;
}

}  // namespace

void OpenNeeds::add(std::uint64_t bits) {
  if (bits == 0) return;
  ++runs;
  in.resize(open_need_keys().size(), 0);
  for (std::size_t i = 0; i < in.size(); ++i) in[i] += (bits >> i & 1U) != 0 ? 1 : 0;
}

void OpenNeeds::add(const OpenNeeds& other) {
  runs += other.runs;
  in.resize(std::max(in.size(), other.in.size()), 0);
  for (std::size_t i = 0; i < other.in.size(); ++i) in[i] += other.in[i];
}

Statement open_needs_statement(const OpenNeeds& open, long of, std::string kind) {
  Statement statement{.kind = std::move(kind), .severity = Severity::danger};
  statement.values = {count_of("count", open.runs), count_of("runs", of)};
  for (std::size_t i = 0; i < open.in.size(); ++i) {
    if (open.in[i] == 0) continue;
    statement.items.push_back(
        {word_of("why", "story.open_need." + std::string(open_need_keys()[i])), count_of("in", open.in[i])});
  }
  return statement;
}

Story study_story(const StudyOutcome& outcome) {
  const long finished = outcome.runs - outcome.failed;
  Story told;
  if (outcome.unmodelled > 0) {
    told.statements.push_back({.kind = "study_unmodelled",
                               .severity = Severity::danger,
                               .values = {count_of("unmodelled", outcome.unmodelled), count_of("runs", finished)}});
  }
  const auto tell_remarks = [&](const char* kind, Severity severity, long count) {
    Statement statement{.kind = kind, .severity = severity};
    statement.values = {count_of("count", count), count_of("runs", finished)};
    for (const auto& [key, runs] : outcome.remarks) {
      statement.items.push_back({text_of("key", key), count_of("in", runs)});
    }
    told.statements.push_back(std::move(statement));
  };
  if (outcome.doubted > 0) tell_remarks("study_doubted", Severity::danger, outcome.doubted);
  if (outcome.open.runs > 0) told.statements.push_back(open_needs_statement(outcome.open, finished));
  if (outcome.remarked > 0 && outcome.doubted == 0) tell_remarks("study_remarked", Severity::warning, outcome.remarked);
  if (finished > 0) {
    told.statements.push_back({.kind = outcome.pounding > 0 ? "study_pounding" : "study_no_pounding",
                               .severity = outcome.pounding > 0 ? Severity::warning : Severity::finding,
                               .values = {count_of("pounding", outcome.pounding), count_of("runs", finished)}});
  }
  if (outcome.failed > 0) {
    told.statements.push_back({.kind = "study_failed",
                               .severity = Severity::warning,
                               .values = {count_of("failed", outcome.failed), count_of("runs", outcome.runs)}});
  }
  if (outcome.hardest_force) told.statements.push_back(placed("study_hardest", *outcome.hardest_force));
  if (outcome.gap_needed)
    told.statements.push_back(
        placed(outcome.open.runs > 0 ? "study_needed_known" : "study_needed", *outcome.gap_needed));
  return told;
}

}  // namespace bentur
