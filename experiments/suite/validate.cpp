// SPDX-License-Identifier: MIT
#include "experiments/suite/validate.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <vector>

#include "core/curve_view.hpp"
#include "experiments/failure.hpp"
#include "experiments/suite/ids.hpp"
#include "experiments/suite/kind.hpp"
#include "experiments/suite/suite.hpp"
#include "reference/number/echo.hpp"
#include "reference/number/number.hpp"

namespace bezierbench::suite {
namespace {

bool contains(std::span<const std::string> ids, std::string_view id) {
  return std::find(ids.begin(), ids.end(), id) != ids.end();
}

Finding unknown(std::string_view key, std::size_t i, std::string_view word, std::span<const std::string> known) {
  return Fault{key, i, {}, fmt::format("unknown {} \"{}\"{}", key, echo(word), suggestion(word, known))};
}

Finding check_axes(const Study& study) {
  const auto fine = [](const auto&) { return std::string(); };
  if (auto found = each("degree", study.degree, [](int degree) {
        return degree >= 0 && degree <= max_degree ? "" : fmt::format("degree must be 0 to {}", max_degree);
      })) {
    return found;
  }
  if (auto found = each("dimension", study.dimension, [](int dimension) {
        return std::string(dimension >= 1 && dimension <= 3 ? "" : "dimension must be 1, 2 or 3");
      })) {
    return found;
  }
  if (auto found = each("coordinate_range", study.coordinate_range, [](double range) {
        return std::string(std::isfinite(range) && range >= 0
                               ? ""
                               : "coordinate_range R must be finite and not negative; coordinates lie in [-R, R]");
      })) {
    return found;
  }
  if (auto found = each("t_interval", study.t_interval, [](const Interval& t) {
        return std::string(std::isfinite(t.min) && std::isfinite(t.max) && t.min <= t.max
                               ? ""
                               : "t_interval must be [a, b] with a <= b, both finite");
      })) {
    return found;
  }
  return each("scalar", study.scalar, fine);
}

/// The keys that not every kind has: those that a kind does not have are as they are where they are left out.
Finding check_own_keys(const Study& study, const Vocabulary& known) {
  const Kind& kind = kind_of(study);
  if (auto found = each("modes", study.modes, [](Mode) { return std::string(); })) return found;
  if (auto found = each("order", study.order, [](int value) {
        return value >= 0 && value <= max_degree ? "" : fmt::format("order must be 0 to {}", max_degree);
      }))
    return found;
  if (auto found = each("points", study.points, [](int value) {
        return value >= 2 && value <= most_points ? "" : fmt::format("points must be 2 to {}", most_points);
      }))
    return found;
  if (auto found = each("tolerance", study.tolerance, [](double value) {
        return std::string(std::isfinite(value) && value > 0 ? "" : "tolerance must be finite and above 0");
      }))
    return found;
  if (study.budget < 1 && find_field(kind, "budget") != nullptr)
    return Fault{
        "budget",
        0,
        {},
        fmt::format("kind \"{}\" needs a budget of at least 1, how many inputs it may try; write budget = 20000",
                    kind.id)};
  constexpr std::int64_t most_kept = 1000;
  if (study.kept < 1 || study.kept > most_kept)
    return Fault{"kept", 0, {}, fmt::format("kept must be 1 to {}", most_kept)};
  if (study.decomposed_trials < 0) return Fault{"decomposed_trials", 0, {}, "decomposed_trials must not be negative"};
  if (!study.published.empty() && !contains(known.published_files, study.published))
    return unknown("published", 0, study.published, known.published_files);
  return std::nullopt;
}

Finding check_counts(const Study& study) {
  if (study.trials < 1) return Fault{"trials", 0, {}, "trials must be at least 1"};
  if (study.replicates < 1) return Fault{"replicates", 0, {}, "replicates must be at least 1"};
  if (study.replicates > most_replicates)
    return Fault{"replicates", 0, {}, fmt::format("replicates must be at most {}, for each is kept", most_replicates)};
  if (study.trials > std::numeric_limits<std::int64_t>::max() / study.replicates)
    return Fault{"replicates", 0, "trials", "trials * replicates must be below 2^63; lower one of them"};
  return std::nullopt;
}

const KnownGenerator* find_generator(const Vocabulary& known, std::string_view id) {
  const auto found = std::find_if(known.generators.begin(), known.generators.end(),
                                  [&](const KnownGenerator& generator) { return generator.id == id; });
  return found == known.generators.end() ? nullptr : &*found;
}

std::vector<std::string> generator_ids(const Vocabulary& known) {
  std::vector<std::string> ids;
  for (const auto& generator : known.generators) ids.push_back(generator.id);
  return ids;
}

/// The number as a power of two where that is shorter to read, else in decimal.
std::string power_or_decimal(double x) {
  int exponent = 0;
  const bool power = std::frexp(x, &exponent) == 0.5;  // x = 2^(exponent - 1)
  return power && std::abs(exponent - 1) > 10 ? fmt::format("2^{}", exponent - 1) : number::decimal(x);
}

/// What is wrong if a generator with weights draws for another form than rational, or one without weights for rational
/// curves.
std::string weights_problem(const Study& study, const KnownGenerator& generator, const Vocabulary& known) {
  const bool rational = study.form == Form::rational;
  if (rational == generator.limits.weights) return {};
  std::vector<std::string> others;
  for (const auto& other : known.generators)
    if (other.limits.weights == rational) others.push_back(other.id);
  return fmt::format("generator \"{}\" draws {}weights, which {}; use {}", generator.id, rational ? "no " : "",
                     rational ? "rational curves need" : "only rational curves have", fmt::join(others, ", "));
}

/// What is wrong if the generator cannot draw with this R; empty where it can.
std::string range_problem(const KnownGenerator& generator, double range) {
  const GeneratorLimits& limits = generator.limits;
  int exponent = 0;
  const bool fits = !limits.exact_coefficients || std::frexp(range, &exponent) == 0.5;
  if (fits && range >= limits.smallest_range && range <= limits.largest_range) return {};
  return fmt::format(
      "generator \"{}\" needs a coordinate_range {}from {} to {}, not {}; change the range or the generator",
      generator.id, limits.exact_coefficients ? "that is a power of two " : "", power_or_decimal(limits.smallest_range),
      power_or_decimal(limits.largest_range), number::decimal(range));
}

/// The first fault in what generator `i` of the study has to draw: the form, a degree, R, an interval or a scalar.
Finding check_generator(const Study& study, std::size_t i, const Vocabulary& known) {
  const KnownGenerator& generator = *find_generator(known, study.generator[i]);
  const GeneratorLimits& limits = generator.limits;
  if (std::string what = weights_problem(study, generator, known); !what.empty())
    return Fault{"generator", i, "curve", std::move(what)};
  const int largest = study.form == Form::power ? limits.polynomial_degree : limits.bezier_degree;
  for (std::size_t k = 0; k < study.degree.size(); ++k)
    if (study.degree[k] > largest)
      return Fault{
          "degree", k, "generator",
          fmt::format("generator \"{}\" draws curves in {} form up to degree {} only, where their coefficients are "
                      "exact; lower the degree or change the generator",
                      generator.id, name(study.form), largest)};
  for (std::size_t k = 0; k < study.coordinate_range.size(); ++k)
    if (std::string what = range_problem(generator, study.coordinate_range[k]); !what.empty())
      return Fault{"coordinate_range", k, "generator", std::move(what)};
  for (std::size_t k = 0; k < study.t_interval.size(); ++k)
    if (limits.finite_width && !std::isfinite(study.t_interval[k].max - study.t_interval[k].min))
      return Fault{"t_interval", k, "generator",
                   fmt::format("generator \"{}\" needs t_max - t_min to be finite; narrow the interval", generator.id)};
  for (std::size_t k = 0; k < study.scalar.size(); ++k)
    if (limits.exact_coefficients && study.scalar[k] != ScalarKind::float64)
      return Fault{"scalar", k, "generator",
                   fmt::format("generator \"{}\" draws coefficients that are exact in double only; leave scalar out "
                               "or change the generator",
                               generator.id)};
  return std::nullopt;
}

/// The first fault of values that are valid on their own but do not fit each other.
Finding check_fit(const Study& study, const Vocabulary& known) {
  for (std::size_t i = 0; i < study.generator.size(); ++i)
    if (auto found = check_generator(study, i, known)) return found;
  const bool single = std::find(study.scalar.begin(), study.scalar.end(), ScalarKind::float32) != study.scalar.end();
  for (std::size_t i = 0; i < study.coordinate_range.size(); ++i) {
    const double range = study.coordinate_range[i];
    if (single && range > static_cast<double>(std::numeric_limits<float>::max()))
      return Fault{"coordinate_range", i, "scalar",
                   fmt::format("coordinate_range {} is beyond the largest float; change the range or the scalar",
                               number::decimal(range))};
  }
  return std::nullopt;
}

/// What is wrong with a method id or glob that matches no method of this build.
std::string missing_method(std::string_view entry, const Vocabulary& known) {
  const auto absent = std::find_if(known.absent_methods.begin(), known.absent_methods.end(),
                                   [&](const AbsentMethod& method) { return means(entry, method.id); });
  if (absent != known.absent_methods.end())
    return fmt::format("method \"{}\" is not in this build; {}", absent->id, absent->remedy);
  if (is_pattern(entry)) return fmt::format("no method matches \"{}\"; see `bezierbench list methods`", echo(entry));
  return fmt::format("unknown method \"{}\"{}", echo(entry), suggestion(entry, known.methods));
}

/// What is wrong with `entry` of `methods`; empty where nothing is. A conversion is a chain of one or more parts.
std::string method_problem(const Study& study, std::string_view entry, const Vocabulary& known) {
  const bool conversion = kind_of(study).chains;
  const std::span<const std::string> ids = conversion ? known.conversions : known.methods;
  std::string_view rest = entry;
  while (true) {
    const std::size_t plus = conversion ? rest.find('+') : std::string_view::npos;
    const std::string_view part = rest.substr(0, plus);
    if (std::none_of(ids.begin(), ids.end(), [&](const std::string& id) { return means(part, id); })) {
      if (!conversion) return missing_method(part, known);
      if (is_pattern(part))
        return fmt::format("no conversion matches \"{}\"; see `bezierbench list methods`", echo(part));
      return fmt::format("unknown conversion \"{}\"{}", echo(part), suggestion(part, ids));
    }
    if (plus == std::string_view::npos) return {};
    rest.remove_prefix(plus + 1);
  }
}

Finding check_ids(const Study& study, const Vocabulary& known) {
  for (std::size_t i = 0; i < study.generator.size(); ++i)
    if (find_generator(known, study.generator[i]) == nullptr)
      return unknown("generator", i, study.generator[i], generator_ids(known));
  std::vector<std::string> baselines{"exact"};
  const auto& ids = kind_of(study).chains ? known.conversions : known.methods;
  baselines.insert(baselines.end(), ids.begin(), ids.end());
  for (std::size_t i = 0; i < study.baseline.size(); ++i) {
    if (contains(baselines, study.baseline[i])) continue;
    if (is_peer(study.baseline[i])) return Fault{"baseline", i, {}, missing_method(study.baseline[i], known)};
    return unknown("baseline", i, study.baseline[i], baselines);
  }
  const auto fine = [](const std::string&) { return std::string(); };
  if (auto found = each("generator", study.generator, fine)) return found;
  if (auto found = each("baseline", study.baseline, fine)) return found;
  return each("methods", study.methods, [&](const std::string& entry) { return method_problem(study, entry, known); });
}

/// Refuses studies with more cells than memory has room for. A few lines can ask for them, and a suite may be a
/// stranger's.
Finding check_cells(const Study& study) {
  constexpr double most_cells = 1e6;
  double cells = 1;
  for (const Field* field : fields_of(kind_of(study))) cells *= static_cast<double>(sweep_length(*field, study));
  if (cells <= most_cells) return std::nullopt;
  return Fault{"degree",
               0,
               {},
               fmt::format("the axes give {:.0f} cells, more than {:.0f}; name fewer values, or make several suites",
                           cells, most_cells)};
}

/// The first key that is missing: one that the kind needs, or an axis that has a default and is given without values.
Finding check_present(const Study& study) {
  const Kind& kind = kind_of(study);
  Study defaults;
  defaults.kind = &kind;
  for (const Field* field : fields_of(kind)) {
    if (!is_empty(*field, study) || (has_sets(study) && field->axis == Axis::of_cells)) continue;
    if (is_required(kind, *field))
      return Fault{field->key,
                   0,
                   {},
                   fmt::format("{} is missing; kind \"{}\" needs it, add {} = {}", field->key, kind.id, field->key,
                               field->example)};
    if (!is_empty(*field, defaults))
      return Fault{field->key, 0, {}, fmt::format("{} is empty; name a value or leave it out", field->key)};
  }
  return check_cells(study);
}

/// The first key that is for drawn curves, where they are those of sets, or the reverse.
Finding check_curves(const Study& study) {
  const Kind& kind = kind_of(study);
  for (const Field* field : fields_of(kind)) {
    if (applies(*field, study) || !study.places.keys.contains(field->key)) continue;
    return Fault{field->key,
                 Fault::key_itself,
                 {},
                 has_sets(study)
                     ? fmt::format("{} is for drawn curves, and these are those of sets; remove it", field->key)
                     : fmt::format("{} is for curves of sets; remove it, or name sets in curves", field->key)};
  }
  if (!has_sets(study)) return std::nullopt;
  if (auto found = each("curves", study.curves, [](const std::string& entry) {
        return std::string(entry.empty() || entry.front() == '#' ? "curves has an entry without a set; remove it" : "");
      }))
    return found;
  if (!study.curves_sha256.empty() && study.curves_sha256.size() != study.curves.size())
    return Fault{"curves_sha256", Fault::key_itself, "curves", "curves_sha256 must have one value for each of curves"};
  constexpr std::int64_t most_parameters = 1 << 20;
  const std::int64_t least = study.parameters_from == ParameterSource::grid ? 2 : 1;
  if (study.parameters < least || study.parameters > most_parameters)
    return Fault{"parameters", 0, "parameters_from",
                 fmt::format("parameters must be {} to {}, {}", least, most_parameters,
                             least == 2 ? "since a grid has both ends" : "for each curve")};
  if (study.parameters_from == ParameterSource::stored && study.parameters != 1)
    return Fault{"parameters", 0, "parameters_from", "parameters are those of the set; leave parameters out"};
  return each("placement", study.placement, [](Placement) { return std::string(); });
}

Finding check_baseline(const Study& study) {
  const Kind& kind = kind_of(study);
  if (kind.has_baseline || study.baseline == std::vector<std::string>{"exact"}) return std::nullopt;
  return Fault{"baseline", Fault::key_itself, "kind",
               fmt::format("kind \"{}\" measures against the exact value only; remove baseline", kind.id)};
}

Position position_of(const KeyPlace& place, std::size_t index) {
  if (index == Fault::key_itself) return place.key;
  return index < place.elements.size() ? place.elements[index] : place.value;
}

}  // namespace

Finding validate(const Study& study, const Vocabulary& known) {
  if (std::string what = id_problem(study.id); !what.empty()) return Fault{"id", 0, {}, std::move(what)};
  if (auto found = check_counts(study)) return found;
  if (auto found = check_present(study)) return found;
  if (auto found = check_axes(study)) return found;
  if (auto found = check_curves(study)) return found;
  const Kind& kind = kind_of(study);
  if (kind.check != nullptr)
    if (auto found = kind.check(study)) return found;
  if (auto found = check_own_keys(study, known)) return found;
  if (auto found = check_ids(study, known)) return found;
  if (auto found = check_baseline(study)) return found;
  if (auto found = check_inputs(study, known.generators)) return found;
  return has_sets(study) ? std::nullopt : check_fit(study, known);
}

std::string seed_problem(std::uint64_t seed) {
  return seed <= static_cast<std::uint64_t>(std::numeric_limits<std::int64_t>::max()) ? "" : "seed must be 0 to 2^63-1";
}

std::string id_problem(std::string_view id) {
  constexpr std::string_view allowed = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789._-";
  constexpr std::size_t longest = 100;  // reports name files after studies, and file names end at 255 bytes
  if (id.empty()) return "id is missing or empty; give it a name";
  if (id.size() > longest) return fmt::format("id has {} characters; shorten it to {} at most", id.size(), longest);
  if (id.find_first_not_of(allowed) != std::string_view::npos)
    return "id may have letters, digits, \".\", \"_\" and \"-\" only; rename it";
  // Files are named after ids: "." and ".." are folders, and a file that begins with "-" looks like an option.
  if (id.front() == '.' || id.front() == '-') return "id must begin with a letter, a digit or \"_\"; rename it";
  return {};
}

void check_unique_ids(std::span<const Suite> suites, std::string_view last_file) {
  std::set<std::string_view> ids;
  std::map<std::string_view, std::string_view> suite_of;
  for (const Suite& suite : suites) {
    if (!ids.insert(suite.id).second)
      throw Failure(Exit::usage, "{}: another suite has the id \"{}\" too; rename one", last_file, suite.id);
    for (const Study& study : suite.studies) {
      const auto [first, is_new] = suite_of.emplace(study.id, suite.id);
      if (is_new) continue;
      throw Failure(
          Exit::usage,
          "{}: study \"{}\" is in suite \"{}\" and in suite \"{}\"; rename one, study ids are unique over a bundle",
          last_file, study.id, first->second, suite.id);
    }
  }
}

std::string place_of(const Study& study, const Fault& fault) {
  const Places& places = study.places;
  for (const std::string_view key : {fault.key, fault.other_key})
    if (const auto option = places.options.find(key); option != places.options.end()) return option->second;
  if (places.file.empty()) return {};
  Position at = places.header;
  if (const auto other = places.keys.find(fault.other_key); other != places.keys.end()) at = other->second.value;
  if (const auto own = places.keys.find(fault.key); own != places.keys.end())
    at = position_of(own->second, fault.index);
  return fmt::format("{}:{}:{}", places.file, at.line, at.column);
}

void refuse(const Study& study, const Fault& fault) {
  const std::string place = place_of(study, fault);
  throw Failure(Exit::usage, "{}{}study \"{}\": {}", place, place.empty() ? "" : ": ", echo(study.id), fault.what);
}

}  // namespace bezierbench::suite
