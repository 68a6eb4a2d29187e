#include "bentur/report/html/internal/page.h"

#include <fmt/format.h>

#include <cstddef>
#include <cstdint>
#include <string_view>

#include "bentur/core/errors.h"
#include "bentur/report/html/internal/assets.h"
#include "bentur/report/html/internal/sections.h"

namespace bentur::html {
namespace {

/// A figure's SVG without what only a file of its own has, and with names of its own among all figures of the page.
std::string inline_svg(const std::string& file, std::size_t number) {
  const std::size_t start = file.find("<svg");
  if (start == std::string::npos) throw InvalidParameter("figures", std::to_string(number), "is no SVG");
  std::string svg = file.substr(start);
  for (const std::string name : {"title", "desc"}) {  // the caption says what it is, and who drew it is no tooltip
    const std::size_t open = svg.find("<" + name + ">");
    const std::size_t close = svg.find("</" + name + ">");
    if (open < close && close != std::string::npos) svg.erase(open, close + name.size() + 3 - open);
  }
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

}  // namespace

std::string_view asset(std::string_view name) {
  for (const EmbeddedFile& file : report_assets()) {
    if (file.name == name) return file.content;
  }
  throw InvalidParameter("asset", std::string(name), "is not built in");
}

std::string page(const Words& say, const std::string& title, const Html& body, bool with_script) {
  const std::string nonce = nonce_of(body.str());
  const std::string head =
      "<meta charset=\"utf-8\">\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n" +
      std::string(report_mark) +
      "\">\n"
      "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; script-src 'nonce-" +
      nonce + "'; style-src 'unsafe-inline'; base-uri 'none'; form-action 'none'\">\n";
  Html content = body;
  if (with_script)
    content += element("script", Html::markup(std::string(asset("motion.js")) + std::string(asset("report.js"))),
                       "nonce=\"" + nonce + "\"");
  const Html document = element("head", Html::markup(head) + element("title", title) +
                                            element("style", Html::markup(asset("report.css")))) +
                        Html::markup("\n") + element("body", content);
  return "<!DOCTYPE html>\n" + element("html", document, "lang=\"" + say.language() + "\"").str() + "\n";
}

Html figures_section(const Words& say, const std::vector<ReportFigure>& figures) {
  Html content;
  for (std::size_t i = 0; i < figures.size(); ++i) {
    if (figures[i].svg.empty()) {
      content += element("p", figures[i].caption, "class=\"note\"");
      continue;
    }
    content +=
        element("figure", Html::markup(inline_svg(figures[i].svg, i + 1)) + element("figcaption", figures[i].caption)) +
        Html::markup("\n");
  }
  return section("figures", say("heading.figures"),
                 figures.empty() ? element("p", say("figures.none")) : element("div", content, "class=\"figures\""));
}

}  // namespace bentur::html
