#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "bentur/core/not_known.h"
#include "bentur/io/toml/toml_view.h"
#include "bentur/model/judgement/open_needs.h"
#include "bentur/study/fragility/ida_results.h"
#include "bentur/study/study_variables.h"

namespace bentur {
namespace {

/// Buildings in plan whose rigidity is given as sums, so that nothing says how far a storey drifts at its edges.
std::vector<std::string> buildings_without_drift(const ResultSource& file) {
  std::vector<std::string> result;
  for (int b = 1; file.has(fmt::format("peak_rotation_{}", b)) || file.has(fmt::format("peak_rotation_{}", b + 1));
       ++b) {
    const std::string rotation = fmt::format("peak_rotation_{}", b);
    if (!file.has(rotation) || file.has(fmt::format("{}_{}", plane_drift, b))) continue;
    result.push_back(file.attribute(rotation, "building"));
  }
  return result;
}

class Reader {
 public:
  Reader(const ResultSource& file, const EventRule& event) : file_(file), event_(event) {
    const StoredVariable* intensity = file_.find("intensity");
    const StoredVariable* records = file_.find("record_intensity");
    const StoredVariable* status = file_.find("status");
    if (intensity == nullptr || records == nullptr || status == nullptr) {
      file_.fail(status != nullptr && file_.find("message") != nullptr
                     ? "holds the results of a sweep: a fragility needs those of bentur ida"
                     : "does not hold the results of bentur ida");
    }
    runs_ = status->dimensions;
    sizes_ = status->shape;
    roles_.resize(runs_.size());
    results_.title = file_.attribute("title");
    results_.intensity = intensity->long_name;
    results_.units = intensity->units;
    results_.study_unit = file_.attribute("intensity", "study_unit");
    // Of a cloud each record has an intensity, and there are no levels.
    const bool is_cloud = intensity->dimensions == records->dimensions;
    if (is_cloud) {
      results_.table.levels = {not_known};
      results_.table.own = file_.numbers("intensity");
    } else {
      results_.table.levels = file_.numbers("intensity");
    }
    results_.table.cases = results_.table.records = 1;
    for (std::size_t i = 0; i < runs_.size(); ++i) {
      const std::size_t size = sizes_[i];
      if (!is_cloud && intensity->dimensions == std::vector<std::string>{runs_[i]}) {
        roles_[i] = Role::level;
      } else if (std::count(records->dimensions.begin(), records->dimensions.end(), runs_[i]) > 0) {
        roles_[i] = Role::record;
        results_.table.records *= size;
        // The record dimension that moves fastest is the last one.
        const bool polarity =
            file_.find(runs_[i]) != nullptr && file_.attribute(runs_[i], "parameter") == "excitation.polarity";
        results_.table.together = polarity ? size : 1;
        if (!polarity) name_records(i);
      } else {
        roles_[i] = Role::other;
        results_.table.cases *= size;
        results_.axes.push_back(axis(i));
      }
    }
    if (std::count(roles_.begin(), roles_.end(), Role::level) != (is_cloud ? 0 : 1)) {
      file_.fail("does not hold the results of bentur ida: its runs have no levels of intensity");
    }
    read_outcomes();
  }

  IdaResults take() { return std::move(results_); }

 private:
  enum class Role { level, record, other };

  [[nodiscard]] ResultAxis axis(std::size_t i) const {
    ResultAxis result{runs_[i], sizes_[i], {}};
    for (const StoredVariable& variable : file_.variables()) {
      if (variable.dimensions != std::vector<std::string>{runs_[i]} || variable.long_name == index_title) continue;
      ResultCoordinate coordinate{variable.name, variable.units, file_.attribute(variable.name, "parameter"), {}, {}};
      if (variable.text) {
        coordinate.texts = file_.texts(variable.name);
      } else {
        coordinate.numbers = file_.numbers(variable.name);
      }
      result.coordinates.push_back(std::move(coordinate));
    }
    return result;
  }

  /// Names of the records by one more dimension of them.
  void name_records(std::size_t i) {
    std::vector<std::string> names(sizes_[i]);
    for (const StoredVariable& variable : file_.variables()) {
      if (variable.dimensions != std::vector<std::string>{runs_[i]} || variable.long_name == index_title) continue;
      if (!variable.text || !names.front().empty()) continue;
      names = file_.texts(variable.name);
    }
    for (std::size_t n = 0; n < names.size(); ++n) {
      if (names[n].empty()) names[n] = fmt::format("{} {}", runs_[i], n + 1);
    }
    std::vector<std::string> all;
    for (const std::string& before : results_.records.empty() ? std::vector<std::string>{""} : results_.records) {
      for (const std::string& name : names) {
        all.push_back(before.empty() ? name : fmt::format("{}, {}", before, name));
      }
    }
    results_.records = std::move(all);
  }

  /// Variables with a value for each run at least.
  [[nodiscard]] std::vector<const StoredVariable*> quantities() const {
    std::vector<const StoredVariable*> result;
    for (const StoredVariable& variable : file_.variables()) {
      if (!variable.text && variable.dimensions.size() >= runs_.size() && variable.name != "scale_factor" &&
          variable.name != "record_intensity" && variable.name != "intensity" && variable.name != "status" &&
          std::equal(runs_.begin(), runs_.end(), variable.dimensions.begin())) {
        result.push_back(&variable);
      }
    }
    return result;
  }

