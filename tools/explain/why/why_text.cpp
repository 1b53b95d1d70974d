#include "tools/explain/why/why_rays.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

namespace rt::tools::explain {
namespace {

// How many of the terms are listed: for the path alone those that make up 90 % of the sum, but at most three.
std::size_t listed_terms(const std::vector<NamedTerm>& terms, double whole, const Detail& detail) {
  if (!detail.is_path_only()) return std::min<std::size_t>(terms.size(), 12);
  std::size_t listed = 0;
  for (double size = 0; listed < std::min<std::size_t>(terms.size(), 3) && size < 0.9 * whole; ++listed)
    size += size_of(terms[listed].value);
  return listed;
}

// The terms, largest first, and their sum compared with the traced radiance.
void write_sum(const Answer& answer, const Detail& detail, Page& page) {
  const std::vector<NamedTerm> terms = named_terms(answer);
  const double whole = size_of(answer.sum.total);
  const std::size_t listed = listed_terms(terms, whole, detail);
  const auto write = [&page](std::string_view first, const Color& value, std::string_view text) {
    page.line(2, fmt::format("{:>9}  {}  {}", first, color_text(value), text), 13);
  };
  page.line(0, terms.empty() ? "no contributions" : "contributions, the largest first");
  for (std::size_t i = 0; i < listed; ++i)
    write(percent_text(size_of(terms[i].value) / whole), terms[i].value, terms[i].text);
  Color rest = black;
  for (std::size_t i = listed; i < terms.size(); ++i) rest += terms[i].value;
  if (const std::size_t left = terms.size() - listed; left > 0)
    write(percent_text(size_of(rest) / whole), rest, fmt::format("{} smaller term{}", left, left == 1 ? "" : "s"));
  const Color traced = answer.tree->radiance, difference = answer.sum.total - traced;
  const double gap = std::max({std::abs(difference.r), std::abs(difference.g), std::abs(difference.b)});
  write("sum", answer.sum.total,
        gap == 0 ? "matches the renderer" : fmt::format("matches the renderer, to {:.1g}", gap));
}

std::string headline(const Answer& answer) {
  const Color seen = answer.tree->radiance;
  return fmt::format("{} of {}: {} linear, shown as {}", answer.ray.name,
                     std::filesystem::path(answer.file).filename().string(), color_text(seen),
                     shown(seen, scene::tone_mapping(answer.scene)));
}

} // namespace

std::string why_text(const Answer& answer, const Detail& detail) {
  Page page;
  page.line(0, headline(answer));
  if (answer.pixel)
    page.line(2, fmt::format("the pixel itself is the mean of its {} samples: {} linear, shown as {}",
                             scene::whitted_samples(answer.scene), color_text(*answer.pixel),
                             shown(*answer.pixel, scene::tone_mapping(answer.scene))));
  page.blank();
  if (detail.is_path_only())
    write_path(answer, page);
  else
    write_tree(answer, detail, page);
  page.blank();
  write_sum(answer, detail, page);
  page.blank();
  page.line(0, verdict(answer));
  return page.take();
}

} // namespace rt::tools::explain
