// SPDX-License-Identifier: MIT
#include "cli/curve_output.h"

#include <algorithm>

#include "cli/error.h"
#ifdef ARETE_HAVE_VTK
#include "arete/vtk/plot_curve.h"
#include "arete/vtk/write_polyline.h"
#endif

namespace arete::cli {
namespace {

Points table_of(const CurveFile& curve) {
  const Index coordinates = curve.points.cols();
  Points table{curve.header, curve.points};
  if (curve.columns.empty()) return table;
  if (!table.header.empty())
    for (const Column& column : curve.columns) table.header.push_back(column.name);
  table.values =
      Grid<double>({curve.points.rows(), coordinates + static_cast<Index>(curve.columns.size())});
  for (Index r = 0; r < curve.points.rows(); ++r) {
    std::copy_n(curve.points.row(r), coordinates, table.values.row(r));
    for (std::size_t c = 0; c < curve.columns.size(); ++c)
      table.values(r, coordinates + static_cast<Index>(c)) =
          curve.columns[c].values[static_cast<std::size_t>(r)];
  }
  return table;
}

#ifdef ARETE_HAVE_VTK
std::optional<vtk::Polyline> polygon_to_draw(const CurveFile& curve) {
  // More control points would hide the curve.
  constexpr Index most_points = 200;
  const Index least = curve.closed ? 3 : 2;
  if (curve.control.rows() < least || curve.control.rows() > most_points) return std::nullopt;
  return vtk::Polyline{curve.control.view(), curve.closed};
}
#endif

}  // namespace

void check_curve_form(const std::string& output) {
  const std::string form = std::filesystem::path(output).extension().string();
  if (form != ".csv" && form != ".vtp" && form != ".png")
    throw Misuse(output + ": the format '" + form +
                 "' is not one of .csv, .vtp, .png; name the output so");
#ifndef ARETE_HAVE_VTK
  if (form != ".csv") throw Failure(output + ": this arete was built without VTK; write a .csv");
#endif
}

void write_curve(const CurveFile& curve, const std::filesystem::path& path) {
  const std::string form = path.extension().string();
  if (form == ".csv") {
    write_points(path, table_of(curve));
    return;
  }
#ifdef ARETE_HAVE_VTK
  const vtk::Polyline line{curve.points.view(), curve.closed, curve.tau};
  if (form == ".vtp")
    vtk::write_polyline(line, path);
  else
    vtk::plot_curve(line, polygon_to_draw(curve), {}, path);
#endif
}

}  // namespace arete::cli
