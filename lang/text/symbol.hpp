#pragma once

#include <cstdint>
#include <deque>
#include <string>
#include <string_view>
#include <vector>

namespace rt::lang {

/// An interned name: equal names have equal numbers within one `SymbolTable`.
enum class Symbol : std::uint32_t {};
inline constexpr Symbol no_symbol{0xffffffff};

/// All names of one run, numbered from 0 in order of first occurrence. If a fixed list is interned first, its symbols
/// are its indices.
class SymbolTable {
public:
  SymbolTable();
  Symbol intern(std::string_view name);
  /// `no_symbol` if the name was never interned.
  Symbol find(std::string_view name) const;
  std::string_view name(Symbol symbol) const { return names_[static_cast<std::uint32_t>(symbol)]; }
  std::size_t size() const { return names_.size(); }

private:
  struct Bucket {
    std::uint32_t hash = 0;
    std::uint32_t symbol = 0xffffffff;
  };
  void grow();

  std::vector<Bucket> buckets_; // open addressing; the size is a power of two
  std::vector<std::string_view> names_;
  std::deque<std::string> storage_; // a deque never moves what it holds
};

} // namespace rt::lang
