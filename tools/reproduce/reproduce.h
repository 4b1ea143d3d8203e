// SPDX-License-Identifier: MIT
//
// All of it: runs the experiments, draws the figures, writes the page.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "refine/surface.h"

namespace sinkmesh::reproduce {

/// The stand-ins for the paper's data sets.
struct Models {
  Surface2 usa;
  std::vector<std::pair<std::string, Surface3>> in_space;  ///< by name, in the order of the figures
};

struct File {
  std::string name;
  std::string bytes;
};

/// @param machine  what it runs on, for the page.
/// @param tell     called with what is being done; never from two threads at once.
/// @return index.html, which holds everything; results.json, runs.csv and rounds.csv with its numbers; and
///         every picture as a file of its own.
/// Cost: about a minute and a half of CPU time for the paper's sizes, on as many threads as there are cores.
std::vector<File> reproduce(const Models& models, const std::string& machine,
                            const std::function<void(std::string_view)>& tell);

/// Processor, operating system and compiler, as far as they can be found out.
std::string describe_machine();

}  // namespace sinkmesh::reproduce
