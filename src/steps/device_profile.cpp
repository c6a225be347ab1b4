#include <algorithm>
#include <cstdlib>
#include <new>
#include <string>

#include "codec/byte_reader.h"
#include "codec/checksum.h"
#include "firmware/unstep_steps.h"
#include "interpolate/arc_walk.h"
#include "steps/exact_lines.h"
#include "steps/format.h"
#include "steps/grid_moves.h"
#include "unstep/step_stream.h"

/// docs/format.md, "Device profile".
namespace unstep {
namespace {

constexpr std::uint8_t kLine = 1;
constexpr std::uint8_t kArc = 2;
constexpr std::uint8_t kRapidBit = 4;
constexpr std::int64_t kMost = std::int64_t{1} << 15;  ///< parts are below
constexpr std::uint64_t kMostSteps = std::uint64_t{1} << 26;

class ProfileWriter {
 public:
  Status add(const steps::GridMove& move) {
    return move.is_arc ? add_arc(move) : add_line(move);
  }

  std::string finish() {
    out_ += '\0';
    const std::uint32_t crc = codec::crc_bytes(
        {reinterpret_cast<const std::uint8_t*>(out_.data()), out_.size()});
    append(crc, 4);
    return std::move(out_);
  }

 private:
  void append(std::uint32_t value, int bytes) {
    for (int i = 0; i < bytes; ++i) {
      out_ += static_cast<char>(value >> (8 * i) & 0xff);
    }
  }
  void head(std::uint8_t kind, bool rapid, int bytes, int rest) {
    out_ += static_cast<char>(kind | (rapid ? kRapidBit : 0) |
                              (bytes - 1) << 3 | rest);
  }
  /// What the numbers of a record do not hold, in lines that make the same
  /// steps.
  Status add_pieces(const steps::GridMove& move, std::uint64_t count) {
    if (count > kMostSteps) {
      return Error{ErrorCode::out_of_range,
                   "a motion of more than 2^26 steps is too large for the "
                   "device profile"};
    }
    std::vector<Step> codes;
    InterpolatorOptions how;
    how.combined = true;
    const Segment whole{move.delta[0], move.delta[1]};
    Result<Interpolator> drawn =
        move.is_arc ? Interpolator::arc(Method::circular, move.arc, how)
                    : Interpolator::line(Method::evaluation8, whole, how);
    if (!drawn) return drawn.error();
    for (Tick t = drawn->next(); t.kind != Tick::Kind::done;
         t = drawn->next()) {
      if (t.kind == Tick::Kind::step) codes.push_back(t.step);
    }
    steps::LineSearch search(codes, Method::evaluation8, kMost - 1);
    for (std::size_t at = 0; at < codes.size();) {
      Segment line;
      at += search.longest(at, line);
      put_line(line, move.rapid);
    }
    return {};
  }

  void put_line(const Segment& line, bool rapid) {
    const std::int32_t size = std::max(std::abs(line.dx), std::abs(line.dy));
    const int bytes = size < 128 ? 1 : 2;
    head(kLine, rapid, bytes, 0);
    append(static_cast<std::uint32_t>(line.dx), bytes);
    append(static_cast<std::uint32_t>(line.dy), bytes);
  }

  Status add_line(const steps::GridMove& move) {
    const std::int64_t size = std::max(std::abs(std::int64_t{move.delta[0]}),
                                       std::abs(std::int64_t{move.delta[1]}));
    if (size >= kMost) {
      return add_pieces(move, static_cast<std::uint64_t>(size));
    }
    put_line({move.delta[0], move.delta[1]}, move.rapid);
    return {};
  }

  Status add_arc(const steps::GridMove& move) {
    const Result<interpolation::ArcGeometry> arc =
        interpolation::check_arc(move.arc);
    if (!arc) return arc.error();
    const interpolation::ArcFrame frame = interpolation::ArcWalk(*arc).frame();
    const std::int64_t size = std::max(
        {frame.a, frame.b, frame.axis_radius, frame.end_a, frame.end_b});
    if (size >= kMost) {
      // A turn has less than 8 steps for each of its radius.
      return add_pieces(move, 8 * static_cast<std::uint64_t>(size));
    }
    const int bytes = size < 128 ? 1 : 2;
    head(kArc, move.rapid, bytes, (frame.mirrored ? 32 : 0) | frame.turns << 6);
    out_ += static_cast<char>(frame.crossings);
    for (const std::int64_t part :
         {frame.a, frame.b, frame.axis_radius, frame.end_a, frame.end_b}) {
      append(static_cast<std::uint32_t>(part), bytes);
    }
    return {};
  }

  std::string out_;
};

}  // namespace

Result<std::string> write_device_profile(const Program& program,
                                         const StepMakeOptions& options) {
  StepMakeOptions how = options;
  how.axes = 2;
  how.method = Method::evaluation8;
  if (Status valid = steps::check_head(step_head(how)); !valid) {
    return valid.error();
  }
  try {
    const Result<std::vector<steps::GridMove>> moves =
        steps::grid_moves(program, how);
    if (!moves) return moves.error();
    ProfileWriter writer;
    for (const steps::GridMove& move : *moves) {
      if (Status added = writer.add(move); !added) return added.error();
    }
    return writer.finish();
  } catch (const std::bad_alloc&) {
    return Error{ErrorCode::limit_exceeded, "no memory for the steps"};
  }
}

Result<StepStream> read_device_profile(std::string_view bytes,
                                       const StepReadOptions& options) {
  StepHead head = options.head;
  head.axes = 2;
  head.clock = 0;
  head.origin[2] = 0;
  if (Status valid = steps::check_head(head); !valid) return valid.error();
  const auto* data = reinterpret_cast<const std::uint8_t*>(bytes.data());
  if (bytes.size() > 0xffffffffU) {
    return Error{ErrorCode::limit_exceeded, "a device profile above 4 GiB"};
  }
  try {
    steps::Collector out(head, options.max_steps);
    unstep_steps state;
    unstep_steps_begin(&state, data, static_cast<std::uint32_t>(bytes.size()));
    std::uint8_t word = unstep_steps_next(&state);
    for (; word < UNSTEP_STEPS_MORE; word = unstep_steps_next(&state)) {
      const auto step = static_cast<StepWord>(word & 15);
      if (Status done = out.add((word & 16) != 0, step, 0); !done) {
        return done.error();
      }
    }
    const auto at = static_cast<std::uint64_t>(state.next - data);
    if (word == UNSTEP_STEPS_MORE) {
      return codec::error_at(ErrorCode::truncated, at,
                             "the device profile ends within a record");
    }
    if (word == UNSTEP_STEPS_BAD) {
      return codec::error_at(ErrorCode::corrupt, at, "no record of a profile");
    }
    codec::ByteReader tail({data + at + 1, bytes.size() - at - 1}, at + 1,
                           ErrorCode::truncated);
    const std::uint32_t crc = tail.u32("the checksum");
    tail.expect_end("the device profile");
    if (!tail.ok()) return tail.error();
    if (codec::crc_bytes({data, static_cast<std::size_t>(at + 1)}) != crc) {
      return Error{ErrorCode::checksum_mismatch,
                   "the device profile is damaged (CRC)"};
    }
    return out.take();
  } catch (const std::bad_alloc&) {
    return Error{ErrorCode::limit_exceeded, "no memory for the steps"};
  }
}

}  // namespace unstep
