#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "bentur/contact/own_law.h"
#include "bentur/core/key.h"
#include "bentur/io/toml/parameter_path.h"
#include "bentur/io/toml/toml_view.h"

namespace bentur {

/// A table of a file with what the schema says of its keys: types, ranges, whether a key must be there and what is
/// without it come from there. Readers ask by the name of a key; asking for one that the schema does not have throws.
class TableView : public TomlView {
 public:
  /// Keys are known already: another view has looked at them.
  TableView(const TomlView& view, const KeyTable& keys) : TomlView(view), keys_(&keys) {}

  /// Nothing (and an error) unless it is a table; an error for each key that `keys` does not have or
  /// has for other words of a choice than the one made.
  [[nodiscard]] static std::optional<TableView> of(const TomlView& view, const KeyTable& keys);

  [[nodiscard]] const KeyTable& keys() const { return *keys_; }
  /// What the schema says of a key here: of several of this name the one whose conditions hold.
  [[nodiscard]] const Key& key(std::string_view name) const;

  // The value of a key, read as the schema has it; an error where it must be there and is not. Nothing where it is
  // missing or wrong, unless something else is said.
  [[nodiscard]] std::optional<TomlView> get(std::string_view name) const;
  /// The default where it is missing and has one. So is it with flags.
  [[nodiscard]] std::optional<double> number(std::string_view name) const;
  [[nodiscard]] bool flag(std::string_view name) const;
  /// A list, or one number where that may stand for all. @param count how many of a list; 0: any number from one
  [[nodiscard]] std::vector<double> numbers(std::string_view name, std::size_t count = 0) const;
  /// The same, and one number said `count` times.
  [[nodiscard]] std::vector<double> numbers_for_each(std::string_view name, std::size_t count) const;
  [[nodiscard]] std::optional<std::int64_t> whole(std::string_view name) const;
  [[nodiscard]] std::optional<std::string> text(std::string_view name) const;
  [[nodiscard]] std::optional<std::string> word(std::string_view name) const;
  [[nodiscard]] std::optional<TableView> table(std::string_view name) const;
  /// The law that a word names, of those listed, or one that the caller has brought along: then it goes to `own`. Null
  /// (and an error) where the word names none, or that law cannot stand here.
  template <class Made>
  [[nodiscard]] const LawEntryOf<Made>* law(std::string_view name, const std::vector<LawEntryOf<Made>>& laws,
                                            std::shared_ptr<const LawEntryOf<Made>> OwnLaw::*place,
                                            std::shared_ptr<const LawEntryOf<Made>>& own) const {
    const auto given = find(std::string(name));
    if (given && given->value().law) {
      own = (*given->value().law).*place;
      if (!own) given->error_value("is a law of contacts alone: here it must be made of branches");
      return own.get();
    }
    const auto known = word(name);
    return known ? find_entry(laws, *known) : nullptr;
  }

  /// Of the keys of a group the one given; an error where there are more, or none and one is needed.
  [[nodiscard]] std::optional<std::string> exactly_one(std::string_view group) const;

 private:
  [[nodiscard]] Length length(const Key& key, std::size_t count) const { return {count, std::string(key.each)}; }

  const KeyTable* keys_;
};

/// The first condition of a key that its table does not fulfil; null where the key counts there. Where a table says
/// nothing of a choice its first word holds.
[[nodiscard]] const Condition* broken_condition(const Key& key, const KeyTable& keys, const TomlValue& table);

/// What the schema says of a key of this name in this table: of several the one whose conditions hold, else the one
/// of which most hold; null where there is none.
[[nodiscard]] const Key* key_of(const KeyTable& keys, std::string_view name, const TomlValue& table);

/// An error at every value of a table and below that is not what its key takes and of which nothing has been said yet:
/// it is right then also where nobody asks for it.
void check_values(const TomlView& table, const KeyTable& keys);

/// The key that a path leads to, and so what its numbers are; null where the schema has none.
/// @param file the whole file: which key counts depends on what stands beside it
[[nodiscard]] const Key* key_at(const KeyTable& keys, const ParameterPath& path, const TomlValue& file);
/// Of the first key on a path that its table of the schema does not have the one that may have been meant, empty where
/// none is like it. Nothing where all are known.
[[nodiscard]] std::optional<std::string> near_unknown_key(const KeyTable& keys, const ParameterPath& path,
                                                          const TomlValue& file);

}  // namespace bentur
