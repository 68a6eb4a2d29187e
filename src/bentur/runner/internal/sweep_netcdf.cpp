#include "bentur/runner/internal/sweep_netcdf.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <map>
#include <string_view>
#include <utility>
#include <vector>

#include "bentur/files/netcdf.h"
#include "bentur/model/story/remarks.h"
#include "bentur/study/study_variables.h"

namespace bentur {
namespace {

constexpr std::size_t block_bytes = 4U << 20;  // of rows held at a time
constexpr std::size_t message_chunk = 1024;    // runs; a part of the file without messages takes no room

/// Consecutive runs that are one block of the dimensions.
struct RunBlock {
  std::size_t first = 0, runs = 0;
  NetcdfBlock places;
};

class SweepFile {
 public:
  SweepFile(const std::filesystem::path& file, const StudyRuns& runs, const std::string& version)
      : file_(file.string()), runs_(runs), study_(study_file(runs, version)) {}

  SweepTotals write(const Journal& journal);

 private:
  void define();
  void write_messages(const std::map<std::size_t, std::string>& failures) const;
  [[nodiscard]] std::vector<std::size_t> place_of(std::size_t run) const;
  [[nodiscard]] RunBlock block_at(std::size_t first) const;

  /// A variable that is written some runs at a time.
  struct Growing {
    NetcdfWriter::Variable stored;
    const StudyVariable* told;
  };
  NetcdfWriter file_;
  const StudyRuns& runs_;
  const StudyFile study_;
  std::vector<std::size_t> sizes_;  // of the dimensions of the runs
  std::vector<Growing> growing_;
  NetcdfWriter::Variable message_{};
};

void SweepFile::define() {
  for (const ResultAttribute& attribute : study_.attributes) file_.attribute(attribute);
  for (const ResultDimension& dimension : study_.runs) sizes_.push_back(dimension.size);
  for (const StudyVariable& variable : study_.variables) {
    const NetcdfWriter::Variable stored = file_.add(variable);
    if (variable.name == message_variable) {
      message_ = stored;
    } else if (variable.of_runs) {
      growing_.push_back({stored, &variable});
    }
  }
  std::vector<std::size_t> chunks = sizes_;
  std::size_t left = message_chunk;
  for (std::size_t i = chunks.size(); i-- > 0;) {
    chunks[i] = std::clamp<std::size_t>(chunks[i], 1, std::max<std::size_t>(1, left));
    left /= chunks[i];
  }
  file_.chunk(message_, chunks);
}

/// A run's place along each dimension.
std::vector<std::size_t> SweepFile::place_of(std::size_t run) const {
  std::vector<std::size_t> place(sizes_.size());
  for (std::size_t i = sizes_.size(); i-- > 0; run /= sizes_[i]) place[i] = run % sizes_[i];
  return place;
}

/// The largest block from run `first` on that fits: whole in the last dimensions, single in the first ones.
RunBlock SweepFile::block_at(std::size_t first) const {
  const std::size_t row = row_size(runs_.quantities()) * sizeof(double);
  const std::size_t most = std::max<std::size_t>(1, block_bytes / row);
  RunBlock block{first, 1, {place_of(first), std::vector<std::size_t>(sizes_.size(), 1)}};
  auto& [start, count] = block.places;
  for (std::size_t i = sizes_.size(); i-- > 0;) {
    count[i] = std::min(sizes_[i] - start[i], std::max<std::size_t>(1, most / block.runs));
    block.runs *= count[i];
    if (count[i] < sizes_[i]) break;
  }
  return block;
}

/// All or none: a variable of texts with pieces that were never written cannot be read as a whole.
void SweepFile::write_messages(const std::map<std::size_t, std::string>& failures) const {
  for (std::size_t first = 0; !failures.empty() && first < runs_.design().runs();) {
    const RunBlock block = block_at(first);
    std::vector<std::string> messages(block.runs);
    for (auto one = failures.lower_bound(first); one != failures.end() && one->first < first + block.runs; ++one) {
      messages[one->first - first] = one->second;
    }
    file_.put(message_, messages, block.places);
    first += block.runs;
  }
}

SweepTotals SweepFile::write(const Journal& journal) {
  define();
  SweepTotals totals;
  const auto named = [&](std::string_view name) {
    return std::find_if(runs_.quantities().begin(), runs_.quantities().end(),
                        [&](const RowPart& quantity) { return quantity.name == name; });
  };
  const auto impacts = named("impacts"), unmodelled = named("unmodelled_contacts");
  const auto remarked = named("remarks"), doubted = named("doubts"), about = named("remark_kinds"),
             open = named("open_needs");
  std::map<std::size_t, std::string> failures;
  for (std::size_t first = 0; first < runs_.design().runs();) {
    const RunBlock block = block_at(first);
    first += block.runs;
    const std::vector<RunResult> results = journal.read(block.first, block.runs);
    for (const RunResult& result : results) {
      if (result.status == RunStatus::done) {
        for (Eigen::Index k = 0; k < impacts->count; ++k) totals.impacts += result.values[impacts->first + k];
        bool some = false;
        for (Eigen::Index k = 0; k < unmodelled->count; ++k) some = some || result.values[unmodelled->first + k] > 0;
        totals.unmodelled += some ? 1 : 0;
        totals.remarked += result.values[remarked->first] > 0 ? 1 : 0;
        totals.doubted += result.values[doubted->first] > 0 ? 1 : 0;
        totals.open.add(static_cast<std::uint64_t>(result.values[open->first]));
        const auto bits = static_cast<std::uint64_t>(result.values[about->first]);
        for (std::size_t k = 0; k < remark_keys().size(); ++k) {
          if ((bits >> k & 1U) != 0) ++totals.remarks[std::string(remark_keys()[k])];
        }
        continue;
      }
      if (totals.failed++ == 0) totals.first_failure = fmt::format("run {}: {}", result.run, result.message);
      failures.emplace(result.run, result.message);
    }
    for (const auto& [stored, told] : growing_) {
      NetcdfBlock places = block.places;
      for (std::size_t i = sizes_.size(); i < told->dimensions.size(); ++i) {
        places.start.push_back(0);
        places.count.push_back(told->dimensions[i].size);
      }
      file_.put(stored, told->of_runs(results), places);
    }
  }
  write_messages(failures);
  file_.finish();
  return totals;
}

}  // namespace

SweepTotals write_sweep_netcdf(const std::filesystem::path& file, const StudyRuns& runs, const Journal& journal,
                               const std::string& version) {
  return SweepFile(file, runs, version).write(journal);
}

}  // namespace bentur
