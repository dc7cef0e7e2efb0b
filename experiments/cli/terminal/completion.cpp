// SPDX-License-Identifier: MIT
#include "experiments/cli/terminal/completion.hpp"

#include <algorithm>
#include <cstddef>
#include <string_view>

namespace bezierbench::cli {
namespace {

constexpr const char* files = ":files";
constexpr const char* folders = ":folders";

std::string last_name(const std::string& full) { return full.substr(full.rfind(' ') + 1); }

/// Where a command line ends: in which command, and of which option the value comes next.
struct Place {
  const CommandNode* command;
  const OptionNode* option = nullptr;
  std::size_t arguments = 0;  ///< positional ones so far
};

const OptionNode* find_option(const CommandNode& command, std::string_view word) {
  const auto found = std::ranges::find(command.options, word, &OptionNode::name);
  return found == command.options.end() || found->name.empty() ? nullptr : &*found;
}

Place place_after(const CommandNode& program, std::span<const std::string> words) {
  Place place{&program};
  for (const auto& word : words) {
    if (place.option != nullptr) {
      place.option = nullptr;
    } else if (word.starts_with('-')) {
      const auto* option = find_option(*place.command, word);
      if (option != nullptr && !option->value.empty()) place.option = option;
    } else if (const auto next = std::ranges::find(place.command->commands, word,
                                                   [](const CommandNode& one) { return last_name(one.name); });
               next != place.command->commands.end()) {
      place = {&*next};
    } else {
      ++place.arguments;
    }
  }
  return place;
}

/// The values of an option that begin with `begun`, each after `lead`. In a list a,b,c the last is completed.
void add_values(const OptionNode& option, const std::string& begun, const std::string& lead,
                std::vector<std::string>& all) {
  const auto comma = begun.rfind(',');
  const auto equals = begun.find('=');
  const bool in_list = comma != std::string::npos && equals != std::string::npos && equals < comma;
  const auto key = in_list ? begun.substr(0, equals + 1) : "";
  const auto typed = in_list ? begun.substr(0, comma + 1) : "";
  const auto wanted = in_list ? key + begun.substr(comma + 1) : begun;
  if (option.values)
    for (const auto& value : option.values())
      if (value.starts_with(wanted)) all.push_back(lead + typed + value.substr(key.size()));
  for (const std::string_view of_files : {file_value, suite_value, command_value, against_value})
    if (option.value == of_files) all.emplace_back(files);
  if (option.value == folder_value || option.value == bundle_value) all.emplace_back(folders);
}

void add_options(const CommandNode& command, const std::string& begun, std::vector<std::string>& all) {
  for (const auto& option : command.options)
    if (!option.name.empty() && option.name.starts_with(begun)) all.push_back(option.name + '\t' + option.help);
}

/// The positional argument after `given` others; the last may take several.
const OptionNode* argument_after(const CommandNode& command, std::size_t given) {
  const OptionNode* last = nullptr;
  for (const auto& option : command.options) {
    if (!option.name.empty()) continue;
    last = &option;
    if (given == 0) return last;
    --given;
  }
  return last != nullptr && last->several ? last : nullptr;
}

}  // namespace

std::vector<std::string> completions(const CommandNode& program, std::span<const std::string> words) {
  std::vector<std::string> all;
  if (words.empty()) return all;
  const auto place = place_after(program, words.first(words.size() - 1));
  const auto& begun = words.back();
  if (place.option != nullptr) {
    add_values(*place.option, begun, "", all);
  } else if (const auto equals = begun.find('='); begun.starts_with("--") && equals != std::string::npos) {
    if (const auto* option = find_option(*place.command, begun.substr(0, equals)))
      add_values(*option, begun.substr(equals + 1), begun.substr(0, equals + 1), all);
  } else if (begun.starts_with('-')) {
    add_options(*place.command, begun, all);
  } else {
    for (const auto& command : place.command->commands)
      if (last_name(command.name).starts_with(begun)) all.push_back(last_name(command.name) + '\t' + command.help);
    if (const auto* argument = argument_after(*place.command, place.arguments))
      add_values(*argument, begun, "", all);
    else if (place.command->commands.empty())
      add_options(*place.command, begun, all);
  }
  return all;
}

}  // namespace bezierbench::cli
