#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <ios>
#include <iterator>
#include <limits>
#include <ostream>
#include <random>
#include <set>
#include <sstream>
#include <streambuf>
#include <string>
#include <vector>

#include "clip/base/error.h"
#include "displayfile/files.h"
#include "displayfile/text/dump_compare.h"
#include "tests/fuzz/record_and_replay.h"
#include "tests/random_application.h"
#include "tests/slower.h"

namespace displayfile {
namespace {

/// The settings that a drawing program makes besides the display file.
void expect_same_state(const GraphicsSystem& a, const GraphicsSystem& b) {
  EXPECT_EQ(a.hidden_surfaces().removal, b.hidden_surfaces().removal);
  EXPECT_EQ(a.looks().attributes.back_face_removal, b.looks().attributes.back_face_removal);
  EXPECT_EQ(a.hidden_surfaces().method, b.hidden_surfaces().method);
  EXPECT_EQ(a.hidden_surfaces().hidden_lines, b.hidden_surfaces().hidden_lines);
  EXPECT_EQ(a.hidden_surfaces().line_order, b.hidden_surfaces().line_order);
  EXPECT_EQ(a.hidden_surfaces().line_halo, b.hidden_surfaces().line_halo);
  EXPECT_EQ(a.hidden_surfaces().z_buffer, b.hidden_surfaces().z_buffer);
  EXPECT_EQ(a.looks().attributes.shading, b.looks().attributes.shading);
  EXPECT_EQ(a.looks().crease_degrees, b.looks().crease_degrees);
  EXPECT_EQ(a.looks().annotation, b.looks().annotation);
  EXPECT_EQ(a.looks().attributes.shadows, b.looks().attributes.shadows);
  EXPECT_EQ(a.counts().polygons, b.counts().polygons);
  EXPECT_EQ(a.counts().triangulated, b.counts().triangulated);
  EXPECT_EQ(a.explicit_settings().contains_view(), b.explicit_settings().contains_view());
  EXPECT_EQ(a.looks().background, b.looks().background);
  EXPECT_EQ(a.looks().cut_faces.kind, b.looks().cut_faces.kind);
  EXPECT_EQ(a.looks().cut_faces.spacing, b.looks().cut_faces.spacing);
  EXPECT_EQ(a.looks().cut_faces.angle, b.looks().cut_faces.angle);
  EXPECT_EQ(words_of(a.hidden_surfaces().lines), words_of(b.hidden_surfaces().lines));
  for (const Segment& segment : a.display_file().segments()) {
    EXPECT_EQ(segment.title(), b.display_file().segment(segment.name()).title());
  }
}

/// Whatever the application called, its recording makes the same display file, bit for bit
/// (numbers in dumps read back to the same doubles), and records to the same text again.
TEST(RecordReplay, RandomApplications) {
  constexpr int kApplications = 300 / test::kSlower, kCalls = 350;
  std::set<std::string> routines;
  std::size_t instructions = 0;
  int refused = 0;
  for (int seed = 0; seed < kApplications; ++seed) {
    SCOPED_TRACE(seed);
    std::ostringstream recording, again;
    Recorder recorder(recording), recorder_again(again);
    GraphicsSystem first, second;
    first.set_recorder(&recorder);
    second.set_recorder(&recorder_again);
    test::RandomApplication application(std::mt19937_64(static_cast<std::uint64_t>(seed)), first);
    for (int i = 0; i < kCalls; ++i) application.call();
    if (first.open_segment_name()) first.close_segment();
    while (first.counts().transformations_saved > 0) first.restore_transformation_3();
    refused += application.refused();

    ASSERT_NO_THROW(replay(recording.str(), "recording", second));
    const std::string expected = dump(first.display_file()), actual = dump(second.display_file());
    ASSERT_EQ(first_difference(actual, expected), std::nullopt);
    ASSERT_EQ(again.str(), recording.str());
    expect_same_state(first, second);

    std::istringstream lines(recording.str());
    for (std::string line; std::getline(lines, line);) {
      routines.insert(line.substr(0, line.find(' ')));
    }
    instructions += static_cast<std::size_t>(std::ranges::count(expected, '\n'));
  }
  // The applications did something: every routine, and pictures of some size.
  if (test::kSlower == 1) {
    EXPECT_EQ(routines.size(), 84u);
  }
  EXPECT_GT(instructions, 50000u / test::kSlower);
  EXPECT_GT(refused, 1000 / test::kSlower);
}

/// A style's parts that have no meaning make no difference between the two display files.
TEST(RecordReplay, StylesWithPartsOfNoMeaning) {
  std::ostringstream recording;
  Recorder recorder(recording);
  GraphicsSystem first, second;
  first.set_recorder(&recorder);
  first.open_segment(1);
  for (double shade : {0.25, 0.5}) {
    first.set_fill_style({FillStyle::Kind::hollow, {shade, 0, 0}});
    first.set_line_style({LineStyle::Kind::none, {shade, 0, 0}, 1.0 + shade});
    first.polygon_abs_2({{0, 0}, {0.5, 0}, {0.5, 0.5}});
    first.set_line_style({LineStyle::Kind::solid, {0, 0, 0}, 1.0, shade, shade});
    first.polygon_abs_2({{0, 0}, {0.5, 0}, {0.5, 0.5}});
  }
  first.close_segment();
  replay(recording.str(), "recording", second);
  EXPECT_EQ(dump(second.display_file()), dump(first.display_file()));
}

/// The text that applications and users read: the routine's words, shortest numbers, two blanks
/// between points.
TEST(RecordReplay, LinesOfTheRecording) {
  std::ostringstream recording;
  Recorder recorder(recording);
  GraphicsSystem system;
  system.set_recorder(&recorder);
  system.set_window(-1, 0.1, -0.0, 1e22);
  system.set_hidden_surfaces({.method = HiddenMethod::z_buffer});
  system.open_segment(12);
  system.set_light({0, 0, 2});
  system.set_line_style({LineStyle::Kind::dashed, {1, 0, 0}, 2, 3, 4});
  system.polygon_abs_3({{0, 0, 0}, {0.1, 0, 0}, {0, 1.0 / 3.0, 5e-324}});
  system.polygon_rel_2({{0, 0}, {0.5, 0}, {0, 0.5}});
  system.set_text_style({0.05, TextStyle::Alignment::right});
  system.set_text_style({1, TextStyle::Alignment::left, true});
  system.text("\u03c0, # \"q\" \\");
  system.text("");
  system.close_segment();
  system.set_visibility(12, false);
  system.set_segment_title(12, "M6 \u00d7 20");
  EXPECT_EQ(recording.str(),
            "set-window -1 0.1 -0 1e+22\n"
            "set-hidden-method z-buffer\n"
            "open-segment 12\n"
            "set-light 0 0 2 0.2\n"
            "set-line-style dashed 1 0 0 2 3 4\n"
            "polygon-abs-3  0 0 0  0.1 0 0  0 0.3333333333333333 5e-324\n"
            "polygon-rel-2  0 0  0.5 0  0 0.5\n"
            "set-text-style 0.05 right\n"
            "set-text-style 1 left always\n"
            "text \"\u03c0, # \\\"q\\\" \\\\\"\n"
            "text \"\"\n"
            "close-segment\n"
            "set-visibility 12 off\n"
            "set-segment-title 12 \"M6 \u00d7 20\"\n");
}

/// Refused calls are not recorded, and a recorder that is taken away records no more.
TEST(RecordReplay, OnlyCallsThatSucceedAreRecorded) {
  std::ostringstream recording;
  Recorder recorder(recording);
  GraphicsSystem system;
  system.set_recorder(&recorder);
  EXPECT_THROW(system.close_segment(), Error);
  EXPECT_THROW(system.set_view_up({0, 0, 0}), Error);
  system.set_hidden_surfaces({.z_buffer = true});
  system.set_recorder(nullptr);
  system.set_hidden_surfaces({.z_buffer = false});
  EXPECT_EQ(recording.str(), "set-z-buffer on\n");
}

void enter_triangle(GraphicsSystem& system) {
  system.polygon_abs_3({{0, 0, 0}, {0.5, 0, 0}, {0, 0.5, 0}});
}

/// Segments that are taken back leave nothing: not in the display file, not in the current
/// position, not in the ordinals and not in the recording.
TEST(RecordReplay, SegmentsThatAreTakenBackAreNotRecorded) {
  std::ostringstream recording;
  Recorder recorder(recording);
  GraphicsSystem system, other, replayed;
  system.set_recorder(&recorder);
  const auto enter = [](GraphicsSystem& g, int name) {
    g.enter_segments([&] {
      g.open_segment(name);
      enter_triangle(g);
      g.close_segment();
    });
  };
  enter(system, 1);
  EXPECT_THROW(system.enter_segments([&] {
    system.open_segment(2);
    enter_triangle(system);
    system.close_segment();
    system.open_segment(3);
    system.line_abs_3(1, 1, 1);
    throw Error("no more");
  }),
               Error);
  EXPECT_FALSE(system.open_segment_name());
  enter(system, 2);
  enter(other, 1);
  enter(other, 2);
  for (GraphicsSystem* g : {&system, &other}) {
    g->open_segment(3);
    g->line_rel_3(0.25, 0, 0);
    g->close_segment();
  }
  EXPECT_EQ(dump(system.display_file()), dump(other.display_file()));
  replay(recording.str(), "recording", replayed);
  EXPECT_EQ(dump(replayed.display_file()), dump(system.display_file()));
}

/// Nor do its settings remain: the recording has none of them.
TEST(RecordReplay, AttributesOfSegmentsThatAreTakenBackAreNotLeft) {
  std::ostringstream recording;
  Recorder recorder(recording);
  GraphicsSystem system, replayed;
  system.set_recorder(&recorder);
  system.set_cutting_plane(2, 0, 0, 1, 9);
  system.save_transformation_3();
  EXPECT_THROW(system.enter_segments([&] {
    system.open_segment(1);
    system.set_fill_style({FillStyle::Kind::solid, {1, 0, 0}});
    system.set_line_style({LineStyle::Kind::dashed, {1, 0, 0}, 2, 3, 4});
    system.set_lower_line_style(LineStyle{LineStyle::Kind::none});
    system.set_text_style({0.5, TextStyle::Alignment::right});
    system.set_light({0, 0, 1});
    system.set_shading(Shading::phong);
    system.set_crease_angle(30.0);
    system.set_annotation_style({2.5, AnnotationStyle::Unit::pixels, AnnotationStyle::Ends::dot, 0,
                                 AnnotationStyle::Placement::automatic, "<> H7"});
    system.set_shadows(true);
    system.set_back_face_removal(true);
    system.set_pick_id(7);
    system.set_surface_curves(SurfaceCurves::x);
    system.set_surface_sides(SurfaceSides::upper);
    system.set_cutting_plane(1, 1, 0, 0, 0);
    system.set_cutting_plane_off(2);
    system.set_cut_faces({CutFaces::Kind::closed});
    system.set_background({Background::Kind::none});
    system.restore_transformation_3();
    system.scale_3(0.5, 0.5, 0.5);
    system.set_vertex_normals({{0, 0, 1}, {0, 0, 1}, {0, 1, 1}, {1, 0, 1}});
    system.set_vertex_colours({{0, 0, 1}, {0, 0, 1}, {0, 1, 1}, {1, 0, 1}});
    system.begin_solid();
    throw Error("no more");
  }),
               Error);
  EXPECT_EQ(system.counts().solids_open, 0u);
  EXPECT_EQ(system.looks().attributes, GraphicsSystem().looks().attributes);
  EXPECT_EQ(system.looks().crease_degrees, 180.0);
  EXPECT_EQ(system.looks().annotation, AnnotationStyle());
  EXPECT_FALSE(system.explicit_settings().contains(Setting::fill_style));
  EXPECT_FALSE(system.explicit_settings().contains(Setting::light));
  EXPECT_FALSE(system.explicit_settings().contains(Setting::crease_angle));
  EXPECT_EQ(system.looks().cut_faces.kind, CutFaces::Kind::open);
  EXPECT_EQ(system.counts().transformations_saved, 1u);
  EXPECT_EQ(system.looks().background, Background());
  system.open_segment(1);
  enter_triangle(system);
  const std::vector<double> heights{0, 1, 1, 0};
  system.surface_3({0, 0.5, 2, 0, 0.5, 2, heights});
  system.text("a");
  system.close_segment();
  system.restore_transformation_3();
  replay(recording.str(), "recording", replayed);
  EXPECT_EQ(dump(replayed.display_file()), dump(system.display_file()));
}

/// A height that is not known is a hole whatever the sign of its NaN is.
TEST(RecordReplay, HolesOfSurfaces) {
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  std::ostringstream recording;
  Recorder recorder(recording);
  GraphicsSystem system, replayed;
  system.set_recorder(&recorder);
  const std::vector<double> heights{0, 0.1, -kNone, 0, 0.1, 0.2, kNone, 0, 0};
  system.open_segment(1);
  system.surface_3({0, 0.5, 3, 0, 0.5, 3, heights});
  system.close_segment();
  EXPECT_NE(recording.str().find(" 0 0.1 nan 0 0.1 0.2 nan 0 0\n"), std::string::npos)
      << recording.str();
  replay(recording.str(), "recording", replayed);
  EXPECT_EQ(dump(replayed.display_file()), dump(system.display_file()));
}

/// The effects of any routines are undone, an open segment is restored, and then work continues.
TEST(RecordReplay, AllOrNothing) {
  std::ostringstream recording;
  Recorder recorder(recording);
  GraphicsSystem system, other;
  system.set_recorder(&recorder);
  for (GraphicsSystem* g : {&system, &other}) {
    g->open_segment(1);
    enter_triangle(*g);
    g->close_segment();
    g->open_segment(2);
    enter_triangle(*g);
  }
  EXPECT_THROW(system.all_or_nothing([&] {
    enter_triangle(system);
    system.set_fill_style({FillStyle::Kind::hollow});
    system.all_or_nothing([&] { system.close_segment(); });
    system.delete_segment(1);
    system.set_window(0, 2, 0, 2);
    throw Error("no more");
  }),
               Error);
  for (GraphicsSystem* g : {&system, &other}) {
    enter_triangle(*g);
    g->close_segment();
    g->open_segment(3);
    g->line_rel_3(0.25, 0, 0);
    g->close_segment();
  }
  EXPECT_EQ(dump(system.display_file()), dump(other.display_file()));
  GraphicsSystem replayed;
  replay(recording.str(), "recording", replayed);
  EXPECT_EQ(dump(replayed.display_file()), dump(system.display_file()));
}

/// A stream on a disk that is full, which throws. Calls that were recorded at once have been
/// carried out; those that were held back have not.
TEST(RecordReplay, StreamsThatThrow) {
  struct Full : std::streambuf {
    int_type overflow(int_type) override { return traits_type::eof(); }
  } full;
  std::ostream stream(&full);
  stream.exceptions(std::ios::badbit);
  Recorder recorder(stream);
  GraphicsSystem system;
  const auto enter = [&] {
    system.open_segment(1);
    enter_triangle(system);
    system.close_segment();
  };
  system.set_recorder(&recorder);
  for (int time = 0; time < 2; ++time) {
    EXPECT_THROW(system.all_or_nothing(enter), std::ios::failure);
    EXPECT_THROW(system.all_or_nothing([&] { system.set_pick_id(3); }), std::ios::failure);
    EXPECT_THROW(system.enter_segments(enter), std::ios::failure);
    EXPECT_EQ(system.display_file().segments().size(), 0u);
    EXPECT_EQ(system.counts().polygons, 0);
  }
  EXPECT_THROW(system.set_hidden_surfaces({.z_buffer = true}), std::ios::failure);
  EXPECT_TRUE(system.hidden_surfaces().z_buffer);
  system.set_recorder(nullptr);
  system.all_or_nothing(enter);
  EXPECT_EQ(system.counts().polygons, 1);
}

/// The fuzzer's corpus: programs right and wrong, without their wrong lines.
TEST(RecordReplay, FuzzCorpus) {
  int programs = 0;
  for (const auto& entry : std::filesystem::directory_iterator(DRAWING_PROGRAM_CORPUS)) {
    SCOPED_TRACE(entry.path().filename().string());
    std::ifstream in(entry.path(), std::ios::binary);
    const std::string program{std::istreambuf_iterator<char>(in), {}};
    EXPECT_EQ(difference_after_record_and_replay(program), std::nullopt);
    ++programs;
  }
  EXPECT_GT(programs, 5);
}

}  // namespace
}  // namespace displayfile
