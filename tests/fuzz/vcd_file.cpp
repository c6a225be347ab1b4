#include <string_view>

#include "formats/vcd_reader.h"
#include "fuzz/target.h"

/// Any text as a value change dump: an error of one line, or changes of known
/// nets in the order of time, no more than there are characters.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data,
                                      std::size_t size) {
  using namespace unstep;
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  Result<VcdReader> file = VcdReader::open(text, fuzz::limits());
  if (!file) {
    fuzz::require_sound(file.error());
    return 0;
  }
  for (const VcdSignal& signal : file->signals()) {
    if (const auto probe = file->find(signal.name); !probe) {
      fuzz::require_sound(probe.error());
    } else {
      fuzz::require(probe->bit < 64, "the bit can be looked up");
    }
  }
  std::uint64_t time = 0;
  for (std::size_t count = 0; count <= size; ++count) {
    const auto change = file->next();
    if (!change) {
      fuzz::require_sound(change.error());
      return 0;
    }
    if (!*change) return 0;
    fuzz::require((*change)->time >= time, "time never falls");
    fuzz::require((*change)->net < file->signals().size(), "the net is known");
    fuzz::require(((*change)->bits & (*change)->unknown) == 0, "0 where x");
    time = (*change)->time;
  }
  fuzz::require(false, "no more changes than characters");
  return 0;
}
