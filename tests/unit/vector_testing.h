#pragma once

#include <gtest/gtest.h>

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "unstep/formats.h"

/// Drawings and vector files in tests.
namespace unstep::vector_testing {

inline Path::Element line(std::int32_t dx, std::int32_t dy) {
  Path::Element element;
  element.segment = {dx, dy};
  return element;
}

inline Path::Element arc(Point centre, Point end, bool clockwise) {
  Path::Element element;
  element.kind = Path::Kind::arc;
  element.arc = {centre, end, clockwise};
  return element;
}

/// A closed square with its upper left corner at `origin`.
inline Path square(Point origin, std::int32_t side) {
  return {origin,
          true,
          0,
          {line(side, 0), line(0, side), line(-side, 0), line(0, -side)}};
}

struct Written {
  std::string text;
  std::vector<std::string> notes;
};

inline Written write(VectorFormat format, const Drawing& drawing,
                     const PageInfo& info = {}) {
  Written written;
  Result<VectorWriter> writer =
      VectorWriter::create(format, [&written](std::string_view bytes) {
        written.text += bytes;
        return Status{};
      });
  EXPECT_TRUE(writer);
  const Status added = writer->add_page(drawing, info);
  EXPECT_TRUE(added) << added.error().message;
  const Status finished = writer->finish();
  EXPECT_TRUE(finished) << finished.error().message;
  written.notes = writer->notes();
  return written;
}

inline VectorPage read(VectorFormat format, std::string_view text,
                       const VectorReadOptions& options = {}) {
  Result<std::vector<VectorPage>> pages = read_vector(text, format, options);
  EXPECT_TRUE(pages) << pages.error().message << "\n" << text.substr(0, 2000);
  if (!pages || pages->size() != 1) return {};
  return std::move(pages->front());
}

}  // namespace unstep::vector_testing
