#include "bentur/model/story/study_story.h"

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
  if (outcome.not_known > 0) {
    told.statements.push_back({.kind = "study_not_known",
                               .severity = Severity::danger,
                               .values = {count_of("count", outcome.not_known), count_of("runs", finished)}});
  }
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
        placed(outcome.not_known > 0 ? "study_needed_known" : "study_needed", *outcome.gap_needed));
  return told;
}

}  // namespace bentur
