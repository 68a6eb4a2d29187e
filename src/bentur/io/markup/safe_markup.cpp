#include "bentur/io/markup/safe_markup.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <utility>

#include "bentur/core/text.h"
#include "bentur/io/input_file.h"
#include "bentur/io/internal/text_cursor.h"
#include "bentur/io/markup/internal/markup_lists.h"
#include "bentur/io/toml/toml_view.h"

namespace bentur {
namespace {

using markup::Family;

constexpr std::string_view markup_blanks = " \t\n\r";

bool is_blank(char32_t c) { return c < 0x80 && markup_blanks.find(static_cast<char>(c)) != std::string_view::npos; }

bool is_of_name(char32_t c) {
  return c < 0x80 && (std::isalnum(static_cast<int>(c)) != 0 || c == '_' || c == '-' || c == '.' || c == ':');
}

/// Text as it may stand between tags and within quotes; braces are kept for the words of a head.
std::string escaped(std::string_view text) {
  std::string result;
  for (const char c : text) {
    switch (c) {
      case '&':
        result += "&amp;";
        break;
      case '<':
        result += "&lt;";
        break;
      case '>':
        result += "&gt;";
        break;
      case '"':
        result += "&quot;";
        break;
      case '\'':
        result += "&#39;";
        break;
      case '{':
        result += "&#123;";
        break;
      case '}':
        result += "&#125;";
        break;
      default:
        result += c;
    }
  }
  return result;
}

std::string without_markup_blanks(std::string_view text) { return std::string(trimmed(text, markup_blanks)); }

struct Attribute {
  std::string name, value;
  SourcePosition at;
};

/// Reads markup and writes what of it is on the lists.
class Reader {
 public:
  Reader(const std::string& text, const std::string& file, MarkupKind kind, Diagnostics& diagnostics)
      : cursor_(text), file_(file), kind_(kind), diagnostics_(diagnostics) {}

  std::optional<std::string> read() {
    const std::size_t before = diagnostics_.errors().size();
    if (read_all()) {
      if (!open_.empty()) complain(here(), fmt::format("ends within <{}>", open_.back().name));
      if (kind_ == MarkupKind::logo && pictures_ != 1) complain({file_, 0, 0}, "must be one <svg>");
    }
    if (diagnostics_.errors().size() != before) return std::nullopt;
    return written_;
  }

 private:
  struct Open {
    std::string name;
    bool dropped = false;  ///< with all that stands in it
  };

  [[nodiscard]] SourcePosition here() const { return {file_, cursor_.line(), cursor_.column()}; }
  /// @return false
  bool complain(const SourcePosition& at, const std::string& what) {
    diagnostics_.error(at, what);
    return false;
  }
  [[nodiscard]] const char* what() const { return kind_ == MarkupKind::logo ? "logo" : "template"; }
  [[nodiscard]] bool in_picture() const {
    return std::any_of(open_.begin(), open_.end(), [](const Open& one) { return one.name == "svg"; });
  }
  [[nodiscard]] bool drops() const { return !open_.empty() && open_.back().dropped; }

  /// Steps over so many bytes, which are ASCII or have been looked at.
  bool pass(std::size_t bytes) {
    const std::size_t end = cursor_.rest().size() - bytes;
    while (cursor_.rest().size() > end) {
      const auto c = cursor_.character();
      if (!c) return complain(here(), "not valid UTF-8 (save the file as UTF-8)");
      if (*c < 0x20 && !is_blank(*c)) return complain(here(), "has a control character");
      cursor_.next();
    }
    return true;
  }
  bool pass_behind(std::string_view end, const char* of) {
    const std::size_t found = cursor_.rest().find(end);
    if (found == std::string_view::npos) return complain(here(), fmt::format("ends within {}", of));
    return pass(found + end.size());
  }
  bool pass_blanks() {
    const std::size_t found = cursor_.rest().find_first_not_of(markup_blanks);
    return pass(found == std::string_view::npos ? cursor_.rest().size() : found);
  }
  std::string take_name() {
    std::string name;
    for (const char c : cursor_.rest()) {
      if (!is_of_name(static_cast<unsigned char>(c))) break;
      name += c;
    }
    (void)pass(name.size());
    return name;
  }

