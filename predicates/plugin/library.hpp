// A shared library that somebody else wrote.
#pragma once

#include <cstdint>
#include <stdexcept>
#include <string>

namespace tribunal {

/// A library that cannot be used as a plug-in: what() is one line that names the file and the reason.
struct PluginError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// A loaded library. It is never unloaded, so that what was found in it lives as long as the process. Loading
/// runs the library's own start-up code, which may do anything: where that matters, load in a process of its
/// own.
class SharedLibrary {
 public:
  /// Loads the file; a name without a slash is one in the working directory. Throws PluginError.
  explicit SharedLibrary(const std::string& path);

  const std::string& path() const { return path_; }

  /// What the library's function of that name returns, a pointer to the structure that it offers; null when
  /// it defines no such function. Throws PluginError when it returns null or a structure, whose first member
  /// is its version, of another version than `version`.
  template <class Offer>
  const Offer* offer(const char* entry, std::uint32_t version) const {
    const auto function = reinterpret_cast<const Offer* (*)()>(symbol(entry));
    if (function == nullptr) return nullptr;
    const Offer* offer = function();
    if (offer == nullptr) refuse(std::string(entry) + " returns null");
    if (offer->version != version)
      refuse("speaks version " + std::to_string(offer->version) + " of the plug-in interface, not " +
             std::to_string(version));
    if (offer->name == nullptr || *offer->name == '\0') refuse(std::string(entry) + " gives no name");
    return offer;
  }

  /// Throws PluginError: "path: reason".
  [[noreturn]] void refuse(const std::string& reason) const;

 private:
  void* symbol(const char* name) const;

  std::string path_;
  void* handle_;
};

}  // namespace tribunal
