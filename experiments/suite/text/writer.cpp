// SPDX-License-Identifier: MIT
#include "experiments/suite/text/writer.hpp"

#include <fmt/format.h>

#include <iterator>

#include "experiments/suite/kind.hpp"
#include "experiments/suite/text/toml_value.hpp"

namespace bezierbench::suite {

std::string to_toml(std::span<const Suite> suites) {
  const bool one = suites.size() == 1;
  std::string text = "schema_version = 1\n";
  const auto out = std::back_inserter(text);
  for (const Suite& suite : suites) {
    fmt::format_to(out, "\n{}\nid = {}\ntitle = {}\nseed = {}\n", one ? "[suite]" : "[[suites]]", to_text(suite.id),
                   to_text(suite.title), suite.seed);
    for (const Study& study : suite.studies) {
      fmt::format_to(out, "\n{}\n", one ? "[[study]]" : "[[suites.study]]");
      for (const Field* field : fields_of(kind_of(study)))
        if (const std::string value = to_text(*field, study); !value.empty() && applies(*field, study))
          fmt::format_to(out, "{} = {}\n", field->key, value);
    }
  }
  return text;
}

}  // namespace bezierbench::suite
