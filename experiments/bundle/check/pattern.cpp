// SPDX-License-Identifier: MIT
#include "experiments/bundle/check/pattern.hpp"

#include <regex.h>

#include <map>
#include <memory>
#include <mutex>
#include <stdexcept>

namespace bezierbench::bundle {
namespace {

class Pattern {
 public:
  explicit Pattern(const std::string& text) {
    if (regcomp(&compiled_, text.c_str(), REG_EXTENDED | REG_NOSUB) != 0)
      throw std::invalid_argument("no regular expression: " + text);
  }
  ~Pattern() { regfree(&compiled_); }
  Pattern(const Pattern&) = delete;
  Pattern& operator=(const Pattern&) = delete;

  [[nodiscard]] bool matches(const std::string& text) const {
    return text.find('\0') == std::string::npos && regexec(&compiled_, text.c_str(), 0, nullptr, 0) == 0;
  }

 private:
  regex_t compiled_{};
};

}  // namespace

bool matches(const std::string& pattern, const std::string& text) {
  static std::mutex mutex;
  static std::map<std::string, std::unique_ptr<Pattern>> patterns;
  const std::lock_guard lock(mutex);
  auto& compiled = patterns[pattern];
  if (!compiled) compiled = std::make_unique<Pattern>(pattern);
  return compiled->matches(text);
}

}  // namespace bezierbench::bundle
