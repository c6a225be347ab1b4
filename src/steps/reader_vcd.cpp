#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "formats/vcd_reader.h"
#include "steps/format.h"

/// Value change dumps: a rising edge of a step wire is a step, its direction
/// is that of the dir wire at the time. docs/steps.md.
namespace unstep::steps {
namespace {

enum class Role : std::uint8_t { step, direction, rapid };

struct Wire {
  Role role = Role::step;
  std::size_t axis = 0;
};

/// What a wire is by its name, without the scopes: "step_x", "XSTEP", "x_dir",
/// "dirZ", "rapid".
std::optional<Wire> wire_of(std::string_view name) {
  name.remove_prefix(name.rfind('.') + 1);  // npos + 1 is 0
  std::string word;
  for (const char c : name) {
    if (c >= 'A' && c <= 'Z') {
      word += static_cast<char>(c + 32);
    } else if (c >= 'a' && c <= 'z') {
      word += c;
    }
  }
  if (word == "rapid") return Wire{Role::rapid, 0};
  for (std::size_t axis = 0; axis < kMaxStepAxes; ++axis) {
    const std::string letter(1, static_cast<char>('x' + axis));
    for (const char* role : {"step", "dir", "direction", "pulse", "stp"}) {
      const std::string text(role);
      if (word != text + letter && word != letter + text) continue;
      return Wire{text[0] == 'd' ? Role::direction : Role::step, axis};
    }
  }
  return std::nullopt;
}

class WireReader {
 public:
  WireReader(VcdReader file, const StepReadOptions& options)
      : file_(std::move(file)), out_(options.head, options.max_steps) {}

  Result<StepStream> read() {
    if (Status begun = begin(); !begun) return begun.error();
    for (;;) {
      const auto change = file_.next();
      if (!change) return change.error();
      if (!*change || (*change)->time != time_) {
        if (Status done = end_time(); !done) return done.error();
      }
      if (!*change) return out_.take();
      time_ = (*change)->time;
      take(**change);
    }
  }

 private:
  Status begin() {
    StepHead& head = out_.head();
    const bool own = file_.comment().find("unstep") != std::string_view::npos;
    if (own) {
      head.clock = 0;
      if (!read_head_words(file_.comment(), head)) {
        return Error{ErrorCode::corrupt, "a broken number in the head"};
      }
    }
    std::array<bool, kMaxStepAxes> steps{};
    for (const VcdSignal& signal : file_.signals()) {
      const std::optional<Wire> wire = wire_of(signal.name);
      if (!wire || signal.width != 1) continue;
      if (signal.net >= wires_.size()) wires_.resize(signal.net + 1);
      wires_[signal.net] = wire;
      if (wire->role == Role::step) steps[wire->axis] = true;
    }
    if (!steps[0] && !steps[1]) {
      return Error{ErrorCode::corrupt, "no wires step_x, dir_x, step_y, dir_y"};
    }
    if (!file_.timescale().known) {
      return Error{ErrorCode::corrupt, "no timescale"};
    }
    clock_ = std::pow(10.0, -file_.timescale().exponent) /
             file_.timescale().magnitude;
    head.axes = steps[2] ? 3 : 2;
    if (!steps[2]) head.origin[2] = 0;
    // Waits count in ticks of at most 1 GHz.
    const double clock = std::min(clock_, static_cast<double>(kVcdClock));
    if (!own) head.clock = static_cast<std::uint32_t>(std::max(clock, 1.0));
    return check_head(head);
  }

  /// x and z count as low.
  void take(const VcdChange& change) {
    if (change.net >= wires_.size() || !wires_[change.net]) return;
    const Wire& wire = *wires_[change.net];
    const bool high = VcdProbe{change.net, 0}.level(change).value_or(false);
    if (wire.role == Role::rapid) {
      rapid_ = high;
    } else if (wire.role == Role::direction) {
      back_[wire.axis] = high;
    } else {
      if (high && !level_[wire.axis]) rose_[wire.axis] = true;
      level_[wire.axis] = high;
    }
  }

  /// All changes of one time are known.
  Status end_time() {
    unsigned word = 0;
    for (std::size_t axis = 0; axis < kMaxStepAxes; ++axis) {
      if (!rose_[axis]) continue;
      word |= (back_[axis] ? 3U : 1U) << (2 * axis);
      rose_[axis] = false;
    }
    if (word == 0) return {};
    const std::uint64_t ticks = ticks_at(time_);
    const std::uint64_t wait =
        std::max<std::uint64_t>(ticks - std::min(before_, ticks), 1);
    if (wait > 0xffffffffU && out_.head().clock > 0) {
      return Error{ErrorCode::out_of_range,
                   "time " + std::to_string(time_) +
                       ": more than 2^32 ticks between two steps"};
    }
    before_ = ticks;
    return out_.add(rapid_, static_cast<StepWord>(word),
                    static_cast<std::uint32_t>(wait));
  }

  /// Ticks of the head's clock, to the nearest.
  [[nodiscard]] std::uint64_t ticks_at(std::uint64_t time) const {
    const double ticks = static_cast<double>(time) / clock_ *
                         static_cast<double>(out_.head().clock);
    return ticks < 1e18 ? static_cast<std::uint64_t>(ticks + 0.5)
                        : std::uint64_t{1} << 60;
  }

  VcdReader file_;
  Collector out_;
  std::vector<std::optional<Wire>> wires_;  ///< by net
  std::array<bool, kMaxStepAxes> level_{};
  std::array<bool, kMaxStepAxes> back_{};
  std::array<bool, kMaxStepAxes> rose_{};
  bool rapid_ = false;
  double clock_ = 0;  ///< of the file's own times
  std::uint64_t time_ = 0;
  std::uint64_t before_ = 0;  ///< ticks of the last step
};

}  // namespace

Result<StepStream> read_vcd(std::string_view text,
                            const StepReadOptions& options) {
  Result<VcdReader> file = VcdReader::open(text, {});
  if (!file) return file.error();
  return WireReader(*std::move(file), options).read();
}

}  // namespace unstep::steps
