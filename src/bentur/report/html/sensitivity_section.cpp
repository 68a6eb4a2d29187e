#include "bentur/report/html/internal/sections.h"
#include "bentur/report/kinds/sensitivity_figure.h"

namespace bentur::html {

PageSection sensitivity_section(const Sensitivity& found, const Words& say, const std::string& language) {
  const Story story = sensitivity_story(found);
  Html sentences;
  for (const SaidStatement& one : said(story.statements, say)) sentences += element("li", one.text);
  Html content = element("p", say("sensitivity.lead"), "class=\"lead\"") + element("ul", sentences);
  try {
    content += opening_figure([&](const FigureOptions& drawn) { return sensitivity_figure(found, drawn); },
                              say("figure.sensitivity"), language);
  } catch (const NoFigure&) {  // of buildings alone there is a table
  }
  for (const StoryTable& table : story.tables) {
    const SaidTable shown = said(table, say);
    content += element("h3", shown.heading) + table_of(shown);
  }
  content += element("p", say("sensitivity.note"), "class=\"note\"");
  return {"sensitivity", say("heading.sensitivity"), content};
}

}  // namespace bentur::html
