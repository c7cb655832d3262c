// The queues (FA) of all cells.
#pragma once

#include <cstdint>
#include <vector>

namespace rc2::thesis {

/// Many first-in-first-out queues that share their memory: what moves between them in a simulation
/// stays in the processor's cache.
template <typename Item>
class Queues {
 public:
  explicit Queues(std::size_t count) : queues_(count) {}

  std::size_t size(std::size_t queue) const { return queues_[queue].size; }
  const Item& front(std::size_t queue) const { return links_[queues_[queue].first].item; }

  void push(std::size_t queue, const Item& item) {
    std::uint32_t place = free_;
    if (place == kNone) {
      place = static_cast<std::uint32_t>(links_.size());
      links_.emplace_back();
    } else {
      free_ = links_[place].next;
    }
    links_[place] = {item, kNone};
    append(queues_[queue], place);
  }

  void pop(std::size_t queue) {
    const std::uint32_t place = take(queues_[queue]);
    links_[place].next = free_;
    free_ = place;
  }

  /// The first one becomes the last one.
  void rotate(std::size_t queue) { append(queues_[queue], take(queues_[queue])); }

 private:
  static constexpr std::uint32_t kNone = 0xFFFFFFFF;

  struct Link {
    Item item;
    std::uint32_t next = kNone;
  };
  struct Queue {
    std::uint32_t first = kNone, last = kNone, size = 0;
  };

  void append(Queue& queue, std::uint32_t place) {
    links_[place].next = kNone;
    (queue.size == 0 ? queue.first : links_[queue.last].next) = place;
    queue.last = place;
    ++queue.size;
  }

  std::uint32_t take(Queue& queue) {
    const std::uint32_t place = queue.first;
    queue.first = links_[place].next;
    --queue.size;
    return place;
  }

  std::vector<Queue> queues_;
  std::vector<Link> links_;
  std::uint32_t free_ = kNone;  ///< the first link that holds nothing
};

}  // namespace rc2::thesis
