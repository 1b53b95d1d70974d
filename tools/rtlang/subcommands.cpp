#include "tools/rtlang/commands.hpp"
#include "tools/rtlang/subcommand.hpp"

namespace rt::tools {

std::span<const Subcommand> subcommands() {
  static constexpr Subcommand table[] = {
      {"render", "SCENE [-o PICTURE]... [OPTIONS]", "makes a picture (the command's name may be left out)",
       declare_render},
      {"ast", "SCENE", "prints the syntax tree", declare_ast},
      {"scene", "SCENE [OPTIONS]", "prints the scene's description as JSON", declare_scene},
      {"export", "SCENE [-o FILE] [OPTIONS]", "writes the scene for POV-Ray 3.7", declare_export},
      {"check", "SCENE [OPTIONS]", "compares the picture with POV-Ray's, pixel by pixel", declare_check},
      {"diff", "A B [-o PICTURE] [OPTIONS]", "measures how far two pictures are apart", declare_diff},
      {"probe", "SCENE --pixel X,Y [OPTIONS]", "tells what a ray meets: object, distance, normal, material",
       declare_probe},
      {"why", "SCENE --pixel X,Y [OPTIONS]", "tells why it has its colour: rays, roots, terms, one sentence",
       declare_why},
      {"lint", "SCENE [OPTIONS]", "warns of what is well formed and hardly meant", declare_lint},
      {"test", "SCENES... [OPTIONS]", "tries what the scenes expect of themselves", declare_test},
      {"fmt", "FILES... [--check]", "rewrites scenes in the house's layout", declare_fmt},
      {"doc", "[NAME]", "explains a thing, property or function of the language", declare_doc},
      {"repl", "[SCENE] [--keep-going]", "builds a scene line by line (what runs without any arguments)", declare_repl},
      {"explain", "[CODE]", "explains an error's code, or lists all codes", declare_explain},
  };
  return table;
}

const Subcommand* find_subcommand(std::string_view name) {
  for (const Subcommand& subcommand : subcommands())
    if (subcommand.name == name) return &subcommand;
  return nullptr;
}

} // namespace rt::tools
