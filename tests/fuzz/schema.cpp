// Cases made from the schema: bytes choose which keys are there, of those that may be, and which of the values that
// they may have. What is read is run for two seconds.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "bentur/io/case/case_toml.h"
#include "bentur/io/schema/case_keys.h"
#include "tests/fuzz/support.h"

namespace bentur::fuzz {
namespace {

class CaseMaker {
 public:
  explicit CaseMaker(const std::string& bytes) : bytes_(bytes) {}

  std::string make() {
    floors_ = 1 + below(4);
    buildings_ = 2 + below(2);
    std::string text;
    for (const auto& [name, value] : entries(case_keys())) text += name + " = " + value + "\n";
    return text;
  }

 private:
  using Entries = std::vector<std::pair<std::string, std::string>>;

  /// 0 once all are used up.
  std::size_t below(std::size_t n) {
    return next_ < bytes_.size() ? static_cast<std::uint8_t>(bytes_[next_++]) % n : 0;
  }
  bool seldom() { return below(12) == 11; }

  /// Whether this key may stand beside what there is already.
  static bool may_be(const Key& key, const std::map<std::string_view, std::string>& words) {
    return std::all_of(key.conditions.begin(), key.conditions.end(), [&](const Condition& one) {
      const auto said = words.find(one.key);
      return said != words.end() && std::any_of(one.words.begin(), one.words.end(),
                                                [&](std::string_view word) { return word == said->second; });
    });
  }

  /// Of the keys of a group which one is there; empty for none.
  std::string_view chosen_of(const KeyTable& keys, std::string_view group,
                             const std::map<std::string_view, std::string>& words) {
    std::vector<std::string_view> names;
    bool needed = false;
    for (const Key& key : keys.keys) {
      if (key.group != group || !may_be(key, words) || is_left_out(key)) continue;
      names.push_back(key.name);
      needed = needed || key.need == Need::one_of;
    }
    if (names.empty() || (!needed && !seldom())) return {};
    return names[below(names.size())];
  }

  /// The keys of a table that are there with their values, in the schema's order.
  Entries entries(const KeyTable& keys) {
    std::map<std::string_view, std::string> words;  // of choices and flags, said or by default
    std::map<std::string_view, std::string_view> groups;
    Entries made;
    const auto is_there = [&](std::string_view name) {
      return std::any_of(made.begin(), made.end(), [&](const auto& entry) { return entry.first == name; });
    };
    for (const Key& key : keys.keys) {
      if (key.kind == Key::Kind::choice) words.emplace(key.name, key.words.front());
      if (key.kind == Key::Kind::flag) words.emplace(key.name, key.default_value == 1 ? "true" : "false");
    }
    for (const Key& key : keys.keys) {
      const bool by_word = key.kind == Key::Kind::choice || key.kind == Key::Kind::flag;
      if (is_there(key.name) || !may_be(key, words) || is_left_out(key)) continue;
      if (!key.group.empty()) {
        if (groups.count(key.group) == 0) groups[key.group] = chosen_of(keys, key.group, words);
        if (groups[key.group] != key.name) continue;
      } else if (key.need == Need::optional && !(wanted(key, keys) && (key.with.empty() || is_there(key.with)))) {
        continue;
      }
      std::string value = value_of(key, keys);
      if (by_word) words[key.name] = value.substr(value[0] == '"' ? 1 : 0, value.size() - (value[0] == '"' ? 2 : 0));
      made.emplace_back(key.name, std::move(value));
    }
    return made;
  }

  /// What a row of buildings cannot have, or needs a file of its own for.
  bool is_left_out(const Key& key) const {
    static constexpr std::array of_plan = {
        "plan", "plane", "rigidity", "y", "points", "friction", "tangential_stiffness"};
    static constexpr std::array of_files = {"shapes_file", "files", "folder", "logo"};
    const auto is = [&](const char* name) { return key.name == name; };
    if (std::any_of(of_plan.begin(), of_plan.end(), is) || std::any_of(of_files.begin(), of_files.end(), is))
      return true;
    return of_columns_ ? key.name == "line_load" : key.name == "shear_capacity" || key.name == "residual_shear";
  }
  /// Whether a key that may be left out is there: those without which there is hardly a case always.
  bool wanted(const Key& key, const KeyTable& keys) {
    static constexpr std::array always = {"gap",      "contact", "width", "damping", "analysis",
                                          "duration", "unit",    "depth", "inertia"};
    if (key.name == "width" && keys.name == "building") return false;
    return std::find(always.begin(), always.end(), key.name) != always.end() || seldom();
  }

  std::string in_braces(const KeyTable& keys) {
    std::string text;
    for (const auto& [name, value] : entries(keys)) text += (text.empty() ? "" : ", ") + name + " = " + value;
    return "{" + text + "}";
  }

  std::size_t count_of(const Key& key) {
    if (key.count > 0) return key.count;
    if (key.name == "building" || key.each == "one per building") return buildings_;
    if (key.name == "gap") return buildings_ - 1;
    if (key.name == "link" || key.name == "bay_widths") return 1 + below(2);
    if (key.kind == Key::Kind::table) return 1;
    return floors_;
  }

