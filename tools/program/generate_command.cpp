// SPDX-License-Identifier: MIT
#include "tools/program/generate_command.h"

#include <fmt/format.h>

#include <cstddef>
#include <string>
#include <variant>
#include <vector>

#include "tools/io/write.h"
#include "tools/models/models.h"
#include "tools/program/stopwatch.h"
#include "tools/program/summary.h"
#include "tools/program/text.h"

namespace sinkmesh::program {
namespace {

using models::Model;

std::string models_text() {
  std::string text;
  for (const Model& model : models::all_models()) {
    text += fmt::format("\n  {:<15}{} ({} triangles)", model.name, model.description, grouped(model.triangles));
  }
  return text;
}

template <int Dim>
ExitStatus generate(const GenerateArguments& arguments, const Model& model, std::size_t triangles,
                    Surface<Dim> (*make)(std::size_t), Stopwatch watch) {
  const Format format = output_format(arguments.files, Dim, FileRole::surface_out);
  check_writable(arguments.files.output);
  watch.lap();
  const Surface<Dim> surface = make(triangles);
  Phases phases = {{"generate", watch.lap()}};
  write_surface(arguments.files.output, surface, format);
  phases.emplace_back("write", watch.lap());
  if (arguments.quiet) return ExitStatus::done;
  const bool to_standard_output = arguments.files.output == "-";
  Summary summary;
  summary.line("model", fmt::format("{}: {}", model.name, model.description));
  summary.line("", fmt::format("{}, {}", count(surface.points.size(), "vertex", "vertices"),
                               count(surface.facets.size(), Dim == 2 ? "segment" : "triangle",
                                     Dim == 2 ? "segments" : "triangles")));
  add_times(summary, phases, watch.total());
  summary.line("output", to_standard_output ? "standard output" : printable(arguments.files.output, 200));
  print(summary.text(), to_standard_output);
  return ExitStatus::done;
}

}  // namespace

CLI::App* add_generate_command(CLI::App& program, GenerateArguments& arguments) {
  CLI::App* const command =
      program.add_subcommand("generate", "The models of the paper, as surfaces that can be refined");
  std::vector<std::string> names;
  for (const Model& model : models::all_models()) names.emplace_back(model.name);
  command->add_option("NAME", arguments.name, "The model")->required()->check(CLI::IsMember(names));
  command
      ->add_option("-o,--output", arguments.files.output,
                   "The surface: .off, .obj, .stl, .ply; of usa: .poly; - is standard output")
      ->required()
      ->type_name("OUTPUT");
  command
      ->add_option("--format", arguments.files.output_format, "Format of OUTPUT, if its suffix does not tell")
      ->type_name("NAME");
  command->add_option("--triangles", arguments.triangles,
                      "About how many, on the surface (usa: inside); default: as in the paper; from a tenth to "
                      "ten times as many");
  command->add_flag("-q,--quiet", arguments.quiet, "No summary");
  command->footer("Models:" + models_text() + "\n\nExample:\n  sinkmesh generate star -o star.off");
  return command;
}

ExitStatus run(const GenerateArguments& arguments) {
  const Stopwatch watch;
  const Model& model = *models::find_model(arguments.name);
  const auto least = static_cast<std::int64_t>(model.least_triangles());
  const auto most = static_cast<std::int64_t>(model.most_triangles());
  const std::int64_t wanted = arguments.triangles.value_or(static_cast<std::int64_t>(model.triangles));
  if (wanted < least || wanted > most) {
    throw UsageError(fmt::format("--triangles {}: {} can have from {} to {}", wanted, model.name, least, most));
  }
  const auto triangles = static_cast<std::size_t>(wanted);
  return std::visit([&](auto* make) { return generate(arguments, model, triangles, make, watch); }, model.make);
}

}  // namespace sinkmesh::program
