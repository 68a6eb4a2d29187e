#include "bentur/model/story/hand_in.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iterator>
#include <utility>

#include "bentur/core/not_known.h"
#include "bentur/core/number_text.h"
#include "bentur/excitation/motion_measures.h"
#include "bentur/io/schema/case_keys.h"
#include "bentur/report/html/internal/echo.h"
#include "bentur/report/html/internal/motion_data.h"
#include "bentur/report/html/internal/sections.h"

namespace bentur::html {
namespace {

/// What [project] says of a key; empty where it says nothing.
std::string said_of(const ProjectSpec& project, const std::string& key) {
  return key == "name"       ? project.name
         : key == "number"   ? project.number
         : key == "engineer" ? project.engineer
         : key == "date"     ? project.date
         : key == "revision" ? project.revision
                             : project.code_basis;
}

/// As an image, within which a browser runs nothing and loads nothing.
Html logo_of(const ProjectSpec& project, const Words& say) {
  if (project.logo.empty()) return {};
  const std::string label = project.engineer.empty() ? say("project.logo") : project.engineer;
  return Html::markup("<img class=\"logo\" src=\"data:" + project.logo_type + ";base64," + base64(project.logo) +
                      "\" alt=\"" + Html::text(label).str() + "\">");
}

Rows rows_of(const ProjectSpec& project, const Words& say) {
  Rows rows;
  for (const char* const key : {"name", "number", "engineer", "date", "revision", "code_basis"}) {
    const std::string value = said_of(project, key);
    if (!value.empty()) rows.emplace_back(label_text(project_keys().at(key).label, say), value);
  }
  return rows;
}

/// As the case names it, but for folders of the machine.
std::string shown_file(const std::string& file) {
  const std::filesystem::path path(file);
  return path.is_absolute() ? path.filename().string() : file;
}

Html list_of(const std::vector<std::string>& texts) {
  Html items;
  for (const std::string& text : texts) items += element("li", text);
  return texts.empty() ? Html() : element("ul", items);
}

std::vector<std::string> texts_of(const std::vector<Statement>& statements, const Words& say) {
  std::vector<std::string> texts;
  for (const SaidStatement& one : said(statements, say)) texts.push_back(one.text);
  return texts;
}

PageSection assumptions_section(const std::optional<ProjectSpec>& project, const Words& say, const HandIn& told) {
  Html content;
  if (project && !project->assumptions.empty()) {
    content += element("p", say("assumption.own")) + list_of(project->assumptions) +
               element("p", say("assumption.of_program"));
  }
  return {"assumptions", say("heading.assumptions"), content + list_of(texts_of(told.assumptions, say))};
}

PageSection checks_section(const Words& say, const HandIn& told) {
  if (told.checks.columns.empty()) return {"checks", say("heading.checks"), {}};
  return {"checks", say("heading.checks"),
          table_of(said(told.checks, say), HtmlTable::OnTelephone::checks) +
              element("p", say("check.note"), "class=\"note\"")};
}

PageSection unchecked_section(const Words& say, const HandIn& told) {
  return {"unchecked", say("heading.unchecked"), list_of(texts_of(told.unchecked, say))};
}

}  // namespace

Html title_block(const std::optional<ProjectSpec>& given, const std::string& title, const std::string& made_by,
                 const Words& say, const Rows& identity) {
  const ProjectSpec project = given.value_or(ProjectSpec{});
  const Html heading = element("h1", title), logo = logo_of(project, say);
  const Html top = logo.str().empty() ? heading : element("div", heading + logo, "class=\"top\"");
  Rows rows = rows_of(project, say);
  rows.emplace_back(say("report.report"), made_by);
  rows.insert(rows.end(), identity.begin(), identity.end());
  return top + facts(rows);
}

Html title_block(const Case& c, const std::string& title, const std::string& made_by, const Words& say) {
  Rows identity;
  const auto add = [&](const char* key, const std::string& file, const std::string& hash) {
    if (hash.empty()) return;
    identity.emplace_back(say(key), shown_file(file) + ", SHA-256 " + hash.substr(0, 16) + "…");
  };
  if (c.source) add("report.case", c.source->file, c.source->sha256);
  for (const ExcitationSpec* const one : c.excitations()) {
    if (one->record) add("report.record", one->record->file, one->record->sha256);
  }
  return title_block(c.project, title, made_by, say, identity);
}

std::string running_head(const std::optional<ProjectSpec>& project, const std::string& title) {
  if (!project) return title;
  std::string head;
  for (const std::string& part : {project->name.empty() ? title : project->name, project->number, project->revision}) {
    if (!part.empty()) head += (head.empty() ? "" : " · ") + part;
  }
  return head;
}

PageSection records_section(const std::vector<AppliedRecord>& records, const Units& units, const Words& say) {
  std::vector<std::string> files, ways, hashes;
  std::vector<double> read, factors, applied, velocities, durations, steps, lengths;
  for (const AppliedRecord& one : records) {
    const std::optional<RecordEcho>& record = one.excitation.record;
    if (!record) continue;
    const MotionMeasures measures = motion_measures(one.excitation.motion);
    const double peak = record->pga_read * acceleration_factor(record->unit, units);
    const auto known = [](double value) { return value > 0 ? value : not_known; };
    files.push_back(shown_file(record->file));
    ways.push_back(say(record->reversed ? "records.reversed" : "records.as_recorded"));
    read.push_back(peak / units.gravity);
    factors.push_back(peak > 0 ? one.pga / peak : not_known);
    applied.push_back(one.pga / units.gravity);
    velocities.push_back(known(measures.pgv));
    durations.push_back(known(measures.significant_duration));
    steps.push_back(record->time_step);
    lengths.push_back(record->duration);
    hashes.push_back(record->sha256.empty() ? "–" : record->sha256.substr(0, 16) + "…");
  }
  if (files.empty()) return {"records", say("heading.records"), {}};
  const auto any = [](const std::vector<double>& values) {
    return std::any_of(values.begin(), values.end(), [](double value) { return !std::isnan(value); });
  };
  HtmlTable table;
  table.add(say("records.file"), "", files, false);
  table.add(say("records.way"), "", ways, false);
  table.add(say("records.read"), "g", read);
  table.add(say("records.factor"), "", factors);
  table.add(say("records.applied"), "g", applied);
  if (any(velocities)) table.add("PGV", units.length + "/s", velocities);
  if (any(durations)) table.add("D5–95", "s", durations);
  table.add(say("records.step"), "s", steps);
  table.add(say("records.length"), "s", lengths);
  table.add("SHA-256", "", hashes, false);
  return {"records", say("heading.records"), table.called(say("records.table")).markup()};
}

std::vector<PageSection> in_order_of_codes(std::vector<PageSection> sections, PageSection records,
                                           const std::optional<ProjectSpec>& project, const Words& say,
                                           const HandIn& told) {
  std::vector<PageSection> ordered = {std::move(sections.front()), assumptions_section(project, say, told),
                                      std::move(sections.back()),  std::move(records),
                                      checks_section(say, told),   unchecked_section(say, told)};
  ordered.insert(ordered.end(), std::move_iterator(sections.begin() + 1), std::move_iterator(sections.end() - 1));
  return ordered;
}

}  // namespace bentur::html
