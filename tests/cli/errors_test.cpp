// SPDX-License-Identifier: MIT
// Bad input: one line on stderr that names what, where and the remedy; the right exit code; nothing
// written.
#include <gtest/gtest.h>

#include <fstream>

#include "expect_error.h"
#include "run_program.h"
#include "support/source_dir.h"
#include "support/temporary_folder.h"

namespace arete {
namespace {

using test::Arguments;
using test::dem;
using test::expect_error;
using test::run_arete;

TEST(cli_errors, misuse_of_refine_exits_with_2_and_writes_nothing) {
  const test::TemporaryFolder folder;
  const std::string out = folder.file("out.tif");
  const auto refine = [&](Arguments more) {
    Arguments all{"refine", dem, out};
    all.insert(all.end(), more.begin(), more.end());
    return all;
  };
  expect_error(refine({}), 2, "--scheme is required");
  expect_error(refine({"--scheme", "gentel"}), 2, "did you mean 'gentle'");
  expect_error(refine({"--scheme", "four-point:w=1"}), 2, "no parameter 'w'");
  expect_error(refine({"--scheme", "four-point:omega=9"}), 2, "out of range");
  expect_error(refine({"--scheme", "mask:arity=2,first=0,coefficients=1;1;1"}), 2,
               "the phases of the mask sum to 2, 1");
  expect_error(refine({"--scheme", "gentle", "--levels", "-1"}), 2, "negative");
  expect_error(refine({"--scheme", "gentle", "--levels", "99"}), 2, "use fewer levels");
  expect_error(refine({"--scheme", "gentle", "--levels", "x"}), 2, "--levels");
  expect_error(refine({"--scheme", "gentle", "--boundary", "mirror"}), 2, "no boundary 'mirror'");
  expect_error(refine({"--scheme", "gentle", "--align", "left"}), 2, "--align");
  expect_error(refine({"--scheme", "gentle", "--type", "int16"}), 2, "--type");
  expect_error(refine({"--scheme", "gentle", "--max-memory", "lots"}), 2, "write e.g. 800M");
  expect_error(refine({"--scheme", "gentle", "--frobnicate"}), 2, "--frobnicate");
  expect_error(refine({"--scheme", "four-parameter:lambda=1,mu=0,omega=0", "--limit"}), 2,
               "no certified limit");
  expect_error({"refine", dem, folder.file("out.xyz"), "--scheme", "gentle"}, 2, ".xyz");
  expect_error({"frobnicate"}, 2, "no verb 'frobnicate'");
  expect_error({}, 2, "arete --help");
  EXPECT_EQ(folder.entries(), 0);
}

TEST(cli_errors, work_that_cannot_be_done_exits_with_1_and_writes_nothing) {
  const test::TemporaryFolder folder;
  const std::string out = folder.file("out.tif");
  const auto refine = [&](const std::string& in, const std::string& to, Arguments more = {}) {
    Arguments all{"refine", in, to, "--scheme", "gentle"};
    all.insert(all.end(), more.begin(), more.end());
    return all;
  };
  expect_error(refine(folder.file("absent.tif"), out), 1, "does not exist");
  expect_error(refine(arete::test::source_dir() + "/LICENSE", out), 1, "not a raster");
  expect_error(refine(dem, folder.file("no/folder/out.tif")), 1, "cannot be written");
  expect_error(refine(dem, out, {"--levels", "7", "--max-memory", "50M"}), 1, "raise --max-memory");
  expect_error(refine(dem, folder.file("out.vti"), {"--max-memory", "1500"}), 1, "1 kB allowed");
  expect_error(refine(dem, folder.file("out.vti"), {"--levels", "8", "--max-memory", "1G"}), 1,
               "write a GeoTIFF");
  expect_error(refine(dem, out, {"--levels", "12", "--creation-option", "COMPRESS=NONE"}), 1,
               "are free");
  expect_error(refine(dem, out, {"--creation-option", "COMPRES=NONE"}), 1, "creation option");
  expect_error(refine(dem, folder.path().string()), 2, "the format ''");
  EXPECT_EQ(folder.entries(), 0);
}

TEST(cli_errors, nothing_is_read_from_a_network_unasked_not_even_through_a_local_file) {
  const test::TemporaryFolder folder;
  const std::string out = folder.file("out.tif");
  for (const char* remote :
       {"/vsicurl/http://127.0.0.1:9/a.tif", "http://127.0.0.1:9/a.tif",
        "/vsizip//vsicurl/http://127.0.0.1:9/a.zip/a.tif", "/vsis3/bucket/a.tif"})
    expect_error({"refine", remote, out, "--scheme", "gentle"}, 1, "--allow-remote");
  const std::string vrt = folder.file("remote.vrt");
  std::ofstream(vrt) << "<VRTDataset rasterXSize=\"9\" rasterYSize=\"9\"><VRTRasterBand "
                        "dataType=\"Float32\" band=\"1\"><SimpleSource><SourceFilename>/vsicurl/"
                        "http://127.0.0.1:9/a.tif</SourceFilename><SourceBand>1</SourceBand>"
                        "</SimpleSource></VRTRasterBand></VRTDataset>";
  const test::Run run = test::run_arete({"refine", vrt, out, "--scheme", "gentle"});
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_EQ(run.err.find("onnect"), std::string::npos) << run.err;
  EXPECT_EQ(folder.entries(), 1);
}

TEST(cli_errors, a_symbolic_link_at_the_output_is_replaced_and_what_it_points_to_is_kept) {
  const test::TemporaryFolder folder;
  const std::string precious = folder.file("precious.txt");
  std::ofstream(precious) << "precious";
  const std::string out = folder.file("out.tif");
  std::filesystem::create_symlink(precious, out);
  expect_error({"refine", dem, out, "--scheme", "gentle"}, 1, "give --overwrite");
  EXPECT_EQ(test::run_arete({"refine", dem, out, "--scheme", "gentle", "--overwrite"}).exit_code,
            0);
  EXPECT_FALSE(std::filesystem::is_symlink(out));
  std::string text;
  std::ifstream(precious) >> text;
  EXPECT_EQ(text, "precious");
}

TEST(cli_errors, input_and_existing_outputs_are_never_damaged) {
  const test::TemporaryFolder folder;
  const std::string in = folder.file("in.tif");
  std::filesystem::copy(dem, in);
  std::filesystem::create_symlink(in, folder.file("link.tif"));
  const auto size = std::filesystem::file_size(in);
  expect_error({"refine", in, in, "--scheme", "gentle", "--overwrite"}, 1, "is the input itself");
  expect_error({"refine", in, folder.file("link.tif"), "--scheme", "gentle", "--overwrite"}, 1,
               "is the input itself");
  const std::string kept = folder.file("kept.tif");
  std::ofstream(kept) << "precious";
  expect_error({"refine", in, kept, "--scheme", "gentle"}, 1, "give --overwrite");
  // A failure while replacing leaves the old file.
  expect_error({"refine", in, kept, "--scheme", "gentle", "--levels", "7", "--max-memory", "50M",
                "--overwrite"},
               1, "--max-memory");
  std::string text;
  std::ifstream(kept) >> text;
  EXPECT_EQ(text, "precious");
  EXPECT_EQ(std::filesystem::file_size(in), size);
  EXPECT_EQ(folder.entries(), 3);
}

TEST(cli_errors, bad_points_name_line_and_column) {
  const test::TemporaryFolder folder;
  const std::string in = folder.file("points.csv");
  const auto with = [&](const char* text) {
    std::ofstream(in) << text;
    return Arguments{"curve", in, folder.file("out.csv"), "--scheme", "chaikin"};
  };
  expect_error(with(""), 1, "holds no points");
  expect_error(with("x,y\n"), 1, "holds no points");
  expect_error(with("x,y\n1,2\n3,abc\n"), 1, "line 3, column 2: 'abc'");
  expect_error(with("1,2\n3\n"), 1, "line 2 has 1 columns");
  expect_error(with("1,2\nnan,3\n"), 1, "line 2, column 1");
  expect_error({"curve", folder.file("absent.csv"), folder.file("o.csv"), "--scheme", "chaikin"}, 1,
               "cannot be read");
  EXPECT_EQ(folder.entries(), 1);
}

TEST(cli_errors, bad_pictures_are_refused) {
  const test::TemporaryFolder folder;
  const std::string out = folder.file("out.png");
  expect_error({"render", dem, out, "--size", "big"}, 2, "1600x1000");
  expect_error({"render", dem, out, "--light", "1"}, 2, "azimuth");
  expect_error({"render", dem, out, "--colormap", "none"}, 1, "choose one of");
  expect_error({"render", dem, folder.file("out.bmp")}, 2, ".png");
  expect_error({"render", dem, out, "--band", "2"}, 2, "no data band 2");
  EXPECT_EQ(folder.entries(), 0);
}

}  // namespace
}  // namespace arete
