#include "displayfile/mesh/cad/cad_document.h"

#include <fmt/format.h>

#include <IGESCAFControl_Reader.hxx>
#include <IGESControl_Controller.hxx>
#include <IGESData_GlobalSection.hxx>
#include <IGESData_IGESModel.hxx>
#include <Interface_Check.hxx>
#include <Interface_CheckIterator.hxx>
#include <Interface_InterfaceModel.hxx>
#include <Interface_Static.hxx>
#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <Message_Printer.hxx>
#include <NCollection_DataMap.hxx>
#include <STEPCAFControl_Controller.hxx>
#include <STEPCAFControl_ExternFile.hxx>
#include <STEPCAFControl_Reader.hxx>
#include <TColStd_SequenceOfAsciiString.hxx>
#include <TCollection_HAsciiString.hxx>
#include <XCAFDoc_DocumentTool.hxx>
#include <XSControl_TransferReader.hxx>
#include <XSControl_WorkSession.hxx>
#include <algorithm>
#include <cctype>
#include <fstream>
#include <string_view>

#include "clip/base/error.h"
#include "displayfile/mesh/import_losses.h"
#include "displayfile/text/characters.h"

namespace displayfile {

namespace {

[[noreturn]] void fail(const std::string& path, CadFormat format, const std::string& why) {
  throw Error(fmt::format("{}: not {} {} file that can be read: {}", path,
                          format == CadFormat::step ? "a" : "an", name_of(format), why));
}

// ---- Messages --------------------------------------------------------------------------

/// In the place of what prints the library's messages: keeps those about errors.
class KeptErrors : public Message_Printer {
 public:
  const std::vector<std::string>& errors() const { return errors_; }

 protected:
  void send(const TCollection_AsciiString& message, Message_Gravity gravity) const override {
    const std::string_view text = message.ToCString();
    if (gravity < Message_Alarm && text.find(" ERR ") == text.npos) return;
    constexpr std::size_t kMost = 100;
    if (errors_.size() < kMost) errors_.emplace_back(text);
  }

