// SPDX-License-Identifier: MIT
#include "reference/companion/integer_polynomial.hpp"

#include <algorithm>
#include <cstdint>
#include <utility>

#include "reference/stop.hpp"

namespace bezierbench::reference {
namespace {

void trim(IntegerPolynomial& p) {
  while (!p.empty() && p.back() == 0) p.pop_back();
}

/// Divides polynomials by the greatest common divisor of all their coefficients.
template <class... Polynomials>
void make_primitive(Polynomials&... polynomials) {
  mpz_class content = 0;
  const auto add = [&](const IntegerPolynomial& p) {
    for (auto c = p.begin(); c != p.end() && content != 1; ++c) {
      StopWhen::poll();
      content = gcd(content, *c);
    }
  };
  const auto divide_by_content = [&](IntegerPolynomial& p) {
    for (auto& c : p) mpz_divexact(c.get_mpz_t(), c.get_mpz_t(), content.get_mpz_t());
  };
  (add(polynomials), ...);
  if (content > 1) (divide_by_content(polynomials), ...);
}

/// Replaces a by its remainder over b, up to a factor, and returns the quotient up to a factor; deg a >= deg b.
IntegerPolynomial divide(IntegerPolynomial& a, const IntegerPolynomial& b) {
  IntegerPolynomial quotient(a.size() - b.size() + 1, 0);
  for (std::size_t top = a.size(); top >= b.size(); --top) {
    StopWhen::poll();
    const mpz_class factor = a[top - 1];
    const std::size_t shift = top - b.size();
    for (auto& c : quotient) c *= b.back();
    quotient[shift] += factor;
    for (auto& c : a) c *= b.back();
    for (std::size_t i = 0; i < b.size(); ++i) a[shift + i] -= factor * b[i];
  }
  trim(a);
  return quotient;
}

/// Whether a and b, which are not zero, have no common divisor modulo a prime that does not divide the last coefficient
/// of a. Then they have none: a common divisor would keep its degree. Remainders of integers take much longer.
bool are_coprime_modulo_a_prime(const IntegerPolynomial& a, const IntegerPolynomial& b) {
  constexpr std::uint64_t prime = 0x7fffffff;
  using Residues = std::vector<std::uint64_t>;
  const auto trimmed = [](Residues& p) {
    while (!p.empty() && p.back() == 0) p.pop_back();
  };
  const auto residues = [&](const IntegerPolynomial& p) {
    Residues result;
    for (const auto& c : p) result.push_back(mpz_fdiv_ui(c.get_mpz_t(), prime));
    trimmed(result);
    return result;
  };
  const auto inverse = [](std::uint64_t x) {  // x^(prime - 2)
    std::uint64_t power = 1;
    for (std::uint64_t e = prime - 2; e > 0; e /= 2, x = x * x % prime)
      if (e % 2 == 1) power = power * x % prime;
    return power;
  };
  auto dividend = residues(a);
  auto divisor = residues(b);
  if (dividend.size() < a.size()) return false;
  while (!divisor.empty()) {
    const std::uint64_t factor = prime - inverse(divisor.back());
    while (dividend.size() >= divisor.size()) {
      const std::uint64_t by = dividend.back() * factor % prime;
      const std::size_t shift = dividend.size() - divisor.size();
      for (std::size_t i = 0; i < divisor.size(); ++i)
        dividend[shift + i] = (dividend[shift + i] + by * divisor[i]) % prime;
      trimmed(dividend);
    }
    std::swap(dividend, divisor);
  }
  return dividend.size() == 1;
}

/// p(t + by).
void shift(IntegerPolynomial& p, const mpz_class& by) {
  for (std::size_t last = 0; last + 1 < p.size(); ++last) {
    StopWhen::poll();
    for (std::size_t i = p.size() - 1; i > last; --i)
      mpz_addmul(p[i - 1].get_mpz_t(), p[i].get_mpz_t(), by.get_mpz_t());
  }
}

/// 2^m p(t / 2).
void stretch(IntegerPolynomial& p) {
  for (std::size_t i = 0; i < p.size(); ++i) p[i] <<= p.size() - 1 - i;
}

/// Sign variations of (1 + x)^m p(1 / (1 + x)): at least as many as p has roots in (0, 1), and of the same parity.
int variations(IntegerPolynomial p) {
  std::reverse(p.begin(), p.end());
  shift(p, 1);
  int count = 0;
  int last = 0;
  for (const auto& c : p) {
    const int sign = sgn(c);
    if (sign == 0) continue;
    count += last == -sign ? 1 : 0;
    last = sign;
  }
  return count;
}

/// Divides by the largest power of t that divides p; true if that is not 1.
bool drop_root_at_zero(IntegerPolynomial& p) {
  const auto first = std::find_if(p.begin(), p.end(), [](const mpz_class& c) { return c != 0; });
  const bool found = first != p.begin();
  p.erase(p.begin(), first);
  return found;
}

/// The roots in [0, 1) of p, which is the square-free polynomial over [k, k+1] / 2^shift.
void isolate(IntegerPolynomial p, const Dyadic& place, std::vector<RootInterval>& roots) {
  if (drop_root_at_zero(p)) roots.push_back({place, true});
  const int count = variations(p);
  if (count == 0) return;
  if (count == 1) {
    roots.push_back({place, false});
    return;
  }
  stretch(p);
  Dyadic half{place.k * 2, place.shift + 1};
  isolate(p, half, roots);
  shift(p, 1);
  ++half.k;
  isolate(std::move(p), half, roots);
}

/// One step of the refinement: cuts the interval into 2^cut parts and takes the one in which the secant meets zero, if
/// the signs at its ends say so.
bool take_guess(const IntegerPolynomial& p, RootInterval& root, unsigned long cut) {
  const mpz_class left = value_at(p, root.t);
  const mpz_class right = value_at(p, {root.t.k + 1, root.t.shift});
  const mpz_class denominator = left - right;
  if (denominator == 0) return false;
  mpz_class numerator = left << cut;
  mpz_class part;
  mpz_fdiv_q(part.get_mpz_t(), numerator.get_mpz_t(), denominator.get_mpz_t());
  const mpz_class parts = mpz_class(1) << cut;
  if (part < 0 || part >= parts) return false;
  const Dyadic a{(root.t.k << cut) + part, root.t.shift + cut};
  const int at_a = part == 0 ? sgn(left) : sign_at(p, a);
  if (at_a == 0 && part != 0) {
    root = {a, true};
    return true;
  }
  const int at_b = part + 1 == parts ? sgn(right) : sign_at(p, {a.k + 1, a.shift});
  if (at_a * at_b >= 0) return false;
  root.t = a;
  return true;
}

/// Halves an interval at one of whose ends p may be zero (another root): the sign inside then follows from the middle.
void halve(const IntegerPolynomial& p, RootInterval& root) {
  const Dyadic middle{root.t.k * 2 + 1, root.t.shift + 1};
  const int at_middle = sign_at(p, middle);
  if (at_middle == 0) {
    root = {middle, true};
    return;
  }
  int at_left = sign_at(p, root.t);
  if (at_left == 0) at_left = sign_at(derivative(p), root.t);  // simple roots: the sign just right of it
  root.t = at_left == at_middle ? middle : Dyadic{root.t.k * 2, root.t.shift + 1};
}

}  // namespace

IntegerPolynomial from_scaled_bernstein(const std::vector<mpz_class>& c) {
  IntegerPolynomial p;  // Horner in s = 1-t over t: p <- p (1-t) + c_k t^k
  for (std::size_t k = 0; k < c.size(); ++k) {
    StopWhen::poll();
    p.emplace_back(0);
    for (std::size_t i = p.size() - 1; i > 0; --i) p[i] -= p[i - 1];
    p[k] += c[k];
  }
  trim(p);
  return p;
}

IntegerPolynomial from_bernstein(const std::vector<Rational>& b, long& exponent) {
  exponent = std::ranges::min(b, {}, &Rational::exponent).exponent;
  std::vector<mpz_class> scaled;
  const int n = static_cast<int>(b.size()) - 1;
  mpz_class binomial = 1;
  for (int i = 0; i <= n; ++i) {
    const auto& x = b[static_cast<std::size_t>(i)];
    scaled.emplace_back((x.numerator << static_cast<mp_bitcnt_t>(x.exponent - exponent)) * binomial);
    binomial = binomial * (n - i) / (i + 1);
  }
  return from_scaled_bernstein(scaled);
}

IntegerPolynomial derivative(const IntegerPolynomial& p) {
  IntegerPolynomial result;
  for (std::size_t i = 1; i < p.size(); ++i) result.emplace_back(p[i] * static_cast<unsigned long>(i));
  return result;
}

IntegerPolynomial product(const IntegerPolynomial& a, const IntegerPolynomial& b) {
  IntegerPolynomial result(a.empty() || b.empty() ? 0 : a.size() + b.size() - 1, 0);
  for (std::size_t i = 0; i < a.size(); ++i) {
    StopWhen::poll();
    for (std::size_t j = 0; j < b.size(); ++j) result[i + j] += a[i] * b[j];
  }
  return result;
}

IntegerPolynomial difference(IntegerPolynomial a, const IntegerPolynomial& b) {
  a.resize(std::max(a.size(), b.size()), 0);
  for (std::size_t i = 0; i < b.size(); ++i) a[i] -= b[i];
  trim(a);
  return a;
}

IntegerPolynomial mirrored(IntegerPolynomial p) {
  shift(p, 1);
  for (std::size_t i = 1; i < p.size(); i += 2) p[i] = -p[i];
  return p;
}

IntegerPolynomial greatest_common_divisor(IntegerPolynomial a, IntegerPolynomial b) {
  if (a.size() < b.size()) std::swap(a, b);
  if (!b.empty() && are_coprime_modulo_a_prime(a, b)) return {1};
  make_primitive(a);
  make_primitive(b);
  while (!b.empty()) {
    divide(a, b);
    make_primitive(a);
    std::swap(a, b);
  }
  return a;
}

IntegerPolynomial square_free(const IntegerPolynomial& p) {
  const auto common = greatest_common_divisor(p, derivative(p));
  auto rest = p;
  auto quotient = common.size() < 2 ? p : divide(rest, common);
  make_primitive(quotient);
  return quotient;
}

std::vector<IntegerPolynomial> square_free_factors(const IntegerPolynomial& p) {
  const auto quotient = [](IntegerPolynomial a, const IntegerPolynomial& b) {
    if (b.size() < 2) return a;
    auto result = divide(a, b);
    make_primitive(result);
    return result;
  };
  std::vector<IntegerPolynomial> factors;
  auto repeated = greatest_common_divisor(p, derivative(p));
  for (auto rest = quotient(p, repeated); rest.size() > 1;) {  // each root of a_k a_(k+1) ... once
    const auto later = greatest_common_divisor(rest, repeated);
    factors.push_back(quotient(rest, later));
    repeated = quotient(repeated, later);
    rest = later;
  }
  return factors;
}

IntegerPolynomial minimal_polynomial(const IntegerPolynomial& value, const IntegerPolynomial& modulus) {
  struct Row {
    IntegerPolynomial remainder;
    IntegerPolynomial p;  ///< p(value) = remainder, up to a factor
  };
  std::vector<Row> rows(modulus.size());  // at the size of their remainders
  const auto eliminate = [&rows](Row& row) {
    const Row& other = rows[row.remainder.size()];
    const mpz_class row_leading = other.remainder.back();
    const mpz_class other_leading = row.remainder.back();
    for (auto [mine, others] : {std::pair(&row.remainder, &other.remainder), std::pair(&row.p, &other.p)}) {
      for (auto& c : *mine) c *= row_leading;
      for (std::size_t i = 0; i < others->size(); ++i) {
        StopWhen::poll();
        (*mine)[i] -= other_leading * (*others)[i];
      }
    }
    trim(row.remainder);
  };
  for (Row row{{1}, {1}};;) {
    while (!row.remainder.empty() && !rows[row.remainder.size()].remainder.empty()) eliminate(row);
    make_primitive(row.remainder, row.p);
    if (row.remainder.empty()) return row.p;
    rows[row.remainder.size()] = row;
    row.remainder = product(row.remainder, value);
    row.p.insert(row.p.begin(), 0);
    if (row.remainder.size() < modulus.size()) continue;
    mpz_class factor;
    mpz_pow_ui(factor.get_mpz_t(), modulus.back().get_mpz_t(), row.remainder.size() - modulus.size() + 1);
    divide(row.remainder, modulus);
    for (auto& c : row.p) c *= factor;
  }
}

bool has_one_root(IntegerPolynomial p, const Dyadic& low, const mpz_class& width) {
  for (std::size_t i = 0; i < p.size(); ++i) p[i] <<= low.shift * (p.size() - 1 - i);
  shift(p, low.k);
  mpz_class power = 1;
  for (auto& c : p) {
    c *= power;
    power *= width;
  }
  return variations(std::move(p)) == 1;
}

mpz_class value_at(const IntegerPolynomial& p, const Dyadic& t) {
  mpz_class value = 0;
  for (std::size_t i = p.size(); i-- > 0;) {
    StopWhen::poll();
    value = value * t.k + (p[i] << (t.shift * (p.size() - 1 - i)));
  }
  return value;
}

int sign_at(const IntegerPolynomial& p, const Dyadic& t) { return sgn(value_at(p, t)); }

std::vector<RootInterval> isolate_roots(const IntegerPolynomial& p) {
  std::vector<RootInterval> roots;
  isolate(p, {0, 0}, roots);
  if (sign_at(p, {1, 0}) == 0) roots.push_back({{1, 0}, true});
  return roots;
}

void refine(const IntegerPolynomial& p, RootInterval& root, unsigned long bits) {
  unsigned long cut = 2;
  while (!root.exact && root.t.shift < bits) {
    if (take_guess(p, root, cut)) {
      cut *= 2;
      continue;
    }
    halve(p, root);
    cut = std::max(cut / 2, 2UL);
  }
}

}  // namespace bezierbench::reference
