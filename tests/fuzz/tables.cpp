// Any bytes as a table of mode shapes, by the length by floors or as ETABS or SAP2000 write it, and as the hazard curve
// of a site.
#include <algorithm>
#include <cmath>

#include "bentur/io/exchange/mode_shapes.h"
#include "bentur/study/risk/hazard.h"
#include "tests/fuzz/support.h"

namespace bentur::fuzz {
namespace {

const std::vector<double> floors = {3.5, 7, 10.5};

void read_shapes(const std::string& input, const ShapesAsked& asked) {
  Diagnostics diagnostics;
  const auto shapes = mode_shapes(input, "fuzzed.csv", asked, diagnostics);
  demand(shapes.has_value() == diagnostics.ok(), "a table is refused without a message, or read with one");
  if (!shapes) return;
  accepted();
  demand(shapes->size() == asked.modes, "a table has not as many modes as were asked for");
  for (const std::vector<double>& mode : *shapes) {
    demand(mode.size() == asked.elevations.size(), "a mode has not a number for each floor");
    const auto finite = [](double x) { return std::isfinite(x); };
    demand(std::all_of(mode.begin(), mode.end(), finite), "a mode has what is no number");
  }
}

void read_curve(const std::string& input, const HazardOptions& options) {
  Diagnostics diagnostics;
  const auto curve = hazard_of(input, "fuzzed.csv", options, diagnostics);
  demand(curve.has_value() == diagnostics.ok(), "a curve is refused without a message, or read with one");
  if (!curve) return;
  accepted();
  demand(curve->intensity.size() == curve->rate.size() && curve->rate.size() > 1, "a curve has no segment");
  for (std::size_t i = 0; i < curve->rate.size(); ++i) {
    demand(curve->intensity[i] > 0 && std::isfinite(curve->intensity[i]), "an intensity is no number > 0");
    demand(curve->rate[i] > 0 && std::isfinite(curve->rate[i]), "a frequency is no number > 0");
    demand(i == 0 || curve->intensity[i] > curve->intensity[i - 1], "intensities do not ascend");
    demand(i == 0 || curve->rate[i] <= curve->rate[i - 1], "a larger intensity is exceeded more often");
  }
}

}  // namespace

void feed(const std::string& input) {
  const std::size_t which = input.size();
  if (which % 3 == 0) read_shapes(input, {.elevations = floors, .modes = 2});
  if (which % 3 == 1) read_shapes(input, {.elevations = floors, .modes = 2, .component = "UX"});
  if (which % 3 == 2) {
    read_shapes(input, {.elevations = floors, .modes = 1, .names = {"1", "2", "3"}, .component = "U1", .numbers = {2}});
  }
  if (which % 2 == 0) read_curve(input, {});
  if (which % 2 == 1) read_curve(input, {.site = 2, .unit = "g"});
}

}  // namespace bentur::fuzz
