// fuzz_TARGET COUNT FILE...: feeds a target with each of the files, and with COUNT changed ones, drawn by a fixed seed.

#include <cstdint>
#include <fstream>
#include <iostream>
#include <iterator>
#include <random>
#include <string>
#include <vector>

#include "tests/support/mutated_text.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

int main(int argc, char** argv) {
  if (argc < 3) {
    std::cerr << "fuzz: needs a count and files\n";
    return 2;
  }
  std::vector<std::string> inputs;
  for (int i = 2; i < argc; ++i) {
    std::ifstream file(argv[i], std::ios::binary);
    inputs.emplace_back(std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>());
  }
  const auto feed = [](const std::string& input) {
    LLVMFuzzerTestOneInput(reinterpret_cast<const std::uint8_t*>(input.data()), input.size());
  };
  for (const std::string& input : inputs) feed(input);
  std::mt19937 random(20190531);
  const int count = std::stoi(argv[1]);
  for (int i = 0; i < count; ++i) feed(bentur::test::mutated(inputs[random() % inputs.size()], random));
  std::cout << inputs.size() << " files, " << count << " changed ones\n";
}
