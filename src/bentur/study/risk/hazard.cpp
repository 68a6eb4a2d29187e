#include "bentur/study/risk/hazard.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <utility>

#include "bentur/core/number_text.h"
#include "bentur/core/text.h"
#include "bentur/core/units.h"
#include "bentur/io/input_file.h"
#include "bentur/io/records/file_unit.h"
#include "bentur/io/toml/toml_view.h"

namespace bentur {
namespace {

constexpr InputKind hazard_input{"hazard curve", std::uintmax_t{16} << 20};

/// Quotes around a cell are no part of it.
std::string_view stripped(std::string_view text) { return trimmed(text, " \t\r\""); }

/// Cells between commas or semicolons; without either between blanks.
std::vector<std::string_view> cells_of(std::string_view line) {
  const bool has_commas = line.find_first_of(",;") != std::string_view::npos;
  std::vector<std::string_view> cells;
  while (true) {
    const std::size_t end = line.find_first_of(has_commas ? ",;" : " \t");
    const std::string_view cell = stripped(line.substr(0, end));
    if (has_commas || !cell.empty()) cells.push_back(cell);
    if (end == std::string_view::npos) return cells;
    line.remove_prefix(end + 1);
  }
}

/// What stands behind `key=` in a comment of OpenQuake: investigation_time=50.0, imt='PGA'.
std::string_view comment_value(std::string_view comment, std::string_view key) {
  const std::size_t at = comment.find(key);
  if (at == std::string_view::npos) return {};
  std::string_view value = comment.substr(at + key.size());
  if (value.starts_with('\'')) {
    value.remove_prefix(1);
    return value.substr(0, value.find('\''));
  }
  return value.substr(0, value.find_first_of(",\" "));
}

/// What a heading says of its column: "Sa(0.5 s) [g]", "pga_gal".
struct HazardLabel {
  std::string measure;                              ///< as OpenQuake calls it; "SA" where no period is said
  std::optional<records::FileUnit> unit = {};       ///< of accelerations
  std::optional<std::string_view> other_unit = {};  ///< in brackets where the unit should stand, and none
};

bool is_letter(char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0; }

/// The words that a text begins with, in any case, between blanks or underlines as it likes. @return 0: it does not
std::size_t end_of_words(std::string_view text, std::string_view words) {
  std::size_t at = 0;
  for (const char c : words) {
    if (c == ' ') {
      while (at < text.size() && (text[at] == ' ' || text[at] == '_')) ++at;
    } else if (at >= text.size() || std::tolower(static_cast<unsigned char>(text[at++])) != c) {
      return 0;
    }
  }
  return at < text.size() && is_letter(text[at]) ? 0 : at;
}

/// The period of a spectral acceleration, "0.5", "(T = 0.5 s)", which `text` loses.
std::optional<double> take_period(std::string_view& text) {
  std::string_view rest = trimmed(text, " _");
  const bool is_bracketed = rest.starts_with('(');
  if (is_bracketed) rest = trimmed(rest.substr(1));
  if (const std::size_t sign = rest.find('='); sign != std::string_view::npos && end_of_words(rest, "t") > 0) {
    rest = trimmed(rest.substr(sign + 1));
  }
  const auto period = parse_number(rest.substr(0, rest.find_first_not_of("0123456789.")));
  if (!period) return std::nullopt;
  rest = trimmed(rest.substr(std::min(rest.find_first_not_of("0123456789."), rest.size())));
  for (const char* const second : {"s", "sec"}) {
    if (const std::size_t end = end_of_words(rest, second); end > 0) rest = trimmed(rest.substr(end));
  }
  if (is_bracketed && !rest.starts_with(')')) return std::nullopt;
  text = rest.substr(is_bracketed ? 1 : 0);
  return period;
}

/// Nothing where the text does not begin with a measure of ground motions.
std::optional<HazardLabel> label_of(std::string_view text) {
  static constexpr std::array<std::pair<std::string_view, std::string_view>, 11> measures = {
      {{"peak ground acceleration", "PGA"},
       {"pga", "PGA"},
       {"pgv", "PGV"},
       {"pgd", "PGD"},
       {"mmi", "MMI"},
       {"avgsa", "AvgSA"},
       {"spectral acceleration", "SA"},
       {"s a", "SA"},
       {"ps a", "SA"},
       {"p sa", "SA"},
       {"sae", "SA"}}};
  text = trimmed(text, " \t#\"");
  for (const auto& [words, measure] : measures) {
    const std::size_t end = end_of_words(text, words);
    if (end == 0) continue;
    text.remove_prefix(end);
    HazardLabel label{std::string(measure)};
    if (measure == "SA") {
      if (const auto period = take_period(text)) label.measure = fmt::format("SA({})", *period);
    }
    text = trimmed(text, " \t_");
    if (label.measure == "SA" && text.starts_with('(') && !records::file_unit(text.substr(1, text.find(')') - 1))) {
      text = trimmed(text.substr(std::min(text.find(')'), text.size() - 1) + 1));  // "(T1)"
    }
    if (text.empty()) return label;
    const bool is_bracketed = text.front() == '(' || text.front() == '[';
    std::string_view unit = text.substr(is_bracketed ? 1 : 0);
    unit = trimmed(unit.substr(0, unit.find_first_of(is_bracketed ? ")]" : " \t,;")));
    label.unit = records::file_unit(unit);
    if (is_bracketed && !label.unit) label.other_unit = unit;
    return label;
  }
  return std::nullopt;
}

class HazardReader {
 public:
  HazardReader(const std::string& name, const HazardOptions& options, Diagnostics& diagnostics)
      : name_(name), options_(options), diagnostics_(diagnostics) {}

