#include "codec/thread_heap.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <thread>
#include <vector>

namespace unstep::codec {
namespace {

/// Blocks of all sizes up to some large pages, each filled with its number.
bool blocks_keep_what_is_written() {
  std::vector<std::vector<std::uint8_t>> blocks;
  for (std::size_t size = 1; size < (std::size_t{8} << 20); size *= 3) {
    blocks.emplace_back(size, static_cast<std::uint8_t>(blocks.size()));
  }
  for (std::size_t i = 0; i < blocks.size(); ++i) {
    if (std::ranges::count(blocks[i], static_cast<std::uint8_t>(i)) !=
        std::ssize(blocks[i])) {
      return false;
    }
  }
  return true;
}

TEST(ThreadHeap, BlocksOfPreparedThreadsDoNotOverlap) {
  // The second round finds the heaps that the first left.
  for (int round = 0; round < 2; ++round) {
    std::vector<int> kept(4);
    std::vector<std::jthread> threads;
    for (int& mine : kept) {
      threads.emplace_back([&mine] {
        prepare_thread_heap();
        prepare_thread_heap();
        mine = blocks_keep_what_is_written() ? 1 : 0;
      });
    }
    threads.clear();
    EXPECT_EQ(kept, std::vector<int>(4, 1));
  }
}

TEST(ThreadHeap, TheFirstThreadsHeapIsLeftAlone) {
  prepare_thread_heap();
  EXPECT_TRUE(blocks_keep_what_is_written());
}

}  // namespace
}  // namespace unstep::codec
