// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "families.hpp"
#include "offer.hpp"
#include "selion/core/angle.hpp"
#include "selion/motion/turns.hpp"

namespace selion {
namespace {

using WordFamily = std::vector<Word> (*)(const Pose& goal, const Swings& swings);

/// A family and a bound of its words: they turn left and right by at least so many radians.
struct Lazy {
  WordFamily words;
  double least_rad;
  Needs needs = Needs::nothing;
};

constexpr double kHair_m = 1e-8;
constexpr std::size_t kCheap = 4;  // straight and U-turns: the first of the families

/// Between words as long as each other the one of fewer stretches stands first and stays: families overlap, a
/// flat turn is also left, straight, left.
std::array<Lazy, 11> families_to(const Pose& goal) {
  const double left = whole_turns_off(goal.heading_rad);
  const double right = whole_turns_off(-goal.heading_rad);
  const double least = std::min(left, right);
  return {{{straight_words, 0},
           {loop_words, least},
           {dip_words, least},
           {flat_words, least},
           {line_words<1, 1>, left},
           {line_words<-1, -1>, right},
           {line_words<1, -1>, least},
           {line_words<-1, 1>, least},
           {fishtail_words, 0, Needs::reverse},
           {cusp_words, 0, Needs::reverse},
           {pivot_words, 0, Needs::pivot}}};
}

}  // namespace

/// What may come next, by the least that it can measure: families, the diagonals and starts of the searches
/// for three swings, and words that only want to be drawn.
class Connections::Queue {
 public:
  Queue(const Pose& from, const Pose& to, const Swings& swings, Manoeuvres may)
      : from_{from},
        to_{to},
        swings_{swings},
        may_{may},
        goal_{seen_from(from, to)},
        families_{families_to(goal_)} {
    entries_.reserve(32);
    words_.reserve(16);
    apart_m_ = length_m(goal_.at);
    for (std::size_t i = 0; i < kCheap; ++i) expand({0, Step::family, i, 0});
    least_m_ = shortest_u_turn_m();
    for (std::size_t i = kCheap; i < families_.size(); ++i)
      if (allows(may_, families_[i].needs)) push(Step::family, i, families_[i].least_rad);
    if (!near_for_three(goal_, swings_)) return;
    for (const std::size_t i : {0U, 1U}) push(Step::search, i, std::abs(goal_.heading_rad));
  }

  std::optional<Path> next() {
    if (auto path = direct()) return path;
    return found_any_ ? std::nullopt : driven_on();
  }

 private:
  enum class Step { word, family, search, diagonal, start };
  struct Entry {
    double least_m;
    Step step;
    std::size_t index;
    std::size_t serial;
  };
  struct Start {
    std::size_t search;
    ThreeSwingSearch::Start start;
  };

  std::optional<Path> direct() {
    while (!entries_.empty()) {
      std::pop_heap(entries_.begin(), entries_.end(), later);
      const Entry entry = entries_.back();
      entries_.pop_back();
      if (entry.step == Step::word) {
        if (auto path = drawn(words_[entry.index], entry.least_m)) return path;
      } else {
        expand(entry);
      }
    }
    return std::nullopt;
  }

  static bool later(const Entry& a, const Entry& b) {
    return a.least_m > b.least_m || (a.least_m == b.least_m && a.serial > b.serial);
  }

  void push_m(Step step, std::size_t index, double least_m) {
    entries_.push_back({least_m, step, index, serial_++});
    std::push_heap(entries_.begin(), entries_.end(), later);
  }

  void push(Step step, std::size_t index, double least_rad) {
    // A hair less: rounding must not let a longer one go first.
    const double bound_m = std::max(apart_m_, swings_.length_m(least_rad)) - kHair_m;
    push_m(step, index, std::max(least_m_, bound_m));
  }

  /// Between swaths side by side nothing is shorter than the loop or the dip, and nothing than the flat turn
  /// to a swath far aside: searching has found none, so the other families need not be asked before. A little
  /// beyond the first flat turns, and where a swath is driven on, others may be shorter.
  [[nodiscard]] double shortest_u_turn_m() const {
    const auto turn = u_turn(goal_);
    if (may_ != Manoeuvres{} || !turn || turn->before_m + std::abs(turn->after_m) > 1e-9) return 0;
    const double flat_from_m = std::numbers::sqrt2 * swings_.chord(std::numbers::pi / 2).length_m;
    const double aside_m = std::abs(turn->goal.at.y_m);
    if (aside_m > flat_from_m && aside_m < 1.5 * flat_from_m) return 0;
    return entries_.empty() ? 0 : entries_.front().least_m + kHair_m;
  }

  void push_word(const Word& word) {
    words_.push_back(word);
    push_m(Step::word, words_.size() - 1, selion::length_m(word, swings_));
  }

