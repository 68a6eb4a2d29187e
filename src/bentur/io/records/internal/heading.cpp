#include "bentur/io/records/internal/heading.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "bentur/core/number_text.h"
#include "bentur/core/units.h"

namespace bentur::records {
namespace {

constexpr double longest_step = 10;         // [s]
constexpr double peak_tolerance = 0.05;     // [-]
constexpr double rounding = 0.51;           // of a last digit
constexpr std::size_t words_to_a_unit = 8;  // "UNITS OF UNCOR ACCEL ARE SEC AND G/10"

bool is_number_start(std::string_view text, std::size_t at) {
  const auto digit = [&](std::size_t i) { return i < text.size() && text[i] >= '0' && text[i] <= '9'; };
  if (at < text.size() && (text[at] == '+' || text[at] == '-')) ++at;
  return digit(at) || (at < text.size() && (text[at] == '.' || text[at] == ',') && digit(at + 1));
}

/// Reads what stands behind the words of a heading.
class HeadingScan {
 public:
  HeadingScan(std::string_view text, std::size_t at) : text_(text), at_(at) {}

  [[nodiscard]] std::string_view rest() const { return text_.substr(at_); }
  [[nodiscard]] bool done() const { return at_ >= text_.size(); }
  [[nodiscard]] bool at_number() const { return is_number_start(text_, at_); }
  void skip(std::string_view characters) { at_ = std::min(text_.find_first_not_of(characters, at_), text_.size()); }

  bool take(char c) {
    const bool there = at_ < text_.size() && text_[at_] == c;
    at_ += there ? 1 : 0;
    return there;
  }

  /// "(SEC)" without its brackets; empty where none begins here.
  std::string_view group() {
    if (done() || (text_[at_] != '(' && text_[at_] != '[')) return {};
    const char open = text_[at_], close = open == '(' ? ')' : ']';
    std::size_t end = at_, depth = 0;
    do {
      depth += text_[end] == open ? 1 : 0;
      depth -= text_[end] == close ? 1 : 0;
    } while (depth > 0 && ++end < text_.size());
    if (end == text_.size()) return {};
    const std::string_view inside = trimmed(text_.substr(at_ + 1, end - at_ - 1));
    at_ = end + 1;
    return inside;
  }

  /// Up to a blank or one of ",;:=()[]".
  std::string_view word() {
    const std::size_t end = std::min(text_.find_first_of(" \t,;:=()[]\"", at_), text_.size());
    const std::string_view found = text_.substr(at_, end - at_);
    at_ = end;
    return found;
  }

  std::optional<double> number(bool counts, Statement& said) {
    std::size_t size = 0;
    const auto value = heading_number(rest(), counts, size);
    if (!value) return value;
    said.column = static_cast<int>(at_) + 1;
    const std::string_view digits = rest().substr(0, size);
    const std::size_t mark = digits.find_first_of("eEdD");
    const std::size_t point = digits.find_first_of(".,");
    const std::size_t end = std::min(mark, digits.size());
    const double decimals = point < end ? static_cast<double>(end - point - 1) : 0;
    const double power = mark < digits.size() ? number_of(digits.substr(mark + 1)).value_or(0) : 0;
    said.resolution = std::pow(10, power - decimals);
    at_ += size;
    return value;
  }

