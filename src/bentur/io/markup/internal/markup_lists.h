#pragma once

#include <optional>
#include <string>
#include <string_view>

// What may stand in markup from elsewhere, element by element, attribute by attribute.
namespace bentur::markup {

enum class Family {
  none,     ///< may not stand
  dropped,  ///< is left out with all that stands in it
  text,     ///< of XHTML
  picture   ///< of SVG
};
[[nodiscard]] Family family_of(std::string_view element);

/// <br>, <hr>: elements that do not close.
[[nodiscard]] bool is_void(std::string_view element);
[[nodiscard]] bool takes_text(std::string_view element);

/// An attribute that drawing programs keep for themselves, or that says nothing here.
[[nodiscard]] bool is_dropped_attribute(std::string_view name);
/// A property of `style` that may be an attribute too.
[[nodiscard]] bool is_style(std::string_view property);
/// A declaration without which the picture is the same.
[[nodiscard]] bool asks_for_nothing(std::string_view property, std::string_view value);

struct SafeValue {
  std::optional<std::string> value = {};
  std::string rule = {};  ///< why there is none; empty: the element has no such attribute
};
/// The value of an attribute as it may stand in a page; ids and references to them begin with `prefix`.
[[nodiscard]] SafeValue safe_value(std::string_view element, Family family, std::string_view name,
                                   const std::string& value, const std::string& prefix);

/// "120" of "120", "120px" and "120.0"; empty where it is no number of pixels above 0.
[[nodiscard]] std::string pixels(const std::string& size);

/// The character of "amp", "#65", "#x41"; nothing where there is none that XML and HTML allow.
[[nodiscard]] std::optional<std::string> entity(const std::string& name);

}  // namespace bentur::markup
