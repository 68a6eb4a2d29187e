#include "bentur/io/schema/case_keys.h"
#include "bentur/model/gap/code_rules.h"
#include "bentur/model/gap/screening.h"

namespace bentur {
namespace {

/// Of each rule its table; keys point to them.
const std::vector<KeyTable>& rule_tables() {
  static const std::vector<KeyTable> tables = [] {
    std::vector<KeyTable> made;
    for (const CodeRule& rule : code_rules()) made.push_back({rule.name, rule.title, rule.keys});
    return made;
  }();
  return tables;
}

}  // namespace

const KeyTable& code_keys() {
  static const KeyTable table = [] {
    KeyTable made = {"code", "the factors that building codes' separation rules need", {}};
    for (const KeyTable& rule : rule_tables()) {
      made.keys.push_back(
          Key::sub_table(rule.name, rule, {rule.title, rule.title}, "the factors of this code").optional());
    }
    made.keys.push_back(Key::of("floors_aligned", Key::Kind::flag, {"Floors aligned", "Lantai sejajar"},
                                "whether every floor of either building has a floor of the other at its elevation")
                            .for_each("one per gap")
                            .optional("no rule asks for less because of it, which is said beside its number"));
    made.keys.push_back(Key::of("same_owner", Key::Kind::flag, {"Same owner", "Pemilik sama"},
                                "whether there is no property line between the buildings; `\"public-way\"`: a line in "
                                "common with a public way")
                            .for_each("one per gap")
                            .or_one_of({"public-way"})
                            .optional("a property line stands in the gap, which is said beside the numbers"));
    return made;
  }();
  return table;
}

const KeyTable& screening_keys() {
  static const KeyTable table = {
      "screening",
      "what the rules of thumb need",
      {Key::choice("seismicity", {seismicity_words().begin(), seismicity_words().end()}, {"Seismicity", "Kegempaan"},
                   "of the site: what the [rules of thumb](separation-rules.md#screening) of `bentur gap` and the "
                   "report need for the gap")
           .optional("those rules say that they need it")}};
  return table;
}

}  // namespace bentur
