// SPDX-License-Identifier: MIT
// Studies of kind `hard_cases`: inputs whose exact values are hard to round, for tests of other libraries.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <span>
#include <string_view>
#include <tuple>
#include <vector>

#include "experiments/judge/scalar_facts.hpp"
#include "experiments/run/blocks/trial_blocks.hpp"
#include "experiments/sample/cell.hpp"
#include "experiments/studies/hard_cases/families.hpp"
#include "experiments/studies/hard_cases/hard_value.hpp"
#include "experiments/studies/roster.hpp"
#include "experiments/suite/suite.hpp"
#include "reference/exact_curve.hpp"
#include "reference/number/number.hpp"

namespace bezierbench::studies {

namespace {

using reference::Rational;

constexpr int decimal_digits = 40;

/// The exact value of a case; p~ is the sum of the magnitudes of its terms.
struct Value {
  Rational exact;
  Rational p_tilde;
  Rational distance;  ///< from the nearest rounding boundary, see boundary_distance
};

/// What a search keeps: cases that are `wanted`, the smallest `measure` first.
struct Search {
  std::string_view id;
  bool (*wanted)(const Value& value);
  Rational (*measure)(const Value& value);
};

bool is_zero(const Rational& value) { return value.numerator == 0; }
Rational one(const Value& /*value*/) { return {1, 1, 0}; }

constexpr std::array searches{
    Search{"tie", [](const Value& v) { return is_zero(v.distance); }, one},
    Search{"nearest", [](const Value& v) { return !is_zero(v.distance); }, [](const Value& v) { return v.distance; }},
    Search{"cancelled", [](const Value& v) { return !is_zero(v.exact); },
           [](const Value& v) {
             return Rational{abs(v.exact).numerator, v.p_tilde.numerator, v.exact.exponent - v.p_tilde.exponent};
           }},
    Search{"zero", [](const Value& v) { return is_zero(v.exact) && !is_zero(v.p_tilde); }, one}};

/// A case and its measure, significand 2^exponent with the significand in [1, 2), which may be below every double.
struct Found {
  std::int64_t exponent = 0;
  double significand = 1;
  std::int64_t trial = 0;
  std::vector<double> coefficients;
  double t = 0;

  /// Orders by measure, and cases of equal measure by trial.
  friend bool operator<(const Found& a, const Found& b) {
    return std::tie(a.exponent, a.significand, a.trial) < std::tie(b.exponent, b.significand, b.trial);
  }
  [[nodiscard]] bool is_same_case(const Found& other) const {
    return t == other.t && coefficients == other.coefficients;
  }

  template <class Bytes, class Self>
  static void each_field(Bytes& bytes, Self& self) {
    bytes(self.exponent, self.significand, self.trial, self.coefficients, self.t);
  }
};

/// The best cases of each search. A case that is drawn several times is kept once, with its first trial.
struct Kept {
  std::int64_t most = 0;
  std::array<std::vector<Found>, searches.size()> of;

  template <class Bytes, class Self>
  static void each_field(Bytes& bytes, Self& self) {
    bytes(self.most, self.of);
  }
  void add(std::size_t search, Found found) {
    auto& all = of[search];
    if (static_cast<std::int64_t>(all.size()) == most && !(found < all.back())) return;
    const auto same = std::ranges::find_if(all, [&](const Found& other) { return other.is_same_case(found); });
    if (same != all.end()) {
      if (!(found < *same)) return;
      all.erase(same);
    }
    all.insert(std::ranges::lower_bound(all, found, std::less()), std::move(found));
    if (static_cast<std::int64_t>(all.size()) > most) all.pop_back();
  }
  void merge(const Kept& other) {
    most = std::max(most, other.most);
    for (std::size_t k = 0; k < of.size(); ++k)
      for (const auto& found : other.of[k]) add(k, found);
  }
};

/// Finds the exact value of a case, and its distance from a rounding boundary.
class Judge {
 public:
  Value value(Form form, const reference::Format& format, std::span<const double> coefficients, double t) {
    const CurveView<double> curve{form, 1, static_cast<int>(coefficients.size()) - 1, coefficients};
    Value value{.exact = exact_.point(curve, t).coordinate(0),
                .p_tilde = exact_.p_tilde(curve, t).coordinate(0),
                .distance = {}};
    value.distance = boundary_distance(format, value.exact);
    return value;
  }

