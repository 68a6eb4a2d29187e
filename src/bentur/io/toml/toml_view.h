#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "bentur/core/diagnostics.h"
#include "bentur/core/key.h"
#include "bentur/io/toml/toml_value.h"

namespace bentur {

/// How many values a list must have and why, e.g. {3, "one per storey"}; count 0: any number from one.
struct Length {
  std::size_t count = 0;
  std::string each;
};

/// A value of a TOML file together with the name a user knows it by: the key path, as in
/// `building["Model 1"].frame.beams[0].mass`. What is wrong with it goes to the diagnostics with its position;
/// every reader then returns nothing, or an empty list, so that reading can go on and collect the other errors.
class TomlView {
 public:
  /// All three must outlive the view.
  TomlView(const TomlValue& value, std::string path, const std::string& file, Diagnostics& diagnostics)
      : value_(&value), path_(std::move(path)), file_(&file), diagnostics_(&diagnostics) {}

  [[nodiscard]] const std::string& path() const { return path_; }
  [[nodiscard]] const TomlValue& value() const { return *value_; }
  [[nodiscard]] SourcePosition position() const { return value_->position(*file_); }
  [[nodiscard]] bool is(TomlValue::Kind kind) const { return value_->kind == kind; }
  [[nodiscard]] bool is_number() const { return value_->is_number(); }

  /// The same value under another name.
  [[nodiscard]] TomlView renamed(std::string path) const { return {*value_, std::move(path), *file_, *diagnostics_}; }

  // Errors about this value. Each returns nothing, for a reader to return in turn.
  std::nullopt_t error(const std::string& message) const;  ///< "PATH MESSAGE"
  /// "PATH = VALUE, RULE", or "PATH is a list, RULE".
  std::nullopt_t error_value(const std::string& rule, const std::string& suggestion = {}) const;
  std::nullopt_t error_shown(const std::string& value, const std::string& rule) const;  ///< the same, so shown
  std::nullopt_t error_missing(const std::string& key,
                               const std::string& reason = {}) const;  ///< "PATH.KEY is missing (REASON)"

  /// Whether something has been said of this value itself.
  [[nodiscard]] bool has_error() const;

  // Tables.
  /// False (and an error) unless this is a table; an error for each key that is not in `known`.
  /// @param listed those that it names where none is like the key; null: all
  /// @param elsewhere where else a key may have been meant to stand, "" for nowhere
  [[nodiscard]] bool is_table_of(const std::vector<std::string>& known,
                                 const std::vector<std::string>* listed = nullptr,
                                 const std::function<std::string(const std::string& key)>& elsewhere = {}) const;
  [[nodiscard]] bool has(const std::string& key) const { return value_->find(key) != nullptr; }
  /// Nothing where the key is missing.
  [[nodiscard]] std::optional<TomlView> find(const std::string& key) const;
  /// An error where a required key is missing.
  [[nodiscard]] std::optional<TomlView> get(const std::string& key, Need need = Need::required) const;
  /// The list of tables headed [[key]]; an error with `reason` where there is none.
  [[nodiscard]] std::optional<TomlView> tables(const std::string& key, const std::string& reason) const;
  /// Of two or more keys that exclude one another the one given; an error when there is none (unless optional) or more.
  [[nodiscard]] std::optional<std::string> exactly_one(const std::vector<std::string>& keys,
                                                       Need need = Need::required) const;
  /// An error with `reason` at each of the keys that is given.
  void refuse(const std::vector<std::string>& keys, const std::string& reason) const;

  // Lists.
  [[nodiscard]] std::size_t size() const { return value_->size(); }
  [[nodiscard]] std::string entries() const;  ///< "1 entry", "3 entries"
  [[nodiscard]] TomlView item(std::size_t index) const;
  [[nodiscard]] std::vector<TomlView> items() const;
  /// False (and an error) unless this is a list of the length asked for, with one entry at least.
  [[nodiscard]] bool is_list_of(const std::string& what, const Length& length = {}) const;
  /// Whether this is a list of more entries (and an error); 0: of as many as there are.
  [[nodiscard]] bool has_more_than(std::int64_t most) const;

  // This value itself.
  [[nodiscard]] std::optional<double> as_number(Range range) const;
  [[nodiscard]] std::vector<double> as_numbers(Range range, const Length& length = {}) const;
  /// One number for all, or one for each as `length` says.
  [[nodiscard]] std::vector<double> as_number_or_numbers(Range range, const Length& length) const;
  /// The same, one number said once for each.
  [[nodiscard]] std::vector<double> as_number_for_each(Range range, const Length& length) const;
  /// A whole number in [least, most].
  [[nodiscard]] std::optional<std::int64_t> as_whole(std::int64_t least, std::int64_t most) const;
  [[nodiscard]] std::optional<std::string> as_text() const;
  /// One line without control characters, and without those that turn the direction of a text: what is printed of it
  /// cannot pass for something else.
  [[nodiscard]] std::optional<std::string> as_line() const;
  [[nodiscard]] std::optional<std::string> as_word(const std::vector<std::string>& known) const;
  [[nodiscard]] std::optional<bool> as_flag() const;

 private:
  const TomlValue* value_;
  std::string path_;
  const std::string* file_;
  Diagnostics* diagnostics_;
};

/// The characters of keys that need no quotes.
inline constexpr std::string_view bare_key_characters =
    "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-";

/// `path.key`, or `path["a key"]` where it needs quotes.
[[nodiscard]] std::string key_path(const std::string& path, const std::string& key);

/// "text" in quotes as a message shows it: control characters escaped, long ones cut.
[[nodiscard]] std::string in_quotes(const std::string& text);

/// Whether a text has no control characters, ends of lines and marks of direction.
[[nodiscard]] bool is_one_line(const std::string& text);

/// The one of `known` that may have been meant; empty where none is near.
[[nodiscard]] std::string likely(const std::string& word, const std::vector<std::string>& known);

/// The end of a message about an unknown word: `did you mean "hertz"?`, or `must be one of a, b, c`.
[[nodiscard]] std::string suggestion(const std::string& word, const std::vector<std::string>& known,
                                     const std::string& otherwise = "must be one of");

}  // namespace bentur
