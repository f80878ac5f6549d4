#pragma once

#include <string_view>

namespace displayfile {

/// SIMD instruction sets of this processor beyond the baseline for which the program was compiled.
///
/// Detected here instead of by Highway's library, which measures the processor's clock for 3 ms
/// when it is loaded.
enum class VectorKind { baseline, sse4, avx2, avx512 };

/// The widest kind that this processor supports; detected at the first call.
VectorKind vectors_of_processor();

/// The kind of that name: baseline, sse4, avx2 or avx512. Throws Error for any other.
VectorKind vector_kind(std::string_view name);

/// The widest kind in use: the processor's, limited by the environment variable
/// DISPLAYFILE_VECTORS, by which tests run the narrower forms. All give the same results. Found at
/// the first call. Throws Error if the variable names no kind.
VectorKind widest_vectors();

/// The form of a function for the widest usable kind. Forms are in the order of VectorKind, null
/// where not compiled.
template <class Function>
Function* widest_form(Function* baseline, Function* sse4, Function* avx2, Function* avx512) {
  const VectorKind widest = widest_vectors();
  if (avx512 != nullptr && widest >= VectorKind::avx512) return avx512;
  if (avx2 != nullptr && widest >= VectorKind::avx2) return avx2;
  if (sse4 != nullptr && widest >= VectorKind::sse4) return sse4;
  return baseline;
}

/// Replaces HWY_DYNAMIC_DISPATCH in files compiled once for each kind.
#define DISPLAYFILE_WIDEST_FORM(function)                                                  \
  displayfile::widest_form<decltype(HWY_STATIC_DISPATCH(function))>(                       \
      HWY_CHOOSE_FALLBACK(function), HWY_CHOOSE_SSE4(function), HWY_CHOOSE_AVX2(function), \
      HWY_CHOOSE_AVX3(function))

}  // namespace displayfile
