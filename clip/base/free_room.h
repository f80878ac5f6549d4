#pragma once

namespace displayfile {

/// Frees an array's spare capacity if it is large, copying the elements.
template <class Array>
void free_room(Array& array) {
  if (array.capacity() - array.size() > array.size() / 32) array.shrink_to_fit();
}

}  // namespace displayfile
