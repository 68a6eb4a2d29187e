#include "bentur/report/html/internal/each_of.h"

namespace bentur::html {

Html EachOf::markup(const Words& say, std::string_view what) const {
  if (all_.size() > most_open) return folded(say, what);
  Html content;
  for (const auto& [name, told] : all_) content += element("h3", name) + told;
  return content;
}

Html EachOf::folded(const Words& say, std::string_view what) const {
  Html content;
  for (const auto& [name, told] : all_) {
    content += element("details", element("summary", name) + told) + Html::markup("\n");
  }
  if (all_.size() <= most_open) return content;
  const Html count = Html::text(say(what, {{"count", std::to_string(all_.size())}}));
  const Html closed = element("span", " " + say("appendix.closed"), "class=\"closed\"");
  return element("details", element("summary", count + closed) + content, "class=\"appendix\"") + Html::markup("\n");
}

}  // namespace bentur::html
