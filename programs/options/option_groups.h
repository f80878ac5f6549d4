#pragma once

namespace displayfile {

// Groups of options in --help.
inline constexpr const char* kOutputOptions = "Output";
inline constexpr const char* kPictureOptions = "Picture";
inline constexpr const char* kPaperOptions = "Paper and pens";
inline constexpr const char* kVectorOptions = "Vectors";
inline constexpr const char* kCameraOptions = "Camera";
inline constexpr const char* kImportOptions = "Limits of foreign formats";
inline constexpr const char* kHiddenSurfaceOptions = "Hidden surfaces";
inline constexpr const char* kGoldenOptions = "Golden files";
inline constexpr const char* kReportOptions = "Reports";
inline constexpr const char* kLimitOptions = "Limits";

}  // namespace displayfile
