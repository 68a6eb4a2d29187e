#include <algorithm>
#include <array>
#include <limits>
#include <optional>
#include <set>
#include <utility>

#include "bentur/model/judgement/judged_gaps.h"
#include "bentur/model/story/judgement_story.h"
#include "bentur/model/story/story.h"
#include "bentur/report/kinds/internal/plan_figures.h"
#include "bentur/report/kinds/internal/run_figures.h"
#include "bentur/report/story_text.h"
#include "bentur/report/words.h"

namespace bentur {
namespace {

/// A block from above, at rest and to scale.
class BlockMap {
 public:
  BlockMap(const PlanRun& run, const FigureOptions& options)
      : run_(run), say_(options.language), judged_(judged_gaps(run)), order_(worst_first(judged_)) {}

  Panel panel(double height) {
    panel_ = {.x = {.numbers = false}, .y = {.numbers = false}, .height = height, .to_scale = true};
    for (std::size_t b = 0; b < run_.problem.buildings.size(); ++b) add_house(b);
    for (const bool corners : {false, true}) {  // the worst above all others
      for (auto gap = order_.rbegin(); gap != order_.rend(); ++gap) {
        if (run_.problem.gaps[*gap].stretch.is_corner() == corners) add_gap(*gap);
      }
    }
    add_legend();
    const double margin = 0.015 * (upper_ - lower_).maxCoeff();  // so that outer walls are drawn whole
    panel_.x.from = lower_.x() - margin, panel_.x.to = upper_.x() + margin;
    panel_.y.from = lower_.y() - margin, panel_.y.to = upper_.y() + margin;
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
    if (PlaceText name = place_of_name(building.name, rings, {0.42, 0.85, 0.15}); name.room > 0) {
      panel_.texts.push_back(std::move(name));
    }
  }

  /// Along the joint, in the middle between both; where they stand corner to corner a disc.
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
      curve.mark = Mark::disc;
      curve.mark_size = 2.5;
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
      curve.in_legend = true;
      curve.x.resize(1);
      curve.y.resize(1);
      panel_.curves.push_back(std::move(curve));
    }
    const auto is_disc = [](const Curve& one) { return one.mark == Mark::disc; };
    const auto disc = std::find_if(panel_.curves.begin(), panel_.curves.end(), is_disc);
    if (disc == panel_.curves.end()) return;
    Curve corner = *disc;  // below it
    corner.label = say_("figure.text.corner_to_corner");
    corner.tone = Tone::grey;
    corner.in_legend = true;
    panel_.curves.insert(panel_.curves.begin(), std::move(corner));
  }

  /// Where the table of the worst has it: on the joint, off its middle, beside which names of houses stand; of corners
  /// beside the lines that meet there.
  void add_number(std::size_t place, Curve& grounds) {
    const Stretch& stretch = run_.problem.gaps[order_[place]].stretch;
    const std::vector<double> corners = stretch.corners_along();
    const double off = stretch.is_corner() ? 0.02 * (upper_ - lower_).maxCoeff() : 0;
    const PlanPoint at = stretch.middle(corners.front() + 0.85 * (corners.back() - corners.front()));
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
          .panels = {BlockMap(run, options).panel(0.72 * options.width)},
          .width = options.width};
}

}  // namespace bentur
