#include "codec/parallel.h"

#include <algorithm>
#include <atomic>
#include <limits>
#include <memory>
#include <new>
#include <system_error>
#include <thread>
#include <vector>

#include "codec/thread_heap.h"

namespace unstep::codec {
namespace {

class Team {
 public:
  Team(std::size_t count, const std::function<Status(std::size_t)>& work)
      : count_(count), work_(work) {}

  void run() {
    while (!failed_.load(std::memory_order_relaxed)) {
      const std::size_t i = next_.fetch_add(1, std::memory_order_relaxed);
      if (i >= count_) return;
      if (Status done = attempt(i); !done) fail(i, done);
    }
  }

  [[nodiscard]] const Status& status() const { return status_; }

 private:
  Status attempt(std::size_t i) {
    try {
      return work_(i);
    } catch (const std::bad_alloc&) {
      return Error{ErrorCode::limit_exceeded, "no memory"};
    }
  }

  void fail(std::size_t i, const Status& why) {
    failed_.store(true, std::memory_order_relaxed);
    const std::lock_guard lock(mutex_);
    if (i < failed_at_) {
      failed_at_ = i;
      status_ = why;
    }
  }

  const std::size_t count_;
  const std::function<Status(std::size_t)>& work_;
  std::atomic<std::size_t> next_{0};
  std::atomic<bool> failed_{false};
  std::mutex mutex_;
  std::size_t failed_at_ = std::numeric_limits<std::size_t>::max();
  Status status_;
};

}  // namespace

Status run_parallel(int jobs, std::size_t count,
                    const std::function<Status(std::size_t)>& work) {
  Team team(count, work);
  {
    const std::size_t threads =
        std::min(count, static_cast<std::size_t>(std::max(jobs, 1)));
    std::vector<std::jthread> helpers;
    try {
      helpers.reserve(threads);
      while (helpers.size() + 1 < threads) {
        helpers.emplace_back([&team] {
          prepare_thread_heap();
          team.run();
        });
      }
    } catch (const std::system_error&) {
      // Fewer threads than wished give the same result.
    }
    team.run();
  }
  return team.status();
}

BlockProgress ProgressSum::block() {
  if (!progress_) return {};
  // Shared, so that copies of the callback count once.
  return [this, seen = std::make_shared<std::uint64_t>(0)](std::uint64_t done) {
    const std::uint64_t more = done > *seen ? done - *seen : 0;
    *seen += more;
    return add(more);
  };
}

Status ProgressSum::complete(const BlockProgress& progress,
                             std::uint64_t size) {
  if (progress && !progress(size)) {
    return Error{ErrorCode::cancelled, "cancelled"};
  }
  return {};
}

bool ProgressSum::add(std::uint64_t more) {
  const std::lock_guard lock(mutex_);
  done_ = std::min(done_ + more, total_);
  if (!cancelled_ && !progress_(done_, total_)) cancelled_ = true;
  return !cancelled_;
}

}  // namespace unstep::codec
