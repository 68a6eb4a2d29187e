#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "bentur/core/diagnostics.h"

namespace bentur {

/// Markup from elsewhere that a report takes in.
enum class MarkupKind {
  logo,  ///< one <svg>
  head   ///< an office's head of a report: parts of XHTML, pictures in <svg> among them
};

/// Elements and levels of nesting that are taken.
inline constexpr int most_markup_elements = 5000;
inline constexpr int most_markup_depth = 64;

/// The markup written anew of what its list of elements, attributes and values has, so that it runs nothing, loads
/// nothing, and reaches nothing of the page it stands in: no script, style, link, file, event, entity or animation; ids
/// and references to them get a prefix, words of `class` too. Declarations of `style` within a picture become
/// attributes. What drawing programs keep for themselves, elements and attributes with a prefix, comments, <metadata>,
/// is left out. All else is an error at its place, in `file`.
/// A picture has a viewBox; a head keeps the {words} of template_words() in its texts, all other braces are references.
/// @return nothing where there is an error
[[nodiscard]] std::optional<std::string> safe_markup(const std::string& text, const std::string& file, MarkupKind kind,
                                                     Diagnostics& diagnostics);

/// The same of a file. @return nothing where it cannot be read, or has an error
[[nodiscard]] std::optional<std::string> read_markup(const std::filesystem::path& file, MarkupKind kind,
                                                     Diagnostics& diagnostics);

/// What a head may ask for in braces: "title", "name", "number", "engineer", "date", "revision", "code_basis",
/// "logo", "file", "version".
[[nodiscard]] const std::vector<std::string>& template_words();

/// Puts values in the place of the words of a head, in one go: what stands in a value stays as it is.
/// @param value the markup of a word
template <class Value>
[[nodiscard]] std::string filled_template(std::string_view safe, const Value& value) {
  std::string filled;
  while (!safe.empty()) {
    const std::size_t open = safe.find('{'), close = safe.find('}', open);
    if (close == std::string_view::npos) break;
    filled += safe.substr(0, open);
    filled += value(std::string(safe.substr(open + 1, close - open - 1)));
    safe.remove_prefix(close + 1);
  }
  return filled += safe;
}

}  // namespace bentur
