// SPDX-License-Identifier: MIT
#include "experiments/external/plugin.h"

#include <dlfcn.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "experiments/bundle/atomic_file.hpp"
#include "experiments/bundle/digest.hpp"
#include "experiments/external/method.hpp"
#include "experiments/failure.hpp"
#include "experiments/number/bytes.hpp"
#include "reference/number/echo.hpp"

namespace bezierbench::external {
namespace {

static_assert(static_cast<int>(Form::bernstein) == BEZIERBENCH_BERNSTEIN &&
              static_cast<int>(Form::power) == BEZIERBENCH_POWER &&
              static_cast<int>(Form::rational) == BEZIERBENCH_RATIONAL);

/// What plugin.h declares for a scalar type.
template <class Scalar>
using PluginCurve = std::conditional_t<std::is_same_v<Scalar, float>, bezierbench_curve_float, bezierbench_curve>;
template <class Scalar>
using PluginFunctions = std::conditional_t<std::is_same_v<Scalar, float>, bezierbench_method_float, bezierbench_method>;

/// The plug-in of this process, for the functions of the kernel. Only child processes set it, each once, since each
/// serves one method. Null where it does not answer in this scalar type.
template <class Scalar>
const PluginFunctions<Scalar>* loaded = nullptr;

decltype(&bezierbench_plugin_solve) loaded_solve = nullptr;

constexpr std::array solved{std::pair(Problem::arc_length, BEZIERBENCH_ARC_LENGTH),
                            std::pair(Problem::projection, BEZIERBENCH_PROJECTION),
                            std::pair(Problem::subdivision, BEZIERBENCH_SUBDIVISION)};

template <class Scalar>
PluginCurve<Scalar> as_given(const CurveView<Scalar>& curve) {
  return {static_cast<bezierbench_form>(curve.form), curve.dimension, curve.degree, curve.coefficients.data(),
          curve.weights.empty() ? nullptr : curve.weights.data()};
}

template <class Scalar>
void prepare(const CurveView<Scalar>& curve, void* prepared) {
  const auto given = as_given(curve);
  void* const state = loaded<Scalar>->prepare(&given);
  if (state == nullptr) throw CurveRefused();
  *static_cast<void**>(prepared) = state;
}

template <class Scalar>
void evaluate(const void* prepared, std::span<const Scalar> t, Scalar* points) {
  loaded<Scalar>->evaluate(*static_cast<void* const*>(prepared), t.data(), t.size(), points);
}

template <class Scalar>
void destroy(void* prepared) {
  if (loaded<Scalar>->destroy != nullptr) loaded<Scalar>->destroy(*static_cast<void**>(prepared));
}

/// The description of a plug-in, on its way from the child process.
struct Description {
  std::string id;
  std::string label;
  int form = 0;
  int min_degree = 0;
  int max_degree = 0;
  std::vector<int> scalars = {};   ///< of suite::ScalarKind
  std::vector<int> problems = {};  ///< of Problem

  template <class Bytes, class Self>
  static void each_field(Bytes& bytes, Self& self) {
    bytes(self.id, self.label, self.form, self.min_degree, self.max_degree, self.scalars, self.problems);
  }
};

/// Loads the file in a child process and returns what it describes of its method; ends the process with one line on
/// standard error where it is not a plug-in.
const bezierbench_method& load(const std::string& file) {
  const auto refuse = [](std::string_view why) {
    std::fputs(fmt::format("{}\n", why).c_str(), stderr);
    std::_Exit(EXIT_FAILURE);
  };
  void* const object = dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (object == nullptr) refuse(dlerror());
  const auto entry = reinterpret_cast<decltype(&bezierbench_plugin)>(dlsym(object, "bezierbench_plugin"));
  if (entry == nullptr) refuse("it does not export bezierbench_plugin");
  const auto* method = entry();
  if (method == nullptr) refuse("bezierbench_plugin() returned nothing");
  if (method->version != BEZIERBENCH_PLUGIN_VERSION)
    refuse(fmt::format("it has version {} of the interface, this program has {}", method->version,
                       BEZIERBENCH_PLUGIN_VERSION));
  loaded<double> = method->prepare != nullptr && method->evaluate != nullptr ? method : nullptr;
  const auto in_float =
      reinterpret_cast<decltype(&bezierbench_plugin_float)>(dlsym(object, "bezierbench_plugin_float"));
  loaded<float> = in_float != nullptr ? in_float() : nullptr;
  if (loaded<float> != nullptr && (loaded<float>->prepare == nullptr || loaded<float>->evaluate == nullptr))
    refuse("prepare or evaluate of bezierbench_plugin_float() is missing");
  loaded_solve = reinterpret_cast<decltype(loaded_solve)>(dlsym(object, "bezierbench_plugin_solve"));
  if (method->id == nullptr || (loaded<double> == nullptr && loaded<float> == nullptr && loaded_solve == nullptr))
    refuse("its id is missing, or prepare and evaluate, bezierbench_plugin_float() and bezierbench_plugin_solve() are");
  return *method;
}

class Plugin final : public Code {
 public:
  Plugin(const std::filesystem::path& file, const Limits& limits, bool (*stop)())
      : Code(limits, stop), file_(std::filesystem::absolute(file).string()) {
    record_.kind = suite::ExternalKind::plugin;
    record_.source = file.filename().string();
    record_.sha256 = bundle::sha256_hex(bundle::read_file(file));
    const auto refuse = [&](std::string_view what) {
      throw Failure(Exit::usage, "--plugin {}: {}; see docs/own_method.md", file.string(), echo(what));
    };
    const auto ended = describe();
    const auto description = description_in(ended);
    if (!description) refuse(failed(ended).detail);
    record_.id = description->id;
    record_.label = description->label;
    record_.form = static_cast<Form>(description->form);
    record_.min_degree = description->min_degree;
    record_.max_degree = description->max_degree;
    if (!description->scalars.empty()) record_.scalars.clear();
    for (const int scalar : description->scalars) record_.scalars.push_back(static_cast<suite::ScalarKind>(scalar));
    record_.problems.clear();
    for (const int problem : description->problems) record_.problems.push_back(static_cast<Problem>(problem));
    if (record_.problems.empty()) refuse("it solves no problem");
    if (const auto what = suite::external_id_problem(record_.id, record_.kind); !what.empty()) refuse(what);
    if (description->form < 0 || description->form > BEZIERBENCH_RATIONAL) refuse("its form is not one of plugin.h");
    if (description->min_degree < 0 || description->max_degree > max_degree ||
        description->min_degree > description->max_degree)
      refuse(fmt::format("its degrees must be from 0 to {}", max_degree));
  }

