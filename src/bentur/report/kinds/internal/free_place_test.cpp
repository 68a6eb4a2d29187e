#include "bentur/report/kinds/internal/free_place.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "bentur/report/figures/box.h"
#include "bentur/report/figures/internal/text_width.h"
#include "bentur/report/kinds/kinds.h"
#include "tests/support/drawn_run.h"

namespace bentur {
namespace {

std::string example_text(const std::string& name) {
  std::ifstream stream(std::string(BENTUR_SOURCE_DIR) + "/examples/" + name + ".toml");
  return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

/// A picture to scale in centimetres.
struct Picture {
  const Panel& panel;
  const PanelPlace& place;

  [[nodiscard]] double cm(double length) const {
    constexpr double pixel = 2.54 / 96;
    return length * pixel * place.width / (place.x.second - place.x.first);
  }
  [[nodiscard]] Box box(const PlaceText& text) const {
    const double half = text_width(text.text) / 2, high = 0.13;
    return {cm(text.x) - half, cm(text.x) + half, cm(text.y) - high, cm(text.y) + high};
  }
  [[nodiscard]] double distance(const Box& box, const Curve& dot) const {
    const double x = cm(dot.x.front()), y = cm(dot.y.front());
    return std::hypot(std::max({0.0, box.left - x, x - box.right}), std::max({0.0, box.bottom - y, y - box.top}));
  }
  /// Whether a line to a dot, but for its beginning there, passes a member of the frame.
  [[nodiscard]] bool passes_a_member(const Curve& leader) const {
    const Curve& members = *std::find_if(panel.curves.begin(), panel.curves.end(),
                                         [](const Curve& one) { return one.label == "members"; });
    const double x = cm(leader.x[0]), y = cm(leader.y[0]), to_x = cm(leader.x[1]), to_y = cm(leader.y[1]);
    const double part = std::min(1.0, 0.1 / std::hypot(to_x - x, to_y - y));
    for (std::size_t n = 1; n < members.x.size(); ++n) {
      if (std::isnan(members.x[n - 1]) || std::isnan(members.x[n])) continue;
      constexpr double half = 0.01;  // [cm]
      const Box line{
          cm(std::min(members.x[n - 1], members.x[n])) - half, cm(std::max(members.x[n - 1], members.x[n])) + half,
          cm(std::min(members.y[n - 1], members.y[n])) - half, cm(std::max(members.y[n - 1], members.y[n])) + half};
      if (line.meets(x + part * (to_x - x), y + part * (to_y - y), to_x, to_y)) return true;
    }
    return false;
  }
};

/// The dot nearest to each value is its own, and is near; a line between both passes no member.
/// @param has_room else bays are narrower than a value
void expect_values_beside_their_dots(const Picture& picture, bool has_room, const std::string& what) {
  std::vector<const Curve*> dots;
  for (const Curve& curve : picture.panel.curves) {
    if (curve.mark == Mark::disc) dots.push_back(&curve);
    if (curve.line == Line::none || curve.x.size() != 2) continue;
    const double long_leader = 1;  // [cm]
    EXPECT_LT(picture.cm(std::hypot(curve.x[1] - curve.x[0], curve.y[1] - curve.y[0])), long_leader)
        << what << ": " << curve.label;
    EXPECT_FALSE(has_room && picture.passes_a_member(curve)) << what << ": " << curve.label;
  }
  std::size_t values = 0;
  for (const PlaceText& text : picture.panel.texts) {
    if (text.side != PlaceText::Side::middle) continue;  // of the bar below the frame
    const Box box = picture.box(text);
    std::sort(dots.begin(), dots.end(),
              [&](const Curve* a, const Curve* b) { return picture.distance(box, *a) < picture.distance(box, *b); });
    ASSERT_FALSE(dots.empty()) << what;
    EXPECT_TRUE(dots.front()->label == text.text || dots.front()->tone == Tone::red)
        << what << ": " << text.text << " stands at the dot of " << dots.front()->label;
    EXPECT_LT(picture.distance(box, *dots.front()), 1.1) << what << ": " << text.text;
    ++values;
  }
  EXPECT_EQ(values, dots.size()) << what;
}

TEST(FreePlace, ValuesOfFramesStandAtTheirOwnMembers) {
  int looked_at = 0;
  for (const std::string name : {"hinged-frame", "m12-el-centro", "row-of-three", "struck-column", "two-frames-si"}) {
    const RunResults run = test::drawn_run(example_text(name));
    for (const bool narrow : {false, true}) {
      FigureOptions options;
      options.narrow = narrow;
      for (const std::string kind : {"frame-forces", "frame-envelope", "frame-moment", "frame-shear", "frame-axial"}) {
        const Figure figure = make_figure(run, kind, options);
        const std::vector<PanelPlace> places = placed_figure(figure, "").panels;
        for (std::size_t i = 0; i < places.size(); ++i) {
          expect_values_beside_their_dots({figure.panels[i], places[i]}, !narrow,
                                          name + ", " + kind + ", " + figure.panels[i].title);
          ++looked_at;
        }
      }
    }
  }
  EXPECT_GT(looked_at, 100);
}

}  // namespace
}  // namespace bentur
