#include <algorithm>
#include <array>
#include <limits>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>

#include "bentur/core/not_known.h"
#include "bentur/core/number_text.h"
#include "bentur/model/judgement/judged_gaps.h"
#include "bentur/model/story/judgement_story.h"
#include "bentur/model/story/story.h"
#include "bentur/report/figures/internal/text_width.h"
#include "bentur/report/kinds/internal/plan_figures.h"
#include "bentur/report/kinds/internal/run_figures.h"
#include "bentur/report/scene/scene.h"
#include "bentur/report/story_text.h"
#include "bentur/report/words.h"

namespace bentur {
namespace {

/// A block from above, at rest and to scale.
class BlockMap {
 public:
  BlockMap(const PlanRun& run, const FigureOptions& options)
      : run_(run), say_(options.language), judged_(judged_gaps(run)), order_(worst_first(judged_)) {}

  Panel panel(double width, double height) {
    panel_ = {.x = {.numbers = false},
              .y = {.numbers = false},
              .height = height,
              .to_scale = true,
              .unit = run_.c.units.length};
    for (std::size_t b = 0; b < run_.problem.buildings.size(); ++b) add_house(b);
    const PlanPoint size = upper_ - lower_;
    constexpr double margins = 0.6;  // beside the frame [cm]
    one_cm_ = std::max(size.x() / (width - margins), size.y() / (height - below));
    add_names();
    for (const bool corners : {false, true}) {  // the worst above all others
      for (auto gap = order_.rbegin(); gap != order_.rend(); ++gap) {
        if (run_.problem.gaps[*gap].stretch.is_corner() == corners) add_gap(*gap);
      }
    }
    add_legend();
    const double margin = 0.015 * (upper_ - lower_).maxCoeff();  // so that outer walls are drawn whole
    panel_.x.from = lower_.x() - margin, panel_.x.to = upper_.x() + margin;
    panel_.y.from = lower_.y() - margin - below * one_cm_, panel_.y.to = upper_.y() + margin;
    add_scale();
    add_directions();
    Curve grounds{.label = say_("figure.text.place_among_worst"),
                  .line = Line::none,
                  .mark = Mark::circle,
                  .complete = true,
                  .mark_size = 5};  // with room for two digits
    for (std::size_t i = 0; i < std::min(worst_gaps_shown, order_.size()); ++i) add_number(i, grounds);
    panel_.curves.push_back(std::move(grounds));
    return std::move(panel_);
  }

 private:
  static constexpr double below = 0.9;  // the block, of the scale [cm]

  /// So that they are told apart in grey too.
  static Line line_of(Sufficiency value) {
    return value == Sufficiency::too_small ? Line::solid : value == Sufficiency::unknown ? Line::dashed : Line::dotted;
  }

  /// The worst of all its gaps; nothing of one that has none.
  [[nodiscard]] std::optional<Sufficiency> worst_of(std::size_t building) const {
    const auto number = static_cast<Eigen::Index>(building);
    for (const std::size_t g : order_) {
      const PlanGap& gap = run_.problem.gaps[g];
      if (gap.left == number || gap.right == number) return judged_[g].judgement.value;
    }
    return std::nullopt;
  }

  void add_house(std::size_t b) {
    const PlanBuilding& building = run_.problem.buildings[b];
    const std::optional<Sufficiency> worst = worst_of(b);
    std::vector<std::vector<PlanPoint>> rings = building.model.footprint.all_rings();
    for (std::vector<PlanPoint>& ring : rings) {
      ring.push_back(ring.front());
      Curve curve{.label = building.name, .tone = worst ? tone_of(*worst) : Tone::grey, .complete = true};
      if (worst) curve.line = line_of(*worst);
      curve.in_legend = false;
      for (const PlanPoint& at : ring) add(curve, at);
      for (const PlanPoint& at : ring) {
        lower_ = lower_.cwiseMin(at);
        upper_ = upper_.cwiseMax(at);
      }
      panel_.curves.push_back(std::move(curve));
    }
    rings_.push_back(std::move(rings));
  }

  void add_names() {
    const NameRows rows{.parts = {0.42, 0.85, 0.15}, .half_height = 0.5 * high_name * one_cm_};
    for (PlaceText& name : places_of_names(run_.problem, rings_, rows, one_cm_)) {
      constexpr std::size_t least = 3;  // letters that tell one house from another
      const std::string cut = cut_to(name.text, name.room / one_cm_);
      const bool is_word = name.text.find(' ') == std::string::npos;  // which no second line makes narrower
      if (is_word && cut.size() >= least + std::string_view("…").size()) name.text = cut;
      if (name.room > 0) panel_.texts.push_back(std::move(name));
    }
  }

  /// A round length below the block.
  void add_scale() {
    const double length = at_most_125(0.3 * (upper_ - lower_).x()), cap = 0.1 * one_cm_;
    const double left = lower_.x(), right = left + length, y = lower_.y() - 0.7 * below * one_cm_;
    panel_.curves.push_back({.x = {left, left, not_known, left, right, not_known, right, right},
                             .y = {y - cap, y + cap, not_known, y, y, not_known, y - cap, y + cap},
                             .width = 0.9,
                             .complete = true,
                             .in_legend = false});
    panel_.texts.push_back({.x = right, .y = y, .text = number(length) + " " + run_.c.units.length});
  }

