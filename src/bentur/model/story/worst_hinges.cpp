#include "bentur/model/story/worst_hinges.h"

#include <algorithm>

namespace bentur {

std::vector<Eigen::Index> worst_hinges(const BuildingPeaks& peaks) {
  constexpr double alike = 1e-9;  // of the larger
  std::vector<Eigen::Index> hinges;
  for (Eigen::Index h = 0; h < std::ssize(peaks.hinges); ++h) {
    if (peaks.hinges[h].first_yield) hinges.push_back(h);
  }
  const auto turned = [&](Eigen::Index h) { return peaks.hinges[h].peak_rotation; };
  std::stable_sort(hinges.begin(), hinges.end(), [&](Eigen::Index a, Eigen::Index b) { return turned(a) > turned(b); });
  for (auto first = hinges.begin(); first != hinges.end();) {
    const double largest = turned(*first);
    const auto end =
        std::find_if(first, hinges.end(), [&](Eigen::Index h) { return turned(h) < largest * (1 - alike); });
    std::sort(first, end);
    first = end;
  }
  return hinges;
}

}  // namespace bentur
