#include <string>

#include "formats/decimal.h"
#include "steps/format.h"

/// IEEE 1364, value change dump.
namespace unstep::steps {
namespace {

constexpr std::string_view kAxisNames = "xyz";
/// Identifiers of the wires: step and dir of each axis, then rapid.
constexpr char kFirstId = '!';
constexpr char kRapidId = '\'';

/// A pulse without a clock takes so many ns.
constexpr std::uint64_t kUntimed = 1000;

class Vcd : public Format {
 public:
  void begin(const StepHead& head, std::string& out) override {
    head_ = head;
    out += "$comment unstep";
    append_head_words(out, head);
    out += " $end\n$timescale 1 ns $end\n$scope module steps $end\n";
    for (int axis = 0; axis < head.axes; ++axis) {
      const auto name = kAxisNames[static_cast<std::size_t>(axis)];
      declare(out, id(axis, false), std::string("step_") + name);
      declare(out, id(axis, true), std::string("dir_") + name);
    }
    declare(out, kRapidId, "rapid");
    out += "$upscope $end\n$enddefinitions $end\n#0\n";
    for (int axis = 0; axis < head.axes; ++axis) {
      set(out, id(axis, false), false);
      set(out, id(axis, true), false);
    }
    set(out, kRapidId, false);
  }

  void add(const StepRun& run, std::string& out) override {
    for (std::size_t i = 0; i < run.words.size(); ++i) {
      const std::uint64_t before = time_;
      if (head_.clock > 0) {
        ticks_ += run.waits[i];
        // Whole seconds apart, so that nothing overflows.
        time_ = ticks_ / head_.clock * kVcdClock +
                ticks_ % head_.clock * kVcdClock / head_.clock;
      } else {
        time_ += kUntimed;
      }
      if (time_ < before + 2) time_ = before + 2;
      pulse(run.words[i], run.rapid, before, out);
    }
  }

  void finish(std::string& out) override {
    if (time_ == 0) return;
    stamp(out, time_ + 1);
    fall(out);
  }

 private:
  static char id(int axis, bool direction) {
    return static_cast<char>(kFirstId + 2 * axis + (direction ? 1 : 0));
  }
  static void declare(std::string& out, char wire, const std::string& name) {
    out += "$var wire 1 ";
    out += wire;
    out += ' ';
    out += name;
    out += " $end\n";
  }
  static void set(std::string& out, char wire, bool on) {
    out += on ? '1' : '0';
    out += wire;
    out += '\n';
  }
  static void stamp(std::string& out, std::uint64_t time) {
    out += '#';
    append_integer(out, static_cast<std::int64_t>(time));
    out += '\n';
  }
  void fall(std::string& out) const {
    for (int axis = 0; axis < head_.axes; ++axis) {
      if (step_of(word_, static_cast<std::size_t>(axis)) != 0) {
        set(out, id(axis, false), false);
      }
    }
  }

  /// Directions change as the pulse before ends.
  void pulse(StepWord word, bool rapid, std::uint64_t before,
             std::string& out) {
    if (word_ != 0) {
      stamp(out, before + (time_ - before) / 2);
      fall(out);
    }
    for (int axis = 0; axis < head_.axes; ++axis) {
      const int step = step_of(word, static_cast<std::size_t>(axis));
      bool& back = back_[static_cast<std::size_t>(axis)];
      if (step == 0 || back == (step < 0)) continue;
      back = step < 0;
      set(out, id(axis, true), back);
    }
    if (rapid != rapid_) set(out, kRapidId, rapid);
    rapid_ = rapid;
    stamp(out, time_);
    for (int axis = 0; axis < head_.axes; ++axis) {
      if (step_of(word, static_cast<std::size_t>(axis)) != 0) {
        set(out, id(axis, false), true);
      }
    }
    word_ = word;
  }

  StepHead head_;
  std::uint64_t ticks_ = 0;
  std::uint64_t time_ = 0;  ///< ns of the last pulse
  StepWord word_ = 0;
  std::array<bool, kMaxStepAxes> back_{};
  bool rapid_ = false;
};

}  // namespace

std::unique_ptr<Format> make_vcd() { return std::make_unique<Vcd>(); }

}  // namespace unstep::steps
