#include "formats/module_loader.h"

#include <cstdlib>
#include <vector>

namespace unstep {
namespace {

#ifdef UNSTEP_MODULE_INSTALL_DIR
/// The folder of the library or program that holds this code.
std::string own_folder() {
  static const char anchor = 0;
  Dl_info about{};
  if (::dladdr(&anchor, &about) == 0 || about.dli_fname == nullptr) return {};
  const std::string path = about.dli_fname;
  const std::size_t slash = path.rfind('/');
  return slash == std::string::npos ? "." : path.substr(0, slash);
}
#endif

/// Where the module may be, first choice first.
std::vector<std::string> module_folders() {
  std::vector<std::string> folders;
  if (const char* chosen = std::getenv("UNSTEP_MODULE_DIR");
      chosen != nullptr && *chosen != '\0') {
    folders.emplace_back(chosen);
  }
#ifdef UNSTEP_MODULE_INSTALL_DIR
  if (const std::string own = own_folder(); !own.empty()) {
    folders.push_back(own + "/unstep");
    folders.push_back(own + "/" UNSTEP_MODULE_RELATIVE_DIR);
  }
  folders.emplace_back(UNSTEP_MODULE_BUILD_DIR);
  folders.emplace_back(UNSTEP_MODULE_INSTALL_DIR);
#endif
  return folders;
}

/// Null if it is not there or of another revision.
void* open_module(const std::string& path, const char* revision_symbol,
                  int revision, std::string& reason) {
  void* handle = ::dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (handle == nullptr) {
    const char* error = ::dlerror();
    reason = error != nullptr ? error : "cannot load " + path;
    return nullptr;
  }
  auto* const built = module_function<int()>(handle, revision_symbol);
  if (built == nullptr || built() != revision) {
    reason = path + " is of another version";
    ::dlclose(handle);
    return nullptr;
  }
  return handle;
}

}  // namespace

Result<void*> load_module(const std::string& name, const char* revision_symbol,
                          int revision, const std::string& purpose) {
  std::string reason = "built without it";
  for (const std::string& folder : module_folders()) {
    void* handle =
        open_module(folder + "/" + name, revision_symbol, revision, reason);
    if (handle != nullptr) return handle;
  }
  return Error{ErrorCode::unsupported,
               purpose + " the module " + name + ", which cannot be loaded (" +
                   reason + "); UNSTEP_MODULE_DIR names its folder"};
}

}  // namespace unstep
