#pragma once

#include <string_view>

namespace displayfile {

/// The kinds of vectors that this processor can calculate with, beyond those that every processor
/// has for which the program was compiled.
///
/// Asked here and not of Highway's library, which measures the processor's clock for 3 ms whenever
/// it is loaded.
enum class VectorKind { baseline, sse4, avx2, avx512 };

/// The widest vectors that this processor can run; found at the first call.
VectorKind vectors_of_processor();

/// The kind of that name: baseline, sse4, avx2 or avx512. Throws Error for any other.
VectorKind vector_kind(std::string_view name);

/// The widest vectors that are used: the processor's, or no wider ones than the environment
/// variable DISPLAYFILE_VECTORS names, with which tests run the narrower forms too. All give the
/// same results. Found at the first call. Throws Error if the variable names no kind.
VectorKind widest_vectors();

/// The form of a function for the widest vectors that can be run. The forms are given in the order
/// of VectorKind, null where not compiled.
template <class Function>
Function* widest_form(Function* baseline, Function* sse4, Function* avx2, Function* avx512) {
  const VectorKind widest = widest_vectors();
  if (avx512 != nullptr && widest >= VectorKind::avx512) return avx512;
  if (avx2 != nullptr && widest >= VectorKind::avx2) return avx2;
  if (sse4 != nullptr && widest >= VectorKind::sse4) return sse4;
  return baseline;
}

/// In a file that is compiled once for each kind of vectors, in place of HWY_DYNAMIC_DISPATCH.
#define DISPLAYFILE_WIDEST_FORM(function)                                                  \
  displayfile::widest_form<decltype(HWY_STATIC_DISPATCH(function))>(                       \
      HWY_CHOOSE_FALLBACK(function), HWY_CHOOSE_SSE4(function), HWY_CHOOSE_AVX2(function), \
      HWY_CHOOSE_AVX3(function))

}  // namespace displayfile
