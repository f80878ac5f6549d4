// The truth by the command, of pixels and of lines, and pictures compared with it.

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "tests/command_fixture.h"

namespace {

class TruthCommand : public Command {
 protected:
  /// The identifiers in a .npy file.
  std::vector<std::int32_t> ids(const std::string& name) const {
    constexpr std::uintmax_t kHeader = 128;
    std::vector<std::int32_t> values((fs::file_size(folder_ / name) - kHeader) / 4);
    std::ifstream in(folder_ / name, std::ios::binary);
    in.seekg(kHeader);
    in.read(reinterpret_cast<char*>(values.data()),
            static_cast<std::streamsize>(4 * values.size()));
    return values;
  }
};

TEST_F(TruthCommand, IsTheItemBufferWhateverTheMethod) {
  write("t.draw",
        "set-window 0 1 0 1\nset-line-style none\nopen-segment 1\n"
        "polygon-abs-3 0 0 1  1 0 1  1 1 1  0 1 1\n"
        "polygon-abs-3 0 0 0  1 0 0  1 1 0\nclose-segment\n");
  EXPECT_EQ(run("truth t.draw --size 9x7 --ids t.npy --depth tz.npy"), 0) << err_;
  EXPECT_EQ(out_ + err_, "");
  EXPECT_EQ(run("draw t.draw --size 9x7 -o d.png --ids d.npy --depth dz.npy --hidden z-buffer"), 0);
  EXPECT_EQ(run("compare d.npy t.npy"), 0) << out_;
  EXPECT_EQ(run("compare dz.npy tz.npy"), 0) << out_;
  EXPECT_EQ(run("draw t.draw --size 9x7 -o p.png --ids p.npy --depth pz.npy --hidden none"), 0);
  EXPECT_EQ(run("compare p.npy t.npy --marks marks.png"), 1);
  EXPECT_NE(
      out_.find("0 show the background in the first only, 0 in the second only, 32 different"),
      std::string::npos)
      << out_;
  EXPECT_TRUE(fs::exists(folder_ / "marks.png"));
  EXPECT_EQ(run("compare pz.npy tz.npy"), 1);
  EXPECT_NE(out_.find("depth error: largest 0.25, mean 0.126984"), std::string::npos) << out_;
  EXPECT_EQ(run("truth t.draw --ids big.npy"), 0);
  EXPECT_EQ(fs::file_size(folder_ / "big.npy"), 128u + 512 * 512 * 4);
}

TEST_F(TruthCommand, OfABareMeshSeesTheSceneThatDrawSees) {
  write("m.obj",
        "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0.5 0.5 1\nf 1 2 5\nf 2 3 5\nf 3 4 5\nf 4 1 5\n");
  EXPECT_EQ(run("truth m.obj --size 90x60 --ids t.npy"), 0) << err_;
  EXPECT_EQ(run("draw m.obj --size 90x60 -o d.png --ids d.npy"), 0) << err_;
  EXPECT_EQ(run("compare d.npy t.npy"), 0) << out_;
}

/// Lengths in the picture's side: of a line through the middle of two squares, one before it.
TEST_F(TruthCommand, JudgesLines) {
  write("t.draw",
        "set-window 0 1 0 1\nset-view-depth -2 2\nset-line-style solid 1 1 1\nopen-segment 1\n"
        "move-abs-3 0 0.5 0\nline-abs-3 1 0.5 0\nset-line-style none\npolygon-abs-3 0.25 0 1  0.5 "
        "0 1  0.5 1 1  0.25 1 1"
        "\npolygon-abs-3 0.75 0 1e-7  1 0 1e-7  1 1 1e-7  0.75 1 1e-7\nclose-segment\n");
  EXPECT_EQ(run("truth t.draw --seen-lines t.txt --hidden franklin"), 0) << err_;
  EXPECT_EQ(out_,
            "lines           1, judged whole\npieces seen     2 by franklin\n"
            "total length    1 of the picture's side\nmissing length  0\nextra length    0\n");
  for (const std::string method : {"roberts", "franklin"}) {
    EXPECT_EQ(run("dump t.draw -o d.txt --hidden " + method), 0) << err_;
    EXPECT_EQ(run("compare t.txt d.txt"), 0) << out_;
  }
  EXPECT_EQ(run("truth t.draw --hidden roberts --precision roundoff=1e-6"), 1) << err_;
  EXPECT_NE(out_.find("missing length  0\nextra length    0.25\n"), std::string::npos) << out_;
  EXPECT_EQ(run("truth t.draw --hidden roberts --precision roundoff=1e-6 --line-samples 400"), 1);
  EXPECT_NE(out_.find("judged at "), std::string::npos) << out_;
  EXPECT_NE(out_.find("missing length  0\nextra length    0.249"), std::string::npos) << out_;
  write("m.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n");
  EXPECT_EQ(run("truth m.obj --hidden franklin --ids i.npy --size 9x9"), 0) << err_;
  EXPECT_NE(out_.find("lines           3,"), std::string::npos) << out_;  // of the one front face
  EXPECT_TRUE(fs::exists(folder_ / "i.npy"));
  expect_error("truth t.draw --hidden z-buffer", "expected one of roberts");
  expect_error("truth t.draw --hidden nothing",
               "unknown hidden-surface method 'nothing': expected one of roberts appel");
  expect_error("truth t.draw --hidden rovert", "did you mean 'roberts'? expected one of roberts");
  expect_error("truth t.draw --hidden franklin --precision rough", "rough");
  expect_error("truth t.draw --from world --seen-lines x.txt", "display-file coordinates");
  expect_error("truth t.draw --seen-lines nowhere/x.txt", "nowhere/x.txt");
  expect_error("truth t.draw --ids x.npy --line-samples 9", "expected --hidden");
}

TEST_F(TruthCommand, FromWorldCountsWhatTheRoundingOfViewingChanges) {
  write("view.draw", "set-view-plane-normal -3 -2 -6\nset-perspective 3 2 6\n");
  write("apart.draw",
        "open-segment 1\npolygon-abs-3 -1 0 1  1 0 1  1 0 -1  -1 0 -1\n"
        "polygon-abs-3 -0.7 1e-9 0.6  0.9 1e-9 0.7  0.3 1e-9 -0.8\nclose-segment\n");
  write("together.draw",
        "set-touching off\nopen-segment 1\npolygon-abs-3 -1 0 1  1 0 1  1 0 -1  -1 0 -1\n"
        "polygon-abs-3 -0.7 0 0.6  0.9 0 0.7  0.3 0 -0.8\nclose-segment\n");
  EXPECT_EQ(run("truth view.draw apart.draw --from world --size 64x64"), 0) << err_;
  EXPECT_EQ(out_, "0 of 4096 pixels differ from the display file, which viewing rounded\n");
  EXPECT_EQ(
      run("truth view.draw together.draw --from world --size 64x64 --ids w.npy --depth z.npy"), 0);
  EXPECT_EQ(std::stoi(out_), 0) << out_;
  EXPECT_EQ(fs::file_size(folder_ / "z.npy"), 128u + 64 * 64 * 8);
  EXPECT_EQ(run("truth view.draw together.draw --from display-file --size 64x64 --ids d.npy"), 0);
  EXPECT_EQ(out_, "");
  EXPECT_EQ(run("compare w.npy d.npy"), 0);
}

/// The rug as entered lies in the floor's plane, under one modelling transformation.
TEST_F(TruthCommand, FromEnteredPolygonsThatTouchLieInOnePlane) {
  write("view.draw",
        "set-view-plane-normal -3 -2 -6\nset-perspective 3 2 6\nset-line-style none\n"
        "rotate-x-3 12.3\nrotate-y-3 31.7\n");
  const std::string floor = "polygon-abs-3 -1 0.1 1  1 0.1 1  1 0.1 -1  -1 0.1 -1\n";
  const std::string rug = "polygon-abs-3 -0.7 0.1 0.6  0.9 0.1 0.7  0.3 0.1 -0.8\n";
  write("both.draw", "open-segment 1\n" + floor + rug + "close-segment\n");
  write("rug.draw", "set-pick-id 1\nopen-segment 1\n" + rug + "close-segment\n");
  EXPECT_EQ(run("truth view.draw both.draw --from entered --size 64x64 --ids e.npy"), 0) << err_;
  EXPECT_EQ(std::stoi(out_), 0) << out_;
  EXPECT_NE(out_.find("polygons in the planes of others: 1\n"), std::string::npos) << out_;
  EXPECT_EQ(run("truth view.draw rug.draw --from entered --size 64x64 --ids r.npy"), 0) << err_;
  const auto both = ids("e.npy"), alone = ids("r.npy");
  ASSERT_EQ(both.size(), alone.size());
  std::size_t covered = 0;
  for (std::size_t k = 0; k < alone.size(); ++k) {
    if (alone[k] != 1) continue;
    ++covered;
    EXPECT_EQ(both[k], 1);
  }
  EXPECT_GT(covered, 100u);
  EXPECT_EQ(run("truth view.draw both.draw --from entered --touching off --size 64x64"), 0);
  EXPECT_NE(out_.find("polygons in the planes of others: 1\n"), std::string::npos) << out_;
  for (const std::string method : {"z-buffer", "map", "bsp"}) {
    EXPECT_EQ(run("draw view.draw both.draw --size 64x64 -o b.png --ids b.npy --hidden " + method),
              0);
    EXPECT_EQ(run("compare e.npy b.npy"), 0) << method;
    EXPECT_EQ(run("draw view.draw both.draw --touching off --size 64x64 -o b.png --ids b.npy "
                  "--hidden " +
                  method),
              0);
    EXPECT_EQ(run("compare e.npy b.npy"), 0) << method;  // they coincide exactly
  }
  EXPECT_EQ(run("truth view.draw both.draw --size 64x64 --ids default.npy"), 0) << err_;
  EXPECT_EQ(out_, "");
  EXPECT_EQ(run("compare e.npy default.npy"), 0);
  expect_error("truth view.draw --from entered --touching on", "expected auto, off or LENGTH");
  expect_error("truth view.draw --from world --touching off",
               "--touching: expected --from display-file or entered");
  expect_error("truth view.draw --from entered --hidden franklin", "display-file coordinates");
}

TEST_F(TruthCommand, AndMarksRefuse) {
  write("t.draw", kTriangle);
  expect_error("truth t.draw --from wordl", "--from wordl: did you mean 'world'?");
  expect_error("truth t.draw --from", "--from");
  expect_error("truth t.draw --depth z.npy", "--ids is required");
  expect_error("truth t.draw --from world --ids nowhere/i.npy", "nowhere/i.npy");
  expect_error("truth t.draw --from world --ids i.npy --depth nowhere/z.npy", "nowhere/z.npy");
  expect_error("truth t.draw --ids nowhere/i.npy", "nowhere/i.npy");
  expect_error("truth t.draw --ids i.npy --depth nowhere/z.npy", "nowhere/z.npy");
  expect_error("truth t.draw --ids i.npy --size 0x5", "0x5");
  expect_error("truth missing.draw --ids i.npy", "missing.draw");
  EXPECT_EQ(run("truth t.draw"), 2);
  EXPECT_EQ(run("truth t.draw --size 4x4 --ids a.npy"), 0);
  EXPECT_EQ(run("truth t.draw --size 5x4 --ids b.npy"), 0);
  EXPECT_EQ(run("compare a.npy b.npy"), 1);
  expect_error("compare a.npy b.npy --marks m.png", "sizes differ");
  expect_error("compare a.npy a.npy --marks m.gif", "m.gif");
  expect_error("compare a.npy a.npy --marks nowhere/m.png", "nowhere/m.png");
  EXPECT_EQ(run("dump t.draw -o t.txt"), 0);
  expect_error("compare t.txt t.txt --marks m.png", "no pixels");
}

}  // namespace
