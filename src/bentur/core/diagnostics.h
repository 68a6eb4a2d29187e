#pragma once

#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace bentur {

/// Where in a user's file something stands. Line and column count from 1; 0 means "the file as a whole".
struct SourcePosition {
  std::string file;
  int line = 0;
  int column = 0;
  int origin = 0;  ///< 0: the file; else what stands there was put in by whoever gave this number, to know it by
};

/// What an English sentence is in another language.
using Wording = std::function<std::string(const std::string&)>;
[[nodiscard]] inline std::string as_it_is(const std::string& english) { return english; }

/// One finding about a user's input.
struct Diagnostic {
  SourcePosition position = {};
  std::string key = {};    ///< the way to it, `gap[0].contact.restitution`; empty: of the file as a whole
  std::string value = {};  ///< as a message shows it, `1.4`, `"hertzz"`, `a list`; empty: what is wrong is no value
  std::string rule = {};   ///< "must be in (0, 1]", or a sentence whose subject is the key
  std::string suggestion = {};  ///< the word that may have been meant; empty: none is near
  bool unknown_key = false;     ///< there is no such key

  /// As the user reads it: "gap[0].contact.restitution = 1.4, must be in (0, 1]". A word that may have been meant is
  /// shown in place of the rule on values. @param say is given its sentences, the rule among them, one by one
  [[nodiscard]] std::string message(const Wording& say = as_it_is) const;
  /// "case.toml:14:9: error: MESSAGE"; line and column are left out where they are 0.
  [[nodiscard]] std::string text(const Wording& say = as_it_is) const;
};

/// Collects every error of one input, so that the user sees all of them in one run.
class Diagnostics {
 public:
  void add(Diagnostic one) { errors_.push_back(std::move(one)); }
  /// All that `other` has found.
  void add(const Diagnostics& other);
  /// Of no key.
  Diagnostic& error(SourcePosition position, std::string message);

  [[nodiscard]] bool ok() const noexcept { return errors_.empty(); }
  /// Sorted by file, line, origin, column; what stands at the same place keeps the order it was found in.
  [[nodiscard]] std::vector<Diagnostic> errors() const;

 private:
  std::vector<Diagnostic> errors_;
};

/// The entry of `known` nearest to `word` by edit distance (a swap of neighbours counts one), the first among equals,
/// or an empty string where none is near enough to be meant (more than a third of the word's letters differ).
[[nodiscard]] std::string nearest(const std::string& word, const std::vector<std::string>& known);

}  // namespace bentur
