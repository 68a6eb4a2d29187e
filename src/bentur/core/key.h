#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "bentur/core/physical_dimension.h"

namespace bentur {

/// The values a number may take; a message states the rule.
/// ratio: [0, 1), restitution: (0, 1], share: [0, 1]; all but positive_or_infinite are finite. size: [1e-9, 1e9], of
/// lengths, gravity and durations, so that what is divided by them is finite; distance: [0, 1e9]; level: an elevation
/// or a displacement, within ±1e9. The last four are of one key each: [0, 0.5], [1e-13, 1e-2], [1, 1e15], (0, 1e9].
enum class Range {
  finite,
  positive,
  positive_or_infinite,
  not_negative,
  not_zero,
  ratio,
  restitution,
  share,
  size,
  distance,
  level,
  poisson,
  tolerance,
  step_limit,
  memory_limit
};

/// The rule that a number breaks, as a message says it; empty where it keeps it.
[[nodiscard]] std::string_view broken_rule(Range range, double x);

/// What documents say of a range, "> 0" or "in [0, 1)"; empty where any number will do.
[[nodiscard]] std::string_view range_text(Range range);

/// Ends of a range; nothing where it has none.
struct Bounds {
  std::optional<double> least = std::nullopt, most = std::nullopt;
  bool least_excluded = false, most_excluded = false;
};
[[nodiscard]] Bounds bounds_of(Range range);

enum class Need {
  required,
  optional,
  one_of  ///< exactly one of all keys of its group
};

/// A name for people, in the languages of the report and the studio.
struct Label {
  std::string_view english, indonesian;
};

/// A key counts only where another one of its table has one of these words.
struct Condition {
  std::string_view key;
  std::vector<std::string_view> words = {};
};

struct KeyTable;

/// All that is said of one key of a table of a file. It is made by one of the functions below and given the rest by
/// those after them: number("mass", dimension::mass, Range::positive, {"Mass", "Massa"}, "of the slab").optional().
/// Texts are literals: they must outlive the key.
struct Key {
  enum class Kind {
    number,
    quantity,     ///< a number > 0, or a text of one with its unit, "0.35 g"
    whole,        ///< a whole number of `least` to `most`
    flag,         ///< true or false
    text,         ///< any text
    line,         ///< one line without control characters and marks of direction
    file,         ///< a text that names a file
    choice,       ///< one of `words`
    table,        ///< a table whose keys are those of `table`
    by_building,  ///< a table of lists of numbers by the names of buildings
    any           ///< whatever its reader takes
  };
  enum class Form { one, list, one_or_list, matrix };

  std::string_view name;
  Kind kind;
  PhysicalDimension dimension;
  Label label;
  std::string_view doc;  ///< one sentence, as it goes on after the values that the key takes; Markdown
  Range range = Range::finite;
  Form form = Form::one;
  std::string_view each = {};  ///< of a list: "one per storey"; empty: any number from one
  Need need = Need::required;
  std::string_view group = {};      ///< keys that exclude one another have the same
  std::string_view otherwise = {};  ///< what is without it, in words; with `by_default` none are needed
  std::optional<double> default_value = std::nullopt;  ///< 1 and 0 of a flag; of a choice the first word is it
  std::vector<std::string_view> words = {};            ///< also of a number: it may be one of them instead
  std::vector<std::string_view> word_docs = {};        ///< of each word what it means, where that is said apart
  std::vector<Label> word_labels = {};                 ///< of each word, empty where the word itself will do
  const KeyTable* table = nullptr;                     ///< also of a number: it may be such a table instead
  std::int64_t least = 0, most = 0;                    ///< of a whole number; of a list how many, 0: any number
  std::size_t count = 0;                               ///< of a list: how many, where that is always the same
  bool or_diagonal = false;                            ///< of a matrix: a list alone is its diagonal
  bool may_be_empty = false;                           ///< a list, or a line
  std::vector<Condition> conditions = {};              ///< all must hold
  std::string_view with = {};                          ///< the key it goes with
  std::string_view beside = {};                        ///< the one key of its group that may stand with it
  std::string_view own_unit = {};                      ///< "g", "MB": a number that the case's units say nothing of

  [[nodiscard]] static Key number(std::string_view name, PhysicalDimension dimension, Range range, Label label,
                                  std::string_view doc = {});
  [[nodiscard]] static Key quantity(std::string_view name, PhysicalDimension dimension, Label label,
                                    std::string_view doc = {});
  [[nodiscard]] static Key whole(std::string_view name, std::int64_t least, std::int64_t most, Label label,
                                 std::string_view doc = {});
  /// Of a kind without numbers, or with none of a dimension: flag, text, line, file, any.
  [[nodiscard]] static Key of(std::string_view name, Kind kind, Label label, std::string_view doc = {});
  [[nodiscard]] static Key choice(std::string_view name, std::vector<std::string_view> words, Label label,
                                  std::string_view doc = {});
  [[nodiscard]] static Key sub_table(std::string_view name, const KeyTable& table, Label label,
                                     std::string_view doc = {});
  [[nodiscard]] static Key by_building(std::string_view name, PhysicalDimension dimension, Range range, Label label,
                                       std::string_view doc = {});

  Key& list(std::string_view one_per = {}, std::size_t of_them = 0);  ///< a list
  Key& or_empty();
  Key& at_least(std::int64_t items);
  Key& up_to(std::int64_t items);
  Key& for_each(std::string_view one_per);                                   ///< one for all, or a list
  Key& matrix(std::string_view one_per = {}, bool or_its_diagonal = false);  ///< a list of lists
  Key& optional(std::string_view without = {});
  Key& by_default(double value);
  Key& one_of(std::string_view of_group, Need how = Need::one_of);  ///< or Need::optional: at most one
  Key& when(std::string_view key, std::vector<std::string_view> any_of);
  Key& goes_with(std::string_view key);
  Key& may_join(std::string_view key);
  Key& or_one_of(std::vector<std::string_view> known);
  Key& called(std::vector<Label> words_for_people);
  Key& or_table(const KeyTable& keys);
  Key& counted_in(std::string_view unit);

  [[nodiscard]] bool is_required() const { return need == Need::required; }
  /// A value of a choice as people call it.
  [[nodiscard]] Label label_of(std::string_view word) const;
  /// Whether it is for this word of another key, or says nothing of that one.
  [[nodiscard]] bool is_for(std::string_view key, std::string_view word) const;
};

/// The keys of one table of a file. A key may stand in it several times, for several words of another one.
struct KeyTable {
  std::string_view name;   ///< as its heading, "building.frame"
  std::string_view title;  ///< what it is of, a sentence
  std::vector<Key> keys;

  /// The key, the first where there are several; null where there is none.
  [[nodiscard]] const Key* find(std::string_view key) const;
  /// @throws std::out_of_range where there is none: a reader asks for what the schema has.
  [[nodiscard]] const Key& at(std::string_view key) const;
  /// Each once, in their order.
  [[nodiscard]] std::vector<std::string> names() const;
  /// Of a group, in their order.
  [[nodiscard]] std::vector<std::string> names_of(std::string_view group) const;
  /// Every word of `by` that this key is for; empty where it is for all.
  [[nodiscard]] std::vector<std::string_view> owners(std::string_view key, std::string_view by) const;
};

}  // namespace bentur
