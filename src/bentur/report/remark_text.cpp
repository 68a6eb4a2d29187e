#include "bentur/report/remark_text.h"

#include "bentur/core/number_text.h"
#include "bentur/report/html/words.h"

namespace bentur {
namespace {

std::string with_unit(const std::string& text, const std::string& unit) {
  return unit.empty() ? text : text + " " + unit;
}

std::string usual_text(const Remark& remark, const html::Words& say) {
  if (remark.usual_from && remark.usual_to) {
    return say("remark.between",
               {{"from", number(*remark.usual_from)}, {"to", with_unit(number(*remark.usual_to), remark.unit)}});
  }
  if (remark.usual_to) return say("remark.up_to", {{"to", with_unit(number(*remark.usual_to), remark.unit)}});
  return say("remark.at_least", {{"from", with_unit(number(remark.usual_from.value_or(0)), remark.unit)}});
}

}  // namespace

std::string remark_text(const Remark& remark, std::string_view language) {
  const html::Words say(language);
  const std::string text = say("remark." + remark.key, {{"value", with_unit(number(remark.value), remark.unit)},
                                                        {"usual", usual_text(remark, say)}});
  return remark.subject.empty() ? text : remark.subject + ": " + text;
}

std::string model_text(std::string_view language) { return html::Words(language)("remarks.model"); }

}  // namespace bentur
