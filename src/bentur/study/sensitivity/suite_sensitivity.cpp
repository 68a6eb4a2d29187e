#include "bentur/study/sensitivity/internal/suite_sensitivity.h"

#include <algorithm>
#include <filesystem>
#include <utility>

#include "bentur/core/not_known.h"
#include "bentur/model/suite/suite.h"
#include "bentur/study/design/study.h"

namespace bentur {
namespace {

using Eigen::Index;

const ParameterPath scale_of_record = {"excitation", "scale"};
const ParameterPath scale_along_y = {"excitation", "y", "scale"};  // of pairs

bool is_scale(const std::string& path) {
  return path == path_text(scale_of_record) || path == path_text(scale_along_y);
}

/// A number's place in what was found of a record; nothing where it is not there.
std::optional<Index> place_of(const Sensitivity& found, const CaseNumber& number) {
  const auto at = std::find_if(found.numbers.begin(), found.numbers.end(), [&](const CaseNumber& one) {
    return one.path == number.path && (is_scale(number.path) || one.value == number.value);
  });
  return at == found.numbers.end() ? std::nullopt : std::optional(at - found.numbers.begin());
}

/// Why a number has no derivative under all records.
std::string why_left_out(const std::vector<Sensitivity>& all, const std::string& path) {
  for (const Sensitivity& one : all) {
    for (const auto& [left_out, why] : one.left_out) {
      if (left_out == path) return why;
    }
  }
  return "is not the same under every record";
}

/// Takes the numbers that all records have. The scale of each becomes that of all together, 1.
void join_numbers(std::vector<Sensitivity>& all) {
  std::vector<CaseNumber> kept;
  std::vector<std::string> gone;
  for (const CaseNumber& number : all.front().numbers) {
    const bool everywhere =
        std::all_of(all.begin(), all.end(), [&](const Sensitivity& one) { return place_of(one, number).has_value(); });
    if (everywhere) {
      kept.push_back(number);
    } else {
      gone.push_back(number.path);
    }
  }
  auto left_out = all.front().left_out;
  for (const std::string& path : gone) left_out.emplace_back(path, why_left_out(all, path));
  for (Sensitivity& one : all) {
    std::vector<Index> places;
    for (const CaseNumber& number : kept) places.push_back(*place_of(one, number));
    for (SensitivePeak& peak : one.peaks) {
      if (peak.derivative.by.size() == 0) continue;
      Eigen::VectorXd by(std::ssize(kept));
      for (Index i = 0; i < by.size(); ++i) {
        const CaseNumber& own = one.numbers[places[i]];
        by(i) = peak.derivative.by(places[i]) * (is_scale(own.path) ? own.value : 1.0);
      }
      peak.derivative.by = std::move(by);
    }
    one.left_out = left_out;
  }
  for (CaseNumber& number : kept) {
    if (is_scale(number.path)) number.value = 1;
  }
  for (Sensitivity& one : all) one.numbers = kept;
}

/// A peak that is 0 under a record, such as the force of a gap that stays open there, stays 0.
bool is_known(const Derivative& of) { return of.by.size() > 0 || of.value == 0; }

Derivative mean_of(const std::vector<Sensitivity>& all, std::size_t peak) {
  Derivative mean;
  mean.time = not_known;
  const auto count = static_cast<double>(all.size());
  const auto numbers = std::ssize(all.front().numbers);
  mean.by = Eigen::VectorXd::Zero(numbers);
  bool known = true, any = false;
  for (const Sensitivity& one : all) {
    const Derivative& of = one.peaks[peak].derivative;
    mean.value += of.value / count;
    known = known && is_known(of);
    any = any || of.by.size() > 0;
    if (of.by.size() > 0) mean.by += of.by / count;
    mean.grazing = std::min(mean.grazing, of.grazing);
    mean.is_equalled = mean.is_equalled || of.is_equalled;
    mean.is_simultaneous = mean.is_simultaneous || of.is_simultaneous;
  }
  if (!known || !any) mean.by.resize(0);
  return mean;
}

}  // namespace

std::optional<Sensitivity> sensitivity_of_suite(const TomlValue& root, const std::filesystem::path& file,
                                                std::shared_ptr<const SuiteSpec> suite,
                                                const SensitivityOptions& options, Diagnostics& diagnostics) {
  Study plain;
  plain.file = plain.case_file = file;
  plain.case_root = root;
  plain.suite = std::move(suite);
  const auto study = read_study(TomlValue(), std::move(plain), diagnostics);
  if (!study) return std::nullopt;
  const Vary& records = study->varies.front();
  const std::size_t count = records.values.size();
  std::vector<ParameterPath> scales = {scale_of_record};
  if (study->suite->is_of_pairs()) scales.push_back(scale_along_y);
  std::vector<std::string> of_suite;  // numbers that choose and scale the records
  for (const ParameterPath& path : numbers_in(root)) {
    const bool is_there = find_value(study->case_root, path) != nullptr;
    if (path.front() == PathStep(std::string("excitation")) && !is_there) of_suite.push_back(path_text(path));
  }
  std::vector<Sensitivity> all;
  for (std::size_t record = 0; record < count; ++record) {
    const std::vector<Choice> choices = {{.level = record}};
    TomlValue of_record = chosen_case(*study, choices);
    for (const ParameterPath& scale : scales) {
      put_value(of_record, scale, toml_number(normalisation_of(*study, choices)));
    }
    SensitivityOptions each{.numbers = options.numbers};
    if (options.progress) {
      each.progress = [&](double fraction) {
        return options.progress((static_cast<double>(record) + fraction) / static_cast<double>(count));
      };
    }
    Diagnostics found;
    auto one = sensitivity_of(of_record, file, each, found);
    for (Diagnostic error : found.errors()) {
      error.rule = "under " + records.labels[record] + ": " + error.rule;
      diagnostics.add(std::move(error));
    }
    if (!one) return std::nullopt;
    all.push_back(*std::move(one));
  }
  join_numbers(all);
  for (const std::string& path : of_suite) {
    all.front().left_out.emplace_back(
        path, "is of how the suite is chosen and scaled: excitation.scale is a factor of all records");
  }
  Sensitivity result = all.front();
  for (const ParameterPath& scale : scales) result.scales.push_back(path_text(scale));
  result.takes_mean = suite_measure(*study->suite).kind == SuiteMeasure::Kind::mean;
  for (std::size_t i = 0; i < result.peaks.size(); ++i) {
    SensitivePeak& peak = result.peaks[i];
    if (result.takes_mean) {
      peak.derivative = mean_of(all, i);
      continue;
    }
    const auto governs = std::max_element(all.begin(), all.end(), [&](const Sensitivity& a, const Sensitivity& b) {
      return a.peaks[i].derivative.value < b.peaks[i].derivative.value;
    });
    peak.derivative = governs->peaks[i].derivative;
    peak.record = records.labels[static_cast<std::size_t>(governs - all.begin())];
  }
  mark_largest(result.peaks);
  for (std::size_t record = 0; record < count; ++record) {
    result.records.push_back({records.labels[record], std::move(all[record].peaks)});
  }
  return result;
}

}  // namespace bentur
