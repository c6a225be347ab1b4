#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>

/// Error values. Nothing in the library throws across its public boundary,
/// prints or exits: a call that can fail returns a Result.
///
///     Result<Bitmap> page = reader.read(0);
///     if (!page) return page.error();
///     use(*page);
namespace unstep {

enum class ErrorCode : std::uint8_t {
  truncated,            ///< the input ends before what it promises
  bad_magic,            ///< not a file of the expected kind
  unsupported_version,  ///< a newer or unknown format or coder
  unsupported,          ///< legal, but this build or tool cannot do it
  corrupt,              ///< the bytes contradict themselves
  checksum_mismatch,    ///< decoded, but not what was encoded
  limit_exceeded,       ///< more pixels, steps or memory than allowed
  out_of_range,         ///< a number outside its documented range
  io_error,             ///< the operating system refused to read or write
  output_exists,        ///< refused to overwrite
  invalid_argument,     ///< the caller's mistake
  cancelled,            ///< the caller's callback asked to stop
  internal,             ///< our bug; please report
};

/// A stable lower-case name ("truncated", "bad_magic", ...), for reports.
[[nodiscard]] std::string_view to_string(ErrorCode code);

/// What went wrong. `message` is one line without a trailing newline; it names
/// the place (byte, line, page, block) and the reason, not the file.
struct Error {
  ErrorCode code = ErrorCode::internal;
  std::string message;
};

/// Either a T or an Error. Reading the one that is not there is a bug in the
/// caller (std::get's behaviour).
template <class T>
class [[nodiscard]] Result {
 public:
  Result(T value) : state_(std::in_place_index<0>, std::move(value)) {}
  Result(Error error) : state_(std::in_place_index<1>, std::move(error)) {}

  [[nodiscard]] explicit operator bool() const { return state_.index() == 0; }
  [[nodiscard]] T& value() { return std::get<0>(state_); }
  [[nodiscard]] const T& value() const { return std::get<0>(state_); }
  [[nodiscard]] const Error& error() const { return std::get<1>(state_); }
  T& operator*() & { return value(); }
  const T& operator*() const& { return value(); }
  T operator*() && { return std::move(value()); }
  T* operator->() { return &value(); }
  const T* operator->() const { return &value(); }

 private:
  std::variant<T, Error> state_;
};

/// Success or an Error.
template <>
class [[nodiscard]] Result<void> {
 public:
  Result() = default;
  Result(Error error) : error_(std::move(error)), ok_(false) {}

  [[nodiscard]] explicit operator bool() const { return ok_; }
  [[nodiscard]] const Error& error() const { return error_; }

 private:
  Error error_;
  bool ok_ = true;
};

using Status = Result<void>;

/// Called now and then during long calls with work done and total (same,
/// unspecified unit). Return false to cancel: the call returns `cancelled`.
/// May be called from a worker thread, never from two at once.
using Progress = std::function<bool(std::uint64_t done, std::uint64_t total)>;

}  // namespace unstep
