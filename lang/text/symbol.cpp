#include "lang/text/symbol.hpp"

#include <cstring>

namespace rt::lang {

namespace {

std::uint64_t load(const char* at, std::size_t bytes) {
  std::uint64_t word = 0;
  std::memcpy(&word, at, bytes);
  return word;
}

// Names are short: two overlapping loads cover 4 to 16 bytes, and only longer ones need a loop.
std::uint32_t hash_of(std::string_view name) {
  constexpr std::uint64_t factor = 0x9e3779b97f4a7c15u; // 2^64 divided by the golden ratio
  const char* const text = name.data();
  const std::size_t size = name.size();
  std::uint64_t first = 0, last = 0;
  if (size >= 8) {
    for (std::size_t at = 0; at + 8 < size; at += 8) first = (first ^ load(text + at, 8)) * factor;
    last = load(text + size - 8, 8);
  } else if (size >= 4) {
    first = load(text, 4);
    last = load(text + size - 4, 4);
  } else if (size > 0) {
    first = static_cast<unsigned char>(text[0]);
    last = static_cast<unsigned char>(text[size / 2]) | static_cast<std::uint64_t>(text[size - 1]) << 8;
  }
  const std::uint64_t mixed = (first ^ (last << 29) ^ (last >> 35) ^ size) * factor;
  return static_cast<std::uint32_t>(mixed >> 32);
}

} // namespace

SymbolTable::SymbolTable() : buckets_(256) {}

Symbol SymbolTable::find(std::string_view name) const {
  const std::uint32_t hash = hash_of(name);
  const std::size_t mask = buckets_.size() - 1;
  for (std::size_t i = hash & mask;; i = (i + 1) & mask) {
    const Bucket& bucket = buckets_[i];
    if (bucket.symbol == 0xffffffff) return no_symbol;
    if (bucket.hash == hash && names_[bucket.symbol] == name) return Symbol{bucket.symbol};
  }
}

Symbol SymbolTable::intern(std::string_view name) {
  const std::uint32_t hash = hash_of(name);
  const std::size_t mask = buckets_.size() - 1;
  std::size_t i = hash & mask;
  for (; buckets_[i].symbol != 0xffffffff; i = (i + 1) & mask) {
    if (buckets_[i].hash == hash && names_[buckets_[i].symbol] == name) return Symbol{buckets_[i].symbol};
  }
  const auto symbol = static_cast<std::uint32_t>(names_.size());
  names_.push_back(storage_.emplace_back(name));
  buckets_[i] = {hash, symbol};
  if (names_.size() * 2 > buckets_.size()) grow();
  return Symbol{symbol};
}

void SymbolTable::grow() {
  std::vector<Bucket> larger(buckets_.size() * 2);
  const std::size_t mask = larger.size() - 1;
  for (const Bucket& bucket : buckets_) {
    if (bucket.symbol == 0xffffffff) continue;
    std::size_t i = bucket.hash & mask;
    while (larger[i].symbol != 0xffffffff) i = (i + 1) & mask;
    larger[i] = bucket;
  }
  buckets_ = std::move(larger);
}

} // namespace rt::lang