  [[nodiscard]] const Kernel<double>* open_kernel(int dimension, double /*zero*/) const override {
    return kernel<double>(dimension);
  }
  [[nodiscard]] const Kernel<float>* open_kernel(int dimension, float /*zero*/) const override {
    return kernel<float>(dimension);
  }

 private:
  template <class Scalar>
  [[nodiscard]] const Kernel<Scalar>* kernel(int dimension) const {
    load(file_);
    if (loaded<Scalar> == nullptr) return nullptr;
    static MethodInfo info;
    info.id = record_.id;
    info.form = record_.form;
    info.min_degree = record_.min_degree;
    info.max_degree = record_.max_degree;
    static Kernel<Scalar> kernel{};
    kernel = {
        &info, dimension, sizeof(void*), alignof(void*), prepare<Scalar>, for_every_degree<Scalar, evaluate<Scalar>>,
        &info, nullptr,   info.form,     nullptr,        destroy<Scalar>};
    return &kernel;
  }
  Status solve(const Batch& batch, std::vector<double>& numbers) const override {
    load(file_);
    const auto as_asked = std::ranges::find(solved, batch.problem, [](const auto& one) { return one.first; })->second;
    const auto each = inputs_of(batch.problem, batch.dimension);
    for (std::size_t k = 0; k < batch.count(); ++k) {
      const auto curve = as_given<double>(batch.curve(k));
      if (loaded_solve(as_asked, &curve, &batch.inputs[k * each], &numbers[k * batch.answer_size()]) != 0)
        return Status::refused;
    }
    return Status::ok;
  }
  [[nodiscard]] Ended describe() const {
    const auto work = [this] {
      const int answer = keep_output_for_answer();
      const auto& method = load(file_);
      const auto text = [](const char* given) { return std::string(given == nullptr ? "" : given); };
      Description description{text(method.id), text(method.label), static_cast<int>(method.form), method.min_degree,
                              method.max_degree};
      if (loaded<float> != nullptr) description.scalars.push_back(static_cast<int>(suite::ScalarKind::float32));
      if (loaded<double> != nullptr) description.scalars.push_back(static_cast<int>(suite::ScalarKind::float64));
      if (!description.scalars.empty()) description.problems.push_back(static_cast<int>(Problem::evaluation));
      for (const auto& [problem, as_asked] : solved)
        if (loaded_solve != nullptr && loaded_solve(as_asked, nullptr, nullptr, nullptr) == 0)
          description.problems.push_back(static_cast<int>(problem));
      number::ByteWriter bytes;
      bytes(description);
      write_all(answer, bytes.bytes());
    };
    constexpr std::size_t room = 1U << 20U;
    return run_in_child(work, {}, room, to_describe(limits_), stop_);
  }
  /// Empty where the process ended without an answer.
  static std::optional<Description> description_in(const Ended& ended) {
    if (ended.end != End::exited || ended.code != 0) return std::nullopt;
    try {
      number::ByteReader reader(ended.output);
      Description description;
      reader(description);
      reader.finish();
      return description;
    } catch (const number::MalformedBytes&) {
      return std::nullopt;
    }
  }

  std::string file_;
};

}  // namespace

std::shared_ptr<const Method> plugin(const std::filesystem::path& file, const Limits& limits, bool (*stop)()) {
  return std::make_shared<Plugin>(file, limits, stop);
}

}  // namespace bezierbench::external
