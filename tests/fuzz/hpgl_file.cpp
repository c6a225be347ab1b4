#include "fuzz/vector_target.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data,
                                      std::size_t size) {
  return unstep::fuzz::check_vector(unstep::VectorFormat::hpgl, data, size);
}
