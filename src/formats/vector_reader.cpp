#include <new>
#include <utility>

#include "formats/format_reader.h"

namespace unstep {
namespace {

Result<std::vector<VectorPage>> read_chain_text(
    std::string_view bytes, const VectorReadOptions& options) {
  Result<Drawing> drawing = parse_freeman(bytes, options.limits);
  if (!drawing) return drawing.error();
  std::vector<VectorPage> pages(1);
  pages.front().drawing = std::move(*drawing);
  return pages;
}

Result<std::vector<VectorPage>> dispatch(std::string_view bytes,
                                         VectorFormat format,
                                         const VectorReadOptions& options) {
  switch (format) {
    case VectorFormat::svg: return read_svg(bytes, options);
    case VectorFormat::dxf: return read_dxf(bytes, options);
    case VectorFormat::hpgl: return read_hpgl(bytes, options);
    case VectorFormat::json: return read_json(bytes, options);
    case VectorFormat::freeman: return read_chain_text(bytes, options);
    case VectorFormat::pdf: break;
  }
  return Error{ErrorCode::unsupported, "PDF is written only"};
}

}  // namespace

Result<std::vector<VectorPage>> read_vector(std::string_view bytes,
                                            VectorFormat format,
                                            const VectorReadOptions& options) {
  try {
    return dispatch(bytes, format, options);
  } catch (const std::bad_alloc&) {
    return Error{ErrorCode::limit_exceeded, "no memory for the drawing"};
  }
}

}  // namespace unstep
