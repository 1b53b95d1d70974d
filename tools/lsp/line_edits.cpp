#include "tools/lsp/line_edits.hpp"

#include <algorithm>
#include <cstdint>

namespace rt::tools::lsp {
namespace {

// Including their line endings.
std::vector<std::string_view> lines_of(std::string_view text) {
  std::vector<std::string_view> lines;
  while (!text.empty()) {
    const std::size_t length = std::min(text.find('\n'), text.size() - 1) + 1;
    lines.push_back(text.substr(0, length));
    text.remove_prefix(length);
  }
  return lines;
}

// With more pairs of lines than this, the difference is a single edit.
constexpr std::size_t most_pairs = 4'000'000;

// The longest common subsequence of lines (Wagner and Fischer, The String-to-String Correction Problem, 1974), forwards
// from the first lines that differ.
class Comparison {
public:
  Comparison(std::vector<std::string_view> before, std::vector<std::string_view> after)
      : before_(std::move(before)), after_(std::move(after)) {}

  std::vector<Edit> run() {
    while (first_ < std::min(before_.size(), after_.size()) && before_[first_] == after_[first_]) ++first_;
    end_before_ = before_.size(), end_after_ = after_.size();
    while (end_before_ > first_ && end_after_ > first_ && before_[end_before_ - 1] == after_[end_after_ - 1])
      --end_before_, --end_after_;
    if (first_ == end_before_ && first_ == end_after_) return {};
    for (std::size_t i = 0; i < first_; ++i) offset_ += before_[i].size();
    if ((end_before_ - first_ + 1) * (end_after_ - first_ + 1) > most_pairs)
      change(first_, end_before_, first_, end_after_);
    else
      walk();
    return std::move(edits_);
  }

private:
  // How many lines are common from `i` and `j` on.
  std::uint32_t& common(std::size_t i, std::size_t j) {
    return common_[(i - first_) * (end_after_ - first_ + 1) + (j - first_)];
  }

  void walk() {
    common_.assign((end_before_ - first_ + 1) * (end_after_ - first_ + 1), 0);
    for (std::size_t i = end_before_; i-- > first_;)
      for (std::size_t j = end_after_; j-- > first_;)
        common(i, j) =
            before_[i] == after_[j] ? common(i + 1, j + 1) + 1 : std::max(common(i + 1, j), common(i, j + 1));
    std::size_t i = first_, j = first_;
    while (i < end_before_ || j < end_after_) {
      if (i < end_before_ && j < end_after_ && before_[i] == after_[j]) {
        offset_ += before_[i].size();
        ++i, ++j;
        continue;
      }
      const std::size_t from_i = i, from_j = j;
      while ((i < end_before_ || j < end_after_) && !(i < end_before_ && j < end_after_ && before_[i] == after_[j])) {
        const bool drops = j == end_after_ || (i < end_before_ && common(i + 1, j) >= common(i, j + 1));
        ++(drops ? i : j);
      }
      change(from_i, i, from_j, j);
    }
  }

  void change(std::size_t i, std::size_t end_i, std::size_t j, std::size_t end_j) {
    Edit edit{offset_, offset_, {}};
    for (; i < end_i; ++i) edit.end += before_[i].size();
    for (; j < end_j; ++j) edit.text += after_[j];
    offset_ = edit.end;
    edits_.push_back(std::move(edit));
  }

  std::vector<std::string_view> before_, after_;
  std::size_t first_ = 0, end_before_ = 0, end_after_ = 0;
  std::size_t offset_ = 0; // in the old text
  std::vector<std::uint32_t> common_;
  std::vector<Edit> edits_;
};

} // namespace

std::vector<Edit> line_edits(std::string_view before, std::string_view after) {
  return Comparison(lines_of(before), lines_of(after)).run();
}

} // namespace rt::tools::lsp
