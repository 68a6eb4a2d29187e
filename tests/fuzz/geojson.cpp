// Any bytes as GeoJSON, of degrees as it stands and of metres with every option; a block that is read becomes a case.
#include <optional>

#include "bentur/io/exchange/block_case.h"
#include "tests/fuzz/support.h"

namespace bentur::fuzz {
namespace {

void import_block(const std::string& input, const GeoJsonOptions& options, const BlockRules& rules) {
  Diagnostics diagnostics;
  const auto houses = read_geojson(input, "fuzzed.geojson", options, diagnostics);
  demand(houses.has_value() == diagnostics.ok(), "a block is refused without a message, or read with one");
  if (!houses) return;
  for (const House& one : houses->all)
    demand(!one.name.empty() && !one.outline.empty(), "a house has no name or corner");
  const auto made = make_block_case(*houses, "fuzzed.geojson", rules, diagnostics);
  demand(made.has_value() == diagnostics.ok(), "a case is refused without a message, or made with one");
  for (const Diagnostic& one : diagnostics.errors()) {
    demand(one.message().find("would become a case with an error") == std::string::npos, one.message());
  }
  accepted(made.has_value());
}

}  // namespace

void feed(const std::string& input) {
  import_block(input, {}, {});
  import_block(input, {.metres = true, .parts = true, .unread_as_none = true}, {.hull = true, .storeys = 2});
  import_block(input, {.parts = true, .levels = "layer_no", .around = "107.61,-6.92", .radius = 1e4},
               {.snap = 5, .hull = true, .clearance = 20, .storeys = 1});
  import_block(input, {.parts = true, .around = "A", .radius = 30, .without = {"B"}, .unread_as_none = true},
               {.hull = true, .storeys = 3});
}

}  // namespace bentur::fuzz
