// SPDX-License-Identifier: MIT
#include "tools/program/files.h"

#include <fmt/format.h>

#include <filesystem>
#include <system_error>

#include "tools/io/detail/file.h"
#include "tools/io/file_error.h"
#include "tools/program/exit_status.h"

namespace sinkmesh::program {
namespace {

Format format_named(const std::string& name) {
  try {
    return format_from_name(name);
  } catch (const InputError& error) {
    throw UsageError(error.what());
  }
}

bool is_mesh_format(const std::string& name) {
  const Format format = format_named(name);
  return supports(format, FileRole::mesh_out, 2) || supports(format, FileRole::mesh_out, 3);
}

// --format is that of OUTPUT; but one that only an input can have leaves no doubt, and
// `sinkmesh refine - -o a.vtu --format off` is what anyone would try first.
bool belongs_to_input(const FileArguments& files) {
  return files.input_format.empty() && !files.output_format.empty() && !is_mesh_format(files.output_format);
}

}  // namespace

std::optional<Format> input_format(const FileArguments& files) {
  if (!files.input_format.empty()) return format_named(files.input_format);
  if (belongs_to_input(files)) return format_named(files.output_format);
  return files.input == "-" ? std::nullopt : format_by_suffix(files.input);
}

std::optional<Format> format_by_suffix(const std::string& path) {
  for (const FileRole role : {FileRole::surface_in, FileRole::points_in, FileRole::mesh_in}) {
    for (const int dim : {3, 2}) {
      try {
        return format_of_path(path, role, dim);
      } catch (const InputError&) {
        // not one of these
      }
    }
  }
  return std::nullopt;
}

Format output_format(const FileArguments& files, int dim, FileRole role) {
  const bool is_mesh = role == FileRole::mesh_out;
  const bool given = !files.output_format.empty() && !(is_mesh && belongs_to_input(files));
  if (!given && files.output == "-") {
    throw UsageError(
        fmt::format("the output is standard output, which has no suffix: give its format, --format {}",
                    format_names(role, dim)));
  }
  try {
    const Format format = given ? format_named(files.output_format) : format_of_path(files.output, role, dim);
    if (supports(format, role, dim)) return format;
    throw UsageError(fmt::format("--format {}: cannot hold a {} of dimension {}: use {}", name_of(format),
                                 is_mesh ? "mesh" : "surface", dim, format_names(role, dim)));
  } catch (const FileError& error) {
    throw UsageError(error.what());
  }
}

void require_distinct(const FileArguments& files, const std::vector<SideOutput>& side_outputs) {
  std::vector<SideOutput> taken = {{"INPUT", files.input}, {"--output", files.output}};
  if (!files.output.empty() && format_by_suffix(files.output) == Format::tetgen) {
    for (const char* const suffix : {".node", ".ele", ".face", ".edge"}) {
      taken.push_back(
          {"a companion of --output", std::filesystem::path(files.output).replace_extension(suffix).string()});
    }
  }
  const auto same = [](const std::string& a, const std::string& b) {
    std::error_code error;
    return a == b || std::filesystem::weakly_canonical(a, error) == std::filesystem::weakly_canonical(b, error);
  };
  for (const SideOutput& side : side_outputs) {
    if (side.path.empty()) continue;
    for (const SideOutput& other : taken) {
      if (!other.path.empty() && same(side.path, other.path)) {
        throw UsageError(fmt::format("{} and {} name the same file, {}", side.option, other.option,
                                     printable(side.path, 200)));
      }
    }
    taken.push_back(side);
  }
}

void check_writable(const std::string& path) {
  if (path.empty() || path == "-") return;
  std::error_code error;
  const auto status = std::filesystem::status(path, error);
  const bool in_place = std::filesystem::exists(status) && !std::filesystem::is_regular_file(status) &&
                        !std::filesystem::is_directory(status);
  // Opening a pipe would already be seen by its reader.
  if (!in_place) const io_detail::OutputFile probe(path);
}

}  // namespace sinkmesh::program
