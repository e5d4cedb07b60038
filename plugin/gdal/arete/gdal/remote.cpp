// SPDX-License-Identifier: MIT
#include "arete/gdal/remote.h"

#include <cpl_conv.h>
#include <cpl_http.h>
#include <cpl_string.h>
#include <cpl_vsi.h>
#include <gdal_priv.h>
#include <ogr_srs_api.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cctype>
#include <cerrno>
#include <string>
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
// What every other file system is built on, or is a file of this machine. One that is not listed
// here, of a newer GDAL, counts as remote.
constexpr std::array<std::string_view, 13> local_systems{
    "/vsimem",   "/vsizip",     "/vsigzip",           "/vsitar",   "/vsi7z",
    "/vsirar",   "/vsisubfile", "/vsisparse",         "/vsicrypt", "/vsicached",
    "/vsistdin", "/vsistdout",  "/vsistdout_redirect"};
// Protocols, anywhere in a name: `NETCDF:"http://..."`.
constexpr std::array<std::string_view, 11> protocols{"http://",  "https://", "ftp://", "ftps://",
                                                     "s3://",    "gs://",    "gs3://", "dods://",
                                                     "dodss://", "dap4://",  "gltp://"};
// Services, at the beginning of a name or of what a file system is asked for.
constexpr std::array<std::string_view, 11> services{
    "wms:",  "wmts:",  "wcs:",      "pg:",     "mysql:",   "mssql:",
    "eeda:", "eedai:", "plmosaic:", "ogcapi:", "<gdal_wms"};

// Drivers that exist to ask a network or a server; a file can name them by its content.
constexpr std::array<const char*, 30> network_drivers{
    "WMS",  "WMTS",          "WCS",        "HTTP",      "PLMOSAIC",     "PLSCENES",
    "EEDA", "EEDAI",         "DAAS",       "OGCAPI",    "STACIT",       "STACTA",
    "NGW",  "PostGISRaster", "PostgreSQL", "MySQL",     "MSSQLSpatial", "Elasticsearch",
    "CSW",  "WFS",           "GMLAS",      "Carto",     "AmigoCloud",   "OAPIF",
    "ODBC", "PGeo",          "OCI",        "MongoDBv3", "HANA",         "OGR_OGDI"};

void remove_driver(const char* name) {
  GDALDriverManager* manager = GetGDALDriverManager();
  GDALDriver* driver = manager->GetDriverByName(name);
  if (driver == nullptr) return;
  manager->DeregisterDriver(driver);
  GDALDestroyDriver(driver);
}

bool is_local_system(std::string_view prefix) {
  const std::string_view name = prefix.substr(0, prefix.find_first_of("/?", 1));
  return std::find(local_systems.begin(), local_systems.end(), name) != local_systems.end();
}

void* open_nothing(void*, const char*, const char*) {
  errno = EACCES;
  return nullptr;
}

// Puts a file system without files in the place of each that is not known to be local.
void close_file_systems() {
  VSIFilesystemPluginCallbacksStruct* nothing = VSIAllocFilesystemPluginCallbacksStruct();
  nothing->open = open_nothing;
  // Never freed: GDAL keeps the pointers that it is given here.
  static char** const prefixes = VSIGetFileSystemsPrefixes();
  for (char** prefix = prefixes; prefix != nullptr && *prefix != nullptr; ++prefix)
    if (!is_local_system(*prefix)) VSIInstallPluginHandler(*prefix, nothing);
  // Not among the prefixes that GDAL lists.
  VSIInstallPluginHandler("/vsicurl?", nothing);
  VSIFreeFilesystemPluginCallbacksStruct(nothing);
}

// What any driver that asks for a URL by GDAL's own means gets.
CPLHTTPResult* fetch_nothing(const char* url, CSLConstList, GDALProgressFunc, void*,
                             CPLHTTPFetchWriteFunc, void*, void*) {
  auto* result = static_cast<CPLHTTPResult*>(CPLCalloc(1, sizeof(CPLHTTPResult)));
  result->nStatus = 1;
  result->pszErrBuf = CPLStrdup("networks are not asked");
  CPLError(CE_Failure, CPLE_HttpResponse, "%s: networks are not asked", url);
  return result;
}

// The NetCDF library asks networks by its own means.
GDALDataset* (*open_netcdf)(GDALOpenInfo*) = nullptr;

GDALDataset* open_local_netcdf(GDALOpenInfo* info) {
  if (!is_remote(info->pszFilename)) return open_netcdf(info);
  CPLError(CE_Failure, CPLE_OpenFailed, "%s: networks are not asked", info->pszFilename);
  return nullptr;
}

void keep_netcdf_local() {
  GDALDriver* driver = GetGDALDriverManager()->GetDriverByName("netCDF");
  if (driver == nullptr || driver->pfnOpen == open_local_netcdf) return;
  open_netcdf = driver->pfnOpen;
  driver->pfnOpen = open_local_netcdf;
}

// `MEM:::DATAPOINTER=...` opens any address of this process as a raster.
GDALDataset* open_no_memory(GDALOpenInfo* info) {
  if (STARTS_WITH_CI(info->pszFilename, "MEM:::"))
    CPLError(CE_Failure, CPLE_OpenFailed, "%s: memory is not opened by its address",
             info->pszFilename);
  return nullptr;
}

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
  const auto has = [&](std::string_view part) { return lower.find(part) != std::string::npos; };
  return std::any_of(protocols.begin(), protocols.end(), has) ||
         std::any_of(services.begin(), services.end(), [&](std::string_view service) {
           return lower.rfind(service, 0) == 0 || has("/" + std::string(service));
         });
}

void forbid_remote_access() {
  forbidden = true;
  register_formats();
  close_file_systems();
  CPLHTTPSetFetchCallback(fetch_nothing, nullptr);
  OSRSetPROJEnableNetwork(0);
  for (const char* name : network_drivers) remove_driver(name);
  keep_netcdf_local();
}

void forbid_programs() {
  register_formats();
  remove_driver("GPSBabel");
  CPLSetConfigOption("GDAL_VRT_ENABLE_PYTHON", "NO");
  if (GDALDriver* memory = GetGDALDriverManager()->GetDriverByName("MEM"))
    memory->pfnOpen = open_no_memory;
}

void refuse_remote(const std::string& path) {
  if (forbidden && is_remote(path))
    throw RasterError(path +
                      " lies on a network, which is not asked unless --allow-remote is given; "
                      "download it, or give that option");
}

}  // namespace arete::gdal
