#include <fmt/format.h>
#include <gtest/gtest.h>

#include <fstream>
#include <random>

#include "mesh/mesh_io.h"
#include "support/temp_dir.h"
#include "unit/mesh/mesh_io_fixtures.h"
#include "unit/mesh/vtu_builder.h"

namespace tetralux {
namespace {

using namespace test;

// The message, with "m.vtu" for the file's whole name.
std::string readError(const std::string& text) {
  const TempDir dir;
  const std::filesystem::path path = dir.write("m.vtu", text);
  return replaced(errorOf([&] { readVtu(path); }), path.string(), "m.vtu");
}

VtuFormat formatOf(Placement placement, Compression compression = Compression::None) {
  VtuFormat format;
  format.placement = placement;
  format.compression = compression;
  return format;
}

std::vector<VtuFormat> oneFormatOfEachKind() {
  return {formatOf(Placement::Ascii),
          formatOf(Placement::Inline),
          formatOf(Placement::Inline, Compression::ZLib),
          formatOf(Placement::AppendedRaw),
          formatOf(Placement::AppendedRaw, Compression::ZLib),
          formatOf(Placement::AppendedRaw, Compression::Lz4),
          formatOf(Placement::AppendedRaw, Compression::Lzma),
          formatOf(Placement::AppendedBase64),
          formatOf(Placement::AppendedBase64, Compression::Lz4)};
}

// The mesh, or nothing after an Error(Input). Anything else that is thrown fails the test.
std::optional<TetMesh> readOrRefuse(const std::filesystem::path& path) {
  try {
    return readVtu(path);
  } catch (const Error& e) {
    EXPECT_EQ(e.code(), ErrorCode::Input);
  } catch (const std::exception& e) {
    ADD_FAILURE() << "not an Error: " << e.what();
  }
  return std::nullopt;
}

TEST(ReadVtuErrors, EveryTruncationIsRefusedUnlessOnlyClosingTagsAreMissing) {
  const TempDir dir;
  for (const VtuFormat& format : oneFormatOfEachKind()) {
    const std::string text = buildVtu(tinyMesh(), format);
    SCOPED_TRACE(text.substr(0, 400));
    const std::filesystem::path path = dir.write("m.vtu", text);
    const size_t dataEnd = std::min(text.rfind("</AppendedData>"), text.rfind("</VTKFile>"));
    for (size_t size = text.size(); size-- > 0;) {
      std::filesystem::resize_file(path, size);
      const auto mesh = readOrRefuse(path);
      if (!mesh) continue;
      // White space before the closing tags is no data, and base64 may do without its padding.
      ASSERT_GE(size + 8, dataEnd) << "read a file of " << size << " bytes";
      expectEqual(*mesh, tinyMesh());
    }
  }
}

TEST(ReadVtuErrors, ADamagedByteIsRefusedOrReadButNeverMore) {
  const TempDir dir;
  std::mt19937 random(20);
  for (const VtuFormat& format : oneFormatOfEachKind()) {
    const std::string text = buildVtu(tinyMesh(), format);
    for (int i = 0; i < 400; i++) {
      std::string damaged = text;
      const size_t at = random() % text.size();
      damaged[at] = static_cast<char>(random());
      SCOPED_TRACE(fmt::format("byte {} is {}", at, static_cast<int>(damaged[at])));
      readOrRefuse(dir.write("m.vtu", damaged));
    }
  }
}

struct Edit {
  const char* from;
  const char* to;
  const char* message;
};

TEST(ReadVtuErrors, EveryAttributeIsChecked) {
  const std::string text = buildVtu(tinyMesh(), {});
  const Edit edits[] = {
      {"<VTKFile", "VTKFile", "m.vtu: begins with 'VTKFile ', expected an XML element"},
      {"<VTKFile", "<!--", "m.vtu: byte 1166: Error parsing comment, expected well-formed XML"},
      {"</UnstructuredGrid>", "</Unstructured>", "m.vtu: byte 1142: Start-end tags mismatch, expected well-formed XML"},
      {"type=\"UnstructuredGrid\"", "type=\"PolyData\"",
       "m.vtu: VTKFile type is 'PolyData', expected 'UnstructuredGrid'"},
      {"type=\"UnstructuredGrid\"", "kind=\"UnstructuredGrid\"",
       "m.vtu: VTKFile type is '', expected 'UnstructuredGrid'"},
      {"LittleEndian", "MiddleEndian", "m.vtu: byte_order is 'MiddleEndian', expected LittleEndian or BigEndian"},
      {"header_type=\"UInt32\"", "header_type=\"UInt16\"", "m.vtu: header_type is 'UInt16', expected UInt32 or UInt64"},
      {"header_type=\"UInt32\"", "compressor=\"vtkZStdDataCompressor\"",
       "m.vtu: compressor is 'vtkZStdDataCompressor', expected vtkZLibDataCompressor, vtkLZ4DataCompressor or "
       "vtkLZMADataCompressor"},
      {"<UnstructuredGrid>", "<UnstructuredGrid></UnstructuredGrid><UnstructuredGrid>",
       "m.vtu: no Piece in UnstructuredGrid, expected at least one"},
      {"NumberOfPoints=\"5\"", "", "m.vtu: no NumberOfPoints in Piece, expected a number"},
      {"NumberOfPoints=\"5\"", "NumberOfPoints=\"-5\"", "m.vtu: NumberOfPoints is '-5', expected a whole number"},
      {"NumberOfPoints=\"5\"", "NumberOfPoints=\"6\"", "m.vtu: Points: ends after 15 values, expected 18"},
      {"NumberOfPoints=\"5\"", "NumberOfPoints=\"4\"", "m.vtu: Points: '4' after the last value, expected 12 values"},
      {"NumberOfPoints=\"5\"", "NumberOfPoints=\"5000000000\"",
       "m.vtu: 5000000000 points, expected no more than 4294967295"},
      {"NumberOfCells=\"2\"", "NumberOfCells=\"\"", "m.vtu: NumberOfCells is '', expected a whole number"},
      {"NumberOfCells=\"2\"", "NumberOfCells=\"3\"", "m.vtu: types: ends after 2 values, expected 3"},
      {"NumberOfCells=\"2\"", "NumberOfCells=\"18446744073709551615\"",
       "m.vtu: types: 18446744073709551615 tuples of 1 components, expected fewer"},
      {"NumberOfCells=\"2\"", "NumberOfCells=\"1000000000000\"",
       "m.vtu: types: 25 characters are left, expected 1000000000000 values"},
      {"NumberOfCells=\"2\"", "NumberOfCells=\"0\"", "m.vtu: no cells, expected at least 1 tetrahedron"},
      {"type=\"Float32\" Name=\"a\"", "type=\"Float16\" Name=\"a\"",
       "m.vtu: point array 'a': type is 'Float16', expected Int8 to Int64, UInt8 to UInt64, Float32 or Float64"},
      {"type=\"Float32\" Name=\"Points\"", "type=\"String\" Name=\"Points\"",
       "m.vtu: Points: type is 'String', expected Int8 to Int64, UInt8 to UInt64, Float32 or Float64"},
      {"NumberOfComponents=\"3\"", "NumberOfComponents=\"0\"",
       "m.vtu: point array 'v': NumberOfComponents is 0, expected at least 1"},
      {"NumberOfComponents=\"3\"", "NumberOfComponents=\"x\"",
       "m.vtu: point array 'v': NumberOfComponents is 'x', expected a whole number"},
      {"NumberOfComponents=\"3\"", "NumberOfComponents=\"2\"",
       "m.vtu: point array 'v': '11' after the last value, expected 10 values"},
      {"NumberOfComponents=\"3\"", "NumberOfComponents=\"5000000000000000000\"",
       "m.vtu: point array 'v': 5 tuples of 5000000000000000000 components, expected fewer"},
      {"Name=\"Points\" NumberOfComponents=\"3\"", "Name=\"Points\" NumberOfComponents=\"2\"",
       "m.vtu: Points: NumberOfComponents is 2, expected 3"},
      {"format=\"ascii\"", "format=\"hex\"",
       "m.vtu: point array 'a': format is 'hex', expected ascii, binary or appended"},
      {"format=\"ascii\"", "format=\"appended\" offset=\"0\"",
       "m.vtu: point array 'a': format is 'appended', expected AppendedData in the file"},
      {"0.5", "0.5.5", "m.vtu: point array 'a': value 0 is '0.5.5', expected a number of type Float32"},
      {"-7 ", "7000000000 ", "m.vtu: cell array 'c': value 0 is '7000000000', expected a number of type Int32"},
      {"<Points>", "<Spots></Spots><Points2></Points2><Points></Points><Points>",
       "m.vtu: Points: no DataArray, expected one"},
      {"Name=\"connectivity\"", "Name=\"links\"", "m.vtu: no array 'connectivity' in Cells, expected one"},
      {"Name=\"offsets\"", "Name=\"ends\"", "m.vtu: no array 'offsets' in Cells, expected one"},
      {"Name=\"types\"", "Name=\"kinds\"", "m.vtu: no array 'types' in Cells, expected one"},
      {"10 10", "10 12",
       "m.vtu: cell 1: cell type 12 (hexahedron), expected 10 (tetrahedron); other cells are not read yet"},
      {"10 10", "99 10",
       "m.vtu: cell 0: cell type 99 (unknown), expected 10 (tetrahedron); other cells are not read yet"},
      {"type=\"Int64\" Name=\"offsets\"", "type=\"Float64\" Name=\"offsets\"",
       "m.vtu: offsets of type Float64, expected an integer type"},
      {"4 8", "4 9", "m.vtu: cell 1: ends after vertex 9 of the connectivity, expected 8"},
      {"4 8", "0 4", "m.vtu: cell 0: ends after vertex 0 of the connectivity, expected 4"},
      {"0 1 2 3 1 2", "0 1 2 3 5 2", "m.vtu: cell 1: vertex index 5, expected below the number of points, 5"},
      {"0 1 2 3 1 2", "0 -1 2 3 1 2", "m.vtu: cell 0: vertex index -1, expected below the number of points, 5"},
      {"0 1 2 3 1 2", "0 4294967297 2 3 1 2",
       "m.vtu: cell 0: vertex index 4294967297, expected below the number of points, 5"},
      {"0 0 0 1 0 0", "0 0 nan 1 0 0", "m.vtu: point 0: coordinate z is nan, expected a finite number"},
  };
  for (const Edit& edit : edits) EXPECT_EQ(readError(replaced(text, edit.from, edit.to)), edit.message) << edit.to;
}

TEST(ReadVtuErrors, OtherDataSetsAndOtherXmlAreNamed) {
  EXPECT_EQ(readError("<html><body/></html>"), "m.vtu: root element is 'html', expected 'VTKFile'");
  EXPECT_EQ(readError("<VTKFile type=\"UnstructuredGrid\"/>"), "m.vtu: no UnstructuredGrid in VTKFile, expected one");
  EXPECT_EQ(readError("   \n"), "m.vtu: begins with '   .', expected an XML element");
  EXPECT_EQ(readError("\x89PNG\r\n\x1a\n"), "m.vtu: begins with '.PNG....', expected an XML element");
}

TEST(ReadVtuErrors, AppendedDataAreChecked) {
  const std::string text = buildVtu(tinyMesh(), formatOf(Placement::AppendedRaw));
  const Edit edits[] = {
      {"encoding=\"raw\"", "encoding=\"hex\"", "m.vtu: encoding of AppendedData is 'hex', expected raw or base64"},
      {"   _", "   #", "m.vtu: AppendedData begins with '.   #...', expected '_'"},
      {"offset=\"0\"", "", "m.vtu: point array 'a': no offset in DataArray, expected a number"},
      {"offset=\"0\"", "offset=\"0x\"", "m.vtu: point array 'a': offset is '0x', expected a whole number"},
      {"offset=\"0\"", "offset=\"99999\"",
       "m.vtu: point array 'a': offset 99999 in appended data, expected no more than its size, 321"},
      {"offset=\"0\"", "offset=\"319\"",
       "m.vtu: point array 'a': header of 1 x 4 bytes, expected no more than the 2 bytes of data left"},
      {"NumberOfPoints=\"5\"", "NumberOfPoints=\"4000000000\"",
       "m.vtu: Points: data has 60 bytes, expected 48000000000 for 12000000000 numbers"},
      {" encoding=\"raw\"", "/", "m.vtu: Points: format is 'appended', expected AppendedData in the file"},
  };
  for (const Edit& edit : edits) EXPECT_EQ(readError(replaced(text, edit.from, edit.to)), edit.message) << edit.to;
}

// What becomes of array "a", 20 bytes, when its header (and nothing else) is changed.
std::string headerError(VtuFormat format, size_t index, std::uint64_t value) {
  format.blockSize = 8;  // 3 blocks, the last one of 4 bytes
  format.editHeader = [=](const std::string& array, std::vector<std::uint64_t>& header) {
    if (array == "a") header.at(index) = value;
  };
  return readError(buildVtu(tinyMesh(), format));
}

TEST(ReadVtuErrors, AHeaderOfPlainDataMustGiveTheirSize) {
  for (const Placement placement : {Placement::Inline, Placement::AppendedRaw, Placement::AppendedBase64}) {
    EXPECT_EQ(headerError(formatOf(placement), 0, 16),
              "m.vtu: point array 'a': data has 16 bytes, expected 20 for 5 numbers");
    EXPECT_EQ(headerError(formatOf(placement), 0, 0xffffffff),
              "m.vtu: point array 'a': data has 4294967295 bytes, expected 20 for 5 numbers");
  }
}

TEST(ReadVtuErrors, EveryNumberOfACompressedHeaderIsChecked) {
  VtuFormat raw = formatOf(Placement::AppendedRaw, Compression::ZLib);
  raw.header64 = true;
  const std::string a = "m.vtu: point array 'a': ";
  EXPECT_EQ(headerError(raw, 0, 0), a + "0 compressed blocks of 8 bytes, the last of 4, expected 20 bytes in all");
  EXPECT_EQ(headerError(raw, 0, 2), a + "2 compressed blocks of 8 bytes, the last of 4, expected 20 bytes in all");
  EXPECT_EQ(headerError(raw, 0, std::uint64_t{1} << 63),
            a + "9223372036854775808 compressed blocks of 8 bytes, the last of 4, expected 20 bytes in all");
  EXPECT_EQ(headerError(raw, 1, 0), a + "3 compressed blocks of 0 bytes, the last of 4, expected 20 bytes in all");
  EXPECT_EQ(headerError(raw, 1, 16), a + "3 compressed blocks of 16 bytes, the last of 4, expected 20 bytes in all");
  EXPECT_EQ(headerError(raw, 1, ~std::uint64_t{0}),
            a + "3 compressed blocks of 18446744073709551615 bytes, the last of 4, expected 20 bytes in all");
  EXPECT_EQ(headerError(raw, 2, 0), a + "3 compressed blocks of 8 bytes, the last of 8, expected 20 bytes in all");
  EXPECT_EQ(headerError(raw, 2, 12), a + "3 compressed blocks of 8 bytes, the last of 12, expected 20 bytes in all");
  EXPECT_EQ(headerError(raw, 3, 0), a + "block 0 has 0 compressed bytes, expected enough for 8 decompressed ones");
  EXPECT_EQ(headerError(raw, 3, 5), a + "block 0 is damaged, expected zlib data of 8 bytes");
  // How much is left depends on the compressor: all appended data, but for this header and the first two blocks.
  std::vector<std::uint64_t> intact;
  VtuFormat recorder = raw;
  recorder.blockSize = 8;
  recorder.editHeader = [&](const std::string& array, std::vector<std::uint64_t>& header) {
    if (array == "a") intact = header;
  };
  const std::string text = buildVtu(tinyMesh(), recorder);
  const size_t appended = text.rfind("</AppendedData>") - (text.find("   _") + 4);
  const size_t left = appended - 6 * 8 - intact.at(3) - intact.at(4);
  const auto tooLarge = [&](std::uint64_t size) {
    return fmt::format("{}block 2 has {} compressed bytes, expected no more than the {} bytes of data left", a, size,
                       left);
  };
  EXPECT_EQ(headerError(raw, 5, left + 1), tooLarge(left + 1));
  EXPECT_EQ(headerError(raw, 5, ~std::uint64_t{0}), tooLarge(~std::uint64_t{0}));
}

TEST(ReadVtuErrors, DamagedBlocksAreNamed) {
  const std::pair<Compression, const char*> kinds[] = {
      {Compression::ZLib, "zlib"}, {Compression::Lz4, "LZ4"}, {Compression::Lzma, "LZMA"}};
  for (const auto& [compression, name] : kinds) {
    for (const Placement placement : {Placement::Inline, Placement::AppendedRaw}) {
      VtuFormat format = formatOf(placement, compression);
      format.blockSize = 64;  // 120 bytes of "v": a full and a partial block
      format.editBytes = [](const std::string& array, std::string& bytes) {
        if (array == "v") bytes.back() = static_cast<char>(bytes.back() ^ 0x55), bytes[bytes.size() / 2 + 4] ^= 0x55;
        if (array == "v") bytes.replace(bytes.size() - 12, 12, 12, '\xff');
      };
      EXPECT_EQ(readError(buildVtu(tinyMesh(), format)),
                fmt::format("m.vtu: point array 'v': block 1 is damaged, expected {} data of 56 bytes", name));
    }
  }
}

// A header may claim gigabytes; what follows it decides.
TEST(ReadVtuErrors, NoMemoryIsTakenForSizesThatTheDataCannotHold) {
  const std::uint64_t points = 2'000'000'000;
  for (const Compression compression : {Compression::ZLib, Compression::Lz4, Compression::Lzma}) {
    std::uint64_t compressedSize = 0;
    VtuFormat format = formatOf(Placement::AppendedRaw, compression);
    format.header64 = true;
    format.blockSize = 1 << 20;
    format.editHeader = [&](const std::string& array, std::vector<std::uint64_t>& header) {
      if (array != "Points") return;
      header[1] = header[2] = points * 12;
      compressedSize = header[3];
    };
    const std::string text = buildVtu(tinyMesh(), format);
    EXPECT_EQ(readError(replaced(text, "NumberOfPoints=\"5\"", fmt::format("NumberOfPoints=\"{}\"", points))),
              fmt::format("m.vtu: Points: block 0 has {} compressed bytes, expected enough for 24000000000 "
                          "decompressed ones",
                          compressedSize));
  }
}

TEST(ReadVtuErrors, Base64IsChecked) {
  const std::string text = buildVtu(tinyMesh(), formatOf(Placement::Inline));
  const size_t at = text.find("format=\"binary\">") + 16 + 11;
  std::string foreign = text;
  foreign[at + 12] = '#';
  EXPECT_EQ(readError(foreign),
            "m.vtu: point array 'a': character 23 of the data is not base64, expected 15 more bytes");
  std::string cut = text;
  cut.erase(at + 8, 8);
  EXPECT_EQ(readError(cut), "m.vtu: point array 'a': data ends after 14 bytes, expected 20");
  EXPECT_EQ(readError(text.substr(0, at) + text.substr(text.find("</DataArray>"))),
            "m.vtu: point array 'a': header of 1 x 4 bytes, expected no more than the 0 bytes of data left");
}

TEST(ReadVtuErrors, PiecesMustAgree) {
  const std::vector<TetMesh> pieces = {tinyMesh(), tinyMesh()};
  const auto edited = [&](const std::function<void(TetMesh&)>& edit) {
    std::vector<TetMesh> changed = pieces;
    edit(changed[1]);
    return readError(buildVtu(changed, {}));
  };
  EXPECT_EQ(edited([](TetMesh& m) { m.pointArrays.pop_back(); }),
            "m.vtu: piece 1: no point array 'v', expected the arrays of the first piece");
  EXPECT_EQ(edited([](TetMesh& m) { m.cellArrays[0].name = "d"; }),
            "m.vtu: piece 1: cell array 'd', expected the arrays of the first piece only");
  EXPECT_EQ(edited([](TetMesh& m) { m.pointArrays[0].values = std::vector<double>(5); }),
            "m.vtu: piece 1: point array 'a' has 1 components of type Float64, expected 1 of type Float32");
  EXPECT_EQ(edited([](TetMesh& m) { m.cells[1][0] = 7; }),
            "m.vtu: piece 1: cell 1: vertex index 7, expected below the number of points, 5");
}

TEST(ReadVtuErrors, FilesThatAreNotThereOrEmpty) {
  const TempDir dir;
  EXPECT_EQ(errorOf([&] { readMesh(dir / "no.vtu"); }), (dir / "no.vtu").string() + ": no such file");
  EXPECT_EQ(errorOf([&] { readMesh(dir.write("e.vtu", "")); }), (dir / "e.vtu").string() + ": is empty");
  std::filesystem::create_directory(dir / "d.vtu");
  EXPECT_EQ(errorOf([&] { readMesh(dir / "d.vtu"); }), (dir / "d.vtu").string() + ": is a directory, expected a file");
}

TEST(ReadMesh, FormatIsChosenByTheNameWhateverItsCase) {
  const TempDir dir;
  const std::string text = buildVtu(tinyMesh(), {});
  expectEqual(readMesh(dir.write("m.vtu", text)), tinyMesh());
  expectEqual(readMesh(dir.write("m.VTU", text)), tinyMesh());
  EXPECT_EQ(errorOf([&] { readMesh("m.obj"); }), "m.obj: file name ends in '.obj', expected .vtu or .vtk");
  EXPECT_EQ(errorOf([&] { readMesh("mesh"); }), "mesh: file name ends in '', expected .vtu or .vtk");
  EXPECT_EQ(errorOf([&] { readMesh(dir.write("m.vtk", "<?xml version=\"1.0\"?>\n")); }),
            (dir / "m.vtk").string() +
                ": line 1: '<?xml version=\"1.0\"?>', expected '# vtk DataFile Version 5.1' or an earlier one");
}

}  // namespace
}  // namespace tetralux
