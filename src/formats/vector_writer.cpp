#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "formats/format_writer.h"
#include "formats/outline.h"

namespace unstep {
namespace {

WriterFactory factory_of(VectorFormat format) {
  switch (format) {
    case VectorFormat::svg: return make_svg_writer;
    case VectorFormat::dxf: return make_dxf_writer;
    case VectorFormat::hpgl: return make_hpgl_writer;
    case VectorFormat::pdf: return make_pdf_writer;
    case VectorFormat::json: return make_json_writer;
    case VectorFormat::freeman: return make_freeman_writer;
  }
  return nullptr;
}

bool has_size(const Canvas& canvas) {
  return canvas.width > 0 && canvas.height > 0;
}

/// What is drawn.
Result<WideBox> box_of(const Drawing& drawing) {
  constexpr std::int64_t kFar = std::numeric_limits<std::int64_t>::max();
  WideBox box{{kFar, kFar}, {-kFar, -kFar}};
  Outline outline;
  const YAxis axis = drawing.canvas.y_axis;
  for (const Chain& chain : drawing.chains) {
    if (Status valid = check_chain(chain, axis); !valid) return valid.error();
    to_outline(chain, axis, drawing.scale, {}, outline);
    extend(box, outline);
  }
  for (const Path& path : drawing.paths) {
    if (Status valid = check_path(path); !valid) return valid.error();
    to_outline(path, {}, outline);
    extend(box, outline);
  }
  if (box.low.x > box.high.x) return WideBox{};
  return box;
}

Error misuse(const char* message) {
  return {ErrorCode::invalid_argument, message};
}

}  // namespace

Status VectorOutput::flush() {
  if (text.empty()) return {};
  Status written = sink_(text);
  flushed_ += text.size();
  text.clear();
  return written;
}

void VectorOutput::note(const std::string& line) {
  for (const std::string& known : notes_) {
    if (known == line) return;
  }
  notes_.push_back(line);
}

struct VectorWriter::Impl {
  explicit Impl(ByteSink sink) : output(std::move(sink)) {}

  VectorOutput output;
  std::unique_ptr<FormatWriter> writer;
  bool in_page = false;
  bool failed = false;
  YAxis axis = YAxis::down;  ///< of the page's drawing

  Status begin(const Canvas& canvas, std::int32_t scale, Paint paint,
               const PageInfo& info, std::optional<WideBox> box);
  Status after(Status status);
};

/// Keeps that a call failed: what follows would not be a file.
Status VectorWriter::Impl::after(Status status) {
  if (!status) failed = true;
  return status;
}

Status VectorWriter::Impl::begin(const Canvas& canvas, std::int32_t scale,
                                 Paint paint, const PageInfo& info,
                                 std::optional<WideBox> box) {
  if (failed || in_page) return misuse("a page begun out of order");
  if (scale < 1 || scale > Drawing::kMaxScale) {
    return Error{ErrorCode::out_of_range, "a scale outside 1 to 1048576"};
  }
  if (canvas.width < 0 || canvas.height < 0 || canvas.width > kMaxCoord ||
      canvas.height > kMaxCoord) {
    return Error{ErrorCode::out_of_range, "a canvas of impossible size"};
  }
  in_page = true;
  axis = canvas.y_axis;
  if (has_size(canvas)) {
    box = WideBox{{0, 0},
                  {std::int64_t{canvas.width} * scale,
                   std::int64_t{canvas.height} * scale}};
  }
  return writer->begin_page({canvas, scale, paint, info, box});
}

Result<VectorWriter> VectorWriter::create(VectorFormat format, ByteSink sink) {
  const WriterFactory make = factory_of(format);
  if (make == nullptr) {
    return Error{ErrorCode::unsupported, "no writer for this format"};
  }
  auto impl = std::make_unique<Impl>(std::move(sink));
  impl->writer = make(impl->output);
  return VectorWriter(std::move(impl));
}

VectorWriter::VectorWriter(std::unique_ptr<Impl> impl)
    : impl_(std::move(impl)) {}
VectorWriter::~VectorWriter() = default;
VectorWriter::VectorWriter(VectorWriter&&) noexcept = default;
VectorWriter& VectorWriter::operator=(VectorWriter&&) noexcept = default;

Status VectorWriter::begin_page(const Canvas& canvas, std::int32_t scale,
                                Paint paint, const PageInfo& info) {
  return impl_->after(impl_->begin(canvas, scale, paint, info, {}));
}

Status VectorWriter::add(const Path& path) {
  if (impl_->failed || !impl_->in_page) return misuse("a path outside a page");
  Status done = check_path(path);
  if (done) done = impl_->writer->add(path);
  if (done) done = impl_->output.flush_if_full();
  return impl_->after(done);
}

Status VectorWriter::add(const Chain& chain) {
  if (impl_->failed || !impl_->in_page) return misuse("a chain outside a page");
  Status done = check_chain(chain, impl_->axis);
  if (done) done = impl_->writer->add(chain);
  if (done) done = impl_->output.flush_if_full();
  return impl_->after(done);
}

Status VectorWriter::end_page() {
  if (impl_->failed || !impl_->in_page) return misuse("no page to end");
  impl_->in_page = false;
  return impl_->after(impl_->writer->end_page());
}

Status VectorWriter::finish() {
  if (impl_->failed || impl_->in_page) return misuse("finished out of order");
  if (Status ended = impl_->writer->finish(); !ended) {
    return impl_->after(ended);
  }
  return impl_->after(impl_->output.flush());
}

Status VectorWriter::add_page(const Drawing& drawing, const PageInfo& info) {
  std::optional<WideBox> box;
  if (!has_size(drawing.canvas)) {
    const Result<WideBox> drawn = box_of(drawing);
    if (!drawn) return impl_->after(drawn.error());
    box = *drawn;
  }
  Status done = impl_->after(
      impl_->begin(drawing.canvas, drawing.scale, drawing.paint, info, box));
  if (!done) return done;
  for (const Chain& chain : drawing.chains) {
    if (Status added = add(chain); !added) return added;
  }
  for (const Path& path : drawing.paths) {
    if (Status added = add(path); !added) return added;
  }
  return end_page();
}

const std::vector<std::string>& VectorWriter::notes() const {
  return impl_->output.notes();
}

}  // namespace unstep
