#include "predicates/plugin/library.hpp"

#include <dlfcn.h>

namespace tribunal {
namespace {

// The loader's own words, without the path that it usually puts first.
std::string loader_message(const std::string& path) {
  const char* message = dlerror();
  std::string text = message != nullptr ? message : "unknown reason";
  if (text.rfind(path + ": ", 0) == 0) text.erase(0, path.size() + 2);
  return text;
}

}  // namespace

SharedLibrary::SharedLibrary(const std::string& path) : path_(path), handle_(nullptr) {
  const std::string file = path.find('/') == std::string::npos ? "./" + path : path;
  // Bound at once, so that a missing symbol is an error here and not a death later.
  handle_ = dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (handle_ == nullptr) refuse("cannot be loaded: " + loader_message(file));
}

void SharedLibrary::refuse(const std::string& reason) const { throw PluginError(path_ + ": " + reason); }

void* SharedLibrary::symbol(const char* name) const { return dlsym(handle_, name); }

}  // namespace tribunal
