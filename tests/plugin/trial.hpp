// `tribunal try` on this layer's modules.
#pragma once

#include "tests/cli/program.hpp"

#include <algorithm>
#include <cstdlib>
#include <string>
#include <sys/wait.h>
#include <vector>

namespace tribunal::plugin_tests {

inline std::string module_file(const std::string& name) { return TRIBUNAL_MODULES + name + ".so"; }

/// Few queries and points, so that a test takes moments.
inline cli::Ended run_try(std::vector<std::string> words) {
  words.insert(words.begin(), "try");
  for (const char* word : {"--json", "--progress", "none"}) words.push_back(word);
  return cli::tribunal(words);
}

inline cli::Ended try_module(const std::string& name, std::vector<std::string> more = {}) {
  std::vector<std::string> words{"--plugin", module_file(name), "--queries", "2000", "-n", "60"};
  words.insert(words.end(), more.begin(), more.end());
  return run_try(words);
}

/// How many exercises of the document ended so.
inline long count(const nlohmann::json& document, const std::string& outcome) {
  const auto& exercises = document.at("exercises");
  return std::count_if(exercises.begin(), exercises.end(),
                       [&](const auto& e) { return e.at("outcome") == outcome; });
}

/// Runs a counterexample's replay as a user would, in a shell, with the program of this build.
inline int replay_status(const std::string& replay) {
  const std::string program = TRIBUNAL_PROGRAM;
  const std::string command = "tribunal() { '" + program + "' \"$@\"; }; { " + replay + "; } >/dev/null 2>&1";
  const int status = std::system(command.c_str());
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

}  // namespace tribunal::plugin_tests
