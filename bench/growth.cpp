// bentur_growth FOLDER CASES: how the time of `exact` grows with duration, storeys, impacts and buildings, beside a
// count of its arithmetic, and the rate at which this machine does arithmetic; how it grows with hinges; and what
// buildings in plan take. Writes growth.csv, rates.csv, hinges.csv, plan_pair.csv and blocks.csv into FOLDER; CASES is
// the folder of cases. What the counts mean: bench/README.md.
#include <fmt/format.h>

#include <cmath>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "bench/arithmetic.h"
#include "bench/plans.h"
#include "bench/timing.h"
#include "bentur/elements/hinges.h"
#include "bentur/io/case/case_toml.h"

namespace {

using namespace bentur;
using namespace bentur::bench;

using File = std::unique_ptr<std::FILE, int (*)(std::FILE*)>;

File open_for_writing(const std::filesystem::path& path) {
  File file(std::fopen(path.c_str(), "w"), std::fclose);
  if (!file) throw std::runtime_error("cannot write " + path.string());
  return file;
}

Case read(const std::filesystem::path& file) {
  Diagnostics diagnostics;
  auto c = read_case(file, diagnostics);
  if (!c) throw std::runtime_error(diagnostics.errors().front().text());
  return *c;
}

class Table {
 public:
  explicit Table(const std::filesystem::path& path) : file_(open_for_writing(path)) {
    fmt::print(file_.get(), "growth,value,minimum,median,impacts,free_steps,contact_steps,free_flops,contact_flops\n");
  }

  void add(const std::string& growth, double value, const Case& c) {
    const Problem problem = make_problem(c);
    Response response;
    const Timing timing = time_of([&] { response = solve(problem); }, 0.1);
    if (response.status != Status::done) throw std::runtime_error(response.message);
    const Arithmetic count = arithmetic_of(problem, response);
    fmt::print(file_.get(), "{},{},{:.6e},{:.6e},{},{},{},{:.6e},{:.6e}\n", growth, value, timing.minimum,
               timing.median, response.impacts.size(), count.free_steps, count.contact_steps, count.free_flops,
               count.contact_flops);
  }

 private:
  File file_;
};

/// Both buildings of a pair with so many storeys, of the sections and the mass of their lowest ones; the gap grows with
/// them.
Case with_storeys(Case c, std::size_t storeys) {
  GapSpec& gap = c.gaps.front();
  for (BuildingSpec& building : c.buildings) {
    auto& frame = std::get<PlaneFrame>(building.structure);
    frame.storey_heights.resize(storeys, frame.storey_heights.back());
    frame.columns.assign(storeys, frame.columns.front());
    frame.beams.assign(storeys, frame.beams.front());
    frame.floor_masses.assign(storeys, frame.floor_masses.front());
  }
  gap.elevations.clear();
  double elevation = 0;
  for (const double height : std::get<PlaneFrame>(c.buildings.front().structure).storey_heights) {
    gap.elevations.push_back(elevation += height);
  }
  gap.widths.assign(storeys, 0.02);
  return c;
}

/// The first buildings of a row.
Case with_buildings(Case c, std::size_t count) {
  c.buildings.resize(count);
  c.gaps.resize(count - 1);
  c.excitation.delays.resize(count);
  return c;
}

void growth(const std::filesystem::path& folder, const std::filesystem::path& cases) {
  Table table(folder / "growth.csv");
  const Case pair = read(cases / "m12-gap-02.toml");
  for (const double duration : {5.0, 10.0, 20.0, 30.0}) {
    Case c = pair;
    c.analysis.duration = duration;
    table.add("duration", duration, c);
  }
  for (const double width : {0.8, 0.6, 0.4, 0.2, 0.1, 0.05, 0.0}) {
    Case c = pair;
    for (double& w : c.gaps.front().widths) w = width;
    table.add("gap", width, c);
  }
  const Case frames = read(cases / "storeys-12-8.toml");
  for (const std::size_t storeys : {5U, 10U, 20U, 40U}) {
    table.add("storeys", static_cast<double>(storeys), with_storeys(frames, storeys));
  }
  const Case row = read(cases / "row-of-five.toml");
  for (const std::size_t count : {2U, 3U, 4U, 5U}) {
    table.add("buildings", static_cast<double>(count), with_buildings(row, count));
  }
  for (const std::string name :
       {"m12-gap-00", "m12-gap-02", "m12-gap-04", "storeys-12-8", "storeys-40-30", "row-of-five"}) {
    table.add(name, 0, read(cases / (name + ".toml")));
  }
}

/// Hinges that count how often the set that flows has changed.
class CountedHinges final : public HingeLaw {
 public:
  using HingeLaw::HingeLaw;
  [[nodiscard]] CoupledState next(const CoupledState& state, const CoupledBranch& branch, std::size_t guard,
                                  double time, const CoupledMotion& motion) const override {
    ++events_;
    return HingeLaw::next(state, branch, guard, time, motion);
  }
  [[nodiscard]] long events() const { return events_; }

