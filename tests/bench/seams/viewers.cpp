#include "tests/bench/seams/viewers.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>

#include "clip/error.h"
#include "interp/files/png_file.h"
#include "programs/bench/process.h"

namespace displayfile::bench {

namespace {

namespace fs = std::filesystem;
using Command = std::vector<std::string>;

constexpr int kPointsOfInch = 72;

std::string dots(double scale) { return fmt::format("{}", kPointsOfInch * scale); }
std::string without_extension(const fs::path& png) {
  return (png.parent_path() / png.stem()).string();
}

/// An SVG file is drawn as large as a page that holds it says.
Command browser(const fs::path& file, double scale, int side, const fs::path& png) {
  const int pixels = static_cast<int>(std::lround(side * scale));
  const fs::path page = png.string() + ".html";
  std::ofstream(page) << fmt::format(
      "<body style=\"margin:0;background:#fff\"><img src=\"{}\" width=\"{}\" "
      "style=\"display:block\">",
      fs::absolute(file).string(), pixels);
  return {"chromium",
          "--headless",
          "--no-sandbox",
          "--disable-gpu",
          "--hide-scrollbars",
          "--force-device-scale-factor=1",
          "--user-data-dir=" + png.string() + ".profile",
          fmt::format("--window-size={0},{0}", std::max(pixels, 600)),
          "--screenshot=" + fs::absolute(png).string(),
          "file://" + fs::absolute(page).string()};
}

Command ghostscript(const fs::path& file, double scale, const fs::path& png) {
  return {"gs",
          "-q",
          "-dNOPAUSE",
          "-dBATCH",
          "-dSAFER",
          "-sDEVICE=png16m",
          "-dEPSCrop",
          "-dGraphicsAlphaBits=4",
          "-r" + dots(scale),
          "-sOutputFile=" + png.string(),
          file.string()};
}

Command poppler(const char* program, const fs::path& file, double scale, const fs::path& png) {
  return {program, "-r", dots(scale), "-png", "-singlefile", file.string(), without_extension(png)};
}

const std::vector<Viewer>& viewers() {
  static const std::vector<Viewer> all{
      {"librsvg", "rsvg-convert", "svg", false,
       [](const fs::path& file, double scale, int, const fs::path& png) {
         return Command{"rsvg-convert", "-z",         fmt::format("{}", scale), "-b", "white", "-o",
                        png.string(),   file.string()};
       }},
      {"Chromium", "chromium", "svg", true, browser},
      {"poppler", "pdftoppm", "pdf", false,
       [](const fs::path& file, double scale, int, const fs::path& png) {
         return poppler("pdftoppm", file, scale, png);
       }},
      {"Cairo", "pdftocairo", "pdf", false,
       [](const fs::path& file, double scale, int, const fs::path& png) {
         return poppler("pdftocairo", file, scale, png);
       }},
      {"MuPDF", "mutool", "pdf", false,
       [](const fs::path& file, double scale, int, const fs::path& png) {
         return Command{"mutool",    "draw", "-q",         "-r",
                        dots(scale), "-o",   png.string(), file.string()};
       }},
      {"Ghostscript", "gs", "pdf", false,
       [](const fs::path& file, double scale, int, const fs::path& png) {
         return ghostscript(file, scale, png);
       }},
      {"Ghostscript", "gs", "eps", false,
       [](const fs::path& file, double scale, int, const fs::path& png) {
         return ghostscript(file, scale, png);
       }},
  };
  return all;
}

}  // namespace

std::vector<Viewer> installed_viewers() {
  std::vector<Viewer> installed;
  for (const Viewer& viewer : viewers()) {
    if (run(Process{{"which", viewer.program}}).succeeded) installed.push_back(viewer);
  }
  return installed;
}

Picture seen_in(const Viewer& viewer, const fs::path& file, double scale, int side) {
  const fs::path png = file.string() + "." + viewer.program + ".png";
  const Command command = viewer.command(file, scale, side, png);
  if (!run(command).succeeded || !fs::exists(png)) {
    throw Error(fmt::format("{} cannot draw {}", viewer.program, file.string()));
  }
  Picture picture = read_png(png);
  fs::remove(png);
  return picture;
}

}  // namespace displayfile::bench
