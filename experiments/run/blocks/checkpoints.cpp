// SPDX-License-Identifier: MIT
#include "experiments/run/blocks/checkpoints.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <string_view>
#include <utility>

#include "experiments/bundle/atomic_file.hpp"
#include "experiments/bundle/bundle.hpp"

namespace bezierbench::run {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view extension = ".blocks";
// Without an `interval` of the owner, the time between two files is the longest of these: so many times the cost of the
// last one, and a share of the time since the beginning, which keeps the files of a long run few.
constexpr auto shortest_interval = std::chrono::milliseconds(50);
constexpr int times_the_cost = 19;
constexpr int share_of_the_time = 50;

std::uint64_t size_of(const bundle::BlockRecord& record) {
  std::uint64_t sum = 0;
  for (const auto& [first, end] : record.blocks) sum += end - first;
  return sum;
}

std::string bytes_of(const Result& result) {
  number::ByteWriter writer;
  result.save(writer);
  return writer.bytes();
}

/// The number in WRITER.NUMBER.blocks, 0 where there is none.
std::uint64_t number_of(const fs::path& path) {
  const std::string digits = path.stem().extension().string();
  std::uint64_t number = 0;
  if (!digits.empty()) std::from_chars(digits.data() + 1, digits.data() + digits.size(), number);
  return number;
}

}  // namespace

Found find_blocks(const fs::path& folder) {
  Found found;
  if (!bundle::is_inner_folder(folder)) return found;
  for (const auto& name : bundle::list_folder(folder).files) {
    if (!name.ends_with(extension)) continue;
    auto file = bundle::parse_block_file(bundle::read_bundle_file(folder / name));
    if (file)
      found.readable.push_back({folder / name, std::move(*file)});
    else
      found.damaged.push_back(folder / name);
  }
  return found;
}

Checkpoints::Checkpoints(const Jobs& jobs, Owner owner)
    : jobs_(jobs), owner_(std::move(owner)), done_(jobs.size()), slots_(jobs.size()), settled_(jobs.size()) {
  for (std::size_t job = 0; job < jobs.size(); ++job) slots_[job].resize(jobs[job]->parts());
  next_checkpoint_ = Clock::now() + pause_after({});
}

bool Checkpoints::is_own(const fs::path& path) const { return path.stem().stem() == owner_.writer; }

BlockSet::Run Checkpoints::blocks_of(std::size_t job, std::uint64_t part) const {
  const auto each = jobs_[job]->blocks_per_part();
  return {part * each, (part + 1) * each};
}

std::vector<std::string> Checkpoints::load(const Found& found, Whose whose) {
  std::vector<std::string> notes;
  for (const auto& path : found.damaged)
    notes.push_back(fmt::format("{}: damaged; what it held is computed again", path.string()));
  for (const auto& one : found.readable) {
    if (is_own(one.path)) next_number_ = std::max(next_number_, number_of(one.path) + 1);
    for (const auto& record : one.file.records) load_record(one, record, whose, notes);
  }
  for (const auto& path : found.damaged)
    if (is_own(path)) next_number_ = std::max(next_number_, number_of(path) + 1);
  return notes;
}

void Checkpoints::load_record(const FoundBlocks& from, const bundle::BlockRecord& record, Whose whose,
                              std::vector<std::string>& notes) {
  const auto pass_over = [&] {
    notes.push_back(fmt::format("{}: holds what is not of this run; computed again", from.path.string()));
  };
  if (record.job >= jobs_.size() || record.part >= jobs_[record.job]->parts()) return pass_over();
  Job& job = *jobs_[record.job];
  if (job.exclusive() && from.file.machine != owner_.machine) return;
  const BlockSet blocks(record.blocks);
  if (blocks.empty() || blocks.within(blocks_of(record.job, record.part)).size() != size_of(record)) return pass_over();
  if (settled_[record.job].overlaps(blocks)) return;
  if (whose == Whose::own && !is_own(from.path)) return done_[record.job].insert(blocks);
  try {
    number::ByteReader reader(record.result);
    auto result = job.read_result(reader);
    reader.finish();
    job.add(record.part, std::move(result));
  } catch (const number::MalformedBytes&) {
    return pass_over();
  }
  settled_[record.job].insert(blocks);
  done_[record.job].insert(blocks);
}

bool Checkpoints::all_settled() const {
  for (std::size_t job = 0; job < jobs_.size(); ++job)
    if (settled_[job].size() != jobs_[job]->blocks()) return false;
  return true;
}

void Checkpoints::add(std::size_t job, std::uint64_t block, std::unique_ptr<Result> result) {
  {
    Slot& slot = slots_[job][jobs_[job]->part_of(block)];
    const std::lock_guard lock(slot.mutex);
    if (slot.fresh)
      slot.fresh->merge(*result);
    else
      slot.fresh = std::move(result);
    slot.blocks.insert(block);
  }
  const std::unique_lock lock(mutex_, std::try_to_lock);  // one thread writes, the others continue
  if (lock && Clock::now() >= next_checkpoint_) write_checkpoint();
}

void Checkpoints::checkpoint() {
  const std::lock_guard lock(mutex_);
  write_checkpoint();
}

void Checkpoints::settle() {
  const std::lock_guard lock(mutex_);
  drain(nullptr);
}

void Checkpoints::drain(std::vector<bundle::BlockRecord>* records) {
  for (std::size_t job = 0; job < jobs_.size(); ++job)
    for (std::size_t part = 0; part < slots_[job].size(); ++part) {
      Slot& slot = slots_[job][part];
      std::unique_ptr<Result> fresh;
      BlockSet blocks;
      {
        const std::lock_guard lock(slot.mutex);
        std::swap(fresh, slot.fresh);
        std::swap(blocks, slot.blocks);
      }
      if (!fresh) continue;
      if (records != nullptr) records->push_back({job, part, blocks.runs(), bytes_of(*fresh)});
      jobs_[job]->add(part, std::move(fresh));
      settled_[job].insert(blocks);
    }
}

void Checkpoints::write_checkpoint() {
  const auto start = Clock::now();
  std::vector<bundle::BlockRecord> records;
  drain(&records);
  if (!records.empty())
    bundle::write_bundle_file(
        owner_.folder / fmt::format("{}.{:06}{}", owner_.writer, next_number_++, extension),
        bundle::block_file_bytes({owner_.manifest, owner_.reference, owner_.machine, std::move(records)}));
  const auto end = Clock::now();
  next_checkpoint_ = end + pause_after(end - start);
}

Checkpoints::Clock::duration Checkpoints::pause_after(Clock::duration cost) const {
  if (owner_.interval) return *owner_.interval;
  return std::max<Clock::duration>(
      {shortest_interval, times_the_cost * cost, (Clock::now() - start_) / share_of_the_time});
}

}  // namespace bezierbench::run