  /// Two arrows along the axes of the case, below the block.
  void add_directions() {
    const double length = 0.6 * one_cm_, head = 0.12 * one_cm_;
    const double x = upper_.x() - length - 0.3 * one_cm_, y = lower_.y() - 0.85 * below * one_cm_;
    panel_.curves.push_back({.x = {x + length - head, x + length, x + length - head, not_known, x + length, x, x,
                                   not_known, x - head, x, x + head},
                             .y = {y + head, y, y - head, not_known, y, y, y + length, not_known, y + length - head,
                                   y + length, y + length - head},
                             .width = 0.9,
                             .complete = true,
                             .in_legend = false});
    panel_.texts.push_back({.x = x + length, .y = y, .text = "x"});
    panel_.texts.push_back({.x = x, .y = y + length - head, .text = "y", .side = PlaceText::Side::left});
  }

  /// Along the joint, in the middle between both; where they stand corner to corner a mark, full where the gap is too
  /// small, open where that is not known, small where it is enough, so that they are told apart in grey too.
  void add_gap(std::size_t g) {
    const Stretch& stretch = run_.problem.gaps[g].stretch;
    Curve curve{.label = gap_name(run_.problem, run_.problem.gaps[g]),
                .tone = tone_of(judged_[g].judgement.value),
                .line = line_of(judged_[g].judgement.value),
                .width = 4,
                .complete = true};
    curve.in_legend = false;
    if (stretch.is_corner()) {
      curve.line = Line::none;
      const Sufficiency value = judged_[g].judgement.value;
      curve.mark = value == Sufficiency::unknown ? Mark::circle : Mark::disc;
      curve.mark_size = value == Sufficiency::too_small ? 3 : value == Sufficiency::unknown ? 2 : 1.5;
    }
    for (const double along : stretch.corners_along()) add(curve, stretch.middle(along));
    used_.insert(judged_[g].judgement.value);
    panel_.curves.push_back(std::move(curve));
  }

  /// What the colours are, each in the legend once: a curve within the first of its kind.
  void add_legend() {
    for (const Sufficiency value : used_) {
      const auto same = [&](const Curve& one) { return one.tone == tone_of(value); };
      const auto first = std::find_if(panel_.curves.begin(), panel_.curves.end(), same);
      if (first == panel_.curves.end()) continue;
      Curve curve = *first;
      curve.label = say_(judgement_word(value));
      curve.width = 4;
      const auto is_corner = [&](const Curve& one) { return same(one) && one.mark != Mark::none; };
      const auto corner = std::find_if(panel_.curves.begin(), panel_.curves.end(), is_corner);
      if (corner != panel_.curves.end()) {
        curve.legend_mark = corner->mark;
        curve.mark_size = corner->mark_size;
      }
      curve.in_legend = true;
      curve.x.resize(1);
      curve.y.resize(1);
      panel_.curves.push_back(std::move(curve));
    }
  }

  /// Where the table of the worst has it: on the joint, off its middle, beside which names of houses stand; of corners
  /// beside the lines that meet there.
  void add_number(std::size_t place, Curve& grounds) {
    const Stretch& stretch = run_.problem.gaps[order_[place]].stretch;
    const std::vector<double> corners = stretch.corners_along();
    const double off = stretch.is_corner() ? 0.02 * (upper_ - lower_).maxCoeff() : 0;
    const PlanPoint at = stretch.middle(corners.front() + 0.72 * (corners.back() - corners.front()));
    add(grounds, at + PlanPoint::Constant(off));
    panel_.texts.push_back({.x = grounds.x.back(),
                            .y = grounds.y.back(),
                            .text = std::to_string(place + 1),
                            .side = PlaceText::Side::middle});
  }

  static void add(Curve& curve, const PlanPoint& at) {
    curve.x.push_back(at.x());
    curve.y.push_back(at.y());
  }

  const PlanRun& run_;
  Words say_;
  std::vector<JudgedGap> judged_;
  std::vector<std::size_t> order_;  // of the gaps, the worst first
  std::set<Sufficiency> used_;
  PlanPoint lower_ = PlanPoint::Constant(std::numeric_limits<double>::infinity()), upper_ = -lower_;  // of all houses
  std::vector<PlanRings> rings_;                                                                      // of all houses
  double one_cm_ = 0;  // of the picture, about [length]
  Panel panel_;
};

/// What the verdict says of all gaps together.
std::string finding_of(const PlanRun& run, const FigureOptions& options) {
  for (const SaidStatement& one : said(run_story(run).statements, Words(options.language))) {
    if (one.kind.starts_with("row_")) return one.text;
  }
  return {};
}

}  // namespace

Figure map_figure(const PlanRun& run, const FigureOptions& options) {
  return {.title = "The block from above, by what is judged of its gaps",
          .finding = finding_of(run, options),
          .panels = {BlockMap(run, options).panel(options.width, 0.8 * options.width)},
          .width = options.width};
}

}  // namespace bentur
