// SPDX-License-Identifier: MIT
#include "experiments/suite/text/reader.hpp"

#include <fmt/format.h>
#include <toml++/toml.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdio>
#include <iterator>
#include <memory>
#include <set>
#include <span>
#include <string>
#include <system_error>
#include <utility>

#include "experiments/failure.hpp"
#include "experiments/suite/external.hpp"
#include "experiments/suite/ids.hpp"
#include "experiments/suite/kind.hpp"
#include "experiments/suite/text/toml_value.hpp"
#include "experiments/suite/validate.hpp"
#include "reference/number/echo.hpp"

namespace bezierbench::suite {
namespace {

class Reader {
 public:
  /// External methods that the file records are known, too.
  Reader(std::string_view file, const Vocabulary& known, const std::vector<ExternalMethod>& external)
      : file_(file), known_(known) {
    for (const auto& method : external) known_.methods.push_back(method.id);
  }

  std::vector<Suite> document(const toml::table& root) {
    check_schema(root);
    std::vector<Suite> suites;
    if (root.contains("suites")) {
      check_keys(root, {"schema_version", "suites", "external"});
      for (const toml::table* table : tables(root, "suites", "[[suites]]")) {
        check_keys(*table, {"id", "title", "seed", "study"});
        suites.push_back(suite(*table, *table, "[[suites.study]]"));
      }
    } else {
      check_keys(root, {"schema_version", "suite", "study", "external"});
      const toml::node* head = root.get("suite");
      if (head == nullptr) fail(root, "[suite] is missing; add it with id, title and seed");
      if (!head->is_table()) fail(*head, "suite must be a table; write [suite]");
      check_keys(*head->as_table(), {"id", "title", "question", "seed", "seconds"});
      suites.push_back(suite(*head->as_table(), root, "[[study]]"));
    }
    return suites;
  }

 private:
  [[noreturn]] void fail(const toml::node& node, std::string_view what) const {
    suite::fail(file_, position(node), what);
  }

  /// The place of a node. The parser gives the root table none.
  static toml::source_position position(const toml::node& node) {
    const auto at = node.source().begin;
    return at.line == 0 ? toml::source_position{1, 1} : at;
  }

  void check_schema(const toml::table& root) const {
    const toml::node* version = root.get("schema_version");
    if (version == nullptr) fail(root, "schema_version is missing; add schema_version = 1");
    if (version->value_exact<std::int64_t>() != std::int64_t{1})
      fail(*version, "schema_version must be 1, the only one that this program reads");
  }

  void check_keys(const toml::table& table, const std::vector<std::string>& allowed) const {
    for (const auto& [key, node] : table) {
      if (std::find(allowed.begin(), allowed.end(), key.str()) != allowed.end()) continue;
      suite::fail(file_, key.source().begin,
                  fmt::format("unknown key \"{}\"{}", echo(key.str()), suggestion(key.str(), allowed)));
    }
  }

  /// The tables of an array of tables, at least one. Throws where there is none.
  std::vector<const toml::table*> tables(const toml::table& parent, std::string_view key,
                                         std::string_view header) const {
    const toml::node* node = parent.get(key);
    if (node == nullptr) fail(parent, fmt::format("no study; add a {} table", header));
    const toml::array* array = node->as_array();
    if (array == nullptr) fail(*node, fmt::format("{} must be an array of tables; write {}", key, header));
    if (array->empty()) fail(*node, fmt::format("no study; add a {} table", header));
    std::vector<const toml::table*> found;
    for (const toml::node& element : *array) {
      if (!element.is_table()) fail(element, fmt::format("{} must be an array of tables; write {}", key, header));
      found.push_back(element.as_table());
    }
    return found;
  }

  Suite suite(const toml::table& head, const toml::table& parent, std::string_view header) {
    Suite out;
    if (const toml::node* node = head.get("id")) read({file_, "id"}, *node, out.id);
    if (std::string what = id_problem(out.id); !what.empty()) fail(head.contains("id") ? *head.get("id") : head, what);
    if (!suite_ids_.insert(out.id).second) fail(*head.get("id"), "another suite has this id; rename one");
    if (const toml::node* node = head.get("title")) read({file_, "title"}, *node, out.title);
    if (const toml::node* node = head.get("seed")) {
      std::int64_t seed = 0;
      read({file_, "seed"}, *node, seed);
      out.seed = static_cast<std::uint64_t>(seed);  // negative seeds become too large and are refused
      if (std::string what = seed_problem(out.seed); !what.empty()) fail(*node, what);
    }
    if (const toml::node* node = head.get("seconds")) {
      std::int64_t seconds = 0;
      read({file_, "seconds"}, *node, seconds);
      if (seconds < 0) fail(*node, "seconds must be at least 0");
    }
    for (const toml::table* table : tables(parent, "study", header)) out.studies.push_back(study(*table));
    return out;
  }

