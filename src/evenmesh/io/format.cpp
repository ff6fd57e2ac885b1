// SPDX-License-Identifier: MIT
#include "evenmesh/io/format.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <filesystem>
#include <string>

#include <fmt/core.h>

#include "evenmesh/base/text.h"
#include "evenmesh/io/exodus.h"
#include "evenmesh/io/inp.h"
#include "evenmesh/io/medit.h"
#include "evenmesh/io/meshb.h"
#include "evenmesh/io/msh.h"
#include "evenmesh/io/nastran.h"
#include "evenmesh/io/nastran_cards.h"
#include "evenmesh/io/netcdf_header.h"
#include "evenmesh/io/obj.h"
#include "evenmesh/io/off.h"
#include "evenmesh/io/ply.h"
#include "evenmesh/io/stl_ascii.h"
#include "evenmesh/io/stl_binary.h"
#include "evenmesh/io/su2.h"
#include "evenmesh/io/text_scan.h"
#include "evenmesh/io/ucd.h"
#include "evenmesh/io/vtk.h"
#include "evenmesh/io/vtk_xml.h"

namespace evenmesh {
namespace {

/// So much of a file is looked at to see whether it is text, and to find its first words.
constexpr std::size_t kLookAt = 4096;

constexpr std::string_view kReads =
    "evenmesh reads OBJ, STL, OFF, PLY, Gmsh MSH, MEDIT (.mesh, .meshb), VTK (.vtk, .vtu, .vtp), "
    "SU2, AVS UCD, Exodus and the decks of Abaqus, CalculiX and Nastran, and all of them "
    "compressed with "
    "gzip";

/// Makes a reader that has no options one that has.
template <MeshFile (*read)(std::shared_ptr<const InputFile>)>
MeshFile without_options(std::shared_ptr<const InputFile> input, const ReadOptions&) {
  return read(std::move(input));
}

constexpr std::array kFormats{
    FormatTraits{Format::obj, "obj", "an OBJ file", ".obj", without_options<read_obj>},
    FormatTraits{Format::stl_ascii, "stl_ascii", "an STL file", ".stl", read_stl_ascii},
    FormatTraits{Format::stl_binary, "stl_binary", "an STL file", ".stl", read_stl_binary},
    FormatTraits{Format::off, "off", "an OFF file", ".off", without_options<read_off>},
    FormatTraits{Format::ply, "ply", "a PLY file", ".ply", without_options<read_ply>},
    FormatTraits{Format::msh, "msh", "a Gmsh file", ".msh", without_options<read_msh>},
    FormatTraits{Format::medit, "medit", "a MEDIT file", ".mesh", without_options<read_medit>},
    FormatTraits{Format::meshb, "meshb", "a binary MEDIT file", ".meshb",
                 without_options<read_meshb>},
    FormatTraits{Format::su2, "su2", "an SU2 file", ".su2", without_options<read_su2>},
    FormatTraits{Format::vtk, "vtk", "a legacy VTK file", ".vtk", without_options<read_vtk>},
    FormatTraits{Format::vtu, "vtu", "a VTU file", ".vtu", without_options<read_vtu>},
    FormatTraits{Format::vtp, "vtp", "a VTP file", ".vtp", without_options<read_vtp>},
    FormatTraits{Format::inp, "inp", "an Abaqus or CalculiX deck", ".inp",
                 without_options<read_inp>},
    FormatTraits{Format::nastran, "nastran", "a Nastran deck", ".bdf .nas .fem .dat",
                 without_options<read_nastran>},
    FormatTraits{Format::exodus, "exodus", "an Exodus file", ".e .exo .ex2 .exii .g .gen",
                 without_options<read_exodus>},
    FormatTraits{Format::ucd, "ucd", "a UCD file", ".inp", without_options<read_ucd>},
};

/// How a file of a format begins that is known but not read. Case does not matter.
struct Signature {
  std::string_view begin;
  std::string_view what;
};
constexpr std::array kSignatures{
    Signature{"$nod\n", "a Gmsh mesh of version 1; save it with 'gmsh -save -format msh41'"},
    Signature{"$nod\r", "a Gmsh mesh of version 1; save it with 'gmsh -save -format msh41'"},
    Signature{"mfem ", "an MFEM mesh; save it as VTK from MFEM"},
    Signature{"<?xml", "an XML file, but none of VTK"},
    Signature{"foamfile", "an OpenFOAM file"},
    Signature{"BZh", "compressed with bzip2; unpack it with bunzip2 first"},
    Signature{"\xfd"
              "7zXZ",
              "compressed with xz; unpack it with unxz first"},
    Signature{"PK\x03\x04", "a zip archive, perhaps 3MF; unpack it first"},
    Signature{
        "\x89HDF",
        "an HDF5 file (MED, CGNS, or Exodus in netCDF-4, of which 'nccopy -k cdf5 IN OUT' makes "
        "one that is read)"},
    Signature{"glTF", "a glTF file (.glb)"},
    Signature{"Kaydara FBX", "an FBX file (.fbx)"},
};

/// Suffixes of formats whose content has no reliable beginning.
constexpr std::array kSuffixes{
    Signature{".msh", "a .msh file, but not Gmsh's"},
    Signature{".mesh", "a .mesh file, but not MEDIT's"},
    Signature{".inp", "a .inp file, but neither a deck of Abaqus or CalculiX nor AVS UCD"},
    Signature{".ugrid", "a UGRID file"},
    Signature{".cgns", "a CGNS file"},
    Signature{".exo", "a .exo file, but not netCDF"},
    Signature{".med", "a MED file"},
    Signature{".k", "an LS-DYNA deck"},
    Signature{".unv", "an I-DEAS universal file"},
};

constexpr std::array<std::string_view, 33> kObjKeywords{
    "v",     "vt",    "vn",     "vp",     "f",      "fo",        "l",      "p",   "o",
    "g",     "s",     "usemtl", "mtllib", "usemap", "maplib",    "cstype", "deg", "curv",
    "curv2", "surf",  "parm",   "trim",   "hole",   "scrv",      "sp",     "end", "con",
    "mg",    "bevel", "lod",    "bmat",   "step",   "shadow_obj"};

bool begins(std::string_view text, std::string_view word) {
  return equal_but_for_case(text.substr(0, word.size()), word);
}

/// The suffix of a file, of "part.obj.gz" the one before.
std::string suffix_of(const InputFile& input) {
  const std::filesystem::path path(input.name());
  const std::string suffix = lower_suffix(path);
  return suffix == ".gz" ? lower_suffix(path.stem()) : suffix;
}

/// What a text editor would show as text, whatever its character set.
bool is_text(std::string_view bytes) {
  constexpr char kDosEndOfFile = '\x1a';
  return std::all_of(bytes.begin(), bytes.end(), [](char c) {
    return static_cast<unsigned char>(c) >= ' ' || is_blank(c) || is_eol(c) || c == kDosEndOfFile;
  });
}

/// Goes through the words of a text.
class Words {
 public:
  explicit Words(std::string_view text) : text_(text) {}

