#pragma once

#include "lang/session/session_statement.hpp"

#include <cstddef>
#include <cstdint>
#include <iterator>
#include <memory>
#include <vector>

namespace rt::lang {

/// What every change of a document needs to know about its statements.
enum Trait : std::uint8_t {
  trait_declares = 1,
  trait_sets_property = 2, ///< of the scene, on its own
  trait_objects = 4,
  trait_lights = 8,
  trait_camera = 16,
  trait_properties = 32,
  trait_sky = 64,
};
std::uint8_t traits_of(const Statement& statement);

/// The bit of a symbol in a Bloom filter of symbols.
constexpr std::uint64_t symbol_bit(Symbol symbol) {
  return std::uint64_t{1} << (static_cast<std::uint32_t>(symbol) % 64);
}

/// A session's statements in order. Similar documents share most of their chunks, so that another version of a long one
/// costs little; and what every change needs is stored contiguously, apart from the statements.
class Document {
public:
  struct Chunk {
    std::vector<StatementRef> statements;
    // Of each statement:
    std::vector<std::uint8_t> traits;
    std::vector<std::uint64_t> stamps;
    std::vector<std::uint64_t> names, uses; ///< Bloom filters of symbols: what it declares; what it uses from elsewhere
    // Of all of them:
    std::uint8_t all_traits = 0;
    Box3 finite_box;
  };
  using Chunks = std::vector<std::shared_ptr<const Chunk>>;

  class Iterator {
  public:
    using iterator_category = std::forward_iterator_tag;
    using value_type = StatementRef;
    using difference_type = std::ptrdiff_t;
    using pointer = const StatementRef*;
    using reference = const StatementRef&;

    Iterator() = default;
    Iterator(const Chunks& chunks, std::size_t chunk) : chunks_(&chunks), chunk_(chunk) {}
    reference operator*() const { return (*chunks_)[chunk_]->statements[at_]; }
    pointer operator->() const { return &**this; }
    Iterator& operator++() {
      if (++at_ == (*chunks_)[chunk_]->statements.size()) ++chunk_, at_ = 0;
      return *this;
    }
    Iterator operator++(int) {
      Iterator old = *this;
      ++*this;
      return old;
    }
    friend bool operator==(const Iterator&, const Iterator&) = default;

  private:
    const Chunks* chunks_ = nullptr;
    std::size_t chunk_ = 0, at_ = 0;
  };

  Iterator begin() const { return {chunks_, 0}; }
  Iterator end() const { return {chunks_, chunks_.size()}; }
  bool empty() const { return chunks_.empty(); }
  std::size_t size() const;
  const Chunks& chunks() const { return chunks_; }
  /// Whether they have the same statements.
  friend bool operator==(const Document& a, const Document& b);

private:
  friend class DocumentBuilder;
  Chunks chunks_; // none is empty
};

/// Assembles a document.
class DocumentBuilder {
public:
  void add(StatementRef statement);
  /// A chunk of another document, unchanged.
  void add(std::shared_ptr<const Document::Chunk> chunk);
  Document finish();

  /// Smaller ones are better added statement by statement: they would multiply.
  static constexpr std::size_t least_worth_sharing = 128;

private:
  void flush();

  Document document_;
  std::vector<StatementRef> pending_;
};

} // namespace rt::lang
