// SPDX-License-Identifier: MIT
#include "arete/gdal/point_layer.h"

#include <gdal_priv.h>
#include <ogrsf_frmts.h>

#include "arete/gdal/internal/dataset.h"
#include "arete/gdal/raster.h"
#include "arete/gdal/reference_system.h"
#include "arete/gdal/remote.h"

namespace arete::gdal {
namespace {

OGRLayer& choose_layer(GDALDataset& dataset, const std::string& path, const std::string& name) {
  std::string names;
  for (int i = 0; i < dataset.GetLayerCount(); ++i)
    names += (i == 0 ? "" : ", ") + std::string(dataset.GetLayer(i)->GetName());
  if (!name.empty()) {
    OGRLayer* layer = dataset.GetLayerByName(name.c_str());
    if (layer == nullptr)
      throw RasterError(path + " has no layer '" + name + "'; choose one of " + names);
    return *layer;
  }
  if (dataset.GetLayerCount() == 0) throw RasterError(path + " has no layer of points");
  if (dataset.GetLayerCount() > 1)
    throw RasterError(path + " has several layers; choose one of " + names);
  return *dataset.GetLayer(0);
}

class LayerReader {
 public:
  LayerReader(std::string where, OGRLayer& layer, const std::string& field)
      : where_(std::move(where)), layer_(layer) {
    if (field.empty()) return;
    field_ = layer.GetLayerDefn()->GetFieldIndex(field.c_str());
    if (field_ < 0) throw RasterError(where_ + " has no field '" + field + "'; see ogrinfo -so");
    const OGRFieldType type = layer.GetLayerDefn()->GetFieldDefn(field_)->GetType();
    if (type != OFTReal && type != OFTInteger && type != OFTInteger64)
      throw RasterError(where_ + ": the field '" + field + "' does not hold numbers");
  }

  PointLayer read() {
    layer_.ResetReading();
    while (const auto feature = OGRFeatureUniquePtr(layer_.GetNextFeature())) take(*feature);
    if (points_.x.empty())
      throw RasterError(where_ + " holds no points with a height; check it with ogrinfo");
    return std::move(points_);
  }

 private:
  void take(OGRFeature& feature) {
    const OGRGeometry* geometry = feature.GetGeometryRef();
    if (geometry == nullptr || geometry->IsEmpty()) return;
    if (field_ >= 0 && !feature.IsFieldSetAndNotNull(field_)) return;
    const std::string place = where_ + ", feature " + std::to_string(feature.GetFID());
    const double height = field_ >= 0 ? feature.GetFieldAsDouble(field_) : 0;
    const OGRwkbGeometryType type = wkbFlatten(geometry->getGeometryType());
    if (type == wkbPoint) {
      add(*geometry->toPoint(), height, place);
    } else if (type == wkbMultiPoint) {
      for (const OGRPoint* point : *geometry->toMultiPoint()) add(*point, height, place);
    } else {
      throw RasterError(place + " is a " + OGRGeometryTypeToName(type) +
                        "; give a layer of points (ogr2ogr can extract vertices)");
    }
  }

  void add(const OGRPoint& point, double height, const std::string& place) {
    if (point.IsEmpty()) return;
    if (field_ < 0 && point.Is3D() == FALSE)
      throw RasterError(place + " has no z; name the field that holds heights (--z-field)");
    points_.x.push_back(point.getX());
    points_.y.push_back(point.getY());
    points_.z.push_back(field_ < 0 ? point.getZ() : height);
  }

  std::string where_;
  OGRLayer& layer_;
  int field_ = -1;
  PointLayer points_;
};

}  // namespace

PointLayer read_points(const std::string& path, const std::string& layer,
                       const std::string& height_field) {
  refuse_remote(path);
  register_formats();
  const ErrorCollector errors;
  const Dataset dataset(GDALDataset::Open(path.c_str(), GDAL_OF_VECTOR | GDAL_OF_READONLY));
  if (!dataset) {
    VSIStatBufL status;
    if (VSIStatL(path.c_str(), &status) != 0)
      throw RasterError(path + " does not exist or cannot be read; check the path");
    throw RasterError(path +
                      " is neither a text file of points (.csv, .xyz, .txt, .dat, .tsv, .pts) nor "
                      "a vector layer that 'ogrinfo' opens");
  }
  OGRLayer& chosen = choose_layer(*dataset, path, layer);
  PointLayer points =
      LayerReader(path + ", layer " + chosen.GetName(), chosen, height_field).read();
  if (errors.failed()) throw RasterError(path + " cannot be read (GDAL: " + errors.message() + ")");
  points.crs = wkt_of(chosen.GetSpatialRef());
  return points;
}

}  // namespace arete::gdal
