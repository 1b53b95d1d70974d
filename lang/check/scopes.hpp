#pragma once

#include "lang/check/context.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace rt::lang {

/// What a visible name refers to. `error`: the line that declares it is in error, and nothing more is reported.
enum class Meaning : std::uint8_t { value, function, module, error };

/// A name visible at the current point.
struct Binding {
  Meaning meaning = Meaning::value;
  Symbol name;
  Span span;
  std::uint32_t scope = 0;    ///< how many scopes were open, including its own
  std::uint32_t level = 0;    ///< of the activation that contains it
  std::uint32_t slot = 0;     ///< or index of the function
  std::uint32_t shadowed = 0; ///< index of the binding of the same name that it shadows
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

/// The scopes open at the current point, and the slots of the frames that will hold their names.
class Scopes {
public:
  explicit Scopes(CheckContext& context) : context_(context) {}

  void open(const Unit* unit, NodeId block, const Owner& owner);
  void close();
  /// The current scope is the file's own.
  void mark_top_level() { top_ = scopes_.size(); }
  bool is_at_top_level() const { return scopes_.size() == top_; }
  bool is_top_level(const Binding& binding) const { return binding.scope == top_; }
  bool is_outside_file(const Binding& binding) const { return binding.scope < top_; }
  const Owner& owner() const { return scopes_.back().owner; }
  /// Innermost last.
  std::span<const Scope> all() const { return scopes_; }
  Scope& innermost() { return scopes_.back(); }

  /// A new frame, as for a call; it ends with the number of its slots.
  void begin_activation() { activations_.push_back({}); }
  std::uint32_t end_activation();
  /// This many slots of the frame are already taken.
  void take_slots(std::uint32_t count) { activations_.back().slots = count; }
  std::size_t activations() const { return activations_.size(); }

  /// Adds a name to the innermost scope, until it is closed. A duplicate is reported.
  Binding& declare(Symbol name, Span span, Meaning meaning);
  /// The same for a name node, which receives its slot unless it is a function's.
  Binding& declare(Unit& unit, NodeId name, Meaning meaning);
  /// What the name refers to, or null.
  Binding* find(Symbol name);
  std::size_t frames_out(const Binding& binding) const { return activations_.size() - 1 - binding.level; }
  /// All that are visible, and from the innermost scope those from `first` on.
  std::span<Binding> bindings(std::size_t first = 0) { return std::span(bindings_).subspan(first); }

private:
  /// The slots of one frame.
  struct Activation {
    std::uint32_t slots = 0;
  };
  static constexpr std::uint32_t none = 0xffffffff;

  CheckContext& context_;
  std::vector<Activation> activations_;
  std::vector<Scope> scopes_;
  std::vector<Binding> bindings_;
  std::vector<std::uint32_t> innermost_; // by symbol: the visible binding of that name
  std::size_t top_ = 0;                  // number of open scopes when a file's own is the innermost
};

/// Whether the node contains a function, which may outlive a loop iteration.
bool has_closure(const Ast& ast, NodeId node);
/// Ends the activation of a loop body, and stores in the node how many slots an iteration takes.
void end_loop_frame(CheckContext& context, Scopes& scopes, Unit& unit, NodeId loop);

} // namespace rt::lang
