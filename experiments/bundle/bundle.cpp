// SPDX-License-Identifier: MIT
#include "experiments/bundle/bundle.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <span>
#include <stdexcept>
#include <system_error>

#include "experiments/bundle/atomic_file.hpp"
#include "experiments/bundle/digest.hpp"
#include "experiments/failure.hpp"

namespace bezierbench::bundle {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(const fs::path& path, std::string_view what) {
  throw Failure(Exit::input_output, "{}: {}", path.string(), what);
}

void make_folder(const fs::path& path) {
  std::error_code error;
  fs::create_directories(path, error);
  if (error) fail(path, fmt::format("cannot be created: {}; choose another --out", error.message()));
}

/// Removes a file or folder. Shards that begin meanwhile may put their locks into the folder; they remove it themselves
/// when they find that the bundle is complete.
void remove_entry(const fs::path& path) {
  std::error_code error;
  fs::remove_all(path, error);
  if (error && error != std::errc::directory_not_empty && error != std::errc::no_such_file_or_directory)
    fail(path, fmt::format("cannot be removed: {}; remove it and run again", error.message()));
}

// blocks/ is looked for first: finish() of another process writes bundle.json before it removes blocks/.
bool is_bundle(const fs::path& path) { return is_inner_folder(path / blocks_name) || is_there(path / manifest_name); }

}  // namespace

BundleDirectory BundleDirectory::create(const fs::path& path) {
  make_folder(path);
  const Folder folder = list_folder(path);
  const bool empty = folder.files.empty() && folder.others.empty();
  if (!empty && !is_bundle(path)) fail(path, "is not empty and not a bundle; choose another --out");
  // From here on the folder is recognisable as a bundle, also by a run that continues one that was killed.
  if (!is_there(path / manifest_name)) make_folder(path / blocks_name);
  return BundleDirectory(path);
}

BundleDirectory BundleDirectory::open(const fs::path& path) {
  if (!is_bundle(path)) fail(path, "is not a bundle; give a folder that `bezierbench run` wrote");
  return BundleDirectory(path);
}

void BundleDirectory::write(std::string_view name, std::string_view bytes) const {
  const bool plain = !name.empty() && name.front() != '.' && name.find('/') == std::string_view::npos;
  if (!plain || name == manifest_name || name == sums_name || name == blocks_name)
    throw std::invalid_argument(fmt::format("'{}' is not allowed as the name of a bundle's file", name));
  make_partial_before_change();
  write_bundle_file(path_ / name, bytes);
}

std::string BundleDirectory::read(std::string_view name) const { return read_bundle_file(path_ / name); }

std::optional<std::string> BundleDirectory::read_if_listed(std::string_view name) const {
  if (!has(name) || !has(sums_name)) return std::nullopt;
  std::string bytes = read(name);
  const std::string lines = '\n' + read(sums_name);
  if (lines.find('\n' + sha256sum_line(name, bytes)) == std::string::npos) return std::nullopt;
  return bytes;
}

std::string BundleDirectory::read_listed(std::string_view name) const {
  auto bytes = read_if_listed(name);
  if (!bytes) fail(path_ / name, has(name) ? "is not what SHA256SUMS lists; restore both" : "is missing; restore it");
  return std::move(*bytes);
}

std::optional<CsvDocument> BundleDirectory::table(std::string_view name) const {
  if (!has(name) && !parse_sums(read(sums_name)).digests.contains(std::string(name))) return std::nullopt;
  return parse_csv(read_listed(name), place(name));
}

bool BundleDirectory::has(std::string_view name) const {
  std::error_code ignored;
  return fs::is_regular_file(fs::symlink_status(path_ / name, ignored));
}

Manifest BundleDirectory::manifest() const { return parse_manifest(read(manifest_name), place(manifest_name)); }

void BundleDirectory::make_partial_before_change() const {
  if (!has(manifest_name)) return;
  Manifest current = manifest();
  if (current.state != complete) return;
  current.state = partial;
  write_bundle_file(path_ / manifest_name, manifest_json(current));
}

void BundleDirectory::write_if_different(std::string_view name, std::string_view bytes) const {
  if (has(name) && read(name) == bytes) return;
  make_partial_before_change();
  write_bundle_file(path_ / name, bytes);
}

void BundleDirectory::finish(Manifest manifest, const std::vector<MethodDigest>& digests) const {
  const std::string text = digests_csv(digests);
  manifest.accuracy_digest = sha256_hex(text);
  if (manifest.state != partial) write_if_different(digests_name, text);
  const std::string manifest_text = manifest_json(manifest);
  (void)parse_manifest(manifest_text, place(manifest_name));  // never write what could not be read again

  Folder folder = list_folder(path_);
  const auto no_own_line = [](const std::string& name) {  // hidden files belong to the desktop or the file server
    return name == manifest_name || name == sums_name || name.starts_with('.');
  };
  std::erase_if(folder.files, no_own_line);
  // bundle.json is written last, since it alone says `complete`. Its line is made from the bytes that it will have.
  const auto place = std::ranges::lower_bound(folder.files, manifest_name);
  const auto before = std::span(folder.files.begin(), place);
  const auto after = std::span(place, folder.files.end());
  const std::string sums =
      sha256sums(path_, before) + sha256sum_line(manifest_name, manifest_text) + sha256sums(path_, after);
  write_if_different(sums_name, sums);
  write_if_different(manifest_name, manifest_text);

  if (manifest.state == complete) clear_away();
}

void BundleDirectory::clear_away() const {
  for (const std::string& name : list_folder(path_).temporaries) remove_entry(path_ / name);
  remove_entry(blocks());
}

bool is_inner_folder(const std::filesystem::path& path) {
  namespace fs = std::filesystem;
  std::error_code ignored;  // an error here also makes the write fail, and that error is reported
  const auto type = fs::symlink_status(path, ignored).type();
  if (type == fs::file_type::directory) return true;
  if (type == fs::file_type::not_found || type == fs::file_type::none || type == fs::file_type::unknown) return false;
  throw Failure(Exit::input_output, "{}: is not a folder; remove it", path.string());
}

bool is_there(const std::filesystem::path& path) {
  std::error_code ignored;
  return std::filesystem::exists(std::filesystem::symlink_status(path, ignored));
}

Folder list_folder(const std::filesystem::path& path) {
  namespace fs = std::filesystem;
  Folder folder;
  std::error_code error;
  for (fs::directory_iterator entry(path, error); !error && entry != fs::directory_iterator(); entry.increment(error)) {
    const std::string name = entry->path().filename().string();
    std::error_code ignored;  // fails if the entry was removed meanwhile, such as another writer's temporary file
    const fs::file_status status = entry->symlink_status(ignored);
    if (is_temporary_name(name)) {
      folder.temporaries.push_back(name);
    } else if (fs::is_regular_file(status)) {
      folder.files.push_back(name);
    } else {
      folder.others.push_back(name);
    }
  }
  if (error)
    throw Failure(Exit::input_output, "{}: cannot be listed: {}; check the path and its permissions", path.string(),
                  error.message());
  for (auto* names : {&folder.files, &folder.temporaries, &folder.others}) std::ranges::sort(*names);
  return folder;
}

}  // namespace bezierbench::bundle
