// SPDX-License-Identifier: GPL-3.0-or-later
// A file that appears at its place whole or not at all.
#pragma once

#include <cstddef>
#include <memory>
#include <span>
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
  friend void commit_together(std::span<const std::unique_ptr<OutputFile>>);
  void flush() const;
  void rename_to_place();

  std::string path_, temporary_path_;
  std::size_t noted_ = 0; ///< for removal
  bool overwrite_ = false, committed_ = false;
};

/// Commits files that belong together, as sheets of a plot do: all are flushed before the first is
/// renamed, and `remove_temporary_files` waits until the last one is, so that a program that is
/// interrupted has all of them or none. Throws Error as `commit` does; where renaming itself fails,
/// those before it stay.
void commit_together(std::span<const std::unique_ptr<OutputFile>> files);

/// Writes the text whole or not at all. Throws Error where it can't be written, or exists and
/// `overwrite` is off.
void write_text(const std::string& text, const std::string& path, bool overwrite);

/// Removes the temporary files of all OutputFiles that live in this process, for a program that
/// ends at once; safe in signal handlers. A file is noted for it before it is there.
void remove_temporary_files() noexcept;

} // namespace orograph