  bool read_all() {
    if (cursor_.starts("\xEF\xBB\xBF")) (void)pass(3);
    while (!cursor_.done()) {
      const bool right = cursor_.starts("<!--")        ? pass_behind("-->", "a comment")
                         : cursor_.starts("<?xml ")    ? pass_behind("?>", "a declaration")
                         : cursor_.starts("<!DOCTYPE") ? read_doctype()
                         : cursor_.starts("</")        ? read_end()
                         : cursor_.byte() == '<'       ? read_element()
                                                       : read_text();
      if (!right) return false;
    }
    return true;
  }

  bool read_doctype() {
    const std::string_view declared = cursor_.rest().substr(0, cursor_.rest().find('>'));
    if (declared.find('[') != std::string_view::npos) return complain(here(), "must have no entities of its own");
    return pass_behind(">", "<!DOCTYPE");
  }

  bool read_text() {
    const SourcePosition at = here();
    const std::size_t end = std::min(cursor_.rest().find('<'), cursor_.rest().size());
    const std::string raw(cursor_.rest().substr(0, end));
    if (!pass(end)) return false;
    if (drops()) return true;
    const auto text = decoded(raw, at);
    if (!text) return true;  // which has been said
    if (trimmed(*text, markup_blanks).empty()) {
      if (!open_.empty() || kind_ == MarkupKind::head) written_ += *text;
      return true;
    }
    const bool takes_text = open_.empty() ? kind_ == MarkupKind::head : markup::takes_text(open_.back().name);
    if (!takes_text) {
      complain(at, fmt::format("has text where a {} has none", what()));
    } else if (kind_ == MarkupKind::logo) {
      written_ += escaped(*text);
    } else {
      write_words(*text, at);
    }
    return true;
  }

  /// Text of a head, with its words in braces.
  void write_words(std::string_view text, const SourcePosition& at) {
    const std::vector<std::string>& known = template_words();
    for (std::size_t open = text.find('{'); open != std::string_view::npos; open = text.find('{')) {
      written_ += escaped(text.substr(0, open));
      text.remove_prefix(open + 1);
      const std::size_t close = text.find_first_of("{}");
      if (close == std::string_view::npos || text[close] == '{') {
        written_ += escaped("{");
        continue;
      }
      const std::string word(text.substr(0, close));
      text.remove_prefix(close + 1);
      if (std::find(known.begin(), known.end(), word) != known.end()) {
        written_ += "{" + word + "}";
      } else {
        complain(at, fmt::format("there is nothing for {{{}}}, {}", word, suggestion(word, known, "there are")));
      }
    }
    written_ += escaped(text);
  }

  /// With its five named entities and its numbers as characters.
  std::optional<std::string> decoded(const std::string& raw, const SourcePosition& at) {
    std::string text;
    for (std::size_t i = 0; i < raw.size(); ++i) {
      if (raw[i] != '&') {
        text += raw[i];
        continue;
      }
      const std::size_t end = raw.find(';', i);
      const std::string name = end == std::string::npos ? "" : raw.substr(i + 1, end - i - 1);
      const auto character = markup::entity(name);
      if (!character) {
        complain(at, fmt::format("has &{}, which is no character here", name.empty() ? "" : name + ";"));
        return std::nullopt;
      }
      text += *character;
      i = end;
    }
    return text;
  }

  bool read_end() {
    const SourcePosition at = here();
    (void)pass(2);
    const std::string name = take_name();
    if (!pass_blanks()) return false;
    if (!cursor_.starts(">")) return complain(at, fmt::format("has a tag </{} that does not end", name));
    (void)pass(1);
    if (open_.empty() || open_.back().name != name) {
      return complain(at, open_.empty() ? fmt::format("closes </{}>, which is not open", name)
                                        : fmt::format("closes </{}> where <{}> is open", name, open_.back().name));
    }
    if (!open_.back().dropped) written_ += "</" + name + ">";
    open_.pop_back();
    return true;
  }

