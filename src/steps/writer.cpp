#include <algorithm>
#include <cstring>
#include <new>
#include <utility>

#include "codec/byte_writer.h"
#include "codec/checksum.h"
#include "formats/decimal.h"
#include "formats/gcode_number.h"
#include "steps/format.h"
#include "unstep/step_stream.h"

namespace unstep {
namespace steps {
namespace {

void append_varint(std::string& out, std::uint64_t value) {
  for (; value >= 0x80; value >>= 7) {
    out += static_cast<char>(value | 0x80);
  }
  out += static_cast<char>(value);
}

std::uint64_t zigzag(std::int64_t value) {
  return value >= 0 ? 2 * static_cast<std::uint64_t>(value)
                    : 2 * static_cast<std::uint64_t>(-(value + 1)) + 1;
}

/// Two words a byte, eight at a time. Bytes are in memory's order, low first.
std::uint32_t pack_eight(const StepWord* words) {
  std::uint64_t all = 0;
  std::memcpy(&all, words, 8);
  all = (all | all >> 4) & 0x00ff00ff00ff00ffU;
  all = (all | all >> 8) & 0x0000ffff0000ffffU;
  return static_cast<std::uint32_t>(all | all >> 16);
}

/// Changes of waits as bytes, most of them one: at a steady speed they are -1,
/// 0 and 1. Blocks of them are looked at side by side, then eight at a time.
class WaitChanges {
 public:
  void append(std::span<const std::uint32_t> waits, std::string& out) {
    for (std::size_t at = 0; at < waits.size(); at += kBlock) {
      append_block(waits.subspan(at, std::min(kBlock, waits.size() - at)), out);
    }
  }

 private:
  static constexpr std::size_t kBlock = 256;
  static constexpr std::size_t kMany = 8;
  /// A change has 33 bits.
  static constexpr std::size_t kMaxBytes = 5;

  void append_block(std::span<const std::uint32_t> waits, std::string& out) {
    const bool short_changes = find(waits);
    std::array<char, kBlock * kMaxBytes> bytes;
    char* to = bytes.data();
    for (std::size_t i = 0; i < waits.size();) {
      if (short_changes && i + kMany <= waits.size() && are_small(i)) {
        std::memcpy(to, &low_[i], kMany);
        to += kMany;
        i += kMany;
        continue;
      }
      const std::size_t end = std::min(i + kMany, waits.size());
      for (; i < end; ++i) {
        const std::uint32_t before = i == 0 ? before_ : waits[i - 1];
        to = put(short_changes ? changes_[i]
                               : zigzag(std::int64_t{waits[i]} - before),
                 to);
      }
    }
    before_ = waits.back();
    out.append(bytes.data(), to);
  }

  /// False if waits are so long that their changes have more than 32 bits.
  bool find(std::span<const std::uint32_t> waits) {
    std::uint32_t all = before_ | waits[0];
    changes_[0] = waits[0] - before_;
    for (std::size_t i = 1; i < waits.size(); ++i) {
      changes_[i] = waits[i] - waits[i - 1];
      all |= waits[i];
    }
    for (std::size_t i = 0; i < waits.size(); ++i) {
      changes_[i] = changes_[i] << 1 ^ (0 - (changes_[i] >> 31));
      low_[i] = static_cast<std::uint8_t>(changes_[i]);
    }
    return all >> 31 == 0;
  }

  [[nodiscard]] bool are_small(std::size_t at) const {
    std::array<std::uint64_t, kMany / 2> pairs;
    std::memcpy(pairs.data(), &changes_[at], sizeof pairs);
    const std::uint64_t all = pairs[0] | pairs[1] | pairs[2] | pairs[3];
    return (all & 0xffffff80ffffff80U) == 0;
  }

  /// One byte or two without a branch: which of them changes at random.
  static char* put(std::uint64_t value, char* to) {
    for (; value >= 0x4000; value >>= 7) {
      *to++ = static_cast<char>(value | 0x80);
    }
    const bool two = value >= 0x80;
    to[0] = static_cast<char>(value | (two ? 0x80U : 0U));
    to[1] = static_cast<char>(value >> 7);
    return to + (two ? 2 : 1);
  }

