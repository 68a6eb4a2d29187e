#include "bentur/io/schema/parameter_units.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "bentur/core/number_text.h"
#include "bentur/io/schema/case_keys.h"
#include "bentur/io/schema/table_view.h"
#include "bentur/model/quantities.h"

namespace bentur {
namespace {

/// A number of at most 13 digits; of 10 where these say as much.
std::string digits_of(double value, bool is_real) {
  double few = 0;
  std::string text = fmt::format("{:.10g}", value);
  from_chars(text.data(), text.data() + text.size(), few);
  if (!(std::abs(few - value) <= 2e-12 * std::abs(value))) text = fmt::format("{:.13g}", value);
  if (is_real && text.find_first_of(".en") == std::string::npos) text += ".0";
  return text;
}

/// What the number at a path is: of a floor in plan the third one is a rotation, where the others are lengths.
PhysicalDimension dimension_at(const Key& key, const ParameterPath& path) {
  const auto place = [&](std::size_t from_end) { return std::get_if<std::size_t>(&path[path.size() - from_end]); };
  const bool of_a_floor =
      key.kind == Key::Kind::by_building && path.size() > 2 && place(1) != nullptr && place(2) != nullptr;
  if (!of_a_floor || *place(1) != 2) return key.dimension;
  return {0, key.dimension.force, key.dimension.time};
}

/// A piece of a text and what comes in its place.
struct Change {
  std::size_t from, to;
  std::string with;
};

class TextInUnits {
 public:
  TextInUnits(const std::string& text, const TomlValue& root, double length, double force)
      : text_(text), root_(root), length_(length), force_(force) {
    lines_.push_back(text.starts_with("\xEF\xBB\xBF") ? 3 : 0);
    for (std::size_t at = 0; (at = text.find('\n', at)) != std::string::npos;) lines_.push_back(++at);
  }

  void convert(const TomlValue& value, ParameterPath& path) {
    for (const TomlMember& member : value.members) {
      path.emplace_back(member.key);
      convert(member.value, path);
      path.pop_back();
    }
    for (std::size_t i = 0; i < value.items.size(); ++i) {
      path.emplace_back(i);
      convert(value.items[i], path);
      path.pop_back();
    }
    if (!value.is_number() || !std::isfinite(value.real)) return;
    const Key* const key = key_at(case_keys(), path, root_);
    const double factor = key == nullptr ? 1 : dimension_at(*key, path).factor(length_, force_);
    if (factor == 1) return;
    const std::size_t from = place(value);
    const std::size_t to = std::min(text_.find_first_of(" \t\r\n,]}#", from), text_.size());
    changes_.push_back({from, to, digits_of(factor * value.real, value.kind == TomlValue::Kind::real)});
  }

  /// A word of [units]; where it is not there yet it comes before the first key there, or in a table of its own.
  void put_unit(const std::string& key, const std::string& word) {
    const TomlValue* units = root_.find("units");
    const TomlValue* old = units == nullptr ? nullptr : units->find(key);
    if (old != nullptr) {
      const std::size_t from = place(*old);
      changes_.push_back({from, text_.find(text_[from], from + 1) + 1, fmt::format("\"{}\"", word)});
    } else if (units == nullptr) {
      missing_ += fmt::format("{} = \"{}\"\n", key, word);
    } else if (units->members.empty()) {
      const std::size_t end = std::min(text_.find('\n', place(*units)), text_.size() - 1) + 1;
      changes_.push_back({end, end, fmt::format("{} = \"{}\"\n", key, word)});
    } else {
      // Before the first key that there is: on a line of its own, dotted as that one is, or in braces.
      const std::size_t from = place(units->members.front());
      const std::size_t line = lines_[static_cast<std::size_t>(units->members.front().line - 1)];
      const std::size_t before = text_.find_last_not_of(" \t", from - 1);
      const std::string made = fmt::format("{} = \"{}\"", key, word);
      if (from > line && before >= line && text_[before] == '.') {
        changes_.push_back({line, line, "units." + made + "\n"});
      } else {
        changes_.push_back({from, from, made + (from == line || before < line ? "\n" : ", ")});
      }
    }
  }

  std::string text() {
    if (!missing_.empty()) {  // before the first table that has a line of its own: keys before it belong to none
      std::size_t at = text_.size();
      for (const TomlMember& member : root_.members) {
        const std::size_t line = lines_[static_cast<std::size_t>(std::max(member.line, 1) - 1)];
        if (text_.find_first_not_of(" \t", line) == text_.find('[', line)) at = std::min(at, line);
      }
      changes_.push_back({at, at, fmt::format("{}[units]\n{}\n", at == text_.size() ? "\n" : "", missing_)});
    }
    std::stable_sort(changes_.begin(), changes_.end(),
                     [](const Change& a, const Change& b) { return a.from > b.from; });
    std::string made = text_;
    for (const Change& change : changes_) made.replace(change.from, change.to - change.from, change.with);
    return made;
  }

 private:
  /// Columns count characters; a byte that goes on with one has the bits 10.
  [[nodiscard]] std::size_t place(int line, int column) const {
    std::size_t at = lines_[static_cast<std::size_t>(line - 1)];
    for (int k = 1; k < column; ++k) {
      do {
        ++at;
      } while (at < text_.size() && (static_cast<unsigned char>(text_[at]) & 0xC0U) == 0x80U);
    }
    return at;
  }
  template <typename Value>
  [[nodiscard]] std::size_t place(const Value& value) const {
    return place(value.line, value.column);
  }

  const std::string& text_;
  const TomlValue& root_;
  const double length_, force_;
  std::vector<std::size_t> lines_;
  std::vector<Change> changes_;
  std::string missing_;
};

/// The unit that a case states, or the default; nothing where it is none.
std::optional<std::string> stated_unit(const TomlValue& root, const std::string& key, const std::string& otherwise,
                                       const std::vector<std::string>& known, const std::string& file,
                                       Diagnostics& diagnostics) {
  const TomlValue* units = root.find("units");
  const TomlValue* value = units == nullptr ? nullptr : units->find(key);
  if (value == nullptr) return otherwise;
  if (std::find(known.begin(), known.end(), value->text) != known.end()) return value->text;
  return TomlView(*value, key_path("units", key), file, diagnostics).as_word(known);
}

}  // namespace

std::optional<std::string> text_in_units(const std::string& text, const std::string& file, const std::string& length,
                                         const std::string& force, Diagnostics& diagnostics) {
  const double metre = metres(length), newton = newtons(force);
  const std::optional<TomlValue> root = parse_toml(text, file, diagnostics);
  if (!root) return std::nullopt;
  const auto old_length = stated_unit(*root, "length", "m", length_units(), file, diagnostics);
  const auto old_force = stated_unit(*root, "force", "N", force_units(), file, diagnostics);
  if (!old_length || !old_force) return std::nullopt;
  TextInUnits made(text, *root, metres(*old_length) / metre, newtons(*old_force) / newton);
  ParameterPath path;
  made.convert(*root, path);
  if (*old_length != length) made.put_unit("length", length);
  if (*old_force != force) made.put_unit("force", force);
  return made.text();
}

std::string parameter_units(const ParameterPath& path, const TomlValue& root, const Units& units) {
  const Key* const key = key_at(case_keys(), path, root);
  const bool is_number = key != nullptr && key->own_unit.empty() &&
                         (key->kind == Key::Kind::number || key->kind == Key::Kind::quantity ||
                          key->kind == Key::Kind::whole || key->kind == Key::Kind::by_building);
  return is_number ? udunits(dimension_at(*key, path).form(), units) : "";
}

}  // namespace bentur
