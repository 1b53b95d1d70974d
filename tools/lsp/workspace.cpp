#include "tools/lsp/workspace.hpp"

#include "tools/lsp/uri.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <system_error>

namespace rt::tools::lsp {
namespace {

TextPosition position_from(const nlohmann::json& position) {
  return {position.at("line").get<std::uint32_t>(), position.at("character").get<std::uint32_t>()};
}

// The text of that path, other than the scene's own; nothing if there is none.
std::optional<lang::FileId> find_part(const lang::SourceMap& sources, const std::string& path) {
  if (path.empty()) return std::nullopt;
  for (lang::FileId file = 1; file < sources.size(); ++file)
    if (sources.file(file).path == path) return file;
  return std::nullopt;
}

} // namespace

Workspace::Workspace(std::vector<std::string> include_roots)
    : files_(lang::disk()), include_roots_(std::move(include_roots)) {}

void Workspace::open(const std::string& uri, std::int64_t version, std::string text) {
  close(uri);
  Document& document = *documents_.emplace_back(std::make_unique<Document>());
  document.uri = uri;
  if (const auto path = file_path(uri)) document.path = files_.canonical(*path).string();
  document.version = version;
  document.text = std::move(text);
  if (!document.path.empty()) files_.open(document.path, document.text);
  forget(); // a file that was missing may be there now
}

void Workspace::change(Document& document, std::int64_t version, const nlohmann::json& change,
                       PositionEncoding encoding) {
  const auto& text = change.at("text").get_ref<const std::string&>();
  if (const auto range = change.find("range"); range != change.end()) {
    const LineTable lines(document.text);
    const std::size_t begin = lines.offset(position_from(range->at("start")), encoding);
    const std::size_t end = std::max(begin, lines.offset(position_from(range->at("end")), encoding));
    document.text.replace(begin, end - begin, text);
  } else {
    document.text = text;
  }
  document.version = version;
  if (!document.path.empty()) files_.open(document.path, document.text);
  forget_texts_of(document);
}

void Workspace::close(std::string_view uri) {
  const Document* document = find(uri);
  if (!document) return;
  if (!document->path.empty()) files_.close(document->path);
  std::erase_if(documents_, [&](const auto& other) { return other.get() == document; });
  forget();
}

void Workspace::forget() {
  for (const auto& document : documents_) document->analysis.reset(), document->loaded.reset();
}

// The scenes that the document is part of.
void Workspace::forget_texts_of(const Document& document) {
  for (const auto& other : documents_) {
    const bool is_part = other.get() == &document ||
                         (other->analysis && find_part(other->analysis->program->sources, document.path).has_value());
    if (is_part || !other->analysis) other->analysis.reset(), other->loaded.reset();
  }
}

Document* Workspace::find(std::string_view uri) {
  for (const auto& document : documents_)
    if (document->uri == uri) return document.get();
  return nullptr;
}

std::string Workspace::uri_of(const std::string& path) const {
  for (const auto& document : documents_)
    if (document->path == path) return document->uri;
  return file_uri(path);
}

std::optional<std::string> Workspace::uri_of(const lang::SourceFile& file) const {
  if (!file.path.empty()) return uri_of(file.path);
  for (const auto& document : documents_)
    if (document->path.empty() && document->uri == file.name) return document->uri;
  return std::nullopt;
}

lang::Analysis Workspace::analyse(const Document& document, const lang::FileSystem& files) const {
  lang::AnalyseOptions options;
  options.files = &files;
  options.include_roots = include_roots_;
  options.keeps_references = true;
  if (document.path.empty()) return lang::analyse_text(document.text, document.uri, folder_, options);
  return lang::analyse_file(document.path, options);
}

const lang::Analysis& Workspace::analysis(Document& document) {
  if (!document.analysis) document.analysis = analyse(document, files_);
  return *document.analysis;
}

lang::Analysis Workspace::analyse_with(const DocumentPlace& place,
                                       const std::vector<std::pair<std::string, std::string>>& texts) {
  lang::OpenBuffers files(files_);
  for (const auto& [path, text] : texts) files.open(path, text);
  for (const auto& document : documents_) {
    if (!document->analysis || &*document->analysis != place.analysis) continue;
    if (!document->path.empty()) return analyse(*document, files);
    Document changed;
    changed.uri = document->uri;
    changed.text = document->text;
    for (const auto& [path, text] : texts)
      if (path == document->uri) changed.text = text;
    return analyse(changed, files);
  }
  throw std::logic_error("the place is of no open document");
}

DocumentPlace Workspace::place_of(Document& document) {
  for (const auto& other : documents_) {
    if (other.get() == &document) continue;
    const lang::Analysis& whole = analysis(*other);
    if (const auto part = find_part(whole.program->sources, document.path)) return {&whole, *part};
  }
  return {&analysis(document), 0};
}

std::vector<Document*> Workspace::scenes() {
  const auto includes = [&](Document& scene, const Document& part) {
    return &scene != &part && find_part(analysis(scene).program->sources, part.path).has_value();
  };
  std::vector<Document*> found;
  for (const auto& document : documents_)
    if (std::ranges::none_of(documents_, [&](const auto& other) { return includes(*other, *document); }))
      found.push_back(document.get());
  for (const auto& document : documents_) // the rest are in cycles
    if (std::ranges::find(found, document.get()) == found.end() &&
        std::ranges::none_of(found, [&](Document* scene) { return includes(*scene, *document); }))
      found.push_back(document.get());
  return found;
}

const lang::Loaded* Workspace::load(Document& document, const std::atomic<bool>& stop) {
  if (document.loaded) return &*document.loaded;
  lang::LoadOptions options;
  options.files = &files_;
  options.include_roots = include_roots_;
  options.lint = true;
  options.stop = &stop;
  lang::Loaded loaded = document.path.empty() ? lang::load_text(document.text, document.uri, folder_, options)
                                              : lang::load_file(document.path, options);
  if (stop) return nullptr;
  loaded.scene.reset(); // only its diagnostics matter
  return &document.loaded.emplace(std::move(loaded));
}

} // namespace rt::tools::lsp
