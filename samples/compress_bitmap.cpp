// Compresses a drawing in memory, writes the file, reads it back.
#include <unstep/codec.h>
#include <unstep/formats.h>

#include <cstdint>
#include <cstdio>
#include <vector>

namespace {

int fail(const unstep::Error& error) {
  std::fprintf(stderr, "compress_bitmap: %s\n", error.message.c_str());
  return 1;
}

}  // namespace

int main(int argc, char** argv) {
  const char* path = argc > 1 ? argv[1] : "bitmap.ustp";

  auto ink = unstep::Bitmap::create(64, 64);
  if (!ink) return fail(ink.error());
  for (std::int32_t i = 8; i < 56; ++i) ink->set(i, i, true);

  unstep::PageInfo info;
  info.name = "a diagonal";
  info.resolution = {{300, 1}, {300, 1}, unstep::Resolution::Unit::inch};

  unstep::UstpWriter writer({});
  if (auto added = writer.add_page(*ink, info); !added) {
    return fail(added.error());
  }
  const auto file = writer.finish();
  if (!file) return fail(file.error());
  if (auto done = unstep::write_file(path, *file, true); !done) {
    return fail(done.error());
  }

  const auto bytes = unstep::read_file(path, 1 << 20);
  if (!bytes) return fail(bytes.error());
  const auto reader = unstep::UstpReader::open(*bytes, {});
  if (!reader) return fail(reader.error());
  const auto page = reader->read_page(0);
  if (!page) return fail(page.error());

  std::printf("%zu bytes, %s\n", bytes->size(),
              page->ink == *ink ? "identical" : "different");
  return page->ink == *ink ? 0 : 1;
}
