#include "interp/raster/caster_lists.h"

#include <algorithm>
#include <array>

namespace displayfile {

CasterLists::CasterLists(const WorldCasters& casters, std::size_t primitives)
    : casters_(&casters),
      primitives_(primitives),
      list_of_(std::make_unique<std::atomic<List>[]>(primitives)) {}

void CasterLists::clear() {
  for (std::size_t i = 0; i < primitives_; ++i) {
    list_of_[i].store(nullptr, std::memory_order_relaxed);
  }
  blocks_used_ = room_left_ = 0;
}

std::optional<std::span<const WorldCasters::Primitive>> CasterLists::of(Primitive receiver,
                                                                        const Point3& toward) {
  List list = list_of_[receiver].load(std::memory_order_acquire);
  if (list == nullptr) {
    std::array<Primitive, kLongest> few;
    const auto found = casters_->find_casters_on(receiver, toward, few);
    list = enter(receiver, std::span(few).first(found.value_or(0)), !found);
  }
  if (*list == kTooMany) return std::nullopt;
  return std::span(list + 1, *list);
}

/// Unless another thread was first.
CasterLists::List CasterLists::enter(Primitive receiver, std::span<const Primitive> list,
                                     bool too_many) {
  const std::lock_guard lock(entering_);
  if (const List entered = list_of_[receiver].load(std::memory_order_relaxed)) return entered;
  const std::size_t room = list.size() + 1;
  if (room_left_ < room) {
    if (blocks_used_ == blocks_.size()) blocks_.push_back(std::make_unique<Primitive[]>(kRoom));
    ++blocks_used_;
    room_left_ = kRoom;
  }
  Primitive* const to = blocks_[blocks_used_ - 1].get() + (kRoom - room_left_);
  room_left_ -= room;
  *to = too_many ? kTooMany : static_cast<Primitive>(list.size());
  std::ranges::copy(list, to + 1);
  list_of_[receiver].store(to, std::memory_order_release);
  ++made_;
  return to;
}

std::size_t CasterLists::bytes() const {
  return primitives_ * sizeof(List) + blocks_.size() * kRoom * sizeof(Primitive);
}

}  // namespace displayfile
