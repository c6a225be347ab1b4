#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "unstep/grid.h"
#include "unstep/interpolate.h"
#include "unstep/result.h"

/// Reverse interpolation: unit steps become segments.
///
///     DeviceReverse device;
///     Segment segment;
///     for (Step step : stream)
///       if (device.push(step, segment) == Pushed::segment) use(segment);
///     if (device.finish(segment)) use(segment);
namespace unstep {

/// What a pushed step did.
enum class Pushed : std::uint8_t {
  open,     ///< it joined the open segment
  segment,  ///< a segment was closed and written
  refused,  ///< not a step of the method; nothing changed
};

/// A2 of SU 1089551. Drawing the segments with Method::device stays within
/// one unit of the chain on each axis at the same step index. Lossy.
///
/// A step that breaks the segment is its last step. A change of sign on an
/// axis closes the segment *before* that step, which opens the next one. A
/// full counter closes the segment too. Diagonal steps (odd codes) are
/// refused. `Device` is DeviceRegisters or GateNet.
template <class Device>
class BasicDeviceReverse {
 public:
  /// Counters hold at most `capacity`, 2..2^31 - 1.
  explicit BasicDeviceReverse(
      std::int32_t capacity = std::numeric_limits<std::int32_t>::max())
      : capacity_(capacity) {}

  /// Takes one step in constant time. `closed` is written when the result is
  /// Pushed::segment; one step closes at most one segment.
  Pushed push(Step step, Segment& closed) {
    if (step > 7 || (step & 1) != 0) return Pushed::refused;
    const bool negative = (step & 4) != 0;
    return (step & 2) != 0 ? push_axis<true>(negative, closed)
                           : push_axis<false>(negative, closed);
  }

  /// End of message. True if a segment was open: it is written and the device
  /// is ready for the next message.
  bool finish(Segment& closed) {
    if (read_out_) clear();
    const DeviceRegisters last = device_.registers();
    if ((last.x | last.y) == 0) return false;
    closed = read();
    clear();
    return true;
  }

  /// The device after the last push, a breaking step's sums included (they
  /// are cleared when the next step arrives).
  [[nodiscard]] const Device& device() const { return device_; }

 private:
  template <bool vertical>
  Pushed push_axis(bool negative, Segment& closed) {
    if (read_out_) clear();
    bool& sign = vertical ? negative_y_ : negative_x_;
    Pushed result = Pushed::open;
    if (sign != negative) {
      if (count<vertical>() > 0) {
        closed = read();
        clear();
        result = Pushed::segment;
      }
      sign = negative;
    }
    using Axis = DeviceRegisters::Axis;
    const bool breaks = device_.accept(vertical ? Axis::y : Axis::x);
    if (breaks || count<vertical>() == capacity_) {
      closed = read();
      read_out_ = true;
      result = Pushed::segment;
    }
    return result;
  }

  template <bool vertical>
  [[nodiscard]] std::int64_t count() const {
    const DeviceRegisters now = device_.registers();
    return vertical ? now.y : now.x;
  }

  [[nodiscard]] Segment read() const {
    const DeviceRegisters now = device_.registers();
    const auto x = static_cast<std::int32_t>(now.x);
    const auto y = static_cast<std::int32_t>(now.y);
    return {negative_x_ ? -x : x, negative_y_ ? -y : y};
  }

  void clear() {
    device_.clear();
    read_out_ = false;
  }

  Device device_;
  std::int32_t capacity_;
  bool negative_x_ = false;
  bool negative_y_ = false;
  bool read_out_ = false;  ///< the sums belong to a segment already read out
};

/// Register level: the one to use.
using DeviceReverse = BasicDeviceReverse<DeviceRegisters>;
/// Gate level (A3): for teaching and for tests.
using GateReverse = BasicDeviceReverse<GateNet>;

/// A2 over a whole chain. invalid_argument naming the step's index if a step
/// is diagonal or no Freeman code.
Result<std::vector<Segment>> reverse_device(std::span<const Step> steps);

/// Exact reverse interpolation: the longest digital straight segments, one
/// after the other, found with the first step that does not fit. interpolate()
/// of the segments gives exactly the steps. Constant memory, constant time per
/// step. I. Debled-Rennesson and J.-P. Reveilles, "A linear algorithm for
/// segmentation of digital curves", 1995.
///
///     ExactReverse exact(Connectivity::eight);
///     DigitalSegment segment;
///     for (Step step : stream)
///       if (exact.push(step, segment) == Pushed::segment) use(segment);
///     if (exact.finish(segment)) use(segment);
///
/// A segment has at most 2^32 - 1 steps; a longer one is split there. In every
/// segment found s0 is its first step, gcd(a, w) is 1 and w <= n; a segment of
/// equal steps has s1 == s0, a == 0, w == 1.
class ExactReverse {
 public:
  explicit ExactReverse(Connectivity connectivity);

