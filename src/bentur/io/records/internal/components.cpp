#include "bentur/io/records/internal/components.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <map>

#include "bentur/io/records/internal/heading_words.h"

namespace bentur::records {
namespace {

constexpr int upward = -1;  // in place of an azimuth

bool all_digits(std::string_view text) {
  return !text.empty() && std::all_of(text.begin(), text.end(), [](char c) { return c >= '0' && c <= '9'; });
}

/// Letters and digits of a name, without what says that it is one: "Chan 1: 90 Deg" is 90, "N90E;+" N90E, "Acc X (g)"
/// X.
std::string plain_component(const std::string& name) {
  std::string text = folded(name);
  text = text.substr(0, text.find(';'));
  if (text.starts_with("CHAN") && text.find(':') != std::string::npos) text.erase(0, text.find(':') + 1);
  if (const std::size_t unit = text.find_first_of("(["); unit != std::string::npos && unit > 0) text.erase(unit);
  for (const std::string_view word : {"COMPONENT", "COMP", "DEG", "ACCELERATION", "ACCEL", "ACC"}) {
    if (const std::size_t at = text.find(word); at != std::string::npos) text.erase(at, word.size());
  }
  std::erase_if(text, [](char c) { return static_cast<unsigned char>(c) < 0x80 && std::isalnum(c) == 0; });
  return text;
}

/// Degrees from north over east, or `upward`; nothing for other names.
std::optional<int> azimuth_of(std::string_view plain) {
  static const std::map<std::string_view, int> names = {
      {"NS", 0},           {"N", 0},      {"NORTH", 0},     {"NORTE", 0},         {"KUZEY", 0},
      {"UTARA", 0},        {"EW", 90},    {"E", 90},        {"EAST", 90},         {"ESTE", 90},
      {"DOGU", 90},        {"TIMUR", 90}, {"UD", upward},   {"U", upward},        {"UP", upward},
      {"V", upward},       {"Z", upward}, {"VERT", upward}, {"VERTICAL", upward}, {"DUSEY", upward},
      {"VERTIKAL", upward}};
  // SEED names of accelerometers, HNE.
  if (plain.size() == 3 && (plain[1] == 'N' || plain[1] == 'L' || plain[1] == 'H') &&
      std::string_view("NEZ").find(plain[2]) != std::string_view::npos &&
      std::string_view("HBES").find(plain[0]) != std::string_view::npos) {
    plain.remove_prefix(2);
  }
  if (const auto found = names.find(plain); found != names.end()) return found->second;
  const auto degrees = [](std::string_view digits) { return digits.size() > 3 ? 999 : std::stoi(std::string(digits)); };
  if (all_digits(plain)) {
    const int azimuth = degrees(plain);
    return azimuth <= 360 ? std::optional(azimuth % 360) : std::nullopt;
  }
  if (plain.size() < 3 || (plain.front() != 'N' && plain.front() != 'S')) return std::nullopt;
  const bool west = plain.back() == 'W' || plain.back() == 'O';
  if ((plain.back() != 'E' && !west) || !all_digits(plain.substr(1, plain.size() - 2))) return std::nullopt;
  const int angle = degrees(plain.substr(1, plain.size() - 2));
  if (angle > 90) return std::nullopt;
  const int from_north = plain.front() == 'N' ? angle : 180 - angle;
  return (west ? 360 - from_north : from_north) % 360;
}

}  // namespace

std::string printable(std::string_view text) {
  std::string result;
  for (const char c : text) result += c >= 0x20 && c < 0x7F ? c : '?';
  return result;
}

std::string in_words(const std::string& name) { return "\"" + printable(name) + "\""; }

bool is_direction(const std::string& name) { return azimuth_of(plain_component(name)).has_value(); }

bool same_component(const std::string& one, const std::string& other) {
  const std::string a = plain_component(one), b = plain_component(other);
  if (a.empty() || b.empty()) return false;
  const auto azimuth = azimuth_of(a);
  return a == b || (azimuth && azimuth == azimuth_of(b));
}

std::optional<std::size_t> named_component(const std::vector<std::string>& names, const char* otherwise,
                                           const RecordOptions& options, RecordErrors& errors) {
  const std::string& asked = *options.component;
  std::optional<std::size_t> found;
  std::string list;
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (!names[i].empty()) list += (list.empty() ? "" : ", ") + in_words(names[i]);
    if (!same_component(names[i], asked)) continue;
    if (found) {
      return errors.error(fmt::format("has the component {} twice, {} and {}: say which one in {} instead",
                                      in_words(asked), in_words(names[*found]), in_words(names[i]),
                                      options.name(otherwise)));
    }
    found = i;
  }
  if (found) return found;
  if (list.empty()) {
    return errors.error(fmt::format("names no components, so that {} cannot be looked for: say which one in {} instead",
                                    options.setting("component", asked), options.name(otherwise)));
  }
  return errors.error(fmt::format("has no component {}, but {}", in_words(asked), list));
}

}  // namespace bentur::records
