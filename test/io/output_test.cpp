// SPDX-License-Identifier: MIT
//
// No half-written file: what is under the name is the old content, the new content, or nothing.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include "test/support/io_files.h"
#include "test/support/sample_files.h"
#include "tools/io/read.h"
#include "tools/io/write.h"

namespace sinkmesh {
namespace {

using test::sample_mesh;
using test::TemporaryFolder;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::StartsWith;

// The message of the FileError that is thrown.
std::string refusal(const std::string& path, const Mesh3& mesh, std::optional<Format> format = std::nullopt) {
  try {
    write_mesh(path, mesh, format);
  } catch (const FileError& error) {
    return error.what();
  }
  return "written";
}

TEST(Output, AppearsUnderItsNameOnly) {
  const TemporaryFolder folder;
  write_mesh(folder.path("a.vtu"), sample_mesh());
  EXPECT_THAT(folder.files(), ElementsAre("a.vtu"));
}

TEST(Output, ReplacesAFileAndKeepsItsPermissions) {
  const TemporaryFolder folder;
  const std::string path = folder.write("a.vtu", "before");
  ASSERT_EQ(chmod(path.c_str(), 0640), 0);
  write_mesh(path, sample_mesh());
  EXPECT_EQ(read_mesh(path).simplices, sample_mesh().simplices);
  struct stat status {};
  ASSERT_EQ(stat(path.c_str(), &status), 0);
  EXPECT_EQ(status.st_mode & 0777U, 0640U);
  EXPECT_THAT(folder.files(), ElementsAre("a.vtu"));
}

TEST(Output, FollowsSymbolicLinks) {
  const TemporaryFolder folder;
  std::filesystem::create_symlink("real.vtu", folder.path("link.vtu"));
  for (int i = 0; i < 2; ++i) {  // dangling at first
    write_mesh(folder.path("link.vtu"), sample_mesh());
    EXPECT_TRUE(std::filesystem::is_symlink(folder.path("link.vtu")));
    EXPECT_EQ(read_mesh(folder.path("real.vtu")).simplices, sample_mesh().simplices);
  }
  EXPECT_THAT(folder.files(), ElementsAre("link.vtu", "real.vtu"));
}

TEST(Output, ARefusedMeshLeavesTheOldFile) {
  const TemporaryFolder folder;
  const std::string path = folder.write("a.vtu", "before");
  Mesh3 mesh = sample_mesh();
  mesh.simplices[0][0] = 99;
  EXPECT_THROW(write_mesh(path, mesh), InputError);
  EXPECT_EQ(folder.read("a.vtu"), "before");
  EXPECT_THAT(folder.files(), ElementsAre("a.vtu"));
}

TEST(Output, FoldersThatCannotBeWritten) {
  const TemporaryFolder folder;
  const Mesh3 mesh = sample_mesh();
  EXPECT_THAT(refusal(folder.path("no/a.vtu"), mesh),
              StartsWith(folder.path("no/a.vtu") + ": cannot create it: "));
  EXPECT_THAT(refusal(folder.path("no/a.vtu"), mesh), HasSubstr("check the path"));
  folder.write("file", "");
  EXPECT_THAT(refusal(folder.path("file/a.vtu"), mesh), StartsWith(folder.path("file/a.vtu") + ": cannot "));
  std::filesystem::create_directory(folder.path("b.vtu"));
  EXPECT_THAT(refusal(folder.path("b.vtu"), mesh), HasSubstr("name a file, not a folder"));
  EXPECT_THAT(refusal("/proc/a.vtu", mesh), StartsWith("/proc/a.vtu: cannot create it: "));
  if (geteuid() != 0) {  // the superuser may write everywhere
    ASSERT_EQ(chmod(folder.path("b.vtu").c_str(), 0555), 0);
    EXPECT_THAT(refusal(folder.path("b.vtu/a.vtu"), mesh), HasSubstr("check the permissions"));
    const std::string path = folder.write("locked.vtu", "before");
    ASSERT_EQ(chmod(path.c_str(), 0444), 0);
    EXPECT_THAT(refusal(path, mesh), HasSubstr("check the permissions"));
    EXPECT_EQ(folder.read("locked.vtu"), "before");
  }
  EXPECT_THAT(std::filesystem::directory_iterator(folder.path("b.vtu")), std::filesystem::directory_iterator());
}

TEST(Output, AFullDevice) {
  const Mesh3 mesh = sample_mesh();
  for (const Format format : {Format::vtu, Format::vtk, Format::medit, Format::msh, Format::msh2}) {
    EXPECT_THAT(refusal("/dev/full", mesh, format), HasSubstr("free some space"));
  }
  EXPECT_THROW(write_surface("/dev/full", test::sample_surface(), Format::off), FileError);
  EXPECT_TRUE(std::filesystem::is_character_file("/dev/full"));
}

// As a shell writes it for `-o >(gzip)`.
TEST(Output, APipeByTheNumberOfItsDescriptor) {
  int ends[2];
  ASSERT_EQ(pipe(ends), 0);
  const std::string path = "/dev/fd/" + std::to_string(ends[1]);
  const TemporaryFolder folder;
  write_mesh(folder.path("a.vtk"), sample_mesh());
  const std::string expected = folder.read("a.vtk");
  EXPECT_EQ(refusal(path, sample_mesh(), Format::vtk), "written");
  std::string found(expected.size(), ' ');
  EXPECT_EQ(read(ends[0], found.data(), found.size()), static_cast<ssize_t>(found.size()));
  EXPECT_EQ(found, expected);
  close(ends[0]);
  EXPECT_THAT(refusal(path, sample_mesh(), Format::vtk),
              HasSubstr("the program that reads the output has ended"));
  close(ends[1]);
}

// One of TetGen's three cannot be written: then none is, and what was there stays.
TEST(Output, SeveralFilesAllOrNone) {
  for (const char* blocked : {"a.node", "a.ele", "a.face"}) {
    SCOPED_TRACE(blocked);
    const TemporaryFolder folder;
    for (const char* name : {"a.node", "a.ele", "a.face"}) {
      if (std::string(name) != blocked) folder.write(name, "before");
    }
    std::filesystem::create_directory(folder.path(blocked));
    EXPECT_THAT(refusal(folder.path("a.node"), sample_mesh()), StartsWith(folder.path(blocked) + ": "));
    EXPECT_THAT(folder.files(), ElementsAre("a.ele", "a.face", "a.node"));
    for (const char* name : {"a.node", "a.ele", "a.face"}) {
      if (std::string(name) != blocked) {
        EXPECT_EQ(folder.read(name), "before");
      }
    }
  }
}

TEST(Output, NamesWithoutAFormatOrWithTheWrongOne) {
  const TemporaryFolder folder;
  const Mesh3 mesh = sample_mesh();
  EXPECT_THAT(refusal(folder.path("a"), mesh), HasSubstr("no suffix"));
  EXPECT_THAT(refusal(folder.path("a.docx"), mesh), HasSubstr(".vtu"));
  EXPECT_THAT(refusal(folder.path("a.off"), mesh), HasSubstr(".vtu"));
  EXPECT_THAT(refusal(folder.path("a.vtu"), mesh, Format::off), HasSubstr("vtu"));
  EXPECT_THAT(refusal("-", mesh), StartsWith("standard output: "));
  EXPECT_THAT(refusal("-", mesh, Format::tetgen), HasSubstr("several files"));
  EXPECT_THROW(write_surface(folder.path("a.vtu"), test::sample_surface()), FileError);
  EXPECT_THAT(folder.files(), IsEmpty());
}

}  // namespace
}  // namespace sinkmesh