  std::string value_of(const Key& key, const KeyTable& keys) {
    of_columns_ = key.name == "columns";
    if (key.name == "between") {
      const std::size_t left = std::min(gap_++ % buildings_, buildings_ - 2);
      return fmt::format("[\"B{}\", \"B{}\"]", left, left + 1);
    }
    if (key.name == "elevations") return elevations(keys.name == "gap" || keys.name == "link");
    if (key.name == "storeys") return fmt::format("{}", floors_);
    if (key.kind == Key::Kind::by_building) return by_building(key);
    if (key.form == Key::Form::matrix) return matrix(key);
    if (key.form == Key::Form::one || (key.form == Key::Form::one_or_list && !seldom())) return one(key);
    std::vector<std::string> items;
    for (std::size_t i = 0, count = count_of(key); i < count; ++i) items.push_back(one(key));
    if (key.name == "rotation_limits") return "[0.01, 0.02, 0.03]";
    return fmt::format("[{}]", fmt::join(items, ", "));
  }

  /// Of floors of three in height each, all or, where that may be, all but the lowest.
  std::string elevations(bool or_fewer) {
    std::vector<std::string> items;
    for (std::size_t i = or_fewer && floors_ > 1 && seldom() ? 1 : 0; i < floors_; ++i)
      items.push_back(fmt::format("{}", 3 * (i + 1)));
    return fmt::format("[{}]", fmt::join(items, ", "));
  }

  std::string by_building(const Key& key) {
    std::vector<std::string> items;
    for (std::size_t i = 0; i < floors_; ++i) items.push_back(one_number(key));
    return fmt::format("{{B{} = [{}]}}", below(buildings_), fmt::join(items, ", "));
  }

  /// Symmetric, of a chain of storeys; of a diagonal alone where that may stand for it.
  std::string matrix(const Key& key) {
    std::vector<std::string> rows;
    const double size = std::abs(std::strtod(one_number(key).c_str(), nullptr));
    for (std::size_t i = 0; i < floors_; ++i) {
      std::vector<double> row(floors_, 0.0);
      row[i] = size * (key.or_diagonal || i + 1 == floors_ ? 1 : 2);
      if (!key.or_diagonal && i > 0) row[i - 1] = -size;
      if (!key.or_diagonal && i + 1 < floors_) row[i + 1] = -size;
      rows.push_back(fmt::format("[{}]", fmt::join(row, ", ")));
    }
    return fmt::format("[{}]", fmt::join(rows, ", "));
  }

  std::string one(const Key& key) {
    switch (key.kind) {
      case Key::Kind::flag:
        return below(2) == 0 ? "false" : "true";
      case Key::Kind::choice:
        return fmt::format("\"{}\"", key.words[below(key.name == "kind" && !seldom() ? 2 : key.words.size())]);
      case Key::Kind::table:
        return in_braces(*key.table);
      case Key::Kind::whole:
        return fmt::format("{}", key.least + static_cast<std::int64_t>(below(6)));
      case Key::Kind::file:
        return "\"../data/el-centro-1940-ns.csv\"";
      case Key::Kind::text:
      case Key::Kind::line:
        return fmt::format("\"B{}\"", key.name == "name" ? name_++ : 0);
      default:
        if (key.table != nullptr && seldom()) return in_braces(*key.table);
        if (!key.words.empty() && seldom()) return fmt::format("\"{}\"", key.words[below(key.words.size())]);
        return one_number(key);
    }
  }

  /// Of the size of a building's numbers in kN and m, up to a factor of 30 either way, and within its range.
  std::string one_number(const Key& key) {
    const double fraction = static_cast<double>(1 + below(254)) / 256;
    const Bounds bounds = bounds_of(key.range);
    if (key.name == "storey_heights" || key.name == "storey_height") return "3";
    if (key.dimension == dimension::none && bounds.least && bounds.most && *bounds.most <= 1) {
      return fmt::format("{:.4g}", *bounds.least + fraction * (*bounds.most - *bounds.least));
    }
    const double usual = key.name == "stiffness" || key.name == "stiffnesses" ? 1e5
                         : key.name == "elastic_modulus"                      ? 3e7
                                                                              : 1;
    const double middle =
        usual * key.dimension.factor(usual == 1 ? 3 : 1, usual == 1 ? 100 : 1) * std::pow(0.3, key.dimension.time);
    const double value = middle * std::pow(10.0, 3 * fraction - 1.5);
    return fmt::format("{:.4g}", std::clamp(value, bounds.least.value_or(value), bounds.most.value_or(value)));
  }

  const std::string& bytes_;
  std::size_t next_ = 0, floors_ = 1, buildings_ = 2, name_ = 0, gap_ = 0;
  bool of_columns_ = false;
};

}  // namespace

void feed(const std::string& input) {
  const std::string text = CaseMaker(input).make();
  if (std::getenv("BENTUR_FUZZ_SHOW") != nullptr) fmt::print("{}\n", text);
  Diagnostics diagnostics;
  auto c = read_case_text(text, folder() / "fuzzed.toml", diagnostics);
  demand(c.has_value() == diagnostics.ok(), "a case is refused without a message, or read with one");
  if (std::getenv("BENTUR_FUZZ_SHOW") != nullptr) {
    for (const Diagnostic& error : diagnostics.errors()) fmt::print("{}\n", error.text());
  }
  if (c) accepted(run_shortly(*std::move(c)));
}

}  // namespace bentur::fuzz
