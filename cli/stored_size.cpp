#include "cli/stored_size.h"

namespace unstep::cli {

Status store_page(UstpWriter& writer, const Page& page) {
  switch (page.kind) {
    case PageKind::ink: return writer.add_page(page.ink, page.info);
    case PageKind::program:
      return writer.add_program(page.program, page.info, page.fidelity);
    default: return writer.add_page(page.drawing, page.info, page.fidelity);
  }
}

Result<std::size_t> stored_size(const Page& page, Effort effort) {
  EncodeOptions options;
  options.verify = false;
  options.effort = effort;
  UstpWriter writer(options);
  if (Status added = store_page(writer, page); !added) return added.error();
  const auto file = writer.finish();
  if (!file) return file.error();
  return file->size();
}

}  // namespace unstep::cli
