#include "cli/page_writer.h"

#include <optional>
#include <utility>

#include "cli/reshape.h"
#include "unstep/trace.h"

namespace unstep::cli {

struct PageWriter::Impl {
  ByteSink sink;
  LineOptions lines;
  Effort effort = Effort::standard;
  DecodeLimits limits;
  bool freeman = false;
  bool program = false;
  std::optional<RasterWriter> raster;
  std::optional<VectorWriter> vector;
  std::size_t notes_taken = 0;

  Status add_ink(const Page& page, std::vector<std::string>& notes);
  Status add_drawing(Page page, std::vector<std::string>& notes);
  Status add_contours(const Page& page);
};

Status PageWriter::Impl::add_ink(const Page& page,
                                 std::vector<std::string>& notes) {
  if (page.kind == PageKind::ink) {
    return raster->add_page(page.ink, page.info, &notes);
  }
  const Result<Bitmap> ink = to_ink(page, limits, notes);
  if (!ink) return ink.error();
  return raster->add_page(*ink, page.info, &notes);
}

/// Without a list of all contours in memory: pages may be huge.
Status PageWriter::Impl::add_contours(const Page& page) {
  const Canvas canvas{page.ink.width(), page.ink.height(), YAxis::down};
  if (Status begun = vector->begin_page(canvas, 1, Paint::fill, page.info);
      !begun) {
    return begun;
  }
  Status added;
  const Status traced = trace_contours(page.ink, [&](const Chain& contour) {
    added = vector->add(contour);
    return static_cast<bool>(added);
  });
  if (!added) return added;
  if (!traced) return traced;
  return vector->end_page();
}

Status PageWriter::Impl::add_drawing(Page page,
                                     std::vector<std::string>& notes) {
  Status added;
  const bool contours = lines.method == LineOptions::Method::none &&
                        lines.trace == LineOptions::Trace::contour;
  if (page.kind == PageKind::ink && contours && !lines.travel) {
    added = add_contours(page);
  } else {
    Result<Page> drawn = to_drawing(std::move(page), lines, effort);
    if (!drawn) return drawn.error();
    // Freeman text holds steps: of the device's segments those that it draws.
    if (freeman && drawn->fidelity.kind == Fidelity::Kind::device) {
      Result<Drawing> chains = device_chains(drawn->drawing);
      if (!chains) return chains.error();
      drawn->drawing = *std::move(chains);
    }
    if (lines.travel) {
      const Status ordered = order_page(*drawn, notes);
      if (!ordered) return ordered;
    }
    added = vector->add_page(drawn->drawing, drawn->info);
  }
  const std::vector<std::string>& all = vector->notes();
  while (notes_taken < all.size()) notes.push_back(all[notes_taken++]);
  return added;
}

PageWriter::PageWriter(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
PageWriter::~PageWriter() = default;
PageWriter::PageWriter(PageWriter&&) noexcept = default;
PageWriter& PageWriter::operator=(PageWriter&&) noexcept = default;

Result<PageWriter> PageWriter::create(OutputFormat format, ByteSink sink,
                                      const LineOptions& lines, Effort effort,
                                      const DecodeLimits& limits) {
  auto impl = std::make_unique<Impl>();
  impl->sink = sink;
  impl->lines = lines;
  impl->effort = effort;
  impl->limits = limits;
  impl->freeman = format == OutputFormat::freeman;
  impl->program = format == OutputFormat::program;
  if (impl->program) return PageWriter(std::move(impl));
  if (const auto raster = raster_format(format)) {
    Result<RasterWriter> writer = RasterWriter::create(*raster);
    if (!writer) return writer.error();
    impl->raster.emplace(std::move(*writer));
  } else {
    Result<VectorWriter> writer =
        VectorWriter::create(*vector_format(format), std::move(sink));
    if (!writer) return writer.error();
    impl->vector.emplace(std::move(*writer));
  }
  return PageWriter(std::move(impl));
}

Status PageWriter::add(Page page, std::vector<std::string>& notes) {
  if (impl_->program) {
    if (page.kind == PageKind::program) return impl_->sink(page.program);
    return Error{ErrorCode::unsupported,
                 "is a drawing; unstep convert makes programs of drawings"};
  }
  if (page.kind == PageKind::program) {
    Result<Page> drawn = draw_program_page(page, notes);
    if (!drawn) return drawn.error();
    page = *std::move(drawn);
  }
  return impl_->raster ? impl_->add_ink(page, notes)
                       : impl_->add_drawing(std::move(page), notes);
}

Status PageWriter::finish() {
  if (impl_->program) return {};
  if (impl_->vector) return impl_->vector->finish();
  const Result<std::vector<std::uint8_t>> bytes = impl_->raster->finish();
  if (!bytes) return bytes.error();
  return impl_->sink(
      {reinterpret_cast<const char*>(bytes->data()), bytes->size()});
}

}  // namespace unstep::cli
