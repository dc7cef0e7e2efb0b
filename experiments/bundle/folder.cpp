// SPDX-License-Identifier: MIT
#include "experiments/bundle/folder.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <system_error>

#include "experiments/bundle/atomic_file.hpp"
#include "experiments/failure.hpp"

namespace bezierbench::bundle {

bool is_inner_folder(const std::filesystem::path& path) {
  namespace fs = std::filesystem;
  std::error_code ignored;  // an error here also makes the write fail, and that error is reported
  const auto type = fs::symlink_status(path, ignored).type();
  if (type == fs::file_type::directory) return true;
  if (type == fs::file_type::not_found || type == fs::file_type::none || type == fs::file_type::unknown) return false;
  throw Failure(Exit::input_output, fmt::format("{}: is not a folder; remove it", path.string()));
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
  if (error) {
    throw Failure(Exit::input_output, fmt::format("{}: cannot be listed: {}; check the path and its permissions",
                                                  path.string(), error.message()));
  }
  for (auto* names : {&folder.files, &folder.temporaries, &folder.others}) std::ranges::sort(*names);
  return folder;
}

}  // namespace bezierbench::bundle
