// SPDX-License-Identifier: MIT
#include "tools/program/reproduce_command.h"

#include <fmt/format.h>

#include <filesystem>
#include <system_error>
#include <variant>
#include <vector>

#include "tools/io/detail/file.h"
#include "tools/io/file_error.h"
#include "tools/models/models.h"
#include "tools/program/files.h"
#include "tools/program/progress.h"
#include "tools/program/text.h"
#include "tools/reproduce/reproduce.h"

namespace sinkmesh::program {
namespace {

// The folder, made if it is not there.
std::filesystem::path output_folder(const std::string& name) {
  std::error_code error;
  std::filesystem::create_directories(name, error);
  if (!std::filesystem::is_directory(name)) {
    throw FileError(name, "is no folder, and cannot be made one; give another with --out");
  }
  return name;
}

}  // namespace

CLI::App* add_reproduce_command(CLI::App& program, ReproduceArguments& arguments) {
  CLI::App* const command = program.add_subcommand(
      "reproduce", "Every table and figure of the paper, computed anew, as one page to look at");
  command
      ->add_option("--out", arguments.folder,
                   "Folder for index.html, its numbers (.json, .csv) and its pictures")
      ->type_name("DIR")
      ->capture_default_str();
  command->add_flag("-q,--quiet", arguments.quiet, "No summary, no progress");
  command->footer("Example:\n  sinkmesh reproduce --out paper && xdg-open paper/index.html");
  return command;
}

ExitStatus run(const ReproduceArguments& arguments) {
  const std::filesystem::path folder = output_folder(arguments.folder);
  check_writable((folder / "index.html").string());
  ProgressLine progress(!arguments.quiet);
  progress.phase("generating the models");
  reproduce::Models models;
  for (const models::Model& model : models::all_models()) {
    if (const auto* const make = std::get_if<Surface2 (*)(std::size_t)>(&model.make)) {
      models.usa = (*make)(model.triangles);
    } else {
      models.in_space.emplace_back(model.name,
                                   std::get<Surface3 (*)(std::size_t)>(model.make)(model.triangles));
    }
  }
  const std::vector<reproduce::File> files = reproduce::reproduce(
      models, reproduce::describe_machine(), [&progress](std::string_view what) { progress.phase(what); });
  for (const reproduce::File& file : files) io_detail::write_file((folder / file.name).string(), file.bytes);
  progress.erase();
  if (!arguments.quiet) print(fmt::format("open {} in a browser\n", (folder / "index.html").string()));
  return ExitStatus::done;
}

}  // namespace sinkmesh::program
