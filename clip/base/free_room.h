#pragma once

namespace displayfile {

/// Gives back the room that an array has for more elements, which copies the elements, if it is
/// much.
template <class Array>
void free_room(Array& array) {
  if (array.capacity() - array.size() > array.size() / 32) array.shrink_to_fit();
}

}  // namespace displayfile
