// SPDX-License-Identifier: MIT
#include "experiments/outside/own.hpp"

#include <fmt/format.h>

#include "experiments/failure.hpp"
#include "experiments/outside/called_code.hpp"

namespace bezierbench::outside {
namespace {

class Own final : public Method {
 public:
  Own(const OwnMethod& method, const Limits& limits, bool (*stop)()) : method_(method), limits_(limits), stop_(stop) {
    const MethodInfo& info = *method.info;
    record_ = {std::string(info.id),
               suite::OutsideKind::own,
               std::string(info.label),
               info.form,
               info.min_degree,
               info.max_degree,
               {},
               {}};
    if (const auto what = suite::outside_id_problem(record_.id, record_.kind); !what.empty())
      throw Failure(Exit::usage, what + "; change MethodInfo::id");
  }

  [[nodiscard]] const suite::OutsideMethod& record() const override { return record_; }
  [[nodiscard]] Answer points(const Batch& batch) const override {
    return ask_code([this](int dimension) { return open_kernel(dimension); }, batch, limits_, stop_);
  }
  [[nodiscard]] bool has_kernel() const override { return true; }
  [[nodiscard]] Limits limits() const override { return limits_; }
  [[nodiscard]] const Kernel<double>* open_kernel(int dimension) const override {
    return method_.kernels.at(static_cast<std::size_t>(dimension) - 1);
  }

 private:
  OwnMethod method_;
  suite::OutsideMethod record_;
  Limits limits_;
  bool (*stop_)();
};

}  // namespace

std::shared_ptr<const Method> own(const OwnMethod& method, const Limits& limits, bool (*stop)()) {
  return std::make_shared<Own>(method, limits, stop);
}

}  // namespace bezierbench::outside
