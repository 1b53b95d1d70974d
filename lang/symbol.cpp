#include "lang/symbol.hpp"

namespace rt::lang {

namespace {

std::uint32_t hash_of(std::string_view name) {
  std::uint32_t hash = 2166136261u; // FNV-1a
  for (const char c : name) hash = (hash ^ static_cast<unsigned char>(c)) * 16777619u;
  return hash ^ (hash >> 15);
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
