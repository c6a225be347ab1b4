#include "codec/dss_state.h"

namespace unstep::codec {

void DssState::start(int step) {
  previous_ = length_;
  s0_ = step;
  s1_ = -1;
  x_ = 1;
  y_ = 0;
  length_ = 1;
}

void DssState::push(int step) {
  if (s0_ < 0 || length_ >= kMaxLength) return start(step);
  if (s1_ < 0) {
    if (step == s0_) {
      ++x_;
      ++length_;
      return;
    }
    const int apart = (step - s0_) & (ring_ - 1);
    if (apart != 1 && apart != ring_ - 1) return start(step);
    s1_ = step;
    a_ = 1;
    b_ = x_;
    w_ = b_ + 1;
    r_ = xu_ = yu_ = yl_ = lly_ = 0;
    xl_ = llx_ = lux_ = x_;
    y_ = luy_ = 1;
    ++length_;
    return;
  }
  std::int64_t r = 0;
  if (step == s0_) {
    r = r_ + a_;
  } else if (step == s1_) {
    r = r_ - b_;
  } else {
    return start(step);
  }
  if (r < -1 || r > w_) return start(step);
  ++(step == s0_ ? x_ : y_);
  ++length_;
  if (r == -1) {
    b_ = x_ - xu_;
    a_ = y_ - yu_;
    w_ = a_ + b_;
    r_ = 0;
    lux_ = x_;
    luy_ = y_;
    xl_ = llx_;
    yl_ = lly_;
  } else if (r == w_) {
    b_ = x_ - xl_;
    a_ = y_ - yl_;
    w_ = a_ + b_;
    r_ = w_ - 1;
    llx_ = x_;
    lly_ = y_;
    xu_ = lux_;
    yu_ = luy_;
  } else {
    r_ = r;
    if (r == 0) {
      lux_ = x_;
      luy_ = y_;
    }
    if (r == w_ - 1) {
      llx_ = x_;
      lly_ = y_;
    }
  }
}

unsigned DssState::verdict(int last) const {
  if (s0_ < 0) return 0;
  if (s1_ < 0) {
    return 1 + static_cast<unsigned>(std::min<std::int64_t>(length_, 24));
  }
  const bool keeps0 = r_ + a_ <= w_;
  const bool keeps1 = r_ - b_ >= -1;
  const bool inside0 = r_ + a_ <= w_ - 1;
  const bool inside1 = r_ - b_ >= 0;
  const auto age = static_cast<unsigned>(std::min<std::uint64_t>(
      7, std::bit_width(static_cast<std::uint64_t>(length_)) - 1));
  return 32U + (keeps0 ? 1U : 0U) + (keeps1 ? 2U : 0U) + (inside0 ? 4U : 0U) +
         (inside1 ? 8U : 0U) + (last == s1_ ? 16U : 0U) +
         (((s1_ - s0_) & (ring_ - 1)) == 1 ? 32U : 0U) + 64U * age;
}

std::uint32_t DssState::slope() const {
  if (w_ < 64) return static_cast<std::uint32_t>(w_ * 64 + a_);
  return static_cast<std::uint32_t>(5000 + a_ * 16 / w_);
}

}  // namespace unstep::codec
