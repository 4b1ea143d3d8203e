// SPDX-License-Identifier: MIT
//
// A surface from a file, good enough to be meshed.
#pragma once

#include "refine/surface.h"
#include "refine/surface_check.h"
#include "tools/io/file_error.h"
#include "tools/io/read.h"
#include "tools/program/files.h"

namespace sinkmesh::program {

/// Of the surface that INPUT holds: 2 if its format is one for polygons in the plane.
/// @throws FileError if it is a format for points or meshes, which have messages of their own; UsageError for a
///         name that is no format.
int surface_dimension(const FileArguments& files);

/// Reads the surface that a command works on.
/// @throws FileError, UsageError
template <int Dim>
Surface<Dim> read_surface_input(const FileArguments& files, SourceLines& lines);

/// @throws FileError with the first defect of the surface, where it is in the file, and how to see all of them.
template <int Dim>
void require_sound(const Surface<Dim>& surface, const SourceLines& lines, const std::string& path);

/// The error of a file, at a line of it unless that is 0.
FileError error_at(const std::string& path, std::size_t line, const std::string& message);

/// Where a defect is in the file: the line of its first facet or vertex; 0 if that is not known.
std::size_t source_line(const SurfaceDefect& defect, const SourceLines& lines);
std::size_t seed_line(const SeedError& error, const SourceLines& lines);

}  // namespace sinkmesh::program
