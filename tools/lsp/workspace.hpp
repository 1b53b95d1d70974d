#pragma once

#include "lang/load.hpp"
#include "tools/lsp/text_positions.hpp"

#include <nlohmann/json_fwd.hpp>

#include <atomic>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace rt::tools::lsp {

/// A text open in the editor, and what is known about it as a scene of its own.
struct Document {
  std::string uri;  ///< as the client writes it
  std::string path; ///< canonical; empty if it is not a file
  std::int64_t version = 0;
  std::string text;
  std::optional<lang::Analysis> analysis;
  std::optional<lang::Loaded> loaded;
};

/// A document among the texts of a scene: its own, or one that includes it.
struct DocumentPlace {
  const lang::Analysis* analysis;
  lang::FileId file;
};

/// The texts that are open in an editor, overriding the files on disk.
class Workspace {
public:
  explicit Workspace(std::vector<std::string> include_roots);
  Workspace(const Workspace&) = delete;
  Workspace& operator=(const Workspace&) = delete;

  /// What relative paths in texts that are not files are resolved against.
  void set_folder(const std::string& folder) { folder_ = folder; }
  void open(const std::string& uri, std::int64_t version, std::string text);
  /// Applies one entry of `contentChanges`: a new text, or a range of the old one and its replacement. Throws
  /// nlohmann::json::exception for anything else.
  void change(Document& document, std::int64_t version, const nlohmann::json& change, PositionEncoding encoding);
  void close(std::string_view uri);
  /// Files on disk may have changed: discards everything derived from them.
  void forget();

  /// Null if it is not open.
  Document* find(std::string_view uri);
  const std::vector<std::unique_ptr<Document>>& documents() const { return documents_; }
  const lang::FileSystem& files() const { return files_; }
  /// As the client writes it, if it is open.
  std::string uri_of(const std::string& path) const;
  /// For a file of a scene. Nothing for texts that are not files.
  std::optional<std::string> uri_of(const lang::SourceFile& file) const;

  /// The document in the scene that it is part of: that of an open text that includes it, else its own.
  DocumentPlace place_of(Document& document);
  /// The documents that no other one includes, at least one of each cycle.
  std::vector<Document*> scenes();
  /// The diagnostics of loading the document as a scene, lint included. Null if `stop` was set meanwhile.
  const lang::Loaded* load(Document& document, const std::atomic<bool>& stop);
  /// The analysis of the document's scene with some files replaced by other texts.
  lang::Analysis analyse_with(const DocumentPlace& place,
                              const std::vector<std::pair<std::string, std::string>>& texts);

private:
  const lang::Analysis& analysis(Document& document);
  lang::Analysis analyse(const Document& document, const lang::FileSystem& files) const;
  void forget_texts_of(const Document& document);

  lang::OpenBuffers files_;
  std::vector<std::string> include_roots_;
  std::string folder_ = ".";
  std::vector<std::unique_ptr<Document>> documents_; // in the order of opening
};

} // namespace rt::tools::lsp
