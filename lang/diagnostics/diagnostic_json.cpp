#include "lang/diagnostics/diagnostic.hpp"

#include <nlohmann/json.hpp>

namespace rt::lang {

namespace {

using Json = nlohmann::ordered_json;

void put_place(Json& out, Span span, const SourceMap& sources) {
  const Position begin = sources.position(span.file, span.begin);
  const Position end = sources.position(span.file, span.end);
  out["file"] = sources.file(span.file).name;
  out["line"] = begin.line;
  out["column"] = begin.column;
  out["end_line"] = end.line;
  out["end_column"] = end.column;
  out["begin"] = span.begin;
  out["end"] = span.end;
}

Json notes(const std::vector<Note>& notes, const SourceMap& sources) {
  Json out = Json::array();
  for (const Note& note : notes) {
    Json entry{{"message", note.message}};
    if (note.span) put_place(entry, *note.span, sources);
    out.push_back(std::move(entry));
  }
  return out;
}

Json inclusions(FileId file, const SourceMap& sources) {
  Json out = Json::array();
  while (sources.file(file).included_from.file != file) {
    const Span from = sources.file(file).included_from;
    put_place(out.emplace_back(Json::object()), from, sources);
    file = from.file;
  }
  return out;
}

} // namespace

std::string render_json(const std::vector<Diagnostic>& diagnostics, const SourceMap& sources) {
  Json out = Json::array();
  for (const Diagnostic& diagnostic : diagnostics) {
    Json entry{{"severity", spelling(diagnostic.severity)}, {"code", diagnostic.code}, {"message", diagnostic.message}};
    put_place(entry, diagnostic.span, sources);
    entry["label"] = diagnostic.label;
    entry["notes"] = notes(diagnostic.notes, sources);
    entry["call_stack"] = notes(diagnostic.call_stack, sources);
    entry["included_from"] = inclusions(diagnostic.span.file, sources);
    out.push_back(std::move(entry));
  }
  // A file that is not valid UTF-8 has its own diagnostic, and its bytes must not break the report of it.
  return out.dump(2, ' ', false, Json::error_handler_t::replace);
}

} // namespace rt::lang
