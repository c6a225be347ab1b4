#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "unstep/result.h"

/// What `batch` works on: folders, globs, list files and plain files, as one
/// ordered list of files.
namespace unstep::cli {

struct BatchInput {
  std::string path;      ///< to read
  std::string relative;  ///< its place below the output folder
  std::uint64_t bytes = 0;
};

/// An argument, folder or list line that gave no file.
struct BatchProblem {
  std::string path;
  Error error;
};

struct FileSetOptions {
  std::vector<std::string> arguments;  ///< file, folder, glob or @list
  std::vector<std::string> lists;      ///< list files; "-" is standard input
  std::string output_folder;           ///< not searched for inputs
  bool ustp = false;  ///< folders: .ustp files rather than drawings
};

struct FileSet {
  std::vector<BatchInput> inputs;  ///< by relative path, bytewise
  std::vector<BatchProblem> problems;
  std::uint64_t passed_over = 0;  ///< files of other kinds in folders
};

/// Places: a folder's files keep their tree below the folder; a glob's matches
/// keep theirs below the last folder before the first wildcard; a list's lines
/// keep their path as written, without root and leading ".."; a file named
/// as an argument keeps its name only. Symbolic links are followed, except
/// into a folder that is being searched already. invalid_argument if two
/// inputs would take the same place.
Result<FileSet> collect_files(const FileSetOptions& options);

}  // namespace unstep::cli
