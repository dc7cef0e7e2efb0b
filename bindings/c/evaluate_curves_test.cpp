// SPDX-License-Identifier: MIT
// Many parameters, and many curves, in one call: each point has the bits that the method's own kernel gives for it alone.
#include <bezierbench/bezierbench.h>
#include <gtest/gtest.h>
#include <pthread.h>

#include <algorithm>
#include <cstdlib>
#include <limits>
#include <new>
#include <random>
#include <string>
#include <thread>
#include <vector>

namespace {

thread_local int allocations = 0;

}  // namespace

// Not inline: GCC would complain of pairs that it sees only in part.
[[gnu::noinline]] void* operator new(std::size_t size) {
  ++allocations;
  if (void* memory = std::malloc(size)) return memory;
  throw std::bad_alloc();
}
[[gnu::noinline]] void* operator new(std::size_t size, std::align_val_t alignment) {
  ++allocations;
  const auto align = static_cast<std::size_t>(alignment);
  if (void* memory = std::aligned_alloc(align, (size + align - 1) / align * align)) return memory;
  throw std::bad_alloc();
}
[[gnu::noinline]] void operator delete(void* memory) noexcept { std::free(memory); }
[[gnu::noinline]] void operator delete(void* memory, std::size_t /*size*/) noexcept { std::free(memory); }
[[gnu::noinline]] void operator delete(void* memory, std::align_val_t /*alignment*/) noexcept { std::free(memory); }

namespace {

template <class Scalar>
int evaluate(const char* method, const bb_batch& batch, const Scalar* points, const Scalar* weights, const Scalar* t,
             Scalar* out) {
  if constexpr (std::is_same_v<Scalar, float>)
    return bb_evaluate_curves_float(method, &batch, points, weights, t, out);
  else
    return bb_evaluate_curves(method, &batch, points, weights, t, out);
}

template <class Scalar>
std::vector<Scalar> numbers(std::size_t count, double from, double to) {
  static std::mt19937_64 random(36);
  std::vector<Scalar> result(count);
  for (Scalar& number : result) number = static_cast<Scalar>(from + (to - from) * 0x1p-53 * double(random() >> 11));
  return result;
}

/// Curves with their parameters, curve after curve.
template <class Scalar>
struct Problem {
  Problem(const bb_method& given, int dimension, int degree, std::size_t curves, std::size_t count)
      : method(given), batch{given.form, dimension, degree, curves, count, nullptr, nullptr, nullptr} {
    const auto coefficients = static_cast<std::size_t>(degree) + 1;
    points = numbers<Scalar>(curves * coefficients * d(), -1, 1);
    weights = numbers<Scalar>(curves * coefficients, 0.5, 2);
    t = given.unit_interval_only != 0 ? numbers<Scalar>(curves * count, 0, 1)
                                      : numbers<Scalar>(curves * count, -0.5, 1.5);
  }
  [[nodiscard]] std::size_t d() const { return static_cast<std::size_t>(batch.dimension); }
  [[nodiscard]] const Scalar* weights_of(std::size_t curve) const {
    return batch.form == BB_RATIONAL ? &weights[curve * (static_cast<std::size_t>(batch.degree) + 1)] : nullptr;
  }

  /// Curve after curve, with fewer points in a call than are evaluated side by side.
  [[nodiscard]] std::vector<Scalar> alone() const {
    std::vector<Scalar> out(batch.curves * batch.count * d());
    auto one = batch;
    one.curves = 1;
    for (std::size_t k = 0; k < t.size(); k += one.count) {
      const std::size_t curve = k / batch.count;
      one.count = std::min<std::size_t>(7, (curve + 1) * batch.count - k);
      const Scalar* own_points = &points[curve * points.size() / batch.curves];
      EXPECT_EQ(evaluate(method.id, one, own_points, weights_of(curve), &t[k], &out[k * d()]), BB_OK);
    }
    return out;
  }

  [[nodiscard]] std::vector<Scalar> together() const {
    std::vector<Scalar> out(batch.curves * batch.count * d());
    EXPECT_EQ(evaluate(method.id, batch, points.data(), weights_of(0), t.data(), out.data()), BB_OK);
    return out;
  }

