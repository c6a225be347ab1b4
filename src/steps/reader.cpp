#include <algorithm>
#include <new>
#include <string>

#include "codec/byte_reader.h"
#include "codec/checksum.h"
#include "formats/decimal.h"
#include "formats/text_scanner.h"
#include "steps/format.h"
#include "unstep/step_stream.h"

namespace unstep {
namespace steps {
namespace {

constexpr std::uint64_t kMaxWait = 0xffffffffU;

std::span<const std::uint8_t> bytes_of(std::string_view text) {
  return {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()};
}

class BinaryReader {
 public:
  BinaryReader(std::string_view bytes, const StepReadOptions& options)
      : file_(bytes_of(bytes)),
        in_(file_, 0, ErrorCode::truncated),
        out_({}, options.max_steps) {}

  Result<StepStream> read() {
    read_head();
    while (in_.ok()) {
      const std::uint64_t head = in_.varint("a run", 2 * kMaxRunPart + 1);
      if (head == 0 || !in_.ok()) break;
      if (Status done = read_run(head); !done) return done.error();
    }
    const std::uint64_t end = in_.position();
    const std::uint32_t crc = in_.u32("the checksum");
    in_.expect_end("the steps");
    if (!in_.ok()) return in_.error();
    if (codec::crc_bytes(file_.first(static_cast<std::size_t>(end))) != crc) {
      return Error{ErrorCode::checksum_mismatch, "the steps are damaged (CRC)"};
    }
    return out_.take();
  }

 private:
  void read_head() {
    const auto signature = in_.bytes("the signature", kSignature.size());
    if (in_.ok() && !std::ranges::equal(signature, kSignature)) {
      in_.fail(ErrorCode::bad_magic, 0, "not a file of steps");
    }
    if (in_.u8("the version") != kVersion) {
      in_.fail(ErrorCode::unsupported_version, 4, "unknown version of steps");
    }
    const std::uint8_t axes = in_.u8("the axes");
    StepHead& head = out_.head();
    head.axes = axes & 0x0f;
    timed_ = (axes & kTimedFlag) != 0;
    if ((axes & 0xe0) != 0 || (head.axes != 2 && head.axes != 3)) {
      in_.fail(ErrorCode::corrupt, 5, "steps of neither 2 nor 3 axes");
      head.axes = 2;
    }
    head.step = static_cast<std::int64_t>(
        in_.varint("the length of a step", kMaxStepLength));
    if (timed_) {
      head.clock =
          static_cast<std::uint32_t>(in_.varint("the clock", kMaxWait));
    }
    if (head.step == 0 || (timed_ && head.clock == 0)) {
      in_.fail(ErrorCode::corrupt, 6, "a step or a clock of 0");
    }
    for (int axis = 0; axis < head.axes; ++axis) {
      head.origin[static_cast<std::size_t>(axis)] =
          in_.coordinate("the origin");
    }
  }

  Status read_run(std::uint64_t head) {
    const std::uint64_t count = head / 2;
    const bool rapid = (head & 1) != 0;
    const int axes = out_.head().axes;
    const auto packed = in_.bytes("steps", axes == 3 ? count : (count + 1) / 2);
    if (count == 0 && in_.ok()) {
      in_.fail(ErrorCode::corrupt, in_.position(), "a run of no steps");
    }
    if (!in_.ok()) return in_.error();
    for (std::uint64_t i = 0; i < count; ++i) {
      const auto at = static_cast<std::size_t>(i);
      const unsigned word =
          axes == 3 ? packed[at]
                    : unsigned{packed[at / 2]} >> (at % 2 * 4) & 15U;
      if (!is_step_word(word, axes)) {
        in_.fail(ErrorCode::corrupt, in_.position(), "a word that is no step");
        return in_.error();
      }
      std::uint32_t wait = 0;
      if (timed_ && !read_wait(wait)) return in_.error();
      if (Status done = out_.add(rapid, static_cast<StepWord>(word), wait);
          !done) {
        return done;
      }
    }
    if (axes == 2 && count % 2 == 1 && packed.back() >> 4 != 0) {
      in_.fail(ErrorCode::corrupt, in_.position(), "bits after the last step");
      return in_.error();
    }
    return {};
  }

