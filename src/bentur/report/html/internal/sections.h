#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "bentur/model/case.h"
#include "bentur/model/gap/minimum_gap.h"
#include "bentur/model/judgement/judged_gaps.h"
#include "bentur/model/quantities.h"
#include "bentur/model/story/hand_in.h"
#include "bentur/pounding/response.h"
#include "bentur/report/html/internal/each_of.h"
#include "bentur/report/html/internal/markup.h"
#include "bentur/report/html/page_parts.h"
#include "bentur/report/html/report.h"
#include "bentur/report/kinds/kinds.h"
#include "bentur/report/run_tables.h"
#include "bentur/report/story_text.h"
#include "bentur/report/words.h"
#include "bentur/study/sensitivity/sensitivity.h"

namespace bentur::html {

/// Everything that the sections of a report are written from.
struct Report {
  RunView run;
  const Case& c;
  const Problem& problem;
  const Response& response;
  const Words& say;
  Story story = {};                    ///< what is to be said
  std::vector<JudgedGap> judged = {};  ///< per gap
  bool to_hand_in = false;             ///< with what a report has that is handed in

  /// The buildings as given are known; not so where the run comes from result files (files/result_reading.h).
  [[nodiscard]] bool from_case() const { return !c.buildings.empty(); }
};

/// Of a long list; report.css hides the others there.
constexpr std::size_t rows_in_print = 100, impacts_in_print = 60;

/// For each gap: whether, where, how often and how hard the buildings collide, and the gap they need.
[[nodiscard]] PageSection verdict_section(const Report& report);
/// Remarks on unusual numbers, and what the model leaves out.
[[nodiscard]] PageSection remarks_section(const Report& report);

/// The gap needed at each level, simulated and by every rule. @param tables gap_tables_of() a run
[[nodiscard]] PageSection gap_section(const std::vector<std::string>& gaps, const std::vector<StoryTable>& tables,
                                      const Case& c, const Words& say);

/// Contact totals per level and peaks per floor.
[[nodiscard]] PageSection peaks_section(const Report& report, const RunTables& tables);
[[nodiscard]] PageSection peaks_section(const PlanRun& run, const RunTables& tables, const Story& story,
                                        const Words& say);

/// How the peaks change with the numbers of the case, which have the words of its keys: sentences, a picture, tables;
/// empty where none were found.
[[nodiscard]] PageSection sensitivity_section(const std::optional<Sensitivity>& found, const Case& c, const Words& say,
                                              const std::string& language);

/// Which storeys yielded, with and without contact, drawn on the buildings; nothing where none can yield.
[[nodiscard]] PageSection damage_section(const Report& report);

/// Columns that floors strike, with and without contact, and how that compares with what they bear; nothing where
/// floors meet at every contact point.
[[nodiscard]] PageSection columns_section(const RunView& run, const RunTable& struck, const Words& say);
[[nodiscard]] PageSection columns_section(const PlanRun& run, const RunTable& struck, const Words& say);

/// The impacts of a run, listed ones alone, to be sorted and downloaded.
[[nodiscard]] PageSection impacts_section(const RunOutcome& outcome, const RunTable& listed, const Words& say);

/// The input with its units, the ground motion, the modes.
[[nodiscard]] PageSection input_section(const Report& report);
/// The same of buildings in plan. @param events of the run; of a suite none is reported
[[nodiscard]] PageSection input_section(const Case& c, const PlanProblem& problem, long events, const Words& say);

// hand_in.cpp: of reports to hand in.

/// The title block: title, logo, and a line each of what [project] says, what made the report, the case and its records
/// by their hashes, so that it can be distinguished from that of another file of the same name.
[[nodiscard]] Html title_block(const Case& c, const std::string& title, const std::string& made_by, const Words& say);
/// The same of a study.
[[nodiscard]] Html title_block(const std::optional<ProjectSpec>& project, const std::string& title,
                               const std::string& made_by, const Words& say, const Rows& identity = {});
/// What runs along the top of every printed page.
[[nodiscard]] std::string running_head(const std::optional<ProjectSpec>& project, const std::string& title);
/// Records that a case applies, with what is made of each; those that are none are left out.
struct AppliedRecord {
  const ExcitationSpec& excitation;
  double pga = 0;  ///< as applied [length/s²]
};
[[nodiscard]] PageSection records_section(const std::vector<AppliedRecord>& records, const Units& units,
                                          const Words& say);
/// A report's sections, the verdict first and the input last, with what one has that is handed in: assumptions, input,
/// records, checks in the order of codes and what was not checked before the rest. @param records may be empty
[[nodiscard]] std::vector<PageSection> in_order_of_codes(std::vector<PageSection> sections, PageSection records,
                                                         const std::optional<ProjectSpec>& project, const Words& say,
                                                         const HandIn& told);

/// Sections for a page that is no report; those without content are not among them.
[[nodiscard]] std::vector<PagePart> parts(const std::vector<PageSection>& sections);

// What the sections share.

/// A statement of the verdict as paragraphs: its badge where that is not `badge`, the one before, and its text.
[[nodiscard]] Html paragraphs(const SaidStatement& statement, std::string& badge);
/// What a verdict shows of a gap.
struct VerdictGap {
  std::string name, in_short;         ///< the latter before sentences
  const JudgedGap* judged = nullptr;  ///< for bars; nothing: none
};
struct Verdict {
  const Story& story;
  const Case& c;
  std::vector<VerdictGap> gaps = {};  ///< by their numbers in statements
  Html key = {};                      ///< of short names, below the table of gaps
  bool by_spectrum = false;
};
/// The outcome, gravest first, and bars at one scale; of several gaps a table, what is of each folded away.
[[nodiscard]] PageSection verdict_section(const Verdict& verdict, const Words& say);
/// Remarks of a story as a list, and what else is to be remarked below it. @param to_hand_in what is said of the model
/// stands elsewhere
[[nodiscard]] PageSection remarks_section(const Story& story, const Words& say, bool to_hand_in);
/// The opening figure below the verdict: over the whole width of a page, and for a narrow one. @param make it at a
/// width
[[nodiscard]] Html opening_figure(const std::function<Figure(const FigureOptions&)>& make, const std::string& caption,
                                  const std::string& language);
/// The hardest impacts, as many as a page lists, the hardest first.
[[nodiscard]] std::vector<Eigen::Index> hardest_impacts(const std::vector<Impact>& impacts);
/// impacts.csv for the script that saves it.
[[nodiscard]] Html csv_script(const std::string& csv);

/// A table in words. @param titles of the cells of its first column, for a pointer
/// @param in_sight rows that stay so on a telephone, where a list has others too
[[nodiscard]] Html table_of(const SaidTable& table, HtmlTable::OnTelephone form = HtmlTable::OnTelephone::as_fits,
                            std::vector<std::string> titles = {}, const std::vector<std::size_t>& in_sight = {});
/// Tables of gaps, each gap under its name and each table under its heading. @param gaps names of all
[[nodiscard]] Html gap_tables(const std::vector<std::string>& gaps, const std::vector<StoryTable>& tables,
                              const Words& say);

/// The attribute of a verdict's box.
[[nodiscard]] inline const char* verdict_class(bool pounds) {
  return pounds ? "class=\"verdict pounds\"" : "class=\"verdict clear\"";
}
/// "0.7262 cm", which no line break separates.
[[nodiscard]] std::string quantity(double value, const std::string& unit);
/// The same of a value in units of the case, of a form "F L", in the units that people are shown.
[[nodiscard]] std::string force_text(const ShownUnits& shown, double value, std::string_view form);
/// Whether buildings are called in short where names would take too much room: in rows.
[[nodiscard]] bool numbers_buildings(const Report& report);
/// "Model 1 | Model 2", or of a row what the buildings are called in short (scene/names.h): "1 | 2", "West | Middle".
[[nodiscard]] std::string short_gap_name(const Report& report, Eigen::Index gap);
/// "1 Bank, 2 Hotel, 3 Office", without names that end with their number.
[[nodiscard]] std::string numbered(const std::vector<std::string>& names);
/// The same of the buildings of a report, where numbers stand for their names.
[[nodiscard]] std::string building_key(const Report& report);
[[nodiscard]] std::string acceleration_unit(const Units& units);  ///< "cm/s²"
[[nodiscard]] std::string mass_unit(const Units& units);          ///< "t", "kgf·s²/cm"
/// A table of a run for a page.
[[nodiscard]] HtmlTable table_of(const RunTable& table);
/// Says, in place of the column of losses, that contact is elastic; nothing where it is not.
[[nodiscard]] Html elastic_note(const std::vector<PointSummary>& points, const Words& say);

/// Indices of the contact points of a gap, highest first.
[[nodiscard]] std::vector<Eigen::Index> points_of(const Problem& problem, Eigen::Index gap);

}  // namespace bentur::html
