#include "bentur/structure/frame/infill.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "bentur/core/errors.h"
#include "bentur/core/require.h"
#include "bentur/elements/softening/strut_pair.h"

namespace bentur {
namespace {

using Eigen::Index;

double depth_of(const Section& section) { return std::sqrt(12 * section.inertia / section.area); }

void check(const std::string& name, const Infill& infill) {
  if (infill.thickness == 0) {
    require_positive(name + ".stiffness", infill.stiffness);
    return;
  }
  require_positive(name + ".thickness", infill.thickness);
  require_positive(name + ".modulus", infill.modulus);
  for (const auto& [key, value] :
       {std::pair{".strength", infill.strength}, std::pair{".sliding_strength", infill.sliding_strength}}) {
    if (!(value > 0)) throw InvalidParameter(name + key, fmt::format("{}", value), "must be > 0");  // may be infinite
  }
}

InfillPanel panel_of(const PlaneFrame& frame, const Infill& infill, const std::string& name, Index storey, Index bay) {
  const double storey_height = frame.storey_heights[storey];
  const Section& column = frame.columns[storey];
  const double below = storey > 0 ? depth_of(frame.beams[storey - 1]) : 0.0;
  const double height = storey_height - 0.5 * (depth_of(frame.beams[storey]) + below);
  const double length = frame.bay_widths[bay] - depth_of(column);
  if (!(height > 0 && length > 0)) {
    throw InvalidParameter(
        name, fmt::format("a panel of {:.4g} by {:.4g}", length, height),
        fmt::format("must have room between the columns and beams of storey {}, bay {}", storey + 1, bay + 1));
  }
  const double diagonal = std::hypot(height, length);
  InfillPanel panel{storey, bay, infill.stiffness, infill.backbone, length / diagonal};
  if (infill.thickness > 0) {
    const double t = infill.thickness, sine = 2 * height * length / (diagonal * diagonal);  // sin 2θ
    const double lambda =
        std::pow(infill.modulus * t * sine / (4 * frame.elastic_modulus * column.inertia * height), 0.25);
    const double width = 0.175 * std::pow(lambda * storey_height, -0.4) * diagonal;
    panel.stiffness = infill.modulus * width * t * panel.cosine * panel.cosine / diagonal;
    panel.backbone.yield = std::min(width * t * infill.strength * panel.cosine, infill.sliding_strength * t * length);
  }
  const double at_yield = panel.backbone.yield / panel.stiffness;
  if (std::isfinite(at_yield) && !(panel.backbone.ultimate > at_yield)) {
    throw InvalidParameter(name + ".backbone.ultimate", fmt::format("{}", panel.backbone.ultimate),
                           fmt::format("must be beyond yielding: storey {} yields at {:.4g}", storey + 1, at_yield));
  }
  if (std::isfinite(panel.backbone.yield)) static_cast<void>(StrutPair(panel.stiffness, panel.backbone));
  return panel;
}

}  // namespace

std::vector<InfillPanel> infill_panels(const PlaneFrame& frame) {
  std::vector<InfillPanel> panels;
  if (frame.infills.empty()) return panels;
  require_size("infills", frame.infills.size(), frame.storey_heights.size());
  for (std::size_t j = 0; j < frame.infills.size(); ++j) {
    if (!frame.infills[j]) continue;
    check(indexed("infills", j), *frame.infills[j]);
    for (Index bay = 0; bay < std::ssize(frame.bay_widths); ++bay) {
      panels.push_back(panel_of(frame, *frame.infills[j], indexed("infills", j), static_cast<Index>(j), bay));
    }
  }
  return panels;
}

Eigen::MatrixXd infill_stiffness(const std::vector<InfillPanel>& panels, Index floors) {
  Eigen::MatrixXd stiffness = Eigen::MatrixXd::Zero(floors, floors);
  for (const InfillPanel& panel : panels) {
    const Index j = panel.storey;
    stiffness(j, j) += panel.stiffness;
    if (j == 0) continue;
    stiffness(j - 1, j - 1) += panel.stiffness;
    stiffness(j, j - 1) -= panel.stiffness;
    stiffness(j - 1, j) -= panel.stiffness;
  }
  return stiffness;
}

std::vector<StrutOnColumn> struts_on_columns(const std::vector<InfillPanel>& panels, const Hinges& hinges) {
  std::vector<StrutOnColumn> found;
  const std::vector<BreakingColumn>& columns = hinges.columns;
  for (Index panel = 0; panel < std::ssize(panels); ++panel) {
    const InfillPanel& of = panels[panel];
    for (const Index line : {of.bay + 1, of.bay + 2}) {
      Index lowest = -1, highest = -1;
      for (Index c = 0; c < std::ssize(columns); ++c) {
        if (columns[c].storey != of.storey + 1 || columns[c].line != line) continue;
        if (lowest < 0 || columns[c].piece < columns[lowest].piece) lowest = c;
        if (highest < 0 || columns[c].piece > columns[highest].piece) highest = c;
      }
      if (lowest >= 0) found.push_back({panel, lowest});
      if (highest != lowest) found.push_back({panel, highest});
    }
  }
  return found;
}

}  // namespace bentur