  bool read_wait(std::uint32_t& wait) {
    const std::uint64_t z = in_.varint("a wait", 2 * kMaxWait + 1);
    const auto half = static_cast<std::int64_t>(z / 2);
    wait_ += (z & 1) != 0 ? -half - 1 : half;
    if (wait_ < 1 || wait_ > static_cast<std::int64_t>(kMaxWait)) {
      in_.fail(ErrorCode::corrupt, in_.position(), "a wait out of its range");
    }
    wait = static_cast<std::uint32_t>(wait_);
    return in_.ok();
  }

  std::span<const std::uint8_t> file_;
  codec::ByteReader in_;
  Collector out_;
  bool timed_ = false;
  std::int64_t wait_ = 0;
};

Result<StepStream> read_raw(std::string_view bytes,
                            const StepReadOptions& options) {
  StepHead head = options.head;
  head.clock = 0;
  if (Status valid = check_head(head); !valid) return valid.error();
  Collector out(head, options.max_steps);
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    const auto word = static_cast<std::uint8_t>(bytes[i]);
    if (!is_step_word(word, head.axes)) {
      return codec::error_at(ErrorCode::corrupt, i, "a word that is no step");
    }
    if (Status done = out.add(false, word, 0); !done) return done.error();
  }
  return out.take();
}

}  // namespace

Status Collector::claim(std::uint64_t count) {
  if (count <= left_) {
    left_ -= count;
    return {};
  }
  return Error{ErrorCode::limit_exceeded, "more steps than allowed"};
}

Status Collector::add(bool rapid, StepWord word, std::uint32_t wait) {
  if (Status fits = claim(1); !fits) return fits;
  if (stream_.runs.empty() || stream_.runs.back().rapid != rapid) {
    stream_.runs.emplace_back().rapid = rapid;
  }
  StepRun& run = stream_.runs.back();
  run.words.push_back(word);
  if (stream_.head.clock > 0) run.waits.push_back(wait);
  return {};
}

bool read_head_words(std::string_view line, StepHead& head) {
  TextScanner in(line);
  StepHead found = head;
  while (true) {
    in.skip_blanks();
    const std::string_view rest = in.rest();
    const std::size_t end = std::min(rest.find_first_of(" \t\r"), rest.size());
    const std::string_view word = rest.substr(0, end);
    if (word.empty()) break;
    in.skip(end);
    in.skip_blanks();
    if (word == "step") {
      const auto value = in.number();
      if (!value || !(*value > 0) || !(*value < 1.1e5)) return false;
      found.step = std::llround(*value * 1e7);
    } else if (word == "clock") {
      const auto value = in.number();
      if (!value || !(*value >= 1) || !(*value <= 4294967295.0)) return false;
      found.clock = static_cast<std::uint32_t>(*value);
    } else if (word == "origin") {
      for (std::size_t axis = 0; axis < kMaxStepAxes; ++axis) {
        in.skip_blanks();
        const auto value = in.number();
        if (!value) break;
        if (!(std::abs(*value) <= kMaxCoord)) return false;
        found.origin[axis] = static_cast<std::int32_t>(*value);
      }
    }
  }
  if (found.step < 1) return false;
  head = found;
  return true;
}

}  // namespace steps

StepFormat recognise_steps(std::string_view bytes) {
  const std::string_view signature(
      reinterpret_cast<const char*>(steps::kSignature.data()),
      steps::kSignature.size());
  if (bytes.starts_with(signature)) return StepFormat::binary;
  TextScanner in(bytes);
  in.skip_blanks();
  if (in.peek() == '$') return StepFormat::vcd;
  return in.peek() == '#' || is_letter(in.peek()) ? StepFormat::csv
                                                  : StepFormat::raw;
}

Result<StepStream> read_steps(std::string_view bytes, StepFormat format,
                              const StepReadOptions& options) {
  try {
    switch (format) {
      case StepFormat::csv: return steps::read_csv(bytes, options);
      case StepFormat::vcd: return steps::read_vcd(bytes, options);
      case StepFormat::raw: return steps::read_raw(bytes, options);
      case StepFormat::binary: break;
    }
    return steps::BinaryReader(bytes, options).read();
  } catch (const std::bad_alloc&) {
    return Error{ErrorCode::limit_exceeded, "no memory for the steps"};
  }
}

}  // namespace unstep
