#include <fmt/format.h>

#include <algorithm>
#include <memory>

#include "bentur/io/results/result_json.h"
#include "bentur/study/minimum_gap.h"
#include "commands.h"
#include "session.h"
#include "table.h"

namespace bentur::cli {
namespace {

/// The rules whose gap is smaller than the simulated one at some point of a gap.
std::string rules_that_fall_short(const std::vector<PointSeparation>& points) {
  std::string names;
  const auto add = [&](const char* name, double PointSeparation::*rule) {
    if (std::any_of(points.begin(), points.end(),
                    [&](const PointSeparation& p) { return p.*rule < p.simulated * (1 - 1e-9); })) {
      names += (names.empty() ? "" : " and ") + std::string(name);
    }
  };
  add("SRSS", &PointSeparation::srss);
  add("DDC", &PointSeparation::ddc);
  return names;
}

std::string gap_text(const Loaded& loaded, int gap, const std::vector<PointSeparation>& all) {
  const Problem& problem = loaded.problem;
  const std::string& length = loaded.c.units.length;
  std::vector<PointSeparation> points;
  for (const PointSeparation& separation : all) {
    if (problem.points[static_cast<std::size_t>(separation.point)].left == gap) {
      points.push_back(separation);
    }
  }
  std::reverse(points.begin(), points.end());  // as the buildings stand: highest first
  const auto point_of = [&](const PointSeparation& s) -> const ContactPoint& {
    return problem.points[static_cast<std::size_t>(s.point)];
  };
  const auto shortfall = [&](const PointSeparation& s) { return s.simulated - point_of(s).width; };
  const auto governing =
      std::max_element(points.begin(), points.end(),
                       [&](const PointSeparation& a, const PointSeparation& b) { return shortfall(a) < shortfall(b); });

  std::string text = fmt::format(
      "{}: {}\n", gap_name(problem, gap),
      shortfall(*governing) > 0
          ? fmt::format("too close. {} {} is needed at elevation {} {}, {} {} given: {} {} short",
                        number(governing->simulated), length, number(point_of(*governing).elevation), length,
                        number(point_of(*governing).width), length, number(shortfall(*governing)), length)
          : fmt::format("wide enough. {} {} is needed at elevation {} {}, {} {} given", number(governing->simulated),
                        length, number(point_of(*governing).elevation), length, number(point_of(*governing).width),
                        length));
  std::vector<double> elevations, widths, simulated, abs, srss, ddc;
  std::vector<std::string> marks;
  for (const PointSeparation& s : points) {
    elevations.push_back(point_of(s).elevation);
    widths.push_back(point_of(s).width);
    simulated.push_back(s.simulated);
    abs.push_back(s.abs);
    srss.push_back(s.srss);
    ddc.push_back(s.ddc);
    marks.push_back(&s == &*governing ? "◄ governs" : "");
  }
  Table table;
  table.add("elevation", length, elevations);
  table.add("given", length, widths);
  table.add("simulated", length, simulated);
  table.add("ABS", length, abs);
  table.add("SRSS", length, srss);
  table.add("DDC", length, ddc);
  table.add("", "", marks);
  text += "\n" + table.text();
  const std::string unsafe = rules_that_fall_short(points);
  if (!unsafe.empty()) {
    text += fmt::format("  {} would be too small here.\n", unsafe);
  }
  return text;
}

void run(const std::string& file, bool json) {
  const Loaded loaded = load(file);
  const Response response = simulate(loaded, 0, true);
  const std::vector<PointSeparation> needed = separations(loaded.problem, response);
  if (json) {
    print(gap_json(loaded.c, loaded.problem, needed, BENTUR_VERSION));
    return;
  }
  std::string text = loaded.c.title.empty() ? "" : loaded.c.title + "\n";
  text += excitation_line(loaded.c) + "\n";
  for (std::size_t gap = 0; gap < loaded.c.gaps.size(); ++gap) {
    text += "\n" + gap_text(loaded, static_cast<int>(gap), needed);
  }
  text +=
      "\nSimulated: the buildings moving freely. ABS, SRSS, DDC: sum, root of squares and double-difference\n"
      "combination of their peak displacements at that elevation.\n";
  print(text);
}

}  // namespace

void add_gap_command(CLI::App& app) {
  struct Arguments {
    std::string file;
    bool json = false;
  };
  auto arguments = std::make_shared<Arguments>();
  CLI::App* command = app.add_subcommand("gap", "The gap that keeps the buildings apart, simulated and by the rules");
  command->add_option("CASE", arguments->file, "the case file (TOML)")->required();
  command->add_flag("--json", arguments->json, "JSON instead of tables");
  command->footer("Example: bentur gap case.toml");
  command->callback([arguments] { run(arguments->file, arguments->json); });
}

}  // namespace bentur::cli