  /// The same with every index of every array in the opposite order of steps: one array for each axis of each point.
  [[nodiscard]] std::vector<Scalar> by_axis() const {
    const std::size_t m = batch.curves;
    const auto strides = [&](std::size_t along) {
      return bb_strides{1, static_cast<std::ptrdiff_t>(m), static_cast<std::ptrdiff_t>(m * along)};
    };
    const auto turned = [m](const std::vector<Scalar>& values, std::size_t along, std::size_t axes, bool back) {
      std::vector<Scalar> result(values.size());
      for (std::size_t c = 0; c < m; ++c)
        for (std::size_t i = 0; i < along; ++i)
          for (std::size_t axis = 0; axis < axes; ++axis) {
            const std::size_t dense = (c * along + i) * axes + axis;
            const std::size_t other = (axis * along + i) * m + c;
            result[back ? dense : other] = values[back ? other : dense];
          }
      return result;
    };
    const auto coefficients = static_cast<std::size_t>(batch.degree) + 1;
    const auto of_points = strides(coefficients);
    const auto of_out = strides(batch.count);
    auto other = batch;
    other.points = &of_points;
    other.t = other.out = &of_out;
    std::vector<Scalar> out(m * batch.count * d());
    EXPECT_EQ(evaluate(method.id, other, turned(points, coefficients, d(), false).data(), weights_of(0),
                       turned(t, batch.count, 1, false).data(), out.data()),
              BB_OK);
    return turned(out, batch.count, d(), true);
  }