  std::uint32_t before_ = 0;
  std::array<std::uint32_t, kBlock> changes_;
  std::array<std::uint8_t, kBlock> low_;
};

class BinaryFormat : public Format {
 public:
  void begin(const StepHead& head, std::string& out) override {
    axes_ = head.axes;
    for (const std::uint8_t byte : kSignature) out += static_cast<char>(byte);
    out += static_cast<char>(kVersion);
    out += static_cast<char>(head.axes + (head.clock > 0 ? kTimedFlag : 0));
    append_varint(out, static_cast<std::uint64_t>(head.step));
    if (head.clock > 0) append_varint(out, head.clock);
    for (int axis = 0; axis < head.axes; ++axis) {
      append_varint(out, zigzag(head.origin[static_cast<std::size_t>(axis)]));
    }
    sum(out, 0);
  }

  void add(const StepRun& run, std::string& out) override {
    const std::size_t begin = out.size();
    for (std::size_t at = 0; at < run.words.size(); at += kMaxRunPart) {
      const std::size_t count =
          std::min<std::size_t>(run.words.size() - at, kMaxRunPart);
      append_varint(out, 2 * count + (run.rapid ? 1 : 0));
      append_words(std::span(run.words).subspan(at, count), out);
      if (run.waits.empty()) continue;
      waits_.append(std::span(run.waits).subspan(at, count), out);
    }
    sum(out, begin);
  }

  void finish(std::string& out) override {
    const std::size_t begin = out.size();
    out += '\0';
    sum(out, begin);
    for (unsigned i = 0; i < 4; ++i) {
      out += static_cast<char>(crc_ >> (8 * i) & 0xff);
    }
  }

 private:
  void append_words(std::span<const StepWord> words, std::string& out) const {
    const std::size_t begin = out.size();
    if (axes_ == 3) {
      out.append(reinterpret_cast<const char*>(words.data()), words.size());
      return;
    }
    out.resize(begin + (words.size() + 1) / 2);
    char* to = out.data() + begin;
    std::size_t i = 0;
    for (; i + 8 <= words.size(); i += 8, to += 4) {
      const std::uint32_t packed = pack_eight(words.data() + i);
      std::memcpy(to, &packed, 4);
    }
    for (; i + 1 < words.size(); i += 2) {
      *to++ = static_cast<char>(words[i] | words[i + 1] << 4);
    }
    if (i < words.size()) *to = static_cast<char>(words[i]);
  }
  void sum(const std::string& out, std::size_t begin) {
    crc_ = codec::crc_bytes(
        {reinterpret_cast<const std::uint8_t*>(out.data()) + begin,
         out.size() - begin},
        crc_);
  }

  int axes_ = 2;
  WaitChanges waits_;
  std::uint32_t crc_ = 0;
};

class Csv : public Format {
 public:
  void begin(const StepHead& head, std::string& out) override {
    axes_ = head.axes;
    out += "# unstep";
    append_head_words(out, head);
    out += '\n';
    out += axes_ == 3 ? "x,y,z,rapid" : "x,y,rapid";
    out += head.clock > 0 ? ",wait\n" : "\n";
  }
  void add(const StepRun& run, std::string& out) override {
    for (std::size_t i = 0; i < run.words.size(); ++i) {
      for (int axis = 0; axis < axes_; ++axis) {
        const int step = step_of(run.words[i], static_cast<std::size_t>(axis));
        out += step < 0 ? "-1," : step > 0 ? "1," : "0,";
      }
      out += run.rapid ? '1' : '0';
      if (!run.waits.empty()) {
        out += ',';
        append_integer(out, run.waits[i]);
      }
      out += '\n';
    }
  }
  void finish(std::string& /*out*/) override {}

