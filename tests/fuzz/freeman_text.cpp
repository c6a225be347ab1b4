#include <cstddef>
#include <string_view>

#include "fuzz/target.h"
#include "unstep/formats.h"

/// Any text as Freeman chains; what can be read can be written and read again.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data,
                                      std::size_t size) {
  using namespace unstep;
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  const Result<Drawing> drawing = parse_freeman(text, fuzz::limits());
  if (!drawing) {
    fuzz::require_sound(drawing.error());
    return 0;
  }
  const Result<Drawing> again =
      parse_freeman(write_freeman(*drawing), fuzz::limits());
  fuzz::require(static_cast<bool>(again), "written text can be read");
  fuzz::require(*again == *drawing, "written text is the same drawing");
  return 0;
}