 private:
  reference::ExactCurve exact_;
};

Found found_of(const Rational& measure, std::int64_t trial, const std::vector<double>& coefficients, double t) {
  const auto exponent = floor_log2(measure);
  Rational significand = measure;
  significand.exponent -= exponent;
  return {exponent, round_to(reference::binary64, significand), trial, coefficients, t};
}

/// A family in one scalar type is a part.
class HardCasesJob final : public run::JobOf<Kept> {
 public:
  HardCasesJob(const suite::Study& study, std::uint64_t seed)
      : study_(study), seed_(seed), blocks_(trials(), 1, block_trials) {
    for (const auto scalar : study_.scalar)
      for (std::size_t family = 0; family < hard::families<double>.size(); ++family) parts_.push_back({scalar, family});
  }

  [[nodiscard]] std::size_t parts() const override { return parts_.size(); }
  [[nodiscard]] std::size_t blocks_per_part() const override { return blocks_.count(); }
  [[nodiscard]] double cost(std::size_t /*part*/) const override { return 1e4 * static_cast<double>(blocks_.full()); }
  [[nodiscard]] run::Extent extent() const override {
    const auto rows = parts() * searches.size() * static_cast<std::size_t>(kept());
    return {parts(), rows, parts() * static_cast<std::uint64_t>(trials())};
  }
  void write(tables::Tables& tables) const override;

 protected:
  [[nodiscard]] Kept work(std::size_t block) const override {
    return judge::with_scalar(parts_[part_of(block)].scalar,
                              [&]<class Scalar>(Scalar /*zero*/) { return searched<Scalar>(block); });
  }

 private:
  struct Part {
    suite::ScalarKind scalar;
    std::size_t family;
  };

  [[nodiscard]] std::int64_t trials() const { return study_.trials * study_.replicates; }
  [[nodiscard]] std::int64_t kept() const { return study_.kept; }

  template <class Scalar>
  [[nodiscard]] Kept searched(std::size_t block) const {
    const auto& family = hard::families<Scalar>[parts_[part_of(block)].family];
    const auto cell = fmt::format("{};{};{}", family.name, name(study_.form), sizeof(Scalar));
    Kept best{.most = kept(), .of = {}};
    Judge values;
    run::each_trial(blocks_[block % blocks_per_part()], [&](std::int64_t trial) {
      hard::Draw<Scalar> draw(
          sample::Words(seed_, sample::key(study_.id), sample::key(cell), static_cast<std::uint64_t>(trial)));
      const auto drawn = family.draw(draw, study_.form);
      std::vector<double> coefficients;
      for (const Scalar c : drawn.coefficients) coefficients.push_back(double{c} + 0.0);  // no case with -0
      const double t = double{drawn.t} + 0.0;
      const auto value = values.value(study_.form, judge::ScalarFacts<Scalar>::format, coefficients, t);
      for (std::size_t k = 0; k < searches.size(); ++k)
        if (searches[k].wanted(value)) best.add(k, found_of(searches[k].measure(value), trial, coefficients, t));
    });
    return best;
  }

  static constexpr std::int64_t block_trials = 2048;

