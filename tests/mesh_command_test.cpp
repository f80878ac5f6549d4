// Meshes on the command line: their colours, the reports on them, and names in either case.

#include <regex>
#include <sstream>
#include <string>

#include "tests/command_fixture.h"
#include "tests/foreign_models.h"
#include "tests/slower.h"

namespace {

/// In messages of builds without it.
constexpr const char* kHasNoImportLibrary = "built without the import library";

constexpr const char* kCorners = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n";
constexpr const char* kFaces = "usemtl red\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";

class MeshCommand : public Command {
 protected:
  MeshCommand() {
    write("m.mtl", "newmtl red\nKd 1 0 0\n");
    write("m.obj", std::string("mtllib m.mtl\n") + kCorners + kFaces);
    write("plain.obj", std::string(kCorners) + "f 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n");
  }
};

TEST_F(MeshCommand, ColourIsThatOfAllMeshes) {
  EXPECT_EQ(run("draw m.obj -o red.png"), 0) << err_;
  EXPECT_EQ(err_, "");
  EXPECT_EQ(run("draw plain.obj -o a.png --colour 1,0,0"), 0) << err_;
  EXPECT_EQ(run("compare red.png a.png"), 0) << out_;
  EXPECT_EQ(run("draw plain.obj -o a.png --colour red"), 0) << err_;
  EXPECT_EQ(run("compare red.png a.png"), 0) << out_;
  expect_error("draw plain.obj -o b.png --colour read", "--colour read: did you mean 'red'?");
  EXPECT_EQ(run("draw plain.obj -o grey.png"), 0) << err_;
  EXPECT_EQ(run("compare red.png grey.png"), 1);
  EXPECT_EQ(run("draw m.obj -o blue.png --colour 0,0,1"), 0) << err_;
  EXPECT_EQ(run("draw plain.obj -o a.png --colour 0,0,1.0"), 0) << err_;
  EXPECT_EQ(run("compare blue.png a.png"), 0) << "in place of the file's colours";
  EXPECT_EQ(run("import m.obj -o m.draw --colour 0,0,1"), 0) << err_;
  EXPECT_EQ(run("draw m.draw -o a.png"), 0) << err_;
  EXPECT_EQ(run("compare blue.png a.png"), 0) << out_;
  EXPECT_EQ(run("dump m.obj -o a.txt --colour 0,0,1"), 0) << err_;
  EXPECT_EQ(run("dump m.draw -o b.txt"), 0) << err_;
  EXPECT_EQ(run("compare a.txt b.txt"), 0) << out_;
  EXPECT_EQ(run("check m.obj --golden golden --update --colour 0,0,1"), 0) << err_;
  EXPECT_EQ(run("check m.obj --golden golden --colour 0,0,1"), 0) << out_;
  EXPECT_EQ(run("check m.obj --golden golden"), 1);
  write("blue.draw", "set-fill-style solid 0 0 1\n");
  EXPECT_EQ(run("draw blue.draw m.obj -o a.png --hidden auto"), 0) << err_;
  EXPECT_EQ(run("compare blue.png a.png"), 0) << "a program's fill style holds: " << out_;
  EXPECT_EQ(run("draw blue.draw m.obj -o a.png --hidden auto --colour 1,0,0"), 0) << err_;
  EXPECT_EQ(run("compare red.png a.png"), 0) << out_;
  EXPECT_EQ(run("draw m.obj -o t.png --turntable 2 --colour 0,0,1"), 0) << err_;
  EXPECT_EQ(run("draw plain.obj -o u.png --turntable 2 --colour 0,0,1"), 0) << err_;
  EXPECT_EQ(run("compare t-001.png u-001.png"), 0) << out_;
}

/// With --stats a display file is written and drawn; without, the mesh is viewed as it is retained.
TEST_F(MeshCommand, PicturesAreTheSameWithADisplayFileAndWithout) {
  write("mixed.off",
        "OFF\n6 4 0\n0 0 0\n1 0 0\n1 1 0.5\n0 1 0\n0 0 1\n2 2 2\n"
        "4 0 1 2 3\n3 0 1 4\n3 1 2 4 1 0 0\n3 0 5 4\n");
  for (const char* input : {"m.obj", "plain.obj", "mixed.off", "m.obj mixed.off"}) {
    for (const char* options :
         {"", "--shading gouraud", "--shading phong", "--hidden z-buffer",
          "--hidden scan-line --precision roundoff", "--scope segment", "--samples 3",
          "--eye 0.4,0.3,0.2 --look-at 1,1,0 --fov 70", "--background none", "--threads 3",
          "--hidden bsp", "--hidden none"}) {
      const std::string drawing = std::string("draw ") + input + " --size 97x64 " + options;
      ASSERT_EQ(run(drawing + " -o a.png --ids a.npy --depth ad.npy"), 0) << drawing << err_;
      const std::string said = err_;
      ASSERT_EQ(run(drawing + " -o b.png --ids b.npy --depth bd.npy --stats"), 0) << err_;
      EXPECT_EQ(std::regex_replace(err_, std::regex("b\\.png"), "a.png"), said);
      for (const char* rest : {".png", ".npy", "d.npy"}) {
        EXPECT_EQ(read(folder_ / (std::string("a") + rest)),
                  read(folder_ / (std::string("b") + rest)))
            << drawing << " " << rest;
      }
    }
  }
}

TEST_F(MeshCommand, SaysWhyNothingIsSeenWithADisplayFileAndWithout) {
  const std::string drawing = "draw plain.obj -o a.png --eye 9,9,9 --look-at 20,20,20 --fov 20";
  ASSERT_EQ(run(drawing), 0) << err_;
  const std::string said = err_;
  EXPECT_NE(said.find("nothing is seen"), std::string::npos) << said;
  EXPECT_EQ(run(drawing + " --stats"), 0) << err_;
  EXPECT_EQ(err_, said);
}

TEST_F(MeshCommand, ACreaseAngleKeepsSidesSharp) {
  write("m.obj",
        "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0.5 0.5 1\nf 1 2 5\nf 2 3 5\nf 3 4 5\nf 4 1 5\n");
  EXPECT_EQ(run("draw m.obj -o flat.png"), 0) << err_;
  EXPECT_EQ(run("draw m.obj -o a.png --shading gouraud"), 0) << err_;
  EXPECT_EQ(run("draw m.obj -o v.png --shading gouraud --turntable 2"), 0) << err_;
  EXPECT_EQ(run("draw m.obj -o c.png --shading gouraud --crease 20"), 0) << err_;
  EXPECT_EQ(run("compare c.png flat.png"), 0);  // the pyramid has no other sides
  EXPECT_EQ(run("import m.obj -o c.draw --shading gouraud --crease 20"), 0) << err_;
  EXPECT_EQ(run("draw c.draw -o d.png"), 0) << err_;
  EXPECT_EQ(run("compare c.png d.png"), 0);
  EXPECT_EQ(run("draw m.obj -o s.png --shading gouraud --crease 180"), 0) << err_;
  EXPECT_EQ(run("compare s.png a.png"), 0);
  EXPECT_EQ(run("draw m.obj -o w.png --shading gouraud --turntable 2 --crease 20"), 0) << err_;
  EXPECT_EQ(run("compare w-000.png v-000.png"), 1);
  const std::string check = "check m.obj --golden gold --picture --shading gouraud";
  EXPECT_EQ(run(check + " --crease 20 --update"), 0) << err_;
  EXPECT_EQ(run(check + " --crease 20"), 0) << err_;
  EXPECT_EQ(run(check), 1);
  expect_error("check m.obj --golden gold --crease 20", "--crease is of pictures");
}

TEST_F(MeshCommand, ACreaseAngleThatIsNoneOrHasNoEffectIsRefusedOrWarnedOf) {
  write("m.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  write("n.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0 0 1\nf 1//1 2//1 3//1\n");
  write("p.draw", "set-light 0 0 1\n");
  write("smooth.draw", "set-shading phong\nset-crease-angle 40\n");
  for (const char* bad : {"-1", "181", "nan", "inf", "sharp", "''", "30,"}) {
    expect_error("draw m.obj -o a.png --shading gouraud --crease " + std::string(bad), "--crease");
  }
  for (const char* command : {"draw m.obj -o a.png", "import m.obj -o a.draw"}) {
    expect_error(std::string(command) + " --crease 30",
                 "--crease 30 has no effect: expected --shading gouraud or phong too");
  }
  expect_error("draw p.draw -o a.png --shading gouraud --crease 30",
               "--crease 30 has no effect: expected a mesh");
  EXPECT_EQ(run("draw smooth.draw m.obj -o a.png --crease 30"), 0);
  EXPECT_EQ(err_, "");
  EXPECT_EQ(run("draw p.draw m.obj -o a.png --crease 30"), 0);
  EXPECT_EQ(err_, "m.obj: --crease has no effect: shading is flat where meshes are entered\n");
  EXPECT_EQ(run("draw n.obj -o a.png --crease 30 --shading phong"), 0);
  EXPECT_EQ(err_, "n.obj: the crease angle has no effect: the file has normals of all vertices\n");
}

TEST_F(MeshCommand, BadColoursAreRefused) {
  for (const char* bad :
       {"1", "1,0", "1,0,", "1,0,0,", "1,0,0,0", "1,0,0 ", "xyzzy", "1.5,0,0", "-0.1,0,0",
        "nan,0,0", "inf,0,0", "1;0;0", "0x1,0,0", "255,0,0", "1e999,0,0", ",,", "1,,0"}) {
    const std::string option = std::string("--colour '") + bad + "'";
    const std::string message = std::string("--colour ") + bad + ": expected red, green and blue";
    expect_error("draw m.obj -o x.png " + option, message);
    expect_error("import m.obj -o x.draw " + option, message);
    expect_error("dump m.obj " + option, message);
    expect_error("check m.obj --golden g --update " + option, message);
  }
  EXPECT_EQ(run("draw m.obj -o x.png --colour"), 2);
}

/// One line for each file with something to report, and the mesh is drawn.
TEST_F(MeshCommand, WhatIsNotDrawnIsSaidOnce) {
  write("t.mtl", "newmtl red\nKd 1 0 0\nmap_Kd a.png\nd 0.5\n");
  write("t.obj", std::string("mtllib t.mtl\n") + kCorners + kFaces + "l 1 2 3\n");
  write("gone.obj", std::string("mtllib nowhere.mtl\n") + kCorners + kFaces);
  EXPECT_EQ(run("draw t.obj gone.obj m.obj -o a.png"), 0);
  EXPECT_EQ(err_,
            "t.obj: left out: 2 points and lines, the textures of 4 faces, the transparency of 4 "
            "faces\ngone.obj: no material library 'nowhere.mtl' beside it\n");
  EXPECT_EQ(run("import t.obj -o a.draw"), 0);
  EXPECT_EQ(err_,
            "t.obj: left out: 2 points and lines, the textures of 4 faces, the transparency of 4 "
            "faces\n");
  write("bad.mtl", "newmtl red\nKd 1 nan 0\n");
  write("bad.obj", std::string("mtllib bad.mtl\n") + kCorners + kFaces);
  expect_error("draw bad.obj -o x.png", "bad.mtl:2:6: 'nan'");
}

TEST_F(MeshCommand, MaterialsWithoutANameAreNone) {
  write("t.mtl", "newmtl red\nKd 1 0 0\n");
  const std::string faces = "f 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";
  write("t.obj", "mtllib t.mtl\nusemtl\n" + (kCorners + faces));
  EXPECT_EQ(run("dump t.obj"), 0);
  EXPECT_EQ(err_, "");
  const std::string dumped = out_;
  EXPECT_EQ(run("dump plain.obj"), 0);
  EXPECT_EQ(out_, dumped);
}

TEST_F(MeshCommand, NoSegmentNameIsLeftForAMesh) {
  write("last.draw", "open-segment 2147483647\nclose-segment\n");
  expect_error("dump last.draw m.obj",
               "segment names 2147483648 to 2147483648: expected positive 32-bit numbers");
}

std::string in_utf16(const std::string& ascii, bool big_endian) {
  std::string text = big_endian ? "\xFE\xFF" : "\xFF\xFE";
  for (const char c : ascii) {
    if (big_endian) text += '\0';
    text += c;
    if (!big_endian) text += '\0';
  }
  return text;
}

TEST_F(MeshCommand, TextInUtf16IsNamedAsSuch) {
  for (const bool big_endian : {false, true}) {
    for (const char* extension : {"obj", "OFF", "ply", "stl", "ac", "x", "draw", "weird"}) {
      const std::string name = std::string("m.") + extension;
      write(name, in_utf16("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", big_endian));
      expect_error("draw " + name + " -o m.png", "UTF-16, expected UTF-8 text");
      EXPECT_TRUE(err_.starts_with("displayfile: " + name + ":")) << err_;
    }
  }
}

/// A limit is reported as a limit, whatever the file.
TEST_F(MeshCommand, ALimitIsNotTakenForUtf16) {
  write("m.dae", in_utf16("<COLLADA/>", false));
  EXPECT_EQ(run("draw m.dae -o m.png --import-seconds 0.000001"), 2);
  if (err_.find(kHasNoImportLibrary) != std::string::npos) GTEST_SKIP() << err_;
  EXPECT_NE(err_.find("--import-seconds"), std::string::npos) << err_;
  before_ = "DISPLAYFILE_IMPORT_PROGRAM=/nonexistent ";
  expect_error("draw m.dae -o m.png", "cannot be started");
}

/// The reason is from the reader of the extension's format, or there is none: the message of
/// another format's reader is of no use.
TEST_F(MeshCommand, RefusedFilesGetTheRightReadersReason) {
  write("m.ac", "nothing\n");
  if (run("draw m.ac -o m.png"); err_.find(kHasNoImportLibrary) != std::string::npos) {
    GTEST_SKIP() << err_;
  }
  expect_error("draw m.ac -o m.png", "m.ac: not a mesh that can be read: AC3D");
  for (const char* text :
       {"v 1 2 3\nvn\nusemtl x\nf 7 8 9\n", "BLENDER", "BLENDER magic", "#VRML"}) {
    write("m.wrl", text);
    expect_error("draw m.wrl -o m.png", "m.wrl: not a mesh that can be read: no reader takes .wrl");
    write("m", text);
    expect_error("draw m -o m.png", "m: not a mesh that can be read: no reader takes it, and its");
  }
}

TEST_F(MeshCommand, FormatsThatAreNotReadAreNamed) {
  write("part.dwg", "AC1032");
  const std::string message =
      "part.dwg: a DWG drawing, which is not read: export it as STL, OBJ, PLY or glTF";
  expect_error("draw part.dwg -o x.png", message);
  expect_error("import part.dwg -o x.draw", message);
}

/// A build may lack OpenCASCADE, and an installation its program.
TEST_F(MeshCommand, AStepFileThatCannotBeReadIsNamed) {
  write("part.step", "ISO-10303-21;\nHEADER;\nENDSEC;\nDATA;\nENDSEC;\nEND-ISO-10303-21;\n");
  ASSERT_EQ(run("--version"), 0);
  if (out_.find("OpenCASCADE") != out_.npos) {
    expect_error("draw part.step -o x.png",
                 "part.step: a STEP file, which this build does not read: it has no OpenCASCADE");
    EXPECT_NE(err_.find("libocct-data-exchange-dev"), err_.npos) << err_;
    return;
  }
  expect_error("draw part.step -o x.png", "part.step: not a STEP file that can be read: ");
  before_ = "DISPLAYFILE_IMPORT_CAD_PROGRAM=/nonexistent ";
  expect_error("draw part.step -o x.png", "cannot be started: /nonexistent: No such file");
  EXPECT_NE(err_.find("package displayfile-cad"), err_.npos) << err_;
}

class CadCommand : public Command {
 protected:
  static std::string model(const std::string& name) {
    return "'" DISPLAYFILE_SOURCE_DIR "/tests/meshes/" + name + "'";
  }
  static constexpr const char* kHasNoOpenCascade =
      "this build does not read: it has no OpenCASCADE";
};

/// The curved side has no edges, and where it meets the ends are its only creases.
TEST_F(CadCommand, ASheetOfAStepPart) {
  if (!can_run("sheet " + model("cylinder.step") + " -o sheet.svg", kHasNoOpenCascade)) {
    GTEST_SKIP() << err_;
  }
  EXPECT_EQ(err_, "");
  EXPECT_NE(read(folder_ / "sheet.svg").find("<svg"), std::string::npos);
}

TEST_F(CadCommand, ADeflectionIsALength) {
  write("m.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  for (const char* bad : {"0", "-1", "x", "nan", "1mm"}) {
    expect_error(std::string("draw m.obj -o m.png --deflection=") + bad,
                 std::string("--deflection ") + bad + ": expected a length, more than 0");
  }
  EXPECT_EQ(run("draw m.obj -o m.ppm --size 8x8 --deflection 0.1"), 0) << err_;
  EXPECT_EQ(err_, "m.obj: --deflection has no effect: it has polygons, no curved surfaces\n");
  const std::string sphere = "import " + model("sphere.step") + " -o ";
  if (!can_run(sphere + "fine.draw", kHasNoOpenCascade)) GTEST_SKIP() << err_;
  ASSERT_EQ(run(sphere + "rough.draw --deflection 0.5"), 0) << err_;
  EXPECT_GT(fs::file_size(folder_ / "fine.draw"), 10 * fs::file_size(folder_ / "rough.draw"));
}

TEST_F(MeshCommand, WhatIsLeftOutIsSaidOnce) {
  const auto gltf = [](const std::string& more) {
    return R"({"asset":{"version":"2.0"},"nodes":[{"mesh":0}],
        "meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],
        "accessors":[{"bufferView":0,"componentType":5121,"count":3,"type":"VEC3"}],
        "bufferViews":[{"buffer":0,"byteLength":9}],
        "buffers":[{"byteLength":9,"uri":"data:;base64,AAAAAQAAAAEA"}],)" +
           more + "}";
  };
  write("a.gltf", gltf(R"("animations":[{},{}])"));
  if (!can_run("draw a.gltf -o a.png", kHasNoImportLibrary)) GTEST_SKIP() << err_;
  EXPECT_EQ(err_, "a.gltf: left out: 2 animations\n");
  EXPECT_EQ(run("import a.gltf -o a.draw"), 0);
  EXPECT_EQ(err_, "a.gltf: left out: 2 animations\n");
  // Lengths on paper are in millimetres unless --unit is set.
  write("b.gltf", gltf(R"("extensionsUsed":[])"));
  const std::string metre = "b.gltf: left out: its unit, metre";
  const std::string at_scale = "draw b.gltf -o a.svg --paper a4 --parallel --scale 1:1";
  ASSERT_EQ(run(at_scale), 0) << err_;
  EXPECT_NE(err_.find(metre), std::string::npos) << err_;
  ASSERT_EQ(run(at_scale + " --unit mm"), 0) << err_;
  EXPECT_EQ(err_.find(metre), std::string::npos) << err_;
  ASSERT_EQ(run("sheet b.gltf -o a.svg"), 0) << err_;
  EXPECT_NE(err_.find(metre), std::string::npos) << err_;
  ASSERT_EQ(run("sheet b.gltf -o a.svg --unit m"), 0) << err_;
  EXPECT_EQ(err_.find(metre), std::string::npos) << err_;
  write("q.gltf", gltf(R"("extensionsRequired":["EXT_meshopt_compression"])"));
  expect_error("draw q.gltf -o x.png",
               "q.gltf: requires the glTF extension EXT_meshopt_compressio");
}

/// A library writes some of its messages to standard error itself, without a name.
TEST_F(MeshCommand, WhatAReaderSaysItselfIsToldWithTheFilesName) {
  write("m.ogex", "CameraObject {}\n");
  write("n.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  write("bad.ac", "nothing\n");
  if (run("draw m.ogex -o m.png"); err_.find(kHasNoImportLibrary) != std::string::npos) {
    GTEST_SKIP() << err_;
  }
  for (const char* command :
       {"draw m.ogex n.obj -o '{name}.png' --threads 1", "draw n.obj m.ogex -o '{name}.png'",
        "draw m.ogex -o m.png", "dump m.ogex", "import m.ogex -o m.draw"}) {
    EXPECT_EQ(run(command), 2);
    std::istringstream lines(err_);
    for (std::string line; std::getline(lines, line);) {
      EXPECT_TRUE(line.starts_with("m.ogex: ") || line.starts_with("displayfile: m.ogex: ") ||
                  line.starts_with("displayfile: 1 of 2") || line == "  m.ogex")
          << command << "\n"
          << line;
    }
    EXPECT_NE(err_.find("displayfile: m.ogex: not a mesh that can be read: it is empty\n"),
              std::string::npos)
        << command << "\n"
        << err_;
  }
  EXPECT_EQ(run("draw bad.ac m.ogex -o '{name}.png' --threads 1"), 2);
  EXPECT_NE(err_.find("m.ogex: not a mesh that can be read: it is empty\n"), std::string::npos)
      << err_;
}

TEST_F(MeshCommand, LimitsOfTheImportLibraryAreOptions) {
  write("hangs.smd", displayfile::test::smd_that_hangs());
  write("hungers.ac", displayfile::test::ac3d_that_hungers());
  write("good.ac", displayfile::test::ac3d("0 0 0\n1 0 0\n1 1 0\n"));
  if (!can_run("draw good.ac -o a.png", kHasNoImportLibrary)) GTEST_SKIP() << err_;
  for (const std::string command :
       {"draw IN -o x.png", "dump IN", "import IN -o x.draw", "check IN --golden g --update",
        "truth IN --size 9x9 --ids x.npy", "sheet IN -o x.svg"}) {
    const auto with = [&](const std::string& input, const std::string& options) {
      std::string line = command;
      return line.replace(line.find("IN"), 2, input) + " " + options;
    };
    expect_error(with("hangs.smd", "--import-seconds 0.2"),
                 "hangs.smd: the import library (Assimp) reached the limit of 0.2 seconds: "
                 "--import-seconds");
    expect_error(with("hungers.ac", "--import-memory 64M"),
                 "hungers.ac: the import library (Assimp) reached the limit of 64 MiB of memory: "
                 "--import-memory");
    for (const char* bad : {"0", "-1", "x", "nan", "1,2"}) {
      expect_error(with("good.ac", std::string("--import-seconds=") + bad),
                   std::string("--import-seconds ") + bad + ": expected seconds, more than 0");
    }
    for (const char* bad : {"0M", "512", "-1G", "M", "1T", "nanM", "1e30G", "x"}) {
      expect_error(
          with("good.ac", std::string("--import-memory=") + bad),
          std::string("--import-memory ") + bad + ": expected bytes with K, M or G, such as 512M");
    }
    EXPECT_EQ(run(with("good.ac", "--import-memory 1.5G --import-seconds 100 --any-format")), 0)
        << command << err_;
    for (const char* written : {"x.png", "x.draw", "x.npy", "x.svg", "g"}) {
      fs::remove_all(folder_ / written);
    }
  }
}

/// The command lends the library its memory, and has that much less meanwhile.
TEST_F(MeshCommand, TheLimitOfMemoryIsTheLibrarysToo) {
  write("hungers.ac", displayfile::test::ac3d_that_hungers());
  write("good.ac", displayfile::test::ac3d("0 0 0\n1 0 0\n1 1 0\n"));
  if (!can_run("draw good.ac -o a.png", kHasNoImportLibrary)) GTEST_SKIP() << err_;
  if (displayfile::test::kSlower > 1) GTEST_SKIP() << "a sanitizer has more memory than this";
  fs::remove(folder_ / "a.png");
  expect_error("draw hungers.ac -o x.png --limit-memory 100M",
               "of memory: --limit-memory, which leaves no more, sets another");
  EXPECT_EQ(run("draw good.ac good.ac good.ac good.ac -o '{number}.png' --limit-memory 100M"), 0)
      << err_;
}

TEST_F(MeshCommand, ExtensionsMayBeInEitherCase) {
  write("M.OBJ", read(folder_ / "m.obj"));
  EXPECT_EQ(run("draw m.obj -o a.png --ids a.npy"), 0) << err_;
  EXPECT_EQ(run("draw M.OBJ -o B.PNG --ids B.NPY"), 0) << err_;
  EXPECT_EQ(run("compare a.png B.PNG"), 0) << out_;
  EXPECT_EQ(run("compare B.NPY a.npy --marks C.Png"), 0) << out_;
  EXPECT_EQ(read(folder_ / "B.PNG"), read(folder_ / "a.png"));
  EXPECT_EQ(run("import M.OBJ -o P.DRAW"), 0) << err_;
  EXPECT_EQ(run("draw P.DRAW -o c.Svg"), 0) << err_;
  EXPECT_EQ(run("draw P.DRAW -o d.svg"), 0) << err_;
  EXPECT_EQ(read(folder_ / "c.Svg"), read(folder_ / "d.svg"));
  EXPECT_EQ(run("draw m.obj -o T.PNG --turntable 2"), 0) << err_;
  EXPECT_TRUE(fs::exists(folder_ / "T-001.PNG"));
  EXPECT_EQ(run("dump P.DRAW -o a.txt"), 0) << err_;
  expect_error("draw m.obj -o a.GIF", "unknown picture format '.GIF'");
}

}  // namespace