  bool read_element() {
    const SourcePosition at = here();
    (void)pass(1);
    const std::string name = take_name();
    if (name.empty()) return complain(at, "has a < that begins no tag; as a character it is &lt;");
    std::vector<Attribute> attributes;
    bool closed = false;
    for (;;) {
      if (!pass_blanks()) return false;
      if (cursor_.starts(">")) break;
      if (cursor_.starts("/>")) {
        closed = true;
        (void)pass(1);
        break;
      }
      if (!read_attribute(name, attributes)) return false;
    }
    (void)pass(1);
    if (++elements_ > most_markup_elements) {
      return complain(at, fmt::format("has more than {} elements", most_markup_elements));
    }
    if (open_.size() >= static_cast<std::size_t>(most_markup_depth)) {
      return complain(at, fmt::format("nests deeper than {} levels", most_markup_depth));
    }
    const Family family = markup::family_of(name);
    const bool dropped =
        drops() || family == Family::dropped || !write_element(name, family, std::move(attributes), at);
    if (kind_ == MarkupKind::head && markup::is_void(name)) return true;
    if (closed) {
      if (!dropped) written_ += "</" + name + ">";
      return true;
    }
    open_.push_back({name, dropped});
    return true;
  }

  bool read_attribute(const std::string& element, std::vector<Attribute>& attributes) {
    const SourcePosition at = here();
    const std::string name = take_name();
    if (name.empty()) return complain(at, fmt::format("has a tag <{} that does not end", element));
    if (!pass_blanks()) return false;
    const bool is_given = cursor_.starts("=");
    if (is_given) (void)pass(1);
    if (!pass_blanks()) return false;
    if (!is_given || !(cursor_.starts("\"") || cursor_.starts("'"))) {
      return complain(at, fmt::format("{} of <{}> must have a value in quotes", name, element));
    }
    const std::string quote(1, cursor_.byte());
    (void)pass(1);
    const std::size_t end = cursor_.rest().find(quote);
    if (end == std::string_view::npos) return complain(at, fmt::format("ends within {} of <{}>", name, element));
    const auto value = decoded(std::string(cursor_.rest().substr(0, end)), at);
    if (!pass(end + 1) || !value) return false;
    const bool again = std::any_of(attributes.begin(), attributes.end(), [&](const auto& a) { return a.name == name; });
    if (again) return complain(at, fmt::format("{} of <{}> is given twice", name, element));
    attributes.push_back({name, *value, at});
    return true;
  }

  /// Says what cannot stand, and goes on, so that all of it is said. @return false where the element itself cannot
  bool write_element(const std::string& name, Family family, std::vector<Attribute> attributes,
                     const SourcePosition& at) {
    const bool is_root = name == "svg" && !in_picture();
    const bool fits = family == Family::picture ? is_root || in_picture() : kind_ == MarkupKind::head && !in_picture();
    if (family == Family::none || !fits || (name == "svg" && !is_root) ||
        (kind_ == MarkupKind::logo && open_.empty() && !is_root)) {
      complain(at, kind_ == MarkupKind::logo
                       ? fmt::format("a logo takes no <{}>: shapes, texts and gradients alone", name)
                       : fmt::format("a template takes no <{}> here: texts, lists, tables and pictures alone", name));
      return false;
    }
    pictures_ += is_root ? 1 : 0;
    if (is_root) give_view_box(attributes, at);
    std::string tag = "<" + name;
    std::vector<std::string> written;
    const auto write = [&](const std::string& key, const std::string& value) {
      if (std::find(written.begin(), written.end(), key) != written.end()) return;  // that of `style` counts
      written.push_back(key);
      tag += " " + key + "=\"" + escaped(value) + "\"";
    };
    for (const Attribute& one : attributes) {
      if (one.name == "style" && family == Family::picture) {
        for (const auto& [key, value] : declarations(name, one)) write(key, value);
      }
    }
    for (const Attribute& one : attributes) {
      if (one.name == "style" && family == Family::picture) continue;
      if (markup::is_dropped_attribute(one.name)) continue;
      if (const auto value = safe_value(name, family, one)) write(one.name, *value);
    }
    written_ += tag + ">";
    return true;
  }

