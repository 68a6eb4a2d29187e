#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>

#include "bentur/pounding/plan/faces.h"
#include "bentur/pounding/plan/outline/parts.h"

namespace bentur {
namespace {

/// How much of half the joint's stiffness a length of it adds to that of a corner: 0 up to `spread`, 1 from twice that.
double grown(double length, double spread) {
  return spread > 0 ? std::clamp((length - spread) / spread, 0.0, 1.0) : 1.0;
}

/// Places along a joint, in order, with how far each stands back from the first ones to touch.
struct Standing {
  double along = 0, beyond = 0;
  bool is_end = false, is_inner = false;  ///< inner: not at a corner
};

/// Shares of the places that stand out, those of least `beyond`, and of the others; 0 where a place is none.
std::vector<double> shares_of(const std::vector<Standing>& places, double spread) {
  const double length = places.back().along - places.front().along;
  std::vector<double> shares(places.size(), 0.0);
  std::vector<std::size_t> first, chosen;
  for (std::size_t i = 0; i < places.size(); ++i) {
    if (places[i].beyond == 0) first.push_back(i);
  }
  const double flat = places[first.back()].along - places[first.front()].along;
  if (first.size() == 1) {
    shares[first.front()] = share_of_corner;
  } else {  // as an even bed between both ends
    const double all = share_of_corner * (1 + grown(flat, spread));
    for (std::size_t n = 1; n < first.size(); ++n) {
      const double part = all * (places[first[n]].along - places[first[n - 1]].along) / flat;
      shares[first[n - 1]] += 0.5 * part;
      shares[first[n]] += 0.5 * part;
    }
  }
  chosen = first;
  std::vector<std::size_t> by_beyond(places.size());
  std::iota(by_beyond.begin(), by_beyond.end(), 0U);
  std::stable_sort(by_beyond.begin(), by_beyond.end(),
                   [&](std::size_t a, std::size_t b) { return places[a].beyond < places[b].beyond; });
  for (const bool ends : {true, false}) {
    for (const std::size_t i : by_beyond) {
      if (places[i].beyond == 0 || places[i].is_end != ends) continue;
      const bool is_near = std::any_of(chosen.begin(), chosen.end(), [&](std::size_t other) {
        return std::abs(places[other].along - places[i].along) < spread;
      });
      if (ends || places[i].is_inner || !is_near) chosen.push_back(i);
    }
  }
  std::sort(chosen.begin(), chosen.end());
  double whole = 0;
  std::vector<double> own(places.size(), 0.0);
  for (std::size_t n = 0; n < chosen.size(); ++n) {
    const std::size_t i = chosen[n];
    if (places[i].beyond == 0) continue;
    if (n > 0) own[i] += 0.5 * (places[i].along - places[chosen[n - 1]].along);
    if (n + 1 < chosen.size()) own[i] += 0.5 * (places[chosen[n + 1]].along - places[i].along);
    whole += own[i];
  }
  for (std::size_t i = 0; whole > 0 && i < places.size(); ++i) {
    shares[i] += share_of_corner * grown(length, spread) * own[i] / whole;
  }
  return shares;
}

}  // namespace

std::vector<StretchPoint> points_of(const Stretch& stretch, int points, std::optional<double> spread) {
  std::vector<Standing> places;
  if (stretch.corners.empty()) {
    places = {{.along = stretch.from, .is_end = true}, {.along = stretch.to, .is_end = true}};
  }
  for (const StretchCorner& corner : stretch.corners) {
    if (stretch.includes(corner)) places.push_back({corner.along, corner.beyond});
  }
  places.front().is_end = places.back().is_end = true;
  std::vector<Standing> all = {places.front()};
  for (std::size_t piece = 1; piece < places.size(); ++piece) {
    const Standing &from = places[piece - 1], &to = places[piece];
    for (int i = 1; i < points - 1; ++i) {
      const double part = static_cast<double>(i) / (points - 1);
      all.push_back({.along = from.along + part * (to.along - from.along),
                     .beyond = from.beyond + part * (to.beyond - from.beyond),
                     .is_inner = true});
    }
    all.push_back(to);
  }
  constexpr double part_of_shorter = 0.25;
  const std::vector<double> shares = shares_of(all, spread.value_or(part_of_shorter * stretch.shorter));
  std::vector<StretchPoint> found;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (shares[i] > 0) found.push_back({all[i].along, shares[i]});
  }
  return found;
}

namespace {

std::vector<StretchPoint> points_of_convex(const Footprint& left, const Footprint& right, const Stretch& joint,
                                           int points, double reach, std::optional<double> spread) {
  std::vector<StretchPoint> all = points_of(joint, points, spread);
  const std::vector<FamilyBeside> families = families_beside(left, right, joint, reach);
  if (families.empty()) return all;
  for (StretchPoint& one : all) one.family = 0;
  for (std::size_t f = 0; f < families.size(); ++f) {
    const std::vector<StretchCorner>& places = families[f].places;
    for (const StretchCorner& place : places) {
      all.push_back(
          {place.along, share_of_corner / static_cast<double>(places.size()), static_cast<Eigen::Index>(f) + 1, place});
    }
  }
  return all;
}

/// Whether a point is of the outlines: between two corners where both are.
bool is_of_outlines(const PartPair& pair, const StretchPoint& point) {
  if (point.beside) return is_of_outlines(pair, *point.beside);
  const std::vector<StretchCorner>& corners = pair.joint.corners;
  const auto after =
      std::find_if(corners.begin(), corners.end(), [&](const StretchCorner& one) { return one.along >= point.along; });
  if (after == corners.end() || !is_of_outlines(pair, *after)) return false;
  return after->along == point.along || after == corners.begin() || is_of_outlines(pair, *std::prev(after));
}

/// The points of one pair of parts, seen from the joint of the outlines.
std::vector<StretchPoint> points_of_pair(const PartPair& pair, const Stretch& joint, Eigen::Index number, int points,
                                         double reach, std::optional<double> spread) {
  std::vector<StretchPoint> all = points_of_convex(pair.of_l(), pair.of_r(), pair.joint, points, reach, spread);
  const PlanPoint axis(-joint.n.y(), joint.n.x());
  for (StretchPoint& one : all) {
    one.pair = number;
    one.seam = !is_of_outlines(pair, one);
    if (number == 0) continue;
    StretchCorner place = one.beside ? *one.beside : pair.joint.at(one.along);
    if (pair.joint.swapped) place = place.turned();
    place.beyond += pair.joint.width - joint.width;
    place.along = one.along = axis.dot(0.5 * (place.left + place.right));
    one.beside = place;
  }
  std::erase_if(all, [](const StretchPoint& one) { return one.seam && one.family < 0; });
  if (std::all_of(all.begin(), all.end(), [](const StretchPoint& one) { return one.seam; })) all.clear();
  return all;
}

}  // namespace

std::vector<StretchPoint> points_between(const Footprint& left, const Footprint& right, const Stretch& joint,
                                         int points, double reach, std::optional<double> spread) {
  if (left.is_convex() && right.is_convex()) return points_of_convex(left, right, joint, points, reach, spread);
  std::vector<StretchPoint> all;
  Eigen::Index number = 0;
  for (const PartPair& pair : pairs_of_parts(left, right, reach)) {
    const std::vector<StretchPoint> found = points_of_pair(pair, joint, number++, points, reach, spread);
    all.insert(all.end(), found.begin(), found.end());
  }
  return all;
}

}  // namespace bentur
