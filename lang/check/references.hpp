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

/// A name that a text declares.
struct Declaration {
  enum class What : std::uint8_t {
    value, ///< bound with `=`
    def,
    fn,
    param,
    parameter, ///< of a def or fn
    local,     ///< a loop's variable, or a parameter of a function without a name
    module,    ///< `use … as name`
    unknown,   ///< its line is in error
  };
  What what = What::value;
  Symbol symbol = no_symbol;
  Span span;                  ///< of the name
  const Unit* unit = nullptr; ///< null where it is a session's earlier statement
  NodeId item = no_node;      ///< the bind, param, def, fn, use, parameter or loop
  bool is_at_top_level = false;
  DeclarationId inside = no_declaration; ///< in whose right side or body it stands
  StaticType known = {};                 ///< of its value
};

/// A word that only one property or parameter takes: `linear`.
struct Choice {
  std::string_view word;
  friend bool operator==(const Choice&, const Choice&) = default;
};

/// A name of CSS for a colour, 0xrrggbb.
struct ColorName {
  std::string_view word;
  std::uint32_t rgb = 0;
  friend bool operator==(const ColorName&, const ColorName&) = default;
};

/// What a name stands for.
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
  DeclarationId inside = no_declaration; ///< in whose right side or body it stands
};

/// What each name of a program refers to. Filled by check where it is wanted: it costs time and memory.
class References {
public:
  void keep() { is_kept_ = true; }
  bool is_kept() const { return is_kept_; }

  /// A name that stands in what is being read. `no_declaration` where references are not kept.
  DeclarationId declare(Declaration declaration);
  /// What is read from now on, until `end`, is the right side or body of this declaration.
  void begin(DeclarationId declaration);
  void end(DeclarationId declaration);
  void set_known(DeclarationId declaration, const StaticType& known);
  void add(Span span, Referent referent, Reference::Use use = Reference::Use::reads) {
    if (is_kept_) references_.push_back({span, referent, use, inside()});
  }
  /// To be called once all is read, before anything is asked.
  void finish();

  std::span<const Declaration> declarations() const { return declarations_; }
  const Declaration& operator[](DeclarationId id) const { return declarations_[static_cast<std::uint32_t>(id)]; }
  /// All of them, by place.
  std::span<const Reference> all() const { return references_; }
  /// The name that stands exactly there.
  const Reference* find(Span span) const;
  /// The name that holds the place or ends there; the one that begins there comes first.
  const Reference* at(FileId file, std::uint32_t offset) const;

private:
  DeclarationId inside() const { return open_.empty() ? no_declaration : open_.back(); }

  bool is_kept_ = false;
  std::vector<Declaration> declarations_;
  std::vector<Reference> references_;
  std::vector<DeclarationId> open_;
};

} // namespace rt::lang