 private:
  mutable long events_ = 0;
};

/// With laws of its own, which have met no set that flows and keep so many numbers of them.
Problem with_fresh_laws(Problem problem, Eigen::Index kept) {
  for (Building& building : problem.buildings) {
    for (CoupledElement& element : building.coupled) {
      const auto& law = dynamic_cast<const HingeLaw&>(*element.law);
      element.law = std::make_shared<CountedHinges>(law.parameters(), kept);
    }
  }
  return problem;
}

/// Pairs of frames with hinges, of more and more storeys and bays, beside the same frames without.
void hinges(const std::filesystem::path& folder, const std::filesystem::path& cases) {
  const File file = open_for_writing(folder / "hinges.csv");
  fmt::print(file.get(), "bays,storeys,hinges,events,elastic,hinged,forgetful\n");
  const Case pair = read(cases / "hinged-6-6.toml");
  struct Size {
    std::size_t bays, storeys;
  };
  for (const auto [bays, storeys] : {Size{1, 2}, {2, 3}, {2, 6}, {2, 10}, {3, 14}}) {
    Case c = with_storeys(pair, storeys);
    for (BuildingSpec& building : c.buildings) {
      auto& frame = std::get<PlaneFrame>(building.structure);
      frame.bay_widths.resize(bays, frame.bay_widths.back());
    }
    Case without = c;
    for (BuildingSpec& building : without.buildings) {
      auto& frame = std::get<PlaneFrame>(building.structure);
      for (std::vector<Section>* sections : {&frame.columns, &frame.beams}) {
        for (Section& section : *sections) section.moment_capacity.clear();
      }
    }
    const Problem elastic = make_problem(without), hinged = make_problem(c);
    const auto time = [](const Problem& problem, Eigen::Index kept) {
      return time_of([&] { (void)solve(with_fresh_laws(problem, kept)); }, 0.5).minimum;
    };
    const Problem counted = with_fresh_laws(hinged, FlowingSets::most_kept);
    (void)solve(counted);
    Eigen::Index count = 0;
    long events = 0;
    for (const Building& building : counted.buildings) {
      const auto& law = dynamic_cast<const CountedHinges&>(*building.coupled.at(0).law);
      count += law.size();
      events += law.events();
    }
    fmt::print(file.get(), "{},{},{},{},{:.6e},{:.6e},{:.6e}\n", bays, storeys, count, events, time(elastic, 0),
               time(hinged, FlowingSets::most_kept), time(hinged, 0));
  }
}

/// Two of three storeys in plan beside a row's pair of nine storeys each, as many degrees of freedom, both with about a
/// hundred impacts; and blocks of more and more houses, in a row and in rows of five, near one another and far apart.
void plans(const std::filesystem::path& folder, const std::filesystem::path& cases) {
  const std::filesystem::path record = cases / "../../data/el-centro-1940-ns.csv";
  struct Found {
    double width = 0, time = 0;
    std::size_t impacts = 0;
  };
  const auto nearest_to_hundred = [](const auto& run) {
    Found best;
    const auto off = [](std::size_t impacts) { return impacts > 100 ? impacts - 100 : 100 - impacts; };
    for (const double width : {0.0, 0.001, 0.002, 0.005, 0.01, 0.02, 0.04}) {
      const auto [time, impacts] = run(width);
      if (off(impacts) < off(best.impacts)) best = {width, time, impacts};
    }
    return best;
  };
  const Case frames = with_storeys(read(cases / "storeys-12-8.toml"), 9);
  const Found row = nearest_to_hundred([&](double width) {
    Case c = frames;
    c.analysis.duration = 10;
    for (double& w : c.gaps.front().widths) w = width;
    const Problem problem = make_problem(c);
    Response response;
    const Timing timing = time_of([&] { response = solve(problem); }, 0.3);
    return std::pair(timing.minimum, response.impacts.size());
  });
  const Found plan = nearest_to_hundred([&](double width) {
    const PlanTime of = time_of_plan(houses(2, 2, width, 3, record));
    return std::pair(of.minimum, of.impacts);
  });
  const File pair = open_for_writing(folder / "plan_pair.csv");
  fmt::print(pair.get(), "what,width,impacts,time\n");
  for (const auto& [what, found] : {std::pair("in plan, 3 storeys", plan), std::pair("in a row, 9 storeys", row)}) {
    fmt::print(pair.get(), "\"{}\",{},{},{:.6e}\n", what, found.width, found.impacts, found.time);
  }
  const File blocks = open_for_writing(folder / "blocks.csv");
  fmt::print(blocks.get(), "block,houses,gaps,impacts,near,far\n");
  for (const bool one_row : {true, false}) {
    for (const int count : {5, 10, 20, 30}) {
      const PlanProblem near = houses(count, one_row ? count : 5, 0.01, 2, record);
      const PlanTime touching = time_of_plan(near),
                     apart = time_of_plan(houses(count, one_row ? count : 5, 0.3, 2, record));
      fmt::print(blocks.get(), "{},{},{},{},{:.6e},{:.6e}\n", one_row ? "one row" : "rows of five", count,
                 near.gaps.size(), touching.impacts, touching.minimum, apart.minimum);
    }
  }
}

void rates(const std::filesystem::path& folder) {
  const File file = open_for_writing(folder / "rates.csv");
  fmt::print(file.get(), "instructions,flops_per_second\n");
  for (const auto& [name, rate] : arithmetic_rates()) fmt::print(file.get(), "{},{:.4e}\n", name, rate);
}

}  // namespace

int main(int argc, char** argv) try {
  if (argc != 3) throw std::runtime_error("usage: bentur_growth FOLDER CASES");
  std::filesystem::create_directories(argv[1]);
  rates(argv[1]);
  growth(argv[1], argv[2]);
  hinges(argv[1], argv[2]);
  plans(argv[1], argv[2]);
  return 0;
} catch (const std::exception& error) {
  fmt::print(stderr, "bentur_growth: {}\n", error.what());
  return 1;
}
