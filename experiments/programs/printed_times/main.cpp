// SPDX-License-Identifier: MIT
// Times the methods of table 2.4 of [Report 001] coded as it describes them, for scripts/check printed_times: points with
// operators in containers, tables of factorials and powers made in each call (sections 1.1 to 1.4), and a conversion for
// each point. It includes no header of core: it measures this coding, compiled with and without optimisation.
//
// printed_times [ROUNDS]   prints form,method,degree,ms: the minimum processor time of 1000 evaluations, each of a curve of
// its own
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <ctime>
#include <functional>
#include <iostream>
#include <limits>
#include <random>
#include <string>
#include <vector>

namespace {

struct Point {
  double x, y;
};
Point operator+(const Point& a, const Point& b) { return {a.x + b.x, a.y + b.y}; }
Point operator-(const Point& a, const Point& b) { return {a.x - b.x, a.y - b.y}; }
Point operator*(double s, const Point& p) { return {s * p.x, s * p.y}; }

using Points = std::vector<Point>;

std::vector<double> factorials(std::size_t n) {
  std::vector<double> table(n + 1, 1);
  for (std::size_t i = 1; i <= n; ++i) table[i] = table[i - 1] * static_cast<double>(i);
  return table;
}

std::vector<double> powers(double base, std::size_t n) {
  std::vector<double> table(n + 1, 1);
  for (std::size_t i = 1; i <= n; ++i) table[i] = table[i - 1] * base;
  return table;
}

/// Section 1.4.
Point direct(const Points& b, double t) {
  const std::size_t n = b.size() - 1;
  const auto factorial = factorials(n);
  const auto t_powers = powers(t, n);
  const auto s_powers = powers(1 - t, n);
  Point sum{0, 0};
  for (std::size_t i = 0; i <= n; ++i) {
    const double basis = factorial[n] / (factorial[i] * factorial[n - i]) * t_powers[i] * s_powers[n - i];
    sum = sum + basis * b[i];
  }
  return sum;
}

/// Section 1.5, in one container: level k takes the place of level k - 1.
Point de_casteljau(const Points& b, double t) {
  Points level = b;
  for (std::size_t k = 1; k < b.size(); ++k)
    for (std::size_t i = 0; i + k < b.size(); ++i) level[i] = (1 - t) * level[i] + t * level[i + 1];
  return level[0];
}

/// Coefficient i, j of the matrix of sections 1.1 and 1.2.
double coefficient(const std::vector<double>& factorial, std::size_t n, std::size_t i, std::size_t j) {
  const double sign = (j - i) % 2 == 0 ? 1 : -1;
  return sign * factorial[n] / (factorial[i] * factorial[n - j] * factorial[j - i]);
}

/// Section 1.1.
Points to_power(const Points& b) {
  const std::size_t n = b.size() - 1;
  const auto factorial = factorials(n);
  Points q(n + 1, Point{0, 0});
  for (std::size_t j = 0; j <= n; ++j)
    for (std::size_t i = 0; i <= j; ++i) q[j] = q[j] + coefficient(factorial, n, i, j) * b[i];
  return q;
}

/// Section 1.2.
Points to_bernstein(const Points& q) {
  const std::size_t n = q.size() - 1;
  const auto factorial = factorials(n);
  Points b(n + 1, Point{0, 0});
  for (std::size_t j = 0; j <= n; ++j) {
    Point sum{0, 0};
    for (std::size_t i = 0; i < j; ++i) sum = sum + coefficient(factorial, n, i, j) * b[i];
    b[j] = 1 / coefficient(factorial, n, j, j) * (q[j] - sum);
  }
  return b;
}

/// Section 1.3.
Point power_sum(const Points& q, double t) {
  Point sum{0, 0};
  double power = 1;
  for (const Point& coefficient : q) {
    sum = sum + power * coefficient;
    power *= t;
  }
  return sum;
}

struct Method {
  std::string form, name;
  std::function<Point(const Points&, double)> evaluate;
};

const std::vector<Method> methods{
    {"bernstein", "direct", direct},
    {"bernstein", "de_casteljau", de_casteljau},
    {"bernstein", "factorial:power_sum", [](const Points& b, double t) { return power_sum(to_power(b), t); }},
    {"power", "power_sum", power_sum},
    {"power", "forward_substitution:direct", [](const Points& q, double t) { return direct(to_bernstein(q), t); }},
    {"power", "forward_substitution:de_casteljau",
     [](const Points& q, double t) { return de_casteljau(to_bernstein(q), t); }}};

constexpr int curves = 1000;   // section 2.4
constexpr double range = 1e6;  // section 2.4
constexpr double alike =
    1e-5;  // of the range: the largest error that the report prints is 0.054, for coordinates in 1e6

struct Problem {
  std::vector<Points> points;
  std::vector<double> t;
};

Problem problem(std::size_t degree) {
  std::mt19937_64 words(degree);
  const auto uniform = [&](double low, double high) {
    return low + (high - low) * (static_cast<double>(words() >> 11) * 0x1p-53);
  };
  Problem made;
  for (int k = 0; k < curves; ++k) {
    Points points;
    for (std::size_t i = 0; i <= degree; ++i) points.push_back({uniform(-range, range), uniform(-range, range)});
    made.points.push_back(points);
    made.t.push_back(uniform(0, 1));
  }
  return made;
}

}  // namespace

int main(int count, char** arguments) {
  const int rounds = count > 1 ? std::atoi(arguments[1]) : 41;
  std::cout << "form,method,degree,ms\n";
  for (const std::size_t degree : {4, 8, 12, 16, 20}) {
    const Problem given = problem(degree);
    std::vector<double> min_ms(methods.size(), std::numeric_limits<double>::infinity());
    std::vector<Points> found(methods.size(), Points(curves));
    for (int round = 0; round < rounds; ++round)
      for (std::size_t m = 0; m < methods.size(); ++m) {
        const std::clock_t begin = std::clock();
        for (std::size_t k = 0; k < curves; ++k) found[m][k] = methods[m].evaluate(given.points[k], given.t[k]);
        min_ms[m] = std::min(min_ms[m], 1e3 * static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC);
      }
    for (std::size_t m = 0; m < methods.size(); ++m) {
      std::cout << methods[m].form << ',' << methods[m].name << ',' << degree << ',' << min_ms[m] << '\n';
      const std::size_t first = methods[m].form == "bernstein" ? 0 : 3;
      for (std::size_t k = 0; k < curves; ++k) {
        const Point apart = found[m][k] - found[first][k];
        if (!(std::hypot(apart.x, apart.y) <= alike * range)) {
          std::cerr << "printed_times: " << methods[m].name << " and " << methods[first].name << " are "
                    << std::hypot(apart.x, apart.y) << " apart at degree " << degree << '\n';
          return 1;
        }
      }
    }
  }
  return 0;
}
