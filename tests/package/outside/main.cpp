#include <unstep/codec.h>
#include <unstep/formats.h>

#include <cstdint>
#include <cstdio>
#include <vector>

// A frame with a diagonal: compressed in memory, read back, compared; and
// written as PNG, so that the image libraries are linked too.
int main() {
  unstep::Result<unstep::Bitmap> frame = unstep::Bitmap::create(40, 30);
  if (!frame) return 1;
  for (std::int32_t y = 0; y < 30; ++y) {
    for (std::int32_t x = 0; x < 40; ++x) {
      const bool border = x == 0 || y == 0 || x == 39 || y == 29;
      if (border || x == y) frame->set(x, y, true);
    }
  }

  unstep::UstpWriter writer({});
  if (!writer.add_page(*frame, {})) return 2;
  const unstep::Result<std::vector<std::uint8_t>> file = writer.finish();
  if (!file) return 3;

  const unstep::Result<unstep::UstpReader> reader =
      unstep::UstpReader::open(*file, {});
  if (!reader) return 4;
  const unstep::Result<unstep::Page> page = reader->read_page(0);
  if (!page || page->ink != *frame) return 5;

  unstep::Result<unstep::RasterWriter> png =
      unstep::RasterWriter::create(unstep::RasterFormat::png);
  if (!png || !png->add_page(page->ink, {}, nullptr)) return 6;
  const unstep::Result<std::vector<std::uint8_t>> image = png->finish();
  if (!image) return 7;

  std::printf("40 x 30 pixels: %zu bytes, PNG %zu bytes, identical\n",
              file->size(), image->size());
  return 0;
}
