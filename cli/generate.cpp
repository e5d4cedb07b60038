// SPDX-License-Identifier: MIT
// arete generate: the manual pages and the bash completion, for packagers. Not shown by --help.
#include <fstream>
#include <memory>

#include "cli/build_info.h"
#include "cli/error.h"
#include "cli/manual.h"
#include "cli/verb.h"

namespace arete::cli {
namespace {

void write(const std::string& path, const std::string& text) {
  std::ofstream stream(path);
  stream << text;
  stream.flush();
  if (!stream) throw Failure("cannot write " + path + "; check that its folder exists");
}

}  // namespace

void add_generate(CLI::App& program, Job& job) {
  CLI::App* verb =
      program.add_subcommand("generate", "Write the manual pages or the bash completion");
  verb->group("");
  auto what = std::make_shared<std::string>();
  auto folder = std::make_shared<std::string>();
  verb->add_option("WHAT", *what, "man or bash-completion")
      ->required()
      ->check(CLI::IsMember({"man", "bash-completion"}));
  verb->add_option("FOLDER", *folder, "An existing folder")->required();
  verb->callback([&program, &job, what, folder] {
    job = [&program, what, folder] {
      if (*what == "man")
        for (const ManualPage& page : manual_pages(program, version()))
          write(*folder + "/" + page.file, page.text);
      else
        write(*folder + "/arete", bash_completion(program));
    };
  });
}

}  // namespace arete::cli
