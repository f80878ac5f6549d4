#include <map>
#include <regex>
#include <set>
#include <sstream>

#include "tests/command_fixture.h"

namespace {

using Words = std::set<std::string>;

class Completion : public Command {
 protected:
  /// The words that are offered for the last typed one, without descriptions.
  Words offered(const std::string& typed) {
    EXPECT_EQ(run("--complete " + typed), 0) << typed << "\n" << err_;
    Words words;
    std::istringstream lines(out_);
    for (std::string line; std::getline(lines, line);) {
      if (!line.starts_with(':')) words.insert(line.substr(0, line.find('\t')));
    }
    return words;
  }

  /// The files that the shell finds by itself.
  std::string found_by_shell(const std::string& typed) {
    EXPECT_EQ(run("--complete " + typed), 0) << typed << "\n" << err_;
    return out_.starts_with(':') ? out_.substr(0, out_.find('\n')) : "";
  }

  Words options_of_help(const std::string& subcommand) {
    EXPECT_EQ(run(subcommand + " --help"), 0) << err_;
    const std::regex name("--[a-z][a-z-]*");
    Words options;
    std::istringstream lines(out_);
    for (std::string line; std::getline(lines, line);) {
      if (!line.starts_with("  -")) continue;
      const std::string names = line.substr(2, line.find(' ', 2) - 2);
      for (std::sregex_iterator at(names.begin(), names.end(), name), end; at != end; ++at) {
        options.insert(at->str());
      }
    }
    return options;
  }

  Words words_expected(const std::string& message) const;

  void write_inputs() {
    write("t.draw", kTriangle);
    write("surface.draw", "open-segment 1\nsurface-3 0 1 2 0 1 2  0 0 0 0.5\nclose-segment\n");
    write("n.obj", "v 2 0 1\nv 3 0 1\nv 2 1 1\nf 1 2 3\n");
    write("m.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n");
  }

