// SPDX-License-Identifier: MIT
//
// The program `sinkmesh`: parses the command line, calls the library, prints.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdlib>
#include <exception>
#include <functional>
#include <new>
#include <sstream>
#include <string>
#include <vector>

#include "predicates/self_test.h"
#include "tools/io/file_error.h"
#include "tools/program/delaunay_command.h"
#include "tools/program/exit_status.h"
#include "tools/program/generate_command.h"
#include "tools/program/inspect_command.h"
#include "tools/program/refine_command.h"
#include "tools/program/reproduce_command.h"
#include "tools/program/text.h"

namespace sinkmesh::program {
namespace {

// Errors of the command-line library can have several lines.
std::string one_line(std::string text) {
  while (!text.empty() && text.back() == '\n') text.pop_back();
  for (char& c : text) {
    if (c == '\n') c = ' ';
  }
  return text;
}

ExitStatus fail(ExitStatus status, const std::string& line) {
  print(one_line(line) + "\n", true);
  return status;
}

ExitStatus wrong_usage(const CLI::App* command, const std::string& message) {
  const std::string name = command == nullptr ? "sinkmesh" : "sinkmesh " + command->get_name();
  return fail(ExitStatus::wrong_usage, name + ": " + one_line(message) + "; see " + name + " --help");
}

// What the library throws knows nothing of files.
template <class Arguments>
ExitStatus run_on(const std::string& file, const Arguments& arguments) {
  const std::string name = file == "-" ? "standard input" : file;
  try {
    return run(arguments);
  } catch (const FileError&) {
    throw;
  } catch (const InputError& error) {
    throw FileError(name, error.what());
  } catch (const CapacityError& error) {
    throw FileError(name, error.what());
  } catch (const std::bad_alloc&) {
    throw FileError(name, "not enough memory; use a smaller input, or --max-vertices");
  }
}

ExitStatus run_program(int argc, char** argv) {
  CLI::App program("Exact Delaunay meshes, refined by inserting sinks.", "sinkmesh");
  program.set_version_flag("--version", "sinkmesh " SINKMESH_VERSION);
  program.require_subcommand(0, 1);  // so that an unknown one is named
  program.footer(
      "Example:\n  sinkmesh refine rotor.off -o rotor.vtu\n\n"
      "sinkmesh COMMAND --help tells more about a command.");
  RefineArguments refine;
  DelaunayArguments delaunay;
  InspectArguments inspect;
  GenerateArguments generate;
  ReproduceArguments reproduce;
  struct Command {
    const CLI::App* app;
    std::function<ExitStatus()> run;
  };
  const std::vector<Command> commands = {
      {add_refine_command(program, refine), [&] { return run_on(refine.files.input, refine); }},
      {add_delaunay_command(program, delaunay), [&] { return run_on(delaunay.files.input, delaunay); }},
      {add_inspect_command(program, inspect), [&] { return run_on(inspect.files.input, inspect); }},
      {add_generate_command(program, generate), [&] { return run_on(generate.files.output, generate); }},
      {add_reproduce_command(program, reproduce), [&] { return run_on(reproduce.folder, reproduce); }},
  };
  const auto chosen = [&]() -> const Command* {
    const auto found =
        std::find_if(commands.begin(), commands.end(), [](const Command& c) { return c.app->parsed(); });
    return found == commands.end() ? nullptr : &*found;
  };
  try {
    program.parse(argc, argv);
  } catch (const CLI::Success& help) {
    std::ostringstream text;
    program.exit(help, text);
    print(text.str());
    return ExitStatus::done;
  } catch (const CLI::ParseError& error) {
    return wrong_usage(chosen() == nullptr ? nullptr : chosen()->app, error.what());
  }

  const Command* const command = chosen();
  if (command == nullptr) {
    return wrong_usage(nullptr, "a command is needed: refine, delaunay, inspect, generate or reproduce");
  }

  const std::string broken = predicates_self_test();
  if (!broken.empty()) return fail(ExitStatus::internal_error, "sinkmesh: " + broken);
  try {
    return command->run();
  } catch (const UsageError& error) {
    return wrong_usage(command->app, error.what());
  } catch (const FileError& error) {
    return fail(ExitStatus::unusable_input, error.what());
  }
}

ExitStatus run_reporting(int argc, char** argv) {
  try {
    return run_program(argc, argv);
  } catch (const FileError& error) {
    return fail(ExitStatus::unusable_input, error.what());
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception& error) {
    return fail(ExitStatus::internal_error, std::string("sinkmesh: internal error: ") + error.what() +
                                                "; please report it, with the command line and the input");
  }
}

ExitStatus out_of_memory() {
  // Nor is there any to say it in other words.
  print("sinkmesh: not enough memory; use a smaller input, or --max-vertices\n", true);
  return ExitStatus::unusable_input;
}

// The destructor of a JSON value needs memory, too, and ends the program where there is none.
[[noreturn]] void terminate() {
  try {
    if (std::current_exception() != nullptr) throw;
  } catch (const std::bad_alloc&) {
    std::_Exit(static_cast<int>(out_of_memory()));
  } catch (...) {
    // an error in the program
  }
  std::abort();
}

ExitStatus run_guarded(int argc, char** argv) {
  std::set_terminate(terminate);
  try {
    return run_reporting(argc, argv);
  } catch (const std::bad_alloc&) {
    return out_of_memory();
  }
}

}  // namespace
}  // namespace sinkmesh::program

int main(int argc, char** argv) { return static_cast<int>(sinkmesh::program::run_guarded(argc, argv)); }
