// SPDX-License-Identifier: MIT
#include "tools/program/options.h"

#include <fmt/format.h>

#include <cmath>
#include <functional>

namespace sinkmesh::program {
namespace {

template <class Compare>
CLI::Validator within(Compare compare, double limit, const char* complaint, const std::string& why) {
  return {[=](std::string& text) -> std::string {
            double value = 0;
            if (!CLI::detail::lexical_cast(text, value)) return fmt::format("'{}' is not a number", text);
            if (!std::isfinite(value)) return fmt::format("'{}' is not a finite number", text);
            if (compare(value, limit)) return {};
            return fmt::format("{} is {} {:g}{}{}", text, complaint, limit, why.empty() ? "" : ", ", why);
          },
          ""};
}

}  // namespace

void add_file_options(CLI::App& command, FileArguments& files, const std::string& input_help) {
  command.add_option("INPUT", files.input, input_help + "; - is standard input")->required();
  command
      .add_option("-o,--output", files.output,
                  "The mesh: .vtu, .vtk, .mesh, .msh, or .node with .ele and .face; in the plane also .svg; - "
                  "is standard "
                  "output")
      ->required()
      ->type_name("OUTPUT");
  command.add_option("--format", files.output_format, "Format of OUTPUT, if its suffix does not tell")
      ->type_name("NAME");
  command.add_option("--input-format", files.input_format, "Format of INPUT, if its suffix does not tell")
      ->type_name("NAME");
}

void add_report_option(CLI::App& command, std::string& path) {
  command.add_option("--report", path, "Write all numbers to this file, as JSON")->type_name("FILE");
}

CLI::Validator at_least(double limit, const std::string& why) {
  return within(std::greater_equal<>(), limit, "below", why);
}
CLI::Validator above(double limit, const std::string& why) {
  return within(std::greater<>(), limit, "not above", why);
}
CLI::Validator at_most(double limit, const std::string& why) {
  return within(std::less_equal<>(), limit, "above", why);
}
CLI::Validator below(double limit, const std::string& why) {
  return within(std::less<>(), limit, "not below", why);
}

}  // namespace sinkmesh::program
