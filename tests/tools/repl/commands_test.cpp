#include "tools/repl/commands.hpp"

#include <catch2/catch.hpp>

TEST_CASE("commands: unambiguous beginnings suffice") {
  using rt::tools::choose_command;
  const auto commands = rt::tools::shell_commands();
  CHECK(choose_command("hist", commands).command->name == "history");
  CHECK(choose_command("q", commands).command->name == "quit");
  CHECK(choose_command("re", commands).problem == "`:re` could be :render, :remove, :redo, :reset, :recover");
  CHECK(choose_command("sohw", commands).problem == "unknown command `:sohw`; did you mean `:show`?");
}
