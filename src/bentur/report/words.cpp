#include "bentur/report/words.h"

#include <fmt/args.h>
#include <fmt/format.h>

#include <algorithm>
#include <mutex>

#include "bentur/core/diagnostics.h"
#include "bentur/core/errors.h"
#include "bentur/io/toml/toml_value.h"
#include "bentur/report/html/internal/assets.h"

namespace bentur {
namespace {

/// A value of a text: {name} is the value, {name:has|have} the first of the two where it is 1, else the second.
struct FilledValue {
  std::string_view text;
};

}  // namespace
}  // namespace bentur

template <>
struct fmt::formatter<bentur::FilledValue> {
  constexpr auto parse(fmt::format_parse_context& context) {
    const auto* const end = std::find(context.begin(), context.end(), '}');
    words_ = {context.begin(), static_cast<std::size_t>(end - context.begin())};
    if (!words_.empty() && words_.find('|') == words_.npos) throw fmt::format_error("has no | between one and many");
    return end;
  }
  auto format(const bentur::FilledValue& value, fmt::format_context& context) const {
    const std::size_t bar = words_.find('|');
    const std::string_view shown = words_.empty()      ? value.text
                                   : value.text == "1" ? words_.substr(0, bar)
                                                       : words_.substr(bar + 1);
    return std::copy(shown.begin(), shown.end(), context.out());
  }

 private:
  std::string_view words_;
};

namespace bentur {
namespace {

/// The file: what stands before the first [key], and what stands under each.
struct Sections {
  std::string_view head;
  std::map<std::string_view, std::string_view> of_key;
};

const Sections& sections() {
  static const Sections all = [] {
    Sections read;
    const std::string_view file = html::asset("texts.toml");
    const std::string_view begins = "\n[";
    std::size_t header = file.find(begins);
    read.head = file.substr(0, header);
    while (header != std::string_view::npos) {
      const std::size_t name = header + begins.size();
      const std::size_t end = file.find(']', name);
      header = file.find(begins, end);
      read.of_key[file.substr(name, end - name)] = file.substr(end + 1, header - end - 1);
    }
    return read;
  }();
  return all;
}

TomlValue parsed(std::string_view text) {
  Diagnostics diagnostics;
  return parse_toml(std::string(text), "texts.toml", diagnostics).value();
}

}  // namespace

const std::vector<std::string>& report_languages() {
  static const std::vector<std::string> all = [] {
    std::vector<std::string> read;
    const TomlValue head = parsed(sections().head);
    for (const TomlValue& tag : head.find("languages")->items) read.push_back(tag.text);
    return read;
  }();
  return all;
}

const Texts* catalogue_entry(std::string_view key) {
  static std::mutex mutex;
  static std::map<std::string_view, Texts> known;
  const auto section = sections().of_key.find(key);
  if (section == sections().of_key.end()) return nullptr;
  const std::lock_guard lock(mutex);
  const auto [texts, is_new] = known.try_emplace(section->first);
  if (is_new) {
    const TomlValue read = parsed(section->second);
    for (const TomlMember& member : read.members) texts->second[member.key] = member.value.text;
  }
  return &texts->second;
}

std::vector<std::string> text_keys(std::string_view prefix) {
  std::vector<std::string> keys;
  for (const auto& [key, unused] : sections().of_key) {
    if (key.starts_with(prefix)) keys.emplace_back(key);
  }
  return keys;
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

bool Words::has(std::string_view key) const { return catalogue_entry(key) != nullptr; }

std::string Words::operator()(std::string_view key) const {
  const Texts* const found = catalogue_entry(key);
  if (found == nullptr) throw InvalidParameter("key", std::string(key), "is not in the catalogue");
  return found->at(language_);
}

std::string Words::operator()(std::string_view key,
                              std::initializer_list<std::pair<const char*, std::string>> values) const {
  return (*this)(key, std::vector<std::pair<std::string, std::string>>(values.begin(), values.end()));
}

std::string Words::operator()(std::string_view key,
                              const std::vector<std::pair<std::string, std::string>>& values) const {
  fmt::dynamic_format_arg_store<fmt::format_context> named;
  for (const auto& [name, value] : values) named.push_back(fmt::arg(name.c_str(), FilledValue{value}));
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

std::string caption_key(const std::string& kind, bool in_plan) {
  return (in_plan && kind == "overview" ? "plan." : "figure.") + kind;
}

std::string figure_title(const std::string& language, const std::string& key, std::string english) {
  const Words say(language);
  if (language == "en" || !say.has(key)) return english;
  const std::string text = say(key);
  return text.substr(0, text.find(". "));
}

FigureWords figure_words(const std::string& language) {
  using ByEnglish = std::map<std::string, std::string, std::less<>>;
  static const std::map<std::string, ByEnglish> all = [] {
    std::map<std::string, ByEnglish> made;
    for (const std::string& key : text_keys("figure.text.")) {
      const Texts& texts = *catalogue_entry(key);
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
