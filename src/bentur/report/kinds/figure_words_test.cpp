#include <gtest/gtest.h>

#include <regex>
#include <set>
#include <string>
#include <vector>

#include "bentur/io/case/case_toml.h"
#include "bentur/report/kinds/kinds.h"
#include "bentur/report/words.h"
#include "tests/support/column_case.h"
#include "tests/support/kinds_case.h"

namespace bentur {
namespace {

RunResults drawn_run(const std::string& text) {
  Diagnostics diagnostics;
  auto c = read_case_text(text, std::string(BENTUR_SOURCE_DIR) + "/examples/case.toml", diagnostics);
  if (!c) throw std::runtime_error(diagnostics.errors().front().text());
  Problem problem = make_problem(*c);
  SolveOptions options;
  options.output_step = 0.01;
  options.course = true;
  Response response = solve(problem, c->analysis.solver, options);
  FigureData figures = figure_data(problem, response, c->analysis.solver);
  RunResults results = run_results(std::move(*c), std::move(problem), std::move(response));
  results.figures = std::move(figures);
  return results;
}

std::vector<std::string> texts_of(const Figure& figure) {
  std::vector<std::string> texts;
  for (const Panel& panel : figure.panels) {
    texts.insert(texts.end(), {panel.title, panel.x.label, panel.y.label, panel.note, panel.events.label});
    for (const Curve& curve : panel.curves) texts.push_back(curve.label);
    for (const RuleLine& rule : panel.rules) texts.push_back(rule.label);
    if (panel.map) texts.push_back(panel.map->label);
  }
  std::erase(texts, "");
  return texts;
}

/// Every text that a figure shows is a word of the catalogue, the name of a building, or symbols and numbers.
TEST(FigureWords, EveryTextOfARunIsInTheCatalogue) {
  std::set<std::string> known;
  for (const auto& [key, text] : catalogue().texts) {
    if (key.starts_with("figure.text.")) known.insert(text.at("en"));
  }
  const std::regex symbols(R"((T[₁₂₃]|S[ad]|ζ)[^a-zA-Z]*( s|%| \[.*\])?)");
  for (const std::string& text : {std::string(test::struck_columns), std::string(test::every_kind)}) {
    const RunResults results = drawn_run(text);
    std::set<std::string> names;
    for (const Building& building : results.problem.buildings) names.insert(building.name);
    FigureOptions options;
    options.say = [&](std::string_view english) {
      EXPECT_TRUE(known.contains(std::string(english))) << english << " is not in the catalogue";
      return "§" + std::string(english);
    };
    for (const FigureKind& kind : figure_kinds(results)) {
      for (const std::string& shown : texts_of(make_figure(results, kind.name, options))) {
        const bool is_word = shown.find("§") != std::string::npos;
        EXPECT_TRUE(is_word || names.contains(shown) || std::regex_match(shown, symbols)) << kind.name << ": " << shown;
      }
    }
  }
}

}  // namespace
}  // namespace bentur
