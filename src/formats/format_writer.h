#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "formats/outline.h"
#include "unstep/formats.h"

/// What the writers of the vector formats share. VectorWriter has checked the
/// order of the calls and every path before a FormatWriter sees them.
namespace unstep {

/// A page as it begins.
struct PageHead {
  Canvas canvas;
  std::int32_t scale = 1;
  Paint paint = Paint::fill;
  PageInfo info;
  /// The canvas or, if it has no size, what is drawn, in path units. Nothing if
  /// that is not known beforehand.
  std::optional<WideBox> box;
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

/// One format. Paths and chains are valid; chains and paths come in order.
class FormatWriter {
 public:
  virtual ~FormatWriter() = default;
  virtual Status begin_page(const PageHead& head) = 0;
  virtual Status add(const Path& path) = 0;
  virtual Status add(const Chain& chain) = 0;
  virtual Status end_page() = 0;
  virtual Status finish() = 0;
};

using WriterFactory = std::unique_ptr<FormatWriter> (*)(VectorOutput& output);
std::unique_ptr<FormatWriter> make_svg_writer(VectorOutput& output);
std::unique_ptr<FormatWriter> make_dxf_writer(VectorOutput& output);
std::unique_ptr<FormatWriter> make_hpgl_writer(VectorOutput& output);
std::unique_ptr<FormatWriter> make_pdf_writer(VectorOutput& output);
std::unique_ptr<FormatWriter> make_json_writer(VectorOutput& output);
std::unique_ptr<FormatWriter> make_freeman_writer(VectorOutput& output);

}  // namespace unstep
