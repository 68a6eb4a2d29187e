#include "bentur/report/html/internal/motion_section.h"

#include <fmt/format.h>

#include <utility>

namespace bentur::html {
namespace {

Html button(const Words& say, const std::string& id) {
  return element("button", say("motion." + id), fmt::format("type=\"button\" id=\"{}\"", id));
}

Html labelled(const Words& say, const std::string& key, const Html& control) {
  return element("label", Html::text(say(key)) + Html::markup(" ") + control);
}

Html speeds() {
  Html options;
  const std::pair<const char*, const char*> all[] = {{"2", "2 ×"},      {"1", "1 ×"},        {"0.5", "1/2 ×"},
                                                     {"0.1", "1/10 ×"}, {"0.01", "1/100 ×"}, {"0.001", "1/1000 ×"}};
  for (const auto& [value, text] : all) {
    const std::string chosen = std::string(value) == "1" ? " selected" : "";
    options += element("option", text, fmt::format("value=\"{}\"{}", value, chosen));
  }
  return element("select", options, "id=\"speed\"");
}

}  // namespace

PageSection motion_section(const Words& say, const std::string& length, MotionView view) {
  const bool in_plan = view == MotionView::plan;
  const std::string label = Html::text(say("motion.picture")).str();
  Html content = element("noscript", element("p", say("motion.noscript")));
  content += element("div",
                     element("svg", Html(), "id=\"stage\" role=\"img\" aria-label=\"" + label + "\"") +
                         element("div",
                                 element("p", element("output", Html(), "id=\"clock\"") + Html::markup("<br>") +
                                                  element("span", Html(), "id=\"event\"")) +
                                     element("div",
                                             element("table",
                                                     element("caption", say("motion.opening", {{"unit", length}})) +
                                                         element("tbody", Html(), "id=\"live\""),
                                                     "class=\"live\""),
                                             "class=\"wide\""),
                                 "class=\"readout\""),
                     "class=\"player\"");
  content += element("p", "", "id=\"building-key\" class=\"note\"");
  content += element("svg", Html(),
                     "id=\"timeline\" role=\"img\" aria-label=\"" + Html::text(say("motion.timeline")).str() + "\"");
  content += element("div", Html(), "id=\"time-axis\" aria-hidden=\"true\"");
  content += Html::markup("<input type=\"range\" id=\"scrub\" class=\"screen\" min=\"0\" aria-label=\"" +
                          Html::text(say("motion.scrub")).str() + "\">\n");
  Html level;
  if (in_plan) {
    level = element("label",
                    Html::text(say("motion.level")) + Html::markup(" ") + element("select", Html(), "id=\"level\""),
                    "id=\"level-choice\"");
  }
  content += element(
      "p",
      button(say, "play") + button(say, "previous") + button(say, "next") + button(say, "hardest") +
          labelled(say, "motion.speed", speeds()) +
          element("label", Html::markup("<input type=\"checkbox\" id=\"slow\"> ") + Html::text(say("motion.slow"))) +
          labelled(
              say, "motion.magnify",
              Html::markup("<input type=\"range\" id=\"magnify\">") + element("output", Html(), "id=\"magnified\"")) +
          level,
      "class=\"controls screen\"");
  content += element("p", say(in_plan ? "motion.note_plan" : "motion.note"), "class=\"note\"");
  return {"motion", say("heading.motion_picture"), content};
}

}  // namespace bentur::html
