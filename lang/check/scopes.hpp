#pragma once

#include "lang/check/context.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace rt::lang {

/// What a visible name stands for. `error`: the line that declares it is in error, and nothing more is said.
enum class Meaning : std::uint8_t { value, function, module, error };

/// A name that is known where check stands.
struct Binding {
  Meaning meaning = Meaning::value;
  Symbol name;
  Span span;
  std::uint32_t scope = 0;    ///< how many scopes were open, with its own
  std::uint32_t level = 0;    ///< of the activation that holds it
  std::uint32_t slot = 0;     ///< or index of the function
  std::uint32_t shadowed = 0; ///< position of the binding of the same name that it hides
  std::uint32_t reads = 0;
  StaticType known;
  DeclarationId declaration = no_declaration;
  bool may_be_property = false; ///< bound with `=` in a block whose thing has a property of that name
};

/// A block, or a function's parameters.
struct Scope {
  std::uint32_t first_binding = 0;
  const Unit* unit = nullptr; ///< null for the scope of the library
  NodeId block = no_node;
  Owner owner;
};

/// The scopes that are open where check stands, and the slots of the frames that their names will live in.
class Scopes {
public:
  explicit Scopes(CheckContext& context) : context_(context) {}

  void open(const Unit* unit, NodeId block, const Owner& owner);
  void close();
  /// The scope that is open now is the file's own.
  void mark_top_level() { top_ = scopes_.size(); }
  bool is_at_top_level() const { return scopes_.size() == top_; }
  bool is_top_level(const Binding& binding) const { return binding.scope == top_; }
  bool is_outside_file(const Binding& binding) const { return binding.scope < top_; }
  const Owner& owner() const { return scopes_.back().owner; }
  /// Innermost last.
  std::span<const Scope> all() const { return scopes_; }
  Scope& innermost() { return scopes_.back(); }

  /// A frame of its own, as a call has; it ends with the number of its slots.
  void begin_activation() { activations_.push_back({}); }
  std::uint32_t end_activation();
  /// So many slots of the frame are taken already.
  void take_slots(std::uint32_t count) { activations_.back().slots = count; }
  std::size_t activations() const { return activations_.size(); }

  /// A name of the innermost scope, until it is closed. A second one of that name is reported.
  Binding& declare(Symbol name, Span span, Meaning meaning);
  /// The same for a name node, which learns its slot unless it is a function's.
  Binding& declare(Unit& unit, NodeId name, Meaning meaning);
  /// What the name stands for, or null.
  Binding* find(Symbol name);
  std::size_t frames_out(const Binding& binding) const { return activations_.size() - 1 - binding.level; }
  /// All that are known, and from the innermost scope those from `first` on.
  std::span<Binding> bindings(std::size_t first = 0) { return std::span(bindings_).subspan(first); }

private:
  /// A call's worth of slots.
  struct Activation {
    std::uint32_t slots = 0;
  };
  static constexpr std::uint32_t none = 0xffffffff;

  CheckContext& context_;
  std::vector<Activation> activations_;
  std::vector<Scope> scopes_;
  std::vector<Binding> bindings_;
  std::vector<std::uint32_t> innermost_; // by symbol: the visible binding of that name
  std::size_t top_ = 0;                  // number of scopes open where a file's own is the innermost
};

/// Whether a function stands in the node, which may outlive a turn of a loop.
bool has_closure(const Ast& ast, NodeId node);
/// Ends the activation of a loop's turns, and writes into the node how many slots one takes.
void end_loop_frame(CheckContext& context, Scopes& scopes, Unit& unit, NodeId loop);

} // namespace rt::lang
