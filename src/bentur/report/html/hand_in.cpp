#include "bentur/model/story/hand_in.h"

#include <algorithm>
#include <cmath>

#include "bentur/core/number_text.h"
#include "bentur/excitation/motion_measures.h"
#include "bentur/io/markup/safe_markup.h"
#include "bentur/io/schema/case_keys.h"
#include "bentur/report/html/internal/echo.h"
#include "bentur/report/html/internal/sections.h"

namespace bentur::html {
namespace {

/// What [project] says of a word of a template; empty where it says nothing.
std::string said_of(const ProjectSpec& project, const std::string& word) {
  return word == "name"         ? project.name
         : word == "number"     ? project.number
         : word == "engineer"   ? project.engineer
         : word == "date"       ? project.date
         : word == "revision"   ? project.revision
         : word == "code_basis" ? project.code_basis
                                : "";
}

Html logo_of(const ProjectSpec& project, const Words& say) {
  if (project.logo.empty()) return {};
  const std::string label = project.engineer.empty() ? say("project.logo") : project.engineer;
  return element("span", Html::markup(project.logo),
                 "class=\"logo\" role=\"img\" aria-label=\"" + Html::text(label).str() + "\"");
}

/// What [project] says that the head has not said already.
Html rest_of(const ProjectSpec& project, const std::string& head, const Words& say) {
  Rows rows;
  for (const char* const key : {"name", "number", "engineer", "date", "revision", "code_basis"}) {
    const std::string value = said_of(project, key);
    if (value.empty() || head.find("{" + std::string(key) + "}") != std::string::npos) continue;
    rows.emplace_back(label_text(project_keys().at(key).label, say), value);
  }
  return rows.empty() ? Html() : facts(rows);
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

}  // namespace

Html identity(const std::optional<CaseSource>& source, const std::vector<const RecordEcho*>& records,
              const Words& say) {
  Html lines;
  const auto add = [&](const char* key, const std::string& file, const std::string& hash) {
    if (hash.empty()) return;
    lines += element("p", say(key, {{"file", file}, {"hash", hash.substr(0, 16) + "…"}}), "class=\"note\"");
  };
  if (source) add("report.identity", source->file, source->sha256);
  for (const RecordEcho* const record : records) add("report.record_identity", record->file, record->sha256);
  return lines;
}

Html title_block(const std::optional<ProjectSpec>& given, const std::string& file, const std::string& title,
                 const std::string& made_by, const ReportOptions& options) {
  const Words say(options.language);
  const ProjectSpec project = given.value_or(ProjectSpec{});
  const Html heading = element("h1", title), note = element("p", made_by, "class=\"note\"");
  if (options.head.empty()) {
    const Html logo = logo_of(project, say);
    const Html top = logo.str().empty() ? heading : element("div", heading + logo, "class=\"top\"");
    return top + rest_of(project, "", say) + note;
  }
  const std::string filled = filled_template(options.head, [&](const std::string& word) {
    if (word == "logo") return logo_of(project, say).str();
    const std::string value = word == "title"     ? title
                              : word == "file"    ? file
                              : word == "version" ? options.version
                                                  : said_of(project, word);
    return Html::text(value.empty() ? "–" : value).str();
  });
  const bool has_heading = options.head.find("<h1") != std::string::npos;
  return element("div", Html::markup(filled), "class=\"office\"") + (has_heading ? Html() : heading) +
         rest_of(project, options.head, say) + note;
}

Html title_block(const Report& report, const std::string& title, const std::string& made_by,
                 const ReportOptions& options) {
  const std::string file = report.c.source ? report.c.source->file : "";
  std::vector<const RecordEcho*> records;
  if (const auto& record = report.c.excitation.record) records.push_back(&*record);
  return title_block(report.c.project, file, title, made_by, options) + identity(report.c.source, records, report.say);
}

std::string running_head(const std::optional<ProjectSpec>& project, const std::string& title) {
  if (!project) return title;
  std::string head;
  for (const std::string& part : {project->name.empty() ? title : project->name, project->number, project->revision}) {
    if (!part.empty()) head += (head.empty() ? "" : " · ") + part;
  }
  return head;
}

PageSection assumptions_section(const Report& report, const HandIn& told) {
  const Words& say = report.say;
  Html content;
  if (report.c.project && !report.c.project->assumptions.empty()) {
    content += element("p", say("assumption.own")) + list_of(report.c.project->assumptions) +
               element("p", say("assumption.of_program"));
  }
  return {"assumptions", say("heading.assumptions"), content + list_of(texts_of(told.assumptions, say))};
}

PageSection records_section(const Report& report) {
  const Words& say = report.say;
  const std::optional<RecordEcho>& record = report.c.excitation.record;
  if (!record) return {"records", say("heading.records"), {}};
  const MotionMeasures measures = motion_measures(report.c.excitation.motion);
  const double gravity = report.c.units.gravity, pga = applied_pga(report.c);
  const double read = record->pga_read * acceleration_factor(record->unit, report.c.units);
  HtmlTable table;
  table.add(say("records.file"), "", {record->file}, false);
  table.add(say("records.way"), "", {say(record->reversed ? "records.reversed" : "records.as_given")}, false);
  table.add(say("records.read"), "g", std::vector<double>{read / gravity});
  table.add(say("records.factor"), "", std::vector<double>{read > 0 ? pga / read : std::nan("")});
  table.add(say("records.applied"), "g", std::vector<double>{pga / gravity});
  if (measures.pgv > 0) table.add("PGV", report.c.units.length + "/s", std::vector<double>{measures.pgv});
  if (measures.significant_duration > 0) {
    table.add("D5–95", "s", std::vector<double>{measures.significant_duration});
  }
  table.add(say("records.step"), "s", std::vector<double>{record->time_step});
  table.add(say("records.length"), "s", std::vector<double>{record->duration});
  table.add("SHA-256", "", {record->sha256.empty() ? "–" : record->sha256.substr(0, 16) + "…"}, false);
  return {"records", say("heading.records"), table.markup()};
}

PageSection checks_section(const Report& report, const HandIn& told) {
  const Words& say = report.say;
  if (told.checks.columns.empty()) return {"checks", say("heading.checks"), {}};
  return {"checks", say("heading.checks"),
          table_of(said(told.checks, say)) + element("p", say("check.note"), "class=\"note\"")};
}

PageSection unchecked_section(const Report& report, const HandIn& told) {
  const Words& say = report.say;
  return {"unchecked", say("heading.unchecked"), list_of(texts_of(told.unchecked, say))};
}

}  // namespace bentur::html
