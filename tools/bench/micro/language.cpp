#include "lang/load.hpp"
#include "lang/syntax/parse.hpp"
#include "tools/bench/scenes/layout.hpp"

#include <benchmark/benchmark.h>

#include <stdexcept>

// From text to scene description.
namespace {

using namespace rt;
using namespace rt::tools::bench;

void parse_text(benchmark::State& state, const std::string& text, bool folds_repeats) {
  lang::SourceMap sources;
  const lang::FileId file = sources.add("scene", "", text);
  for (auto _ : state) {
    lang::SymbolTable symbols;
    lang::ParseOptions options;
    options.folds_repeats = folds_repeats;
    const lang::Parsed parsed = lang::parse(sources, file, symbols, options);
    if (!parsed.diagnostics.empty()) throw std::runtime_error("the text has errors");
    benchmark::DoNotOptimize(parsed.ast.nodes.data());
  }
  state.SetBytesProcessed(state.iterations() * static_cast<std::int64_t>(text.size()));
}

void parse_literal(benchmark::State& state) {
  parse_text(state, write(make_layout("rings"), Format::rtl), true);
}
BENCHMARK(parse_literal)->Unit(benchmark::kMillisecond);

void parse_unfolded(benchmark::State& state) {
  parse_text(state, write(make_layout("rings"), Format::rtl), false);
}
BENCHMARK(parse_unfolded)->Unit(benchmark::kMillisecond);

void load(benchmark::State& state, const std::string& text, std::int64_t items) {
  for (auto _ : state) {
    const lang::Loaded loaded = lang::load_text(text, "scene", ".", {});
    if (!loaded.scene) throw std::runtime_error("the text has errors");
    benchmark::DoNotOptimize(loaded.scene->objects.data());
  }
  state.SetItemsProcessed(state.iterations() * items);
}

void evaluate_loop(benchmark::State& state) {
  load(state, "for i in 0..<100000 { sphere { at: [i, 2 * i, sin(i)], radius: 0.3 } }\n", 100'000);
}
BENCHMARK(evaluate_loop)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime();

void evaluate_calls(benchmark::State& state) {
  load(state, "fn fib(n) = if n < 2 { n } else { fib(n - 1) + fib(n - 2) }\nx = fib(20)\nsphere { radius: x }\n",
       21'891);
}
BENCHMARK(evaluate_calls)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime();

} // namespace
