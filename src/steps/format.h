#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

#include "unstep/result.h"
#include "unstep/step_stream.h"

/// What writers and readers of step streams share. docs/steps.md.
namespace unstep::steps {

inline constexpr std::array<std::uint8_t, 4> kSignature{0xf5, 0x53, 0x0d, 0x0a};
inline constexpr std::uint8_t kVersion = 0;
inline constexpr std::uint8_t kTimedFlag = 0x10;
inline constexpr std::uint64_t kMaxRunPart = std::uint64_t{1} << 20;
inline constexpr std::int64_t kMaxStepLength = std::int64_t{1} << 40;

/// Nanoseconds of VCD files.
inline constexpr std::uint64_t kVcdClock = 1'000'000'000;

Status check_head(const StepHead& head);
/// What the head does not allow: invalid_argument.
Status check_run(const StepHead& head, const StepRun& run);

/// One format's side of StepWriter. Appends to `out`, which is flushed.
class Format {
 public:
  virtual ~Format() = default;
  virtual void begin(const StepHead& head, std::string& out) = 0;
  virtual void add(const StepRun& run, std::string& out) = 0;
  virtual void finish(std::string& out) = 0;
};
std::unique_ptr<Format> make_vcd();

/// Collects pulses into runs, within the limit.
class Collector {
 public:
  Collector(const StepHead& head, std::uint64_t max_steps)
      : stream_{head, {}}, left_(max_steps) {}

  [[nodiscard]] StepHead& head() { return stream_.head; }
  [[nodiscard]] const StepHead& head() const { return stream_.head; }
  Status add(bool rapid, StepWord word, std::uint32_t wait);
  [[nodiscard]] StepStream take() { return std::move(stream_); }
  [[nodiscard]] StepStream& stream() { return stream_; }
  /// limit_exceeded if there may not be so many more.
  Status claim(std::uint64_t count);

 private:
  StepStream stream_;
  std::uint64_t left_;
};

Result<StepStream> read_csv(std::string_view text,
                            const StepReadOptions& options);
Result<StepStream> read_vcd(std::string_view text,
                            const StepReadOptions& options);

/// "step 0.01" and "clock 1000" of a line: whole or decimal numbers after
/// their names. False if a number is broken or out of its range.
bool read_head_words(std::string_view line, StepHead& head);
void append_head_words(std::string& out, const StepHead& head);

}  // namespace unstep::steps
