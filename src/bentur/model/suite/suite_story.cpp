#include "bentur/model/suite/suite_story.h"

#include <algorithm>
#include <cmath>

#include "bentur/model/story/internal/story_parts.h"

namespace bentur {

Story suite_story(const SuiteSpec& suite, const Units& units) {
  using story::count_of;
  using story::text_of;
  using story::value_in;
  const auto [first, last] = suite.target.band();
  const double least_ratio = suite.least_share();
  double least_factor = INFINITY, most_factor = 0, most_misfit = 0;
  StoryColumn name{.label = "column.record"}, event{.label = "column.event"}, factor{"column.factor"};
  StoryColumn pga{"column.pga", "g"}, misfit{"column.misfit"};
  for (const SuiteRecord& record : suite.records) {
    least_factor = std::min(least_factor, record.factor);
    most_factor = std::max(most_factor, record.factor);
    most_misfit = std::max(most_misfit, record.misfit);
    name.texts.push_back(record.name());
    event.texts.push_back(record.event.empty() ? "–" : record.event);
    factor.numbers.push_back(record.factor);
    const double peak = record.along_y ? std::max(record.echo.pga, record.along_y->echo.pga) : record.echo.pga;
    pga.numbers.push_back(peak / units.gravity);
    misfit.numbers.push_back(record.misfit);
  }
  StoryColumn building{.label = "column.building"}, period_1{"column.first_period", "s"};
  StoryColumn period_2{"column.second_period", "s"};
  for (const SuitePeriods& one : suite.buildings) {
    building.texts.push_back(one.name);
    period_1.numbers.push_back(one.first);
    period_2.numbers.push_back(one.second.value_or(NAN));
  }
  Story told;
  const bool are_alike = number(least_factor) == number(most_factor);
  Statement taken{
      .kind = are_alike ? "suite_alike" : "suite",
      .values = {count_of("records", std::ssize(suite.records)), count_of("files", static_cast<long>(suite.files))}};
  if (are_alike) {
    taken.values.push_back(value_in("factor", most_factor));
  } else {
    taken.values.push_back(value_in("least", least_factor));
    taken.values.push_back(value_in("most", most_factor));
  }
  taken.values.push_back(value_in("misfit", most_misfit));
  told.statements.push_back(std::move(taken));
  Statement mean{.kind = suite.request.is_of_code() ? "suite_mean_of_code" : "suite_mean",
                 .values = {value_in("ratio", least_ratio), value_in("from", first, "s"), value_in("to", last, "s")}};
  if (suite.request.is_of_code()) {
    const bool is_en = suite.request.scale == "en-1998-1";
    mean.values.push_back(text_of("clause", is_en ? "EN 1998-1:2004, 3.2.3.1.2" : "ASCE 7-16, 16.2.3.2"));
    mean.values.push_back(value_in("common", suite.common_factor));
  }
  if (suite.is_below_target()) {
    mean.kind = "suite_target_not_known";
    mean.severity = Severity::warning;
    mean.values.push_back(value_in("asked", SuiteSpec::share_asked));
  }
  told.statements.push_back(std::move(mean));
  if (suite.is_of_pairs()) {
    const bool is_largest = pair_measure(suite.request) == PairMeasure::maximum_direction;
    told.statements.push_back({.kind = is_largest ? "suite_pairs_largest" : "suite_pairs"});
  }
  if (suite.request.scale == "asce-7-16")
    told.statements.push_back({.kind = "suite_level", .severity = Severity::warning});
  told.tables.push_back({.kind = "suite", .columns = {name, event, factor, pga, misfit}});
  told.tables.push_back({.kind = "suite_buildings", .columns = {building, period_1, period_2}});
  return told;
}

}  // namespace bentur
