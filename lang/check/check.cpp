#include "lang/check/check.hpp"

#include "lang/check/items.hpp"

namespace rt::lang {
namespace {

/// The pass over one file and those that it includes; a file named by `use` has a pass of its own.
class FilePass {
public:
  FilePass(Program& program, Files& files, Report& report, std::vector<std::string>& open_files,
           const ModuleInfo* module = nullptr)
      : context_{program, files, report, open_files, module}, scopes_(context_), names_(context_, scopes_),
        items_(context_, scopes_, names_) {}

  void check_library();
  void check_define(Define& define);
  void check_main();
  void check_module(ModuleInfo& module);
  void check_session(std::span<TopItem> items, std::uint32_t& slots);
  NameResolver& names() { return names_; }

private:
  void declare_library();
  void open_file(const Unit* unit);
  std::size_t enter(TopItem& item);
  void declare_known(const TopItem& item, bool functions);
  void take_names(TopItem& item, std::size_t first);

  CheckContext context_;
  Scopes scopes_;
  NameResolver names_;
  ItemChecker items_;
};

void FilePass::check_library() {
  Program& program = context_.program;
  scopes_.begin_activation();
  scopes_.open(nullptr, no_node, {});
  scopes_.mark_top_level();
  items_.check_all(*program.library, program.library->ast.root);
  for (const Binding& binding : scopes_.bindings())
    program.library_names.push_back({binding.name, binding.slot, binding.span, binding.declaration});
  scopes_.close();
  program.library_frame_size = scopes_.end_activation();
}

// The library's names are in a scope around each file.
void FilePass::declare_library() {
  scopes_.begin_activation();
  scopes_.open(nullptr, no_node, {});
  for (const Program::LibraryName& entry : context_.program.library_names) {
    Binding& binding = scopes_.declare(entry.name, entry.span, Meaning::value);
    binding.slot = entry.slot;
    binding.known.what = StaticType::What::thing;
    binding.known.type = &context_.program.types.material();
    binding.declaration = entry.declaration;
  }
}

void FilePass::open_file(const Unit* unit) {
  declare_library();
  scopes_.begin_activation();
  Owner owner;
  owner.type = &context_.program.types.scene();
  scopes_.open(unit, unit ? unit->ast.root : no_node, owner);
  scopes_.mark_top_level();
}

void FilePass::check_define(Define& define) {
  names_.set_in_define();
  declare_library();
  scopes_.begin_activation();
  items_.check_value(*define.unit, define.unit->ast.root);
  define.frame_size = scopes_.end_activation();
  scopes_.close();
}

void FilePass::check_main() {
  Unit& unit = *context_.program.main;
  const std::string& path = context_.program.sources.file(unit.ast.file).path;
  if (!path.empty()) context_.open_files.push_back(path);
  open_file(&unit);
  items_.check_all(unit, unit.ast.root);
  scopes_.close();
  context_.program.main_frame_size = scopes_.end_activation();
  scopes_.close();
}

void FilePass::check_module(ModuleInfo& module) {
  open_file(module.unit);
  items_.check_all(*module.unit, module.unit->ast.root);
  for (Binding& binding : scopes_.bindings(scopes_.innermost().first_binding)) {
    ++binding.reads; // other files may read the module's names
    if (binding.meaning == Meaning::error) continue;
    const FunctionInfo* function =
        binding.meaning == Meaning::function ? &context_.program.functions[binding.slot] : nullptr;
    module.exports.push_back({binding.name, binding.slot, function, binding.known.type, binding.declaration});
  }
  scopes_.close();
  module.frame_size = scopes_.end_activation();
  scopes_.close();
}

// Functions are visible throughout, so all of them are declared first; values are visible from their statement on.
void FilePass::check_session(std::span<TopItem> items, std::uint32_t& slots) {
  open_file(nullptr);
  scopes_.take_slots(slots);
  for (TopItem& item : items) {
    if (!item.unit) {
      declare_known(item, true);
      continue;
    }
    const std::size_t first = enter(item);
    for (const NodeId node : item.nodes) items_.hoist(*item.unit, node);
    take_names(item, first);
  }
  for (TopItem& item : items) {
    if (!item.unit) {
      declare_known(item, false);
      continue;
    }
    const std::size_t first = enter(item);
    for (const NodeId node : item.nodes) items_.check(*item.unit, node);
    take_names(item, first);
  }
  names_.set_statement(nullptr);
  scopes_.close();
  slots = scopes_.end_activation();
  scopes_.close();
}

std::size_t FilePass::enter(TopItem& item) {
  names_.set_statement(&item);
  scopes_.innermost().unit = item.unit;
  scopes_.innermost().block = item.unit->ast.root;
  return scopes_.bindings().size();
}

void FilePass::declare_known(const TopItem& item, bool functions) {
  for (const TopName& name : item.names) {
    if ((name.meaning == Meaning::function) != functions) continue;
    Binding& binding = scopes_.declare(name.name, name.span, name.meaning);
    binding.slot = name.slot;
    binding.known = name.known;
  }
}

void FilePass::take_names(TopItem& item, std::size_t first) {
  for (const Binding& binding : scopes_.bindings(first))
    item.names.push_back({binding.meaning, binding.name, binding.span, binding.slot, binding.known});
}

} // namespace

void check_library(Program& program, Files& files, Report& report) {
  std::vector<std::string> open_files;
  FilePass(program, files, report, open_files).check_library();
  for (Define& define : program.defines) FilePass(program, files, report, open_files).check_define(define);
}

void check(Program& program, Files& files, Report& report) {
  check_library(program, files, report);
  std::vector<std::string> open_files;
  FilePass(program, files, report, open_files).check_main();
  program.references.finish();
}

void check_module(ModuleInfo& module, Program& program, Files& files, Report& report,
                  std::vector<std::string>& open_files) {
  FilePass(program, files, report, open_files, &module).check_module(module);
}

void check_session(std::span<TopItem> items, std::uint32_t& slots, const NameResolver::AddNames& add_further_names,
                   Program& program, Files& files, Report& report) {
  std::vector<std::string> open_files;
  FilePass pass(program, files, report, open_files);
  pass.names().set_further_names(add_further_names);
  pass.check_session(items, slots);
}

} // namespace rt::lang
