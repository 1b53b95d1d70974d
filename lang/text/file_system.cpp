#include "lang/text/file_system.hpp"

#include "lang/text/sort_unique.hpp"

#include <algorithm>
#include <cerrno>
#include <cstdint>
#include <fstream>
#include <system_error>

namespace rt::lang {

namespace fs = std::filesystem;

namespace {

[[noreturn]] void fail(int error, const fs::path& path) {
  throw std::system_error(error, std::generic_category(), path.string());
}

class Disk : public FileSystem {
public:
  std::string read(const fs::path& path) const override {
    std::error_code error;
    if (fs::is_directory(path, error)) fail(EISDIR, path);
    constexpr std::uintmax_t most = 0xffff'ffff; // positions in a text are 32-bit numbers
    std::ifstream in(path, std::ios::binary);
    if (!in) fail(errno, path);
    std::string text;
    const auto size = fs::file_size(path, error);
    if (!error && size > most) fail(EFBIG, path);
    if (!error) text.reserve(size);
    char buffer[1 << 16];
    while (in.read(buffer, sizeof buffer) || in.gcount() > 0)
      text.append(buffer, static_cast<std::size_t>(in.gcount()));
    if (text.size() > most) fail(EFBIG, path);
    if (in.bad()) fail(EIO, path);
    return text;
  }

  bool exists(const fs::path& path) const override {
    std::error_code error;
    return fs::exists(path, error);
  }

  bool is_pipe(const fs::path& path) const override {
    std::error_code error;
    return fs::is_fifo(path, error);
  }

  fs::path canonical(const fs::path& path) const override {
    std::error_code error;
    fs::path whole = fs::weakly_canonical(path, error);
    return error ? fs::absolute(path).lexically_normal() : whole;
  }

  std::vector<std::string> files_in(const fs::path& folder) const override {
    std::vector<std::string> names;
    std::error_code error;
    for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error))
      if (std::error_code unknown; entry->is_regular_file(unknown)) names.push_back(entry->path().filename().string());
    std::ranges::sort(names);
    return names;
  }
};

} // namespace

const FileSystem& disk() {
  static const Disk the_disk;
  return the_disk;
}

std::string MemoryFiles::read(const fs::path& path) const {
  const auto found = texts_.find(canonical(path));
  if (found != texts_.end()) return found->second;
  fail(files_in(path).empty() ? ENOENT : EISDIR, path);
}

fs::path MemoryFiles::canonical(const fs::path& path) const {
  return ("/" / path).lexically_normal();
}

std::vector<std::string> MemoryFiles::files_in(const fs::path& folder) const {
  std::vector<std::string> names;
  for (const auto& [path, text] : texts_)
    if (path.parent_path() == canonical(folder)) names.push_back(path.filename().string());
  return names;
}

std::string OpenBuffers::read(const fs::path& path) const {
  const fs::path whole = canonical(path);
  return buffers_.exists(whole) ? buffers_.read(whole) : saved_.read(path);
}

bool OpenBuffers::exists(const fs::path& path) const {
  return buffers_.exists(canonical(path)) || saved_.exists(path);
}

bool OpenBuffers::is_pipe(const fs::path& path) const {
  return !buffers_.exists(canonical(path)) && saved_.is_pipe(path);
}

std::vector<std::string> OpenBuffers::files_in(const fs::path& folder) const {
  std::vector<std::string> names = saved_.files_in(folder);
  std::ranges::copy(buffers_.files_in(canonical(folder)), std::back_inserter(names));
  sort_unique(names);
  return names;
}

} // namespace rt::lang
