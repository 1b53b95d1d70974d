#pragma once

#include "lang/text/source.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace rt::lang {

enum class Severity : std::uint8_t { note, warning, error };
std::string_view spelling(Severity severity);

/// A related place of a diagnostic, or advice without a place.
struct Note {
  std::optional<Span> span;
  std::string message;
};

/// A mistake (or a remark) about a scene, as data. `code` is a key of the registry (`find_code`).
struct Diagnostic {
  Severity severity = Severity::error;
  std::string code;    ///< "E0204"
  std::string message; ///< one sentence, names in back quotes, no full stop
  Span span;           ///< empty in a note or warning about the scene as a whole, which is shown without an excerpt
  std::string label;   ///< beside the carets: "did you mean `radius`?"; may be empty
  std::vector<Note> notes;
  std::vector<Note> call_stack; ///< innermost first
};

Diagnostic make_error(std::string_view code, Span place, std::string message, std::string label = {},
                      std::vector<Note> notes = {});

/// As shown to users: the place, the line with carets, the notes. `use_color` adds terminal colours.
std::string render(const Diagnostic& diagnostic, const SourceMap& sources, bool use_color);
/// The place and the message on one line: "ball.rtl:3:1: 0.5".
std::string render_line(const Diagnostic& diagnostic, const SourceMap& sources);
/// As one JSON array, for machines.
std::string render_json(const std::vector<Diagnostic>& diagnostics, const SourceMap& sources);

/// An entry of the registry of codes: one row of a table in `lang/diagnostics/codes/`.
struct Code {
  std::string_view code;    ///< "E0204"
  std::string_view title;   ///< a few words, no full stop
  std::string_view meaning; ///< a paragraph or two: what is wrong, why it is a mistake, what to do
  std::string_view example; ///< a scene that triggers it; empty if no scene's text alone can
  std::string_view mended;  ///< the same scene, corrected
};
/// All groups, in order.
std::vector<Code> all_codes();
std::optional<Code> find_code(std::string_view code);
/// What `rtlang explain` prints.
std::string explain(const Code& code);

} // namespace rt::lang
