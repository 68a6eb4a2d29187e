#include "bentur/io/record_files.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fstream>
#include <limits>
#include <sstream>
#include <system_error>

#include "bentur/io/record_files_text.h"

namespace bentur {

void RecordErrors::error(int line, int column, const std::string& message) {
  if (!full()) diagnostics_.error({file_, line, column}, message);
  ++count_;
}

std::vector<Line> lines_of(std::string_view text) {
  while (!text.empty() && (text.back() == '\x1A' || text.back() == '\0')) text.remove_suffix(1);
  std::vector<Line> lines;
  int number = 1;
  while (!text.empty()) {
    const std::size_t end = text.find_first_of("\r\n");
    lines.push_back({text.substr(0, end), number++});
    if (end == std::string_view::npos) break;
    text.remove_prefix(text.compare(end, 2, "\r\n") == 0 ? end + 2 : end + 1);
  }
  return lines;
}

std::vector<Token> words_of(const Line& line, std::string_view separators) {
  std::vector<Token> words;
  std::size_t at = 0;
  while ((at = line.text.find_first_not_of(separators, at)) != std::string_view::npos) {
    const std::size_t end = std::min(line.text.find_first_of(separators, at), line.text.size());
    words.push_back({line.text.substr(at, end - at), line.number, static_cast<int>(at) + 1});
    at = end;
  }
  return words;
}

std::optional<double> number_of(std::string_view text, bool decimal_comma) {
  std::string number(text.substr(0, 64));
  if (text.size() > 64 || number.empty()) return std::nullopt;
  if (number.front() == '+') {
    number.erase(0, 1);
    if (number.empty() || number.front() == '-') return std::nullopt;
  }
  for (char& c : number) {
    if (c == 'd' || c == 'D') c = 'E';
    if (c == ',' && decimal_comma) c = '.';
  }
  double value = 0;
  const auto [end, failure] = std::from_chars(number.data(), number.data() + number.size(), value);
  if (end != number.data() + number.size()) return std::nullopt;
  if (failure == std::errc::result_out_of_range) {  // 1e-400 is zero, 1e400 is beyond any double
    const std::size_t exponent = number.find_first_of("eE");
    const bool tiny = exponent != std::string::npos && number.find('-', exponent) != std::string::npos;
    return tiny ? 0.0 : std::numeric_limits<double>::infinity();
  }
  if (failure != std::errc()) return std::nullopt;
  return value;
}

std::string shown(std::string_view text) {
  std::string result = "\"";
  for (const char c : text.substr(0, 30)) result += c >= 0x20 && c < 0x7F ? c : '?';
  return result + (text.size() > 30 ? "...\"" : "\"");
}

std::optional<double> finite_number(const Token& token, bool decimal_comma, RecordErrors& errors) {
  const auto value = number_of(token.text, decimal_comma);
  if (!value) {
    errors.error(token, shown(token.text) + " is not a number");
    return std::nullopt;
  }
  if (!std::isfinite(*value)) {
    errors.error(token, shown(token.text) + " is not a finite number");
    return std::nullopt;
  }
  return value;
}

std::optional<Record> read_record(const std::filesystem::path& file, const RecordOptions& options,
                                  Diagnostics& diagnostics) {
  constexpr std::size_t largest_file = std::size_t{256} << 20;  // bytes
  RecordErrors errors(file.string(), diagnostics);
  std::error_code failed;
  if (!std::filesystem::exists(file, failed)) {
    errors.error(0, 0, "there is no such file");
    return std::nullopt;
  }
  if (std::filesystem::is_directory(file, failed)) {
    errors.error(0, 0, "is a folder, not a record");
    return std::nullopt;
  }
  if (std::filesystem::is_regular_file(file, failed) && std::filesystem::file_size(file, failed) > largest_file) {
    errors.error(0, 0, "is larger than 256 MiB, which no record is");
    return std::nullopt;
  }
  std::ifstream stream(file, std::ios::binary);
  std::ostringstream buffer;
  buffer << stream.rdbuf();
  if (!stream) {
    errors.error(0, 0, "cannot be read");
    return std::nullopt;
  }
  std::string text = buffer.str();
  if (text.compare(0, 3, "\xEF\xBB\xBF") == 0) text.erase(0, 3);  // a byte order mark
  const std::vector<Line> lines = lines_of(text);
  const bool blank = std::all_of(lines.begin(), lines.end(), [](const Line& line) {
    return line.text.find_first_not_of(" \t") == std::string_view::npos;
  });
  if (blank) {
    errors.error(0, 0, "is empty");
    return std::nullopt;
  }
  const bool peer = options.format == "peer-at2" || (options.format == "auto" && looks_like_peer(lines));
  std::optional<Record> record = peer ? read_peer(lines, options, errors) : read_columns(lines, options, errors);
  if (record && record->values.size() < 2) errors.error(0, 0, "holds one value only, a record needs two or more");
  return errors.ok() ? std::move(record) : std::nullopt;
}

}  // namespace bentur
