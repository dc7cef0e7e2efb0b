// SPDX-License-Identifier: MIT
#include "experiments/bundle/check/kernel_share.hpp"

#include <fmt/format.h>

#include <string_view>

#include "experiments/bundle/bundle.hpp"
#include "experiments/bundle/csv.hpp"
#include "experiments/failure.hpp"
#include "experiments/number/number.hpp"

namespace bezierbench::bundle {
namespace {

constexpr std::string_view table_name = "reference.csv";

std::uint64_t count(const CsvDocument& table, std::size_t row, std::string_view column) {
  const auto value = number::parse_integer(table.at(row, column));
  if (!value || *value < 0)
    throw Failure(Exit::input_output, fmt::format("{}:{}: {} is not a count; run the suite again", table.file_name(),
                                                  table.line(row), column));
  return static_cast<std::uint64_t>(*value);
}

}  // namespace

std::optional<KernelShare> kernel_share(const std::filesystem::path& path) {
  const auto directory = BundleDirectory::open(path);
  if (!directory.has(table_name)) return std::nullopt;
  const auto table = parse_csv(directory.read(table_name), (path / table_name).string());
  if (!table.has_column("own_kernel")) return std::nullopt;
  KernelShare share;
  for (std::size_t row = 0; row < table.row_count(); ++row) {
    share.judged += count(table, row, "trials");
    share.own += count(table, row, "own_kernel");
  }
  return share;
}

}  // namespace bezierbench::bundle