  /// Of a picture that has a size alone: what it shows.
  void give_view_box(std::vector<Attribute>& attributes, const SourcePosition& at) {
    const auto named = [&](std::string_view name) {
      return std::find_if(attributes.begin(), attributes.end(), [&](const Attribute& a) { return a.name == name; });
    };
    if (named("viewBox") == attributes.end()) {
      std::string box = "0 0";
      for (const char* const side : {"width", "height"}) {
        const auto found = named(side);
        const std::string size = found == attributes.end() ? "" : markup::pixels(found->value);
        if (size.empty()) {
          complain(at, "<svg> needs a viewBox, or width and height in px");
          return;
        }
        box += " " + size;
      }
      attributes.push_back({"viewBox", box, at});
    }
    if (kind_ == MarkupKind::logo) {  // the page gives it its size
      std::erase_if(attributes, [](const Attribute& a) { return a.name == "width" || a.name == "height"; });
    }
  }

  /// "fill:#fff;stroke:none" as attributes.
  std::vector<std::pair<std::string, std::string>> declarations(const std::string& element, const Attribute& style) {
    std::vector<std::pair<std::string, std::string>> found;
    std::string_view rest = style.value;
    while (!rest.empty()) {
      const std::size_t end = std::min(rest.find(';'), rest.size());
      const std::string one = without_markup_blanks(rest.substr(0, end));
      rest.remove_prefix(std::min(end + 1, rest.size()));
      if (one.empty()) continue;
      const std::size_t colon = std::min(one.find(':'), one.size());
      const std::string key = without_markup_blanks(one.substr(0, colon));
      const std::string value = colon < one.size() ? without_markup_blanks(one.substr(colon + 1)) : "";
      if (markup::asks_for_nothing(key, value)) continue;
      if (!markup::is_style(key)) {
        complain(style.at, fmt::format("style of <{}> takes no {} here", element, key));
      } else if (const auto safe = safe_value(element, Family::picture, {key, value, style.at})) {
        found.emplace_back(key, *safe);
      }
    }
    return found;
  }

  std::optional<std::string> safe_value(const std::string& element, Family family, const Attribute& one) {
    const std::string prefix = kind_ == MarkupKind::logo ? "logo-" : "head-";
    const auto found = markup::safe_value(element, family, one.name, without_markup_blanks(one.value), prefix);
    if (found.value) return found.value;
    if (found.rule.empty()) {
      complain(one.at, fmt::format("<{}> takes no {} here", element, one.name));
    } else {
      diagnostics_.add({.position = one.at, .key = one.name, .value = in_quotes(one.value), .rule = found.rule});
    }
    return std::nullopt;
  }

  TextCursor cursor_;
  std::string file_;
  MarkupKind kind_;
  Diagnostics& diagnostics_;
  std::vector<Open> open_;
  int elements_ = 0, pictures_ = 0;
  std::string written_;
};

}  // namespace

const std::vector<std::string>& template_words() {
  static const std::vector<std::string> words = {"title",    "name",       "number", "engineer", "date",
                                                 "revision", "code_basis", "logo",   "file",     "version"};
  return words;
}

std::optional<std::string> safe_markup(const std::string& text, const std::string& file, MarkupKind kind,
                                       Diagnostics& diagnostics) {
  return Reader(text, file, kind, diagnostics).read();
}

std::optional<std::string> read_markup(const std::filesystem::path& file, MarkupKind kind, Diagnostics& diagnostics) {
  const auto text = read_input(file, kind == MarkupKind::logo ? logo_input : template_input, diagnostics);
  return text ? safe_markup(*text, file.string(), kind, diagnostics) : std::nullopt;
}

}  // namespace bentur
