#include "bentur/model/quantities.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <numbers>
#include <optional>
#include <string_view>

#include "bentur/core/errors.h"
#include "bentur/excitation/ground_motion.h"
#include "bentur/model/gap/gap_outcome.h"
#include "bentur/model/restitution.h"

namespace bentur {
namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();

/// One problem and, when values are wanted, its response; `fill` is called with the values of each quantity in turn.
struct Reading {
  const Problem& problem;
  const Response& response;
  std::vector<PointRestitution> restitutions;
};

struct FloorQuantity {
  const char* name;
  const char* units;  // L length, F force
  const char* what;
  double (*value)(const BuildingPeaks& peaks, Eigen::Index floor);
};

double amplification(const BuildingPeaks& peaks, Eigen::Index floor) {
  const double without = peaks.displacement_no_contact(floor);
  return without > 0 ? peaks.displacement(floor) / without : none;
}

const FloorQuantity floor_quantities[] = {
    {"peak_displacement", "L", "largest displacement relative to the own base",
     [](const BuildingPeaks& p, Eigen::Index i) { return p.displacement(i); }},
    {"peak_displacement_no_contact", "L", "largest displacement with contact switched off",
     [](const BuildingPeaks& p, Eigen::Index i) { return p.displacement_no_contact(i); }},
    {"amplification", "1", "largest displacement over that with contact switched off", amplification},
    {"peak_drift_ratio", "1", "largest storey drift over storey height",
     [](const BuildingPeaks& p, Eigen::Index i) { return p.drift_ratio(i); }},
    {"peak_acceleration", "L s-2", "largest absolute acceleration",
     [](const BuildingPeaks& p, Eigen::Index i) { return p.acceleration(i); }},
    {"peak_storey_shear", "F", "largest elastic storey shear",
     [](const BuildingPeaks& p, Eigen::Index i) { return p.storey_shear(i); }},
};

struct PointQuantity {
  const char* name;
  const char* units;
  const char* what;
  double (*value)(const Reading& reading, std::size_t point);
};

double or_none(const std::optional<double>& value) { return value.value_or(none); }

const PointQuantity point_quantities[] = {
    {"point_width", "L", "initial opening of the contact points",
     [](const Reading& r, std::size_t i) { return r.problem.points[i].width; }},
    {"minimum_gap_no_contact", "L", "gap that the free response needs",
     [](const Reading& r, std::size_t i) { return r.response.points[i].minimum_gap_no_contact; }},
    {"impacts", "1", "number of impacts",
     [](const Reading& r, std::size_t i) { return static_cast<double>(r.response.points[i].impacts); }},
    {"contact_duration", "s", "total time in contact",
     [](const Reading& r, std::size_t i) { return r.response.points[i].contact_duration; }},
    {"peak_force", "F", "largest contact force",
     [](const Reading& r, std::size_t i) { return r.response.points[i].peak_force; }},
    {"peak_force_time", "s", "time of the largest contact force",
     [](const Reading& r, std::size_t i) { return or_none(r.response.points[i].peak_force_time); }},
    {"peak_penetration", "L", "largest penetration",
     [](const Reading& r, std::size_t i) { return r.response.points[i].peak_penetration; }},
    {"peak_closing_speed", "L s-1", "largest closing speed at the start of an impact",
     [](const Reading& r, std::size_t i) { return r.response.points[i].peak_closing_speed; }},
    {"impulse", "F s", "impulse of all impacts",
     [](const Reading& r, std::size_t i) { return r.response.points[i].impulse; }},
    {"energy_lost", "F L", "energy that the contact dissipated",
     [](const Reading& r, std::size_t i) { return r.response.points[i].energy_lost; }},
    {"peak_tension", "F", "largest pull of the contact",
     [](const Reading& r, std::size_t i) { return r.response.points[i].peak_tension; }},
    {"restitution_smallest", "1", "smallest coefficient of restitution of an impact",
     [](const Reading& r, std::size_t i) { return or_none(r.restitutions[i].smallest); }},
    {"restitution_largest", "1", "largest coefficient of restitution of an impact",
     [](const Reading& r, std::size_t i) { return or_none(r.restitutions[i].largest); }},
};

double first_period(const Building& building) {
  const double omega = building.modes.omega(0);
  return omega > 0 ? 2 * std::numbers::pi / omega : none;
}

/// "F s" in the units of the case.
std::string in_units(std::string_view form, const Units& units) {
  std::string text;
  for (const char c : form) {
    text += c == 'L' ? udunit(units.length) : c == 'F' ? udunit(units.force) : std::string(1, c);
  }
  return text;
}

std::size_t gap_count(const Problem& problem) { return problem.buildings.size() - 1; }

}  // namespace

