#include "tools/lsp/diagnostics.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace rt::tools::lsp {
namespace {

using nlohmann::json;

// LSP 3.17, "DiagnosticSeverity": 1 error, 2 warning, 4 hint. A note reports an assumption, and requires no fix.
int severity(lang::Severity severity) {
  switch (severity) {
  case lang::Severity::error:
    return 1;
  case lang::Severity::warning:
    return 2;
  case lang::Severity::note:
    return 4;
  }
  return 1;
}

// Notes with a place become related information, the others lines of the message.
void add_notes(json& diagnostic, std::string& message, const std::vector<lang::Note>& notes, Ranges& ranges) {
  for (const lang::Note& note : notes) {
    auto location = note.span ? ranges.location(*note.span) : std::nullopt;
    if (location)
      diagnostic["relatedInformation"].push_back({{"location", std::move(*location)}, {"message", note.message}});
    else
      message += "\n" + note.message;
  }
}

json to_json(const lang::Diagnostic& d, Ranges& ranges) {
  json result{{"range", ranges.range(d.span)}, {"severity", severity(d.severity)}, {"source", "rtlang"}};
  if (!d.code.empty()) result["code"] = d.code;
  std::string message = d.label.empty() ? d.message : fmt::format("{}: {}", d.message, d.label);
  add_notes(result, message, d.notes, ranges);
  add_notes(result, message, d.call_stack, ranges);
  result["message"] = std::move(message);
  return result;
}

void collect(const Workspace& workspace, const Document& scene, const lang::Loaded& loaded, PositionEncoding encoding,
             std::map<std::string, json>& found) {
  Ranges ranges(workspace, loaded.sources, encoding);
  for (const auto* list : {&loaded.diagnostics, &loaded.remarks}) {
    for (lang::Diagnostic d : *list) {
      std::optional<std::string> uri = workspace.uri_of(loaded.sources.file(d.span.file));
      if (!uri) { // it is shown at the start of the scene
        d.message = fmt::format("{}: {}", loaded.sources.file(d.span.file).name, d.message);
        d.span = {};
        uri = scene.uri;
      }
      json& about = found.try_emplace(*uri, json::array()).first->second;
      json diagnostic = to_json(d, ranges);
      if (std::ranges::find(about, diagnostic) == about.end()) about.push_back(std::move(diagnostic));
    }
  }
}

} // namespace

const LineTable& Ranges::lines(lang::FileId file) {
  return lines_.try_emplace(file, sources_.file(file).text).first->second;
}

json Ranges::range(lang::Span span) {
  const auto place = [&](std::uint32_t offset) -> json {
    const TextPosition position = lines(span.file).position(offset, encoding_);
    return {{"line", position.line}, {"character", position.character}};
  };
  return {{"start", place(span.begin)}, {"end", place(span.end)}};
}

std::optional<json> Ranges::location(lang::Span span) {
  const auto uri = workspace_.uri_of(sources_.file(span.file));
  if (!uri) return std::nullopt;
  return json{{"uri", *uri}, {"range", range(span)}};
}

std::optional<std::map<std::string, json>> all_diagnostics(Workspace& workspace, PositionEncoding encoding,
                                                           const std::atomic<bool>& stop) {
  std::map<std::string, json> found;
  for (const auto& document : workspace.documents()) found.emplace(document->uri, json::array());
  for (Document* scene : workspace.scenes()) {
    const lang::Loaded* loaded = workspace.load(*scene, stop);
    if (!loaded) return std::nullopt;
    collect(workspace, *scene, *loaded, encoding, found);
  }
  return found;
}

} // namespace rt::tools::lsp
