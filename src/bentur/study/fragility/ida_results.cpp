#include "bentur/study/fragility/ida_results.h"

#include <system_error>

#include "bentur/core/number_text.h"
#include "bentur/core/text.h"

namespace bentur {

std::optional<double> number_after(const std::string& text, const std::string& word) {
  const std::size_t at = text.find(word);
  if (at == std::string::npos) return std::nullopt;
  double number = 0;
  const char* const end = text.data() + text.size();
  const auto read = from_chars(text.data() + at + word.size(), end, number);
  return read.ec == std::errc() ? std::optional(number) : std::nullopt;
}

bool EventRule::holds(double value) const {
  switch (comparison) {
    case Comparison::more:
      return value > threshold;
    case Comparison::at_least:
      return value >= threshold;
    case Comparison::less:
      return value < threshold;
    case Comparison::at_most:
      return value <= threshold;
  }
  return false;
}

std::optional<EventRule> parse_event(const std::string& text, std::string& error) {
  const std::size_t sign = text.find_first_of("<>");
  EventRule rule;
  error = "must be a quantity, one of > >= < <=, and a number, as in \"peak_force > 20\"";
  if (sign == std::string::npos) return std::nullopt;
  const bool equal = sign + 1 < text.size() && text[sign + 1] == '=';
  rule.quantity = trimmed(text.substr(0, sign));
  const auto threshold = parse_number(trimmed(text.substr(sign + (equal ? 2 : 1))));
  if (rule.quantity.empty() || !threshold) return std::nullopt;
  rule.threshold = *threshold;
  rule.comparison = text[sign] == '>' ? (equal ? EventRule::Comparison::at_least : EventRule::Comparison::more)
                                      : (equal ? EventRule::Comparison::at_most : EventRule::Comparison::less);
  error.clear();
  return rule;
}

bool ResultCoordinate::is_gap_width() const {
  return !numbers.empty() && parameter.starts_with("gap[") && parameter.find("].width") != std::string::npos;
}

std::optional<double> IdaResults::period() const { return number_after(intensity, "period "); }

std::vector<std::size_t> IdaResults::places(std::size_t c) const {
  std::vector<std::size_t> result(axes.size());
  for (std::size_t i = axes.size(); i-- > 0; c /= axes[i].size) result[i] = c % axes[i].size;
  return result;
}

}  // namespace bentur
