#include "tools/explain/why/why.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace rt::tools::explain {

std::string way_text(const Namer& namer, const Sum& sum, std::uint32_t last_step) {
  std::string text, last;
  std::vector<WayStep> way = sum.way(last_step);
  std::reverse(way.begin(), way.end());
  for (const WayStep& step : way) {
    const std::string title = namer.title(step.at->path);
    const std::string part = step.how == WayStep::How::mirrored ? fmt::format("mirrored in {}", title)
                             : step.how == WayStep::How::totally_reflected
                                 ? fmt::format("total internal reflection in {}", title)
                                 : fmt::format("through {}", title);
    if (part != last) text += ", " + part;
    last = part;
  }
  return text;
}

namespace {

std::string term_text(const Answer& answer, const Contribution& term) {
  const std::string where = term.surface ? answer.namer.title(term.surface->path) : "";
  std::string text;
  switch (term.kind) {
  case Contribution::Kind::ambient:
    text = fmt::format("ambient light on {}", where);
    break;
  case Contribution::Kind::emission:
    text = fmt::format("emission of {}", where);
    break;
  case Contribution::Kind::diffuse:
    text = fmt::format("{} on {}", answer.namer.light(term.light), where);
    break;
  case Contribution::Kind::highlight:
    text = fmt::format("highlight of {} on {}", answer.namer.light(term.light), where);
    break;
  case Contribution::Kind::background:
    text = "the background";
    break;
  case Contribution::Kind::estimate:
    text = "estimates for weak rays";
    break;
  case Contribution::Kind::unexpanded:
    text = "rays not shown individually";
    break;
  }
  return text + way_text(answer.namer, answer.sum, term.last_step);
}

} // namespace

std::vector<NamedTerm> named_terms(const Answer& answer) {
  std::vector<NamedTerm> terms;
  for (const Contribution& term : answer.sum.terms) {
    std::string text = term_text(answer, term);
    const auto same = std::find_if(terms.begin(), terms.end(), [&](const NamedTerm& t) { return t.text == text; });
    if (same == terms.end())
      terms.push_back({std::move(text), term.value});
    else
      same->value += term.value;
  }
  std::stable_sort(terms.begin(), terms.end(),
                   [](const NamedTerm& a, const NamedTerm& b) { return size_of(a.value) > size_of(b.value); });
  return terms;
}

} // namespace rt::tools::explain