  Study study(const toml::table& table) {
    const toml::node* kind = table.get("kind");
    if (kind == nullptr) fail(table, "kind is missing; see `bezierbench list kinds`");
    Study out;
    read({file_, "kind", known_.kinds}, *kind, out.kind);
    check_keys_of(kind_of(out), table);
    out.places = places(table);
    for (const Field* field : fields_of(kind_of(out)))
      if (const toml::node* node = table.get(field->key); node != nullptr && node != kind)
        read(file_, *node, *field, out);
    if (has_sets(out) && !table.contains("dimension")) out.dimension.clear();  // all that there are
    if (out.form == Form::rational && !table.contains("generator")) {
      const auto weighted = std::find_if(known_.generators.begin(), known_.generators.end(),
                                         [](const KnownGenerator& known) { return known.limits.weights; });
      if (weighted != known_.generators.end()) out.generator = {weighted->id};
    }
    if (const auto fault = validate(out, known_))
      throw Failure(Exit::usage, "{}: {}", place_of(out, *fault), fault->what);
    if (!study_ids_.insert(out.id).second)
      fail(*table.get("id"), fmt::format("another study has the id \"{}\"; rename one", out.id));
    return out;
  }

  /// Refuses a key that the kind does not have: as one of other kinds if these have it, else as unknown.
  void check_keys_of(const Kind& kind, const toml::table& table) const {
    std::vector<std::string> allowed;
    for (const Field* field : fields_of(kind)) allowed.emplace_back(field->key);
    for (const auto& [key, node] : table) {
      if (find_field(kind, key.str()) != nullptr) continue;
      if (const auto foreign = foreign_key_problem(kind, key.str(), known_.kinds); !foreign.empty())
        suite::fail(file_, key.source().begin, foreign + "; remove it");
    }
    check_keys(table, allowed);
  }

  static Position place(const toml::source_position& at) { return {at.line, at.column}; }

  Places places(const toml::table& table) const {
    Places all{std::string(file_), place(position(table)), {}, {}};
    for (const auto& [key, node] : table) {
      KeyPlace one{place(key.source().begin), place(position(node)), {}};
      if (const toml::array* array = node.as_array())
        for (const toml::node& element : *array) one.elements.push_back(place(position(element)));
      all.keys.emplace(key.str(), std::move(one));
    }
    return all;
  }

  std::string_view file_;
  Vocabulary known_;
  std::set<std::string> suite_ids_;
  std::set<std::string> study_ids_;
};

/// Refuses keys with many dots. Every dot in a key nests a table deeper, and beyond some ten thousand the parser's
/// recursion overflows the stack; no suite has a key with dots. Adjacent dots are not part of a key, but may decorate a
/// comment.
void refuse_deep_keys(std::string_view text, std::string_view file_name) {
  constexpr int most_dots = 100;
  int dots = 0;
  char before = '\n';
  toml::source_position at{1, 1};
  for (const char c : text) {
    if (c == '.' ? before == '.' : std::string_view("=,[]{}#\n").find(c) != std::string_view::npos) dots = 0;
    if (c == '.' && before != '.' && ++dots > most_dots)
      fail(file_name, at, fmt::format("more than {} dots in one key; write a shorter one", most_dots));
    ++at.column;
    if (c == '\n') at = {at.line + 1, 1};
    before = c;
  }
}

std::string contents(const std::filesystem::path& file) {
  const auto refuse = [&](int error) {
    throw Failure(Exit::usage, "{}: cannot be read ({}); name a suite file that can, or see `bezierbench list suites`",
                  file.string(), std::generic_category().message(error));
  };
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> stream(std::fopen(file.c_str(), "rb"), &std::fclose);
  if (!stream) refuse(errno);
  std::string text;
  std::array<char, 65536> buffer{};
  while (const std::size_t got = std::fread(buffer.data(), 1, buffer.size(), stream.get()))
    text.append(buffer.data(), got);
  if (std::ferror(stream.get()) != 0) refuse(errno);  // opening a folder succeeds, reading it fails here
  return text;
}

}  // namespace

std::vector<Suite> parse_suites(std::string_view text, std::string_view file_name, const Vocabulary& known) {
  refuse_deep_keys(text, file_name);
  try {
    const auto document = toml::parse(text);
    return Reader(file_name, known, parse_external(text, file_name)).document(document);
  } catch (const toml::parse_error& error) {
    std::string what(error.description());
    std::replace_if(
        what.begin(), what.end(), [](char c) { return static_cast<unsigned char>(c) < 0x20; }, ' ');
    fail(file_name, error.source().begin, "not TOML: " + what + "; correct the syntax here");
  }
}

std::vector<Suite> read_suites(const std::filesystem::path& file, const Vocabulary& known) {
  return parse_suites(contents(file), file.string(), known);
}

Declared declared(std::string_view text) {
  const auto document = toml::parse(text);
  const auto suite = document["suite"];
  return {suite["question"].value_or(std::string()), suite["seconds"].value<std::int64_t>()};
}

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
