// SPDX-License-Identifier: MIT
// File to file: `arete refine` beside GDAL's programs, each in a process of its own, in turn;
// prints a Markdown table of medians.
//
//     bench_files ARETE DEM.tif FOLDER
#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

namespace {

using Command = std::vector<std::string>;

struct Cost {
  double wall = 0, cpu = 0, peak = 0;  // seconds, seconds, MiB
};

Cost run(const Command& command) {
  std::vector<char*> arguments;
  for (const std::string& word : command) arguments.push_back(const_cast<char*>(word.c_str()));
  arguments.push_back(nullptr);
  const auto start = std::chrono::steady_clock::now();
  const pid_t child = fork();
  if (child == 0) {
    const int nowhere = open("/dev/null", O_WRONLY);
    dup2(nowhere, STDOUT_FILENO);
    execvp(arguments[0], arguments.data());
    _exit(127);
  }
  int status = 0;
  rusage usage{};
  wait4(child, &status, 0, &usage);
  const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - start;
  if (status != 0) {
    std::fprintf(stderr, "failed: %s ...\n", command[0].c_str());
    std::exit(1);
  }
  const auto seconds = [](const timeval& t) {
    return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
  };
  return {wall.count(), seconds(usage.ru_utime) + seconds(usage.ru_stime),
          static_cast<double>(usage.ru_maxrss) / 1024};
}

Cost median(std::vector<Cost> costs) {
  const auto middle = [&](double Cost::*what) {
    std::vector<double> values;
    for (const Cost& cost : costs) values.push_back(cost.*what);
    std::nth_element(values.begin(),
                     values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2), values.end());
    return values[values.size() / 2];
  };
  return {middle(&Cost::wall), middle(&Cost::cpu), middle(&Cost::peak)};
}

struct Line {
  const char* name;
  Command command;
  const char* goal;
};

// The first line is what the others are divided by.
void compare(const std::vector<Line>& lines) {
  constexpr int repetitions = 5;
  std::vector<std::vector<Cost>> costs(lines.size());
  for (int i = 0; i < repetitions; ++i)
    for (std::size_t k = 0; k < lines.size(); ++k) costs[k].push_back(run(lines[k].command));
  const Cost first = median(costs[0]);
  for (std::size_t k = 0; k < lines.size(); ++k) {
    const Cost cost = median(costs[k]);
    std::printf("| %s | %.2f | %.2f | %.0f | %.2f | %s |\n", lines[k].name, cost.wall, cost.cpu,
                cost.peak, cost.wall / first.wall, lines[k].goal);
    std::fflush(stdout);
  }
}

Command operator+(Command a, const Command& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 4) {
    std::fprintf(stderr, "usage: bench_files ARETE DEM.tif FOLDER\n");
    return 2;
  }
  const std::string arete = argv[1], dem = argv[2], folder = argv[3];
  const auto file = [&](const char* name) { return folder + "/" + name; };
  std::printf(
      "| command | wall s | CPU s | peak MiB | wall / arete's | goal |\n"
      "|---|---|---|---|---|---|\n");

  const Command refine{
      arete,      "refine", dem,       file("arete.tif"), "--scheme",   "b-spline:degree=3",
      "--levels", "4",      "--align", "cells",           "--overwrite"};
  compare({{"arete refine, tiled, uncompressed, 1 thread",
            refine + Command{"--threads", "1", "--creation-option", "COMPRESS=NONE"}, "-"},
           {"gdal_translate -r cubicspline, tiled, uncompressed",
            {"gdal_translate", "-q", "-ot", "Float32", "-outsize", "1600%", "1600%", "-r",
             "cubicspline", "-co", "TILED=YES", dem, file("translate.tif")},
            ">= 1.5, peak no lower"}});

  const Command deflate{"-co", "TILED=YES",   "-co", "COMPRESS=DEFLATE",
                        "-co", "PREDICTOR=3", "-co", "NUM_THREADS=2"};
  Command deflate_ours;
  for (const std::string& word : deflate)
    if (word != "-co") deflate_ours = deflate_ours + Command{"--creation-option", word};
  run(refine + deflate_ours);
  compare(
      {{"arete refine, DEFLATE, 2 threads", refine + Command{"--threads", "2"} + deflate_ours, "-"},
       {"gdalwarp -r cubic -multi, DEFLATE, 2 threads",
        Command{"gdalwarp", "-q", "-overwrite", "-ot", "Float32", "-ts", "5504", "6448", "-r",
                "cubic", "-multi", "-wo", "NUM_THREADS=2"} +
            deflate + Command{dem, file("warp.tif")},
        ">= 3"},
       {"gdal_translate, a copy of the finished raster, DEFLATE, 2 threads",
        Command{"gdal_translate", "-q"} + deflate + Command{file("arete.tif"), file("copy.tif")},
        ">= 0.77"}});
  return 0;
}
