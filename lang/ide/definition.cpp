#include "lang/ide/definition.hpp"

namespace rt::lang {

std::optional<Span> find_definition(const Analysis& analysis, FileId file, std::uint32_t place) {
  const References& references = analysis.program->references;
  const Reference* reference = references.at(file, place);
  if (!reference) return std::nullopt;
  if (const auto* declaration = std::get_if<DeclarationId>(&reference->referent)) return references[*declaration].span;
  if (const auto* named = std::get_if<FileId>(&reference->referent)) return Span{*named, 0, 0};
  return std::nullopt;
}

std::vector<Span> find_references(const Analysis& analysis, FileId file, std::uint32_t place) {
  const References& references = analysis.program->references;
  const Reference* reference = references.at(file, place);
  if (!reference) return {};
  std::vector<Span> places;
  for (const Reference& other : references.all())
    if (other.referent == reference->referent) places.push_back(other.span);
  return places;
}

} // namespace rt::lang
