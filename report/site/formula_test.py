# SPDX-License-Identifier: MIT
"""Formulas of headers as TeX: what is mathematics, what stays a word."""
import unittest

from .formula import segments


def written(text):
    """The text with $ around what is mathematics, without blanks that TeX does not see."""
    return "".join(f"${part.replace('  ', ' ')}$" if is_math else part for is_math, part in segments(text))


class Formula(unittest.TestCase):
    def check(self, text, expected):
        self.assertEqual(written(text), expected)

    def test_indices_and_powers(self):
        self.check("b_i^k = (1-t) b_i^(k-1) + t b_(i+1)^(k-1), p(t) = b_0^n.",
                   "$b_{i}^{k} = (1-t) b_{i}^{k-1} + t b_{i+1}^{k-1}$, $p(t) = b_{0}^{n}$.")
        self.check("gamma_3n p~ and 2^-26", r"$\gamma _{3n} \tilde p$ and $2^{-26}$")
        self.check("U = A' W - B_i' B_j", "$U = A' W - B_{i}' B_{j}$")
        self.check("h_i B_i,n-k(t)", "$h_{i} B_{i,n-k}(t)$")

    def test_words_stay_words(self):
        self.check("p = p t + q_j for j = n-1..0, a product at a time", r"$p = p t + q_{j}$ for $j = n-1\ldots 0$, a product at a time")
        self.check("the sum of a term and horner_bernstein_fma (barycentric.hpp)", "the sum of a term and horner_bernstein_fma (barycentric.hpp)")
        self.check("changes its sign; q = sign(b) sqrt(b^2 - a c)", r"changes its sign; $q = \operatorname{sign} (b) \sqrt{b^{2} - a c}$")
        self.check("where it is as in [Farin 2002], 24 points", "where it is as in [Farin 2002], 24 points")
        self.check("the tolerance is [Chromium 2014]'s", "the tolerance is [Chromium 2014]'s")
        self.check("S_left is known", r"$S_{\mathrm{left}}$ is known")

    def test_functions(self):
        self.check("C(n,i) q_j", r"$\binom{n}{i} q_{j}$")
        self.check("C(t_i) = C^(k)(t)", "$C(t_{i}) = C^{(k)}(t)$")
        self.check("sum_(i<=j) x <= sum |b_i|", r"$\sum _{i\le j} x \le \sum |b_{i}|$")
        self.check("(C - P).C' < 1e-7", r"$(C - P)\cdot C' < 10^{-7}$")
        self.check("floor(n/2) and 2dn", r"$\lfloor n/2\rfloor$ and $2dn$")


if __name__ == "__main__":
    unittest.main()
