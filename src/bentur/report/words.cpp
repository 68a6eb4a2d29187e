#include "bentur/report/words.h"

#include <fmt/args.h>
#include <fmt/format.h>

#include <algorithm>

#include "bentur/core/errors.h"
#include "bentur/io/toml/parameter_path.h"
#include "bentur/report/html/internal/assets.h"

namespace bentur {
namespace {

/// A table holds the text of one key in each language, tables of longer keys, or both.
void collect(const TomlValue& table, const std::string& key, Catalogue& into) {
  for (const TomlMember& member : table.members) {
    if (member.value.kind == TomlValue::Kind::text) into.texts[key][member.key] = member.value.text;
    collect(member.value, key.empty() ? member.key : key + "." + member.key, into);
  }
}

}  // namespace

const std::vector<std::string>& report_languages() { return catalogue().languages; }

const Catalogue& catalogue() {
  static const Catalogue all = [] {
    Diagnostics diagnostics;
    const TomlValue file = parse_toml(std::string(html::asset("texts.toml")), "texts.toml", diagnostics).value();
    Catalogue read;
    collect(file, "", read);
    for (const TomlValue& tag : find_value(file, {"languages"})->items) read.languages.push_back(tag.text);
    return read;
  }();
  return all;
}

Words::Words(std::string_view language) : language_(language) {
  const std::vector<std::string>& known = report_languages();
  if (std::find(known.begin(), known.end(), language) == known.end()) {
    throw InvalidParameter("lang", language_, fmt::format("must be {}", fmt::join(known, " or ")));
  }
}

std::size_t Words::number() const {
  const std::vector<std::string>& all = report_languages();
  return static_cast<std::size_t>(std::find(all.begin(), all.end(), language_) - all.begin());
}

bool Words::has(std::string_view key) const { return catalogue().texts.find(key) != catalogue().texts.end(); }

std::string Words::operator()(std::string_view key) const {
  const auto& texts = catalogue().texts;
  const auto found = texts.find(key);
  if (found == texts.end()) throw InvalidParameter("key", std::string(key), "is not in the catalogue");
  return found->second.at(language_);
}

std::string Words::operator()(std::string_view key,
                              std::initializer_list<std::pair<const char*, std::string>> values) const {
  return (*this)(key, std::vector<std::pair<std::string, std::string>>(values.begin(), values.end()));
}

std::string Words::operator()(std::string_view key,
                              const std::vector<std::pair<std::string, std::string>>& values) const {
  fmt::dynamic_format_arg_store<fmt::format_context> named;
  for (const auto& [name, value] : values) named.push_back(fmt::arg(name.c_str(), value));
  const std::string text = (*this)(key);
  try {
    return fmt::vformat(text, named);
  } catch (const fmt::format_error& error) {
    throw InvalidParameter(std::string(key), text, error.what());
  }
}

std::string Words::count(std::string_view key, long n) const {
  return (*this)(std::string(key) + (n == 1 ? ".one" : ".many"), {{"n", std::to_string(n)}});
}

FigureWords figure_words(const std::string& language) {
  using Texts = std::map<std::string, std::string, std::less<>>;
  static const std::map<std::string, Texts> all = [] {
    std::map<std::string, Texts> made;
    for (const auto& [key, texts] : catalogue().texts) {
      if (!key.starts_with("figure.text.")) continue;
      for (const auto& [tag, text] : texts) made[tag].emplace(texts.at("en"), text);
    }
    return made;
  }();
  return [&texts = all.at(language)](std::string_view english) {
    const auto found = texts.find(english);
    return found == texts.end() ? std::string(english) : found->second;
  };
}

}  // namespace bentur