  /// The next word; empty at the end.
  std::string_view next() {
    while (!text_.empty() && (is_blank(text_[0]) || is_eol(text_[0]))) text_.remove_prefix(1);
    std::size_t length = 0;
    while (length < text_.size() && !is_blank(text_[length]) && !is_eol(text_[length])) ++length;
    const std::string_view word = text_.substr(0, length);
    text_.remove_prefix(length);
    return word;
  }
  void skip_line() {
    while (!text_.empty() && !is_eol(text_[0])) text_.remove_prefix(1);
  }

 private:
  std::string_view text_;
};

/// "solid", a name, and then nothing else than what follows in an ASCII STL. The header of a binary
/// STL may begin with "solid" too.
bool looks_like_ascii_stl(std::string_view text) {
  Words words(text);
  if (!equal_but_for_case(words.next(), "solid")) return false;
  words.skip_line();
  const std::string_view word = words.next();
  return word.empty() || begins("facet", word) || begins("endsolid", word) || begins("solid", word);
}

/// The first word that is no comment; a comment goes from its sign to the end of the line.
std::string_view first_word(std::string_view text, char comment) {
  Words words(text);
  std::string_view word = words.next();
  for (; word.starts_with(comment); word = words.next()) words.skip_line();
  return word;
}

bool looks_like_msh(std::string_view begin) {
  const std::string_view word = Words(begin).next();
  return word == "$MeshFormat" || word == "$Comments";
}

bool looks_like_ply(std::string_view begin) {
  return begin.size() > 3 && begins(begin, "ply") && is_eol(begin[3]);
}

bool looks_like_su2(std::string_view text) {
  const std::string_view word = first_word(text, '%');
  for (const std::string_view key : {"NDIME", "NZONE", "IZONE", "NELEM", "NPOIN", "NMARK"}) {
    if (begins(word, key) && (word.size() == key.size() || word[key.size()] == '=')) return true;
  }
  return false;
}

bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }

/// The keywords of a deck follow a star, comments two.
bool looks_like_inp(std::string_view text) {
  const std::string_view word = Words(text).next();
  return word.size() > 1 && word[0] == '*' && (word[1] == '*' || is_letter(word[1]));
}

/// The first statement that is no comment is one of OBJ's.
bool looks_like_obj(std::string_view text) {
  Words words(text);
  for (;;) {
    const std::string_view word = words.next();
    if (!word.starts_with('#')) {
      return std::find(kObjKeywords.begin(), kObjKeywords.end(), word) != kObjKeywords.end();
    }
    words.skip_line();
  }
}

[[noreturn]] void refuse(const InputFile& input, std::string_view what) {
  input.fail(fmt::format("is {}; {}", what, kReads));
}

}  // namespace

