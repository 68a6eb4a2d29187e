#include <algorithm>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>

#include "arguments.h"
#include "bentur/core/version.h"
#include "bentur/io/results/result_json.h"
#include "bentur/io/results/rules_json.h"
#include "bentur/model/gap/spectral_gap.h"
#include "bentur/model/plan/plan_places.h"
#include "bentur/model/story/story.h"
#include "bentur/report/errors.h"
#include "bentur/study/gap/gap_study.h"
#include "bentur/study/gap/gap_study_story.h"
#include "cases/gap_text.h"
#include "cases/suite.h"
#include "commands.h"
#include "session.h"
#include "text/table.h"

namespace bentur::cli {
namespace {

struct GapArguments {
  std::string file;
  std::optional<double> at;
  bool json = false, rules = false;
  std::optional<int> record;
  std::string language = "en";
};

/// Peak displacements of one building by both combinations, highest first.
std::string peaks_text(const Building& building, const SpectralPeaks& peaks, const std::string& length,
                       const Words& say) {
  if (building.is_rigid() && !building.given) return building.name + ": " + say("cli.moves") + "\n";
  const auto from_top = [](const auto& floors) {
    return std::vector<double>(std::make_reverse_iterator(floors.end()), std::make_reverse_iterator(floors.begin()));
  };
  Table table;
  table.add(say("column.elevation"), length, from_top(building.model.elevations));
  if (const auto& given = building.given) {
    table.add("u", length, from_top(given->displacement));
    const bool amplifies = given->amplification != 1;
    if (amplifies) table.add(say("spectral.amplified"), length, from_top(peaks.srss));
    return say("cli.peaks_given",
               {{"building", building.name},
                {"amplified", amplifies ? say("cli.amplified", {{"factor", number(given->amplification)}}) : ""}}) +
           "\n\n" + table.text();
  }
  if (peaks.srss_y.size() == 0) {
    table.add("SRSS", length, from_top(peaks.srss));
    table.add("CQC", length, from_top(peaks.cqc));
  } else {
    table.add("x, SRSS", length, from_top(peaks.srss));
    table.add("x, CQC", length, from_top(peaks.cqc));
    table.add("y, SRSS", length, from_top(peaks.srss_y));
    table.add("y, CQC", length, from_top(peaks.cqc_y));
  }
  return say("cli.peaks_by",
             {{"building", building.name}, {"elastic", building.can_yield() ? say("cli.elastic") : ""}}) +
         "\n\n" + table.text();
}

void run_spectrum(const Loaded& loaded, bool json, const Words& say) {
  const Case& c = loaded.c;
  const SpectrumSpec& spectrum = *c.excitation.spectrum;
  const SpectralGaps spectral = spectral_gaps(loaded);
  if (json) {
    print(spectral_gap_json(c, loaded.problem, spectral, version()));
    return;
  }
  std::string text = c.title.empty() ? "" : c.title + "\n";
  text += excitation_line(c.excitation, c.units, say) + "\n";
  std::string peaks;
  for (std::size_t b = 0; b < loaded.problem.buildings.size(); ++b) {
    peaks += "\n" + peaks_text(loaded.problem.buildings[b], spectral.peaks[b], c.units.length, say);
  }
  std::vector<std::string> notes;
  const auto& buildings = loaded.problem.buildings;
  if (!spectrum.of_displacements) notes.push_back(say("spectral.note"));
  if (std::any_of(buildings.begin(), buildings.end(), [](const Building& one) { return one.given.has_value(); }))
    notes.push_back(say("spectral.given_note"));
  if (!spectrum.of_displacements) notes.push_back(say("screening.note"));
  text +=
      all_gaps_text(gap_names(loaded.problem), c.code, spectral_story(c, loaded.problem, spectral), notes, say, peaks);
  if (!c.code.rules.empty() && !spectrum.of_displacements)
    text += wrapped(say(spectrum.reduction.empty() ? "cli.unreduced" : "cli.reduced")) + "\n";
  print(fitted(text));
}

/// The gaps over all records of a study.
/// @param story what is to be said of it
std::string study_text(const GapStudy& study, const Story& story, const Words& say) {
  std::string text = study.title.empty() ? "" : study.title + "\n";
  if (study.suite) text += suite_line(*study.suite, say) + "\n";
  if (study.at) {
    text += say("cli.scaled_records",
                {{"value", number(*study.at)}, {"unit", study.intensity_unit}, {"intensity", study.intensity}}) +
            "\n";
  } else if (!study.intensity.empty()) {
    text += say("cli.unscaled_records", {{"intensity", study.intensity}}) + "\n";
  }
  std::vector<std::string> names;
  for (const GapStudy::Between& gap : study.gaps) names.push_back(gap.name);
  text += "\n" + story_text(names, story, say, Told::all);
  text += "\n" + wrapped(say(study.suite ? "suite.note" : "cli.gap_study_note")) + "\n";
  if (study.in_plan) text += wrapped(say("cli.gap_study_in_plan")) + "\n";
  if (!study.code.rules.empty()) text += wrapped(say("cli.gap_study_codes")) + "\n";
  return text;
}

void tell_study(const GapArguments& arguments, const GapStudy& study) {
  print(arguments.json ? gap_study_json(study, version())
                       : fitted(study_text(study, gap_study_story(study), Words(arguments.language))));
  if (!study.is_whole()) throw Failure(exit_other, "");
}

/// Of a suite with what happens under its records, as bentur run tells it.
void tell_suite(const GapArguments& arguments, const Loaded& loaded) {
  const SuiteRun run = run_records(loaded, true, arguments.language);
  const GapStudy study = run.is_whole() ? gaps_over_records(loaded, arguments.file, arguments.language) : GapStudy();
  if (arguments.json) {
    print(gap_study_json(study, version(), suite_said_json(run, study)));
  } else {
    Story story = suite_story(run, study);
    std::erase_if(story.tables, [](const StoryTable& one) { return one.kind == "suite_runs"; });
    print(fitted(study_text(study, story, Words(arguments.language))));
  }
  if (!run.is_whole() || !study.is_whole()) throw Failure(exit_other, "");
}

void run_study(const GapArguments& arguments) {
  Diagnostics diagnostics;
  std::optional<GapStudy> study;
  try {
    const StopOnSignal stop;
    Progress progress("of the records");
    const auto goes_on = [&](double fraction) {
      progress.show(fraction);
      return !StopOnSignal::asked();
    };
    study = gap_study(arguments.file, arguments.at, goes_on, diagnostics);
  } catch (const std::runtime_error& error) {
    throw Failure(exit_numbers_failed,
                  error_words(std::string("the numbers failed: ") + error.what(), arguments.language));
  }
  if (!study) throw Failure(diagnostics, arguments.language);
  tell_study(arguments, *study);
}

/// What rules ask from heights alone.
void run_rules(const GapArguments& arguments) {
  if (is_study(arguments.file)) {
    throw Failure(exit_bad_input, error_words("bentur gap: --rules is for a case", arguments.language));
  }
  if (arguments.at)
    throw Failure(exit_bad_input, error_words("bentur gap: --at is for a study with [ida]", arguments.language));
  if (arguments.record) {
    throw Failure(exit_bad_input,
                  error_words("bentur gap: --record is for simulated gaps, not for --rules", arguments.language));
  }
  const Words say(arguments.language);
  const Loaded loaded = load(arguments.file, arguments.language);
  const Case& c = loaded.c;
  if (arguments.json) {
    return print(with_problem(loaded, [&](const auto& problem) { return height_rules_json(c, problem, version()); }));
  }
  std::string text = c.title.empty() ? "" : c.title + "\n\n";
  const Story story = with_problem(loaded, [&](const auto& problem) { return height_rules_story(c, problem); });
  const std::vector<std::string> names = with_problem(loaded, [](const auto& problem) { return gap_names(problem); });
  if (!story.tables.empty()) text += tables_text(names, story, say) + "\n" + wrapped(say("cli.height_note")) + "\n";
  print(fitted(text + codes_note(c.code, say)));
}

void run(const GapArguments& arguments) {
  if (arguments.rules) return run_rules(arguments);
  if (is_study(arguments.file)) {
    if (arguments.record)
      throw Failure(exit_bad_input,
                    error_words("--record is for a case with excitation.kind = \"suite\"", arguments.language));
    return run_study(arguments);
  }
  if (arguments.at)
    throw Failure(exit_bad_input, error_words("bentur gap: --at is for a study with [ida]", arguments.language));
  const Words say(arguments.language);
  Loaded loaded = load(arguments.file, arguments.language);
  if (arguments.record) loaded = record_of(std::move(loaded), *arguments.record, arguments.language);
  if (loaded.c.excitation.suite) {
    return tell_suite(arguments, loaded);
  }
  if (loaded.c.excitation.spectrum) return run_spectrum(loaded, arguments.json, say);
  const std::string note = say(loaded.c.is_in_plan() ? "cli.plan_gap_note" : "cli.gap_note");
  print(with_run(loaded, arguments.language, [&](const auto& run) {
    if (arguments.json) return gap_json(run, version());
    return fitted(heading(run.c, say) + all_gaps_text(gap_names(run.problem), run.c.code, gap_story(run),
                                                      {note, say("screening.note")}, say));
  }));
}

}  // namespace

void add_gap_command(CLI::App& app) {
  auto arguments = std::make_shared<GapArguments>();
  CLI::App* command = app.add_subcommand("gap", "The gap that keeps the buildings apart, simulated and by the rules");
  command->add_option("FILE", arguments->file, "the case file (TOML), or a study: then over all of its records")
      ->required()
      ->check(not_empty());
  command->add_option("--at", arguments->at, "for a study with [ida] and levels: the intensity; default the highest")
      ->check(positive());
  command->add_flag("--rules", arguments->rules, "what rules of [code] ask from heights alone; nothing is computed");
  add_record(*command, arguments->record);
  command->add_flag("--json", arguments->json, "JSON instead of tables");
  add_language(*command, arguments->language);
  command->footer(
      "Example: bentur gap case.toml\n"
      "What codes ask from heights alone: bentur gap --rules case.toml\n"
      "Over the records of a study: bentur gap study.toml --at 0.5");
  command->callback([arguments] { run(*arguments); });
}

}  // namespace bentur::cli
