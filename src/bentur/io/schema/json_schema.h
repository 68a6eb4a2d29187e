#pragma once

#include <string>

#include "bentur/core/key.h"

namespace bentur {

/// A JSON Schema (Draft 4, as far as Taplo's validator understands it) of a file with these keys: titles, descriptions,
/// types, ranges, words, which keys must be there and which exclude one another. Whatever takes several keys together
/// to see is beyond it. What documents, Python and the studio need besides stands under "x-bentur", for each key of a
/// name: `value` and `default` in words, `number` what a number at it may be, `label` in both languages, `dimension` as
/// UDUNITS forms are written ("F s2 L-1"), `unit` in words ("force·s²/length"), `need`, `group`, `when` it counts.
/// @param title of the whole
[[nodiscard]] std::string json_schema(const KeyTable& keys, const std::string& title);

/// What a key takes, in words: "number or list, > 0 [length], one per storey". Markdown.
[[nodiscard]] std::string value_text(const Key& key);

/// What is without it; empty where it must be there.
[[nodiscard]] std::string default_text(const Key& key);

}  // namespace bentur