  bb_method method;
  bb_batch batch;
  std::vector<Scalar> points;
  std::vector<Scalar> weights;
  std::vector<Scalar> t;
};

std::vector<bb_method> evaluators() {
  std::vector<bb_method> result;
  bb_method method;
  for (std::size_t k = 0; bb_method_at(k, &method) == BB_OK; ++k)
    if (method.problem == std::string("evaluation")) result.push_back(method);
  return result;
}

template <class Scalar>
std::string bytes(const std::vector<Scalar>& values) {
  return {reinterpret_cast<const char*>(values.data()), values.size() * sizeof(Scalar)};
}

template <class Scalar>
void expect_same_bits(int step, std::size_t curves, std::size_t count) {
  for (const auto& method : evaluators())
    for (int degree = 1; degree <= 30; degree += step) {
      const int most = sizeof(Scalar) == sizeof(float) ? method.max_degree_float : method.max_degree;
      if (degree < method.min_degree || degree > most) continue;
      const Problem<Scalar> problem(method, 1 + degree % 3, degree, curves, count);
      const auto right = bytes(problem.alone());
      ASSERT_EQ(bytes(problem.together()), right) << method.id << ", form " << method.form << ", degree " << degree;
      ASSERT_EQ(bytes(problem.by_axis()), right) << method.id << ", form " << method.form << ", degree " << degree;
    }
}

/// A group and a part of one.
TEST(EvaluateCurves, CurvesAtOneParameterEach) {
  expect_same_bits<double>(1, 19, 1);
  expect_same_bits<float>(1, 19, 1);
}

TEST(EvaluateCurves, CurvesAtSeveralParametersEach) {
  expect_same_bits<double>(2, 17, 3);
  expect_same_bits<float>(2, 17, 3);
  expect_same_bits<double>(2, 2, 20);
  expect_same_bits<float>(2, 2, 20);
}

/// More points than are computed before they are written.
TEST(EvaluateCurves, OneCurveAtManyParameters) {
  expect_same_bits<double>(4, 1, 521);
  expect_same_bits<float>(4, 1, 521);
}

/// Degrees that are too high for groups, and those that take the most room.
TEST(EvaluateCurves, CurvesOfHighDegrees) {
  for (const auto& method : evaluators())
    for (const int degree : {63, 64, 1023}) {
      if (degree > method.max_degree || std::string(method.id).find(':') != std::string::npos) continue;
      const Problem<double> problem(method, 3, degree, 2, 9);
      ASSERT_EQ(bytes(problem.together()), bytes(problem.alone())) << method.id << ", degree " << degree;
    }
}

TEST(EvaluateCurves, FunctionsForOneCurveGiveTheSame) {
  for (const auto& method : evaluators()) {
    const Problem<double> problem(method, 3, 5, 1, 521);
    auto points = problem.points;
    const bb_curve curve{method.form, 3, 5, points.data(), problem.weights_of(0)};
    std::vector<double> out(3 * problem.t.size());
    ASSERT_EQ(bb_curve_evaluate(method.id, &curve, problem.t.data(), problem.t.size(), out.data()), BB_OK);
    ASSERT_EQ(out, problem.alone()) << method.id;
    bb_prepared* prepared = nullptr;
    ASSERT_EQ(bb_prepare(method.id, &curve, &prepared), BB_OK);
    std::fill(points.begin(), points.end(), 7);  // it is independent of the array
    for (const std::size_t some : {1, 100, 520}) {
      std::vector<double> again(out.size());
      ASSERT_EQ(bb_prepared_evaluate(prepared, problem.t.data(), some, again.data()), BB_OK);
      ASSERT_EQ(bb_prepared_evaluate(prepared, &problem.t[some], problem.t.size() - some, &again[3 * some]), BB_OK);
      ASSERT_EQ(again, out) << method.id;
    }
    bb_prepared_free(prepared);
    if (method.form != BB_BERNSTEIN) continue;
    const Problem<float> single(method, 2, 3, 1, 33);
    std::vector<float> floats(2 * single.t.size());
    ASSERT_EQ(bb_evaluate_float(method.id, 2, 3, single.points.data(), single.t.data(), 33, floats.data()), BB_OK);
    ASSERT_EQ(floats, single.alone()) << method.id;
  }
  bb_prepared_free(nullptr);
}

const bb_method horner_bernstein{"horner_bernstein", "", "", "", "", "", BB_BERNSTEIN, 0, 1023, 127, 0, 1};

/// A t that all curves share, points that run backwards, every second number of an array.
TEST(EvaluateCurves, StridesAreFollowed) {
  const Problem<double> problem(horner_bernstein, 2, 3, 20, 2);
  const auto at_both = [&](const std::vector<double>& t) {
    auto same = problem;
    for (std::size_t k = 0; k < same.t.size(); ++k) same.t[k] = t[k % t.size()];
    return same.alone();
  };
  const std::vector<double> shared{0.25, 0.75};
  const bb_strides none{0, 1, 0};
  const bb_strides backwards{-8, 2, 1};
  std::vector<double> spread(problem.points.size() * 2, std::numeric_limits<double>::quiet_NaN());
  for (std::size_t k = 0; k < problem.points.size(); ++k) spread[2 * k] = problem.points[k];
  const bb_strides apart{16, 4, 2};
  auto batch = problem.batch;
  batch.t = &none;
  std::vector<double> out(80);
  const auto right = at_both(shared);
  ASSERT_EQ(evaluate("horner_bernstein", batch, problem.points.data(), {}, shared.data(), out.data()), BB_OK);
  EXPECT_EQ(out, right);
  batch.points = &apart;
  ASSERT_EQ(evaluate("horner_bernstein", batch, spread.data(), {}, shared.data(), out.data()), BB_OK);
  EXPECT_EQ(out, right);
  const bb_strides of_out{-4, 2, 1};
  batch.points = &backwards;
  batch.out = &of_out;
  ASSERT_EQ(evaluate("horner_bernstein", batch, &problem.points[8 * 19], {}, shared.data(), &out[4 * 19]), BB_OK);
  EXPECT_EQ(out, right);
}

TEST(EvaluateCurves, WhatIsWrongIsRefusedBeforeAnythingIsWritten) {
  const Problem<double> good(horner_bernstein, 2, 3, 20, 2);
  const auto status = [&](const bb_batch& batch, const char* method, const std::vector<double>& points,
                          const std::vector<double>& t, const double* weights = nullptr) {
    std::vector<double> out(80, 7);
    const int result = evaluate(method, batch, points.data(), weights, t.data(), out.data());
    EXPECT_EQ(out, std::vector<double>(80, 7));
    return result;
  };
  const auto with = [&](auto change) {
    auto batch = good.batch;
    change(batch);
    return status(batch, "horner_bernstein", good.points, good.t);
  };
  EXPECT_EQ(bb_evaluate_curves("direct", nullptr, good.points.data(), nullptr, good.t.data(), nullptr), BB_ERROR_NULL);
  EXPECT_EQ(evaluate<double>("direct", good.batch, nullptr, nullptr, good.t.data(), nullptr), BB_ERROR_NULL);
  EXPECT_EQ(evaluate<double>("direct", good.batch, good.points.data(), nullptr, nullptr, nullptr), BB_ERROR_NULL);
  EXPECT_EQ(evaluate<double>("direct", good.batch, good.points.data(), nullptr, good.t.data(), nullptr), BB_ERROR_NULL);
  EXPECT_EQ(with([](bb_batch& batch) { batch.form = 3; }), BB_ERROR_FORM);
  EXPECT_EQ(with([](bb_batch& batch) { batch.form = BB_POWER; }), BB_ERROR_FORM);
  EXPECT_EQ(with([](bb_batch& batch) { batch.dimension = 4; }), BB_ERROR_DIMENSION);
  EXPECT_EQ(with([](bb_batch& batch) { batch.degree = -1; }), BB_ERROR_DEGREE);
  EXPECT_EQ(status(good.batch, "horner_bernstien", good.points, good.t), BB_ERROR_METHOD);
  for (const std::size_t place : {std::size_t(0), good.points.size() - 1}) {
    auto points = good.points;
    points[place] = std::numeric_limits<double>::infinity();
    EXPECT_EQ(status(good.batch, "horner_bernstein", points, good.t), BB_ERROR_NOT_FINITE);
  }
  auto t = good.t;
  t.back() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(status(good.batch, "horner_bernstein", good.points, t), BB_ERROR_NOT_FINITE);
  t = std::vector<double>(good.t.size(), 0.5);
  t.back() = 1.5;
  EXPECT_EQ(status(good.batch, "correctly_rounded", good.points, t), BB_ERROR_PARAMETER);
  auto rational = good.batch;
  rational.form = BB_RATIONAL;
  std::vector<double> weights(80, 1);
  std::fill_n(&weights[4], 4, 0);
  EXPECT_EQ(status(rational, nullptr, good.points, good.t), BB_ERROR_NULL);
  EXPECT_EQ(status(rational, nullptr, good.points, good.t, weights.data()), BB_ERROR_NO_POINT);
  auto nothing = good.batch;
  nothing.curves = 0;
  EXPECT_EQ(evaluate<double>("direct", nothing, nullptr, nullptr, nullptr, nullptr), BB_OK);
}

TEST(EvaluateCurves, ThreadsDoNotDisturbEachOtherAndNothingIsAllocated) {
  const Problem<double> groups(horner_bernstein, 2, 3, 100, 3);
  const Problem<float> one(horner_bernstein, 3, 9, 3, 1000);
  const auto right = groups.alone();
  const auto right_float = one.alone();
  // The first call of a process finds out which targets its processor has, and keeps them.
  std::vector<double> first(right.size());
  std::vector<float> first_float(right_float.size());
  ASSERT_EQ(evaluate("horner_bernstein", groups.batch, groups.points.data(), {}, groups.t.data(), first.data()), BB_OK);
  ASSERT_EQ(evaluate("horner_bernstein", one.batch, one.points.data(), {}, one.t.data(), first_float.data()), BB_OK);
  std::vector<std::thread> threads;
  for (int k = 0; k < 8; ++k)
    threads.emplace_back([&] {
      std::vector<double> out(right.size());
      std::vector<float> floats(right_float.size());
      int calls = 0;
      for (int repetition = 0; repetition < 20; ++repetition) {
        allocations = 0;
        calls += evaluate("horner_bernstein", groups.batch, groups.points.data(), {}, groups.t.data(), out.data());
        calls += evaluate("horner_bernstein", one.batch, one.points.data(), {}, one.t.data(), floats.data());
        EXPECT_EQ(calls, 0);
        EXPECT_EQ(allocations, 0);
        EXPECT_EQ(out, right);
        EXPECT_EQ(floats, right_float);
      }
    });
  for (auto& thread : threads) thread.join();
}

/// A thread with a mebibyte of stack: a call that takes more ends the process.
TEST(EvaluateCurves, AMebibyteOfStackSuffices) {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  GTEST_SKIP() << "sanitizers put room between the variables of the library";
#endif
  const auto call_all = [](void* /*unused*/) -> void* {
    for (const bb_method& method : evaluators())
      for (const int dimension : {1, 2, 3})
        for (const std::size_t count : {1, 20}) {
          const int degree = std::min(method.max_degree_float, 40);
          static_cast<void>(Problem<double>(method, dimension, degree, 20, count).together());
          static_cast<void>(Problem<float>(method, dimension, degree, 20, count).together());
        }
    return nullptr;
  };
  pthread_attr_t attributes;
  ASSERT_EQ(pthread_attr_init(&attributes), 0);
  ASSERT_EQ(pthread_attr_setstacksize(&attributes, 1 << 20), 0);
  pthread_t thread;
  ASSERT_EQ(pthread_create(&thread, &attributes, call_all, nullptr), 0);
  ASSERT_EQ(pthread_join(thread, nullptr), 0);
  ASSERT_EQ(pthread_attr_destroy(&attributes), 0);
}

}  // namespace