  void expand(const Entry& entry) {
    if (entry.step == Step::family) {
      for (const Word& word : families_[entry.index].words(goal_, swings_)) push_word(word);
    } else if (entry.step == Step::search) {
      searches_[entry.index].emplace(goal_, entry.index == 0 ? 1 : -1, swings_);
      push_diagonal(entry.index);
    } else if (entry.step == Step::diagonal) {
      add_starts(entry.index, ranks_[entry.index]++);
      push_diagonal(entry.index);
    } else if (const auto triple =
                   searches_[starts_[entry.index].search]->found(starts_[entry.index].start)) {
      push_word({.swings_rad = *triple});
    }
  }

  void push_diagonal(std::size_t search) {
    const auto least_m = searches_[search]->least_m(ranks_[search]);
    if (least_m) push_m(Step::diagonal, search, std::max(apart_m_, *least_m));
  }

  void add_starts(std::size_t search, std::size_t rank) {
    scratch_.clear();
    searches_[search]->add_starts(scratch_, rank);
    for (const auto& start : scratch_) {
      starts_.push_back({search, start});
      push_m(Step::start, starts_.size() - 1, std::max(apart_m_, start.least_m));
    }
  }

  /// Unless it is the same way as the last one.
  std::optional<Path> drawn(const Word& word, double length_m) {
    auto path = drawn_to(word, from_, to_, swings_);
    if (!path || (found_any_ && same_as_last(*path, length_m))) return std::nullopt;
    found_any_ = true;
    last_ = word;
    last_m_ = length_m;
    return path;
  }

  [[nodiscard]] bool same_as_last(const Path& path, double length_m) const {
    if (std::abs(length_m - last_m_) > 1e-7) return false;
    Drawn last{from_};
    draw_word(last, last_, swings_);
    return distance_m(at_quarter(path, length_m), at_quarter(last.path, last_m_)) < 1e-6;
  }

  static Point at_quarter(const Path& path, double length_m) {
    double left = length_m / 4;
    std::size_t i = 0;
    for (; i + 1 < path.size() && left > path[i].curve.length_m; ++i) left -= path[i].curve.length_m;
    return state_at(path[i].curve, left).at;
  }

  /// Where nothing else fits: straight on until the goal lies so far back that a turn towards it does.
  std::optional<Path> driven_on() {
    const double k = swings_.limits().curvature_per_m;
    const double least_m = 1 / k + k / swings_.limits().sharpness_per_m2;
    for (; doubled_ < 30; ++doubled_) {
      Drawn start{from_};
      draw_line(start, std::ldexp(least_m, doubled_));
      if (!rest_) rest_ = std::make_unique<Queue>(start.at, to_, swings_, may_);
      if (auto more = rest_->direct()) {
        append(start.path, *more);
        return std::move(start.path);
      }
      if (rest_->found_any_) break;
      rest_.reset();
    }
    return std::nullopt;
  }

  Pose from_;
  Pose to_;
  const Swings& swings_;
  Manoeuvres may_;
  Pose goal_;
  double apart_m_ = 0;
  double least_m_ = 0;  // of the families that are not cheap, where that is known
  std::array<Lazy, 11> families_;
  std::array<std::optional<ThreeSwingSearch>, 2> searches_;
  std::array<std::size_t, 2> ranks_{};  // of the next diagonal of each search
  std::vector<Entry> entries_;
  std::vector<Word> words_;
  std::vector<Start> starts_;
  std::vector<ThreeSwingSearch::Start> scratch_;
  std::size_t serial_ = 0;
  bool found_any_ = false;
  Word last_;
  double last_m_ = 0;
  int doubled_ = 0;
  std::unique_ptr<Queue> rest_;  // from where it has driven on to
};

Connections::Connections(const Pose& from, const Pose& to, const Swings& swings)
    : Connections{from, to, swings, Manoeuvres{}} {}
Connections::Connections(const Pose& from, const Pose& to, const Swings& swings, const Manoeuvres& may)
    : queue_{std::make_unique<Queue>(from, to, swings, may)} {}
Connections::~Connections() = default;
Connections::Connections(Connections&&) noexcept = default;
Connections& Connections::operator=(Connections&&) noexcept = default;

std::optional<Path> Connections::next() { return queue_->next(); }

std::vector<Path> connections(const Pose& from, const Pose& to, const CurveLimits& limits) {
  const Swings swings{limits};
  Connections all{from, to, swings};
  std::vector<Path> paths;
  while (auto path = all.next()) paths.push_back(std::move(*path));
  // A search for three swings may, once in thousands of pairs, show a way after one that is longer by little.
  std::stable_sort(paths.begin(), paths.end(),
                   [](const Path& a, const Path& b) { return length_m(a) < length_m(b); });
  return paths;
}

}  // namespace selion
