// SPDX-License-Identifier: MIT
#include "experiments/suite/fault.hpp"

#include "experiments/failure.hpp"
#include "reference/number/echo.hpp"

namespace bezierbench::suite {
namespace {

Position position_of(const KeyPlace& place, std::size_t index) {
  if (index == Fault::key_itself) return place.key;
  return index < place.elements.size() ? place.elements[index] : place.value;
}

}  // namespace

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
  throw Failure(Exit::usage,
                fmt::format("{}{}study \"{}\": {}", place, place.empty() ? "" : ": ", echo(study.id), fault.what));
}

}  // namespace bezierbench::suite
