#include "clip/base/vector_kind.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <string>
#include <string_view>

#include "clip/base/error.h"

#if defined(__x86_64__) || defined(__i386__)
#include <cpuid.h>
#endif

namespace displayfile {

namespace {

#if defined(__x86_64__) || defined(__i386__)
/// The features for which not all versions of the compilers' built-in check have a name: conversion
/// to half floats, and counting leading zeros.
bool has_half_floats_and_leading_zeros() {
  unsigned a = 0, b = 0, c = 0, d = 0;
  const bool half_floats = __get_cpuid(1, &a, &b, &c, &d) != 0 && (c & bit_F16C) != 0;
  return half_floats && __get_cpuid(0x80000001, &a, &b, &c, &d) != 0 && (c & bit_LZCNT) != 0;
}

/// Checks all features that Highway needs for a vector kind, and that the system saves its
/// registers.
VectorKind find_widest_vectors() {
  __builtin_cpu_init();
  const auto all = [](auto... supported) { return ((supported != 0) && ...); };
  if (!all(__builtin_cpu_supports("sse4.1"), __builtin_cpu_supports("sse4.2"),
           __builtin_cpu_supports("ssse3"), __builtin_cpu_supports("aes"),
           __builtin_cpu_supports("pclmul"))) {
    return VectorKind::baseline;
  }
  if (!all(__builtin_cpu_supports("avx2"), __builtin_cpu_supports("fma"),
           __builtin_cpu_supports("bmi"), __builtin_cpu_supports("bmi2"),
           has_half_floats_and_leading_zeros())) {
    return VectorKind::sse4;
  }
  return all(__builtin_cpu_supports("avx512f"), __builtin_cpu_supports("avx512cd"),
             __builtin_cpu_supports("avx512dq"), __builtin_cpu_supports("avx512bw"),
             __builtin_cpu_supports("avx512vl"))
             ? VectorKind::avx512
             : VectorKind::avx2;
}
#else
VectorKind find_widest_vectors() { return VectorKind::baseline; }
#endif

constexpr std::array<std::string_view, 4> kNames{"baseline", "sse4", "avx2", "avx512"};

}  // namespace

VectorKind vectors_of_processor() {
  static const VectorKind widest = find_widest_vectors();
  return widest;
}

VectorKind vector_kind(std::string_view name) {
  const auto* const found = std::ranges::find(kNames, name);
  if (found != kNames.end()) return static_cast<VectorKind>(found - kNames.begin());
  throw Error("DISPLAYFILE_VECTORS=" + std::string(name) +
              ": expected baseline, sse4, avx2 or avx512");
}

VectorKind widest_vectors() {
  static const VectorKind widest = [] {
    const char* const most = std::getenv("DISPLAYFILE_VECTORS");
    return most == nullptr ? vectors_of_processor()
                           : std::min(vector_kind(most), vectors_of_processor());
  }();
  return widest;
}

}  // namespace displayfile
