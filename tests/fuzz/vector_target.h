#pragma once

#include <string>
#include <string_view>
#include <utility>

#include "fuzz/target.h"
#include "unstep/formats.h"

namespace unstep::fuzz {

/// Any bytes as a vector file: an error of one line, or drawings that every
/// writer takes and that JSON gives back equal.
inline int check_vector(VectorFormat format, const std::uint8_t* data,
                        std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  (void)recognise_vector(text);
  const Result<std::vector<VectorPage>> pages =
      read_vector(text, format, {0, limits()});
  if (!pages) {
    require_sound(pages.error());
    return 0;
  }
  for (const VectorPage& page : *pages) {
    for (const std::string& note : page.notes) {
      require(note.find('\n') == std::string::npos, "note of lines");
    }
    for (const VectorFormat to :
         {VectorFormat::svg, VectorFormat::dxf, VectorFormat::hpgl,
          VectorFormat::pdf, VectorFormat::json}) {
      std::string written;
      Result<VectorWriter> writer =
          VectorWriter::create(to, [&written](std::string_view bytes) {
            written += bytes;
            return Status{};
          });
      const Status added = writer->add_page(page.drawing, page.info);
      require(static_cast<bool>(added), added ? "" : added.error().message);
      require(static_cast<bool>(writer->finish()), "a file can be finished");
      if (to != VectorFormat::json) continue;
      const auto again = read_vector(written, to, {});
      require(static_cast<bool>(again), "written JSON can be read");
      require(again->front().drawing == page.drawing, "the same drawing");
    }
  }
  return 0;
}

}  // namespace unstep::fuzz
