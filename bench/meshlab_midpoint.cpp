// SPDX-License-Identifier: MIT
// One level on a grid of quads in meshlabserver, opening and saving included: "Arete: Subdivide
// Terrain Grid" beside MeshLab's own "Subdivision Surfaces: Midpoint" on the same file.
//
//   bench_meshlab_midpoint [SIDE [RUNS]]     SIDE x SIDE vertices (1025), RUNS of each in turn (3)
//
// Fails if a result does not have the vertices it must have; prints Markdown.
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <iostream>
#include <sstream>
#include <string>
#include <thread>
#include <vector>

#include "support/temporary_folder.h"

namespace {

const std::string source = ARETE_SOURCE_DIR;
const std::string arete_name = "Arete: Subdivide Terrain Grid";

void write_quads(const std::string& path, int n) {
  std::ofstream ply(path, std::ios::binary);
  ply << "ply\nformat binary_little_endian 1.0\nelement vertex " << n * n
      << "\nproperty float x\nproperty float y\nproperty float z\nelement face "
      << (n - 1) * (n - 1) << "\nproperty list uchar int vertex_indices\nend_header\n";
  for (int r = 0; r < n; ++r)
    for (int c = 0; c < n; ++c) {
      const float p[] = {float(c), float(-r), float((r * 31 + c * 17) % 23)};
      ply.write(reinterpret_cast<const char*>(p), sizeof p);
    }
  for (int r = 0; r + 1 < n; ++r)
    for (int c = 0; c + 1 < n; ++c) {
      const int i = r * n + c;
      const int corners[] = {i, i + n, i + n + 1, i + 1};
      ply.put(4);
      ply.write(reinterpret_cast<const char*>(corners), sizeof corners);
    }
}

std::string text_of(const std::string& path) {
  std::ifstream stream(path, std::ios::binary);
  std::ostringstream text;
  text << stream.rdbuf();
  return text.str();
}

void set_value(std::string& filter, const std::string& name, const std::string& value) {
  const std::string before = "name=\"" + name + "\" value=\"";
  const auto begin = filter.find(before) + before.size();
  filter.replace(begin, filter.find('"', begin) - begin, value);
}

// The filter as the shipped script has it, with one level and without detail.
void write_scripts(const std::string& arete, const std::string& midpoint) {
  const std::string head = "<!DOCTYPE FilterScript>\n<FilterScript>\n";
  const std::string all = text_of(source + "/examples/terrain.mlx");
  const auto begin = all.find("<filter name=\"" + arete_name + "\">");
  std::string filter = all.substr(begin, all.find("</filter>", begin) + 9 - begin);
  set_value(filter, "Levels", "1");
  set_value(filter, "DetailAmount", "0");
  std::ofstream(arete) << head << filter << "\n</FilterScript>\n";
  std::ofstream(midpoint) << head
                          << "<filter name=\"Subdivision Surfaces: Midpoint\">\n"
                             "<Param type=\"RichInt\" name=\"Iterations\" value=\"1\"/>\n"
                             "<Param type=\"RichAbsPerc\" name=\"Threshold\" value=\"0\" min=\"0\" "
                             "max=\"1000\"/>\n"
                             "<Param type=\"RichBool\" name=\"Selected\" value=\"false\"/>\n"
                             "</filter>\n</FilterScript>\n";
}

long vertices_in(const std::string& path) {
  std::ifstream stream(path, std::ios::binary);
  std::string line;
  long count = 0;
  while (std::getline(stream, line) && line != "end_header")
    std::sscanf(line.c_str(), "element vertex %ld", &count);
  return count;
}

double seconds(const arete::test::TemporaryFolder& folder, const std::string& script,
               long vertices) {
  const std::string out = folder.file("out.ply");
  std::remove(out.c_str());
  const std::string command =
      "HOME=" + folder.path().string() + " XDG_RUNTIME_DIR=" + folder.path().string() + " " +
      source + "/tests/support/with_display " + source +
      "/scripts/try-meshlab --build " ARETE_BUILD_DIR " --server -i " + folder.file("in.ply") +
      " -o " + out + " -s " + script + " > " + folder.file("log") + " 2>&1";
  const auto start = std::chrono::steady_clock::now();
  const int code = std::system(command.c_str());
  const std::chrono::duration<double> duration = std::chrono::steady_clock::now() - start;
  if (code != 0 || vertices_in(out) != vertices) {
    std::cerr << text_of(folder.file("log")) << "expected " << vertices << " vertices, found "
              << vertices_in(out) << '\n';
    std::exit(1);
  }
  return duration.count();
}

std::string processor() {
  std::ifstream info("/proc/cpuinfo");
  std::string line;
  while (std::getline(info, line))
    if (line.rfind("model name", 0) == 0) return line.substr(line.find(':') + 2);
  return "unknown processor";
}

}  // namespace

int main(int argc, char** argv) {
  const int n = argc > 1 ? std::atoi(argv[1]) : 1025;
  const int runs = argc > 2 ? std::atoi(argv[2]) : 3;
  const arete::test::TemporaryFolder folder;
  write_quads(folder.file("in.ply"), n);
  write_scripts(folder.file("arete.mlx"), folder.file("midpoint.mlx"));
  // Midpoint adds a vertex on each side and each diagonal.
  const long side = n;
  const long expected = (2 * side - 1) * (2 * side - 1);
  const std::time_t now = std::time(nullptr);
  char date[16];
  std::strftime(date, sizeof date, "%Y-%m-%d", std::localtime(&now));
  std::cout << "`bench_meshlab_midpoint " << n << ' ' << runs << "`, " << date << ", "
            << processor() << ", " << std::thread::hardware_concurrency()
            << " threads; seconds of meshlabserver, opening and saving included\n\n"
            << "| run | arete | Midpoint | ratio |\n|---|---|---|---|\n";
  std::vector<double> ratios;
  for (int run = 0; run < runs; ++run) {
    const double arete = seconds(folder, folder.file("arete.mlx"), expected);
    const double midpoint = seconds(folder, folder.file("midpoint.mlx"), expected);
    ratios.push_back(midpoint / arete);
    std::printf("| %d | %.2f | %.2f | %.2f |\n", run + 1, arete, midpoint, ratios.back());
    std::fflush(stdout);
  }
  std::sort(ratios.begin(), ratios.end());
  if (!ratios.empty()) std::printf("\nMedian ratio: %.2f\n", ratios[ratios.size() / 2]);
}
