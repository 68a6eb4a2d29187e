#include "bentur/core/diagnostics.h"

#include <fmt/format.h>

#include <algorithm>
#include <tuple>
#include <utility>

namespace bentur {
namespace {

// Edit distance: insertion, deletion, replacement and the swap of two neighbouring letters count one each
// (optimal string alignment). Three rows of the usual table are enough.
std::size_t edit_distance(const std::string& a, const std::string& b) {
  std::vector<std::size_t> before_last(b.size() + 1), last(b.size() + 1), row(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) last[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      row[j] = std::min({last[j] + 1, row[j - 1] + 1, last[j - 1] + (a[i - 1] == b[j - 1] ? 0U : 1U)});
      const bool swapped = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
      if (swapped) row[j] = std::min(row[j], before_last[j - 2] + 1);
    }
    std::swap(before_last, last);
    std::swap(last, row);
  }
  return last[b.size()];
}

}  // namespace

std::string Diagnostic::message(const Wording& say) const {
  std::string text = key;
  if (!value.empty()) {
    const bool is_kind = value.starts_with("a ");
    text += " " + (is_kind ? say(fmt::format("is {},", value)) : fmt::format("= {},", value));
  }
  if (value.empty() || suggestion.empty()) text += (text.empty() ? "" : " ") + say(rule);
  if (suggestion.empty()) return text;
  return text + (value.empty() ? ", " : " ") + say(fmt::format("did you mean \"{}\"?", suggestion));
}

std::string Diagnostic::text(const Wording& say) const {
  std::string place = position.file;
  if (position.line > 0) {
    place += fmt::format(":{}", position.line);
    if (position.column > 0) place += fmt::format(":{}", position.column);
  }
  return fmt::format("{}{}{}: {}", place, place.empty() ? "" : ": ", say("error"), message(say));
}

Diagnostic& Diagnostics::error(SourcePosition position, std::string message) {
  return errors_.emplace_back(Diagnostic{.position = std::move(position), .rule = std::move(message)});
}

void Diagnostics::add(const Diagnostics& other) {
  errors_.insert(errors_.end(), other.errors_.begin(), other.errors_.end());
}

std::vector<Diagnostic> Diagnostics::errors() const {
  std::vector<Diagnostic> sorted = errors_;
  // What was put in has no line and comes before what the file itself has wrong, the last one first.
  std::stable_sort(sorted.begin(), sorted.end(), [](const Diagnostic& one, const Diagnostic& other) {
    const SourcePosition &a = one.position, &b = other.position;
    return std::tie(a.file, a.line, b.origin, a.column) < std::tie(b.file, b.line, a.origin, b.column);
  });
  return sorted;
}

std::string nearest(const std::string& word, const std::vector<std::string>& known) {
  std::string best;
  std::size_t allowed = word.size() / 3;
  for (const std::string& candidate : known) {
    const std::size_t distance = edit_distance(word, candidate);
    if (distance < allowed || (distance == allowed && best.empty())) {
      best = candidate;
      allowed = distance;
    }
  }
  return best;
}

}  // namespace bentur
