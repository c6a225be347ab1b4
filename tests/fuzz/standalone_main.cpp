#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <vector>

#include "fuzz/target.h"

/// Runs a fuzz target without libFuzzer: every file of a folder, then as many
/// mutations of them, always the same ones. Each input ends at a page that
/// cannot be read.
///
///     fuzz_decode_file CORPUS_FOLDER MUTATIONS
///     fuzz_decode_file INPUT_FILE
namespace {

namespace fs = std::filesystem;
using Bytes = std::vector<std::uint8_t>;

class GuardedBuffer {
 public:
  explicit GuardedBuffer(std::size_t capacity)
      : page_(static_cast<std::size_t>(sysconf(_SC_PAGESIZE))),
        usable_((capacity + page_ - 1) / page_ * page_) {
    void* memory = mmap(nullptr, usable_ + page_, PROT_READ | PROT_WRITE,
                        MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    if (memory == MAP_FAILED) std::abort();
    memory_ = static_cast<std::uint8_t*>(memory);
    if (mprotect(memory_ + usable_, page_, PROT_NONE) != 0) std::abort();
  }
  ~GuardedBuffer() { munmap(memory_, usable_ + page_); }
  GuardedBuffer(const GuardedBuffer&) = delete;
  GuardedBuffer& operator=(const GuardedBuffer&) = delete;

  void run(const Bytes& input) {
    if (input.size() > usable_) std::abort();
    std::uint8_t* start = memory_ + usable_ - input.size();
    std::copy(input.begin(), input.end(), start);
    LLVMFuzzerTestOneInput(start, input.size());
  }

 private:
  std::size_t page_;
  std::size_t usable_;
  std::uint8_t* memory_ = nullptr;
};

Bytes read(const fs::path& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

/// Changes inputs as libFuzzer's simplest mutators do. Only the generator and
/// its remainders are used, so that every platform makes the same inputs.
class Mutator {
 public:
  explicit Mutator(const std::vector<Bytes>& seeds) : seeds_(seeds) {}

  Bytes next() {
    Bytes input = seeds_[below(seeds_.size())];
    for (std::size_t i = below(4) + 1; i > 0; --i) change(input);
    return input;
  }

 private:
  std::size_t below(std::size_t end) {
    return static_cast<std::size_t>(random_()) % end;
  }
  std::uint8_t byte() { return static_cast<std::uint8_t>(random_()); }
  std::ptrdiff_t place(const Bytes& input) {
    return static_cast<std::ptrdiff_t>(below(input.size() + 1));
  }

  void change(Bytes& input) {
    constexpr std::array<std::uint8_t, 8> kTelling{0x00, 0x01, 0x7f, 0x80,
                                                   0xff, 0xfe, 0x10, 0x40};
    if (input.empty()) {
      input.push_back(byte());
      return;
    }
    std::uint8_t& one = input[below(input.size())];
    switch (below(8)) {
      case 0: one ^= static_cast<std::uint8_t>(1U << below(8)); break;
      case 1: one = byte(); break;
      case 2: one = kTelling[below(kTelling.size())]; break;
      case 3: input.insert(input.begin() + place(input), byte()); break;
      case 4: input.resize(below(input.size() + 1)); break;
      case 5: erase_some(input); break;
      case 6: repeat_some(input); break;
      default: splice(input); break;
    }
  }

  void erase_some(Bytes& input) {
    const auto from = input.begin() + place(input);
    const auto room = static_cast<std::size_t>(input.end() - from);
    input.erase(
        from, from + static_cast<std::ptrdiff_t>(std::min(below(8) + 1, room)));
  }

  void repeat_some(Bytes& input) {
    const std::size_t from = below(input.size());
    const std::size_t count = std::min(below(16) + 1, input.size() - from);
    const auto start = input.begin() + static_cast<std::ptrdiff_t>(from);
    const Bytes part(start, start + static_cast<std::ptrdiff_t>(count));
    input.insert(input.begin() + place(input), part.begin(), part.end());
  }

  void splice(Bytes& input) {
    const Bytes& other = seeds_[below(seeds_.size())];
    input.erase(input.begin() + place(input), input.end());
    input.insert(input.end(), other.begin() + place(other), other.end());
  }

  const std::vector<Bytes>& seeds_;
  std::mt19937 random_{20260101};
};

int run_one(const fs::path& path) {
  const Bytes input = read(path);
  GuardedBuffer(input.size()).run(input);
  return 0;
}

int run_corpus(const fs::path& folder, long mutations) {
  std::vector<fs::path> paths;
  for (const auto& entry : fs::directory_iterator(folder)) {
    paths.push_back(entry.path());
  }
  std::sort(paths.begin(), paths.end());
  std::vector<Bytes> seeds;
  std::size_t longest = 0;
  for (const fs::path& path : paths) {
    seeds.push_back(read(path));
    longest = std::max(longest, seeds.back().size());
  }
  if (seeds.empty()) {
    std::fprintf(stderr, "no inputs in %s\n", folder.c_str());
    return 2;
  }
  // Four changes at most, each of which adds at most a whole seed.
  GuardedBuffer buffer(5 * longest + 64);
  for (const Bytes& seed : seeds) buffer.run(seed);
  Mutator mutator(seeds);
  for (long i = 0; i < mutations; ++i) buffer.run(mutator.next());
  std::printf("%zu seeds, %ld mutations\n", seeds.size(), mutations);
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc == 2) return run_one(argv[1]);
  if (argc == 3) {
    return run_corpus(argv[1], std::strtol(argv[2], nullptr, 10));
  }
  std::fprintf(stderr, "usage: %s CORPUS_FOLDER MUTATIONS | INPUT\n", argv[0]);
  return 2;
}
