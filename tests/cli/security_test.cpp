// SPDX-License-Identifier: MIT
// The threats that SECURITY.md names, tried on the program: networks, foreign programs, sizes that
// headers claim.
#include <arpa/inet.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <unistd.h>

#include <atomic>
#include <fstream>
#include <iterator>
#include <thread>

#include "expect_error.h"
#include "run_program.h"
#include "support/temporary_folder.h"

namespace arete {
namespace {

using test::expect_error;
using test::run_arete;

/// Counts who calls on a port of this machine.
class Listener {
 public:
  Listener() : socket_(socket(AF_INET, SOCK_STREAM, 0)) {
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    socklen_t size = sizeof address;
    EXPECT_EQ(bind(socket_, reinterpret_cast<sockaddr*>(&address), size), 0);
    EXPECT_EQ(listen(socket_, 64), 0);
    getsockname(socket_, reinterpret_cast<sockaddr*>(&address), &size);
    host_ = "127.0.0.1:" + std::to_string(ntohs(address.sin_port));
    thread_ = std::thread([this] {
      for (int caller = accept(socket_, nullptr, nullptr); caller >= 0;
           caller = accept(socket_, nullptr, nullptr)) {
        ++calls_;
        close(caller);
      }
    });
  }
  ~Listener() {
    shutdown(socket_, SHUT_RDWR);
    thread_.join();
    close(socket_);
  }
  Listener(const Listener&) = delete;
  Listener& operator=(const Listener&) = delete;

  [[nodiscard]] const std::string& host() const { return host_; }
  [[nodiscard]] int calls() const { return calls_; }

 private:
  int socket_;
  std::string host_;
  std::atomic<int> calls_{0};
  std::thread thread_;
};

std::string escaped(const std::string& text) {
  std::string result;
  for (const char c : text)
    result += c == '"' ? "&quot;" : c == '<' ? "&lt;" : c == '&' ? "&amp;" : std::string(1, c);
  return result;
}

std::string vrt_of(const std::string& source) {
  return "<VRTDataset rasterXSize=\"9\" rasterYSize=\"9\"><VRTRasterBand dataType=\"Float32\" "
         "band=\"1\"><SimpleSource><SourceFilename>" +
         escaped(source) +
         "</SourceFilename><SourceBand>1</SourceBand></SimpleSource></VRTRasterBand></VRTDataset>";
}

std::string claim(long columns, long rows) {
  return "<VRTDataset rasterXSize=\"" + std::to_string(columns) + "\" rasterYSize=\"" +
         std::to_string(rows) + "\"><VRTRasterBand dataType=\"Float32\" band=\"1\"/></VRTDataset>";
}

/// Sets a variable of the environment for a while.
class Variable {
 public:
  Variable(const char* name, const std::string& value) : name_(name) {
    if (const char* old = getenv(name)) old_ = old;
    setenv(name, value.c_str(), 1);
  }
  ~Variable() {
    if (old_.empty())
      unsetenv(name_);
    else
      setenv(name_, old_.c_str(), 1);
  }
  Variable(const Variable&) = delete;
  Variable& operator=(const Variable&) = delete;

