#pragma once

#include "lang/builtins/builtins.hpp"
#include "lang/check/check.hpp"

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace rt::lang {

/// What is known of a value without running anything.
struct StaticType {
  enum class What : std::uint8_t { nothing, thing, function, builtin, module } what = What::nothing;
  const NodeType* type = nullptr;         ///< of a thing; a def's is `group`
  const FunctionInfo* function = nullptr; ///< of a function; of a thing that a def makes: the def
  const Builtin* builtin = nullptr;
  const ModuleInfo* module = nullptr;
  bool is_bare_noun = false; ///< the name of a noun or def itself: no property is written yet

  bool is_thing() const { return what == What::thing; }
};

/// The thing whose block is being read, which properties there belong to.
struct Owner {
  const NodeType* type = nullptr;    ///< null where no property is expected
  const FunctionInfo* def = nullptr; ///< whose parameters come first
  bool is_unknown = false;           ///< some thing, known only when the program runs
  bool is_def_body = false;          ///< the inside of a `def`, where properties are defaults
};

/// What a name at the top of a file or session stands for.
enum class Meaning : std::uint8_t { value, function, module, error };

/// A name that a statement of a session has declared.
struct TopName {
  Meaning meaning = Meaning::value;
  Symbol name;
  Span span;
  std::uint32_t slot = 0; ///< or index of the function
  StaticType known;
};

/// A statement of a session as check sees it: to be checked, or checked before.
struct TopItem {
  Unit* unit = nullptr;        ///< null: it was checked before, and only its names matter
  std::vector<NodeId> nodes;   ///< its items: one, or things that were written one after the other
  std::vector<TopName> names;  ///< that it declares: given, or found
  std::vector<Symbol> uses;    ///< found: names of other statements, also of its own functions
  std::vector<Symbol> globals; ///< found: names that no statement declares
};

/// The pass itself, for one file and those it includes: a file that `use` names has a checker of its own.
class Checker {
public:
  Checker(Program& program, Files& files, Report& report, std::vector<std::string>& open_files);

  void check_library();
  void check_define(Define& define);
  void check_main();
  void check_module(ModuleInfo& module);
  /// The statements of a session, in order. `slots` says how many of the session's frame are taken already, and then
  /// how many are. Names of statements that are not among them are known all the same, as far as suggestions go:
  /// `add_further_names`.
  using AddNames = std::function<void(std::vector<std::string_view>&)>;
  void check_session(std::span<TopItem> items, std::uint32_t& slots, const AddNames& add_further_names);

private:
  /// A call's worth of slots.
  struct Activation {
    std::uint32_t level = 0;
    std::uint32_t slots = 0;
  };
  struct Binding {
    using What = Meaning;
    What what = What::value;
    Symbol name;
    Span span;
    std::uint32_t scope = 0;
    std::uint32_t level = 0;
    std::uint32_t slot = 0; ///< or index of the function
    std::uint32_t shadowed = none;
    std::uint32_t reads = 0;
    StaticType known;
    std::uint32_t use = NameUses::none; ///< its number there, for the lint
    int pi_power = 0;                   ///< of its value, for the lint
    bool may_be_property = false;       ///< bound with `=` in a block whose thing has a property of that name
  };
  struct Scope {
    std::uint32_t first_binding = 0;
    const Unit* unit = nullptr;
    NodeId block = no_node;
    Owner owner;
  };
  static constexpr std::uint32_t none = 0xffffffff;
  static constexpr std::uint32_t most_loop_slots = 0xffff;

  // Scopes and names (check_scopes.cpp)
  void open_scope(const Unit* unit, NodeId block, const Owner& owner);
  void close_scope();
  Binding* declare(Unit& unit, NodeId name, Binding::What what);
  Binding* declare(Symbol name, Span span, Binding::What what);
  Binding* find(Symbol name);
  std::uint32_t level() const { return activations_.back().level; }
  std::uint32_t new_slot() { return activations_.back().slots++; }
  void begin_activation() { activations_.push_back({static_cast<std::uint32_t>(activations_.size()), 0}); }
  std::uint32_t end_activation();
  void declare_library();
  void report_masked_property(const Binding& binding, const Owner& owner);
  StaticType resolve(Unit& unit, NodeId name);
  StaticType resolve_global(Unit& unit, NodeId name);
  void report_unknown_name(const Unit& unit, NodeId name);
  std::vector<std::string_view> visible_names() const;

  // Items (check_items.cpp)
  void check_items(Unit& unit, NodeId block);
  void hoist(Unit& unit, NodeId block);
  void hoist_item(Unit& unit, NodeId item);
  void hoist_function(Unit& unit, NodeId item);
  void check_item(Unit& unit, NodeId item);
  void check_block(Unit& unit, NodeId block, const Owner& owner);
  void check_function_body(Unit& unit, NodeId node);
  void check_include(Unit& unit, NodeId item);
  void check_repeat(Unit& unit, const Repeat& repeat);
  void check_use(Unit& unit, NodeId item);
  const ModuleInfo* load_module(Unit& unit, NodeId item);
  void check_param(Unit& unit, NodeId item);
  void check_bind(Unit& unit, NodeId item);
  void check_for(Unit& unit, NodeId item);
  void set_loop_frame(Unit& unit, NodeId node);
  void check_if_item(Unit& unit, NodeId item);
  void check_expect(Unit& unit, NodeId item);
  void check_property(Unit& unit, NodeId item);
  void add_parameters(Unit& unit, FunctionInfo& info);
  // Sessions (check_session.cpp)
  void declare_known(const TopItem& item, bool functions);
  void take_names(TopItem& item, std::size_t first);
  void note_use(Symbol symbol, const Binding* binding);
  bool is_query(const Unit& unit, NodeId node) const;
  bool is_at_top_level() const { return scopes_.size() == top_scope_ + 1; }

  // Expressions (check_expressions.cpp)
  StaticType check_expression(Unit& unit, NodeId node);
  StaticType check_if_value(Unit& unit, NodeId node);
  void check_value_block(Unit& unit, NodeId block, std::string_view what);
  StaticType check_lambda(Unit& unit, NodeId node);
  StaticType check_call(Unit& unit, NodeId node);
  StaticType check_callee(Unit& unit, NodeId callee);
  void check_function_call(Unit& unit, NodeId node, const FunctionInfo& function);
  void check_signature_call(Unit& unit, NodeId node, std::string_view name, const Signature& signature);
  void check_thing_call(Unit& unit, NodeId node, const StaticType& callee);
  StaticType check_member(Unit& unit, NodeId node, bool is_called);
  StaticType check_override(Unit& unit, NodeId node);
  void check_comprehension(Unit& unit, NodeId node);
  void check_record(Unit& unit, NodeId node);
  StaticType check_binary(Unit& unit, NodeId node);
  bool is_simple(const Unit& unit, NodeId block, const NodeType& type) const;
  bool has_closure(const Unit& unit, NodeId node) const;

  // Properties (check_properties.cpp)
  void check_property_name(Unit& unit, NodeId item, const Owner& owner);
  void report_unknown_property(const Unit& unit, NodeId item, const Owner& owner);
  void report_duplicates(const Unit& unit, NodeId block, const Owner& owner);
  std::string list_properties(const Owner& owner) const;

  // For the lint (check_lint.cpp)
  bool is_exported(const Unit& unit) const;
  bool places_nothing(const Unit& unit) const;
  std::uint32_t declare_use(const Unit& unit, NodeId name_node, NameUses::What what);
  void begin_use(std::uint32_t use);
  void end_use(std::uint32_t use);
  void settle_use(std::uint32_t use, const StaticType& known);
  int pi_power(const Unit& unit, NodeId node);
  void check_angle(const Unit& unit, NodeId node);
  void check_angle_property(const Unit& unit, NodeId item, const Property& property);
  void check_angle_arguments(const Unit& unit, NodeId node, const Signature& signature, bool is_rotation);

  std::string_view name(Symbol symbol) const { return program_.symbols.name(symbol); }
  std::uint32_t line(Span span) const { return program_.sources.position(span.file, span.begin).line; }

  Program& program_;
  Files& files_;
  Report& report_;
  std::vector<std::string>& open_files_; // canonical paths of the files being read, to find cycles
  std::vector<Activation> activations_;
  std::vector<Scope> scopes_;
  std::vector<Binding> bindings_;
  std::vector<std::uint32_t> innermost_; // by symbol: the visible binding of that name
  std::size_t top_scope_ = 0;            // index of the file's own scope
  Symbol being_bound_ = no_symbol;       // the name on the left of the `=` whose right side is being read
  bool names_are_missing_ = false;       // a file could not be read: names that are not found may have stood there
  bool is_in_lambda_ = false;            // which is the right side of that `=`
  bool is_in_expect_ = false;            // where the questions are known
  bool is_main_ = false;
  std::vector<std::pair<const Unit*, NodeId>> wrong_models_; // of repeats
  bool is_library_ = false;                                  // the scene places nothing: it is for others to use
  bool reads_part_ = false;                                  // the name that is looked up next stands before a dot
  bool is_define_ = false;
  const AddNames* add_further_names_ = nullptr;
  TopItem* top_item_ = nullptr;        // in a session: the statement being read
  const ModuleInfo* module_ = nullptr; // the used file that is read, null for the scene itself
};

} // namespace rt::lang
