#pragma once

#include "lang/check/static_type.hpp"
#include "lang/syntax/ast.hpp"

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <variant>
#include <vector>

namespace rt::lang {

struct Unit;

/// Index of a declaration in `References`.
enum class DeclarationId : std::uint32_t {};
inline constexpr DeclarationId no_declaration{0xffffffff};

/// A name declared by a text.
struct Declaration {
  enum class What : std::uint8_t {
    value, ///< bound with `=`
    def,
    fn,
    param,
    parameter, ///< of a def or fn
    local,     ///< a loop variable, or a parameter of an anonymous function
    module,    ///< `use … as name`
    unknown,   ///< its line is in error
  };
  What what = What::value;
  Symbol symbol = no_symbol;
  Span span;                  ///< of the name
  const Unit* unit = nullptr; ///< null for an earlier statement of a session
  NodeId item = no_node;      ///< the bind, param, def, fn, use, parameter or loop
  bool is_at_top_level = false;
  DeclarationId inside = no_declaration; ///< whose right side or body contains it
  StaticType known = {};                 ///< of its value
};

/// A word that only one property or parameter takes: `linear`.
struct Choice {
  std::string_view word;
  friend bool operator==(const Choice&, const Choice&) = default;
};

/// A CSS colour name, 0xrrggbb.
struct ColorName {
  std::string_view word;
  std::uint32_t rgb = 0;
  friend bool operator==(const ColorName&, const ColorName&) = default;
};

/// What a name refers to.
using Referent = std::variant<DeclarationId, FileId, const NodeType*, const Property*, const Builtin*,
                              const SignatureParameter*, const ChainMethod*, const Constant*, ColorName, Choice>;

/// A name in a text.
struct Reference {
  enum class Use : std::uint8_t {
    declares,
    reads,
    reads_part, ///< one property of the value, or one name of the file
    sets,       ///< a property or an argument
    names_file,
  };
  Span span;
  Referent referent;
  Use use = Use::reads;
  DeclarationId inside = no_declaration; ///< whose right side or body contains it
};

/// What each name of a program refers to. Filled by check only if requested: it costs time and memory.
class References {
public:
  void keep() { is_kept_ = true; }
  bool is_kept() const { return is_kept_; }

  /// A name declared in what is being read. `no_declaration` if references are not kept.
  DeclarationId declare(Declaration declaration);
  /// What is read from now on, until `end`, is the right side or body of this declaration.
  void begin(DeclarationId declaration);
  void end(DeclarationId declaration);
  void set_known(DeclarationId declaration, const StaticType& known);
  void add(Span span, Referent referent, Reference::Use use = Reference::Use::reads) {
    if (is_kept_) references_.push_back({span, referent, use, inside()});
  }
  /// To be called after everything is read, before any query.
  void finish();

  std::span<const Declaration> declarations() const { return declarations_; }
  const Declaration& operator[](DeclarationId id) const { return declarations_[static_cast<std::uint32_t>(id)]; }
  /// All of them, by place.
  std::span<const Reference> all() const { return references_; }
  /// The name with exactly this span.
  const Reference* find(Span span) const;
  /// The name that contains the place or ends there; one that begins there has priority.
  const Reference* at(FileId file, std::uint32_t offset) const;

private:
  DeclarationId inside() const { return open_.empty() ? no_declaration : open_.back(); }

  bool is_kept_ = false;
  std::vector<Declaration> declarations_;
  std::vector<Reference> references_;
  std::vector<DeclarationId> open_;
};

} // namespace rt::lang
