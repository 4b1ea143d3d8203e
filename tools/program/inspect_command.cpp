// SPDX-License-Identifier: MIT
#include "tools/program/inspect_command.h"

#include <fmt/format.h>

#include "tools/io/detail/file.h"
#include "tools/program/inspection.h"
#include "tools/program/options.h"
#include "tools/program/text.h"

namespace sinkmesh::program {
namespace {

void begin(Inspection& inspection, const InspectArguments& arguments, const char* kind, Format format,
           int dim) {
  inspection.summary.line(kind, printable(arguments.files.input, 200));
  inspection.report["input"] = {{"path", arguments.files.input},
                                {"kind", kind},
                                {"format", std::string(name_of(format))},
                                {"dimension", dim}};
}

template <int Dim>
void inspect_surface_file(const InspectArguments& arguments, Format format, Inspection& inspection) {
  SourceLines lines;
  const Surface<Dim> surface = read_surface<Dim>(arguments.files.input, {format, &lines});
  begin(inspection, arguments, "surface", format, Dim);
  inspect_surface<Dim>(surface, lines, arguments.ratio.value_or(default_ratio(Dim)), inspection);
}

template <int Dim>
void inspect_mesh_file(const InspectArguments& arguments, Format format, Inspection& inspection) {
  const Mesh<Dim> mesh = read_mesh<Dim>(arguments.files.input, {format, nullptr});
  begin(inspection, arguments, "mesh", format, Dim);
  inspect_mesh<Dim>(mesh, arguments.ratio.value_or(default_ratio(Dim)), inspection);
}

// A format for meshes says the dimension in the file only.
void inspect_mesh_of_any_dimension(const InspectArguments& arguments, Format format, Inspection& inspection) {
  try {
    return inspect_mesh_file<3>(arguments, format, inspection);
  } catch (const FileError& in_space) {
    if (arguments.files.input == "-") throw;  // cannot be read twice
    try {
      return inspect_mesh_file<2>(arguments, format, inspection);
    } catch (const FileError& in_plane) {
      // The reader that came further has seen what is wrong; the other one only that the dimension is.
      if (in_plane.line() > in_space.line()) throw;
    }
    throw;
  }
}

Format format_of(const InspectArguments& arguments) {
  const std::optional<Format> format = input_format(arguments.files);
  if (format) return *format;
  if (arguments.files.input == "-") {
    throw UsageError("standard input has no suffix: give its format, --format NAME");
  }
  throw FileError(
      arguments.files.input,
      fmt::format("its suffix is that of no known format: give one with --format, {} for a surface, "
                  "{} for a mesh",
                  format_names(FileRole::surface_in), format_names(FileRole::mesh_in)));
}

}  // namespace

CLI::App* add_inspect_command(CLI::App& program, InspectArguments& arguments) {
  CLI::App* const command = program.add_subcommand(
      "inspect", "Tell what a surface or a mesh is, and everything that is wrong with it");
  command->add_option("FILE", arguments.files.input, "A surface, or a mesh; - is standard input")->required();
  command->add_option("--format", arguments.files.input_format, "Format of FILE, if its suffix does not tell")
      ->type_name("NAME");
  command->add_option("--ratio", arguments.ratio, "Simplices with a larger r/l are counted as of low quality")
      ->check(at_least(0))
      ->default_str(kDefaultRatioText);
  add_report_option(*command, arguments.report);
  command->footer(
      "Example:\n  sinkmesh inspect rotor.off\n\n"
      "Exit status: 0 no defects; 1 defects, which are listed, or a file that cannot be read.");
  return command;
}

ExitStatus run(const InspectArguments& arguments) {
  const Format format = format_of(arguments);
  require_distinct(arguments.files, {{"--report", arguments.report}});
  check_writable(arguments.report);
  Inspection inspection;
  if (supports(format, FileRole::surface_in, 3)) {
    inspect_surface_file<3>(arguments, format, inspection);
  } else if (supports(format, FileRole::surface_in, 2)) {
    inspect_surface_file<2>(arguments, format, inspection);
  } else if (supports(format, FileRole::mesh_in, 3) || supports(format, FileRole::mesh_in, 2)) {
    inspect_mesh_of_any_dimension(arguments, format, inspection);
  } else {
    throw FileError(
        arguments.files.input,
        "holds points only, and inspect looks at surfaces and meshes; sinkmesh delaunay meshes points");
  }
  if (!arguments.report.empty()) io_detail::write_file(arguments.report, to_text(inspection.report));
  print(inspection.summary.text());
  return inspection.has_defects ? ExitStatus::unusable_input : ExitStatus::done;
}

}  // namespace sinkmesh::program
