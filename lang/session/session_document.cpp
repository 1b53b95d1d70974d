#include "lang/session/session_document.hpp"

#include <algorithm>
#include <utility>

namespace rt::lang {
namespace {

constexpr std::size_t largest_chunk = 256;

std::uint64_t bits_of(const std::vector<Symbol>& symbols) {
  std::uint64_t bits = 0;
  for (const Symbol symbol : symbols) bits |= symbol_bit(symbol);
  return bits;
}

std::uint64_t declared_bits(const Statement& statement) {
  std::uint64_t bits = statement.declares() ? symbol_bit(statement.key) : 0;
  for (const TopName& name : statement.names) bits |= symbol_bit(name.name);
  return bits;
}

std::shared_ptr<const Document::Chunk> make_chunk(std::vector<StatementRef> statements) {
  auto chunk = std::make_shared<Document::Chunk>();
  for (const StatementRef& statement : statements) {
    chunk->traits.push_back(traits_of(*statement));
    chunk->stamps.push_back(statement->stamp);
    chunk->names.push_back(declared_bits(*statement));
    chunk->uses.push_back(bits_of(statement->uses) | bits_of(statement->globals));
    chunk->all_traits |= chunk->traits.back();
    chunk->finite_box.extend(statement->finite_box);
  }
  chunk->statements = std::move(statements);
  return chunk;
}

} // namespace

std::uint8_t traits_of(const Statement& statement) {
  const auto trait = [](bool holds, Trait which) { return holds ? static_cast<int>(which) : 0; };
  const StatementResult& made = statement.made;
  return static_cast<std::uint8_t>(
      trait(statement.declares(), trait_declares) | trait(statement.kind == Kind::property, trait_sets_property) |
      trait(!made.objects.empty(), trait_objects) | trait(!made.lights.empty(), trait_lights) |
      trait(made.camera.has_value(), trait_camera) | trait(!made.properties.empty(), trait_properties) |
      trait(made.sky_place.has_value(), trait_sky));
}

std::size_t Document::size() const {
  std::size_t sum = 0;
  for (const auto& chunk : chunks_) sum += chunk->statements.size();
  return sum;
}

bool operator==(const Document& a, const Document& b) {
  return a.chunks_ == b.chunks_ || std::equal(a.begin(), a.end(), b.begin(), b.end());
}

void DocumentBuilder::add(StatementRef statement) {
  pending_.push_back(std::move(statement));
  if (pending_.size() == largest_chunk) flush();
}

void DocumentBuilder::add(std::shared_ptr<const Document::Chunk> chunk) {
  flush();
  document_.chunks_.push_back(std::move(chunk));
}

void DocumentBuilder::flush() {
  if (!pending_.empty()) document_.chunks_.push_back(make_chunk(std::exchange(pending_, {})));
}

Document DocumentBuilder::finish() {
  flush();
  return std::move(document_);
}

} // namespace rt::lang
