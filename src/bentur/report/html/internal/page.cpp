#include "bentur/report/html/internal/page.h"

#include <fmt/format.h>

#include <cctype>
#include <cstddef>
#include <string>
#include <string_view>

#include "bentur/core/errors.h"
#include "bentur/io/file_identity.h"
#include "bentur/report/figures/figure.h"
#include "bentur/report/html/internal/assets.h"
#include "bentur/report/html/internal/motion_data.h"
#include "bentur/report/utf8.h"

namespace bentur::html {
namespace {

/// What a policy calls this text, which alone it lets in.
std::string hash_source(const std::string& text) {
  const std::string digits = sha256(text);
  std::string bytes;
  for (std::size_t i = 0; i < digits.size(); i += 2) {
    bytes += static_cast<char>(std::stoi(digits.substr(i, 2), nullptr, 16));
  }
  return "'sha256-" + base64(bytes) + "'";
}

/// A text between quotes of a style sheet: letters and digits, all else as references to its code point.
std::string css_text(std::string_view text) {
  std::string result;
  for (const auto& [bytes, code] : characters(text)) {
    const bool plain = code < 0x80 && std::isalnum(static_cast<unsigned char>(bytes[0])) != 0;
    result += plain ? std::string(bytes) : fmt::format("\\{:x} ", code < 0 ? 0xFFFD : code);
  }
  return result;
}

/// The list of sections between the header and the main part, which holds them.
Html markup_of(const Words& say, const PageBody& body) {
  Html links, sections;
  for (const auto& [id, heading, content, behind] : body.sections) {
    if (content.str().empty()) continue;
    links += element("li", element("a", heading, "href=\"#" + id + "\""));
    sections +=
        element("section", element("h2", heading) + Html::markup("\n") + content + behind, "id=\"" + id + "\"") +
        Html::markup("\n");
  }
  const std::string on = body.running_head.empty() ? "screen" : "contents";
  const Html list = element("nav", element("ol", links),
                            "class=\"" + on + "\" aria-label=\"" + Html::text(say("report.contents")).str() + "\"");
  Html unfold;
  if (sections.str().find("class=\"appendix\"") != std::string::npos) {
    unfold =
        element("p", element("button", say("appendix.unfold"), "type=\"button\" id=\"unfold\""), "class=\"screen\"");
  }
  return element("header", body.header) + list + unfold + element("main", sections) + body.footer;
}

}  // namespace

std::string_view asset(std::string_view name) {
  for (const EmbeddedFile& file : report_assets()) {
    if (file.name == name) return file.content;
  }
  throw InvalidParameter("asset", std::string(name), "is not built in");
}

std::string page(const Words& say, const std::string& title, const PageBody& body, bool with_script) {
  const std::string style = std::string(asset("report.css")) + page_style() + "\n@page { @top-left { content: \"" +
                            css_text(body.running_head.empty() ? title : body.running_head) + "\"; } }\n";
  std::string script;
  if (with_script) {
    for (const char* const name : {"samples.js", "row.js", "plan.js", "motion.js", "report.js"}) {
      script += asset(name);
    }
  }
  const std::string head =
      "<meta charset=\"utf-8\">\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n" +
      std::string(report_mark) +
      "\">\n"
      "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; script-src " +
      (with_script ? hash_source(script) : "'none'") + "; style-src " + hash_source(style) +
      "; img-src data:; base-uri 'none'; form-action 'none'\">\n";
  Html content = markup_of(say, body);
  if (with_script) content += element("script", Html::markup(script));
  const Html document =
      element("head", Html::markup(head) + element("title", title) + element("style", Html::markup(style))) +
      Html::markup("\n") + element("body", content, body.running_head.empty() ? "" : "class=\"hand-in\"");
  return "<!DOCTYPE html>\n" + element("html", document, "lang=\"" + say.language() + "\"").str() + "\n";
}

PageSection figures_section(const Words& say, const std::vector<PageFigure>& figures) {
  if (figures.empty()) return {"figures", say("heading.figures"), {}};
  Html content;
  for (std::size_t i = 0; i < figures.size(); ++i) {
    const std::string caption = say("figure.number", {{"n", std::to_string(i + 1)}, {"caption", figures[i].caption}});
    // On a phone a wide one keeps its letters and is moved, by keys too.
    const Html drawing = Html::markup(figures[i].svg);
    Html shown = figures[i].wide ? element("div", drawing, "class=\"wide\" tabindex=\"0\"") : drawing;
    if (!figures[i].slim.empty()) shown += element("div", Html::markup(figures[i].slim), "class=\"slim\"");
    content += element("figure", shown + element("figcaption", caption),
                       figures[i].is_parted ? "class=\"broad parted\""
                       : figures[i].wide    ? "class=\"broad\""
                                            : "") +
               Html::markup("\n");
  }
  return {"figures", say("heading.figures"), element("div", content, "class=\"figures\"")};
}

}  // namespace bentur::html