 private:
  const char* name_;
  std::string old_;
};

TEST(cli_security, no_name_however_nested_reaches_a_network_unasked) {
  const test::TemporaryFolder folder;
  const Listener listener;
  const std::string host = listener.host();
  const Variable swift("SWIFT_STORAGE_URL", "http://" + host);
  const Variable token("SWIFT_AUTH_TOKEN", "x");
  const Variable s3("AWS_S3_ENDPOINT", host);
  const Variable https("AWS_HTTPS", "NO");
  const Variable unsigned_requests("AWS_NO_SIGN_REQUEST", "YES");
  const std::string out = folder.file("out.tif");
  const std::string vrt = folder.file("in.vrt");
  for (const std::string& name :
       {"/vsicurl/http://" + host + "/a.tif", "/vsicurl?url=http://" + host + "/a.tif",
        "/vsicurl_streaming/http://" + host + "/a.tif",
        "/vsizip//vsicurl/http://" + host + "/a.zip/a.tif",
        "/vsigzip//vsicurl_streaming/http://" + host + "/a.gz",
        "/vsitar//vsigzip//vsicurl/http://" + host + "/a.tar.gz/a.tif",
        "/vsisubfile/0_10,/vsicurl/http://" + host + "/a.tif",
        "vrt:///vsicurl/http://" + host + "/a.tif", "NETCDF:\"http://" + host + "/a.nc\":v",
        "vrt://NETCDF:\"http://" + host + "/a.nc\":v", std::string("/vsis3/bucket/a.tif"),
        std::string("/vsis3_streaming/bucket/a.tif"), std::string("/vsiswift/bucket/a.tif"),
        "http://" + host + "/a.tif", "WMS:http://" + host + "/?",
        "<GDAL_WMS><Service name=\"TMS\"><ServerUrl>http://" + host +
            "/${z}</ServerUrl></Service></GDAL_WMS>"}) {
    expect_error({"refine", name, out, "--scheme", "gentle"}, 1, "--allow-remote");
    std::ofstream(vrt) << vrt_of(name);
    EXPECT_EQ(run_arete({"refine", vrt, out, "--scheme", "gentle"}).exit_code, 1) << name;
    EXPECT_EQ(listener.calls(), 0) << name;
  }
  EXPECT_EQ(folder.entries(), 1);
}

TEST(cli_security, a_network_is_asked_when_it_is_allowed) {
  const test::TemporaryFolder folder;
  const Listener listener;
  const std::string name = "/vsicurl/http://" + listener.host() + "/a.tif";
  (void)run_arete({"refine", name, folder.file("out.tif"), "--scheme", "gentle", "--allow-remote"});
  EXPECT_GT(listener.calls(), 0);
}

TEST(cli_security, points_and_textures_reach_no_network_either) {
  const test::TemporaryFolder folder;
  const Listener listener;
  const std::string remote = "http://" + listener.host() + "/a.json";
  expect_error({"grid", remote, folder.file("out.tif"), "--spacing", "1", "--layer", "a"}, 1, "");
  const std::string vrt = folder.file("in.vrt");
  std::ofstream(vrt) << "<OGRVRTDataSource><OGRVRTLayer name=\"a\"><SrcDataSource>" << remote
                     << "</SrcDataSource></OGRVRTLayer></OGRVRTDataSource>";
  expect_error({"grid", vrt, folder.file("out.tif"), "--spacing", "1"}, 1, "");
  expect_error({"render", test::dem, folder.file("out.png"), "--texture", remote}, 1,
               "--allow-remote");
  EXPECT_EQ(listener.calls(), 0);
  EXPECT_EQ(folder.entries(), 1);
}

TEST(cli_security, no_name_and_no_file_opens_the_memory_of_the_process) {
  const test::TemporaryFolder folder;
  const std::string out = folder.file("out.tif");
  const std::string vrt = folder.file("in.vrt");
  const std::string memory = "MEM:::DATAPOINTER=4096,PIXELS=9,LINES=9,DATATYPE=Float32";
  std::ofstream(vrt) << vrt_of(memory);
  for (const std::string& name : {memory, "mem:::" + memory.substr(6), vrt, "vrt://" + memory})
    for (const char* networks : {"--levels=1", "--allow-remote"})
      EXPECT_EQ(run_arete({"refine", name, out, "--scheme", "gentle", networks}).exit_code, 1)
          << name;
  EXPECT_EQ(folder.entries(), 1);
}

TEST(cli_security, no_program_and_no_code_of_a_file_is_run) {
  const test::TemporaryFolder folder;
  const std::string trace = folder.file("trace");
  const std::string program = folder.file("gpsbabel");
  std::ofstream(program) << "#!/bin/sh\ntouch " << trace << "\n";
  std::filesystem::permissions(program, std::filesystem::perms::owner_all);
  const Variable path("PATH", folder.path().string() + ":" + getenv("PATH"));
  const Variable python("GDAL_VRT_ENABLE_PYTHON", "YES");
  const std::string out = folder.file("out.tif");
  (void)run_arete({"grid", "GPSBABEL:gpx:" + program, out, "--spacing", "1", "--allow-remote"});
  const std::string vrt = folder.file("code.vrt");
  std::ofstream(vrt)
      << "<VRTDataset rasterXSize=\"9\" rasterYSize=\"9\"><VRTRasterBand dataType=\"Float32\" "
         "band=\"1\" subClass=\"VRTDerivedRasterBand\"><PixelFunctionLanguage>Python"
         "</PixelFunctionLanguage><PixelFunctionType>f</PixelFunctionType><PixelFunctionCode>"
         "<![CDATA[\ndef f(*a, **k):\n  open('"
      << trace << "', 'w')\n]]></PixelFunctionCode></VRTRasterBand></VRTDataset>";
  EXPECT_EQ(run_arete({"refine", vrt, out, "--scheme", "gentle"}).exit_code, 1);
  EXPECT_FALSE(std::filesystem::exists(trace));
  EXPECT_FALSE(std::filesystem::exists(out));
}

#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
/// A limit on the address space of the programs that are started while it lives.
class MemoryLimit {
 public:
  explicit MemoryLimit(rlim_t bytes) {
    getrlimit(RLIMIT_AS, &old_);
    const rlimit limit{bytes, old_.rlim_max};
    setrlimit(RLIMIT_AS, &limit);
  }
  ~MemoryLimit() { setrlimit(RLIMIT_AS, &old_); }
  MemoryLimit(const MemoryLimit&) = delete;
  MemoryLimit& operator=(const MemoryLimit&) = delete;

