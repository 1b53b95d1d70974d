#include "lang/check/imports.hpp"

#include "lang/check/check.hpp"
#include "lang/check/errors/statement_errors.hpp"
#include "lang/text/tokens.hpp"

#include <algorithm>
#include <filesystem>

namespace rt::lang {
namespace {

/// The path of the file; empty if it may not be read now, which is reported.
std::filesystem::path find_file(CheckContext& context, std::string_view path, Span place, std::string_view how) {
  std::filesystem::path found = context.files.find(path, place);
  if (found.empty()) return {};
  if (std::ranges::find(context.open_files, found.string()) == context.open_files.end()) return found;
  errors::file_cycle(context.report, place, how, found);
  return {};
}

/// The span of the path in an `include` or `use`.
Span path_span(const CheckContext& context, Span item) {
  const std::string_view text = context.text(item);
  std::uint32_t at = 0;
  for (Token token = next_token(text, at); token.kind != TokenKind::end; token = next_token(text, at = token.end))
    if (token.kind == TokenKind::string) return {item.file, item.begin + token.begin, item.begin + token.end};
  return item;
}

} // namespace

Unit* read_included(CheckContext& context, Unit& unit, NodeId item) {
  const Span place = unit.ast.span(item);
  const std::filesystem::path path = find_file(context, unit.ast.text(item), place, "include");
  Unit* included = path.empty() ? nullptr : context.files.read(path, place);
  if (!included) return nullptr;
  context.program.references.add(path_span(context, place), included->ast.file, Reference::Use::names_file);
  unit.includes.emplace_back(item, included);
  return included;
}

const ModuleInfo* read_module(CheckContext& context, Unit& unit, NodeId item) {
  const Span place = unit.ast.span(item);
  const std::filesystem::path path = find_file(context, unit.ast.use_item(item).path, place, "use");
  if (path.empty()) return nullptr;
  for (const ModuleInfo& known : context.program.modules) {
    if (known.path != path.string()) continue;
    context.program.references.add(path_span(context, place), known.unit->ast.file, Reference::Use::names_file);
    return &known;
  }
  Unit* read = context.files.read(path, place);
  if (!read) return nullptr;
  context.program.references.add(path_span(context, place), read->ast.file, Reference::Use::names_file);
  ModuleInfo& module = context.program.modules.emplace_back();
  module.unit = read;
  module.path = path.string();
  context.open_files.push_back(module.path);
  check_module(module, context.program, context.files, context.report, context.open_files);
  context.open_files.pop_back();
  return &module;
}

} // namespace rt::lang