 private:
  std::string_view text_;
  std::size_t at_;
};

/// What a phrase is of the heading, and where its value is.
struct Spoken {
  std::string_view unit, label;  // in brackets before the value
  std::vector<Statement> values;
  std::string_view after;  // the word behind the last value
};

bool is_unit(std::string_view word) { return seconds_of(word) || is_rate_unit(word) || unit_at(word); }

bool is_link(std::string_view word) {
  static constexpr std::string_view links[] = {"IS",     "ARE", "OF", "AT", "IN", "VALUE",
                                               "VALUES", "ES",  "DE", "EN", "SON"};
  return std::find(std::begin(links), std::end(links), word) != std::end(links);
}

/// "C1-C6", which a Mexican heading has behind its words.
bool is_range_of_channels(std::string_view word) { return word.size() >= 4 && word[0] == 'C' && word.find("-C") < 4; }

/// What stands behind words: " (SEC) : 0.01", "= .005 SEC", ", C1-C6 (S) : /0.005/0.005", " (GAL) : (N-S) 1.2 (E-W) 3".
Spoken spoken_behind(std::string_view text, std::size_t at, bool counts) {
  HeadingScan scan(text, at);
  Spoken found;
  if (scan.take('_')) found.unit = scan.word();
  while (!scan.done() && !scan.at_number()) {
    scan.skip(" \t:=,;");
    if (!scan.at_number() && scan.take('.')) continue;  // of an abbreviation
    if (const std::string_view group = scan.group(); !group.empty()) {
      (is_unit(group) ? found.unit : found.label) = group;
      continue;
    }
    if (scan.at_number() || scan.done()) break;
    if (scan.take('/')) {
      scan.skip(" \t");
      break;
    }
    const std::string_view word = scan.word();
    if (!is_link(word) && !is_range_of_channels(word)) return found;
  }
  while (scan.at_number()) {
    Statement said;
    const auto value = scan.number(counts, said);
    if (!value) break;
    said.value = *value;
    said.text = found.label;
    said.place = found.values.size();
    found.values.push_back(said);
    scan.skip(" \t");
    if (scan.take('/')) {
      scan.skip(" \t");
      continue;
    }
    HeadingScan behind = scan;
    const std::string_view group = behind.group();  // "(N-S) 13.2 (E-W) 12.1"
    behind.skip(" \t");
    if (group.empty() || !behind.at_number()) break;
    found.label = group;
    scan = behind;
  }
  found.after = scan.rest();
  for (Statement& said : found.values) said.of = found.values.size();
  return found;
}

/// The number that ends right before `at`, as in "4000 POINTS".
std::optional<Statement> spoken_before(std::string_view text, std::size_t at, bool counts) {
  const std::size_t last = text.substr(0, at).find_last_not_of(" \t");
  if (last == std::string_view::npos) return std::nullopt;
  const std::size_t blank = text.substr(0, last + 1).find_last_of(" \t:=;(");
  HeadingScan scan(text.substr(0, last + 1), blank == std::string_view::npos ? 0 : blank + 1);
  Statement said;
  const auto value = scan.at_number() ? scan.number(counts, said) : std::nullopt;
  if (!value || !scan.done()) return std::nullopt;
  said.value = *value;
  return said;
}

std::string_view first_word(std::string_view text) {
  HeadingScan scan(text, 0);
  scan.skip(" \t");
  return scan.word();
}

/// Steps from steps or from rates, by the unit before or behind them.
void say_steps(const HeadingPhrase& phrase, const Spoken& spoken, int line, std::vector<Statement>& steps) {
  const std::string_view word = first_word(spoken.after);
  std::string_view unit = spoken.unit;
  if (!seconds_of(unit) && !is_rate_unit(unit)) unit = word;
  if (!seconds_of(unit) && !is_rate_unit(unit) && phrase.number_before) unit = phrase.fact == Fact::rate ? "HZ" : "S";
  for (Statement said : spoken.values) {
    const auto seconds = seconds_of(unit);
    if (phrase.needs_unit && !(phrase.fact == Fact::rate ? is_rate_unit(unit) : seconds.has_value())) continue;
    const bool by_rate = is_rate_unit(unit) || (phrase.fact == Fact::rate && !seconds && said.value >= 1);
    said.vague = !seconds && !by_rate && said.value >= 1;
    said.value = by_rate ? 1 / said.value : said.value * seconds.value_or(1);
    said.line = line;
    if (said.value > 0 && (said.value <= longest_step || said.vague)) steps.push_back(said);
  }
}

void say_peaks(const HeadingPhrase& phrase, const Spoken& spoken, int line, std::vector<Statement>& peaks) {
  auto unit = unit_at(spoken.unit);
  if (!unit) unit = unit_at(spoken.after);
  if (phrase.needs_unit && !unit) return;
  for (Statement said : spoken.values) {
    said.value = std::abs(said.value);
    said.line = line;
    if (unit) {
      said.unit = unit->unit;
      said.factor = unit->factor;
    }
    if (said.value > 0 && std::isfinite(said.value)) peaks.push_back(said);
  }
}

void say_unit(const FileUnit& unit, int line, std::size_t at, std::vector<Statement>& units) {
  units.push_back({.unit = unit.unit, .factor = unit.factor, .line = line, .column = static_cast<int>(at) + 1});
}

/// Behind "UNITS": the first of the next words that is one of accelerations; without one, what is a unit of other
/// things, where it stands at once.
void say_units(std::string_view text, std::size_t at, int line, Heading& heading) {
  HeadingScan scan(text, at);
  std::string_view first, before;
  for (std::size_t i = 0; i < words_to_a_unit && !scan.done(); ++i) {
    scan.skip(" \t:=,_()[]\"");
    const std::size_t place = text.size() - scan.rest().size();
    const auto unit = unit_at(scan.rest());
    const std::string_view word = scan.word();
    // The letter g is also one of names: "Unit 5, block G".
    const std::size_t last = text.find_last_not_of(" \t", place - 1);
    const bool marked = std::string_view(":=([").find(text[last]) != std::string_view::npos;
    const bool meant =
        word != "G" || marked || before.empty() || before == "AND" || is_link(before) || before.starts_with("ACC");
    if (unit && meant) return say_unit(*unit, line, place, heading.units);
    if (word.empty()) break;
    if (first.empty() && !is_link(word)) first = word;
    before = word;
  }
  if (!is_other_unit(first) || first.size() < 3) return;
  heading.other_units.push_back(
      {.text = std::string(first), .line = line, .column = static_cast<int>(first.data() - text.data()) + 1});
}

/// Behind "ACCELERATION": "(CM/S2)", "_G", ", G", or "... IN [UNITS OF] CM/S/S".
void say_acceleration(std::string_view text, std::size_t at, int line, std::vector<Statement>& units) {
  HeadingScan scan(text, at);
  const auto take = [&](std::string_view candidate) {
    const auto unit = unit_at(candidate);
    if (unit) say_unit(*unit, line, static_cast<std::size_t>(candidate.data() - text.data()), units);
    return unit.has_value();
  };
  if (scan.take('_') || scan.take(',')) {
    if (take(scan.rest())) return;
  }
  for (std::size_t i = 0; i < words_to_a_unit && !scan.done(); ++i) {
    scan.skip(" \t:=,.");
    if (const std::string_view group = scan.group(); !group.empty()) {
      if (take(group)) return;
      continue;
    }
    const std::string_view word = scan.word();
    if (word == "UNITS" || word.empty()) return;
    if (word != "IN" && word != "EN") continue;
    scan.skip(" \t");
    if (take(scan.rest())) return;
  }
}

/// A line that is a unit and nothing else, "# Gal", "[cm/s2]", "gal (cm/s/s)".
void say_lone_unit(std::string_view text, int line, std::vector<Statement>& units) {
  constexpr std::string_view marks = " \t#%*()[]\"";
  text.remove_prefix(std::min(text.find_first_not_of(marks), text.size()));
  const std::size_t last = text.find_last_not_of(marks);
  if (last == std::string_view::npos) return;
  const std::string_view whole = text.substr(0, last + 1);
  const std::size_t open = whole.find_first_of("([");
  auto unit = file_unit(whole.substr(0, open));
  if (open != std::string_view::npos && !file_unit(whole.substr(open + 1))) unit.reset();
  if (unit) say_unit(*unit, line, 0, units);
}

/// "El Centro NS gal dt 0.01": a unit but for the letter g, which is not that of a number before it.
void say_mentions(std::string_view text, int line, std::vector<Statement>& mentions) {
  std::vector<Statement> found;
  bool number_before = false;
  for (HeadingScan scan(text, 0); !scan.done();) {
    scan.skip(" \t,;:=()[]\"");
    const std::string_view word = scan.word();
    if (word == "G") return;  // "from gal to g"
    const auto unit = file_unit(word);
    if (unit && unit->unit != "g" && !number_before) say_unit(*unit, line, 0, found);
    number_before = !word.empty() && is_number_start(word, 0);
  }
  mentions.insert(mentions.end(), found.begin(), found.end());
}

/// The numbers that words are about: before them, behind them, or in the line below where theirs ends with them.
Spoken spoken_of(const HeadingPhrase& phrase, std::string_view text, const std::string& below) {
  const bool counts = phrase.fact == Fact::count;
  if (phrase.number_before) {
    if (const auto before = spoken_before(text, phrase.begin, counts)) return {{}, {}, {*before}, {}};
  }
  Spoken spoken = spoken_behind(text, phrase.end, counts);
  const bool ends = trimmed(text.substr(phrase.end)).find_first_of(":=,") == std::string_view::npos;
  if (spoken.values.empty() && ends && !below.empty()) spoken.values = spoken_behind(below, 0, counts).values;
  // "filter points: 4"
  constexpr double least = 10;
  if (counts && phrase.number_before && !spoken.values.empty() && spoken.values[0].value < least) spoken.values.clear();
  return spoken;
}

void say_counts(const Spoken& spoken, int line, std::vector<Statement>& counts) {
  for (Statement said : spoken.values) {
    said.line = line;
    if (is_count(said.value) && said.value >= 2) counts.push_back(said);
  }
}

/// As the file spells it, where no letter has lost its accent.
void say_component(const Line& line, std::string_view text, std::size_t at, std::vector<Statement>& components) {
  HeadingScan scan(text, at);
  scan.skip(" \t.:=");
  std::string_view word = scan.word();
  if (text.size() == line.text.size()) {
    word = line.text.substr(static_cast<std::size_t>(word.data() - text.data()), word.size());
  }
  if (!word.empty()) components.push_back({.text = std::string(word), .line = line.number});
}

/// One line. @param below the number that is the next line, for words without one
void say_line(const Line& line, const std::string& below, Heading& heading) {
  const std::string text = folded(line.text);
  say_lone_unit(text, line.number, heading.units);
  const std::vector<HeadingPhrase> phrases = phrases_of(text);
  const bool of_amounts = std::any_of(phrases.begin(), phrases.end(), [](const HeadingPhrase& one) {
    return one.fact != Fact::step && one.fact != Fact::rate && one.fact != Fact::count && one.fact != Fact::component;
  });
  if (!of_amounts) say_mentions(text, line.number, heading.mentions);
  for (const HeadingPhrase& phrase : phrases) {
    const auto spoken = [&] { return spoken_of(phrase, text, below); };
    switch (phrase.fact) {
      case Fact::count:
        say_counts(spoken(), line.number, heading.counts);
        if (phrase.number_before && is_link(first_word(std::string_view(text).substr(phrase.end)))) {
          say_acceleration(text, phrase.end, line.number, heading.units);  // "4000 VALUES IN GAL"
        }
        break;
      case Fact::step:
      case Fact::rate:
        say_steps(phrase, spoken(), line.number, heading.steps);
        break;
      case Fact::peak:
        say_peaks(phrase, spoken(), line.number, heading.peaks);
        break;
      case Fact::unit:
        say_units(text, phrase.end, line.number, heading);
        break;
      case Fact::acceleration:
        say_acceleration(text, phrase.end, line.number, heading.units);
        break;
      case Fact::component:
        say_component(line, text, phrase.end, heading.components);
        break;
      default:
        break;
    }
  }
}

}  // namespace

std::optional<double> heading_number(std::string_view text, bool counts, std::size_t& size) {
  const auto digits = [&](std::size_t at) {
    std::size_t end = at;
    while (end < text.size() && text[end] >= '0' && text[end] <= '9') ++end;
    return end - at;
  };
  const auto is = [&](std::size_t at, std::string_view any) {
    return at < text.size() && any.find(text[at]) != std::string_view::npos;
  };
  size = 0;
  std::string plain;
  std::size_t at = is(0, "+-") ? 1 : 0;
  plain.append(text.substr(0, at));
  const std::size_t whole = digits(at);
  plain.append(text.substr(at, whole));
  at += whole;
  if (counts) {  // "12,000"
    while (whole > 0 && is(at, ",") && digits(at + 1) == 3 && !is(at + 4, ".")) {
      plain.append(text.substr(at + 1, 3));
      at += 4;
    }
  }
  std::size_t fraction = 0;
  if (is(at, ".") || (!counts && is(at, ",") && digits(at + 1) > 0 && !is(at + 1 + digits(at + 1), "."))) {
    fraction = digits(at + 1);
    plain += '.';
    plain.append(text.substr(at + 1, fraction));
    at += 1 + fraction;
  }
  if (whole + fraction == 0) return std::nullopt;
  if (is(at, "eEdD")) {
    const std::size_t sign = is(at + 1, "+-") ? 1 : 0;
    if (const std::size_t power = digits(at + 1 + sign); power > 0) {
      plain += 'E';
      plain.append(text.substr(at + 1, sign + power));
      at += 1 + sign + power;
    }
  }
  const auto value = number_of(plain);
  if (value) size = at;
  return value;
}

std::optional<FileUnit> unit_at(std::string_view text) {
  text.remove_prefix(std::min(text.find_first_not_of(" \t"), text.size()));
  text = text.substr(0, text.find_first_of(",;:()[]\"="));
  std::vector<std::size_t> ends;  // of the first three words
  for (std::size_t at = 0; at < text.size() && ends.size() < 3;) {
    const std::size_t end = std::min(text.find_first_of(" \t", at), text.size());
    ends.push_back(end);
    at = std::min(text.find_first_not_of(" \t", end), text.size());
  }
  for (std::size_t i = ends.size(); i-- > 0;) {
    if (auto unit = file_unit(text.substr(0, ends[i]))) return unit;
  }
  return std::nullopt;
}

Heading read_heading(std::span<const Line> lines) {
  Heading heading;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    std::string below;
    if (i + 1 < lines.size()) {
      std::string_view text = lines[i + 1].text;
      text.remove_prefix(std::min(text.find_first_not_of(" \t#%"), text.size()));
      std::size_t size = 0;
      if (heading_number(text, false, size) && trimmed(text).size() == size) below = trimmed(text);
    }
    say_line(lines[i], below, heading);
  }
  return heading;
}

