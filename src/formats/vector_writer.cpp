#include <limits>
#include <new>
#include <string>
#include <utility>

#include "formats/format_writer.h"
#include "formats/outline.h"

namespace unstep {
namespace {

constexpr std::int64_t kFar = std::numeric_limits<std::int64_t>::max();

WriterFactory factory_of(VectorFormat format) {
  switch (format) {
    case VectorFormat::svg: return make_svg_writer;
    default: return nullptr;
  }
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
  std::int32_t scale = 1;
  Frame frame;
  Outline outline;  ///< reused

  [[nodiscard]] Frame frame_for(const Canvas& canvas,
                                std::int32_t page_scale) const {
    const bool flip = canvas.y_axis != writer->y_axis();
    return {flip, flip ? std::int64_t{canvas.height} * page_scale : 0};
  }
  Status begin(const Canvas& canvas, std::int32_t page_scale, Paint paint,
               const PageInfo& info, const WideBox* box);
  Status add_outline();
  Status after(Status status);
  [[nodiscard]] Status box_of(const Drawing& drawing, WideBox& box);
};

/// Keeps that a call failed: what follows would not be a file.
Status VectorWriter::Impl::after(Status status) {
  if (!status) failed = true;
  return status;
}

Status VectorWriter::Impl::begin(const Canvas& canvas, std::int32_t page_scale,
                                 Paint paint, const PageInfo& info,
                                 const WideBox* box) {
  if (failed || in_page) return misuse("a page begun out of order");
  if (page_scale < 1 || page_scale > Drawing::kMaxScale) {
    return Error{ErrorCode::out_of_range, "a scale outside 1 to 1048576"};
  }
  if (canvas.width < 0 || canvas.height < 0 || canvas.width > kMaxCoord ||
      canvas.height > kMaxCoord) {
    return Error{ErrorCode::out_of_range, "a canvas of impossible size"};
  }
  in_page = true;
  axis = canvas.y_axis;
  scale = page_scale;
  frame = frame_for(canvas, page_scale);
  PageHead head{canvas, page_scale, paint, info, {}, true};
  if (canvas.width > 0 && canvas.height > 0) {
    head.box = {{0, 0},
                {std::int64_t{canvas.width} * page_scale,
                 std::int64_t{canvas.height} * page_scale}};
  } else if (box != nullptr) {
    head.box = *box;
  } else {
    head.has_box = false;
  }
  return writer->begin_page(head);
}

Status VectorWriter::Impl::add_outline() {
  if (Status added = writer->add(outline); !added) return added;
  return output.flush_if_full();
}

/// What is drawn on a canvas without size.
Status VectorWriter::Impl::box_of(const Drawing& drawing, WideBox& box) {
  const Frame flipped = frame_for(drawing.canvas, drawing.scale);
  box = {{kFar, kFar}, {-kFar, -kFar}};
  for (const Chain& chain : drawing.chains) {
    if (Status valid = check_chain(chain, drawing.canvas.y_axis); !valid) {
      return valid;
    }
    to_outline(chain, drawing.canvas.y_axis, drawing.scale, flipped, outline);
    extend(box, outline);
  }
  for (const Path& path : drawing.paths) {
    if (Status valid = check_path(path); !valid) return valid;
    to_outline(path, flipped, outline);
    extend(box, outline);
  }
  if (box.low.x > box.high.x) box = {};
  return {};
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
  return impl_->after(impl_->begin(canvas, scale, paint, info, nullptr));
}

Status VectorWriter::add(const Path& path) {
  if (impl_->failed || !impl_->in_page) return misuse("a path outside a page");
  if (Status valid = check_path(path); !valid) return impl_->after(valid);
  to_outline(path, impl_->frame, impl_->outline);
  return impl_->after(impl_->add_outline());
}

Status VectorWriter::add(const Chain& chain) {
  if (impl_->failed || !impl_->in_page) return misuse("a chain outside a page");
  if (Status valid = check_chain(chain, impl_->axis); !valid) {
    return impl_->after(valid);
  }
  to_outline(chain, impl_->axis, impl_->scale, impl_->frame, impl_->outline);
  return impl_->after(impl_->add_outline());
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
  const Canvas& canvas = drawing.canvas;
  WideBox box;
  const bool unbounded = canvas.width == 0 || canvas.height == 0;
  if (unbounded) {
    if (Status known = impl_->box_of(drawing, box); !known) {
      return impl_->after(known);
    }
  }
  Status done = impl_->after(impl_->begin(canvas, drawing.scale, drawing.paint,
                                          info, unbounded ? &box : nullptr));
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
