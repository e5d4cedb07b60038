// SPDX-License-Identifier: MIT
#include "arete/gdal/remote.h"

#include <cpl_conv.h>
#include <gdal_priv.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cctype>
#include <string_view>

#include "arete/gdal/error.h"
#include "arete/gdal/raster.h"

namespace arete::gdal {
namespace {

std::atomic<bool> forbidden{false};

// Every file system of GDAL that asks a network; each also comes with `_streaming`.
constexpr std::array<std::string_view, 9> file_systems{"/vsicurl",  "/vsis3",   "/vsigs",
                                                       "/vsiaz",    "/vsiadls", "/vsioss",
                                                       "/vsiswift", "/vsihdfs", "/vsiwebhdfs"};
constexpr std::array<std::string_view, 14> services{
    "http://", "https://", "ftp://", "wms:",   "wmts:",     "wcs:",    "pg:",
    "mysql:",  "mssql:",   "eeda:",  "eedai:", "plmosaic:", "ogcapi:", "<gdal_wms"};

// Drivers that exist to ask a network or a server; a file can name them by its content.
constexpr std::array<const char*, 29> network_drivers{
    "WMS",  "WMTS",          "WCS",        "HTTP",      "PLMOSAIC",     "PLSCENES",
    "EEDA", "EEDAI",         "DAAS",       "OGCAPI",    "STACIT",       "STACTA",
    "NGW",  "PostGISRaster", "PostgreSQL", "MySQL",     "MSSQLSpatial", "Elasticsearch",
    "CSW",  "WFS",           "GMLAS",      "Carto",     "AmigoCloud",   "OAPIF",
    "ODBC", "PGeo",          "OCI",        "MongoDBv3", "HANA"};

}  // namespace

bool is_remote(const std::string& path) {
  std::string lower = path;
  std::transform(lower.begin(), lower.end(), lower.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  for (const std::string_view system : file_systems) {
    const auto at = lower.find(system);
    if (at == std::string::npos) continue;
    const char next = at + system.size() < lower.size() ? lower[at + system.size()] : '\0';
    if (next == '/' || next == '?' || next == '_') return true;
  }
  return std::any_of(services.begin(), services.end(), [&](std::string_view service) {
    return lower.rfind(service, 0) == 0 ||
           lower.find("/" + std::string(service)) != std::string::npos;
  });
}

void forbid_remote_access() {
  forbidden = true;
  // No file name is ever allowed to the file systems that are built on curl.
  CPLSetConfigOption("CPL_VSIL_CURL_ALLOWED_FILENAME", "/none");
  register_formats();
  GDALDriverManager* manager = GetGDALDriverManager();
  for (const char* name : network_drivers)
    if (GDALDriver* driver = manager->GetDriverByName(name)) {
      manager->DeregisterDriver(driver);
      GDALDestroyDriver(driver);
    }
}

void refuse_remote(const std::string& path) {
  if (forbidden && is_remote(path))
    throw RasterError(path +
                      " lies on a network, which is not asked unless --allow-remote is given; "
                      "download it, or give that option");
}

}  // namespace arete::gdal
