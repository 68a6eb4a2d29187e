// bentur_compare FOLDER CASE...: solves each case by every solver and every peer at many settings, and writes into
// FOLDER runs.csv, one row a setting, and NAME.json, what models of other programs are made from. See bench/README.md.
#include <fmt/format.h>

#include <cmath>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <fstream>
#include <functional>
#include <nlohmann/json.hpp>
#include <numbers>
#include <stdexcept>
#include <string>
#include <variant>
#include <vector>

#include "bench/peers/peers.h"
#include "bench/timing.h"
#include "bentur/io/case/case_toml.h"
#include "bentur/pounding/pounding.h"

namespace {

using namespace bentur;
using namespace bentur::bench;
using Json = nlohmann::ordered_json;

constexpr double budget = 0.05;  // for the repeats of one setting, ten times that where a solver has only one [s]
constexpr double cap = 3.0;      // a setting that takes longer is the last of its solver [s]

Case read(const std::filesystem::path& file) {
  Diagnostics diagnostics;
  auto c = read_case(file, diagnostics);
  if (!c) throw std::runtime_error(diagnostics.errors().front().text());
  return *c;
}

double peak_force(const Response& response) {
  if (response.status != Status::done) throw std::runtime_error(response.message);
  double peak = 0;
  for (const PointSummary& point : response.points) peak = std::max(peak, point.peak_force);
  return peak;
}

double largest_displacement(const Response& response) {
  double largest = 0;
  for (const BuildingPeaks& peaks : response.buildings)
    largest = std::max(largest, peaks.displacement_no_contact.maxCoeff());
  return largest;
}

struct Found {
  double peak_force = 0;
  long impacts = 0, work = 0;  // work: steps of ours, evaluations of the derivative of peers
};

/// The rows of one case.
class Table {
 public:
  Table(std::FILE* file, std::string name, double reference)
      : file_(file), name_(std::move(name)), reference_(reference) {}

  /// One setting; whether a finer one is worth while, which it is neither after a slow one nor after two of next to no
  /// error.
  bool add(const std::string& solver, const std::string& setting, const std::function<Found()>& run) {
    Found found;
    Timing timing;
    try {
      timing = time_of([&] { found = run(); }, setting.empty() ? 10 * budget : budget);
    } catch (const std::exception& error) {
      fmt::print(stderr, "{}: {} at {}: {}\n", name_, solver, setting, error.what());
      return true;
    }
    const double error = std::abs(found.peak_force / reference_ - 1);
    fmt::print(file_, "{},{},{},{:.6e},{:.6e},{},{:.15g},{:.3e},{},{}\n", name_, solver, setting, timing.minimum,
               timing.median, timing.repeats, found.peak_force, error, found.impacts, found.work);
    std::fflush(file_);
    if (solver != solver_) converged_ = 0;
    solver_ = solver;
    converged_ = error < 1e-10 ? converged_ + 1 : 0;
    return timing.minimum < cap && converged_ < 2;
  }

