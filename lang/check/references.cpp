#include "lang/check/references.hpp"

#include <algorithm>
#include <tuple>
#include <utility>

namespace rt::lang {
namespace {

std::tuple<FileId, std::uint32_t, std::uint32_t> place(const Reference& reference) {
  return {reference.span.file, reference.span.begin, reference.span.end};
}

} // namespace

DeclarationId References::declare(Declaration declaration) {
  if (!is_kept_) return no_declaration;
  const auto id = static_cast<DeclarationId>(declarations_.size());
  declaration.inside = inside();
  references_.push_back({declaration.span, id, Reference::Use::declares, declaration.inside});
  declarations_.push_back(std::move(declaration));
  return id;
}

void References::begin(DeclarationId declaration) {
  if (declaration != no_declaration) open_.push_back(declaration);
}

void References::end(DeclarationId declaration) {
  if (declaration != no_declaration) open_.pop_back();
}

void References::set_known(DeclarationId declaration, const StaticType& known) {
  if (declaration != no_declaration) declarations_[static_cast<std::uint32_t>(declaration)].known = known;
}

// An item that represents many is read again if it is in error.
void References::finish() {
  std::ranges::stable_sort(references_, {}, place);
  const auto is_same = [](const Reference& a, const Reference& b) { return a.span == b.span; };
  references_.erase(std::unique(references_.begin(), references_.end(), is_same), references_.end());
}

const Reference* References::find(Span span) const {
  const auto found = std::ranges::lower_bound(references_, std::tuple(span.file, span.begin, span.end), {}, place);
  return found != references_.end() && found->span == span ? &*found : nullptr;
}

const Reference* References::at(FileId file, std::uint32_t offset) const {
  const auto after = std::ranges::upper_bound(references_, std::pair(file, offset), {},
                                              [](const Reference& r) { return std::pair(r.span.file, r.span.begin); });
  if (after == references_.begin()) return nullptr;
  const Reference& last = *std::prev(after);
  return last.span.file == file && offset <= last.span.end ? &last : nullptr;
}

} // namespace rt::lang
