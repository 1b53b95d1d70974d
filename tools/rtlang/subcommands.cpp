#include "tools/rtlang/commands.hpp"
#include "tools/rtlang/subcommand.hpp"

namespace rt::tools {

std::span<const Subcommand> subcommands() {
  static constexpr Subcommand table[] = {
      {"render", "SCENE [-o PICTURE]... [OPTIONS]", "renders a picture (the command name may be omitted)",
       declare_render},
      {"merge", "PARTS... -o PICTURE", "combines the parts of a picture (see --part)", declare_merge},
      {"view", "SCENE [OPTIONS]", "shows a picture in a window, and reloads the file when it changes", declare_view},
      {"ast", "SCENE", "prints the syntax tree", declare_ast},
      {"scene", "SCENE [OPTIONS]", "prints the scene description as JSON", declare_scene},
      {"export", "SCENE [-o FILE] [OPTIONS]", "exports the scene to POV-Ray 3.7", declare_export},
      {"convert", "FILE [-o SCENE]", "converts another program's scene (miniRT .rt) to rtlang", declare_convert},
      {"check", "SCENE [OPTIONS]", "compares the picture with POV-Ray's, pixel by pixel", declare_check},
      {"diff", "A B [-o PICTURE] [OPTIONS]", "measures the difference between two pictures", declare_diff},
      {"probe", "SCENE --pixel X,Y [OPTIONS]", "shows what a ray hits: object, distance, normal, material",
       declare_probe},
      {"why", "SCENE --pixel X,Y [OPTIONS]", "explains a pixel's colour: rays, roots, shading terms", declare_why},
      {"lint", "SCENE [OPTIONS]", "warns about likely mistakes in a valid scene", declare_lint},
      {"test", "SCENES... [OPTIONS]", "checks the `expect` statements of scenes", declare_test},
      {"fmt", "FILES... [--check]", "formats scenes in the standard style", declare_fmt},
      {"doc", "[NAME]", "explains a thing, property or function of the language", declare_doc},
      {"repl", "[SCENE] [--keep-going]", "builds a scene interactively (the default without arguments)", declare_repl},
      {"lsp", "[OPTIONS]", "language server: errors as you type, completion, definitions", declare_lsp},
      {"explain", "[CODE]", "explains an error code, or lists all of them", declare_explain},
  };
  return table;
}

const Subcommand* find_subcommand(std::string_view name) {
  for (const Subcommand& subcommand : subcommands())
    if (subcommand.name == name) return &subcommand;
  return nullptr;
}

} // namespace rt::tools
