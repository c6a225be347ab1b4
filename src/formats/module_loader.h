#pragma once

#include <dlfcn.h>

#include <string>

#include "unstep/result.h"

/// The modules that hold OpenCV are loaded when the first file needs them, so
/// that nothing else pays for them.
namespace unstep {

/// dlopen's handle of a module; loaded once, kept to the end. Looked for in
/// $UNSTEP_MODULE_DIR, beside the library or program, in the build folder and
/// where it was installed. `revision_symbol` is its function without arguments
/// that must return `revision`. unsupported, beginning with `purpose` ("BMP
/// needs"), if there is none.
Result<void*> load_module(const std::string& name, const char* revision_symbol,
                          int revision, const std::string& purpose);

/// A function of a module; null if it has none of that name.
template <class Function>
Function* module_function(void* module, const char* name) {
  return reinterpret_cast<Function*>(::dlsym(module, name));
}

}  // namespace unstep