std::span<const FormatTraits> all_formats() { return kFormats; }

const FormatTraits& format_traits(std::string_view name) {
  const auto found = std::find_if(kFormats.begin(), kFormats.end(),
                                  [name](const FormatTraits& f) { return f.name == name; });
  assert(found != kFormats.end());
  return *found;
}

bool has_suffix(const FormatTraits& format, std::string_view suffix) {
  Words words(format.suffixes);
  for (std::string_view word = words.next(); !word.empty(); word = words.next()) {
    if (word == suffix) return true;
  }
  return false;
}

std::string lower_suffix(const std::filesystem::path& path) {
  return lower(path.extension().string());
}

Format find_format(const InputFile& input) {
  const std::string_view bytes = input.bytes();
  std::string_view begin = bytes.substr(0, kLookAt);
  const std::string suffix = suffix_of(input);

  if (begin.starts_with("\xFE\xFF") || begin.starts_with("\xFF\xFE")) {
    refuse(input, "text in UTF-16; save it as UTF-8");
  }
  if (begin.starts_with("\xEF\xBB\xBF")) begin.remove_prefix(3);
  if (looks_like_msh(begin)) return Format::msh;
  if (looks_like_ply(begin)) return Format::ply;
  if (looks_like_meshb(begin)) return Format::meshb;
  if (begins(begin, "# vtk datafile")) return Format::vtk;
  if (is_netcdf(begin)) return Format::exodus;
  if (const auto dataset = vtk_xml_dataset(begin)) {
    return *dataset == "PolyData" ? Format::vtp : Format::vtu;
  }
  const bool text = is_text(begin);
  if (text && looks_like_ascii_stl(begin)) return Format::stl_ascii;
  if (has_binary_stl_size(bytes)) return Format::stl_binary;

  for (const Signature& known : kSignatures) {
    if (begins(begin, known.begin)) refuse(input, known.what);
  }
  if (!text) {
    if (suffix == ".stl") return Format::stl_binary;
    for (const Signature& known : kSuffixes) {
      if (suffix == known.begin) refuse(input, known.what);
    }
    refuse(input, "binary data in no format known here");
  }
  const std::string_view hashed = first_word(begin, '#');
  if (equal_but_for_case(hashed, "MeshVersionFormatted")) return Format::medit;
  if (off_keyword_length(hashed) > 0) return Format::off;
  if (looks_like_obj(begin) || suffix == ".obj") return Format::obj;
  if (looks_like_su2(begin) || suffix == ".su2") return Format::su2;
  if (looks_like_inp(begin)) return Format::inp;
  if (suffix == ".inp" && looks_like_ucd(begin)) return Format::ucd;
  if (looks_like_nastran(begin) || suffix == ".bdf" || suffix == ".nas") return Format::nastran;
  if (suffix == ".stl") {
    input.fail(bytes.size() < kBinaryStlHeader
                   ? "is neither an ASCII STL, which begins with 'solid', nor long enough for a "
                     "binary one"
                   : "is neither an ASCII STL, which begins with 'solid', nor has it the size that "
                     "a binary one with its number of facets has; export it again");
  }
  for (const Signature& known : kSuffixes) {
    if (suffix == known.begin) refuse(input, known.what);
  }
  for (const FormatTraits& known : kFormats) {
    if (has_suffix(known, suffix)) return known.format;
  }
  refuse(input, "in no format known here");
}

MeshFile read_as(Format format, std::shared_ptr<const InputFile> input,
                 const ReadOptions& options) {
  const auto found = std::find_if(kFormats.begin(), kFormats.end(),
                                  [format](const FormatTraits& f) { return f.format == format; });
  assert(found != kFormats.end());
  MeshFile file = found->read(input, options);
  file.path = input->name();
  file.bytes = input->size_on_disk();
  file.input = std::move(input);
  if (file.group_names.empty()) file.group_names = {""};
  std::vector<Index>& held = file.held.vertices;
  std::sort(held.begin(), held.end());
  held.erase(std::unique(held.begin(), held.end()), held.end());
  return file;
}

MeshFile read_mesh(std::shared_ptr<const InputFile> input, const ReadOptions& options) {
  const Format format = find_format(*input);
  return read_as(format, std::move(input), options);
}

}  // namespace evenmesh
