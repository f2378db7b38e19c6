// SPDX-License-Identifier: GPL-3.0-or-later
// A file that appears at its place whole or not at all.
#pragma once

#include <cstddef>
#include <string>

namespace orograph {

/// Holds the name of a temporary file in the folder of `path`, with the same extension. The file
/// and what writers leave beside it (`-journal`) are removed by the destructor, and by
/// `remove_temporary_files`, unless `commit` has renamed it to `path`.
class OutputFile {
public:
  /// Creates the temporary file, empty. Throws Error where the folder can't be written to, where
  /// `path` exists and `overwrite` is off, or where it is no ordinary file. A symbolic link stays,
  /// and the file that it points to is written.
  OutputFile(const std::string& path, bool overwrite);
  ~OutputFile();
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  const std::string& temporary_path() const { return temporary_path_; }
  /// Flushes the file to the disk and renames it to its place. Throws Error, also where a file has
  /// appeared there meanwhile and `overwrite` is off. What replaces a file has its rights, and its
  /// owner where this process may give files away.
  void commit();

private:
  std::string path_, temporary_path_;
  std::size_t noted_ = 0; ///< for removal
  bool overwrite_ = false, committed_ = false;
};

/// Removes the temporary files of all OutputFiles that live in this process, for a program that
/// ends at once; safe in signal handlers. A thread that makes one has SIGINT and SIGTERM wait until
/// it is known here.
void remove_temporary_files() noexcept;

} // namespace orograph
