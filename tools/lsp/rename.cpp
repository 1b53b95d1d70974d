#include "lang/text/characters.hpp"
#include "lang/text/words.hpp"
#include "tools/lsp/answers.hpp"
#include "tools/lsp/request_error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>

namespace rt::tools::lsp {
namespace {

using nlohmann::json;

bool is_name(std::string_view word) {
  return !word.empty() && lang::is_name_start(word.front()) && std::ranges::all_of(word, lang::is_name_part) &&
         !lang::is_reserved(lang::classify(word));
}

// What identifies a file: its path, or the name of a text that has none.
std::string key(const lang::SourceFile& file) {
  return file.path.empty() ? file.name : file.path;
}

bool is_before(const lang::Span& a, const lang::Span& b) {
  return std::pair(a.file, a.begin) < std::pair(b.file, b.begin);
}

// All places in the scene's texts that refer to the same thing. A text that is included twice declares its names twice,
// but exists only once on disk: the two change together. Places are those of its first file.
class Namesakes {
public:
  explicit Namesakes(const lang::Analysis& analysis) : program_(*analysis.program) {
    for (lang::FileId file = 0; file < program_.sources.size(); ++file)
      files_[key(program_.sources.file(file))].push_back(file);
  }

  std::vector<lang::Span> places(lang::DeclarationId name) {
    std::vector<lang::Span> places;
    names_ = {name};
    for (std::size_t i = 0; i < names_.size(); ++i)
      for (const lang::Reference& reference : program_.references.all())
        if (reference.referent == lang::Referent(names_[i])) places.push_back(first_of(reference.span));
    std::ranges::sort(places, is_before);
    places.erase(std::unique(places.begin(), places.end()), places.end());
    return places;
  }

private:
  // Records what the same place of the text refers to where it is included again.
  lang::Span first_of(lang::Span span) {
    const std::vector<lang::FileId>& same = files_.at(key(program_.sources.file(span.file)));
    for (const lang::FileId file : same) {
      const lang::Reference* other = program_.references.find({file, span.begin, span.end});
      const auto* name = other ? std::get_if<lang::DeclarationId>(&other->referent) : nullptr;
      if (name && std::ranges::find(names_, *name) == names_.end()) names_.push_back(*name);
    }
    return {same.front(), span.begin, span.end};
  }

  const lang::Program& program_;
  std::map<std::string, std::vector<lang::FileId>> files_;
  std::vector<lang::DeclarationId> names_;
};

// Nothing if there is none of the scene's own names.
std::optional<lang::DeclarationId> declaration_at(const lang::Analysis& analysis, lang::FileId file,
                                                  std::uint32_t offset) {
  const lang::Reference* reference = analysis.program->references.at(file, offset);
  const auto* name = reference ? std::get_if<lang::DeclarationId>(&reference->referent) : nullptr;
  return name ? std::optional(*name) : std::nullopt;
}

// The texts with the new name in these places, by key.
std::vector<std::pair<std::string, std::string>>
renamed(const lang::SourceMap& sources, const std::vector<lang::Span>& places, const std::string& name) {
  std::vector<std::pair<std::string, std::string>> texts;
  for (auto span = places.rbegin(); span != places.rend(); ++span) { // from the end, so that offsets stay valid
    const lang::SourceFile& file = sources.file(span->file);
    if (texts.empty() || texts.back().first != key(file)) texts.emplace_back(key(file), file.text);
    texts.back().second.replace(span->begin, span->end - span->begin, name);
  }
  return texts;
}

} // namespace

// The name at the place, if it is declared in a text that can be changed.
lang::Span Answers::renamable(const Asked& at) const {
  const auto name = declaration_at(*at.place.analysis, at.place.file, at.offset);
  if (!name) throw RequestError(ErrorCode::request_failed, "no name of the scene's own stands here");
  const lang::Span declared = at.program().references[*name].span;
  const lang::Span here = at.program().references.at(at.place.file, at.offset)->span;
  const lang::SourceMap& sources = at.program().sources;
  if (!workspace_.uri_of(sources.file(declared.file)))
    throw RequestError(ErrorCode::request_failed, fmt::format("`{}` is the library's", sources.text(here)));
  return here;
}

json Answers::prepare_rename(const json& params) {
  Asked at = asked(params);
  const lang::Span name = renamable(at);
  return {{"range", at.ranges.range(name)}, {"placeholder", at.program().sources.text(name)}};
}

json Answers::rename(const json& params) {
  Asked at = asked(params);
  const auto& name = params.at("newName").get_ref<const std::string&>();
  if (!is_name(name)) throw RequestError(ErrorCode::invalid_params, fmt::format("`{}` is no name", name));
  renamable(at);
  const auto declared = *declaration_at(*at.place.analysis, at.place.file, at.offset);
  const std::vector<lang::Span> places = Namesakes(*at.place.analysis).places(declared);
  require_same_meaning(at, places, name);
  json changes = json::object();
  for (const lang::Span& span : places) {
    const auto uri = workspace_.uri_of(at.program().sources.file(span.file));
    changes[*uri].push_back({{"range", at.ranges.range(span)}, {"newText", name}});
  }
  return {{"changes", std::move(changes)}};
}

// With the new name the number of errors is the same, and the same places refer to the same thing: none of them is
// captured by or shadows another name.
void Answers::require_same_meaning(const Asked& at, const std::vector<lang::Span>& places, const std::string& name) {
  const lang::Analysis& before = *at.place.analysis;
  const lang::Analysis after = workspace_.analyse_with(at.place, renamed(before.program->sources, places, name));
  const lang::Span first = places.front(); // nothing before it has moved
  const auto declared = declaration_at(after, first.file, first.begin);
  const bool is_same = declared && after.report.error_count() == before.report.error_count() &&
                       after.program->references.all().size() == before.program->references.all().size() &&
                       Namesakes(after).places(*declared).size() == places.size();
  if (!is_same)
    throw RequestError(ErrorCode::request_failed,
                       fmt::format("as `{}` it would mean something else: the name is taken", name));
}

} // namespace rt::tools::lsp