  /// Takes one step. Pushed::segment: `closed` is the segment before this
  /// step, which opens the next one. Pushed::refused, nothing changed, if the
  /// step is no code of the connectivity.
  Pushed push(Step step, DigitalSegment& closed);

  /// The segment of the steps since the last one closed; n == 0 if there are
  /// none.
  [[nodiscard]] DigitalSegment open() const;

  /// End of message. True if a segment was open: it is written, and the next
  /// message may begin.
  bool finish(DigitalSegment& closed);

 private:
  static constexpr std::size_t kStateBytes = 128;
  alignas(8) std::array<std::byte, kStateBytes> state_{};
};

/// The segments of a whole chain. On a closed chain the first segment may
/// start anywhere: `start` is the index of its first step, and segments run
/// across the chain's own end; 0 on open chains.
struct DigitalSegments {
  std::size_t start = 0;
  std::vector<DigitalSegment> segments;
};

/// Greedy and maximal: no segment but the last could be a step longer. On an
/// open chain that is the least number of segments, the same as ExactReverse
/// gives. On a closed chain the start is chosen so that their number is the
/// least of all starts; only where looking for it would take more than eight
/// laps it may be one more. Linear time.
/// invalid_argument naming the step's index if it does not fit the
/// connectivity.
Result<DigitalSegments> reverse_exact(const Chain& chain);

/// What lines within a tolerance are to be.
enum class LineAim : std::uint8_t {
  few_lines,  ///< as ToleranceOptions::effort says
  few_bytes,  ///< cheap for UstpWriter; more lines than need be
};

struct ToleranceOptions {
  /// Euclidean Frechet distance between the chain and the path, in grid
  /// units, before rasterising: never more than this. From 1/256 to 2^20.
  Rational tolerance{1, 1};
  /// standard: one pass, vertices on points of the chain; below 1 free ones on
  /// the sub-grid. max: as few segments as there can be, and free vertices
  /// where they save some. fast is the same as standard.
  Effort effort = Effort::standard;
  bool arcs = true;  ///< arcs where one replaces several lines
  /// few_bytes: vertices are free, and closed paths start at their topmost
  /// vertex, where the coder of paths begins. It takes a hundred times as long
  /// as one pass or more. fast: few_lines. max: more is tried, several times as
  /// long.
  LineAim aim = LineAim::few_lines;
  /// Lines may cross where the chains do not, at any tolerance: for strokes,
  /// which lie on each other as they are.
  bool may_cross = false;
};

/// What reverse_tolerance did.
struct ToleranceReport {
  std::uint64_t segments = 0;
  std::uint64_t arcs = 0;
  /// Paths that were made finer because they met themselves or each other
  /// although the chains did not.
  std::uint64_t refined = 0;
};

/// The chains of `drawing` as paths within the tolerance, in their order; the
/// result has the canvas of `drawing` and no chains. Ends of open chains are
/// kept, closed chains stay closed and may start elsewhere. No line has length
/// 0 or spans more than 2^24 path units. Closed chains of up to 8 steps keep
/// their corners; a larger one that encloses ink keeps an inside.
/// At a tolerance of at most 1, contours that were simple do not cross
/// themselves or each other, unless they may.
/// invalid_argument for chains that are not valid or a drawing with paths,
/// out_of_range for the tolerance.
Result<Drawing> reverse_tolerance(const Drawing& drawing,
                                  const ToleranceOptions& options,
                                  ToleranceReport* report = nullptr);

/// One chain alone. The path's coordinates are in 1 / path_scale(tolerance)
/// grid units, as those of the drawing above.
Result<Path> reverse_tolerance(const Chain& chain, YAxis axis,
                               const ToleranceOptions& options);

/// Path units per grid unit for this tolerance: 1 from 1 up, a power of two
/// below.
[[nodiscard]] std::int32_t path_scale(const Rational& tolerance);

}  // namespace unstep
