// SPDX-License-Identifier: MIT
// Runs a fuzz target on files, and on cut and changed copies of them: what a compiler without
// libFuzzer can do, on every run of the tests.
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <vector>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

int main(int argc, char** argv) {
  int runs = 0;
  std::mt19937 random(1);
  for (int i = 1; i < argc; ++i)
    for (const auto& entry : std::filesystem::directory_iterator(argv[i])) {
      std::ifstream stream(entry.path(), std::ios::binary);
      const std::vector<char> text(std::istreambuf_iterator<char>(stream), {});
      const std::vector<std::uint8_t> seed(text.begin(), text.end());
      for (int round = 0; round < 200; ++round) {
        std::vector<std::uint8_t> bytes = seed;
        for (int k = round % 4; k > 0 && !bytes.empty(); --k)
          bytes[random() % bytes.size()] = static_cast<std::uint8_t>(random());
        if (round % 5 == 4) bytes.resize(random() % (bytes.size() + 1));
        LLVMFuzzerTestOneInput(bytes.data(), bytes.size());
        ++runs;
      }
    }
  std::printf("%d inputs\n", runs);
  return runs > 0 ? 0 : 1;
}
