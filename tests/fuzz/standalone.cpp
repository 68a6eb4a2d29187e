// fuzz_TARGET COUNT [FILE...]: feeds a target with each of the files, and with COUNT changed ones, drawn by a fixed
// seed; without files with COUNT strings of any bytes.

#include <cstdint>
#include <fstream>
#include <iostream>
#include <iterator>
#include <random>
#include <string>
#include <vector>

#include "tests/fuzz/support.h"
#include "tests/support/mutated_text.h"

int main(int argc, char** argv) {
  if (argc < 2) {
    std::cerr << "fuzz: needs a count\n";
    return 2;
  }
  std::vector<std::string> inputs;
  for (int i = 2; i < argc; ++i) {
    std::ifstream file(argv[i], std::ios::binary);
    inputs.emplace_back(std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>());
  }
  for (const std::string& input : inputs) bentur::fuzz::feed(input);
  std::mt19937 random(20190531);
  const auto any_bytes = [&] {
    std::string bytes(random() % 400, '\0');
    for (char& byte : bytes) byte = static_cast<char>(random() & 0xFF);
    return bytes;
  };
  const int count = std::stoi(argv[1]);
  for (int i = 0; i < count; ++i) {
    bentur::fuzz::feed(inputs.empty() ? any_bytes() : bentur::test::mutated(inputs[random() % inputs.size()], random));
  }
  const long accepted = bentur::fuzz::accepted(false);
  std::cout << inputs.size() << " files, " << count << " changed ones or of any bytes, " << accepted << " accepted\n";
  return accepted > 0 ? 0 : 1;
}