 private:
  std::FILE* file_;
  std::string name_;
  double reference_;
  std::string solver_;  // of the last setting
  int converged_ = 0;   // its settings of next to no error in a row
};

Found by(const Solver& solver, const Problem& problem) {
  const Response response = solve(problem, solver);
  return {peak_force(response), std::ssize(response.impacts), response.steps};
}

void ours(Table& table, const Problem& problem) {
  const auto run = [&problem](const Solver& solver) { return by(solver, problem); };
  table.add("exact", "", [&] { return run(ExactSolver{}); });
  const FreeResponse free(problem);
  table.add("exact after free response", "", [&] {
    const Response response = free.solve(problem);
    return Found{peak_force(response), std::ssize(response.impacts), response.steps};
  });
  for (const double tolerance : {1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9, 1e-10, 1e-11, 1e-12}) {
    if (!table.add("adaptive", fmt::format("{:.0e}", tolerance), [&] { return run(AdaptiveSolver{tolerance}); })) break;
  }
  for (const double step : {2e-3, 1e-3, 5e-4, 2e-4, 1e-4, 5e-5, 2e-5, 1e-5}) {
    if (!table.add("runge-kutta", fmt::format("{:.0e} s", step), [&] { return run(RungeKuttaSolver{step}); })) break;
  }
}

/// Largest relative difference of any floor's peak displacement, without contact and with, drift or shear.
double difference(const Response& known, const FloorPeaks& free_peaks, const FloorPeaks& peaks) {
  double largest = 0;
  for (std::size_t b = 0; b < known.buildings.size(); ++b) {
    const BuildingPeaks& building = known.buildings[b];
    const Eigen::Index floors = building.displacement.size();
    Eigen::VectorXd expected(3 * floors);
    expected << building.displacement, building.drift_ratio, building.storey_shear;
    largest = std::max(largest, (peaks.peaks()[b].cwiseQuotient(expected).array() - 1).abs().maxCoeff());
    const Eigen::VectorXd alone = free_peaks.peaks()[b].head(floors).cwiseQuotient(building.displacement_no_contact);
    largest = std::max(largest, (alone.array() - 1).abs().maxCoeff());
  }
  return largest;
}

void peers(Table& table, const Problem& problem, double length) {
  Equations equations(problem, length);
  const auto all = [&](const std::string& name, const std::function<void(double)>& integrate) {
    for (double tolerance = 1e-3; tolerance > 0.5e-12; tolerance /= std::sqrt(10.0)) {
      const bool go_on = table.add(name, fmt::format("{:.1e}", tolerance), [&] {
        equations.restart();
        integrate(tolerance);
        return Found{equations.peak_force(), equations.impacts(), equations.evaluations()};
      });
      if (!go_on) break;
    }
  };
#ifdef BENTUR_WITH_SUNDIALS
  all("cvode", [&](double tolerance) { integrate_with_cvode(equations, tolerance); });
  all("arkode order 5",
      [&](double tolerance) { integrate_with_arkode(equations, tolerance, Arkode::dormand_prince_5); });
  all("arkode order 8", [&](double tolerance) { integrate_with_arkode(equations, tolerance, Arkode::fehlberg_8); });
#endif
  Problem apart = problem;
  apart.points.clear();
  Equations free(apart, length);
  const Response known = solve(problem);
  all("odeint all peaks", [&](double tolerance) {
    FloorPeaks free_peaks(problem), peaks(problem);
    free.restart();
    integrate_with_odeint(free, tolerance, &free_peaks);
    integrate_with_odeint(equations, tolerance, &peaks);
    if (tolerance < 1e-6 && difference(known, free_peaks, peaks) > 1e-3) throw std::runtime_error("other floor peaks");
  });
  all("odeint dopri5", [&](double tolerance) { integrate_with_odeint(equations, tolerance); });
}

Json rows(const Eigen::MatrixXd& matrix) {
  Json out = Json::array();
  for (Eigen::Index i = 0; i < matrix.rows(); ++i) {
    out.push_back(std::vector<double>(matrix.row(i).begin(), matrix.row(i).end()));
  }
  return out;
}

Json contacts(const Problem& problem) {
  Json out = Json::array();
  for (const ContactPoint& point : problem.points) {
    out.push_back({{"left", point.left},
                   {"left_floor", point.left_floor},
                   {"right_floor", point.right_floor},
                   {"width", point.width},
                   {"stiffness", point.law->parameters().front().second}});
  }
  return out;
}

Json sections(const std::vector<Section>& list) {
  Json out = Json::array();
  for (const Section& section : list) out.push_back({{"area", section.area}, {"inertia", section.inertia}});
  return out;
}

/// C = αM + βK for all buildings of the case: the ratio of its modes, in modes 1 and 3 of the first building.
struct Rayleigh {
  double ratio = 0, first = 0, third = 0;  // ζ [-], ω [rad/s]
  Rayleigh(const Case& c, const Problem& problem)
      : ratio(std::get<ModalDamping>(c.buildings.front().damping).ratios.front()),
        first(problem.buildings.front().modes.omega(0)),
        third(problem.buildings.front().modes.omega(2)) {}
  [[nodiscard]] RayleighDamping damping() const { return {{ratio, ratio}, {period(first), period(third)}}; }
  [[nodiscard]] double alpha() const { return 2 * ratio * first * third / (first + third); }
  [[nodiscard]] double beta() const { return 2 * ratio / (first + third); }
  static double period(double omega) { return 2 * std::numbers::pi / omega; }
};

/// The case as users of frame programs model it: masses lumped at the joints, Rayleigh damping.
Problem as_frames(Case c, const Rayleigh& rayleigh) {
  for (BuildingSpec& building : c.buildings) {
    std::get<PlaneFrame>(building.structure).mass_matrix = MassMatrix::lumped;
    building.damping = rayleigh.damping();
  }
  return make_problem(c);
}

/// What models of other programs are made from, with the peak force each of them is to come to: `frames`, joints and
/// members, and `matrices`, the condensed equations of the case itself.
void describe(const std::filesystem::path& file, const Case& c, const Problem& problem, const Problem& of_frames) {
  const Rayleigh rayleigh(c, problem);
  const auto& motion = std::get<SampledMotion>(problem.motion);
  Json frames = Json::array(), matrices = Json::array();
  for (std::size_t b = 0; b < problem.buildings.size(); ++b) {
    const auto& frame = std::get<PlaneFrame>(c.buildings[b].structure);
    const StructuralModel& model = of_frames.buildings[b].model;
    frames.push_back({{"elastic_modulus", frame.elastic_modulus},
                      {"storey_heights", frame.storey_heights},
                      {"bay_widths", frame.bay_widths},
                      {"columns", sections(frame.columns)},
                      {"beams", sections(frame.beams)},
                      {"masses", std::vector<double>(model.load.begin(), model.load.end())}});
    const Building& building = problem.buildings[b];
    const Eigen::MatrixXd to_modes = building.modes.shapes.transpose() * building.model.mass;
    matrices.push_back({{"mass", rows(building.model.mass)},
                        {"stiffness", rows(building.model.stiffness)},
                        {"damping", rows(to_modes.transpose() * building.modal_damping * to_modes)},
                        {"load", std::vector<double>(building.model.load.begin(), building.model.load.end())}});
  }
  const Json out = {{"duration", problem.duration},
                    {"time_step", motion.time_step},
                    {"acceleration", motion.acceleration},
                    {"delays", problem.delays},
                    {"rayleigh", {{"alpha", rayleigh.alpha()}, {"beta", rayleigh.beta()}}},
                    {"contacts", contacts(problem)},
                    {"largest_displacement", largest_displacement(solve(problem))},
                    {"frames", frames},
                    {"frames_peak_force", peak_force(solve(of_frames))},
                    {"matrices", matrices},
                    {"matrices_peak_force", peak_force(solve(problem))}};
  std::ofstream(file) << out.dump() << '\n';
}

void compare(const std::filesystem::path& folder, const std::filesystem::path& file, std::FILE* runs) {
  const std::string name = file.stem().string();
  fmt::print(stderr, "bench: {}\n", name);
  const Case c = read(file);
  const Problem problem = make_problem(c);
  const Response response = solve(problem);
  const double reference = peak_force(response);
  const Problem of_frames = as_frames(c, Rayleigh(c, problem));
  describe(folder / (name + ".json"), c, problem, of_frames);
  Table(runs, name, peak_force(solve(of_frames))).add("exact of frames", "", [&] {
    return by(ExactSolver{}, of_frames);
  });
  Table table(runs, name, reference);
  ours(table, problem);
  peers(table, problem, largest_displacement(response));
}

}  // namespace

int main(int argc, char** argv) try {
  if (argc < 3) throw std::runtime_error("usage: bentur_compare FOLDER CASE...");
  const std::filesystem::path folder = argv[1];
  std::filesystem::create_directories(folder);
  std::FILE* runs = std::fopen((folder / "runs.csv").c_str(), "w");
  if (runs == nullptr) throw std::runtime_error("cannot write " + (folder / "runs.csv").string());
  fmt::print(runs, "case,solver,setting,minimum,median,repeats,peak_force,error,impacts,work\n");
#ifndef BENTUR_WITH_SUNDIALS
  fmt::print(stderr, "bench: SUNDIALS is not installed (Debian: libsundials-dev); going on without CVODE and ARKODE\n");
#endif
  for (int i = 2; i < argc; ++i) compare(folder, argv[i], runs);
  std::fclose(runs);
  return 0;
} catch (const std::exception& error) {
  fmt::print(stderr, "bentur_compare: {}\n", error.what());
  return 1;
}