// tf would be unknown to UDUNITS, since its ton_force is the short one.
std::string udunit(const std::string& unit) { return unit == "tf" ? "1000 kgf" : unit; }

std::vector<Quantity> sweep_quantities(const Problem& problem, const Units& units, bool energy_audit) {
  std::vector<Quantity> list;
  std::size_t next = 0;
  const auto add = [&](Quantity quantity) {
    quantity.units = in_units(quantity.units, units);
    quantity.first = next;
    next += quantity.count;
    list.push_back(std::move(quantity));
  };
  for (std::size_t b = 0; b < problem.buildings.size(); ++b) {
    const Building& building = problem.buildings[b];
    const auto floors = static_cast<std::size_t>(building.model.floors());
    for (const FloorQuantity& q : floor_quantities) {
      add({fmt::format("{}_{}", q.name, b + 1), q.units, fmt::format("{}, building \"{}\"", q.what, building.name),
           Owner::floors, b, floors});
    }
    add({fmt::format("first_period_{}", b + 1), "s", fmt::format("first period, building \"{}\"", building.name)});
  }
  for (const PointQuantity& q : point_quantities) {
    add({q.name, q.units, q.what, Owner::points, 0, problem.points.size()});
  }
  add({"gap_minimum_no_contact", "L", "gap that the free response needs, the largest of its points", Owner::gaps, 0,
       gap_count(problem)});
  add({"gap_needed", "L", "gap that the free response needs, floors that face a column included", Owner::gaps, 0,
       gap_count(problem)});
  add({"unmodelled_contacts", "1", "floors that met what they face where no contact is modelled", Owner::gaps, 0,
       gap_count(problem)});
  add({"peak_ground_acceleration", "L s-2", "peak ground acceleration as applied"});
  add({"events", "1", "contacts closed or opened"});
  if (energy_audit) add({"energy_residual", "1", "largest energy not accounted for over the largest input"});
  return list;
}

std::size_t row_size(const std::vector<Quantity>& quantities) {
  return quantities.empty() ? 0 : quantities.back().first + quantities.back().count;
}

bool same_places(const Problem& a, const Problem& b) {
  const auto floors = [](const Building& x, const Building& y) { return x.model.floors() == y.model.floors(); };
  const auto left = [](const ContactPoint& x, const ContactPoint& y) { return x.left == y.left; };
  return std::equal(a.buildings.begin(), a.buildings.end(), b.buildings.begin(), b.buildings.end(), floors) &&
         std::equal(a.points.begin(), a.points.end(), b.points.begin(), b.points.end(), left);
}

void fill_row(const Problem& problem, const Response& response, std::span<double> row) {
  const Reading reading{problem, response, restitutions(problem, response)};
  std::size_t next = 0;
  const auto add = [&](double value) {
    if (next < row.size()) row[next] = value;
    ++next;
  };
  for (std::size_t b = 0; b < problem.buildings.size(); ++b) {
    const Eigen::Index floors = problem.buildings[b].model.floors();
    for (const FloorQuantity& q : floor_quantities) {
      for (Eigen::Index floor = 0; floor < floors; ++floor) add(q.value(response.buildings[b], floor));
    }
    add(first_period(problem.buildings[b]));
  }
  for (const PointQuantity& q : point_quantities) {
    for (std::size_t i = 0; i < problem.points.size(); ++i) add(q.value(reading, i));
  }
  std::vector<double> gaps(gap_count(problem), 0.0);
  for (std::size_t i = 0; i < problem.points.size(); ++i) {
    double& needed = gaps[static_cast<std::size_t>(problem.points[i].left)];
    needed = std::max(needed, response.points[i].minimum_gap_no_contact);
  }
  for (const double needed : gaps) add(needed);
  for (std::size_t gap = 0; gap < gaps.size(); ++gap) add(gap_needed(problem, response, gap));
  for (std::size_t gap = 0; gap < gaps.size(); ++gap) {
    add(static_cast<double>(unmodelled_contacts(problem, response, gap).size()));
  }
  add(peak_acceleration(problem.motion));
  add(static_cast<double>(response.events));
  if (response.energy) add(response.energy->relative_residual());
  if (next != row.size()) {
    throw InvalidParameter("row", fmt::format("{} values", row.size()), fmt::format("must have {}", next));
  }
}

}  // namespace bentur
