#pragma once

#include <cmath>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "unstep/formats.h"

/// What the writers of the vector formats share. VectorWriter has checked the
/// order of the calls and every path before a FormatWriter sees them.
namespace unstep {

/// A place or a move in path units. A chain's coordinates times the scale are
/// below 2^30 * 2^20, so nothing here comes near the end of int64.
struct WidePoint {
  std::int64_t x = 0;
  std::int64_t y = 0;
  friend bool operator==(const WidePoint&, const WidePoint&) = default;
  friend WidePoint operator+(WidePoint a, WidePoint b) {
    return {a.x + b.x, a.y + b.y};
  }
  friend WidePoint operator-(WidePoint a, WidePoint b) {
    return {a.x - b.x, a.y - b.y};
  }
};

/// A smallest box around what is drawn.
struct WideBox {
  WidePoint low;
  WidePoint high;
};

/// A segment or an arc as a move in the y direction of the format.
struct Piece {
  bool is_arc = false;
  WidePoint end;
  WidePoint centre;        ///< arcs
  bool ascending = false;  ///< arcs: angle grows from +x to +y
  [[nodiscard]] bool is_circle() const { return is_arc && end == WidePoint{}; }
};

/// A path in path units and the y direction of the format.
struct Outline {
  WidePoint origin;
  bool closed = false;
  std::int64_t width = 0;
  std::vector<Piece> pieces;
};

/// The page of a format whose y grows to `axis`.
struct PageHead {
  Canvas canvas;
  std::int32_t scale = 1;
  Paint paint = Paint::fill;
  PageInfo info;
  /// What is drawn, if the canvas has no size and it is known, in path units
  /// and the y direction of the format; else the canvas.
  WideBox box;
  bool has_box = false;  ///< false: unbounded, and not known beforehand
};

/// The bytes on their way to the sink, and the notes.
class VectorOutput {
 public:
  explicit VectorOutput(ByteSink sink) : sink_(std::move(sink)) {}

  /// Append here, then call flush_if_full.
  std::string text;

  Status flush();
  Status flush_if_full() { return text.size() < kFull ? Status{} : flush(); }
  /// Bytes given to the sink and waiting in `text`.
  [[nodiscard]] std::uint64_t size() const { return flushed_ + text.size(); }

  void note(const std::string& line);
  [[nodiscard]] const std::vector<std::string>& notes() const { return notes_; }

 private:
  static constexpr std::size_t kFull = std::size_t{1} << 16;
  ByteSink sink_;
  std::uint64_t flushed_ = 0;
  std::vector<std::string> notes_;
};

/// One format. y_axis() says which way its y grows.
class FormatWriter {
 public:
  virtual ~FormatWriter() = default;
  [[nodiscard]] virtual YAxis y_axis() const { return YAxis::up; }
  virtual Status begin_page(const PageHead& head) = 0;
  virtual Status add(const Outline& outline) = 0;
  virtual Status end_page() = 0;
  virtual Status finish() = 0;
};

using WriterFactory = std::unique_ptr<FormatWriter> (*)(VectorOutput& output);
std::unique_ptr<FormatWriter> make_svg_writer(VectorOutput& output);

}  // namespace unstep
