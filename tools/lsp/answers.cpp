#include "tools/lsp/answers.hpp"

#include "lang/format/format.hpp"
#include "lang/ide/complete.hpp"
#include "lang/ide/definition.hpp"
#include "lang/ide/hover.hpp"
#include "lang/ide/outline.hpp"
#include "lang/text/words.hpp"
#include "tools/lsp/line_edits.hpp"
#include "tools/lsp/request_error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

namespace rt::tools::lsp {
namespace {

using nlohmann::json;

// LSP 3.17, "CompletionItemKind".
int completion_kind(const lang::ReferenceEntry* entry, std::string_view word) {
  if (lang::is_reserved(lang::classify(word))) return 14; // keyword
  if (!entry) return 6;                                   // variable
  if (entry->section == "chain") return 2;                // method
  if (entry->section == "builtins") return 3;             // function
  if (entry->section == "library") return 21;             // constant
  return 7;                                               // class
}

// LSP 3.17, "SymbolKind".
int symbol_kind(lang::OutlineEntry::What what) {
  using What = lang::OutlineEntry::What;
  switch (what) {
  case What::value:
    return 13; // variable
  case What::function:
    return 12;
  case What::noun:
    return 5; // class
  case What::module:
    return 2;
  case What::parameter:
    return 14; // constant
  case What::property:
    return 7;
  case What::thing:
    return 19; // object
  }
  return 13;
}

json to_json(const std::vector<lang::OutlineEntry>& entries, Ranges& ranges) {
  json list = json::array();
  for (const lang::OutlineEntry& entry : entries)
    list.push_back({{"name", entry.name},
                    {"detail", entry.detail},
                    {"kind", symbol_kind(entry.what)},
                    {"range", ranges.range(entry.whole)},
                    {"selectionRange", ranges.range(entry.name_span)},
                    {"children", to_json(entry.children, ranges)}});
  return list;
}

} // namespace

Answers::Answers(Workspace& workspace) : workspace_(workspace) {
  for (lang::ReferenceEntry& entry : lang::reference()) entries_.emplace(entry.name, entry);
}

Document& Answers::document(const json& params) {
  const auto& uri = params.at("textDocument").at("uri").get_ref<const std::string&>();
  if (Document* found = workspace_.find(uri)) return *found;
  throw RequestError(ErrorCode::invalid_params, fmt::format("{} is not open", uri));
}

Answers::Asked Answers::asked(const json& params) {
  Document& asked_about = document(params);
  const json& position = params.at("position");
  const TextPosition at{position.at("line").get<std::uint32_t>(), position.at("character").get<std::uint32_t>()};
  const DocumentPlace place = workspace_.place_of(asked_about);
  Ranges ranges(workspace_, place.analysis->program->sources, encoding_);
  const auto offset = static_cast<std::uint32_t>(ranges.offset(place.file, at));
  return {asked_about, place, std::move(ranges), offset};
}

json Answers::hover(const json& params) {
  Asked at = asked(params);
  const auto found = lang::hover(*at.place.analysis, at.place.file, at.offset);
  if (!found) return nullptr;
  return {{"contents", {{"kind", "plaintext"}, {"value", found->text}}}, {"range", at.ranges.range(found->span)}};
}

json Answers::definition(const json& params) {
  Asked at = asked(params);
  const auto found = lang::find_definition(*at.place.analysis, at.place.file, at.offset);
  const auto location = found ? at.ranges.location(*found) : std::nullopt;
  return location ? *location : json();
}

json Answers::references(const json& params) {
  Asked at = asked(params);
  const bool with_declaration = params.at("context").at("includeDeclaration").get<bool>();
  const auto declared = lang::find_definition(*at.place.analysis, at.place.file, at.offset);
  json list = json::array();
  for (const lang::Span span : lang::find_references(*at.place.analysis, at.place.file, at.offset)) {
    if (!with_declaration && declared == span) continue;
    if (auto location = at.ranges.location(span)) list.push_back(std::move(*location));
  }
  return list;
}

json Answers::highlight(const json& params) {
  Asked at = asked(params);
  const auto declared = lang::find_definition(*at.place.analysis, at.place.file, at.offset);
  json list = json::array();
  for (const lang::Span span : lang::find_references(*at.place.analysis, at.place.file, at.offset))
    if (span.file == at.place.file)
      list.push_back({{"range", at.ranges.range(span)}, {"kind", declared == span ? 3 : 2}}); // written, read
  return list;
}

json Answers::completion(const json& params) {
  Asked at = asked(params);
  const lang::WordCompletion found = lang::complete(*at.place.analysis, at.place.file, at.offset);
  if (found.is_path) return path_completion(at, found.begin);
  const json range = at.ranges.range({at.place.file, static_cast<std::uint32_t>(found.begin), at.offset});
  json items = json::array();
  for (const std::string& word : found.words) {
    const auto entry = entries_.find(word);
    json item{{"label", word},
              {"kind", completion_kind(entry == entries_.end() ? nullptr : &entry->second, word)},
              {"sortText", fmt::format("{:04}", items.size())},
              {"textEdit", {{"range", range}, {"newText", word}}}};
    if (entry != entries_.end()) item["detail"] = entry->second.signature;
    items.push_back(std::move(item));
  }
  return {{"isIncomplete", false}, {"items", std::move(items)}};
}

json Answers::path_completion(const Asked& at, std::size_t begin) const {
  namespace fs = std::filesystem;
  const std::string& text = at.document.text;
  const std::string typed = text.substr(begin, at.offset - begin);
  const std::size_t slash = typed.rfind('/');
  const fs::path folder =
      fs::path(at.document.path).parent_path() / (slash == std::string::npos ? "" : typed.substr(0, slash));
  const std::size_t name_begin = slash == std::string::npos ? begin : begin + slash + 1;
  Ranges ranges(workspace_, at.program().sources, encoding_);
  const json range = ranges.range({at.place.file, static_cast<std::uint32_t>(name_begin), at.offset});
  json items = json::array();
  if (at.document.path.empty()) return items;
  for (const std::string& name : workspace_.files().files_in(folder)) {
    if (!name.ends_with(".rtl") || (folder / name).lexically_normal() == at.document.path) continue;
    items.push_back({{"label", name}, {"kind", 17}, {"textEdit", {{"range", range}, {"newText", name}}}}); // a file
  }
  return items;
}

json Answers::resolve_completion(const json& item) {
  json whole = item;
  const auto& word = item.at("label").get_ref<const std::string&>();
  const auto entry = entries_.find(word);
  const std::string text = entry != entries_.end() ? lang::describe(entry->second) : lang::describe_keyword(word);
  if (!text.empty()) whole["documentation"] = {{"kind", "plaintext"}, {"value", text}};
  return whole;
}

json Answers::formatting(const json& params) {
  const Document& text = document(params);
  lang::SourceMap sources;
  const lang::FileId file = sources.add(text.uri, "", text.text);
  const lang::Formatted formatted = lang::format(sources, file);
  if (!formatted.diagnostics.empty()) return nullptr; // they are already shown
  Ranges ranges(workspace_, sources, encoding_);
  json edits = json::array();
  for (const Edit& edit : line_edits(text.text, formatted.text)) {
    const lang::Span span{file, static_cast<std::uint32_t>(edit.begin), static_cast<std::uint32_t>(edit.end)};
    edits.push_back({{"range", ranges.range(span)}, {"newText", edit.text}});
  }
  return edits;
}

json Answers::symbols(const json& params) {
  const DocumentPlace place = workspace_.place_of(document(params));
  Ranges ranges(workspace_, place.analysis->program->sources, encoding_);
  return to_json(lang::outline(*place.analysis, place.file), ranges);
}

} // namespace rt::tools::lsp
