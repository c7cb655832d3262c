// In place of libFuzzer, for compilers that have none: inputs at random, or those in files.
//
//   TARGET COUNT SEED | FILE...
#include <unistd.h>

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <fstream>
#include <iterator>
#include <random>
#include <string>
#include <vector>

// NOLINTNEXTLINE(readability-identifier-naming): the name is libFuzzer's.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace {

// An input that takes longer hangs, or is a job that the targets should not have made.
constexpr unsigned kSeconds = 60;

void try_one(const std::vector<std::uint8_t>& input, const std::string& name) {
  alarm(kSeconds);
  try {
    LLVMFuzzerTestOneInput(input.data(), input.size());
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s: %s\n", name.c_str(), error.what());
    std::exit(1);
  }
}

}  // namespace

int main(int argc, char** argv) {
  const std::vector<std::string> words(argv + 1, argv + argc);
  std::size_t tried = 0;
  if (words.size() == 2 && words[0].find_first_not_of("0123456789") == std::string::npos) {
    std::mt19937_64 random(std::stoull(words[1]));
    for (const std::size_t count = std::stoull(words[0]); tried < count; ++tried) {
      std::vector<std::uint8_t> input(random() % 400);
      for (std::uint8_t& byte : input) byte = static_cast<std::uint8_t>(random());
      try_one(input, "input " + std::to_string(tried) + " of seed " + words[1]);
    }
  } else {
    for (; tried < words.size(); ++tried) {
      std::ifstream file(words[tried], std::ios::binary);
      try_one({std::istreambuf_iterator<char>(file), {}}, words[tried]);
    }
  }
  std::fprintf(stderr, "%zu inputs, nothing found\n", tried);
}
