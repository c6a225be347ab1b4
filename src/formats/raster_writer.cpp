#include <new>
#include <utility>

#include "formats/raster_sink.h"

namespace unstep {
namespace {

Error no_memory_to_write() {
  return {ErrorCode::limit_exceeded, "no memory to write the image"};
}

SinkResult create_sink(RasterFormat format) {
  switch (format) {
    case RasterFormat::pbm: return create_pbm_sink();
    case RasterFormat::png: return create_png_sink();
    case RasterFormat::tiff: return create_tiff_sink();
  }
  return Error{ErrorCode::invalid_argument, "no such raster format"};
}

}  // namespace

struct RasterWriter::Impl {
  std::unique_ptr<RasterSink> sink;
  bool has_page = false;
};

RasterWriter::RasterWriter(std::unique_ptr<Impl> impl)
    : impl_(std::move(impl)) {}
RasterWriter::~RasterWriter() = default;
RasterWriter::RasterWriter(RasterWriter&&) noexcept = default;
RasterWriter& RasterWriter::operator=(RasterWriter&&) noexcept = default;

Result<RasterWriter> RasterWriter::create(RasterFormat format) {
  try {
    SinkResult sink = create_sink(format);
    if (!sink) return sink.error();
    auto impl = std::make_unique<Impl>();
    impl->sink = std::move(*sink);
    return RasterWriter(std::move(impl));
  } catch (const std::bad_alloc&) {
    return no_memory_to_write();
  }
}

Status RasterWriter::add_page(const Bitmap& ink, const PageInfo& info,
                              std::vector<std::string>* notes) {
  if (ink.pixels() == 0) {
    return Error{ErrorCode::invalid_argument, "an empty page"};
  }
  try {
    std::vector<std::string> unwanted;
    Status added =
        impl_->sink->add_page(ink, info, notes != nullptr ? *notes : unwanted);
    impl_->has_page = impl_->has_page || added;
    return added;
  } catch (const std::bad_alloc&) {
    return no_memory_to_write();
  }
}

Result<std::vector<std::uint8_t>> RasterWriter::finish() {
  if (!impl_->has_page) {
    return Error{ErrorCode::invalid_argument, "no page was added"};
  }
  try {
    return impl_->sink->finish();
  } catch (const std::bad_alloc&) {
    return no_memory_to_write();
  }
}

}  // namespace unstep
