#pragma once

#include <unistd.h>

#include <cerrno>
#include <string>
#include <system_error>
#include <utility>

#include "unstep/result.h"

/// What reading and writing files share.
namespace unstep {

inline Error system_error(const char* doing, int number) {
  return {ErrorCode::io_error,
          std::string(doing) + ": " + std::generic_category().message(number)};
}

/// An owned file descriptor; 0 and 1 are borrowed.
class Descriptor {
 public:
  explicit Descriptor(int number) : number_(number) {}
  ~Descriptor() {
    if (number_ > 1) ::close(number_);
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  [[nodiscard]] int get() const { return number_; }
  [[nodiscard]] explicit operator bool() const { return number_ >= 0; }
  /// The close that tells of delayed write errors. 0 or an errno.
  int close() {
    const int number = std::exchange(number_, -1);
    return number > 1 && ::close(number) != 0 && errno != EINTR ? errno : 0;
  }

 private:
  int number_;
};

template <class Call>
auto retry(const Call& call) {
  auto result = call();
  while (result < 0 && errno == EINTR) result = call();
  return result;
}

}  // namespace unstep
