#include "unstep/unstep.h"

namespace unstep {

std::string_view version() { return UNSTEP_VERSION; }

}  // namespace unstep
