#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cstdint>

#include "bentur/io/markup/internal/markup_lists.h"

namespace bentur::markup {
namespace {

constexpr auto text_elements =
    std::to_array<std::string_view>({"div", "p",  "span",  "h1",    "h2",    "h3", "strong", "em", "b",  "i",  "small",
                                     "br",  "hr", "table", "thead", "tbody", "tr", "th",     "td", "ul", "ol", "li"});
constexpr auto picture_elements = std::to_array<std::string_view>(
    {"svg", "g", "defs", "path", "rect", "circle", "ellipse", "line", "polyline", "polygon", "text", "tspan",
     "linearGradient", "radialGradient", "stop", "clipPath"});
constexpr auto dropped_elements = std::to_array<std::string_view>({"metadata", "title", "desc"});

/// Attributes of pictures that `style` has too.
constexpr auto style_attributes = std::to_array<std::string_view>(
    {"fill",           "fill-opacity",    "fill-rule",         "stroke",           "stroke-opacity",    "stroke-width",
     "stroke-linecap", "stroke-linejoin", "stroke-miterlimit", "stroke-dasharray", "stroke-dashoffset", "opacity",
     "color",          "clip-path",       "clip-rule",         "stop-color",       "stop-opacity",      "font-family",
     "font-size",      "font-weight",     "font-style",        "text-anchor",      "letter-spacing",    "display",
     "visibility"});
constexpr auto picture_attributes = std::to_array<std::string_view>({"d",
                                                                     "points",
                                                                     "x",
                                                                     "y",
                                                                     "x1",
                                                                     "y1",
                                                                     "x2",
                                                                     "y2",
                                                                     "dx",
                                                                     "dy",
                                                                     "cx",
                                                                     "cy",
                                                                     "r",
                                                                     "rx",
                                                                     "ry",
                                                                     "fx",
                                                                     "fy",
                                                                     "width",
                                                                     "height",
                                                                     "offset",
                                                                     "transform",
                                                                     "viewBox",
                                                                     "preserveAspectRatio",
                                                                     "gradientUnits",
                                                                     "gradientTransform",
                                                                     "spreadMethod",
                                                                     "clipPathUnits"});
/// Of them those without which the picture is the same, or that no picture here needs.
constexpr auto dropped_attributes = std::to_array<std::string_view>(
    {"xmlns", "version", "baseProfile", "enable-background", "overflow", "shape-rendering", "text-rendering",
     "color-rendering", "image-rendering", "paint-order", "role"});
constexpr auto idle_properties = std::to_array<std::string_view>(
    {"enable-background", "overflow", "isolation", "line-height", "white-space", "paint-order", "shape-rendering",
     "text-rendering", "color-rendering", "image-rendering", "color-interpolation", "color-interpolation-filters",
     "solid-color", "solid-opacity", "font-stretch", "text-indent", "text-align", "writing-mode", "direction"});
constexpr auto classes =
    std::to_array<std::string_view>({"left", "right", "center", "small", "large", "bold", "faint", "line", "row"});

template <class List>
bool has(const List& list, std::string_view one) {
  return std::find(list.begin(), list.end(), one) != list.end();
}

bool is_id(std::string_view text) {
  const auto letter = [](char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0 || c == '_'; };
  return !text.empty() && letter(text.front()) && std::all_of(text.begin(), text.end(), [&](char c) {
    return letter(c) || std::isdigit(static_cast<unsigned char>(c)) != 0 || c == '-' || c == '.';
  });
}

bool is_plain(std::string_view text) {
  return std::all_of(text.begin(), text.end(), [](char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 ||
           std::string_view(" \t\r\n.,#%()+-_'").find(c) != std::string_view::npos;
  });
}

std::string lower(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

/// "#name" with the prefix; empty where it is no reference.
std::string reference(std::string_view text, const std::string& prefix) {
  if (!text.starts_with('#') || !is_id(text.substr(1))) return {};
  return "#" + prefix + std::string(text.substr(1));
}

SafeValue picture_value(std::string_view name, const std::string& value, const std::string& prefix) {
  if (lower(value).find("url") != std::string::npos) {
    const std::string inner =
        value.starts_with("url(") && value.ends_with(")") ? value.substr(4, value.size() - 5) : "";
    const std::string target = reference(inner, prefix);
    const bool takes = name == "fill" || name == "stroke" || name == "clip-path";
    if (target.empty() || !takes) return {.rule = "must name nothing outside, but an id in the picture: url(#a)"};
    return {"url(" + target + ")"};
  }
  if (!is_plain(value)) return {.rule = "must be of letters, digits, blanks and . , # % ( ) + - _ ' alone"};
  return {value};
}

std::string classes_of(const std::string& value) {
  std::string found;
  std::string_view rest = value;
  while (!rest.empty()) {
    const std::size_t end = std::min(rest.find(' '), rest.size());
    const std::string_view word = rest.substr(0, end);
    rest.remove_prefix(std::min(end + 1, rest.size()));
    if (word.empty()) continue;
    if (!has(classes, word)) return {};
    found += (found.empty() ? "head-" : " head-") + std::string(word);
  }
  return found;
}

void append_utf8(std::uint32_t code, std::string& text) {
  const auto tail = [&](int shift) { text += static_cast<char>(0x80U | ((code >> shift) & 0x3FU)); };
  if (code < 0x80) {
    text += static_cast<char>(code);
  } else if (code < 0x800) {
    text += static_cast<char>(0xC0U | (code >> 6));
    tail(0);
  } else if (code < 0x10000) {
    text += static_cast<char>(0xE0U | (code >> 12));
    tail(6), tail(0);
  } else {
    text += static_cast<char>(0xF0U | (code >> 18));
    tail(12), tail(6), tail(0);
  }
}

}  // namespace

Family family_of(std::string_view element) {
  if (element.find(':') != std::string_view::npos || has(dropped_elements, element)) return Family::dropped;
  return has(picture_elements, element) ? Family::picture : has(text_elements, element) ? Family::text : Family::none;
}

bool is_void(std::string_view element) { return element == "br" || element == "hr"; }

bool takes_text(std::string_view element) {
  if (element == "text" || element == "tspan") return true;
  const bool is_frame = element == "table" || element == "thead" || element == "tbody" || element == "tr" ||
                        element == "ul" || element == "ol";
  return family_of(element) == Family::text && !is_frame;
}

bool is_dropped_attribute(std::string_view name) {
  if (name == "xlink:href") return false;
  return name.find(':') != std::string_view::npos || has(dropped_attributes, name) || name.starts_with("data-") ||
         name.starts_with("aria-");
}

bool is_style(std::string_view property) { return has(style_attributes, property); }

bool asks_for_nothing(std::string_view property, std::string_view value) {
  const bool is_plain_word = value == "none" || value == "normal" || value == "auto" || value == "inherit";
  return property.starts_with("-") || property.starts_with("font-variant") || property.starts_with("font-feature") ||
         has(idle_properties, property) || (!is_style(property) && is_plain_word);
}

SafeValue safe_value(std::string_view element, Family family, std::string_view name, const std::string& value,
                     const std::string& prefix) {
  if (family == Family::picture) {
    const bool is_gradient = element == "linearGradient" || element == "radialGradient";
    if ((name == "href" || name == "xlink:href") && is_gradient) {
      const std::string target = reference(value, prefix);
      if (target.empty()) return {.rule = "must name nothing outside, but an id in the picture: #a"};
      return {target};
    }
    if (name == "id") {
      if (!is_id(value)) return {.rule = "must be a letter, then letters, digits and - . _"};
      return {prefix + value};
    }
    if (has(style_attributes, name) || has(picture_attributes, name)) return picture_value(name, value, prefix);
    return {};
  }
  if (name == "class") {
    const std::string found = classes_of(value);
    if (found.empty()) return {.rule = "must be of left, right, center, small, large, bold, faint, line, row"};
    return {found};
  }
  const bool is_cell = element == "td" || element == "th";
  if (is_cell && (name == "colspan" || name == "rowspan")) {
    const bool is_count = value.size() == 1 && value[0] >= '1' && value[0] <= '9';
    return is_count ? SafeValue{value} : SafeValue{.rule = "must be a whole number from 1 to 9"};
  }
  if (element == "th" && name == "scope" && (value == "row" || value == "col")) return {value};
  return {};
}

std::string pixels(const std::string& size) {
  const std::string number = size.ends_with("px") ? size.substr(0, size.size() - 2) : size;
  const bool is_number = std::all_of(number.begin(), number.end(), [](char c) {
    return c == '.' || std::isdigit(static_cast<unsigned char>(c)) != 0;
  });
  const bool is_above = number.find_first_of("123456789") != std::string::npos;
  return is_number && is_above && number.size() < 12 && std::count(number.begin(), number.end(), '.') < 2 ? number : "";
}

std::optional<std::string> entity(const std::string& name) {
  if (name == "amp") return "&";
  if (name == "lt") return "<";
  if (name == "gt") return ">";
  if (name == "quot") return "\"";
  if (name == "apos") return "'";
  if (!name.starts_with('#')) return std::nullopt;
  const bool hexadecimal = name.starts_with("#x");
  std::uint32_t code = 0;
  const char* const first = name.data() + (hexadecimal ? 2 : 1);
  const char* const last = name.data() + name.size();
  const auto [end, error] = std::from_chars(first, last, code, hexadecimal ? 16 : 10);
  const bool is_surrogate = code >= 0xD800 && code <= 0xDFFF;
  if (error != std::errc{} || end != last || code > 0x10FFFF || is_surrogate || (code >= 0x7F && code < 0xA0) ||
      (code < 0x20 && code != '\t' && code != '\n')) {
    return std::nullopt;
  }
  std::string text;
  append_utf8(code, text);
  return text;
}

}  // namespace bentur::markup
