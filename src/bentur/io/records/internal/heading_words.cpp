#include "bentur/io/records/internal/heading_words.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <map>

namespace bentur::records {
namespace {

struct TableWord {
  Fact fact;
  std::string_view words;      ///< folded, one blank between two
  bool number_before = false;  ///< also behind the number
  bool needs_unit = false;
};

// English, Spanish, Turkish, Japanese, Indonesian. A blank stands for any of " \t._:-" in a heading.
constexpr TableWord heading_table[] = {
    {Fact::step, "SAMPLING INTERVAL"},
    {Fact::step, "SAMPLE INTERVAL"},
    {Fact::step, "SAMPLING PERIOD"},
    {Fact::step, "SAMPLING STEP"},
    {Fact::step, "TIME STEP"},
    {Fact::step, "TIMESTEP"},
    {Fact::step, "TIME INCREMENT"},
    {Fact::step, "TIME INTERVAL"},
    {Fact::step, "DELTA T"},
    {Fact::step, "DELTAT"},
    {Fact::step, "DT"},
    {Fact::step, "INTERVALS OF"},
    {Fact::step, "EQUAL SPACING OF"},
    {Fact::step, "EQUALLY SPACED AT"},
    {Fact::step, "SEC INTERVALS", true},
    {Fact::step, "SECOND INTERVALS", true},
    {Fact::step, "S INTERVALS", true},
    {Fact::step, "SPACING", false, true},
    {Fact::step, "STEP", false, true},
    {Fact::step, "EVERY", false, true},
    {Fact::step, "INTERVALO DE MUESTREO"},
    {Fact::step, "INTERVALO DE TIEMPO"},
    {Fact::step, "INCREMENTO DE TIEMPO"},
    {Fact::step, "PASO DE TIEMPO"},
    {Fact::step, "PERIODO DE MUESTREO"},
    {Fact::step, "PASO", false, true},
    {Fact::step, "CADA", false, true},
    {Fact::step, "ORNEKLEME ARALIGI"},
    {Fact::step, "ORNEKLEME PERIYODU"},
    {Fact::step, "ZAMAN ARALIGI"},
    {Fact::step, "ZAMAN ADIMI"},
    {Fact::step, "サンプリング間隔"},
    {Fact::step, "サンプリング周期"},
    {Fact::step, "時間間隔"},
    {Fact::step, "時間刻み"},
    {Fact::step, "LANGKAH WAKTU"},
    {Fact::step, "INTERVAL WAKTU"},
    {Fact::rate, "SAMPLING FREQ"},
    {Fact::rate, "SAMPLING FREQUENCY"},
    {Fact::rate, "SAMPLINGFREQUENCY"},
    {Fact::rate, "SAMPLING RATE"},
    {Fact::rate, "SAMPLE RATE"},
    {Fact::rate, "SAMPLERATE"},
    {Fact::rate, "SAMPLINGRATE"},
    {Fact::rate, "SAMPLES PER SECOND", true},
    {Fact::rate, "SAMPLES/SEC", true},
    {Fact::rate, "SAMPLES/S", true},
    {Fact::rate, "PTS/SEC", true},
    {Fact::rate, "SPS", true},
    {Fact::rate, "FS", false, true},
    {Fact::rate, "FRECUENCIA DE MUESTREO"},
    {Fact::rate, "VELOCIDAD DE MUESTREO"},
    {Fact::rate, "VEL DE MUESTREO"},
    {Fact::rate, "TASA DE MUESTREO"},
    {Fact::rate, "ORNEKLEME FREKANSI"},
    {Fact::rate, "ORNEKLEME HIZI"},
    {Fact::rate, "サンプリング周波数"},
    {Fact::rate, "サンプリングレート"},
    {Fact::rate, "FREKUENSI SAMPLING"},
    {Fact::count, "NPTS"},
    {Fact::count, "NPT"},
    {Fact::count, "NDATA"},
    {Fact::count, "NUMBER OF DATA"},
    {Fact::count, "NUMBER OF DATA POINTS"},
    {Fact::count, "NUMBER OF POINTS"},
    {Fact::count, "NUMBER OF SAMPLES"},
    {Fact::count, "NUMBER OF VALUES"},
    {Fact::count, "NO OF DATA"},
    {Fact::count, "NO OF DATA POINTS"},
    {Fact::count, "NO OF POINTS"},
    {Fact::count, "NO OF SAMPLES"},
    {Fact::count, "DATA POINTS", true},
    {Fact::count, "POINTS", true},
    {Fact::count, "SAMPLES", true},
    {Fact::count, "VALUES", true},
    {Fact::count, "NUMERO DE DATOS"},
    {Fact::count, "NUMERO DE MUESTRAS"},
    {Fact::count, "NUMERO DE PUNTOS"},
    {Fact::count, "NUMERO TOTAL DE MUESTRAS"},
    {Fact::count, "NUM TOTAL DE MUESTRAS"},
    {Fact::count, "NUM DE PUNTOS"},
    {Fact::count, "NO DE DATOS"},
    {Fact::count, "MUESTRAS", true},
    {Fact::count, "PUNTOS", true},
    {Fact::count, "VERI SAYISI"},
    {Fact::count, "ORNEK SAYISI"},
    {Fact::count, "NOKTA SAYISI"},
    {Fact::count, "データ数"},
    {Fact::count, "サンプル数"},
    {Fact::count, "JUMLAH DATA"},
    {Fact::count, "BANYAK DATA"},
    {Fact::unit, "UNIT"},
    {Fact::unit, "UNITS"},
    {Fact::unit, "AMPLITUDEUNIT"},
    {Fact::unit, "DATA IN"},
    {Fact::unit, "DATOS EN"},
    {Fact::unit, "VALORES EN"},
    {Fact::unit, "UNIDAD"},
    {Fact::unit, "UNIDADES"},
    {Fact::unit, "BIRIM"},
    {Fact::unit, "BIRIMI"},
    {Fact::unit, "BIRIMLER"},
    {Fact::unit, "単位"},
    {Fact::unit, "SATUAN"},
    {Fact::peak, "PGA"},
    {Fact::peak, "PGA VALUES"},
    {Fact::peak, "PEAK GROUND ACCELERATION"},
    {Fact::peak, "PEAK ACCELERATION"},
    {Fact::peak, "PEAK ACCEL"},
    {Fact::peak, "PEAK ACC"},
    {Fact::peak, "ACCELERATION PEAK"},
    {Fact::peak, "MAXIMUM ACCELERATION"},
    {Fact::peak, "MAXIMUM ACC"},
    {Fact::peak, "MAX ACCELERATION"},
    {Fact::peak, "MAX ACCEL"},
    {Fact::peak, "MAX ACC"},
    {Fact::peak, "ACELERACION MAXIMA"},
    {Fact::peak, "ACEL MAX"},
    {Fact::peak, "EN BUYUK IVME"},
    {Fact::peak, "MAKSIMUM IVME"},
    {Fact::peak, "MAKS IVME"},
    {Fact::peak, "PIK IVME"},
    {Fact::peak, "最大加速度"},
    {Fact::peak, "PERCEPATAN MAKSIMUM"},
    {Fact::peak, "PERCEPATAN PUNCAK"},
    {Fact::peak, "MAX", false, true},
    {Fact::peak, "MAXIMUM", false, true},
    {Fact::peak, "PEAK", false, true},
    {Fact::component, "COMPONENT"},
    {Fact::component, "COMP"},
    {Fact::component, "DIRECTION"},
    {Fact::component, "DIR"},
    {Fact::component, "ORIENTATION"},
    {Fact::component, "COMPONENTE"},
    {Fact::component, "ORIENTACION"},
    {Fact::component, "BILESEN"},
    {Fact::component, "成分"},
    {Fact::component, "KOMPONEN"},
    {Fact::acceleration, "ACCELERATION"},
    {Fact::acceleration, "ACCELERATIONS"},
    {Fact::acceleration, "ACCELARATION"},  // as a public database writes it
    {Fact::acceleration, "ACCEL"},
    {Fact::acceleration, "ACC"},
    {Fact::acceleration, "ACELERACION"},
    {Fact::acceleration, "ACELERACIONES"},
    {Fact::acceleration, "ACEL"},
    {Fact::acceleration, "IVME"},
    {Fact::acceleration, "加速度"},
    {Fact::acceleration, "PERCEPATAN"},
    {Fact::acceleration, "BESCHLEUNIGUNG"},
    {Fact::velocity, "VELOCITY"},
    {Fact::velocity, "VEL"},
    {Fact::velocity, "VELOCIDAD"},
    {Fact::velocity, "HIZ"},
    {Fact::velocity, "KECEPATAN"},
    {Fact::displacement, "DISPLACEMENT"},
    {Fact::displacement, "DISPL"},
    {Fact::displacement, "DISP"},
    {Fact::displacement, "DESPLAZAMIENTO"},
    {Fact::displacement, "YER DEGISTIRME"},
    {Fact::displacement, "変位"},
    {Fact::displacement, "PERPINDAHAN"},
    {Fact::other, "TIME PGA"},  // when, not how much
    {Fact::other, "TIME OF PGA"},
    {Fact::other, "TIME OF PEAK ACCELERATION"},
    {Fact::other, "TIME OF MAX ACC"},
    {Fact::other, "UNCOR MAX"},
    {Fact::other, "PEAK VELOCITY"},
    {Fact::other, "VELOCITY PEAK"},
    {Fact::other, "PEAK DISPLACEMENT"},
    {Fact::other, "DISPLACEMENT PEAK"},
};

constexpr std::string_view time_labels[] = {"TIME", "T",       "TIEMPO",       "ZAMAN",         "SURE",
                                            "SEC",  "SECONDS", "RELATIVETIME", "RELATIVE TIME", "時間",
                                            "時刻", "WAKTU",   "ZEIT",         "T SEC",         "TIME SEC"};
constexpr std::string_view index_labels[] = {"", "INDEX", "UNNAMED 0", "NO", "SAMPLE", "POINT", "I"};

bool word_letter(char c) { return (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9'); }

bool between_words(char c) { return c == ' ' || c == '\t' || c == '.' || c == '_' || c == ':' || c == '-'; }

/// The end of the words in the text, where they stand there from `at` on; else 0.
std::size_t end_of_words(std::string_view text, std::size_t at, std::string_view words) {
  for (const char c : words) {
    if (c != ' ') {
      if (at >= text.size() || text[at] != c) return 0;
      ++at;
      continue;
    }
    if (at >= text.size() || !between_words(text[at])) return 0;
    while (at < text.size() && between_words(text[at])) ++at;
  }
  return word_letter(words.back()) && at < text.size() && word_letter(text[at]) ? 0 : at;
}

/// The table by the first byte of its words.
const std::array<std::vector<const TableWord*>, 256>& by_first_byte() {
  static const auto sorted = [] {
    std::array<std::vector<const TableWord*>, 256> made;
    for (const TableWord& word : heading_table) made[static_cast<unsigned char>(word.words.front())].push_back(&word);
    return made;
  }();
  return sorted;
}

/// The character that begins at `at` in UTF-8, and its bytes; one byte, as it is, where that is no UTF-8.
std::pair<char32_t, std::size_t> character_at(std::string_view text, std::size_t at) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned char first = byte(at);
  const std::size_t size = first >= 0xF0 ? 4 : first >= 0xE0 ? 3 : first >= 0xC2 ? 2 : 1;
  if (first < 0xC2 || at + size > text.size()) return {first, 1};
  char32_t character = first & (0xFF >> (size + 1));
  for (std::size_t i = at + 1; i < at + size; ++i) {
    if ((byte(i) & 0xC0) != 0x80) return {first, 1};
    character = (character << 6) | (byte(i) & 0x3F);
  }
  return {character, size};
}

}  // namespace

char base_letter(char32_t character) {
  // From 0xC0 to 0xFF in Latin-1; ÷ and × are no letters. Below them what Turkish has in their place in one byte.
  static constexpr std::string_view latin = "AAAAAAACEEEEIIIIDNOOOOO OUUUUYTSAAAAAAACEEEEIIIIDNOOOOO OUUUUYTY";
  static const std::map<char32_t, char> others = {{0xB2, '2'},   {0x11E, 'G'},  {0x11F, 'G'},  {0x130, 'I'},
                                                  {0x131, 'I'},  {0x15E, 'S'},  {0x15F, 'S'},  {0xFF08, '('},
                                                  {0xFF09, ')'}, {0xFF1A, ':'}, {0xFF1D, '='}, {0x3000, ' '}};
  static_assert(latin.size() == 0x40);
  if (character >= 0xC0 && character <= 0xFF) {
    const char letter = latin[character - 0xC0];
    return letter == ' ' ? '\0' : letter;
  }
  const auto found = others.find(character);
  return found == others.end() ? '\0' : found->second;
}

std::string folded(std::string_view text) {
  std::string result;
  result.reserve(text.size());
  for (std::size_t at = 0; at < text.size();) {
    const auto [character, bytes] = character_at(text, at);
    if (character < 0x80) {
      const char c = static_cast<char>(character);
      result += c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
    } else if (bytes == 1) {  // Turkish where it differs from Western letters, which no heading of records has
      const char32_t turkish = character == 0xD0 || character == 0xF0   ? U'\u011E'
                               : character == 0xDD || character == 0xFD ? U'\u0130'
                               : character == 0xDE || character == 0xFE ? U'\u015E'
                                                                        : character;
      const char letter = base_letter(turkish);
      result += letter == '\0' ? '?' : letter;
    } else if (const char letter = base_letter(character); letter != '\0') {
      result += letter;
    } else {
      result += text.substr(at, bytes);
    }
    at += bytes;
  }
  return result;
}

std::vector<HeadingPhrase> phrases_of(std::string_view text) {
  std::vector<HeadingPhrase> found;
  for (std::size_t at = 0; at < text.size();) {
    const bool inside = at > 0 && word_letter(text[at]) && word_letter(text[at - 1]);
    HeadingPhrase best;
    for (const TableWord* const word : by_first_byte()[static_cast<unsigned char>(text[at])]) {
      if (inside) break;
      const std::size_t end = end_of_words(text, at, word->words);
      if (end > best.end) best = {word->fact, at, end, word->number_before, word->needs_unit};
    }
    if (best.end > 0) found.push_back(best);
    at = best.end > 0 ? best.end : at + 1;
  }
  return found;
}

std::optional<Fact> fact_of_label(std::string_view label) {
  std::string plain;
  for (const char c : label) {
    if (!between_words(c)) {
      plain += c;
    } else if (!plain.empty() && plain.back() != ' ') {
      plain += ' ';
    }
  }
  if (plain.ends_with(' ')) plain.pop_back();
  const auto is_one_of = [&](const auto& labels) {
    return std::find(std::begin(labels), std::end(labels), plain) != std::end(labels);
  };
  if (is_one_of(index_labels)) return Fact::index;
  if (is_one_of(time_labels)) return Fact::time;
  if (plain == "A") return Fact::acceleration;
  for (const HeadingPhrase& phrase : phrases_of(plain)) {
    if (phrase.fact == Fact::acceleration) return phrase.fact;
    // Prose speaks of them, too; a column's heading begins with them.
    const bool other = phrase.fact == Fact::velocity || phrase.fact == Fact::displacement;
    if (other && phrase.begin == 0 && std::count(plain.begin(), plain.end(), ' ') <= 1) return phrase.fact;
  }
  return std::nullopt;
}

std::optional<double> seconds_of(std::string_view word) {
  static const std::map<std::string_view, double> units = {{"S", 1},
                                                           {"SEC", 1},
                                                           {"SECS", 1},
                                                           {"SECOND", 1},
                                                           {"SECONDS", 1},
                                                           {"SEG", 1},
                                                           {"SN", 1},
                                                           {"SANIYE", 1},
                                                           {"SEGUNDOS", 1},
                                                           {"DETIK", 1},
                                                           {"秒", 1},
                                                           {"MS", 1e-3},
                                                           {"MSEC", 1e-3},
                                                           {"MSN", 1e-3},
                                                           {"MSEG", 1e-3},
                                                           {"MILLISECOND", 1e-3},
                                                           {"MILLISECONDS", 1e-3}};
  while (word.ends_with('.')) word.remove_suffix(1);
  const auto found = units.find(word);
  return found == units.end() ? std::nullopt : std::optional(found->second);
}

bool is_rate_unit(std::string_view word) {
  return word == "HZ" || word == "SPS" || word == "1/S" || word == "SAMPLES/SEC" || word == "SAMPLES/S" ||
         word == "MUESTRAS/S";
}

bool is_other_unit(std::string_view word) {
  static constexpr std::string_view units[] = {"CM/S", "CM/SEC", "MM/S", "M/S",   "M/SEC",  "IN/S", "IN/SEC", "FT/S",
                                               "CM",   "MM",     "M",    "COUNT", "COUNTS", "VOLT", "VOLTS",  "V"};
  return std::find(std::begin(units), std::end(units), word) != std::end(units);
}

}  // namespace bentur::records