void check_peak(const Heading& heading, const std::vector<double>& values, const std::string& unit,
                ChannelPlace channel, const std::string& hint, RecordErrors& errors) {
  double read = 0;
  for (const double value : values) read = std::max(read, std::abs(value));
  const Units metres{.length = "m", .force = "N", .gravity = standard_gravity("m")};
  const auto in_metres = [&](const std::string& of, double value) { return value * acceleration_factor(of, metres); };
  const auto fits = [&](const Statement& said) {
    const auto near = [&](double stated, double resolution, double found) {
      return std::abs(found - stated) <= std::max(peak_tolerance * stated, rounding * resolution);
    };
    const double stated = said.value * said.factor, resolution = said.resolution * said.factor;
    const auto fits_in = [&](const std::string& stated_unit, const std::string& read_unit) {
      return near(in_metres(stated_unit, stated), in_metres(stated_unit, resolution), in_metres(read_unit, read));
    };
    const std::vector<std::string>& all = acceleration_units();
    const auto any = [&](const auto& fit) { return std::any_of(all.begin(), all.end(), fit); };
    if (!unit.empty() && !said.unit.empty()) return fits_in(said.unit, unit);
    if (!unit.empty()) return any([&](const std::string& one) { return fits_in(one, unit); });
    if (!said.unit.empty()) return any([&](const std::string& one) { return fits_in(said.unit, one); });
    return any(
        [&](const std::string& one) { return any([&](const std::string& other) { return fits_in(one, other); }); });
  };
  const Statement* first = nullptr;
  for (const Statement& said : heading.peaks) {
    if (channel.of > 1 && said.of == channel.of && said.place != channel.place) continue;
    if (fits(said)) return;
    if (first == nullptr) first = &said;
  }
  if (first == nullptr) return;
  const auto with_unit = [](double value, const std::string& of) {
    return fmt::format("{:.6g}{}", value, of.empty() ? "" : " " + of);
  };
  errors.error(first->line, first->column,
               fmt::format("says a peak of {}, but that of the values is {}{}",
                           with_unit(first->value * first->factor, first->unit), with_unit(read, unit), hint));
}

}  // namespace bentur::records