  /// Those that the event is about.
  [[nodiscard]] std::vector<const StoredVariable*> event_variables() const {
    std::vector<const StoredVariable*> result;
    const std::string drift = "drift";
    std::vector<std::string> known;
    for (const StoredVariable* variable : quantities()) {
      const std::string base = without_number(variable->name);
      if (is_quantity(variable->name, event_.quantity)) result.push_back(variable);
      if (is_quantity(variable->name, drift)) known.insert(known.begin(), drift);
      // An impact that is not modelled is one: of how hard it is, or how many there are, nothing is known.
      const bool any_impact = event_.quantity == "impacts" && event_.holds(1) && !event_.holds(0);
      if (any_impact && variable->name == "unmodelled_contacts") result.push_back(variable);
      for (const std::string& name : {base, variable->name}) {
        if (std::find(known.begin(), known.end(), name) == known.end()) known.push_back(name);
      }
    }
    if (event_.quantity == drift) {
      const std::vector<std::string> without = buildings_without_drift(file_);
      if (!without.empty()) {
        file_.fail(fmt::format("has drifts of planes alone, and building {} has none: the event {} leaves it out",
                               in_quotes(without.front()), plane_drift));
      }
    }
    if (!result.empty()) return result;
    const std::string near = nearest(event_.quantity, known);
    std::string which = near.empty() ? "there are" : fmt::format("did you mean \"{}\"?", near);
    if (near.empty()) {
      std::set<std::string> names;
      for (const StoredVariable* variable : quantities()) names.insert(without_number(variable->name));
      for (const std::string& name : names) which += (name == *names.begin() ? " " : ", ") + name;
    }
    file_.fail(fmt::format("has no quantity {} for the event, {}", in_quotes(event_.quantity), which));
    return result;
  }

  void read_outcomes() {
    const std::vector<const StoredVariable*> variables = event_variables();
    results_.quantity_units = variables.front()->units;
    OutcomeTable& table = results_.table;
    table.outcomes.resize(table.cases * table.records * table.levels.size());
    table.demands.resize(table.outcomes.size(), not_known);
    table.collapsed.resize(table.outcomes.size(), 0);
    const bool exceeds =
        event_.comparison == EventRule::Comparison::more || event_.comparison == EventRule::Comparison::at_least;
    if (exceeds && event_.threshold > 0) table.threshold = event_.threshold;
    for (std::size_t i = 0; i < sizes_.front(); ++i) {
      const std::vector<double> ends = file_.numbers("status", i);
      std::vector<bool> events(ends.size(), false), gone(ends.size(), false);
      std::vector<double> demands(ends.size(), not_known);
      // What collapses or drifts that far, and what no longer can be computed, is beyond any threshold.
      if (file_.find("collapsed") != nullptr) {
        const std::vector<double> collapsed = file_.numbers("collapsed", i);
        for (std::size_t k = 0; k < collapsed.size(); ++k) events[k] = gone[k] = collapsed[k] > 0;
      }
      if (file_.find("open_needs") != nullptr) {
        const std::vector<double> open = file_.numbers("open_needs", i);
        for (std::size_t k = 0; k < open.size(); ++k) {
          if (ends[k] != 0) continue;
          const auto bits = static_cast<std::uint64_t>(open[k]);
          results_.open.add(bits);
          if (has(bits, OpenNeed::drift)) events[k] = gone[k] = true;
        }
      }
      results_.done += std::count(ends.begin(), ends.end(), 0.0);
      for (const StoredVariable* variable : variables) {
        const std::vector<double> values = file_.numbers(variable->name, i);
        const std::size_t each = values.size() / ends.size();
        const bool by_size = is_compared_by_size(file_, variable->name);
        for (std::size_t k = 0; k < values.size(); ++k) {
          const double value = by_size ? std::abs(values[k]) : values[k];
          if (event_.holds(value)) events[k / each] = true;
          double& demand = demands[k / each];
          if (!std::isnan(value)) demand = std::isnan(demand) ? value : std::max(demand, value);
        }
      }
      for (std::size_t k = 0; k < ends.size(); ++k) {
        constexpr double numbers_failed = 1, no_case = 2;
        const std::size_t at = place(i * ends.size() + k);
        table.demands[at] = demands[k];
        table.collapsed[at] = gone[k] || ends[k] == numbers_failed ? 1 : 0;
        const bool is_nowhere = table.is_cloud() && std::isnan(table.own[at % table.records]);
        table.outcomes[at] = ends[k] == no_case || is_nowhere         ? Outcome::failed
                             : events[k] || ends[k] == numbers_failed ? Outcome::event
                                                                      : Outcome::no_event;
      }
    }
  }

  /// Where in the table run number `run` belongs.
  [[nodiscard]] std::size_t place(std::size_t run) const {
    std::size_t c = 0, record = 0, level = 0, cases = 1, records = 1;
    for (std::size_t i = runs_.size(); i-- > 0;) {
      const std::size_t size = sizes_[i];
      const std::size_t at = run % size;
      run /= size;
      if (roles_[i] == Role::level) {
        level = at;
      } else if (roles_[i] == Role::record) {
        record += at * records;
        records *= size;
      } else {
        c += at * cases;
        cases *= size;
      }
    }
    return (c * results_.table.records + record) * results_.table.levels.size() + level;
  }

  const ResultSource& file_;
  const EventRule& event_;
  std::vector<std::string> runs_;  // dimensions
  std::vector<std::size_t> sizes_;
  std::vector<Role> roles_;
  IdaResults results_;
};

}  // namespace

bool is_compared_by_size(const ResultSource& file, const std::string& variable) {
  return file.attribute(variable, "compared_by") == "size";
}

IdaResults read_ida_results(const ResultSource& file, const EventRule& event) { return Reader(file, event).take(); }

}  // namespace bentur
