// SPDX-License-Identifier: MIT
#include "experiments/judge/methods.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <span>
#include <string>
#include <type_traits>
#include <vector>

#include "core/arc_length/kernel.hpp"
#include "core/project/kernel.hpp"
#include "experiments/judge/scalar_facts.hpp"
#include "experiments/peers/peers.hpp"
#include "experiments/sample/draw.hpp"
#include "experiments/suite/ids.hpp"
#include "experiments/suite/kind.hpp"
#include "experiments/suite/suite.hpp"
#include "experiments/suite/validate.hpp"
#include "reference/exact_point.hpp"

namespace bezierbench::judge {

namespace {

/// A table for each dimension, our own first.
template <class K>
class Tables {
 public:
  Tables(std::span<const K> (*ours)(int), std::span<const K> (*peers::Peer::*theirs)(int)) {
    for (int dimension = 1; dimension <= reference::max_dimension; ++dimension) {
      auto& table = tables_[static_cast<std::size_t>(dimension - 1)];
      const auto append = [&](std::span<const K> kernels) {
        table.insert(table.end(), kernels.begin(), kernels.end());
      };
      append(ours(dimension));
      for (const auto& peer : peers::present()) append((peer.*theirs)(dimension));
    }
  }
  [[nodiscard]] std::span<const K> of(int dimension) const {
    if (dimension < 1 || dimension > reference::max_dimension) return {};
    return tables_[static_cast<std::size_t>(dimension - 1)];
  }

 private:
  std::array<std::vector<K>, reference::max_dimension> tables_;
};

}  // namespace

template <class Scalar>
std::span<const Kernel<Scalar>> methods(int dimension) {
  if constexpr (std::is_same_v<Scalar, double>) {
    static const Tables<Kernel<double>> tables(kernels<double>, &peers::Peer::kernels);
    return tables.of(dimension);
  } else {
    return kernels<Scalar>(dimension);
  }
}

template std::span<const Kernel<float>> methods<float>(int dimension);
template std::span<const Kernel<double>> methods<double>(int dimension);

std::span<const ArcLengthKernel> arc_length_methods(int dimension) {
  static const Tables<ArcLengthKernel> tables(arc_length_kernels, &peers::Peer::arc_length_kernels);
  return tables.of(dimension);
}

std::span<const ProjectionKernel> projection_methods(int dimension) {
  static const Tables<ProjectionKernel> tables(projection_kernels, &peers::Peer::projection_kernels);
  return tables.of(dimension);
}

std::vector<const MethodInfo*> chosen_companions(const suite::Study& study, std::vector<const MethodInfo*> infos) {
  const auto problem = name(infos.front()->problem);
  if (study.methods.empty()) {
    std::erase_if(infos, [](const MethodInfo* info) { return suite::is_peer(info->id); });
    return infos;
  }
  const auto means = [](const MethodInfo* info) {
    return [info](const std::string& pattern) { return suite::means(pattern, info->id); };
  };
  for (std::size_t k = 0; k < study.methods.size(); ++k)
    if (std::ranges::none_of(infos, [&](const MethodInfo* info) { return suite::means(study.methods[k], info->id); }))
      suite::refuse(study, {"methods",
                            k,
                            {},
                            fmt::format("\"{}\" is not a method for the problem {}; see `list methods`",
                                        study.methods[k], problem)});
  std::erase_if(infos, [&](const MethodInfo* info) { return std::ranges::none_of(study.methods, means(info)); });
  return infos;
}

void require_form(const suite::Study& study, bool any_method) {
  if (any_method || study.slice) return;
  suite::refuse(study,
                {study.methods.empty() ? "curve" : "methods", 0, "curve",
                 fmt::format("none of its methods takes curves in {} form; see `list methods`", name(study.form))});
}

bool takes(const MethodInfo& info, const suite::Interval& t_interval) {
  return !info.unit_interval_only || (t_interval.min >= 0 && t_interval.max <= 1);
}

template <class Scalar>
std::vector<const Kernel<Scalar>*> chosen_kernels(const suite::Study& study, const sample::Cell& cell) {
  const Form form = study.form;
  const int dimension = cell.dimension;
  // The curves of a set may have several forms; a method gets those that it takes.
  for (std::size_t k = 0; k < study.methods.size() && !study.slice; ++k) {
    const std::string& pattern = study.methods[k];
    const MethodInfo* named = nullptr;
    bool somewhere = false;
    for (const auto& kernel : methods<Scalar>(dimension)) {
      if (kernel.info->form != form || !suite::means(pattern, kernel.info->id)) continue;
      named = kernel.info;
      somewhere = somewhere || std::ranges::any_of(study.t_interval, [&](const auto& t) { return takes(*named, t); });
    }
    if (named != nullptr && !somewhere)
      suite::refuse(study,
                    {"methods", k, "t_interval",
                     fmt::format("method \"{}\" takes t in [0,1] only; narrow t_interval or leave it out", pattern)});
    if (named == nullptr)
      suite::refuse(study, {"methods", k, "curve",
                            fmt::format("method \"{}\" does not take curves in {} form, {} with {} axes; see `list "
                                        "methods`",
                                        pattern, name(form), suite::name(ScalarFacts<Scalar>::kind), dimension)});
  }
  std::vector<const Kernel<Scalar>*> chosen;
  const std::vector<std::string> all{"*"};
  for (const auto& kernel : methods<Scalar>(dimension)) {
    if (kernel.info->form != form || !takes(*kernel.info, cell.t_interval)) continue;
    const bool named = std::ranges::any_of(study.methods.empty() ? all : study.methods,
                                           [&](const auto& pattern) { return suite::means(pattern, kernel.info->id); });
    if (named) chosen.push_back(&kernel);
  }
  return chosen;
}

template std::vector<const Kernel<float>*> chosen_kernels<float>(const suite::Study&, const sample::Cell&);
template std::vector<const Kernel<double>*> chosen_kernels<double>(const suite::Study&, const sample::Cell&);

namespace {

const std::vector<suite::KnownGenerator>& known_generators() {
  static const auto all = [] {
    std::vector<suite::KnownGenerator> known;
    for (const auto& generator : sample::generators()) known.push_back({std::string(generator.id), generator.limits});
    return known;
  }();
  return all;
}

}  // namespace

void check_inputs(const suite::Study& study) {
  if (const auto fault = suite::check_inputs(study, known_generators())) suite::refuse(study, *fault);
}

void check_timed(const suite::Study& study, const suite::Kind& judged) {
  if (const auto fault = suite::check_timed(study, judged, known_generators())) suite::refuse(study, *fault);
}

}  // namespace bezierbench::judge
