#include <algorithm>
#include <string_view>
#include <utility>

#include "bentur/io/exchange/internal/geo_text.h"
#include "bentur/io/json_position.h"

namespace bentur {
namespace {

constexpr char record_separator = '\x1e';  // RFC 8142, 2.1
constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
constexpr std::string_view json_blanks = " \t\r\n";

/// Where the entries of the list `features` begin, of a text that is JSON.
std::vector<SourcePosition> places_of_features(const std::string& file, const std::string& text) {
  std::vector<SourcePosition> places;
  int line = 1, depth = 0;
  std::size_t line_begin = 0, string_begin = 0;
  bool in_string = false, is_features = false, is_entry_due = false;
  std::string_view last;  // the string that ended last
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (c == '\n') {
      ++line;
      line_begin = i + 1;
    }
    if (in_string) {
      if (c == '\\') ++i;
      if (c != '"') continue;
      in_string = false;
      last = std::string_view(text).substr(string_begin, i - string_begin);
      continue;
    }
    if (c == ' ' || c == '\t' || c == '\r' || c == '\n') continue;
    if (depth == 2 && is_features && is_entry_due && c != ']') {
      places.push_back({file, line, static_cast<int>(i - line_begin) + 1});
      is_entry_due = false;
    }
    if (c == '"') {
      in_string = true;
      string_begin = i + 1;
    } else if (c == ':' && depth == 1) {
      is_features = last == "features";
      if (is_features) places.clear();
    } else if (c == '{' || c == '[') {
      ++depth;
      if (depth == 2 && is_features) is_entry_due = true;
    } else if (c == '}' || c == ']') {
      --depth;
    } else if (c == ',' && depth == 2) {
      is_entry_due = true;
    }
  }
  return places;
}

std::size_t begin_of_json(const std::string& text) {
  const std::size_t mark = text.starts_with(byte_order_mark) ? byte_order_mark.size() : 0;
  return std::min(text.find_first_not_of(json_blanks, mark), text.size());
}

bool is_of_type(const GeoNode& node, const char* type) {
  return node.is_object() && node.value("type", GeoNode()) == type;
}

/// Features one after the other: each begins with the separator, or the first is a line that another one follows.
bool is_sequence(const std::string& text) {
  const std::size_t begin = begin_of_json(text);
  if (begin == text.size()) return false;
  if (text[begin] == record_separator) return true;
  const std::size_t end = std::min(text.find('\n', begin), text.size());
  if (text.find_first_not_of(json_blanks, end) == std::string::npos) return false;
  const std::string_view line = std::string_view(text).substr(begin, end - begin);
  return is_of_type(GeoNode::parse(line, nullptr, false), "Feature");
}

/// A text that is JSON, or what of it is not.
std::optional<GeoNode> parse_geo(std::string_view part, std::size_t begin, const std::string& text,
                                 const std::string& file, Diagnostics& diagnostics) {
  try {
    return GeoNode::parse(part);
  } catch (const GeoNode::parse_error& fault) {
    diagnostics.error(json_position(file, text, begin + fault.byte), no_json);
  } catch (const GeoNode::exception&) {
    diagnostics.error(begin == 0 ? SourcePosition{file} : json_position(file, text, begin + 1),
                      "has a number that is too large");
  }
  return std::nullopt;
}

std::optional<GeoText> read_sequence(const std::string& text, const std::string& file, Diagnostics& diagnostics) {
  GeoText read;
  const char end_of_one = text[begin_of_json(text)] == record_separator ? record_separator : '\n';
  int line = 1;
  std::size_t counted_to = 0;
  for (std::size_t at = begin_of_json(text); at < text.size();) {
    const std::size_t end = std::min(text.find(end_of_one, at), text.size());
    const std::size_t begin = std::min(text.find_first_not_of(json_blanks, at), end);
    if (begin < end) {
      auto node = parse_geo(std::string_view(text).substr(begin, end - begin), begin, text, file, diagnostics);
      if (!node) return std::nullopt;
      line += static_cast<int>(std::count(text.data() + counted_to, text.data() + begin, '\n'));
      counted_to = begin;
      const std::size_t newline = begin == 0 ? std::string::npos : text.rfind('\n', begin - 1);
      const std::size_t line_begin = newline == std::string::npos ? 0 : newline + 1;
      read.features.push_back({*std::move(node), {file, line, static_cast<int>(begin - line_begin) + 1}});
    }
    at = end + 1;
  }
  return read;
}

}  // namespace

std::optional<GeoText> read_geo_text(const std::string& text, const std::string& file, Diagnostics& diagnostics) {
  if (is_sequence(text)) return read_sequence(text, file, diagnostics);
  auto root = parse_geo(text, 0, text, file, diagnostics);
  if (!root) return std::nullopt;
  GeoText read;
  if (root->is_object()) read.crs = root->value("crs", GeoNode());
  if (is_of_type(*root, "Feature")) {
    read.features.push_back({*std::move(root), json_position(file, text, begin_of_json(text) + 1)});
    return read;
  }
  const bool is_collection =
      is_of_type(*root, "FeatureCollection") && root->contains("features") && (*root)["features"].is_array();
  if (!is_collection) {
    diagnostics.error({file},
                      "must be a GeoJSON FeatureCollection with its features (RFC 7946), a Feature, or features one a "
                      "line (RFC 8142)");
    return std::nullopt;
  }
  const auto places = places_of_features(file, text);
  for (GeoNode& feature : (*root)["features"]) {
    const std::size_t i = read.features.size();
    read.features.push_back({std::move(feature), i < places.size() ? places[i] : SourcePosition{file}});
  }
  return read;
}

}  // namespace bentur