  std::optional<HazardCurve> read(std::string_view text) {
    while (!text.empty() && good_) {
      const std::size_t end = text.find('\n');
      ++line_;
      take(text.substr(0, end));
      text = end == std::string_view::npos ? std::string_view{} : text.substr(end + 1);
    }
    if (good_ && is_openquake_) choose_site();
    if (!good_) return std::nullopt;
    if (curve_.unit.empty()) curve_.unit = is_openquake_ ? "g" : options_.unit;
    if (!options_.unit.empty() && options_.unit != curve_.unit) {
      fail(0, fmt::format("its intensities are in {}, not in {}", curve_.unit, options_.unit));
    }
    if (curve_.intensity.size() < 2) fail(0, "has no curve: two intensities or more, each with its frequency a year");
    return good_ ? std::optional(std::move(curve_)) : std::nullopt;
  }

 private:
  void fail(int line, const std::string& why) {
    if (good_) diagnostics_.error({name_, line, 0}, why);
    good_ = false;
  }

  void take(std::string_view line) {
    const std::string_view text = stripped(line);
    if (text.empty()) return;
    if (text.starts_with('#')) return take_comment(text);
    const std::vector<std::string_view> cells = cells_of(line);
    const bool is_heading = !parse_number(cells.front());
    if (is_heading && sites_.empty() && curve_.intensity.empty()) return take_heading(text, cells);
    if (is_openquake_) return take_site(cells);
    if (cells.size() != 2) {
      return fail(line_, fmt::format("has {}, must have 2: an intensity and the frequency a year that it is exceeded",
                                     counted(cells.size(), "number")));
    }
    std::vector<double> numbers;
    for (const std::string_view cell : cells) {
      const auto number = parse_number(cell);
      if (!number) return fail(line_, fmt::format("{} is no number", in_quotes(std::string(cell))));
      numbers.push_back(*number);
    }
    add(numbers[0], numbers[1]);
  }

  void take_comment(std::string_view text) {
    if (const std::string_view years = comment_value(text, "investigation_time="); !years.empty()) {
      const auto number = parse_number(years);
      if (!number || !(*number > 0)) return fail(line_, "investigation_time must be > 0");
      years_ = *number;
    }
    if (const std::string_view measure = comment_value(text, "imt="); !measure.empty()) {
      curve_.measure = measure;
    } else if (const auto label = label_of(text)) {
      take_label(*label);
    }
  }

  void take_label(const HazardLabel& label) {
    const bool is_more = label.measure.starts_with(curve_.measure);  // a period, too
    if (!is_more && !curve_.measure.starts_with(label.measure)) {
      return fail(line_, fmt::format("is of {}, but said before to be of {}", label.measure, curve_.measure));
    }
    if (is_more) curve_.measure = label.measure;
    if (label.other_unit) {
      return fail(line_, fmt::format("{} is no unit of accelerations that is known; one of {}",
                                     in_quotes(std::string(*label.other_unit)), fmt::join(acceleration_units(), ", ")));
    }
    if (!label.unit) return;
    curve_.unit = label.unit->unit;
    factor_ = label.unit->factor;
  }

  void take_heading(std::string_view line, const std::vector<std::string_view>& cells) {
    if (const auto label = label_of(line)) {
      take_label(*label);
    } else if (cells.size() == 2 && label_of(cells[1])) {
      return fail(line_, fmt::format("{} must be the first column", in_quotes(std::string(cells[1]))));
    }
    for (const std::string_view cell : cells) {
      const bool is_poe = cell.starts_with("poe-");
      poe_columns_.push_back(is_poe ? parse_number(cell.substr(4)) : std::nullopt);
      if (is_poe && !poe_columns_.back()) fail(line_, fmt::format("{} has no intensity", in_quotes(std::string(cell))));
      is_openquake_ = is_openquake_ || is_poe;
      const std::size_t open = cell.find_last_of("([");
      const bool is_closed = cell.ends_with(')') || cell.ends_with(']');
      if (open == std::string_view::npos || !is_closed || !curve_.measure.empty()) continue;
      if (const auto unit = records::file_unit(cell.substr(open + 1, cell.size() - open - 2))) {
        curve_.unit = unit->unit;
        factor_ = unit->factor;
      }
    }
    if (is_openquake_ && years_ == 0) fail(line_, "does not say investigation_time, as OpenQuake does in its comment");
  }

