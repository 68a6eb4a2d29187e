#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <limits>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>

#include "arguments.h"
#include "bentur/io/results/result_json.h"
#include "bentur/model/gap/gap_outcome.h"
#include "bentur/model/gap/minimum_gap.h"
#include "bentur/model/gap/spectral_gap.h"
#include "bentur/study/gap/gap_study.h"
#include "commands.h"
#include "session.h"
#include "text/gap_study_text.h"
#include "text/table.h"

namespace bentur::cli {
namespace {

struct GapArguments {
  std::string file;
  std::optional<double> at;
  bool json = false;
};

std::string_view title_of(const CodeSeparation& code) { return find_code_rule(code.rule)->title; }

/// The rules whose gap is smaller than the simulated one at some point of a gap.
std::string rules_that_fall_short(const std::vector<PointSeparation>& points) {
  std::vector<std::string> names;
  const auto add = [&](std::string_view name, const auto& gap_of) {
    if (std::any_of(points.begin(), points.end(),
                    [&](const PointSeparation& p) { return gap_of(p) < p.simulated * (1 - 1e-9); })) {
      names.emplace_back(name);
    }
  };
  add("SRSS", [](const PointSeparation& p) { return p.srss; });
  add("DDC", [](const PointSeparation& p) { return p.ddc; });
  for (std::size_t i = 0; i < points.front().codes.size(); ++i) {
    add(title_of(points.front().codes[i]), [i](const PointSeparation& p) { return p.codes[i].gap; });
  }
  if (names.empty()) return {};
  const std::string last = names.back();
  names.pop_back();
  return names.empty() ? last : fmt::format("{} and {}", fmt::join(names, ", "), last);
}

/// The rules of the codes, each at the point where it asks for most over what is given.
std::string codes_text(const Problem& problem, const std::vector<PointSeparation>& points, const std::string& length) {
  std::vector<std::string> titles, clauses, wordings, marks;
  std::vector<double> gaps, elevations, lefts, rights;
  const double none = std::numeric_limits<double>::quiet_NaN();
  for (std::size_t i = 0; i < points.front().codes.size(); ++i) {
    const auto short_by = [&](const PointSeparation& s) {
      return s.codes[i].gap - problem.points[static_cast<std::size_t>(s.point)].width;
    };
    const auto most = std::max_element(points.begin(), points.end(),
                                       [&](const auto& a, const auto& b) { return short_by(a) < short_by(b); });
    const CodeSeparation& code = most->codes[i];
    titles.emplace_back(title_of(code));
    clauses.emplace_back(find_code_rule(code.rule)->clause);
    wordings.emplace_back(find_code_rule(code.rule)->wording);
    gaps.push_back(code.gap);
    elevations.push_back(problem.points[static_cast<std::size_t>(most->point)].elevation);
    lefts.push_back(code.to_left.value_or(none));
    rights.push_back(code.to_right.value_or(none));
    marks.emplace_back(short_by(*most) > 0 ? "too close" : "wide enough");
  }
  Table table;
  table.add("code", "", titles);
  table.add("clause", "", clauses);
  table.add("gap", length, gaps);
  table.add("level", length, elevations);
  table.add("given is", "", marks);
  table.add("left to line", length, lefts);
  table.add("right to line", length, rights);
  table.add("wording", "", wordings);
  return table.text();
}

/// What a user may want to know of the rules: those not shown and why, and what the numbers are worth.
std::string codes_note(const CodeSpec& code) {
  if (code.rules.empty()) {
    std::vector<std::string_view> titles;
    for (const CodeRule& rule : code_rules()) titles.push_back(rule.title);
    return fmt::format("\nRules of building codes appear when the case gives their factors in [code]:\n{}.\n",
                       fmt::join(titles, ", "));
  }
  std::vector<std::string> others;
  for (const CodeRule& rule : code_rules()) {
    if (std::any_of(code.rules.begin(), code.rules.end(), [&](const auto& given) { return given.rule == rule.name; })) {
      continue;
    }
    std::vector<std::string_view> keys;
    for (const CodeKey& key : rule.keys) {
      if (key.kind != CodeKey::Kind::flag) keys.push_back(key.name);
    }
    others.push_back(fmt::format("  code.{}: {}\n", rule.name, fmt::join(keys, ", ")));
  }
  std::string text =
      "\nCodes: the same peaks, amplified by the factors of [code]; they belong to displacements under a code's\n"
      "reduced design forces and are 1 where the ground motion is not reduced. To line: from a building to a\n"
      "property line. Wording: whether the clause itself was read; to check: as commonly cited. What each\n"
      "takes for u:\n";
  for (const CodeRuleSpec& given : code.rules) {
    const CodeRule& rule = *find_code_rule(given.rule);
    text += "  " + wrapped(fmt::format("{}: {}", rule.title, rule.assumes)) + "\n";
  }
  if (!others.empty()) {
    text += fmt::format("\nNot shown, because the case does not give what {} need{}:\n{}",
                        others.size() == 1 ? "this code" : "these codes", others.size() == 1 ? "s" : "",
                        fmt::join(others, ""));
  }
  return text;
}

const std::string watched_heading = "\nFloors that face their neighbour where no contact is modelled\n\n";

/// The floors that face a column, or a floor that no contact point is at.
std::string watched_text(const Problem& problem, const Response& response, Eigen::Index gap,
                         const GoverningLevel& governing, const std::string& length) {
  const std::vector<Eigen::Index> watched = gap_at(problem, gap).watched;
  std::vector<double> elevations, widths, simulated;
  std::vector<std::string> owners, faces, marks;
  for (auto i = watched.rbegin(); i != watched.rend(); ++i) {
    const WatchedFloor& floor = problem.watched[*i];
    elevations.push_back(floor.elevation);
    widths.push_back(floor.width);
    simulated.push_back(response.watched[*i].needed);
    owners.push_back(problem.buildings[static_cast<std::size_t>(floor.floor_of)].name);
    faces.emplace_back(floor.facing_floor ? "floor" : "column");
    marks.emplace_back(governing.watched == *i ? "◄ governs" : "");
  }
  Table table;
  table.add("level", length, elevations);
  table.add("floor of", "", owners);
  table.add("faces a", "", faces);
  table.add("given", length, widths);
  table.add("simulated", length, simulated);
  table.add("", "", marks);
  return watched_heading + table.text();
}

/// "A | B: too close. 0.191 m is needed at level 20 m, 0.05 m given: 0.141 m short".
std::string verdict_line(const Problem& problem, const Gap& gap, const GoverningLevel& level,
                         const std::string& length) {
  const bool is_short = level.is_short();
  return fmt::format("{}: {}. {} {} is needed at level {} {}, {} {} given{}\n", gap_name(problem, gap.left),
                     is_short ? "too close" : "wide enough", number(level.needed), length, number(level.elevation),
                     length, number(level.width), length,
                     is_short ? fmt::format(": {} {} short", number(level.needed - level.width), length) : "");
}

std::string gap_text(const RunResults& run, const Gap& gap, const std::vector<PointSeparation>& all) {
  const Problem& problem = run.problem;
  const std::string& length = run.c.units.length;
  std::vector<PointSeparation> points;  // as the buildings stand: highest first
  for (auto i = gap.points.rbegin(); i != gap.points.rend(); ++i) points.push_back(all[*i]);
  const auto point_of = [&](const PointSeparation& s) -> const ContactPoint& {
    return problem.points[static_cast<std::size_t>(s.point)];
  };
  const GoverningLevel governing = governing_level(problem, run.response, gap.left);
  std::string text = verdict_line(problem, gap, governing, length);
  if (governing.watched) {
    const WatchedFloor& floor = problem.watched[*governing.watched];
    text += fmt::format("  There {} faces {}, and no contact is modelled.\n", floor_text(problem, floor),
                        faced_text(problem, floor));
  }
  std::vector<double> elevations, widths, simulated, abs, srss, ddc;
  std::vector<std::string> marks;
  for (const PointSeparation& s : points) {
    elevations.push_back(point_of(s).elevation);
    widths.push_back(point_of(s).width);
    simulated.push_back(s.simulated);
    abs.push_back(s.abs);
    srss.push_back(s.srss);
    ddc.push_back(s.ddc);
    marks.push_back(!governing.watched && point_of(s).elevation == governing.elevation ? "◄ governs" : "");
  }
  Table table;
  table.add("level", length, elevations);
  table.add("given", length, widths);
  table.add("simulated", length, simulated);
  table.add("ABS", length, abs);
  table.add("SRSS", length, srss);
  table.add("DDC", length, ddc);
  table.add("", "", marks);
  if (!points.empty()) text += "\n" + table.text();
  if (!gap.watched.empty()) text += watched_text(problem, run.response, gap.left, governing, length);
  if (points.empty())
    return text + "  No floors meet here: the rules, which compare floors that do, have nothing to say.\n";
  if (!points.front().codes.empty()) text += "\n" + codes_text(problem, points, length);
  const std::string unsafe = rules_that_fall_short(points);
  if (!unsafe.empty()) {
    text += fmt::format("  {} would be too small here.\n", unsafe);
  }
  return text;
}

/// "12.5", and nothing where there is no limit.
std::string limit_text(const std::optional<double>& limit) { return limit ? number(*limit) : "–"; }

/// What the rules of thumb say of how the neighbours stand; empty where one of them is a wall.
std::string screening_text(const Case& c, const Problem& problem, Eigen::Index gap) {
  const std::vector<ScreeningFinding> findings = screening(problem, gap, c.screening, c.units);
  if (findings.empty()) return {};
  std::vector<std::string> titles, units, values, limits, verdicts, sources;
  for (const ScreeningFinding& found : findings) {
    const bool known = found.verdict != ScreeningFinding::Verdict::needs_seismicity;
    titles.emplace_back(found.rule->title);
    units.emplace_back(found.rule->unit == "length" ? c.units.length : std::string(found.rule->unit));
    values.emplace_back(!found.rule->yes_or_no ? number(found.value) : !known ? "–" : found.value > 0 ? "yes" : "no");
    limits.emplace_back(limit_text(found.limit));
    verdicts.emplace_back(known ? verdict_text(found.verdict) : "needs seismicity");
    sources.emplace_back(
        found.rule->wording == "ours" ? "ours" : found.rule->source.substr(0, found.rule->source.find_first_of(",(")));
  }
  Table table;
  table.add("screening", "", titles);
  table.add("value", "", values);
  table.add("limit", "", limits);
  table.add("unit", "", units);
  table.add("verdict", "", verdicts);
  table.add("source", "", sources);
  return "\n" + table.text();
}

const char* const screening_note =
    "\nScreening: how the neighbours stand, before anything is computed. The rules of FEMA P-154 (2015,\n"
    "adjacency) and ASCE 41-17 (Tier 1, adjacent buildings) are by memory: check the text. Pounding is to\n"
    "be scored where the gap is too small for the storeys and one of the three rules above it asks for\n"
    "attention.\n";

/// Peak displacements of one building by both combinations, highest first.
std::string peaks_text(const Building& building, const SpectralPeaks& peaks, const std::string& length) {
  if (building.is_rigid()) return building.name + ": moves with the ground\n";
  std::vector<double> elevations, srss, cqc;
  for (Eigen::Index floor = building.model.floors() - 1; floor >= 0; --floor) {
    elevations.push_back(building.model.elevations[floor]);
    srss.push_back(peaks.srss(floor));
    cqc.push_back(peaks.cqc(floor));
  }
  Table table;
  table.add("level", length, elevations);
  table.add("SRSS", length, srss);
  table.add("CQC", length, cqc);
  const std::string elastic = building.can_yield() ? " (elastic, with its initial stiffness)" : "";
  return fmt::format("Peak displacements of {}{}\n\n{}", building.name, elastic, table.text());
}

std::string spectral_text(const Case& c, const Problem& problem, const SpectralGaps& spectral, const Gap& gap) {
  const std::string& length = c.units.length;
  std::vector<PointSeparation> points;  // highest first
  std::vector<double> elevations, widths, differences, abs, srss, ddc;
  for (auto i = gap.points.rbegin(); i != gap.points.rend(); ++i) {
    const ContactPoint& point = problem.points[*i];
    const PointSeparation& s = spectral.points[*i];
    points.push_back(s);
    elevations.push_back(point.elevation);
    widths.push_back(point.width);
    differences.push_back(s.simulated);
    abs.push_back(s.abs);
    srss.push_back(s.srss);
    ddc.push_back(s.ddc);
  }
  std::vector<double> watched_elevations, watched_widths, watched_differences;
  std::vector<std::string> owners, faces;
  for (auto i = gap.watched.rbegin(); i != gap.watched.rend(); ++i) {
    const WatchedFloor& floor = problem.watched[*i];
    watched_elevations.push_back(floor.elevation);
    watched_widths.push_back(floor.width);
    watched_differences.push_back(spectral.watched[*i]);
    owners.push_back(problem.buildings[static_cast<std::size_t>(floor.floor_of)].name);
    faces.emplace_back(floor.facing_floor ? "floor" : "column");
  }
  std::string text = gap_name(problem, gap.left) + ": no floors face one another\n";
  if (const auto worst = governing_level(problem, spectral, gap)) text = verdict_line(problem, gap, *worst, length);
  if (!points.empty()) {
    Table table;
    table.add("level", length, elevations);
    table.add("given", length, widths);
    table.add("difference", length, differences);
    table.add("ABS", length, abs);
    table.add("SRSS", length, srss);
    table.add("DDC", length, ddc);
    text += "\n" + table.text();
  }
  if (!owners.empty()) {
    Table table;
    table.add("level", length, watched_elevations);
    table.add("floor of", "", owners);
    table.add("faces a", "", faces);
    table.add("given", length, watched_widths);
    table.add("difference", length, watched_differences);
    text += watched_heading + table.text();
  }
  if (!points.empty() && !points.front().codes.empty()) text += "\n" + codes_text(problem, points, length);
  return text + screening_text(c, problem, gap.left);
}

void run_spectrum(const Loaded& loaded, bool json) {
  const Case& c = loaded.c;
  const SpectrumSpec& spectrum = *c.excitation.spectrum;
  const SpectralGaps spectral = spectral_gaps(loaded.problem, spectrum, c.code, c.units);
  if (json) {
    print(spectral_gap_json(c, loaded.problem, spectral, BENTUR_VERSION));
    return;
  }
  std::string text = c.title.empty() ? "" : c.title + "\n";
  text += excitation_line(c) + "\n";
  for (std::size_t b = 0; b < loaded.problem.buildings.size(); ++b) {
    text += "\n" + peaks_text(loaded.problem.buildings[b], spectral.peaks[b], c.units.length);
  }
  for (const Gap& gap : gaps_of(loaded.problem)) text += "\n" + spectral_text(c, loaded.problem, spectral, gap);
  text += fmt::format(
      "\nDifference: the peak of left minus right over the modes of both buildings by {0}. ABS, SRSS, DDC:\n"
      "sum, root of squares and double-difference combination of their peaks by {0} at that level.\n"
      "All are means: about half of the ground motions of this spectrum need more. Buildings are elastic.\n",
      spectrum.combination == ModalCombination::cqc ? "CQC" : "SRSS");
  text += screening_note + codes_note(c.code);
  if (!c.code.rules.empty()) {
    text += spectrum.reduction.empty()
                ? "The spectrum is taken as it is; excitation.reduction divides what the codes amplify.\n"
                : "What the codes amplify is the peaks divided by excitation.reduction.\n";
  }
  print(fitted(text));
}

void run_study(const GapArguments& arguments) {
  Diagnostics diagnostics;
  std::optional<GapStudy> study;
  try {
    Progress progress("of the records");
    study = gap_study(
        arguments.file, arguments.at, [&](double fraction) { progress.show(fraction); }, diagnostics);
  } catch (const std::runtime_error& error) {
    throw Failure(exit_numbers_failed, std::string("the numbers failed: ") + error.what());
  }
  if (!study) throw Failure(diagnostics);
  print(arguments.json ? gap_study_json(*study, BENTUR_VERSION) : fitted(gap_study_text(*study)));
}

void run(const GapArguments& arguments) {
  if (is_study(arguments.file)) return run_study(arguments);
  if (arguments.at) throw Failure(exit_bad_input, "bentur gap: --at is for a study with [ida]");
  const Loaded loaded = load(arguments.file, Purpose::no_run);
  if (loaded.c.excitation.spectrum) return run_spectrum(loaded, arguments.json);
  const RunResults results = simulate(loaded, 0, true);
  const std::vector<PointSeparation> needed =
      separations(results.problem, results.response, results.c.code, results.c.units);
  if (arguments.json) {
    print(gap_json(results, needed, BENTUR_VERSION));
    return;
  }
  std::string text = loaded.c.title.empty() ? "" : loaded.c.title + "\n";
  text += excitation_line(loaded.c) + "\n";
  for (const Gap& gap : gaps_of(results.problem)) {
    text += "\n" + gap_text(results, gap, needed) + screening_text(results.c, results.problem, gap.left);
  }
  text +=
      "\nSimulated: the buildings moving freely. ABS, SRSS, DDC: sum, root of squares and double-difference\n"
      "combination of their peak displacements at that level.\n";
  text += screening_note + codes_note(loaded.c.code);
  print(fitted(text));
}

}  // namespace

void add_gap_command(CLI::App& app) {
  auto arguments = std::make_shared<GapArguments>();
  CLI::App* command = app.add_subcommand("gap", "The gap that keeps the buildings apart, simulated and by the rules");
  command->add_option("FILE", arguments->file, "the case file (TOML), or a study: then over all of its records")
      ->required()
      ->check(not_empty());
  command->add_option("--at", arguments->at, "for a study with [ida]: the intensity; default its highest level")
      ->check(positive());
  command->add_flag("--json", arguments->json, "JSON instead of tables");
  command->footer(
      "Example: bentur gap case.toml\n"
      "Over the records of a study: bentur gap study.toml --at 0.5");
  command->callback([arguments] { run(*arguments); });
}

}  // namespace bentur::cli
