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

namespace bezierbench::c {

void require_shape(int dimension, int degree) {
  require(dimension >= 1 && dimension <= max_dimension, BB_ERROR_DIMENSION);
  require(degree >= 0 && degree <= max_degree, BB_ERROR_DEGREE);
}

Form form_at(int form) {
  switch (form) {
    case BB_BERNSTEIN: return Form::bernstein;
    case BB_POWER: return Form::power;
    case BB_RATIONAL: return Form::rational;
    default: throw Refused{BB_ERROR_FORM};
  }
}

CurveView<double> curve_of(const bb_curve* curve) {
  require_pointers(curve);
  const Form form = form_at(curve->form);
  auto view = bezier_curve(curve->dimension, curve->degree, curve->points);
  view.form = form;
  if (form != Form::rational) return view;
  view.weights = weights_of(curve->weights, curve->degree);
  return view;
}

CurveView<double> bernstein_curve_of(const bb_curve* curve) {
  const auto view = curve_of(curve);
  require(view.form == Form::bernstein, BB_ERROR_FORM);
  return view;
}

bb_form form_of(Form form) {
  switch (form) {
    case Form::power: return BB_POWER;
    case Form::rational: return BB_RATIONAL;
    default: return BB_BERNSTEIN;
  }
}

}  // namespace bezierbench::c
