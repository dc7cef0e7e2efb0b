// SPDX-License-Identifier: MIT

#include "experiments/external/method.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <limits>
#include <string_view>

#include "core/evaluate/kernel/prepared_state.hpp"
#include "experiments/failure.hpp"

namespace bezierbench::external {
namespace {

template <class Scalar>
Status evaluate_each(const Method& method, const Batch& batch, std::vector<double>& points) {
  const auto* kernel = method.open_kernel(batch.dimension, Scalar{});
  if (kernel == nullptr) return Status::exited;
  const std::vector<Scalar> coefficients(batch.coefficients.begin(), batch.coefficients.end());
  const std::vector<Scalar> weights(batch.weights.begin(), batch.weights.end());
  std::vector<Scalar> computed(points.begin(), points.end());
  for (std::size_t k = 0; k < batch.count(); ++k) {
    const auto t = static_cast<Scalar>(batch.inputs[k]);
    PreparedState<Scalar>(*kernel, batch.curve<Scalar>(k, coefficients, weights))
        .evaluate({&t, 1}, computed.data() + k * static_cast<std::size_t>(batch.dimension));
  }
  std::copy(computed.begin(), computed.end(), points.begin());
  return Status::ok;
}

std::string_view last_line(std::string_view text) {
  const auto end = text.find_last_not_of(" \n\r\t");
  if (end == std::string_view::npos) return {};
  text = text.substr(0, end + 1);
  return text.substr(text.rfind('\n') + 1);
}

class Own final : public Code {
 public:
  Own(const OwnMethod& method, const Limits& limits, bool (*stop)()) : Code(limits, stop), method_(method) {
    const MethodInfo& info = *method.info;
    record_.id = info.id;
    record_.kind = suite::ExternalKind::own;
    record_.label = info.label;
    record_.form = info.form;
    record_.min_degree = info.min_degree;
    record_.max_degree = info.max_degree;
    if (method.float_kernels.front() != nullptr)
      record_.scalars = {suite::ScalarKind::float32, suite::ScalarKind::float64};
    if (const auto what = suite::external_id_problem(record_.id, record_.kind); !what.empty())
      throw Failure(Exit::usage, what + "; change MethodInfo::id");
  }

  [[nodiscard]] const Kernel<double>* open_kernel(int dimension, double /*zero*/) const override {
    return method_.kernels.at(static_cast<std::size_t>(dimension) - 1);
  }
  [[nodiscard]] const Kernel<float>* open_kernel(int dimension, float /*zero*/) const override {
    return method_.float_kernels.at(static_cast<std::size_t>(dimension) - 1);
  }

 private:
  OwnMethod method_;
};

}  // namespace

Answer failed(const Ended& ended) {
  const auto message = last_line(ended.errors);
  const auto with = [&](const std::string& how) { return message.empty() ? how : fmt::format("{}: {}", how, message); };
  switch (ended.end) {
    case End::exited: {
      const auto* const when = ended.code == 0 ? " before it had answered" : "";
      return {Status::exited, {}, with(fmt::format("the process ended with code {}{}", ended.code, when))};
    }
    case End::signalled:
      return {Status::crashed, {}, with(fmt::format("signal {} ({})", ended.code, strsignal(ended.code)))};
    case End::timed_out: return {Status::timed_out, {}, with("it did not end within the time limit")};
    case End::interrupted: break;
  }
  return {Status::timed_out, {}, "interrupted"};
}

Status Code::answer(const Batch& batch, std::vector<double>& numbers) const {
  try {
    if (batch.problem != Problem::evaluation) return solve(batch, numbers);
    return batch.scalar == suite::ScalarKind::float32 ? evaluate_each<float>(*this, batch, numbers)
                                                      : evaluate_each<double>(*this, batch, numbers);
  } catch (const CurveRefused&) {
    return Status::refused;
  } catch (...) {
    return Status::threw;
  }
}

Answer Code::ask(const Batch& batch) const {
  const std::size_t numbers = batch.count() * batch.answer_size();
  const auto work = [&] {
    const int file = keep_output_for_answer();
    // A number that was not written is not finite.
    std::vector<double> computed(numbers, std::numeric_limits<double>::quiet_NaN());
    const Status status = answer(batch, computed);
    write_all(file, {reinterpret_cast<const char*>(&status), sizeof status});
    write_all(file, {reinterpret_cast<const char*>(computed.data()), numbers * sizeof(double)});
  };
  constexpr std::size_t room_for_errors = 1U << 20U;
  const auto size = sizeof(Status) + numbers * sizeof(double);
  const auto ended = run_in_child(work, {}, size + room_for_errors, limits_, stop_);
  if (ended.end != End::exited || ended.code != 0 || ended.output.size() != size) return failed(ended);
  Answer answer;
  std::memcpy(&answer.status, ended.output.data(), sizeof answer.status);
  answer.numbers.resize(numbers);
  std::memcpy(answer.numbers.data(), ended.output.data() + sizeof answer.status, numbers * sizeof(double));
  if (answer.status != Status::ok) answer.detail = last_line(ended.errors);
  return answer;
}

std::shared_ptr<const Method> own(const OwnMethod& method, const Limits& limits, bool (*stop)()) {
  return std::make_shared<Own>(method, limits, stop);
}

void Batch::add(const CurveView<double>& curve, std::span<const double> given) {
  inputs.insert(inputs.end(), given.begin(), given.end());
  coefficients.insert(coefficients.end(), curve.coefficients.begin(), curve.coefficients.end());
  weights.insert(weights.end(), curve.weights.begin(), curve.weights.end());
}

std::size_t Batch::answer_size() const {
  constexpr std::size_t t_and_distance = 2;
  const auto d = static_cast<std::size_t>(dimension);
  switch (problem) {
    case Problem::arc_length: return 1;
    case Problem::projection: return t_and_distance;
    case Problem::subdivision: return 2 * (static_cast<std::size_t>(degree) + 1) * (form == Form::rational ? d + 1 : d);
    default: return d;
  }
}

std::string_view name(Status status) {
  switch (status) {
    case Status::ok: return "ok";
    case Status::non_finite: return "non_finite";
    case Status::missing: return "missing";
    case Status::refused: return "refused";
    case Status::malformed: return "malformed";
    case Status::exited: return "exited";
    case Status::threw: return "threw";
    case Status::crashed: return "crashed";
    case Status::timed_out: return "timed_out";
  }
  return "";
}

const Method* find(const Methods& methods, std::string_view id) {
  const auto found = std::ranges::find_if(methods, [&](const auto& method) { return method->record().id == id; });
  return found == methods.end() ? nullptr : found->get();
}

}  // namespace bezierbench::external
