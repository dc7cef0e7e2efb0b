// SPDX-License-Identifier: MIT
// Files of curves.

#include <algorithm>
#include <fstream>
#include <iterator>
#include <string>

#include "bindings/c/curve.hpp"
#include "bindings/c/status.hpp"

using namespace bezierbench;

namespace {

/// Throws Unreadable. No more is read than a reader takes.
std::string contents_of(const std::string& file) {
  std::ifstream stream(file, std::ios::binary);
  std::string contents;
  std::string part(std::size_t{1} << 16U, '\0');
  while (contents.size() <= curves::most_bytes &&
         (stream.read(part.data(), static_cast<std::streamsize>(part.size())) || stream.gcount() > 0))
    contents.append(part, 0, static_cast<std::size_t>(stream.gcount()));
  if (!stream.eof() && contents.size() <= curves::most_bytes)
    throw curves::Unreadable(file + ": cannot be read; check that it is a readable file");
  return contents;
}

/// Writes as much of `text` as fits.
void write_text(std::string_view text, char* message, std::size_t size) {
  if (message == nullptr || size == 0) return;
  const auto length = std::min(text.size(), size - 1);
  std::copy_n(text.data(), length, message);
  message[length] = '\0';
}

const bb_curves& at(const bb_curves* curves, std::size_t index) {
  c::require_pointers(curves);
  c::require(index < curves->set.size(), BB_ERROR_COUNT);
  return *curves;
}

}  // namespace

int bb_curves_read(const char* file, char* message, std::size_t size, bb_curves** curves) {
  return c::guarded([&] {
    c::require_pointers(file, curves);
    try {
      *curves = new bb_curves{curves::read(contents_of(file), file).set};
    } catch (const curves::Unreadable& error) {
      write_text(error.what(), message, size);
      throw c::Refused{BB_ERROR_FILE};
    }
  });
}

std::size_t bb_curves_count(const bb_curves* curves) { return curves == nullptr ? 0 : curves->set.size(); }

int bb_curves_at(const bb_curves* curves, std::size_t index, bb_curve* curve) {
  return c::guarded([&] {
    const auto view = at(curves, index).set[index];
    c::require_pointers(curve);
    const auto form = view.form == Form::power ? BB_POWER : view.form == Form::rational ? BB_RATIONAL : BB_BERNSTEIN;
    *curve = {form, view.dimension, view.degree, view.coefficients.data(),
              view.weights.empty() ? nullptr : view.weights.data()};
  });
}

int bb_curves_begins_path(const bb_curves* curves, std::size_t index, int* begins) {
  return c::guarded([&] {
    const bool begins_path = at(curves, index).set.begins_path(index);
    c::require_pointers(begins);
    *begins = begins_path ? 1 : 0;
  });
}

int bb_curves_id(const bb_curves* curves, std::size_t index, char* id, std::size_t size, std::size_t* required) {
  return c::guarded([&] {
    const auto text = at(curves, index).set.id(index);
    if (required != nullptr) *required = text.size() + 1;
    c::require(text.size() < size, BB_ERROR_COUNT);
    c::require_pointers(id);
    write_text(text, id, size);
  });
}

void bb_curves_free(bb_curves* curves) { delete curves; }
