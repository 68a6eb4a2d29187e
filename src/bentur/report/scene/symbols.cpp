#include "bentur/report/scene/internal/symbols.h"

#include <utility>

namespace bentur::scene {

ScenePoint between(const ScenePoint& a, const ScenePoint& b, double share, double rise) {
  ScenePoint point{.height = (1 - share) * a.height + share * b.height + rise};
  for (const auto& [end, weight] : {std::pair{&a, 1 - share}, std::pair{&b, share}}) {
    for (SceneMover mover : end->movers) {
      mover.weight *= weight;
      if (mover.weight != 0) point.movers.push_back(mover);
    }
  }
  return point;
}

namespace {

/// A zigzag with a straight part at both ends, each tooth `across` and `rise` beside the line.
SceneLine zigzag(const ScenePoint& a, const ScenePoint& b, double across, double rise) {
  constexpr int teeth = 6;
  constexpr double lead = 0.2;
  SceneLine line = {a, between(a, b, lead)};
  for (int i = 0; i < teeth; ++i) {
    const double side = i % 2 == 0 ? 1 : -1;
    line.push_back(between(a, b, lead + (1 - 2 * lead) * (i + 0.5) / teeth, side * rise));
    for (SceneMover& mover : line.back().movers) mover.offset += side * across;
  }
  line.insert(line.end(), {between(a, b, 1 - lead), b});
  return line;
}

}  // namespace

std::vector<SceneLine> spring(const ScenePoint& a, const ScenePoint& b, double size) { return {zigzag(a, b, 0, size)}; }

SceneLine upright_spring(const ScenePoint& a, const ScenePoint& b, double size) { return zigzag(a, b, size, 0); }

std::vector<SceneLine> bar(const ScenePoint& a, const ScenePoint& b, double /*size*/) { return {{a, b}}; }

std::vector<SceneLine> damper(const ScenePoint& a, const ScenePoint& b, double size) {
  const auto at = [&](double share, double rise) { return between(a, b, share, rise); };
  return {{a, at(0.5, 0)},
          {at(0.5, 0.6 * size), at(0.5, -0.6 * size)},
          {at(0.35, size), at(0.65, size), at(0.65, -size), at(0.35, -size)},
          {at(0.65, 0), b}};
}

std::vector<SceneLine> plates(const ScenePoint& a, const ScenePoint& b, double size) {
  const auto at = [&](double share, double rise) { return between(a, b, share, rise); };
  return {{a, at(0.15, 0), at(0.15, 0.5 * size), at(0.7, 0.5 * size)},
          {b, at(0.85, 0), at(0.85, -0.5 * size), at(0.3, -0.5 * size)},
          {at(0.5, size), at(0.5, -size)}};
}

std::vector<SceneLine> cable(const ScenePoint& a, const ScenePoint& b, double size) {
  constexpr int parts = 8;
  SceneLine line;
  for (int i = 0; i <= parts; ++i) {
    const double share = static_cast<double>(i) / parts;
    line.push_back(between(a, b, share, -4 * share * (1 - share) * size));
  }
  return {line};
}

}  // namespace bentur::scene
