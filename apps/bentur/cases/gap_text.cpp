#include "cases/gap_text.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <optional>
#include <string_view>

#include "session.h"
#include "text/table.h"

namespace bentur::cli {

std::string tables_text(const std::vector<std::string>& gaps, const Story& story, const Words& say) {
  Story of_all{story.statements};
  std::copy_if(story.tables.begin(), story.tables.end(), std::back_inserter(of_all.tables),
               [](const StoryTable& table) { return !table.gap; });
  std::string text = story_text(gaps, of_all, say, Told::outcome);
  std::optional<Eigen::Index> gap;
  for (const StoryTable& table : story.tables) {
    if (!table.gap) continue;
    if (table.gap != gap && gaps.size() > 1) text += "\n" + gaps.at(*table.gap) + "\n";
    gap = table.gap;
    text += "\n" + table_text(said(table, say));
  }
  return text + "\n" + story_text(gaps, {story.statements}, say, Told::remarks);
}

std::string codes_note(const CodeSpec& code, const Words& say) {
  if (code.rules.empty()) {
    std::vector<std::string_view> titles;
    for (const CodeRule& rule : code_rules()) titles.push_back(rule.title);
    return "\n" + wrapped(say("cli.no_codes", {{"titles", fmt::format("{}", fmt::join(titles, ", "))}})) + "\n";
  }
  std::vector<std::string> others;
  for (const CodeRule& rule : code_rules()) {
    if (std::any_of(code.rules.begin(), code.rules.end(), [&](const auto& given) { return given.rule == rule.name; })) {
      continue;
    }
    std::vector<std::string_view> keys;
    for (const Key& key : rule.keys) {
      if (key.is_required()) keys.push_back(key.name);
    }
    others.push_back(keys.empty() ? fmt::format("  code.{} = {{}}\n", rule.name)
                                  : fmt::format("  code.{}: {}\n", rule.name, fmt::join(keys, ", ")));
  }
  std::string text = "\n" + wrapped(say("gap.codes_note")) + "\n" + say("cli.takes") + "\n";
  for (const CodeRuleSpec& given : code.rules) {
    const CodeRule& rule = *find_code_rule(given.rule);
    text += "  " + wrapped(fmt::format("{}: {}", rule.title, say("gap.takes." + std::string(rule.name)))) + "\n";
  }
  if (!others.empty()) {
    text += "\n" + wrapped(say.count("cli.not_shown", static_cast<long>(others.size()))) + "\n" +
            fmt::format("{}", fmt::join(others, ""));
  }
  return text;
}

std::string all_gaps_text(const std::vector<std::string>& gaps, const CodeSpec& code, const Story& story,
                          const std::vector<std::string>& notes, const Words& say, const std::string& details) {
  std::string text = "\n" + tables_text(gaps, story, say) + details;
  for (const std::string& one : notes) text += "\n" + wrapped(one) + "\n";
  return text + codes_note(code, say);
}

}  // namespace bentur::cli