 private:
  rlimit old_{};
};

// A sanitizer's shadow memory alone is beyond any such limit.
TEST(cli_security, a_header_that_claims_a_huge_size_is_refused_in_little_memory) {
  const test::TemporaryFolder folder;
  const MemoryLimit limit(rlim_t{4} << 30);
  const std::string in = folder.file("in.vrt");
  const std::string table = folder.file("in.asc");
  std::ofstream(table) << "ncols 2147483647\nnrows 2147483647\nxllcorner 0\nyllcorner "
                          "0\ncellsize 1\n1 2 3\n";
  const auto refuses = [&](const test::Arguments& arguments) {
    const test::Run run = run_arete(arguments);
    EXPECT_EQ(run.exit_code, 1) << arguments[0];
    EXPECT_EQ(run.err.rfind("arete: ", 0), 0u) << run.err;
    EXPECT_EQ(run.err.find("out of memory"), std::string::npos) << arguments[0] << ": " << run.err;
  };
  for (const auto& [columns, rows] : {std::pair{2147483647L, 2147483647L}, {2147483647L, 1L}}) {
    std::ofstream(in) << claim(columns, rows);
    for (const std::string& file : {in, table}) {
      refuses({"refine", file, folder.file("o.tif"), "--scheme", "gentle"});
      refuses({"refine", file, folder.file("o.vti"), "--scheme", "gentle"});
      refuses({"refine", file, folder.file("o.obj"), "--scheme", "gentle"});
      refuses({"coarsen", file, folder.file("o.tif"), "--scheme", "gentle", "--levels", "1"});
      refuses({"compare", file, file});
      refuses({"fit", file, "--scheme", "four-point"});
      refuses({"render", file, folder.file("o.png")});
    }
  }
  std::ofstream(in) << claim(100000, 100000);
  refuses({"refine", in, folder.file("o.tif"), "--scheme", "gentle", "--max-memory", "500M"});
  refuses({"refine", in, folder.file("o.vti"), "--scheme", "gentle", "--max-memory", "500M"});
  EXPECT_EQ(folder.entries(), 2);
}
#endif

}  // namespace
}  // namespace arete