  void take_site(const std::vector<std::string_view>& cells) {
    if (cells.size() != poe_columns_.size()) {
      return fail(line_, fmt::format("has {}, its heading {}", counted(cells.size(), "column"), poe_columns_.size()));
    }
    sites_.push_back({line_, {}});
    for (std::size_t i = 0; i < cells.size(); ++i) {
      if (!poe_columns_[i]) continue;
      const auto poe = parse_number(cells[i]);
      if (!poe || !(*poe >= 0 && *poe <= 1)) {
        return fail(line_, fmt::format("{} is no probability", in_quotes(std::string(cells[i]))));
      }
      sites_.back().poes.push_back(*poe);
    }
  }

  void choose_site() {
    if (sites_.empty()) return fail(0, "has no site");
    if (!options_.site && sites_.size() > 1) {
      return fail(0, fmt::format("has {} sites: choose one, from 1 to {}", sites_.size(), sites_.size()));
    }
    const long site = options_.site.value_or(1);
    if (site < 1 || site > std::ssize(sites_)) return fail(0, fmt::format("has no site {}", site));
    const Site& chosen = sites_[static_cast<std::size_t>(site - 1)];
    line_ = chosen.line;
    std::size_t i = 0;
    for (const std::optional<double>& intensity : poe_columns_) {
      if (!intensity) continue;
      const double poe = chosen.poes[i++];
      if (poe < 1) add(*intensity, -std::log1p(-poe) / years_);  // of P = 1 no frequency is known
    }
  }

  void add(double intensity, double rate) {
    const double x = intensity * factor_;
    if (!(x > 0)) return fail(line_, fmt::format("intensity = {}, must be > 0", intensity));
    if (!(rate >= 0)) return fail(line_, fmt::format("frequency = {}, must be >= 0", rate));
    if (rate == 0) {  // beyond what the hazard has; what follows can be nothing else
      ended_ = true;
      return;
    }
    if (ended_) return fail(line_, "the frequency of a larger intensity must not be larger");
    if (!curve_.intensity.empty()) {
      if (!(x > curve_.intensity.back())) return fail(line_, "intensities must ascend");
      if (rate > curve_.rate.back()) return fail(line_, "the frequency of a larger intensity must not be larger");
    }
    curve_.intensity.push_back(x);
    curve_.rate.push_back(rate);
  }

  struct Site {
    int line = 0;
    std::vector<double> poes;
  };

  const std::string& name_;
  const HazardOptions& options_;
  Diagnostics& diagnostics_;
  HazardCurve curve_;
  bool good_ = true, is_openquake_ = false, ended_ = false;
  int line_ = 0;
  double years_ = 0, factor_ = 1;                   // factor: what brings intensities to the unit of the curve
  std::vector<std::optional<double>> poe_columns_;  // of each column its intensity, where it has probabilities
  std::vector<Site> sites_;
};

}  // namespace

double HazardCurve::slope(std::size_t segment) const {
  return std::log(rate[segment] / rate[segment + 1]) / std::log(intensity[segment + 1] / intensity[segment]);
}

std::size_t HazardCurve::segment_of(double x) const {
  const auto after = std::upper_bound(intensity.begin(), intensity.end(), x);
  const auto index = static_cast<std::size_t>(std::max<std::ptrdiff_t>(after - intensity.begin(), 1));
  return std::min(index - 1, segments() - 1);
}

double HazardCurve::rate_at(double x) const {
  const std::size_t i = segment_of(x);
  return rate[i] * std::exp(-slope(i) * std::log(x / intensity[i]));
}

std::optional<HazardCurve> hazard_of(std::string_view text, const std::string& name, const HazardOptions& options,
                                     Diagnostics& diagnostics) {
  return HazardReader(name, options, diagnostics).read(text);
}

std::optional<HazardCurve> read_hazard(const std::filesystem::path& file, const HazardOptions& options,
                                       Diagnostics& diagnostics) {
  const auto text = read_input(file, hazard_input, diagnostics);
  return text ? hazard_of(*text, file.string(), options, diagnostics) : std::nullopt;
}

}  // namespace bentur
