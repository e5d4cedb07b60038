// SPDX-License-Identifier: MIT
#include "arete/vtk/write_image.h"

#include <gtest/gtest.h>
#include <vtkDataSetAttributes.h>
#include <vtkImageData.h>
#include <vtkMatrix3x3.h>
#include <vtkXMLImageDataReader.h>

#include <array>
#include <cmath>

#include "fixtures.h"
#include "reading.h"

namespace arete::vtk {
namespace {

constexpr Extent extent{5, 7};

vtkSmartPointer<vtkImageData> written(const Surface& surface, const WriteOptions& options = {}) {
  const Scratch scratch;
  write_image(surface, scratch / "a.vti", options);
  return read_back<vtkXMLImageDataReader>(scratch / "a.vti");
}

/// The point at the sample's world position, up to a rounding error of the reader.
vtkIdType point_at(vtkImageData& image, const Georeference& georeference, Index row, Index col) {
  const WorldPoint at = georeference.position(static_cast<double>(row), static_cast<double>(col));
  std::array<double, 3> world{at.x, at.y, 0};
  const vtkIdType point = image.FindPoint(world.data());
  if (point < 0) return -1;
  std::array<double, 3> found{};
  image.GetPoint(point, found.data());
  const double tolerance = 1e-14 * (std::abs(at.x) + std::abs(at.y));
  return std::hypot(found[0] - at.x, found[1] - at.y) <= tolerance ? point : -1;
}

class EveryGeoreference : public testing::TestWithParam<Georeference> {};
INSTANTIATE_TEST_SUITE_P(write_image, EveryGeoreference,
                         testing::Values(north_up, south_up, mirrored, rotated, quarter_turn, utm,
                                         jacksboro));

TEST_P(EveryGeoreference, every_sample_lies_at_its_world_position) {
  const auto grid = planted<double>(extent, GetParam(), plane_height);
  const auto image = written(surface_of(grid, GetParam()));
  ASSERT_EQ(image->GetNumberOfPoints(), 35);
  for (Index r = 0; r < extent.rows; ++r) {
    for (Index c = 0; c < extent.cols; ++c) {
      const vtkIdType point = point_at(*image, GetParam(), r, c);
      ASSERT_GE(point, 0) << "no point for sample " << r << ", " << c;
      EXPECT_EQ(value(*image, "height", point), grid(r, c)) << r << ", " << c;
    }
  }
}

TEST_P(EveryGeoreference, axes_are_right_handed_and_spacing_positive) {
  const auto grid = planted<float>(extent, GetParam(), plane_height);
  const auto image = written(surface_of(grid, GetParam()));
  EXPECT_NEAR(image->GetDirectionMatrix()->Determinant(), 1, 1e-14);
  EXPECT_GT(image->GetSpacing()[0], 0);
  EXPECT_GT(image->GetSpacing()[1], 0);
}

TEST(write_image, needs_no_direction_matrix_unless_rotated) {
  const auto grid = planted<float>(extent, north_up, plane_height);
  for (const Georeference& georeference : {north_up, south_up, mirrored, utm}) {
    EXPECT_TRUE(written(surface_of(grid, georeference))->GetDirectionMatrix()->IsIdentity());
  }
  EXPECT_FALSE(written(surface_of(grid, rotated))->GetDirectionMatrix()->IsIdentity());
}

TEST(write_image, heights_keep_their_type_and_their_last_bit) {
  Grid<double> doubles(extent, 1 + 1e-15);
  const auto as_double = written(surface_of(doubles, north_up));
  EXPECT_EQ(as_double->GetScalarType(), VTK_DOUBLE);
  EXPECT_EQ(value(*as_double, "height", 0), 1 + 1e-15);
  Grid<float> floats(extent, 1.1f);
  const auto as_float = written(surface_of(floats, north_up));
  EXPECT_EQ(as_float->GetScalarType(), VTK_FLOAT);
  EXPECT_EQ(value(*as_float, "height", 0), 1.1f);
  EXPECT_STREQ(as_float->GetPointData()->GetScalars()->GetName(), "height");
}

TEST(write_image, missing_samples_are_nan_and_hidden_and_no_others) {
  auto grid = planted<float>(extent, north_up, plane_height);
  grid(0, 1) = missing;
  grid(3, 6) = std::numeric_limits<float>::infinity();
  const auto image = written(surface_of(grid, north_up));
  auto* hidden = ghosts(*image);
  ASSERT_NE(hidden, nullptr);
  for (Index r = 0; r < extent.rows; ++r) {
    for (Index c = 0; c < extent.cols; ++c) {
      const vtkIdType point = point_at(*image, north_up, r, c);
      const bool valid = std::isfinite(grid(r, c));
      EXPECT_EQ(hidden->GetValue(point), valid ? 0 : vtkDataSetAttributes::HIDDENPOINT);
      EXPECT_EQ(std::isfinite(value(*image, "height", point)), valid);
    }
  }
}

TEST(write_image, a_whole_raster_has_no_ghosts) {
  const auto grid = planted<float>(extent, north_up, plane_height);
  EXPECT_EQ(ghosts(*written(surface_of(grid, north_up))), nullptr);
}

TEST(write_image, rows_may_lie_apart_in_memory) {
  const auto grid = planted<float>(extent, north_up, plane_height);
  const GridView<const float> part(grid.row(1) + 2, {3, 4}, grid.cols());
  const auto image = written({.heights = part, .georeference = north_up});
  for (Index r = 0; r < 3; ++r) {
    for (Index c = 0; c < 4; ++c) {
      EXPECT_EQ(value(*image, "height", point_at(*image, north_up, r, c)), grid(r + 1, c + 2));
    }
  }
}

TEST(write_image, keeps_reference_system_map_and_notes) {
  const auto grid = planted<float>(extent, jacksboro, plane_height);
  Surface surface = surface_of(grid, jacksboro);
  surface.coordinates = Coordinates::geographic;
  surface.crs_wkt = "GEOGCRS[\"WGS 84\",\n  <&>\"]";
  surface.notes = {
      {"scheme", "four-parameter:omega=3/64"}, {"arête", "crête & vallée\n"}, {"empty", ""}};
  const auto image = written(surface);
  EXPECT_EQ(field_text(*image, "CRS_WKT"), surface.crs_wkt);
  for (const Note& note : surface.notes) {
    EXPECT_EQ(field_text(*image, note.name.c_str()), note.text);
  }
  auto* map = image->GetFieldData()->GetArray("GeoTransform");
  ASSERT_NE(map, nullptr);
  for (int k = 0; k < 6; ++k) {
    EXPECT_EQ(map->GetTuple1(k), jacksboro.affine[static_cast<std::size_t>(k)]);
  }
  EXPECT_EQ(field_text(*image, "local_plane"), "(none)") << "a .vti keeps degrees";
}

TEST(write_image, one_row_one_column_and_nothing_valid_are_ordinary) {
  for (const Extent small : {Extent{1, 9}, {9, 1}, {1, 1}}) {
    const auto grid = planted<float>(small, north_up, plane_height);
    const auto image = written(surface_of(grid, north_up));
    ASSERT_EQ(image->GetNumberOfPoints(), small.rows * small.cols);
    const vtkIdType last = point_at(*image, north_up, small.rows - 1, small.cols - 1);
    EXPECT_EQ(value(*image, "height", last), grid(small.rows - 1, small.cols - 1));
  }
  const Grid<float> nothing(extent, missing);
  EXPECT_EQ(written(surface_of(nothing, north_up))->GetNumberOfPoints(), 35);
}

TEST(write_image, packing_changes_the_file_and_not_the_data) {
  const Scratch scratch;
  const auto grid = planted<float>({64, 64}, north_up, plane_height);
  const std::array<std::pair<Compression, std::string>, 3> packings{
      {{Compression::none, ""},
       {Compression::lz4, "vtkLZ4DataCompressor"},
       {Compression::zlib, "vtkZLibDataCompressor"}}};
  for (const auto& [compression, name] : packings) {
    write_image(surface_of(grid, north_up), scratch / "a.vti", {compression});
    const std::string file = contents(scratch / "a.vti");
    const std::string head = file.substr(0, file.find('>'));
    EXPECT_NE(head.find("header_type=\"UInt64\""), std::string::npos);
    EXPECT_EQ(head.find("compressor=\"" + name + "\"") != std::string::npos, !name.empty()) << head;
    EXPECT_NE(file.find("<AppendedData encoding=\"raw\">"), std::string::npos);
    const auto image = read_back<vtkXMLImageDataReader>(scratch / "a.vti");
    for (Index r = 0; r < 64; ++r) {
      EXPECT_EQ(value(*image, "height", point_at(*image, north_up, r, 5)), grid(r, 5));
    }
  }
  write_image(surface_of(grid, north_up), scratch / "default.vti");
  write_image(surface_of(grid, north_up), scratch / "lz4.vti", {Compression::lz4});
  EXPECT_EQ(contents(scratch / "default.vti"), contents(scratch / "lz4.vti"));
}

TEST(write_image, refuses_shear_and_says_what_to_write_instead) {
  const Scratch scratch;
  const auto grid = planted<float>(extent, sheared, plane_height);
  try {
    write_image(surface_of(grid, sheared), scratch / "a.vti");
    FAIL() << "a sheared raster was written";
  } catch (const InvalidField& error) {
    EXPECT_NE(std::string(error.what()).find(".vts"), std::string::npos) << error.what();
  }
  EXPECT_FALSE(std::filesystem::exists(scratch / "a.vti"));
}

}  // namespace
}  // namespace arete::vtk
