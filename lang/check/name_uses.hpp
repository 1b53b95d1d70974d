#pragma once

#include "lang/text/source.hpp"
#include "lang/text/symbol.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace rt::lang {

class Report;

/// Which names read which: what nobody needs is found once all is read. Kept for the lint only.
class NameUses {
public:
  static constexpr std::uint32_t none = 0xffffffff;

  enum class What : std::uint8_t {
    value,
    thing,    ///< what can be placed
    material, ///< or a pattern
    def,
    fn,
    param,
    parameter, ///< of a def or fn
    module,
  };

  struct Name {
    What what = What::value;
    Symbol symbol = no_symbol;
    Span span;
    bool is_exported = false;    ///< other files may read it, or the reader shall not be told
    std::uint32_t reader = none; ///< whose right side or body it stands in
    bool is_read = false;
    bool is_read_whole = false; ///< not only a property of it
    std::vector<std::uint32_t> reads = {};
  };

  /// A name that stands in what is being read; its number.
  std::uint32_t declare(What what, Symbol symbol, Span span, bool is_exported);
  /// What is read from now on, until `end`, is read for this name's sake.
  void begin(std::uint32_t name) { readers_.push_back(name); }
  void end() { readers_.pop_back(); }
  void set_what(std::uint32_t name, What what) { names_[name].what = what; }
  /// `part`: of a thing, one of its properties.
  void read(std::uint32_t name, bool part);

  /// A warning for each name that leads to nothing in the scene, unless that follows from another one's.
  void tell(Report& report, const SymbolTable& symbols) const;

private:
  std::vector<bool> needed() const;
  void mark(std::uint32_t name, std::vector<bool>& marked) const;
  void tell_unused(const Name& name, Report& report, const SymbolTable& symbols) const;
  void tell_parts_only(const Name& name, Report& report, const SymbolTable& symbols) const;

  std::vector<Name> names_;
  std::vector<std::uint32_t> readers_;
  std::vector<std::uint32_t> roots_; // what the scene itself reads
};

} // namespace rt::lang