 private:
  mutable std::vector<std::string> errors_;
};

opencascade::handle<KeptErrors> keep_errors() {
  opencascade::handle<KeptErrors> kept = new KeptErrors;
  const auto& messenger = Message::DefaultMessenger();
  messenger->ChangePrinters().Clear();
  messenger->AddPrinter(kept);
  return kept;
}

/// A message such as "**** ERR StepFile : Undefined Parsing: Line 2: Incorrect syntax  ****", from
/// its line on.
std::string reason_in(std::string_view message) {
  const std::size_t line = message.find("Line ");
  if (line != message.npos) message.remove_prefix(line);
  constexpr std::string_view kAround = " *\n:";
  const std::size_t first = std::min(message.find_first_not_of(kAround), message.size());
  message.remove_prefix(first);
  message = message.substr(0, message.find_last_not_of(kAround) + 1);
  std::string reason = drawable(message);
  if (!reason.empty()) reason[0] = static_cast<char>(std::tolower(reason[0]));
  return reason;
}

/// The number at the end of "Unresolved Reference : Fails Count : 3 ***".
std::string count_in(std::string_view message) {
  constexpr std::string_view kCount = "Count : ";
  const std::size_t at = message.find(kCount);
  if (at == message.npos) return "some";
  message.remove_prefix(at + kCount.size());
  return std::string(message.substr(0, message.find_first_not_of("0123456789")));
}

/// Refuses invalid syntax; references to nothing become warnings.
void judge(const std::string& path, CadFormat format, const KeptErrors& kept,
           std::vector<std::string>& warnings) {
  for (const std::string& error : kept.errors()) {
    if (error.find("Unresolved Reference") != error.npos) {
      warnings.push_back(
          fmt::format("left out: {} references to entities that are not in it", count_in(error)));
    } else if (error.find("Incorrect Syntax") != error.npos) {
      fail(path, format, fmt::format("incorrect syntax at {} places", count_in(error)));
    }
  }
}

/// The entities with errors, in the model or on their way to shapes, each with its first error.
void add_failed(const opencascade::handle<XSControl_WorkSession>& session, CadFormat format,
                std::vector<std::string>& warnings) {
  const auto& model = session->Model();
  Interface_CheckIterator checks = session->ModelCheckList(Standard_False);
  if (!session->TransferReader().IsNull()) {
    Interface_CheckIterator transfers = session->TransferReader()->LastCheckList();
    checks.Merge(transfers);
  }
  std::size_t n = 0;
  std::string first;
  for (checks.Start(); checks.More(); checks.Next()) {
    if (checks.Value()->NbFails() == 0) continue;
    if (n++ > 0) continue;
    const int number = checks.Number();
    if (number > 0 && number <= model->NbEntities()) {
      first = model->StringLabel(model->Value(number))->ToCString();
      first += ": ";
    }
    first += checks.Value()->CFail(1);
  }
  if (n == 0) return;
  warnings.push_back(fmt::format("left out: {} of {} with errors, the first {}",
                                 n == 1 ? "1 entity" : fmt::format("{} entities", n),
                                 name_of(format), drawable(first)));
}

// ---- Units -----------------------------------------------------------------------------

/// Names of units in STEP files, in lower case, and the number and name by which the library reads
/// lengths in them. IGES 5.3, 2.2.4.3.14 has the same numbers.
struct Unit {
  std::string_view in_step;
  int number;
  const char* name;
};
constexpr Unit kUnits[] = {{"inch", 1, "inch"},
                           {"inches", 1, "inch"},
                           {"in", 1, "inch"},
                           {"millimetre", 2, "millimetre"},
                           {"foot", 4, "foot"},
                           {"feet", 4, "foot"},
                           {"ft", 4, "foot"},
                           {"mile", 5, "mile"},
                           {"metre", 6, "metre"},
                           {"kilometre", 7, "kilometre"},
                           {"mil", 8, "mil"},
                           {"micrometre", 9, "micrometre"},
                           {"centimetre", 10, "centimetre"},
                           {"microinch", 11, "microinch"}};
constexpr int kMillimetre = 2;

/// Lengths of files that are read from now on stay in this unit.
void read_lengths_in(int unit) { Interface_Static::SetIVal("xstep.cascade.unit", unit); }

void warn_of_unit(int unit, std::vector<std::string>& warnings) {
  if (unit == kMillimetre) return;
  const auto* const found = std::ranges::find(kUnits, unit, &Unit::number);
  warnings.push_back(
      fmt::format("left out: its unit, {}: --unit sets that of a sheet or scale", found->name));
}

// ---- STEP ------------------------------------------------------------------------------

/// The library reads a file that was cut off between two entities as if it were whole.
void require_end_of_step(const std::string& path) {
  constexpr std::streamoff kTail = 4096;
  std::ifstream in(path, std::ios::binary | std::ios::ate);
  const std::streamoff size = in.tellg();
  std::string tail(static_cast<std::size_t>(std::clamp<std::streamoff>(size, 0, kTail)), '\0');
  in.seekg(std::max<std::streamoff>(size - kTail, 0));
  in.read(tail.data(), static_cast<std::streamsize>(tail.size()));
  if (tail.find("END-ISO-10303-21") != tail.npos) return;
  fail(path, CadFormat::step, "it ends too early: expected END-ISO-10303-21;");
}

/// The unit of the file's first context; the library converts lengths of others to it.
int unit_of(STEPControl_Reader& reader, std::vector<std::string>& warnings) {
  TColStd_SequenceOfAsciiString lengths, angles, solid_angles;
  reader.FileUnits(lengths, angles, solid_angles);
  if (lengths.IsEmpty()) return kMillimetre;
  std::string name = lengths.First().ToCString();
  std::ranges::transform(name, name.begin(), [](unsigned char c) { return std::tolower(c); });
  const auto* const found = std::ranges::find(kUnits, name, &Unit::in_step);
  if (found != std::end(kUnits)) return found->number;
  warnings.push_back(
      fmt::format("its unit, {}, is not known: lengths are in millimetres", drawable(name)));
  return kMillimetre;
}

/// Parts that stand in files of their own.
void add_missing_files(const STEPCAFControl_Reader& reader, std::vector<std::string>& warnings) {
  std::size_t n = 0;
  std::string first;
  for (NCollection_DataMap<TCollection_AsciiString,
                           opencascade::handle<STEPCAFControl_ExternFile>>::Iterator
           file(reader.ExternFiles());
       file.More(); file.Next()) {
    if (file.Value()->GetLoadStatus() == IFSelect_RetDone) continue;
    if (n++ == 0) first = drawable(file.Key().ToCString());
  }
  if (n == 0) return;
  warnings.push_back(fmt::format("left out: {} that cannot be read, the first {}",
                                 n == 1 ? "1 file of parts" : fmt::format("{} files of parts", n),
                                 first));
}

CadDocument read_step(const std::string& path, const KeptErrors& kept) {
  constexpr CadFormat kFormat = CadFormat::step;
  require_end_of_step(path);
  STEPCAFControl_Reader reader;
  if (reader.ReadFile(path.c_str()) != IFSelect_RetDone) {
    fail(path, kFormat, kept.errors().empty() ? "it is invalid" : reason_in(kept.errors().front()));
  }
  CadDocument document;
  judge(path, kFormat, kept, document.warnings);
  const int unit = unit_of(reader.ChangeReader(), document.warnings);
  read_lengths_in(unit);
  warn_of_unit(unit, document.warnings);
  document.shapes = new TDocStd_Document("XCAF");
  XCAFDoc_DocumentTool::Set(document.shapes->Main());
  reader.SetGDTMode(Standard_False);
  if (!reader.Transfer(document.shapes)) fail(path, kFormat, "it has no shapes");
  add_failed(reader.Reader().WS(), kFormat, document.warnings);
  add_missing_files(reader, document.warnings);
  return document;
}

// ---- IGES ------------------------------------------------------------------------------

const IGESData_GlobalSection& global_section(const IGESCAFControl_Reader& reader) {
  return opencascade::handle<IGESData_IGESModel>::DownCast(reader.WS()->Model())->GlobalSection();
}

/// IGES 5.3, 2.2.4.6: the last line is of the terminate section.
void require_end_of_iges(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  std::string line, last;
  while (std::getline(in, line)) {
    if (line.find_first_not_of(" \r") != line.npos) last = line;
  }
  constexpr std::size_t kSection = 72;
  if (last.size() > kSection && last[kSection] == 'T') return;
  fail(path, CadFormat::iges,
       "it ends too early: expected a last line of the terminate section, T in column 73");
}

CadDocument read_iges(const std::string& path, const KeptErrors& kept) {
  constexpr CadFormat kFormat = CadFormat::iges;
  require_end_of_iges(path);
  IGESCAFControl_Reader reader;
  const auto read = [&] {
    if (reader.ReadFile(path.c_str()) == IFSelect_RetDone) return;
    fail(path, kFormat, kept.errors().empty() ? "it is invalid" : reason_in(kept.errors().front()));
  };
  read();
  CadDocument document;
  const int unit = global_section(reader).UnitFlag();
  const bool is_known = std::ranges::find(kUnits, unit, &Unit::number) != std::end(kUnits);
  if (!is_known) {
    document.warnings.push_back(
        fmt::format("its unit, {}, is not known: lengths are in millimetres", unit));
  } else if (unit != kMillimetre) {
    warn_of_unit(unit, document.warnings);
    read_lengths_in(unit);
    read();  // lengths are converted as they are read
  }
  judge(path, kFormat, kept, document.warnings);
  document.resolution = global_section(reader).Resolution();
  document.shapes = new TDocStd_Document("XCAF");
  XCAFDoc_DocumentTool::Set(document.shapes->Main());
  if (!reader.Transfer(document.shapes)) fail(path, kFormat, "it has no shapes");
  add_failed(reader.WS(), kFormat, document.warnings);
  return document;
}

}  // namespace

CadDocument read_cad_document(const std::string& path, CadFormat format) {
  const opencascade::handle<KeptErrors> kept = keep_errors();
  return format == CadFormat::step ? read_step(path, *kept) : read_iges(path, *kept);
}

void load_cad_readers() {
  STEPCAFControl_Controller::Init();
  IGESControl_Controller::Init();
}

}  // namespace displayfile
