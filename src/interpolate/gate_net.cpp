// The net of SU 1089551, Fig. 1. Wires as the claim lists them but for the
// trigger, whose inputs the description has right (bus 20 sets, AND 19
// resets): with the claim's wiring the device would never start.

#include "unstep/interpolate.h"

namespace unstep {
namespace {

// Toggle flip-flops: a stage toggles when all lower stages are 1 (counting
// up) or 0 (counting down).
std::uint64_t count(std::uint64_t counter, bool subtract, int bits) {
  bool toggle = true;
  for (int i = 0; i < bits && toggle; ++i) {
    const bool q = (counter >> i & 1) != 0;
    counter ^= std::uint64_t{1} << i;
    toggle = subtract ? !q : q;
  }
  return counter;
}

// Ripple-carry adder; subtraction adds the inverse with a carry in.
std::uint64_t add(std::uint64_t a, std::uint64_t b, bool subtract, int bits) {
  std::uint64_t sum = 0;
  bool carry = subtract;
  for (int i = 0; i < bits; ++i) {
    const bool p = (a >> i & 1) != 0;
    const bool q = ((b >> i & 1) != 0) != subtract;
    sum |= std::uint64_t{(p != q) != carry} << i;
    carry = (p && q) || (carry && (p || q));
  }
  return sum;
}

}  // namespace

void GateNet::start(std::int64_t xk, std::int64_t yk) {
  clear();
  counter1_ = static_cast<std::uint64_t>(xk);
  counter2_ = static_cast<std::uint64_t>(yk);
  adder3_ = add(counter2_, counter1_, true, kBits);
  trigger_ = true;  // bus 20
  signals_.and19 = (counter1_ | counter2_) == 0;
  if (signals_.and19) clear();
}

void GateNet::pulse(bool generator, bool x_input, bool y_input) {
  constexpr std::uint64_t kMask = (std::uint64_t{1} << kBits) - 1;
  Signals& s = signals_;
  const bool sign = (adder3_ >> (kBits - 1) & 1) != 0;
  s.trigger11 = trigger_;
  s.and12 = (~adder3_ & kMask) == kMask;
  s.or13 = sign || s.and12;
  s.not14 = !s.or13;
  s.and9 = generator && trigger_;
  s.and4 = sign && s.and9;
  s.or6 = y_input || s.and9;
  s.and5 = !sign && s.or6;
  s.and15 = x_input && s.or13;
  s.and16 = s.not14 && x_input;
  s.and18 = sign && y_input;
  s.or7 = s.and5 || s.and18;
  s.or8 = s.and4 || s.and15 || s.and16;
  s.or17 = s.and18 || s.and16;

  // OR 8 counts in counter 1 and adds counter 2; OR 7 counts in counter 2
  // and subtracts counter 1. One pulse raises one of them at most.
  if (s.or8) {
    counter1_ = count(counter1_, trigger_, kBits);
    adder3_ = add(adder3_, counter2_, false, kBits);
  }
  if (s.or7) {
    counter2_ = count(counter2_, trigger_, kBits);
    adder3_ = add(adder3_, counter1_, true, kBits);
  }
  s.and19 = (~counter1_ & kMask) == kMask && (~counter2_ & kMask) == kMask;
  if (s.and19) trigger_ = false;
}

GateNet::Axis GateNet::clock() {
  pulse(true, false, false);
  if (signals_.or8) return Axis::x;
  return signals_.or7 ? Axis::y : Axis::none;
}

bool GateNet::accept(Axis axis) {
  pulse(false, axis == Axis::x, axis == Axis::y);
  return signals_.or17;
}

void GateNet::clear() { *this = GateNet(); }

DeviceRegisters GateNet::registers() const {
  // Shift the sign up to the top bit and back: two's complement of kBits.
  const auto f =
      static_cast<std::int64_t>(adder3_ << (64 - kBits)) >> (64 - kBits);
  return {static_cast<std::int64_t>(counter1_),
          static_cast<std::int64_t>(counter2_), f, trigger_};
}

}  // namespace unstep
