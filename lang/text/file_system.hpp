#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace rt::lang {

/// Where the language reads its files: the disk, an editor's open buffers overlaying it, or a test's memory. A path
/// returned by `canonical` is the only such path of its file.
class FileSystem {
public:
  virtual ~FileSystem() = default;
  /// The whole file. Throws std::system_error with the path in its message.
  virtual std::string read(const std::filesystem::path& path) const = 0;
  virtual bool exists(const std::filesystem::path& path) const = 0;
  /// Whether reading it blocks until another program writes.
  virtual bool is_pipe(const std::filesystem::path& path) const = 0;
  /// The absolute path without `.`, `..` and symbolic links. The file need not exist.
  virtual std::filesystem::path canonical(const std::filesystem::path& path) const = 0;
  /// The names of the regular files in a folder, sorted; none if it cannot be listed.
  virtual std::vector<std::string> files_in(const std::filesystem::path& folder) const = 0;
};

/// The computer's own.
const FileSystem& disk();

/// Files that exist only in memory. There are no links, and relative paths start at the root.
class MemoryFiles : public FileSystem {
public:
  /// Adds a file, or replaces its text.
  void write(const std::filesystem::path& path, std::string text) { texts_[canonical(path)] = std::move(text); }
  void remove(const std::filesystem::path& path) { texts_.erase(canonical(path)); }

  std::string read(const std::filesystem::path& path) const override;
  bool exists(const std::filesystem::path& path) const override { return texts_.contains(canonical(path)); }
  bool is_pipe(const std::filesystem::path&) const override { return false; }
  std::filesystem::path canonical(const std::filesystem::path& path) const override;
  std::vector<std::string> files_in(const std::filesystem::path& folder) const override;

private:
  std::map<std::filesystem::path, std::string> texts_;
};

/// An editor's open buffers override what is saved. `saved` must outlive it.
class OpenBuffers : public FileSystem {
public:
  explicit OpenBuffers(const FileSystem& saved) : saved_(saved) {}
  void open(const std::filesystem::path& path, std::string text) { buffers_.write(canonical(path), std::move(text)); }
  void close(const std::filesystem::path& path) { buffers_.remove(canonical(path)); }

  std::string read(const std::filesystem::path& path) const override;
  bool exists(const std::filesystem::path& path) const override;
  bool is_pipe(const std::filesystem::path& path) const override;
  std::filesystem::path canonical(const std::filesystem::path& path) const override { return saved_.canonical(path); }
  std::vector<std::string> files_in(const std::filesystem::path& folder) const override;

private:
  const FileSystem& saved_;
  MemoryFiles buffers_;
};

} // namespace rt::lang
