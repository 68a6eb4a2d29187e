#include "bentur/report/html/internal/page.h"

#include <fmt/format.h>

#include <cctype>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "bentur/core/errors.h"
#include "bentur/report/html/internal/assets.h"
#include "bentur/report/utf8.h"

namespace bentur::html {
namespace {

/// A figure's SVG without what only a file of its own has, and with names of its own among all figures of the page.
std::string inline_svg(const std::string& file, std::size_t number, const std::string& label) {
  const std::size_t start = file.find("<svg");
  if (start == std::string::npos) throw InvalidParameter("figures", std::to_string(number), "is no SVG");
  std::string svg = file.substr(start);
  for (const std::string name : {"title", "desc"}) {  // the caption says what it is, and who drew it is no tooltip
    for (std::size_t open = svg.find("<" + name + ">"); open != std::string::npos; open = svg.find("<" + name + ">")) {
      const std::size_t close = svg.find("</" + name + ">", open);
      if (close == std::string::npos) break;
      svg.erase(open, close + name.size() + 3 - open);
    }
  }
  svg.insert(4, " role=\"img\" aria-label=\"" + Html::text(label).str() + "\"");
  const std::string prefix = fmt::format("figure{}-", number);
  for (const std::string opening : {" id=\"", " id='", "href=\"#", "href='#", "url(#"}) {
    for (std::size_t at = svg.find(opening); at != std::string::npos; at = svg.find(opening, at)) {
      at += opening.size();
      svg.insert(at, prefix);
    }
  }
  return svg;
}

/// A number that an author of a case's text cannot foresee: it depends on all of the page (FNV-1a).
std::string nonce_of(const std::string& page) {
  std::uint64_t hash = 14695981039346656037ULL;
  for (const char c : page) hash = (hash ^ static_cast<unsigned char>(c)) * 1099511628211ULL;
  return fmt::format("{:016x}", hash);
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
  for (const auto& [id, heading, content] : body.sections) {
    if (content.str().empty()) continue;
    links += element("li", element("a", heading, "href=\"#" + id + "\""));
    sections += element("section", element("h2", heading) + Html::markup("\n") + content, "id=\"" + id + "\"") +
                Html::markup("\n");
  }
  const Html list = element("nav", element("ol", links),
                            "class=\"screen\" aria-label=\"" + Html::text(say("report.contents")).str() + "\"");
  return element("header", body.header) + list + element("main", sections) + body.footer;
}

}  // namespace

std::string_view asset(std::string_view name) {
  for (const EmbeddedFile& file : report_assets()) {
    if (file.name == name) return file.content;
  }
  throw InvalidParameter("asset", std::string(name), "is not built in");
}

std::string page(const Words& say, const std::string& title, const PageBody& body, bool with_script) {
  Html content = markup_of(say, body);
  const std::string nonce = nonce_of(content.str());
  const std::string head =
      "<meta charset=\"utf-8\">\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n" +
      std::string(report_mark) +
      "\">\n"
      "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; script-src 'nonce-" +
      nonce + "'; style-src 'unsafe-inline'; base-uri 'none'; form-action 'none'\">\n";
  if (with_script)
    content += element("script", Html::markup(std::string(asset("motion.js")) + std::string(asset("report.js"))),
                       "nonce=\"" + nonce + "\"");
  const Html document =
      element("head",
              Html::markup(head) + element("title", title) +
                  element("style", Html::markup(std::string(asset("report.css")) + "@page { @top-left { content: \"" +
                                                css_text(title) + "\"; } }\n"))) +
      Html::markup("\n") + element("body", content);
  return "<!DOCTYPE html>\n" + element("html", document, "lang=\"" + say.language() + "\"").str() + "\n";
}

PageSection figures_section(const Words& say, const std::vector<ReportFigure>& figures) {
  Html content;
  for (std::size_t i = 0; i < figures.size(); ++i) {
    const std::string caption = say("figure.number", {{"n", std::to_string(i + 1)}, {"caption", figures[i].caption}});
    content +=
        element("figure",
                Html::markup(inline_svg(figures[i].svg, i + 1, figures[i].caption)) + element("figcaption", caption),
                figures[i].wide ? "class=\"broad\"" : "") +
        Html::markup("\n");
  }
  return {"figures", say("heading.figures"),
          figures.empty() ? element("p", say("figures.none")) : element("div", content, "class=\"figures\"")};
}

}  // namespace bentur::html
