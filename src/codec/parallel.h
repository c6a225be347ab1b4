#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <mutex>

#include "codec/block_coder.h"
#include "unstep/codec.h"
#include "unstep/result.h"

namespace unstep::codec {

/// Calls work(i) once for each i < count on up to `jobs` threads, the caller's
/// included, in no fixed order. After a failure no new i is begun. Returns the
/// failure with the lowest i. `work` may throw std::bad_alloc, which becomes
/// limit_exceeded.
Status run_parallel(int jobs, std::size_t count,
                    const std::function<Status(std::size_t)>& work);

/// Adds the progress of blocks that run in parallel up to one Progress.
class ProgressSum {
 public:
  /// `total` in the unit of the blocks (rows, chains).
  ProgressSum(const Progress& progress, std::uint64_t total)
      : progress_(progress), total_(total) {}
  ProgressSum(const ProgressSum&) = delete;
  ProgressSum& operator=(const ProgressSum&) = delete;

  /// A callback for one block; empty if nobody listens. Must not outlive this.
  [[nodiscard]] BlockProgress block();

  /// Tells that the block of `progress` is complete, `size` of it, whatever
  /// its coder told. `cancelled` if the listener wants to stop.
  static Status complete(const BlockProgress& progress, std::uint64_t size);

 private:
  bool add(std::uint64_t more);

  const Progress& progress_;
  const std::uint64_t total_;
  std::mutex mutex_;
  std::uint64_t done_ = 0;
  bool cancelled_ = false;
};

}  // namespace unstep::codec
