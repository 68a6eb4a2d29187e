#include "bentur/pounding/plan/masses_elsewhere.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <set>

namespace bentur {
namespace {

constexpr int places = 5;  // where masses are expected, and four others

/// Of each building those that it has a gap or a link with, where masses of both may stand elsewhere.
std::vector<std::set<std::size_t>> neighbours_of(const PlanProblem& problem) {
  std::vector<std::set<std::size_t>> all(problem.buildings.size());
  const auto join = [&](Eigen::Index a, Eigen::Index b) {
    const auto one = static_cast<std::size_t>(a), other = static_cast<std::size_t>(b);
    if (problem.elsewhere[one].empty() || problem.elsewhere[other].empty()) return;
    all[one].insert(other);
    all[other].insert(one);
  };
  for (const PlanGap& gap : problem.gaps) join(gap.left, gap.right);
  for (const PlanLink& link : problem.links) join(link.link.left, link.link.right);
  return all;
}

/// A number for each building, other than those of its neighbours. Buildings with the fewest neighbours come last: of a
/// map in the plane, whose every part has a building with five at most, six numbers are enough.
std::vector<std::size_t> columns_of(const PlanProblem& problem) {
  const std::vector<std::set<std::size_t>> neighbours = neighbours_of(problem);
  std::vector<std::set<std::size_t>> left = neighbours;
  std::vector<std::size_t> order;
  std::vector<bool> taken(left.size(), false);
  while (order.size() < left.size()) {
    std::size_t next = left.size();
    for (std::size_t b = 0; b < left.size(); ++b) {
      if (!taken[b] && (next == left.size() || left[b].size() < left[next].size())) next = b;
    }
    taken[next] = true;
    order.push_back(next);
    for (const std::size_t other : left[next]) left[other].erase(next);
  }
  std::vector<std::size_t> columns(left.size(), left.size());
  for (auto b = order.rbegin(); b != order.rend(); ++b) {
    std::set<std::size_t> used;
    for (const std::size_t other : neighbours[*b]) used.insert(columns[other]);
    std::size_t column = 0;
    while (used.contains(column)) ++column;
    columns[*b] = column;
  }
  return columns;
}

/// Digits of a number to the base of so many places, the last digit first.
std::vector<int> digits(std::size_t number, std::size_t count) {
  std::vector<int> all(count, 0);
  for (int& digit : all) {
    digit = static_cast<int>(number % places);
    number /= places;
  }
  return all;
}

/// Columns of an orthogonal array of strength two over the field of five elements (Bose 1938): vectors of so many
/// digits whose last digit that is not 0 is 1, no two of which depend on one another. A run is any vector; its place in
/// a column is their product.
std::vector<std::vector<int>> array_columns(std::size_t length) {
  std::vector<std::vector<int>> all;
  std::size_t count = 1;
  for (std::size_t i = 0; i < length; ++i) count *= places;
  for (std::size_t number = 1; number < count; ++number) {
    std::vector<int> one = digits(number, length);
    const auto last = std::find_if(one.rbegin(), one.rend(), [](int digit) { return digit != 0; });
    if (*last == 1) all.push_back(std::move(one));
  }
  return all;
}

void raise(std::optional<double>& value, const std::optional<double>& other) {
  if (other) value = std::max(value.value_or(0), *other);
}

template <class Summary>
void raise_all(const std::vector<Summary>& others, int choice, std::vector<Summary>& all) {
  for (std::size_t i = 0; i < all.size(); ++i) {
    const Summary& other = others[i];
    Summary& one = all[i];
    if (other.gap_needed > one.gap_needed) {
      one.gap_needed = other.gap_needed;
      one.masses = choice;
    }
    if (one.gap_needed_reversed && other.gap_needed_reversed) {
      if (*other.gap_needed_reversed > *one.gap_needed_reversed) one.masses_reversed = choice;
      raise(one.gap_needed_reversed, other.gap_needed_reversed);
    } else {
      one.gap_needed_reversed.reset();  // not known of some masses, so of none
    }
    raise(one.to_come, other.to_come);
    raise(one.to_come_reversed, other.to_come_reversed);
    one.peak_left = std::fmax(one.peak_left, other.peak_left);
    one.peak_right = std::fmax(one.peak_right, other.peak_right);
  }
}

void raise_drifts(const std::vector<LargestDrift>& others, std::vector<LargestDrift>& drifts) {
  if (drifts.empty()) drifts = others;
  for (std::size_t b = 0; b < drifts.size() && b < others.size(); ++b) {
    if (others[b].ratio > drifts[b].ratio) drifts[b] = others[b];
  }
}

void raise_collapse(const std::optional<Collapse>& other, std::optional<Collapse>& collapse) {
  if (other && (!collapse || other->time < collapse->time)) collapse = other;
}

}  // namespace

std::vector<MassPlaces> mass_choices(const PlanProblem& problem) {
  const auto is_moved = [](const std::vector<PlanBuilding>& one) { return !one.empty(); };
  if (std::none_of(problem.elsewhere.begin(), problem.elsewhere.end(), is_moved)) return {};
  const std::vector<std::size_t> columns = columns_of(problem);
  std::size_t needed = 0;
  for (std::size_t b = 0; b < columns.size(); ++b) {
    if (is_moved(problem.elsewhere[b])) needed = std::max(needed, columns[b] + 1);
  }
  std::size_t length = 1, runs = places;
  while (array_columns(length).size() < needed) {
    ++length;
    runs *= places;
  }
  const std::vector<std::vector<int>> array = array_columns(length);
  std::vector<MassPlaces> choices;
  for (std::size_t run = 1; run < runs; ++run) {  // in the first all are where they are expected
    const std::vector<int> row = digits(run, length);
    MassPlaces at(problem.buildings.size(), -1);
    for (std::size_t b = 0; b < at.size(); ++b) {
      if (!is_moved(problem.elsewhere[b])) continue;
      at[b] = std::inner_product(row.begin(), row.end(), array[columns[b]].begin(), 0) % places - 1;
    }
    choices.push_back(std::move(at));
  }
  return choices;
}

PlanProblem with_masses_at(const PlanProblem& problem, const MassPlaces& at) {
  PlanProblem moved = problem;
  moved.elsewhere.clear();
  for (std::size_t b = 0; b < at.size(); ++b) {
    if (at[b] >= 0) moved.buildings[b] = problem.elsewhere[b][static_cast<std::size_t>(at[b])];
  }
  return moved;
}

void raise_needs(const PlanResponse& other, int choice, PlanResponse& response) {
  raise_all(other.points, choice, response.points);
  raise_all(other.watched, choice, response.watched);
  raise_collapse(other.collapse_no_contact, response.collapse_no_contact);
  raise_drifts(drifts_no_contact(other), response.drifts_elsewhere);
  if (!response.reversed || !other.reversed) return;
  raise_collapse(other.reversed->collapse_no_contact, response.reversed->collapse_no_contact);
  raise_drifts(other.reversed->drifts, response.reversed->drifts);
}

}  // namespace bentur
