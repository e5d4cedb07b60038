// SPDX-License-Identifier: MIT
#include "run_program.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <fstream>
#include <iterator>

#include "support/temporary_folder.h"

namespace arete::test {
namespace {

std::string contents(const std::string& path) {
  std::ifstream stream(path);
  return {std::istreambuf_iterator<char>(stream), {}};
}

[[noreturn]] void become_arete(const Arguments& arguments, const std::string& out,
                               const std::string& err) {
  const auto redirect = [](const char* path, int flags, int target) {
    const int file = open(path, flags, 0600);
    if (file < 0 || dup2(file, target) < 0) _exit(126);
  };
  redirect("/dev/null", O_RDONLY, STDIN_FILENO);
  redirect(out.c_str(), O_WRONLY | O_CREAT | O_TRUNC, STDOUT_FILENO);
  redirect(err.c_str(), O_WRONLY | O_CREAT | O_TRUNC, STDERR_FILENO);
  unsetenv("DISPLAY");
  std::string program = program_path();
  std::vector<char*> argv{program.data()};
  for (const std::string& argument : arguments) argv.push_back(const_cast<char*>(argument.c_str()));
  argv.push_back(nullptr);
  execv(program.c_str(), argv.data());
  _exit(127);
}

}  // namespace

std::string program_path() { return ARETE_PROGRAM; }

Run run_arete(const Arguments& arguments, const std::function<void(int)>& while_running) {
  const TemporaryFolder folder;
  const std::string out = folder.file("out");
  const std::string err = folder.file("err");
  const pid_t child = fork();
  if (child == 0) become_arete(arguments, out, err);
  if (while_running) while_running(child);
  int status = 0;
  waitpid(child, &status, 0);
  const int code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  return {code, contents(out), contents(err)};
}

nlohmann::json run_json(const Arguments& arguments) {
  const Run run = run_arete(arguments);
  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_EQ(run.err, "");
  auto object = nlohmann::json::parse(run.out, nullptr, false);
  EXPECT_TRUE(object.is_object()) << run.out;
  return object;
}

}  // namespace arete::test
