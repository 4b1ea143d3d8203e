// SPDX-License-Identifier: MIT
//
// The page: everything in one HTML file that needs no network.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "tools/reproduce/study.h"

namespace sinkmesh::reproduce {

/// A picture as HTML (<svg> or <img>), what it shows, and the same as a file of its own.
struct Picture {
  std::string html;
  std::string caption;
  std::string file_name;
  std::string file;
};

struct StudyPage {
  Study study;
  std::vector<Picture> pictures;
};

struct PageContent {
  std::string machine;
  double total_seconds = 0;
  std::vector<Picture> figures;  ///< of sections 2 to 4
  std::vector<StudyPage> studies;
};

std::string page(const PageContent& content);

}  // namespace sinkmesh::reproduce