  /// Commands that are right, each subcommand's.
  const std::map<std::string, std::vector<std::string>> kRight{
      {"draw",
       {"draw m.obj -o -", "draw m.obj -o x.svg", "draw surface.draw -o x.svg",
        "draw m.obj -o '{name}.svg'", "draw m.obj -o x.svg --parallel --paper a4 --scale 1:100",
        "draw m.obj -o x.svg --pens", "draw m.obj n.obj -o x.svg"}},
      {"dump", {"dump m.obj", "dump surface.draw"}},
      {"check",
       {"check m.obj --golden g --picture --update", "check m.obj --golden g --update",
        "check surface.draw --golden g --update"}},
      {"truth",
       {"truth m.obj --hidden appel", "truth m.obj --ids x.npy", "truth m.obj",
        "truth surface.draw", "truth m.obj --from entered"}},
      {"compare", {"compare t.draw t.draw"}},
      {"import", {"import m.obj -o x.draw"}},
      {"export", {"export m.obj -o x.stl", "export m.obj -o x.ply"}},
      {"surface", {"surface x -o x.svg", "surface x -o x.png", "surface x -o x.svg --pens"}},
      {"sheet", {"sheet m.obj -o x.svg"}},
  };
};

/// The words that a message expects.
Words Completion::words_expected(const std::string& message) const {
  static const Words kSentence{
      "above", "along", "at",   "axis",    "factor",     "first",    "most",  "a",    "after",
      "and",   "as",    "blue", "cases",   "each",       "family",   "green", "hard", "in",
      "it",    "name",  "of",   "one",     "or",         "parts",    "red",   "some", "such",
      "the",   "to",    "with", "without", "-landscape", "-portrait"};
  std::smatch found;
  Words words;
  const std::regex sentence("(expected|[a-z] is|[a-z] are) (.*?)(, not '.*)?\n");
  if (!std::regex_search(message, found, sentence)) return words;
  std::string text = found[2].str();
  std::ranges::replace_if(
      text, [](char c) { return c == ',' || c == ';'; }, ' ');
  std::istringstream tokens(text);
  const std::regex word("\\.?(-?[a-z][a-z0-9=-]*)([A-Z]+)?");
  for (std::string token; tokens >> token;) {
    if (!std::regex_match(token, found, word)) continue;
    if (!kSentence.contains(found[1])) words.insert(found[1]);
  }
  return words;
}

TEST_F(Completion, OffersTheSubcommandsAndOptionsOfHelp) {
  const Words subcommands = offered("''");
  EXPECT_TRUE(subcommands.contains("draw"));
  EXPECT_TRUE(subcommands.contains("bench"));
  for (const std::string& subcommand : subcommands) {
    ASSERT_EQ(run("--help"), 0);
    EXPECT_NE(out_.find("\n  " + subcommand + " "), out_.npos) << subcommand;
    const Words options = options_of_help(subcommand);
    EXPECT_GE(options.size(), 3u) << subcommand;
    EXPECT_EQ(offered(subcommand + " --"), options) << subcommand;
  }
  EXPECT_EQ(offered("-"), options_of_help(""));
  EXPECT_EQ(offered("nothing --"), Words{});
}

/// Every offered word is accepted, and every expected one in a message is offered.
TEST_F(Completion, OffersTheWordsThatTheCommandTakes) {
  write_inputs();
  ASSERT_EQ(run("--version"), 0);
  const bool has_osmesa = out_.find("OSMesa                   not found") == out_.npos;
  int tried = 0;
  for (const auto& [subcommand, right] : kRight) {
    for (const std::string& option : offered(subcommand + " --")) {
      const Words words = offered(subcommand + " " + option + " ''");
      for (const std::string& word : words) {
        if (word == "osmesa" && !has_osmesa) continue;
        const char* const number = option == "--section"  ? "0.5"  // within the box
                                   : option == "--detail" ? "0.1,0.1,0.2@1:1"
                                   : option == "--lines"  ? "1"
                                                          : "0";
        const std::string value = word.ends_with('=') ? word + number : word;
        const bool taken = std::ranges::any_of(right, [&](const std::string& command) {
          return run(command + " " + option + " " + value) == 0;
        });
        const bool is_known = taken || err_.find("needs world coordinates") != err_.npos;
        EXPECT_TRUE(is_known) << subcommand << " " << option << " " << value << "\n" << err_;
        ++tried;
      }
      if (words.empty()) continue;
      if (subcommand == "truth" && option == "--hidden") continue;  // methods of lines alone
      run(right.front() + " " + option + " zzz");
      for (std::string expected : words_expected(err_)) {
        if (!words.contains(expected) && expected.ends_with('=')) expected.pop_back();
        if (words.contains(expected + "=")) continue;
        EXPECT_TRUE(words.contains(expected) || expected == "mm") << expected << " of " << err_;
      }
    }
  }
  EXPECT_GT(tried, 200);
}

TEST_F(Completion, OffersTheScenesAndMethodsOfBenchmarks) {
  EXPECT_EQ(run("bench zzz"), 2);
  const Words scenes = offered("bench ''");
  for (const std::string& scene : words_expected(err_)) {
    if (scene != "drawing" && scene != "program" && scene != "mesh" && scene != "default") {
      EXPECT_TRUE(scenes.contains(scene)) << scene << " of " << err_;
    }
  }
  EXPECT_TRUE(scenes.contains("city"));
  EXPECT_EQ(run("bench --methods zzz"), 2);
  const Words methods = words_expected(err_);
  EXPECT_GT(methods.size(), 10u);
  EXPECT_EQ(offered("bench --methods ''"), methods);
}

TEST_F(Completion, OffersWhatMayStandAtThePlace) {
  EXPECT_EQ(offered("draw --hidden bs"), Words{"bsp"});
  EXPECT_EQ(offered("draw --hidden=bs"), Words{"--hidden=bsp"});
  EXPECT_EQ(offered("draw --hidden colour-rule=b"),
            (Words{"colour-rule=back-face", "colour-rule=bsp"}));
  EXPECT_EQ(offered("draw --lines outline,bo"), Words{"outline,boundary"});
  EXPECT_FALSE(offered("draw --lines outline,").contains("outline,outline"));
  EXPECT_EQ(offered("draw --up -z"), Words{"-z"});       // a value, that looks like an option
  EXPECT_EQ(offered("draw -o out.svg --out"), Words{});  // there may be only one
  EXPECT_EQ(offered("sheet part.obj --section front=0 --sec"), Words{"--section"});
  EXPECT_EQ(offered("sheet part.obj --section front=0 si"), Words{"side="});
  EXPECT_EQ(offered("draw -- --"), Words{});  // inputs alone
  EXPECT_EQ(offered("truth --hidden ''"),
            (Words{"appel", "franklin", "perimeter", "plain-appel", "roberts"}));
  EXPECT_EQ(offered("draw --samples ''"), Words{});
  EXPECT_EQ(offered("help dr"), Words{"draw"});
  EXPECT_EQ(offered("help draw ''"), Words{});
}

TEST_F(Completion, LeavesFilesToTheShell) {
  EXPECT_EQ(found_by_shell("draw -o ''"), ":files png ppm svg pdf eps dxf");
  EXPECT_EQ(found_by_shell("draw --output=x"), ":files png ppm svg pdf eps dxf");
  EXPECT_EQ(found_by_shell("draw --ids ''"), ":files npy");
  EXPECT_EQ(found_by_shell("compare a ''"), ":files ");
  EXPECT_EQ(found_by_shell("compare a b ''"), "");
  EXPECT_EQ(found_by_shell("check t.draw --golden ''"), ":files ");
  EXPECT_NE(out_.find("\n:folders\n"), out_.npos);
  const std::string inputs = found_by_shell("draw ''");
  for (const char* extension : {" draw", " obj", " off", " ply", " stl"}) {
    EXPECT_NE((inputs + " ").find(std::string(extension) + " "), inputs.npos) << inputs;
  }
  EXPECT_EQ(found_by_shell("import ''").find(" draw"), inputs.npos);
}

/// A build without the import library, or OpenCASCADE, offers the extensions that it reads.
TEST_F(Completion, OffersMeshesThatAreRead) {
  ASSERT_EQ(run("--version"), 0);
  const bool has_library = out_.find("(Assimp)  not found") == out_.npos;
  const bool has_cad = out_.find("OpenCASCADE") == out_.npos;  // "built without ..."
  const std::string inputs = found_by_shell("draw ''");
  EXPECT_EQ(inputs.find(" 3ds ") != inputs.npos, has_library);
  const auto offers = [&](const char* extension) {
    return (inputs + " ").find(extension) != inputs.npos;
  };
  for (const char* extension : {" iges ", " igs "}) EXPECT_EQ(offers(extension), has_cad);
  // The import library's buildings may be named so, too.
  for (const char* extension : {" step ", " stp "}) {
    EXPECT_EQ(offers(extension), has_cad || has_library) << extension;
  }
}

TEST_F(Completion, TellsWhatAnOptionIs) {
  ASSERT_EQ(run("--complete draw --seam"), 0);
  EXPECT_EQ(out_, "--seams\tadjacent visible surfaces in vectors\n");
}

/// The same on every machine, and escaped.
TEST_F(Completion, ManualPagesSayWhatHelpSays) {
  for (const std::string& subcommand : offered("''")) {
    const Words options = options_of_help(subcommand);
    ASSERT_EQ(run("--manual " + subcommand), 0) << err_;
    for (std::string option : options) {
      for (auto at = option.find('-'); at != option.npos; at = option.find('-', at + 2)) {
        option.insert(at, "\\");
      }
      EXPECT_NE(out_.find("\\fB" + option + "\\fR"), out_.npos) << subcommand << " " << option;
    }
    EXPECT_EQ(out_.find(", here "), out_.npos);
  }
  ASSERT_EQ(run("--manual draw"), 0);
  EXPECT_NE(out_.find("\\fB\\-\\-samples\\fR \\fIN\\fR\n"), out_.npos) << out_;
  EXPECT_NE(out_.find("; 1 to 16; 4 if not"), out_.npos) << out_;
  EXPECT_NE(out_.find("\\fBroundoff\\fR[=\\fIEPS\\fR]"), out_.npos) << out_;
}

}  // namespace