  suite::Study study_;
  std::uint64_t seed_;
  run::TrialBlocks blocks_;
  std::vector<Part> parts_;
};

void HardCasesJob::write(tables::Tables& tables) const {
  constexpr int distance_digits = 17;
  (void)tables.table("hard_cases.csv");
  Judge values;
  for (std::size_t part = 0; part < parts_.size(); ++part) {
    const auto scalar = parts_[part].scalar;
    const auto format =
        judge::with_scalar(scalar, []<class Scalar>(Scalar) { return judge::ScalarFacts<Scalar>::format; });
    for (std::size_t k = 0; k < searches.size(); ++k)
      for (const Found& found : state(part).of[k]) {
        const auto value = values.value(study_.form, format, found.coefficients, found.t);
        std::string coefficients;
        for (const double c : found.coefficients)
          coefficients += fmt::format("{}{}", coefficients.empty() ? "" : " ", number::hexadecimal(c));
        const auto rounded = [&](const reference::Format& to) {
          return tables::Hexadecimal{round_to(to, value.exact)};
        };
        tables.add(tables::Row("hard_cases.csv")
                       .set("study", study_.id)
                       .set("family", hard::families<double>[parts_[part].family].name)
                       .set("search", searches[k].id)
                       .set("drawn", trials())
                       .set("form", name(study_.form))
                       .set("scalar", suite::name(scalar))
                       .set("degree", found.coefficients.size() - 1)
                       .set("dimension", 1)
                       .set("t", tables::Hexadecimal{found.t})
                       .set("coefficients", coefficients)
                       .set("exact", significant(value.exact, decimal_digits))
                       .set("rounded", rounded(format))
                       .set("rounded_double", rounded(reference::binary64))
                       .set("rounded_float", rounded(reference::binary32))
                       .set("distance_ulp", significant(value.distance, distance_digits)));
      }
  }
}

std::unique_ptr<run::Job> hard_cases_job(const suite::Study& study, const run::JobContext& context) {
  return std::make_unique<HardCasesJob>(study, context.seed);
}

constexpr std::array hard_cases_fields{suite::field<&suite::Study::kept>(
    {.key = "kept",
     .meaning = "so many of the trials of a family are kept by each search, 1 to 1000",
     .example = "10"})};

constexpr std::array<std::string_view, 5> without{"dimension", "coordinate_range", "t_interval", "generator",
                                                  "methods"};

}  // namespace

extern constexpr StudyKind hard_cases_kind{
    .asks = {.id = "hard_cases",
             .about = "inputs whose exact values are hard to round: ties, numbers beside them, cancellation",
             .own = hard_cases_fields,
             .methods_example = {},
             .inputs = {.forms = suite::polynomial_forms,
                        .forms_reason = "the families are of polynomials",
                        .degree = suite::DegreeUse::not_a_key,
                        .degree_reason = "degree is drawn with the case",
                        .sets = suite::SetUse::none,
                        .sets_reason = "a family draws the whole case"},
             .without = without,
             .without_reason = "a family draws the whole case, of one coordinate, and no method takes part"},
    .make = hard_cases_job};

namespace {

using reference::Rational;

/// floor(value) of a value >= 0.
mpz_class floor_of(const Rational& value) {
  mpz_class whole;
  const auto by = static_cast<mp_bitcnt_t>(std::abs(value.exponent));
  if (value.exponent >= 0)
    mpz_mul_2exp(whole.get_mpz_t(), value.numerator.get_mpz_t(), by);
  else
    mpz_fdiv_q_2exp(whole.get_mpz_t(), value.numerator.get_mpz_t(), by);
  return whole;
}

mpz_class power(unsigned long base, long exponent) {
  mpz_class result;
  mpz_ui_pow_ui(result.get_mpz_t(), base, static_cast<unsigned long>(exponent));
  return result;
}

Rational nearer(const Rational& a, const Rational& b) { return less(a, b) ? a : b; }

/// |value| 10^-lowest to the nearest integer, ties to even.
mpz_class rounded_at(const Rational& value, long lowest) {
  mpz_class numerator =
      ::abs(value.numerator) * power(2, std::max(0L, value.exponent)) * power(10, std::max(0L, -lowest));
  const mpz_class denominator = power(2, std::max(0L, -value.exponent)) * power(10, std::max(0L, lowest));
  mpz_class rest;
  mpz_fdiv_qr(numerator.get_mpz_t(), rest.get_mpz_t(), numerator.get_mpz_t(), denominator.get_mpz_t());
  const int half = cmp(mpz_class(2 * rest), denominator);
  if (half > 0 || (half == 0 && mpz_odd_p(numerator.get_mpz_t()) != 0)) ++numerator;
  return numerator;
}

}  // namespace

Rational boundary_distance(const reference::Format& format, const Rational& value) {
  const Rational half{1, 1, -1};
  long spacing = format.lowest_exponent;
  if (value.numerator != 0)
    spacing = std::clamp(floor_log2(value) - format.precision + 1, spacing, format.highest_exponent - format.precision);
  const Rational position{::abs(value.numerator), 1, value.exponent - spacing};
  const mpz_class below = floor_of(position);
  const mpz_class end = power(2, format.precision);
  if (below >= end) return position - (Rational{end} - half);
  const Rational above = position - Rational{below};  // in [0, 1)
  const Rational distance = abs(above - half);
  // Below a power of two numbers are half as far apart, and the midpoint a quarter of the spacing away.
  if (2 * below == end && spacing > format.lowest_exponent) return nearer(distance, above + Rational{1, 1, -2});
  return distance;
}

std::string significant(const Rational& value, int digits) {
  if (value.numerator == 0) return "0";
  constexpr double decades_per_binade = 0.30102999566398120;
  auto decade = static_cast<long>(std::floor(static_cast<double>(floor_log2(value)) * decades_per_binade));
  std::string text = rounded_at(value, decade - digits + 1).get_str();
  while (static_cast<int>(text.size()) != digits) {  // the first guess was from the binade, or rounding added a digit
    decade += static_cast<long>(text.size()) - digits;
    text = rounded_at(value, decade - digits + 1).get_str();
  }
  text.erase(text.find_last_not_of('0') + 1);
  if (text.size() > 1) text.insert(1, ".");
  return fmt::format("{}{}{}", value.numerator < 0 ? "-" : "", text, decade == 0 ? "" : fmt::format("e{:+}", decade));
}

}  // namespace bezierbench::studies
