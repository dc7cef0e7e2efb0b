// SPDX-License-Identifier: MIT
// The formula that each method states as its flops, against what is counted when it runs.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <string>
#include <string_view>

#include "core/evaluate/roster.hpp"
#include "core/operations/operations.hpp"

namespace bezierbench {
namespace {

/// Evaluates sums of products in n and d as methods write them: "3d n(n+1)/2 + 1", "2dn + log2 n".
class Formula {
 public:
  Formula(std::string_view text, double n, double d) : text_(text), n_(n), d_(d) {}

  double value() {
    const double sum = this->sum();
    EXPECT_TRUE(text_.empty()) << "'" << text_ << "' is not part of a formula";
    return sum;
  }

 private:
  void skip_blanks() { text_.remove_prefix(std::min(text_.find_first_not_of(' '), text_.size())); }
  bool take(std::string_view word) {
    skip_blanks();
    if (!text_.starts_with(word)) return false;
    text_.remove_prefix(word.size());
    return true;
  }
  double sum() {
    double result = product();
    for (;;) {
      if (take("+"))
        result += product();
      else if (take("-"))
        result -= product();
      else
        return result;
    }
  }
  /// Factors stand side by side.
  double product() {
    double result = factor();
    for (;;) {
      if (take("/")) {
        result /= factor();
        continue;
      }
      skip_blanks();
      if (text_.empty() || std::string_view("+-)").find(text_.front()) != std::string_view::npos) return result;
      result *= factor();
    }
  }
  double factor() {
    if (take("(")) {
      const double inside = sum();
      EXPECT_TRUE(take(")"));
      return inside;
    }
    if (take("log2 n")) return std::log2(n_);
    if (take("n")) return n_;
    if (take("d")) return d_;
    const std::string number(text_.substr(0, text_.find_first_not_of("0123456789")));
    EXPECT_FALSE(number.empty()) << "'" << text_ << "' begins with no number";
    text_.remove_prefix(number.empty() ? text_.size() : number.size());
    return std::atof(number.c_str());
  }

  std::string_view text_;
  double n_;
  double d_;
};

/// What stands before `word`, and `text` is left with what stands behind it.
std::string_view up_to(std::string_view word, std::string_view& text) {
  const auto at = text.find(word);
  const auto before = text.substr(0, at);
  text = at == std::string_view::npos ? std::string_view() : text.substr(at + word.size());
  return before;
}

/// What a method states of its operations at one degree and dimension.
struct Stated {
  double least;
  double most;
  double divisions;  ///< -1 where it does not say
};

Stated stated(std::string_view text, int n, int d) {
  constexpr std::string_view lifted = " with d + 1 for d; d divisions";
  if (text.ends_with(lifted)) {
    auto inner = stated(text.substr(0, text.size() - lifted.size()), n, d + 1);
    inner.least += d;
    inner.most += d;
    if (inner.divisions >= 0) inner.divisions += d;
    return inner;
  }
  const bool at_most = text.starts_with("at most ");
  if (at_most) text.remove_prefix(std::string_view("at most ").size());
  std::string_view rest = text;
  std::string_view totals = up_to(", ", rest);
  Stated result{HUGE_VAL, 0, -1};
  while (!totals.empty()) {
    const double total = Formula(up_to(" or ", totals), n, d).value();
    result.least = std::min(result.least, total);
    result.most = std::max(result.most, total);
  }
  while (!rest.empty()) {
    std::string_view remark = up_to(", ", rest);
    if (remark.ends_with(" of them divisions")) {
      result.divisions = Formula(up_to(" of them", remark), n, d).value();
      continue;
    }
    std::string_view parity = remark;
    const double fewer = Formula(up_to(" fewer for ", parity), n, d).value();
    if (parity == (n % 2 == 0 ? "even n" : "odd n")) {
      result.least -= fewer;
      result.most -= fewer;
    }
  }
  // A power by squaring takes between log2 n and 2 log2 n products, and log2 n is rarely a whole number.
  if (at_most) result.least *= 0.6;
  return result;
}

template <class... Es>
void expect_stated_flops(TypeList<Es...> /*evaluators*/) {
  for (const MethodInfo* method : {&Es::info...})
    for (const int n : {3, 5, 8, 12, 13})
      for (const int d : {1, 2, 3}) {
        const auto counted = point_operations(*method, n, d, Layout::points);
        if (!counted) continue;  // libm does the work
        EXPECT_EQ(method->fused, (*counted)[Operation::fused] > 0) << method->id << " says whether it is fused";
        const auto claim = stated(method->flops, n, d);
        EXPECT_LE(counted->flops(), claim.most)
            << method->id << " (" << method->flops << "), n = " << n << ", d = " << d;
        EXPECT_GE(counted->flops(), claim.least)
            << method->id << " (" << method->flops << "), n = " << n << ", d = " << d;
        if (claim.divisions >= 0) {
          EXPECT_EQ((*counted)[Operation::divide], claim.divisions) << method->id << ", n = " << n << ", d = " << d;
        }
      }
}

TEST(Flops, AreThoseThatAreCounted) { expect_stated_flops(Evaluators()); }

TEST(Flops, FormulasAreRead) {
  EXPECT_EQ(Formula("3d n(n+1)/2 + 1", 4, 2).value(), 61);
  EXPECT_EQ(stated("9dn/2 + 1, 3d/2 fewer for odd n", 3, 2).most, 25);
  EXPECT_EQ(stated("n(5+3d) + 3, n + 1 of them divisions", 4, 1).divisions, 5);
  EXPECT_EQ(stated("2dn with d + 1 for d; d divisions", 4, 1).most, 17);
}

}  // namespace
}  // namespace bezierbench