 private:
  int axes_ = 2;
};

class Raw : public Format {
 public:
  void begin(const StepHead& /*head*/, std::string& /*out*/) override {}
  void add(const StepRun& run, std::string& out) override {
    out.append(reinterpret_cast<const char*>(run.words.data()),
               run.words.size());
  }
  void finish(std::string& /*out*/) override {}
};

std::unique_ptr<Format> make(StepFormat format) {
  switch (format) {
    case StepFormat::csv: return std::make_unique<Csv>();
    case StepFormat::vcd: return make_vcd();
    case StepFormat::raw: return std::make_unique<Raw>();
    case StepFormat::binary: break;
  }
  return std::make_unique<BinaryFormat>();
}

}  // namespace

void append_head_words(std::string& out, const StepHead& head) {
  out += " step ";
  append_number(out, head.step);
  if (head.clock > 0) {
    out += " clock ";
    append_integer(out, head.clock);
  }
  out += " origin";
  for (int axis = 0; axis < head.axes; ++axis) {
    out += ' ';
    append_integer(out, head.origin[static_cast<std::size_t>(axis)]);
  }
}

/// is_step_word() of all, eight at a time.
bool are_step_words(std::span<const StepWord> words, int axes) {
  constexpr std::uint64_t kBytes = 0x0101010101010101U;
  const auto unused = static_cast<std::uint8_t>(0xffU << (2 * axes));
  std::uint64_t bad = 0;
  std::size_t i = 0;
  for (; i + 8 <= words.size(); i += 8) {
    std::uint64_t all = 0;
    std::memcpy(&all, words.data() + i, 8);
    // Backwards without a step; 0, which alone does not reach 0x80.
    bad |= (all & kBytes * unused) | (all >> 1 & ~all & kBytes * 0x15) |
           (~(all + kBytes * 0x7f) & kBytes * 0x80);
  }
  for (; i < words.size(); ++i) {
    if (!is_step_word(words[i], axes)) return false;
  }
  return bad == 0;
}

Status check_head(const StepHead& head) {
  if (head.axes != 2 && head.axes != 3) {
    return Error{ErrorCode::invalid_argument, "steps have 2 or 3 axes"};
  }
  if (head.step < 1 || head.step > kMaxStepLength) {
    return Error{ErrorCode::out_of_range,
                 "a step is 0.0000001 mm to 109 m long"};
  }
  for (std::size_t axis = 0; axis < kMaxStepAxes; ++axis) {
    const std::int32_t at = head.origin[axis];
    if (at > kMaxCoord || at < -kMaxCoord ||
        (at != 0 && static_cast<int>(axis) >= head.axes)) {
      return Error{ErrorCode::out_of_range, "the origin of the steps"};
    }
  }
  return {};
}

Status check_run(const StepHead& head, const StepRun& run) {
  const bool timed = head.clock > 0;
  if (run.waits.size() != (timed ? run.words.size() : 0)) {
    return Error{ErrorCode::invalid_argument,
                 "as many waits as steps, or none if there is no clock"};
  }
  bool all = are_step_words(run.words, head.axes);
  std::uint32_t none = 0;
  for (const std::uint32_t wait : run.waits) none |= wait == 0 ? 1 : 0;
  all = all && none == 0;
  if (all) return {};
  return Error{ErrorCode::invalid_argument,
               "a word that is no step, or a wait of 0"};
}

}  // namespace steps

struct StepWriter::Impl {
  StepHead head;
  ByteSink sink;
  std::unique_ptr<steps::Format> format;
  std::string out;

  Status flush() {
    const Status done = out.empty() ? Status() : sink(out);
    out.clear();
    return done;
  }
};

StepWriter::StepWriter(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
StepWriter::~StepWriter() = default;
StepWriter::StepWriter(StepWriter&&) noexcept = default;
StepWriter& StepWriter::operator=(StepWriter&&) noexcept = default;

Result<StepWriter> StepWriter::create(StepFormat format, const StepHead& head,
                                      ByteSink sink) {
  if (Status valid = steps::check_head(head); !valid) return valid.error();
  auto impl = std::make_unique<Impl>();
  impl->head = head;
  impl->sink = std::move(sink);
  impl->format = steps::make(format);
  impl->format->begin(head, impl->out);
  return StepWriter(std::move(impl));
}

Status StepWriter::add(const StepRun& run) {
  if (Status valid = steps::check_run(impl_->head, run); !valid) return valid;
  try {
    impl_->format->add(run, impl_->out);
    return impl_->flush();
  } catch (const std::bad_alloc&) {
    return Error{ErrorCode::limit_exceeded, "no memory for the steps"};
  }
}

Status StepWriter::finish() {
  impl_->format->finish(impl_->out);
  return impl_->flush();
}

Result<std::string> write_steps(const StepStream& stream, StepFormat format) {
  std::string out;
  Result<StepWriter> writer =
      StepWriter::create(format, stream.head, [&out](std::string_view bytes) {
        out += bytes;
        return Status();
      });
  if (!writer) return writer.error();
  for (const StepRun& run : stream.runs) {
    if (Status added = writer->add(run); !added) return added.error();
  }
  if (Status done = writer->finish(); !done) return done.error();
  return out;
}

}  // namespace unstep
