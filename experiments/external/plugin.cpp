// SPDX-License-Identifier: MIT
#include "experiments/external/plugin.h"

#include <dlfcn.h>
#include <fmt/format.h>

#include <cstdio>
#include <cstdlib>
#include <optional>
#include <string>
#include <string_view>

#include "experiments/bundle/atomic_file.hpp"
#include "experiments/bundle/digest.hpp"
#include "experiments/external/code.hpp"
#include "experiments/external/method.hpp"
#include "experiments/failure.hpp"
#include "experiments/number/bytes.hpp"
#include "reference/number/echo.hpp"

namespace bezierbench::external {
namespace {

static_assert(static_cast<int>(Form::bernstein) == BEZIERBENCH_BERNSTEIN &&
              static_cast<int>(Form::power) == BEZIERBENCH_POWER &&
              static_cast<int>(Form::rational) == BEZIERBENCH_RATIONAL);

/// The plug-in of this process, for the functions of the kernel. Only child processes set it, each once, since each
/// serves one method.
const bezierbench_method* loaded = nullptr;

void prepare(const CurveView<double>& curve, void* prepared) {
  const bezierbench_curve given{static_cast<bezierbench_form>(curve.form), curve.dimension, curve.degree,
                                curve.coefficients.data(), curve.weights.empty() ? nullptr : curve.weights.data()};
  void* const state = loaded->prepare(&given);
  if (state == nullptr) throw CurveRefused();
  *static_cast<void**>(prepared) = state;
}

void evaluate(const void* prepared, std::span<const double> t, double* points) {
  loaded->evaluate(*static_cast<void* const*>(prepared), t.data(), t.size(), points);
}

void destroy(void* prepared) {
  if (loaded->destroy != nullptr) loaded->destroy(*static_cast<void**>(prepared));
}

/// The description of a plug-in, on its way from the child process.
struct Description {
  std::string id;
  std::string label;
  int form = 0;
  int min_degree = 0;
  int max_degree = 0;

  template <class Bytes, class Self>
  static void each_field(Bytes& bytes, Self& self) {
    bytes(self.id, self.label, self.form, self.min_degree, self.max_degree);
  }
};

/// Loads the file in a child process; ends the process with one line on standard error where it is not a plug-in.
void load(const std::string& file) {
  const auto refuse = [](std::string_view why) {
    std::fputs(fmt::format("{}\n", why).c_str(), stderr);
    std::_Exit(EXIT_FAILURE);
  };
  void* const object = dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (object == nullptr) refuse(dlerror());
  using Entry = const bezierbench_method* (*)();
  const auto entry = reinterpret_cast<Entry>(dlsym(object, "bezierbench_plugin"));
  if (entry == nullptr) refuse("it does not export bezierbench_plugin");
  loaded = entry();
  if (loaded == nullptr) refuse("bezierbench_plugin() returned nothing");
  if (loaded->version != BEZIERBENCH_PLUGIN_VERSION)
    refuse(fmt::format("it has version {} of the interface, this program has {}", loaded->version,
                       BEZIERBENCH_PLUGIN_VERSION));
  if (loaded->id == nullptr || loaded->prepare == nullptr || loaded->evaluate == nullptr)
    refuse("its id, prepare or evaluate is missing");
}

class Plugin final : public Method {
 public:
  Plugin(const std::filesystem::path& file, const Limits& limits, bool (*stop)())
      : file_(std::filesystem::absolute(file).string()), limits_(limits), stop_(stop) {
    record_.kind = suite::ExternalKind::plugin;
    record_.source = file.filename().string();
    record_.sha256 = bundle::sha256_hex(bundle::read_file(file));
    const auto refuse = [&](std::string_view what) {
      throw Failure(Exit::usage, fmt::format("--plugin {}: {}; see docs/own_method.md", file.string(), echo(what)));
    };
    const auto ended = describe();
    const auto description = description_in(ended);
    if (!description) refuse(failed(ended).detail);
    record_.id = description->id;
    record_.label = description->label;
    record_.form = static_cast<Form>(description->form);
    record_.min_degree = description->min_degree;
    record_.max_degree = description->max_degree;
    if (const auto what = suite::external_id_problem(record_.id, record_.kind); !what.empty()) refuse(what);
    if (description->form < 0 || description->form > BEZIERBENCH_RATIONAL) refuse("its form is not one of plugin.h");
    if (description->min_degree < 0 || description->max_degree > max_degree ||
        description->min_degree > description->max_degree)
      refuse(fmt::format("its degrees must be from 0 to {}", max_degree));
  }

  [[nodiscard]] const suite::ExternalMethod& record() const override { return record_; }
  [[nodiscard]] Answer points(const Batch& batch) const override {
    return call_code([this](int dimension) { return open_kernel(dimension); }, batch, limits_, stop_);
  }
  [[nodiscard]] Limits limits() const override { return limits_; }

  [[nodiscard]] const Kernel<double>* open_kernel(int dimension) const override {
    load(file_);
    static MethodInfo info;
    info.id = record_.id;
    info.form = record_.form;
    info.min_degree = record_.min_degree;
    info.max_degree = record_.max_degree;
    static Kernel<double> kernel{};
    kernel = {&info, dimension, sizeof(void*), alignof(void*), prepare, for_every_degree<double, evaluate>,
              &info, nullptr,   info.form,     nullptr,        destroy};
    return &kernel;
  }

 private:
  [[nodiscard]] Ended describe() const {
    const auto work = [this] {
      const int answer = keep_output_for_answer();
      load(file_);
      const auto text = [](const char* given) { return std::string(given == nullptr ? "" : given); };
      number::ByteWriter bytes;
      bytes(Description{text(loaded->id), text(loaded->label), static_cast<int>(loaded->form), loaded->min_degree,
                        loaded->max_degree});
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
  suite::ExternalMethod record_;
  Limits limits_;
  bool (*stop_)();
};

}  // namespace

std::shared_ptr<const Method> plugin(const std::filesystem::path& file, const Limits& limits, bool (*stop)()) {
  return std::make_shared<Plugin>(file, limits, stop);
}

}  // namespace bezierbench::external
